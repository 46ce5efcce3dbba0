//! How far off the asymptotes are, in one sentence.

use crate::experiments::Outcome;
use crate::experiments::boundary::figures::equation_label;
use crate::experiments::tolerance::tables::place_of_limit;
use crate::experiments::tolerance::{ToleranceOutcome, ToleranceRow};
use slipmode_core::number::format::{rational_to_decimal, round_digits};
use slipmode_core::number::{Ball, Rational};

/// Digits of a limit in the sentence; the table has more.
const DIGITS: usize = 2;

/// Where each asymptote of the first slider is accurate to one per cent, or to the best that the scene asks for above it, and how far
/// off the nearer asymptote is at worst: Markdown; `None` when no scene asks for it.
#[must_use]
pub fn accuracy_of_asymptotes(outcome: &Outcome) -> Option<String> {
    let (_, found) = outcome.each(|scene| &scene.tolerance).next()?;
    let one_per_cent = Rational::from((1, 100));
    let tolerances = || found.rows.iter().map(|row| &row.tolerance);
    let tolerance = tolerances().filter(|it| **it >= one_per_cent).min().or_else(|| tolerances().max())?;
    let rows = found.rows.iter().filter(|row| row.tolerance == *tolerance);
    let per_cent = rational_to_decimal(&Rational::from(tolerance * 100u32), DIGITS);
    let list: Vec<String> = rows.map(row_words).collect();
    Some(format!(
        "The asymptotes equal the exact boundary within {per_cent} % only far from their corners: {}{}.",
        list.join(", "),
        worst_words(found)
    ))
}

fn row_words(row: &ToleranceRow) -> String {
    let limit = &row.limit;
    let equation = equation_label(limit.asymptote);
    if limit.whole_branch {
        return format!("{equation} for {}", place_of_limit(limit));
    }
    let unit = if limit.asymptote.is_quasi_static() { "m/s" } else { "Pa" };
    format!("{equation} for {} {} {unit}", place_of_limit(limit), scientific(&row.in_si))
}

/// Where two asymptotes meet, the nearer of the two is farthest from the boundary.
fn worst_words(found: &ToleranceOutcome) -> String {
    let factor = |log10: &Ball| round_digits(libm::exp10(log10.to_f64()), DIGITS + 1);
    let lower = factor(&found.corners.lower_worst_log10);
    let upper = found.corners.upper_worst_log10.as_ref();
    let upper =
        upper.map_or_else(String::new, |upper| format!("a factor {} at eqs 15 and 18, and ", factor(upper)));
    format!(". The error is largest where two of them meet: {upper}a factor {lower} at eqs 16 and 20")
}

/// The value as `$6.2\times10^{-5}$`, or as it is between a hundredth and ten thousand.
fn scientific(value: &Ball) -> String {
    let value = value.to_f64();
    let exponent = libm::floor(libm::log10(value));
    if (-2.0..4.0).contains(&exponent) {
        return round_digits(value, DIGITS);
    }
    format!("${}\\times10^{{{exponent}}}$", round_digits(value / libm::exp10(exponent), DIGITS))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_ten_are_set_where_they_help() {
        let shown = |value: f64| scientific(&Ball::from_rational(&Rational::from_f64(value).unwrap(), 64));
        assert_eq!(shown(6.24e-5), "$6.2\\times10^{-5}$");
        assert_eq!(shown(333.0), "330");
        assert_eq!(shown(3.04e7), "$3\\times10^{7}$");
    }
}
