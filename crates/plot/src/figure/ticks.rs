//! Ticks: decades with their halves on logarithmic axes, steps of 1, 2 or 5 on linear ones.

use super::Scale;

/// A tick: where it stands, and its label in figure markup (empty for a minor tick).
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    /// Value on the axis.
    pub value: f64,
    /// Text next to the tick, such as `10^{-3}`; empty when the tick is a minor one.
    pub label: String,
}

impl Tick {
    /// One without a label is a minor one.
    fn of(value: f64, label: Option<String>) -> Self {
        Self { value, label: label.unwrap_or_default() }
    }

    /// Whether the tick carries a label.
    pub fn is_major(&self) -> bool {
        !self.label.is_empty()
    }
}

/// Labels that fit along an axis.
const MOST_LABELS: i32 = 9;

/// Decades along an axis up to which every multiple gets a minor tick.
const MOST_FINE_DECADES: i32 = 6;
const ALL_DIGITS: &[i32] = &[2, 3, 4, 5, 6, 7, 8, 9];
const FEW_DIGITS: &[i32] = &[2, 5];

/// Ticks between `min` and `max`, ascending.
pub(crate) fn ticks(scale: Scale, min: f64, max: f64) -> Vec<Tick> {
    let mut all = match scale {
        Scale::Linear => linear(min, max),
        Scale::Log10 => decades(min, max, 1, MOST_FINE_DECADES),
        Scale::SignedLog10 { smallest } => signed_decades(smallest, min, max),
    };
    let slack = (max - min).abs() * 1e-9;
    all.retain(|tick| match scale {
        Scale::Linear => tick.value >= min - slack && tick.value <= max + slack,
        _ => tick.value >= min - min.abs() * 1e-9 && tick.value <= max + max.abs() * 1e-9,
    });
    all
}

fn exponent_floor(value: f64) -> i32 {
    libm::floor(libm::log10(value) + 1e-9) as i32
}

/// Power of ten that is exact where binary64 allows it.
pub(crate) fn power_of_ten(exponent: i32) -> f64 {
    // Reading the decimal gives the nearest binary number; a library's power function need not.
    format!("1e{exponent}").parse().unwrap_or(f64::INFINITY)
}

fn decades(min: f64, max: f64, sign: i32, most_fine: i32) -> Vec<Tick> {
    if !(min > 0.0 && max.is_finite() && max > min) {
        return Vec::new();
    }
    let (first, last) = (exponent_floor(min), exponent_floor(max));
    let stride = (last - first) / MOST_LABELS + 1;
    let narrow = last - first < 2;
    let digits = if last - first > most_fine { FEW_DIGITS } else { ALL_DIGITS };
    let mut all = Vec::new();
    for exponent in first..=last {
        let decade = f64::from(sign) * power_of_ten(exponent);
        let labelled = exponent.rem_euclid(stride) == 0;
        all.push(Tick::of(decade, labelled.then(|| decimal_label(sign, 1, exponent))));
        for &digit in digits.iter().filter(|_| stride == 1) {
            let shown = narrow && matches!(digit, 2 | 5);
            let label = shown.then(|| decimal_label(sign, digit, exponent));
            all.push(Tick::of(f64::from(digit) * decade, label));
        }
    }
    all
}

fn signed_decades(smallest: f64, min: f64, max: f64) -> Vec<Tick> {
    let mut below =
        if min < -smallest { decades(smallest, -min, -1, MOST_FINE_DECADES / 2) } else { Vec::new() };
    below.reverse();
    below.push(Tick::of(0.0, Some("0".into())));
    if max > smallest {
        below.extend(decades(smallest, max, 1, MOST_FINE_DECADES / 2));
    }
    below.retain(|tick| tick.value == 0.0 || tick.value.abs() >= smallest * (1.0 - 1e-9));
    below
}

