//! The class of many random points: how many each precision level decides, and how many each textbook method gets wrong.
//!
//! The reference is the exact classification itself; the textbook methods get the same 64-bit inputs.

use rayon::prelude::*;

use super::sets::Sliders;
use crate::methods::{TEXTBOOK, Textbook, signs_of};
use slipmode_core::friction::Parameters;
use slipmode_core::stability::batch::{PrecisionCounts, SignPair, classify_points};

/// Classes of random points.
#[derive(Debug, Clone, PartialEq)]
pub struct ClassCounts {
    /// Points that were classified exactly.
    pub points: u64,
    /// How many of them each precision level decided.
    pub decided_by: PrecisionCounts,
    /// Textbook methods on the first of them.
    pub methods: Vec<MethodCount>,
}

/// One textbook method on random points.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MethodCount {
    /// The method.
    pub method: &'static str,
    /// Points requested.
    pub points: usize,
    /// A wrong sign of the growth rate, or real for complex, or the reverse.
    pub wrong: usize,
    /// Roots that are not finite.
    pub failed: usize,
}

/// Classifies this many points, and the first of them by every textbook method.
pub(crate) fn count(points: u32, textbook_points: u32) -> ClassCounts {
    let sliders = Sliders::new();
    let rows: Vec<Parameters<f64>> =
        (0..points).into_par_iter().map(|number| sliders.parameters(number)).collect();
    let columns: [Vec<f64>; 7] =
        std::array::from_fn(|input| rows.iter().map(|row| <[f64; 7]>::from(row.clone())[input]).collect());
    let exact = classify_points(&Parameters::from(columns.each_ref().map(Vec::as_slice)));
    // Every value is a power of ten to a finite exponent.
    let (signs, decided_by) = exact.unwrap_or_default();
    let requested = rows.len().min(textbook_points as usize);
    let methods = TEXTBOOK.map(|method| by_textbook(method, &rows[..requested], &signs)).to_vec();
    ClassCounts { points: signs.len() as u64, decided_by, methods }
}

fn by_textbook((name, solve): Textbook, rows: &[Parameters<f64>], signs: &[SignPair]) -> MethodCount {
    let outcome = |(row, exact): (&Parameters<f64>, &SignPair)| match signs_of(&solve(
        row.groups().characteristic_cubic(),
    )) {
        None => [0, 1],
        Some(found) => [usize::from(found != (exact.transition_sign(), exact.boundary_sign())), 0],
    };
    let sums = rows.par_iter().zip(signs).map(outcome);
    let [wrong, failed] = sums.reduce(|| [0, 0], |one, other| [one[0] + other[0], one[1] + other[1]]);
    MethodCount { method: name, points: rows.len(), wrong, failed }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_is_decided_and_closed_forms_are_wrong_where_eigenvalues_are_right() {
        let found = count(20_000, 4_000);
        assert_eq!(found.decided_by.f64 + found.decided_by.double_double + found.decided_by.exact, 20_000);
        let wrong = |name| found.methods.iter().find(|method| method.method == name).unwrap().wrong;
        assert!(wrong("Cardano") > 40 && wrong("companion eigenvalues") == 0, "{:?}", found.methods);
    }
}
