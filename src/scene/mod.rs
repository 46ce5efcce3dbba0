//! Scenes: what a user asks for, validated and exact.
