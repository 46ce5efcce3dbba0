//! Markdown with formulas.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| slipmode_fuzz::promises::prose(bytes));
