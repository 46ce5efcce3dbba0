//! The boundary and the transition over error bars: at each loading velocity the normal stresses at which some values have them, as bands.

use rayon::prelude::*;

use slipmode_core::number::format::round_digits;
use slipmode_core::number::{Rational, nearest_f64, parse_decimal};
use slipmode_core::stability::ParameterBox;
use slipmode_core::stability::inverse::{SolutionRange, Target, Unknown, solve_over_box};
use slipmode_plot::figure::{Axis, Line, LineRole};

/// Velocities at which a figure's bands are computed.
pub(crate) const VELOCITIES: u32 = 72;

/// Significant digits of these velocities.
const DIGITS: usize = 6;

/// Two ranges at neighbouring velocities belong to one band if their distance in ln σ is at most so many steps in ln V0: no line of
/// theory is steeper but next to the cusp.
const STEEPEST: f64 = 2.0;

/// How far beyond the axis of normal stress an end without a bound is drawn.
const BEYOND: f64 = 1e3;

/// A line of theory with error bars.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BandOf {
    /// The boundary max Im(s) = 0.
    Boundary,
    /// The transition K = K_c.
    Transition,
}

impl BandOf {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Boundary, Self::Transition];

    /// Its word in tables.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Boundary => "boundary",
            Self::Transition => "transition",
        }
    }

    fn target(self) -> Target {
        match self {
            Self::Boundary => Target::Boundary,
            Self::Transition => Target::GrowthRate(Rational::new()),
        }
    }

    /// All solutions for one coordinate at this value of the other one, which the box's own values do not affect.
    #[must_use]
    pub fn ranges(self, region: &ParameterBox, unknown: Unknown, known: &Rational) -> Vec<SolutionRange> {
        let [mut lower, mut upper] = [region.lower(), region.upper()];
        for end in [&mut lower, &mut upper] {
            match unknown {
                Unknown::NormalStress => end.point.loading_velocity_m_per_s = known.clone(),
                _ => end.point.normal_stress_pa = known.clone(),
            }
        }
        let region = ParameterBox::new(lower, upper);
        region.map_or_else(Vec::new, |region| solve_over_box(&region, unknown, &self.target()))
    }
}

/// A line of theory over error bars: at each velocity, ascending, the ranges of normal stress.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// Which line.
    pub of: BandOf,
    /// The loading velocities with their ranges.
    pub columns: Vec<(Rational, Vec<SolutionRange>)>,
}

/// Both bands at these loading velocities.
#[must_use]
pub fn bands(region: &ParameterBox, velocities: &[Rational]) -> Vec<Band> {
    let band = |of: BandOf| {
        let column =
            |velocity: &Rational| (velocity.clone(), of.ranges(region, Unknown::NormalStress, velocity));
        Band { of, columns: velocities.par_iter().map(column).collect() }
    };
    BandOf::ALL.into_iter().map(band).collect()
}

/// Velocities from one end of an axis to the other, even on it to rounding to short decimals.
#[must_use]
pub fn velocities((from, to): (f64, f64), points: u32) -> Vec<Rational> {
    let (low, high) = (libm::log10(from), libm::log10(to));
    let at = |index: u32| low + (high - low) * f64::from(index) / f64::from(points.max(2) - 1);
    let decimal = |index: u32| parse_decimal(&round_digits(libm::exp10(at(index)), DIGITS)).ok();
    (0..points).filter_map(decimal).collect()
}

/// The bands as areas of a map.
#[must_use]
pub fn band_lines(bands: &[Band], y: &Axis) -> Vec<Line> {
    let lines = |band: &Band| {
        let (label, role) = match band.of {
            BandOf::Boundary => ("boundary within the error bars", LineRole::BoundaryBand),
            BandOf::Transition => ("transition within the error bars", LineRole::TransitionBand),
        };
        outlines(band, y).into_iter().map(|outline| Line::new(label, role, outline)).collect::<Vec<_>>()
    };
    bands.iter().flat_map(lines).collect()
}

/// A range of normal stress at a velocity.
type Place = (f64, [f64; 2]);

/// The outlines of a band: ranges at neighbouring velocities are joined.
fn outlines(band: &Band, y: &Axis) -> Vec<Vec<(f64, f64)>> {
    let columns: Vec<Vec<Place>> = band.columns.iter().map(|column| places(column, y)).collect();
    let mut open: Vec<Vec<Place>> = Vec::new();
    let mut closed: Vec<Vec<Place>> = Vec::new();
    for next in columns {
        let joined =
            |chain: &Vec<Place>, place: &Place| chain.last().is_some_and(|last| are_joined(last, place));
        let mut continued = Vec::new();
        for place in &next {
            let mut before: Vec<&Vec<Place>> = open.iter().filter(|chain| joined(chain, place)).collect();
            let alone = before.pop_if(|chain| next.iter().filter(|other| joined(chain, other)).count() == 1);
            match (alone, before.is_empty()) {
                (Some(chain), true) => continued.push(chain.iter().chain([place]).copied().collect()),
                (alone, _) => {
                    // Where ranges part or meet, each is joined by an area of its own.
                    let pieces = before.into_iter().chain(alone).filter_map(|chain| chain.last());
                    closed.extend(pieces.map(|last| vec![*last, *place]));
                    continued.push(vec![*place]);
                }
            }
        }
        let is_continued =
            |chain: &Vec<Place>| continued.iter().any(|longer: &Vec<Place>| longer.starts_with(chain));
        closed.extend(open.into_iter().filter(|chain| !is_continued(chain)));
        open = continued;
    }
    closed.extend(open);
    closed.into_iter().filter(|chain| chain.len() > 1).map(|chain| outline(&chain)).collect()
}

