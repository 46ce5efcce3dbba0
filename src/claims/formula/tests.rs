//! Random formulas, decided and compared with their truth at points.

use slipmode_core::theory::Equations;

use super::*;
use crate::claims::Verdict;
use crate::scene::{Scope, read_equations};

const EQUATIONS: &[u8] = include_bytes!("../../../reports/im-avouac/equations.toml");

/// A comparison, and its truth for K, M and V in halves.
type Atom = (&'static str, fn([i64; 3]) -> bool);

const ATOMS: [Atom; 10] = [
    ("K > M", |[k, m, _]| k > m),
    ("K >= M", |[k, m, _]| k >= m),
    ("K = M", |[k, m, _]| k == m),
    ("K != V", |[k, _, v]| k != v),
    ("M <= V", |[_, m, v]| m <= v),
    ("K + M > V", |[k, m, v]| k + m > v),
    ("K*M >= V^2", |[k, m, v]| k * m >= v * v),
    ("2*K < M", |[k, m, _]| 2 * k < m),
    ("K - V < 1", |[k, _, v]| k - v < 2),
    ("stable(z^2 + (K - M)*z + V, z)", |[k, m, _]| k > m),
];

/// A formula in words with its truth.
type Random = (String, Box<dyn Fn([i64; 3]) -> bool>);

/// A random formula, from a sequence of numbers.
fn formula(next: &mut impl FnMut(usize) -> usize, depth: u32) -> Random {
    if depth == 0 || next(5) == 0 {
        let (text, truth) = ATOMS[next(ATOMS.len())];
        return (text.to_owned(), Box::new(truth));
    }
    let (one, truth) = formula(next, depth - 1);
    if next(5) == 0 {
        return (format!("not [{one}]"), Box::new(move |point| !truth(point)));
    }
    let (other, second) = formula(next, depth - 1);
    let (word, join): (_, fn(bool, bool) -> bool) = [
        ("and", (|a, b| a && b) as fn(bool, bool) -> bool),
        ("or", |a, b| a || b),
        ("implies", |a, b| !a || b),
        ("iff", |a, b| a == b),
    ][next(4)];
    (format!("[{one}] {word} [{other}]"), Box::new(move |point| join(truth(point), second(point))))
}

/// The value of a name in halves in `at K = 1/2, M = 3: …`, if it is a whole number of them.
fn halves(example: &str, name: &str) -> Option<i64> {
    let list = example.strip_prefix("at ").unwrap().split(": ").next().unwrap();
    let value = list.split(", ").find_map(|pair| pair.strip_prefix(&format!("{name} = ")));
    let value: slipmode_core::number::Rational = value.unwrap_or("1").parse().unwrap();
    let doubled: slipmode_core::number::Rational = value * 2;
    doubled.is_integer().then(|| doubled.numer().to_i64())?
}

#[test]
fn no_random_formula_holds_that_a_point_refutes_and_every_counter_example_is_one() {
    let equations: Equations = read_equations("equations.toml", EQUATIONS).unwrap();
    let mut state = 7_u64;
    let mut next = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(state >> 40).unwrap() % below
    };
    let values = [1, 2, 3, 4, 6];
    let points: Vec<[i64; 3]> =
        (0..125).map(|index| [values[index / 25], values[index / 5 % 5], values[index % 5]]).collect();
    let (mut held, mut failed, mut open) = (0, 0, 0);
    for turn in 0..200 {
        // Most are false; of several one is true more often.
        let several: Vec<Random> =
            (0..=turn % 2 * 4).map(|_| formula(&mut next, 3 - turn as u32 % 2)).collect();
        let text = several.iter().map(|(text, _)| format!("[{text}]")).collect::<Vec<_>>().join(" or ");
        let truth = |point| several.iter().any(|(_, truth)| truth(point));
        // Some are true by construction, and refused.
        let Ok(read) = ClaimFormula::read(&text, Scope::default(), &equations) else { continue };
        let found = decide_equations("formula", "", &read, &equations);
        match found.verdict {
            Verdict::Holds => {
                held += 1;
                let refuting = points.iter().find(|point| !truth(**point));
                assert_eq!(refuting, None, "{text} is said to hold");
            }
            Verdict::Fails => {
                failed += 1;
                let example = found.counter_example.unwrap();
                let point = ["K", "M", "V"].map(|name| halves(&example, name));
                if let [Some(k), Some(m), Some(v)] = point {
                    assert!(!truth([k, m, v]), "{text}: {example}");
                }
            }
            _ => open += 1,
        }
    }
    assert!(held >= 10 && failed >= 60 && open <= 20, "{held} held, {failed} failed, {open} open");
}
