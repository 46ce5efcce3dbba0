//! The three roots of a real cubic: 64-bit, double-double and certified, with a ladder that reports its rung.
