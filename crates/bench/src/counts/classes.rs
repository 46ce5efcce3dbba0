//! The signs of many random points: how many each precision level decides, and how many each method gets wrong.
//!
//! The reference of every point is its exact rational signs; the textbook methods get the same 64-bit inputs.

use rayon::prelude::*;

use super::sets::Sliders;
use crate::methods::{TEXTBOOK, Textbook, signs_of};
use crate::paper::exactly;
use slipmode_core::friction::Parameters;
use slipmode_core::stability::batch::{PrecisionCounts, SignPair, signs_of_points};
use slipmode_core::stability::{boundary_sign, transition_sign};

/// One precision level or textbook method on random points.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ClassCount {
    /// The precision level or the method.
    pub method: &'static str,
    /// Points requested.
    pub points: u64,
    /// Points that it decided.
    pub decided: u64,
    /// A wrong sign of the growth rate, or real for complex, or the reverse.
    pub wrong: u64,
    /// Points that no precision level decides; for a textbook method, roots that are not finite.
    pub failed: u64,
}

/// Classifies this many points by every precision level, and the first of them by every textbook method.
pub(crate) fn count(points: u32, textbook_points: u32) -> Vec<ClassCount> {
    let sliders = Sliders::new();
    let rows: Vec<Parameters<f64>> =
        (0..points).into_par_iter().map(|number| sliders.parameters(number)).collect();
    let (signs, decided_by) = classify(&rows);
    let exact: Vec<SignPair> = rows.par_iter().map(exact_signs).collect();
    let requested = rows.len().min(textbook_points as usize);
    let mut counts = by_levels(&rows, &signs, &exact, decided_by);
    counts.extend(TEXTBOOK.map(|method| by_textbook(method, &rows[..requested], &exact)));
    counts
}

fn classify(rows: &[Parameters<f64>]) -> (Vec<SignPair>, PrecisionCounts) {
    let columns: [Vec<f64>; 7] =
        std::array::from_fn(|input| rows.iter().map(|row| <[f64; 7]>::from(row.clone())[input]).collect());
    // No point is decided when a value is not finite.
    signs_of_points(&Parameters::from(columns.each_ref().map(Vec::as_slice))).unwrap_or_default()
}

fn exact_signs(row: &Parameters<f64>) -> SignPair {
    let groups = row.map(|value| exactly(*value)).groups();
    SignPair::new(transition_sign(&groups), boundary_sign(&groups))
}

/// Our precision levels. A wrong point counts for the level that decides it when it is classified alone.
fn by_levels(
    rows: &[Parameters<f64>],
    signs: &[SignPair],
    exact: &[SignPair],
    decided_by: PrecisionCounts,
) -> Vec<ClassCount> {
    let mut wrong = PrecisionCounts::default();
    for ((row, _), _) in rows.iter().zip(signs).zip(exact).filter(|((_, found), exact)| found != exact) {
        wrong += classify(std::slice::from_ref(row)).1;
    }
    let points = rows.len() as u64;
    let PrecisionCounts { f64: filter, double_double, exact } = decided_by;
    let failed = points - (filter + double_double + exact);
    [
        ("ours: 64-bit filter", filter, wrong.f64),
        ("ours: double-double", double_double, wrong.double_double),
        ("ours: rationals", exact, wrong.exact),
    ]
    .map(|(method, decided, wrong)| ClassCount { method, points, decided, wrong, failed })
    .to_vec()
}

fn by_textbook((method, solve): Textbook, rows: &[Parameters<f64>], exact: &[SignPair]) -> ClassCount {
    let outcome = |(row, exact): (&Parameters<f64>, &SignPair)| match signs_of(&solve(
        row.groups().characteristic_cubic(),
    )) {
        None => [0, 1],
        Some(found) => [u64::from(found != (exact.transition_sign(), exact.boundary_sign())), 0],
    };
    let sums = rows.par_iter().zip(exact).map(outcome);
    let [wrong, failed] = sums.reduce(|| [0, 0], |one, other| [one[0] + other[0], one[1] + other[1]]);
    let points = rows.len() as u64;
    ClassCount { method, points, decided: points - failed, wrong, failed }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_is_decided_and_closed_forms_are_wrong_where_eigenvalues_are_right() {
        let found = count(20_000, 4_000);
        assert_eq!(found[..3].iter().map(|level| level.decided).sum::<u64>(), 20_000);
        assert!(found[..3].iter().all(|level| (level.wrong, level.failed) == (0, 0)), "{found:?}");
        let wrong = |name| found.iter().find(|count| count.method == name).unwrap().wrong;
        assert!(wrong("Cardano") > 40 && wrong("companion eigenvalues") == 0, "{found:?}");
    }

    #[test]
    fn a_wrong_sign_and_an_undecided_point_are_counted() {
        let rows: Vec<Parameters<f64>> = (0..20).map(|number| Sliders::new().parameters(number)).collect();
        let exact: Vec<SignPair> = rows.iter().map(exact_signs).collect();
        let (mut signs, mut decided_by) = classify(&rows);
        signs[7] = SignPair::new(-exact[7].transition_sign(), exact[7].boundary_sign());
        decided_by.f64 -= 1;
        let found = by_levels(&rows, &signs, &exact, decided_by);
        assert_eq!(found.iter().map(|level| level.wrong).sum::<u64>(), 1);
        assert!(found.iter().all(|level| level.failed == 1));
    }
}
