//! Valid inputs with a few bytes changed, the same ones every time, held against what every reader promises.

use std::time::{Duration, Instant};

use slipmode::archive::{Files, ReleaseTime, pack};

use crate::promises;

/// The longest that one reader may spend on one input.
const PATIENCE: Duration = Duration::from_secs(2);

/// A generator of 64-bit numbers: splitmix64, from a fixed seed.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, limit: usize) -> usize {
        usize::try_from(self.next() % u64::try_from(limit.max(1)).unwrap()).unwrap()
    }
}

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
fn hold(promise: fn(&[u8]), valid: &[&[u8]], count: usize) {
    let mut random = Random(2026);
    valid.iter().for_each(|bytes| promise(bytes));
    for turn in 0..count {
        let bytes = mutated(valid[turn % valid.len()], &mut random);
        let start = Instant::now();
        promise(&bytes);
        assert!(start.elapsed() < PATIENCE, "{:?}", String::from_utf8_lossy(&bytes));
    }
}

#[test]
fn changed_numbers_are_refused_or_read_as_written() {
    hold(promises::number, &[b"0.004", b"-1.5e-3", b"+.5E2", b"123456789.000001e300", b"7e10000"], 5_000);
}

#[test]
fn changed_scenes_are_refused_or_read_as_written() {
    let scenes = [
        include_str!("../../reports/im-avouac/scenes/potentially-unstable.toml"),
        include_str!("../../reports/im-avouac/scenes/effect-ratio-sweep.toml"),
        include_str!("../../reports/im-avouac/scenes/numerical-error.toml"),
    ];
    hold(promises::scene, &scenes.map(str::as_bytes), 400);
}

#[test]
fn changed_expressions_are_refused_or_print_as_they_read() {
    let expressions: [&[u8]; 4] = [
        b"(b - a)*sigma/D_c*(1 + M*V_0^2/(sigma*a*D_c))",
        b"-V*theta/D_c*ln(V*theta/D_c)",
        b"a*asinh(V/(2*V_0)*exp((mu_0 + b*ln(V_0*theta/D_c))/a))",
        b"\xc2\xb1i*sqrt((b - a)/a)*V_0/D_c",
    ];
    hold(promises::expression, &expressions, 4_000);
}

#[test]
fn changed_archives_are_refused_or_pack_to_the_same_files() {
    let text: String = (0..200).map(|line| format!("{line},{}\n", line * line)).collect();
    let files = Files::from([
        ("inputs/report.toml".to_string(), b"name = \"r\"\n".to_vec()),
        ("report/tables/t.csv".to_string(), text.into_bytes()),
    ]);
    let packed = pack(&files, ReleaseTime::UNSTATED).unwrap();
    hold(promises::archive, &[&packed], 4_000);
}
