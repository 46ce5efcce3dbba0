//! What every reader promises of any bytes: it ends, without a panic, and what it accepts is the same when it is printed and read again.
//!
//! Nothing here knows where the bytes come from, so that any source of them can be held against the promises.

use rug::ops::Pow;
use slipmode::archive::{Caps, pack, unpack};
use slipmode::number::{MAX_EXPONENT, Rational, parse_decimal};
use slipmode::polynomial::Expression;
use slipmode::scene::{Limits, Scene, check_name};

/// A number that is accepted is the same when it is printed in full and read again.
pub fn number(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Ok(value) = parse_decimal(text) {
        assert_eq!(parse_decimal(&in_full(&value)), Ok(value), "{text:?}");
    }
}

/// Every digit of a decimal, within the grammar's limits on digits and exponent.
fn in_full(value: &Rational) -> String {
    // Denominators divide a power of ten; most divide a small one.
    let scaled = |places: u32| value.clone() * Rational::from(10).pow(places);
    let places = [0, 400, 20_000].into_iter().find(|places| scaled(*places).is_integer()).expect("a decimal");
    let scaled = scaled(places);
    let sign = if *value < 0 { "-" } else { "" };
    let mut digits = scaled.numer().clone().abs().to_string();
    let mut exponent = -i64::from(places);
    while digits.len() > 1 && digits.ends_with('0') && exponent < MAX_EXPONENT {
        digits.pop();
        exponent += 1;
    }
    // What the exponent cannot say goes behind the point.
    let behind = usize::try_from((-MAX_EXPONENT - exponent).max(0)).unwrap();
    let digits = format!("{digits:0>width$}", width = behind + 1);
    let (whole, fraction) = digits.split_at(digits.len() - behind);
    format!("{sign}{whole}.{fraction}e{}", exponent.max(-MAX_EXPONENT))
}

/// A scene that is accepted is the same with another system's line ends, and its name is one that can be written.
pub fn scene(bytes: &[u8]) {
    match Scene::parse("s.toml", bytes, &Limits::default()) {
        Ok(scene) => {
            assert_eq!(check_name(&scene.name), Ok(()));
            let text = std::str::from_utf8(bytes).expect("an accepted scene is text");
            let other = text.replace("\r\n", "\n").replace('\n', "\r\n");
            // A text over several lines may hold line ends of its own.
            if !text.contains("\"\"\"") && !text.contains("'''") {
                assert_eq!(Scene::parse("s.toml", other.as_bytes(), &Limits::default()), Ok(scene));
            }
        }
        Err(faults) => {
            assert!(!faults.is_empty());
            assert!(faults.iter().all(|fault| fault.to_string().starts_with("s.toml")), "{faults:?}");
        }
    }
}

/// An expression that is accepted is the same when it is printed and read again.
pub fn expression(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Ok(read) = text.parse::<Expression>() {
        let printed = read.to_string();
        assert_eq!(printed.parse::<Expression>().map(|again| again.to_string()), Ok(printed), "{text:?}");
    }
}

/// An archive that is accepted holds the same files when they are packed and unpacked again.
pub fn archive(bytes: &[u8]) {
    let caps = Caps { file_bytes: 1 << 20, total_bytes: 1 << 22, ..Caps::default() };
    match unpack(bytes, &caps) {
        Ok((files, time)) => {
            let again = pack(&files, time).expect("what was unpacked can be packed");
            assert_eq!(unpack(&again, &caps), Ok((files, time)));
        }
        Err(faults) => assert!(!faults.is_empty()),
    }
}
