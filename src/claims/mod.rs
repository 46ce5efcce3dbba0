//! The ledger: one function per claim, every verdict computed.
