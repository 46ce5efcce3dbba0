//! Axes: which values a figure shows, and where along an edge a value lies.

use super::Scale;
use super::ticks::{Tick, ticks};

/// An axis: title, unit, scale and the range shown.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Axis {
    /// Title with figure markup, such as `Loading velocity *V*_0`.
    pub title: String,
    /// Unit, such as `m/s`; empty for pure numbers.
    pub unit: String,
    /// How values are spread.
    pub scale: Scale,
    /// Value at the left or lower end.
    pub min: f64,
    /// Value at the right or upper end, larger than `min`.
    pub max: f64,
}

impl Axis {
    /// An axis on a linear scale.
    #[must_use]
    pub fn linear(title: &str, unit: &str, min: f64, max: f64) -> Self {
        Self { title: title.into(), unit: unit.into(), scale: Scale::Linear, min, max }
    }

    /// An axis on a log10 scale; `min` must be positive.
    #[must_use]
    pub fn log10(title: &str, unit: &str, min: f64, max: f64) -> Self {
        Self { title: title.into(), unit: unit.into(), scale: Scale::Log10, min, max }
    }

    /// Where the value lies between the ends, 0 at `min` and 1 at `max`; `None` when the scale has no place for it.
    #[must_use]
    pub fn position(&self, value: f64) -> Option<f64> {
        let (low, high) = (self.scale.coordinate(self.min)?, self.scale.coordinate(self.max)?);
        let at = (self.scale.coordinate(value)? - low) / (high - low);
        at.is_finite().then_some(at)
    }

    /// The value at a position: the inverse of [`Axis::position`].
    #[must_use]
    pub fn value_at(&self, position: f64) -> Option<f64> {
        let (low, high) = (self.scale.coordinate(self.min)?, self.scale.coordinate(self.max)?);
        let value = self.scale.value(low + position * (high - low));
        value.is_finite().then_some(value)
    }

    /// Ticks inside the range, in ascending order.
    pub(crate) fn ticks(&self) -> Vec<Tick> {
        ticks(self.scale, self.min, self.max)
    }

    /// Title with unit: `Loading velocity *V*_0 (m/s)`.
    pub(crate) fn heading(&self) -> String {
        if self.unit.is_empty() { self.title.clone() } else { format!("{} ({})", self.title, self.unit) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn signed_log10(smallest: f64, min: f64) -> Axis {
        Axis { scale: Scale::SignedLog10 { smallest }, ..Axis::linear("error", "", min, 1.0) }
    }

    #[test]
    fn a_decade_is_the_same_length_everywhere_on_a_log_axis() {
        let axis = Axis::log10("V", "m/s", 1e-8, 1e2);
        for n in 0..=10 {
            let at = axis.position(libm::exp10(f64::from(n - 8))).unwrap();
            assert!((at - f64::from(n) / 10.0).abs() < 1e-14, "{n}: {at}");
        }
        assert_eq!(axis.position(0.0), None);
        assert_eq!(axis.position(-1.0), None);
        assert_eq!(axis.position(f64::NAN), None);
    }

    #[test]
    fn a_signed_axis_is_odd_and_continuous_where_it_turns_linear() {
        let axis = signed_log10(1e-6, -1.0);
        for value in [1e-9, 1e-6, 2e-6, 1e-3, 0.5] {
            let (up, down) = (axis.position(value).unwrap(), axis.position(-value).unwrap());
            assert!((up + down - 1.0).abs() < 1e-15);
        }
        let (below, above) = (axis.position(1e-6 * (1.0 - 1e-9)), axis.position(1e-6 * (1.0 + 1e-9)));
        assert!((below.unwrap() - above.unwrap()).abs() < 1e-8);
    }

    #[test]
    fn value_at_inverts_position() {
        for axis in
            [Axis::linear("x", "", -3.0, 7.0), Axis::log10("x", "", 1e-5, 1e3), signed_log10(1e-4, -10.0)]
        {
            for step in 0..=20 {
                let at = f64::from(step) / 20.0;
                let back = axis.position(axis.value_at(at).unwrap()).unwrap();
                assert!((back - at).abs() < 1e-13, "{axis:?} {at} {back}");
            }
        }
    }
}
