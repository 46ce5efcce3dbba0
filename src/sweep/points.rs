//! The points of a grid or of samples by their number: seven values, those that vary as 64-bit numbers taken exactly.

use rug::Float;

use crate::scene::{LogAxis, Quantity, Uncertain};
use crate::sweep::low_discrepancy::LowDiscrepancy;
use crate::sweep::{Coordinate, Spacing, Span, SweepPoints};
use slipmode_core::friction::{ParameterBox, Parameters};
use slipmode_core::number::{Dd, Rational, nearest_f64};

/// A point: the values of those quantities that vary; the others are not looked at.
pub type Varying = [f64; 7];

/// The points of a sweep by number, in memory that grows with the axes but not with the points.
#[derive(Debug, Clone)]
pub struct PointSource {
    coordinates: [Slot; 7],
    sequence: Option<LowDiscrepancy>,
    count: u64,
    has_error_bars: bool,
}

#[derive(Debug, Clone)]
enum Slot {
    Fixed(Box<Uncertain>, Dd),
    /// An axis, and the number of points after which it goes on to its next value.
    Axis {
        values: Vec<f64>,
        stride: u64,
    },
    /// A span, and its dimension in the sequence.
    Anywhere {
        span: Stretch,
        dimension: usize,
    },
}

/// A span in 64-bit numbers.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    from: f64,
    to: f64,
    /// Natural logarithms of the ends, when these are what is spread evenly.
    logarithms: Option<[f64; 2]>,
}

impl PointSource {
    /// The points of a section; `None` for a list, whose points are in its file. Samples are keyed by `key`.
    #[must_use]
    pub fn new(points: &SweepPoints, key: &[u8]) -> Option<Self> {
        let (coordinates, sequence, count) = match points {
            SweepPoints::Grid(coordinates) => {
                (coordinates, None, coordinates.iter().map(Coordinate::points).product())
            }
            SweepPoints::Samples { count, coordinates } => {
                (coordinates, Some(LowDiscrepancy::new(key)), *count)
            }
            SweepPoints::List { .. } => return None,
        };
        let place = |index: usize| {
            let later = &coordinates[index + 1..];
            match &coordinates[index] {
                Coordinate::Fixed(value) => {
                    Slot::Fixed(Box::new(value.clone()), Dd::from_rational(&value.middle()))
                }
                Coordinate::Axis { span, points } => Slot::Axis {
                    values: axis_values(span, *points),
                    stride: later.iter().map(Coordinate::points).product(),
                },
                Coordinate::Anywhere(span) => Slot::Anywhere {
                    span: Stretch::new(span),
                    dimension: later.iter().filter(|coordinate| coordinate.varies()).count(),
                },
            }
        };
        let has_error_bars = points.has_error_bars();
        Some(Self { coordinates: [0, 1, 2, 3, 4, 5, 6].map(place), sequence, count, has_error_bars })
    }

    /// How many points there are.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The positions in [`Quantity::ALL`] of the quantities that vary.
    #[must_use]
    pub fn varying(&self) -> Vec<usize> {
        let varies = |index: &usize| !matches!(self.coordinates[*index], Slot::Fixed(..));
        (0..Quantity::ALL.len()).filter(varies).collect()
    }

    /// The point of a number below [`Self::count`].
    #[must_use]
    pub fn at(&self, number: u64) -> Varying {
        [0, 1, 2, 3, 4, 5, 6].map(|index| match &self.coordinates[index] {
            Slot::Fixed(..) => 0.0,
            Slot::Axis { values, stride } => values[(number / stride % values.len() as u64) as usize],
            Slot::Anywhere { span, dimension } => {
                span.at(self.sequence.map_or(0.0, |sequence| sequence.coordinate(number, *dimension)))
            }
        })
    }

    /// The point's parameters, each within a relative [`Dd::UNIT`] of the true one.
    #[must_use]
    pub fn double_double(&self, point: &Varying) -> Parameters<Dd> {
        Parameters::from([0, 1, 2, 3, 4, 5, 6].map(|index| match &self.coordinates[index] {
            Slot::Fixed(_, value) => *value,
            _ => Dd::from(point[index]),
        }))
    }

    /// All values within the error bars at a point; none where no value has one.
    #[must_use]
    pub fn region(&self, point: &Varying) -> Option<ParameterBox> {
        if !self.has_error_bars {
            return None;
        }
        let values = [0, 1, 2, 3, 4, 5, 6].map(|index| match &self.coordinates[index] {
            Slot::Fixed(value, _) => value.as_ref().clone(),
            _ => Uncertain::certain(Rational::from_f64(point[index]).unwrap_or_default()),
        });
        Uncertain::region(values)
    }

