//! How far off the asymptotes are, in one sentence.

use crate::experiments::Outcome;
use crate::experiments::tolerance::tables::place_of_limit;
use crate::experiments::tolerance::{ToleranceOutcome, ToleranceRow};
use slipmode_core::number::format::{Side, rational_to_decimal, rounded};
use slipmode_core::number::{Ball, Rational};
use slipmode_core::stability::boundary::ErrorPair;

/// Digits of a limit in the sentence; the table has more.
const DIGITS: usize = 2;

/// Digits of an error in per cent.
const PER_CENT_DIGITS: usize = 3;

/// Where each asymptote of the first slider is accurate to one per cent, or to the best that the scene asks for above it, and how far
/// off each is at worst: Markdown; `None` when no scene asks for it.
pub(crate) fn accuracy_of_asymptotes(outcome: &Outcome) -> Option<String> {
    let (_, found) = outcome.each(|scene| &scene.tolerance).next()?;
    let one_per_cent = Rational::from((1, 100));
    let tolerances = || found.rows.iter().map(|row| &row.tolerance);
    let tolerance = tolerances().filter(|it| **it >= one_per_cent).min().or_else(|| tolerances().max())?;
    let rows = found.rows.iter().filter(|row| row.tolerance == *tolerance);
    let per_cent = rational_to_decimal(&Rational::from(tolerance * 100u32), DIGITS);
    let list: Vec<String> = rows.map(row_words).collect();
    Some(format!(
        "The asymptotes equal the exact boundary within {per_cent} % only far from their corners: {}. Up to the corner or the cusp, where another one takes over, their errors are up to {}.",
        list.join(", "),
        worst_words(found)
    ))
}

fn row_words(row: &ToleranceRow) -> String {
    let limit = &row.limit;
    let equation = limit.asymptote.as_str().replace("eq", "eq ");
    if limit.whole_branch {
        return format!("{equation} for {}", place_of_limit(limit.asymptote, limit.whole_branch));
    }
    let unit = if limit.asymptote.is_quasi_static() { "m/s" } else { "Pa" };
    let place = place_of_limit(limit.asymptote, limit.whole_branch);
    let side = if place.ends_with("above") { Side::Above } else { Side::Below };
    format!("{equation} for {place} {} {unit}", scientific(&row.in_si, side))
}

/// The largest error of each asymptote: of eqs 15 and 18 at the V0 of their corner, of eqs 16 and 20 at the cusp.
fn worst_words(found: &ToleranceOutcome) -> String {
    let per_cent = |error: &Ball, equation: u32| format!("{} (eq {equation})", at_most_per_cent(error));
    let upper = found.corners.upper.as_ref();
    let (cusp, upper) = (&found.corners.cusp, |of: fn(&ErrorPair) -> &Ball, equation| {
        upper.map(|pair| per_cent(of(pair), equation))
    });
    let errors = [
        upper(|pair| &pair.quasi_static, 15),
        Some(per_cent(&cusp.quasi_static, 16)),
        upper(|pair| &pair.inertial, 18),
        Some(per_cent(&cusp.inertial, 20)),
    ];
    errors.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// A relative error as every sentence states it: in per cent, away from zero.
pub(crate) fn at_most_per_cent(error: &Ball) -> String {
    let error = 100.0 * error.to_f64();
    let side = if error < 0.0 { Side::Below } else { Side::Above };
    format!("{} %", rounded(error, PER_CENT_DIGITS, side).replace('-', "−"))
}

/// The value as `$6.2\times10^{-5}$`, or as it is between a hundredth and ten thousand, rounded to one side.
pub(crate) fn scientific(value: &Ball, side: Side) -> String {
    let shown = |value: f64| rounded(value, DIGITS, side);
    let value = value.to_f64();
    let exponent = libm::floor(libm::log10(value));
    if (-2.0..4.0).contains(&exponent) {
        return shown(value);
    }
    format!("${}\\times10^{{{exponent}}}$", shown(value / libm::exp10(exponent)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_ten_are_set_where_they_help() {
        let shown = |value: f64, side: Side| {
            scientific(&Ball::from_rational(&Rational::from_f64(value).unwrap(), 64), side)
        };
        assert_eq!(shown(6.24e-5, Side::Below), "$6.2\\times10^{-5}$");
        assert_eq!(shown(6.24e-5, Side::Above), "$6.3\\times10^{-5}$");
        assert_eq!(shown(333.0, Side::Below), "330");
        assert_eq!(shown(3.04e7, Side::Above), "$3.1\\times10^{7}$");
    }
}