fn places((velocity, ranges): &(Rational, Vec<SolutionRange>), y: &Axis) -> Vec<Place> {
    let velocity = nearest_f64(velocity);
    let (least, greatest) = (y.min / BEYOND, y.max * BEYOND);
    ranges.iter().map(|range| (velocity, range.enclosure.map(|end| end.clamp(least, greatest)))).collect()
}

fn are_joined((slow, [low, high]): &Place, (fast, [next_low, next_high]): &Place) -> bool {
    let gap = (next_low / high).max(low / next_high);
    libm::log(gap) <= STEEPEST * libm::log(fast / slow)
}

/// Along the lower ends and back along the upper ones.
fn outline(chain: &[Place]) -> Vec<(f64, f64)> {
    let end = |of: usize| move |(velocity, range): &Place| (*velocity, range[of]);
    chain.iter().map(end(0)).chain(chain.iter().rev().map(end(1))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::friction::Parameters;
    use slipmode_core::stability::{InertialThreshold, over_box};

    fn region(ends: [[&str; 5]; 2]) -> ParameterBox {
        let point = |[a, b, d, k, m]: [&str; 5]| {
            Parameters::from([a, b, d, k, m, "1", "1"].map(|text| parse_decimal(text).unwrap()))
        };
        let [lower, upper] = ends.map(point);
        ParameterBox::new(lower, upper).unwrap()
    }

    #[test]
    fn between_the_bands_the_signs_are_certain_and_inside_they_are_not() {
        let region = region([
            ["0.0088", "0.0122", "7.8e-6", "1.9e9", "2300"],
            ["0.0092", "0.0130", "8.2e-6", "2.1e9", "2500"],
        ]);
        let at = |stress: f64, velocity: &Rational| {
            let [lower, upper] = [region.lower(), region.upper()]
                .map(|end| end.slider.at(Rational::from_f64(stress).unwrap(), velocity.clone()));
            let found =
                over_box(&ParameterBox::new(lower, upper).unwrap(), &InertialThreshold::default()).unwrap();
            [found.boundary_signs, found.transition_signs]
        };
        let velocities = velocities((1e-7, 1e-1), 7);
        for (which, band) in bands(&region, &velocities).iter().enumerate() {
            let mut met = 0;
            for (velocity, ranges) in &band.columns {
                for [low, high] in ranges.iter().map(|range| range.enclosure) {
                    met += 1;
                    for outside in
                        [low * (1.0 - 1e-9), high * (1.0 + 1e-9)].into_iter().filter(|end| *end > 0.0)
                    {
                        let [least, greatest] = at(outside, velocity)[which];
                        assert_eq!(least, greatest, "{:?} {} {outside}", band.of, nearest_f64(velocity));
                    }
                    let [least, greatest] = at((low.max(1e-3 * high) * high).sqrt(), velocity)[which];
                    assert!(least < greatest, "{:?} {} {low} {high}", band.of, nearest_f64(velocity));
                }
            }
            assert!(met > 5, "{:?}", band.of);
        }
    }

    #[test]
    fn a_band_that_parts_has_an_area_for_each_branch() {
        let range = |low, high| SolutionRange { enclosure: [low, high], certain: None };
        let column = |velocity: u32, ranges: Vec<SolutionRange>| (Rational::from(velocity), ranges);
        let columns = vec![
            column(1, vec![range(1.0, 2.0), range(9.0, 16.0)]),
            column(2, vec![range(1.0, 2.0), range(9.0, f64::INFINITY)]),
            column(4, vec![range(1.0, 16.0)]),
            column(8, vec![]),
        ];
        let y = Axis::log10("y", "", 1.0, 10.0);
        let found = outlines(&Band { of: BandOf::Boundary, columns }, &y);
        let far = 10.0 * BEYOND;
        let expected = [
            vec![(2.0, 1.0), (4.0, 1.0), (4.0, 16.0), (2.0, 2.0)],
            vec![(2.0, 9.0), (4.0, 1.0), (4.0, 16.0), (2.0, far)],
            vec![(1.0, 1.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0)],
            vec![(1.0, 9.0), (2.0, 9.0), (2.0, far), (1.0, 16.0)],
        ];
        assert_eq!(found.len(), expected.len(), "{found:?}");
        assert!(expected.iter().all(|outline| found.contains(outline)), "{found:?}");
    }
}
