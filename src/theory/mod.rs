//! The paper's linear theory, derived from eqs 1-4 and proved as identities over the rationals.
