//! Tables and charts that were measured apart.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| slipmode_fuzz::promises::measured(bytes));