/// `30`, `10^{−2}` or `−3·10^{5}`: a digit times a power of ten.
fn decimal_label(sign: i32, digit: i32, exponent: i32) -> String {
    let minus_sign = if sign < 0 { "−" } else { "" };
    match exponent {
        0 => format!("{minus_sign}{digit}"),
        1 => format!("{minus_sign}{digit}0"),
        _ if digit == 1 => format!("{minus_sign}10^{{{}}}", minus(exponent)),
        _ => format!("{minus_sign}{digit}·10^{{{}}}", minus(exponent)),
    }
}

fn linear(min: f64, max: f64) -> Vec<Tick> {
    if !(min.is_finite() && max.is_finite() && max > min) {
        return Vec::new();
    }
    let (step, exponent) = round_step(max - min);
    let fine = step / 5.0;
    let (first, last) = (libm::floor(min / fine) as i64, libm::ceil(max / fine) as i64);
    let at = |index: i64| {
        let value = index as f64 * fine;
        Tick::of(value, (index.rem_euclid(5) == 0).then(|| fixed(value, exponent)))
    };
    (first..=last).map(at).collect()
}

/// Step of 1, 2 or 5 times a power of ten that gives five to ten labels, and that power's exponent.
fn round_step(span: f64) -> (f64, i32) {
    let exponent = exponent_floor(span / 5.0);
    let decade = power_of_ten(exponent);
    let factor = [5.0, 2.0, 1.0].into_iter().find(|factor| span / (factor * decade) >= 4.0).unwrap_or(1.0);
    (factor * decade, exponent)
}

fn fixed(value: f64, exponent: i32) -> String {
    let decimals = usize::try_from(-exponent).unwrap_or(0);
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.bytes().any(|b| matches!(b, b'1'..=b'9')) => format!("−{digits}"),
        Some(digits) => digits.into(),
        None => text,
    }
}

fn minus(exponent: i32) -> String {
    if exponent < 0 { format!("−{}", exponent.unsigned_abs()) } else { exponent.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: Scale, min: f64, max: f64) -> Vec<String> {
        ticks(scale, min, max).into_iter().filter(Tick::is_major).map(|tick| tick.label).collect()
    }

    #[test]
    fn every_decade_in_range_is_labelled_once() {
        assert_eq!(labels(Scale::Log10, 1e-3, 1e2), ["10^{−3}", "10^{−2}", "10^{−1}", "1", "10", "10^{2}"]);
        assert_eq!(ticks(Scale::Log10, 1e-3, 1e2).len(), 5 * 9 + 1);
    }

    #[test]
    fn many_decades_are_thinned_and_few_are_subdivided() {
        assert!(labels(Scale::Log10, 1e-30, 1e30).len() <= 10);
        assert_eq!(labels(Scale::Log10, 1.0, 10.0), ["1", "2", "5", "10"]);
        assert_eq!(labels(Scale::Log10, 0.01, 0.05), ["10^{−2}", "2·10^{−2}", "5·10^{−2}"]);
    }

    #[test]
    fn signed_ticks_ascend_through_zero() {
        let all = ticks(Scale::SignedLog10 { smallest: 1e-3 }, -1.0, 0.1);
        assert!(all.windows(2).all(|pair| pair[0].value < pair[1].value), "{all:?}");
        assert!(all.iter().any(|tick| tick.label == "−10^{−2}"));
        assert!(all.iter().any(|tick| tick.label == "0"));
    }

    #[test]
    fn linear_labels_have_the_decimals_of_their_step() {
        assert_eq!(labels(Scale::Linear, -0.5, 0.5), ["−0.4", "−0.2", "0.0", "0.2", "0.4"]);
        assert_eq!(labels(Scale::Linear, 0.0, 100.0), ["0", "20", "40", "60", "80", "100"]);
    }

    #[test]
    fn an_empty_or_impossible_range_has_no_ticks() {
        for (min, max) in [(1.0, 1.0), (2.0, 1.0), (f64::NAN, 1.0), (0.0, f64::INFINITY)] {
            assert!(ticks(Scale::Linear, min, max).is_empty());
            assert!(ticks(Scale::Log10, min, max).is_empty());
        }
    }
}
