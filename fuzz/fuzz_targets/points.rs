//! CSV files of points.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| slipmode_fuzz::csv_promises::points(bytes));