    /// The point's parameters, exactly, in the middle of the error bars.
    #[must_use]
    pub fn exact(&self, point: &Varying) -> Parameters<Rational> {
        Parameters::from([0, 1, 2, 3, 4, 5, 6].map(|index| match &self.coordinates[index] {
            Slot::Fixed(value, _) => value.middle(),
            _ => Rational::from_f64(point[index]).unwrap_or_default(),
        }))
    }
}

/// The values of an axis, ascending, each the f64 nearest to its place; the ends are those nearest to `from` and `to`.
fn axis_values(span: &Span, points: u32) -> Vec<f64> {
    let (from, to) = (span.from.clone(), span.to.clone());
    match span.spacing {
        Spacing::Logarithmic => LogAxis { from, to, points }.coordinates(),
        Spacing::Linear => {
            let step = (to - &from) / points.saturating_sub(1).max(1);
            (0..points).map(|index| nearest_f64(&(from.clone() + step.clone() * index))).collect()
        }
    }
}

impl Stretch {
    fn new(span: &Span) -> Self {
        let logarithms = (span.spacing == Spacing::Logarithmic)
            // not f64: MPFR's logarithm.
            .then(|| [&span.from, &span.to].map(|end| Float::with_val(53, end).ln().to_f64()));
        Self { from: nearest_f64(&span.from), to: nearest_f64(&span.to), logarithms }
    }

    /// The value at a fraction of the way, kept within the ends whatever the rounding.
    fn at(&self, fraction: f64) -> f64 {
        let value = match self.logarithms {
            Some([from, to]) => libm::exp(from + fraction * (to - from)),
            None => self.from + fraction * (self.to - self.from),
        };
        value.clamp(self.from, self.to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::number::parse_decimal;

    fn span(from: &str, to: &str, spacing: Spacing) -> Span {
        Span { from: parse_decimal(from).unwrap(), to: parse_decimal(to).unwrap(), spacing }
    }

    fn fixed() -> [Coordinate; 7] {
        [1, 2, 3, 4, 5, 6, 7].map(|value| Coordinate::Fixed(Uncertain::certain(Rational::from((value, 3)))))
    }

    #[test]
    fn a_grid_goes_through_every_combination_the_last_axis_fastest() {
        let mut coordinates = fixed();
        coordinates[3] = Coordinate::Axis { span: span("1", "100", Spacing::Logarithmic), points: 3 };
        coordinates[6] = Coordinate::Axis { span: span("0.1", "0.4", Spacing::Linear), points: 4 };
        let source = PointSource::new(&SweepPoints::Grid(Box::new(coordinates)), b"").unwrap();
        assert_eq!((source.count(), source.varying()), (12, vec![3, 6]));
        let points: Vec<_> =
            (0..12).map(|number| source.at(number)).map(|point| (point[3], point[6])).collect();
        assert_eq!(points[..5], [(1.0, 0.1), (1.0, 0.2), (1.0, 0.3), (1.0, 0.4), (10.0, 0.1)]);
        assert_eq!(points[11], (100.0, 0.4));
        let exact = source.exact(&source.at(4));
        assert_eq!(exact.slider.direct_effect, Rational::from((1, 3)), "a decimal stays exact");
        assert_eq!(
            exact.point.loading_velocity_m_per_s,
            Rational::from_f64(0.1).unwrap(),
            "a coordinate is its 64-bit number"
        );
        assert_eq!(source.double_double(&source.at(4)).slider.stiffness_pa_per_m, Dd::from(10.0));
    }

    #[test]
    fn samples_stay_in_their_box_and_depend_on_key_and_number_only() {
        let mut coordinates = fixed();
        coordinates[0] = Coordinate::Anywhere(span("1e-300", "1e300", Spacing::Logarithmic));
        coordinates[5] = Coordinate::Anywhere(span("2", "3", Spacing::Linear));
        let points = SweepPoints::Samples { count: 1000, coordinates: Box::new(coordinates) };
        let (one, other) =
            (PointSource::new(&points, b"1").unwrap(), PointSource::new(&points, b"2").unwrap());
        let all: Vec<_> = (0..1000).map(|number| one.at(number)).collect();
        assert!(all.iter().all(|p| (1e-300..=1e300).contains(&p[0]) && (2.0..=3.0).contains(&p[5])));
        let below = all.iter().filter(|point| point[0] < 1.0 && point[5] < 2.5).count();
        // A quarter of the box; 1000 Halton points in two dimensions miss it by far less than 3 %.
        assert!((220..280).contains(&below), "{below}");
        assert_ne!(one.at(7), other.at(7));
    }
}
