//! The ranges of growth rate, largest imaginary part and frequency over error bars, as text, JSON and cells.

use slipmode_core::number::format::{ends_around, ends_within};
use slipmode_core::number::{Rational, Wide, nearest_f64};
use slipmode_core::stability::{OverBox, ParameterBox, Ranges, ValueRange, ranges_over_box};

use crate::cli::answer::{Answer, SHOWN_DIGITS};

/// The text states where values are attained if the enclosure is wider by more than this share of them.
const NOTICED: f64 = 1e-6;

/// The ranges over a box; absent beyond 64-bit numbers.
#[derive(Debug)]
pub struct RootRanges {
    of_parts: Ranges,
    frequency_hz: Option<ValueRange>,
}

impl RootRanges {
    /// The ranges over a box, of which `found` states the exact signs.
    pub fn new(region: &ParameterBox, found: &OverBox) -> Self {
        let of_parts = ranges_over_box(region, found);
        Self { of_parts, frequency_hz: of_parts.max_imaginary_per_s.map(in_hertz) }
    }

    fn all(&self) -> [Option<ValueRange>; 3] {
        [self.of_parts.max_real_per_s, self.of_parts.max_imaginary_per_s, self.frequency_hz]
    }

    /// Ends of max Re(s), of max Im(s) and of the frequency, between which all values lie.
    pub fn enclosures(&self) -> [Option<[f64; 2]>; 3] {
        self.all().map(|range| range.map(|range| range.enclosure))
    }

    /// States the enclosures, and the least and greatest values that were found at points of the box.
    pub fn answer(&self) -> Answer {
        let names = [
            ("max_real_per_s", "max Re(s)", "1/s", ""),
            ("max_imaginary_per_s", "max Im(s)", "1/s", ""),
            ("frequency_hz", "frequency", "Hz", "(max Im(s)/2 pi)"),
        ];
        let (mut answer, mut attained) = (Answer::default(), Answer::default());
        for ((key, name, unit, note), range) in names.into_iter().zip(self.all()) {
            attained = attained.with(key, range.map(|range| range.attained));
            answer = answer.with(key, range.map(|range| range.enclosure));
            answer = match range {
                Some(range) => {
                    let note = attained_words(&range).unwrap_or_else(|| note.to_string());
                    let ends = ends_around(range.enclosure, SHOWN_DIGITS).join(" to ");
                    answer.named(name, &format!("{ends} {unit}")).note(&note)
                }
                None => answer.named(name, "-").note("(beyond the range of 64-bit numbers)"),
            };
        }
        answer.part("attained", attained)
    }
}

/// States the values that occur, where the enclosure is noticeably wider.
fn attained_words(ValueRange { enclosure, attained }: &ValueRange) -> Option<String> {
    let is_wide = |i: usize| (enclosure[i] - attained[i]).abs() > NOTICED * attained[i].abs();
    (is_wide(0) || is_wide(1))
        .then(|| format!("(enclosed; values of {} occur)", ends_within(*attained, SHOWN_DIGITS).join(" to ")))
}

/// The frequencies, enclosed.
fn in_hertz(range: ValueRange) -> ValueRange {
    let tau = std::f64::consts::TAU;
    let [low, high] = range.enclosure.map(|value| value / tau);
    // Two roundings, of 2 pi and of the quotient; zero is exact.
    let down = |value: f64| if value > 0.0 { value.next_down().next_down() } else { 0.0 };
    let up = |value: f64| if value > 0.0 { value.next_up().next_up() } else { 0.0 };
    ValueRange { enclosure: [down(low), up(high)], attained: range.attained.map(|value| value / tau) }
}

/// Numbers of 64 bits that enclose a range.
pub fn outward([least, greatest]: &[Rational; 2]) -> [f64; 2] {
    let (low, high) = (nearest_f64(least), nearest_f64(greatest));
    let is_above = Rational::from_f64(low).is_some_and(|low| low > *least);
    let is_below = Rational::from_f64(high).is_some_and(|high| high < *greatest);
    [if is_above { low.next_down() } else { low }, if is_below { high.next_up() } else { high }]
}

/// A range as it is typed as an input; empty where it is absent.
pub fn cell(range: Option<[f64; 2]>) -> String {
    let [low, high] = match range.map(|ends| ends.map(Wide::from_f64)) {
        Some([Some(low), Some(high)]) => [low, high],
        _ => return String::new(),
    };
    format!("[{low}, {high}]")
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::number::Ball;

    #[test]
    fn frequencies_are_enclosed() {
        for value in [0.0, 1e-300, 0.1, 1.0, std::f64::consts::TAU, 7.0, 1e17] {
            let range = in_hertz(ValueRange { enclosure: [value; 2], attained: [value; 2] });
            let exact = Ball::from_rational(&Rational::from_f64(value).unwrap(), 200)
                / (Ball::pi(200) * Ball::from(2));
            let [low, high] =
                range.enclosure.map(|end| Ball::from_rational(&Rational::from_f64(end).unwrap(), 200));
            assert!((exact.clone() - low).lower() >= 0 && (high - exact).lower() >= 0, "{value}");
        }
        assert_eq!(cell(Some([0.0, 0.5])), "[0, 0.5]");
        assert_eq!(cell(None), "");
    }
}
