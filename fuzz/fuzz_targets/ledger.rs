//! `claims.toml` and `report.toml`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| slipmode_fuzz::promises::ledger(bytes));
