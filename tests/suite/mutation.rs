//! Valid bytes with a few changes, the same ones every time.

use std::time::{Duration, Instant};

use crate::random::Random;

/// The longest that one reader may spend on one input.
const PATIENCE: Duration = Duration::from_secs(2);

/// Pieces that readers are known to stumble over.
const PIECES: [&[u8]; 16] = [
    b"-",
    b"e",
    b".",
    b"0",
    b"99999999999",
    b"e-9999",
    b"nan",
    b"\"",
    b"[",
    b"]",
    b"{ }",
    b"\r\n",
    b"\xff",
    b"\0",
    b"\xe2\x80\xae",
    b"= 0\n",
];

/// One to four changes: a byte flipped, a piece put in, a part taken out or doubled, or the end cut.
fn mutated(valid: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = valid.to_vec();
    for _ in 0..=random.below(4) {
        let (at, other) = (random.below(bytes.len() + 1), random.below(bytes.len() + 1));
        let (first, last) = (at.min(other), at.max(other).min(at.min(other) + 40));
        match random.below(5) {
            0 if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
            1 => drop(bytes.splice(at..at, PIECES[random.below(PIECES.len())].iter().copied())),
            2 => drop(bytes.drain(first..last)),
            3 => {
                let part = bytes[first..last].to_vec();
                drop(bytes.splice(at..at, part));
            }
            _ => bytes.truncate(bytes.len() - random.below(bytes.len().min(40) + 1)),
        }
    }
    bytes
}

/// Holds a promise on valid inputs and on `count` changed ones.
pub fn hold(promise: fn(&[u8]), valid: &[&[u8]], count: usize) {
    let mut random = Random(2026);
    valid.iter().for_each(|bytes| promise(bytes));
    for turn in 0..count {
        let bytes = mutated(valid[turn % valid.len()], &mut random);
        let start = Instant::now();
        promise(&bytes);
        assert!(start.elapsed() < PATIENCE, "{:?}", String::from_utf8_lossy(&bytes));
    }
}
