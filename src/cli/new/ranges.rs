//! The part of the (V, σ) plane that a slider's report shows: all corners of its boundary, in whole decades, or the range around its
//! operating point.

use slipmode_core::friction::{OperatingPoint, Slider};
use slipmode_core::number::format::{Side, round_digits, rounded};
use slipmode_core::number::{Ball, Rational, nearest_f64, parse_decimal};
use slipmode_core::stability::{Arc, asymptote};

/// Two powers of ten.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decades {
    /// The exponent of the lower end.
    pub from: f64,
    /// The exponent of the upper end, greater than `from`.
    pub to: f64,
}

impl Decades {
    /// The two ends.
    pub fn ends(self) -> (f64, f64) {
        (libm::exp10(self.from), libm::exp10(self.to))
    }

    /// The two ends as decimals: powers of ten, or two digits, rounded outward.
    pub fn decimals(self) -> [String; 2] {
        [(self.from, Side::Below), (self.to, Side::Above)].map(|(exponent, side)| {
            let is_whole = exponent == exponent.round();
            if is_whole { format!("1e{exponent}") } else { rounded(libm::exp10(exponent), 2, side) }
        })
    }

    /// From a value to another one, with half a decade on either side.
    fn around([low, high]: [&Rational; 2]) -> Self {
        let [low, high] = [low, high].map(|value| libm::log10(nearest_f64(value)));
        Self { from: low - ROOM, to: high + ROOM }
    }

    fn meets(self, other: Self) -> bool {
        self.from <= other.to && other.from <= self.to
    }

    /// The shortest range that contains both.
    fn with(self, other: Self) -> Self {
        Self { from: self.from.min(other.from), to: self.to.max(other.to) }
    }
}

/// Three ascending values of one quantity in SI: the ends of the operating range, and the operating point.
pub type OwnRange = [Rational; 3];

/// Decades of normal stress and of loading velocity on either side of an operating point, where no range is given.
pub const USUAL: [f64; 2] = [0.5, 1.0];

/// The range of so many decades on either side of a value, its ends with two digits.
pub fn usual(value: &Rational, decades: f64) -> OwnRange {
    let end = |exponent: f64| {
        let end = round_digits(nearest_f64(value) * libm::exp10(exponent), 2);
        parse_decimal(&end).unwrap_or_else(|_| value.clone())
    };
    [end(-decades), value.clone(), end(decades)]
}

/// The axes of the maps and of the grid of simulations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ranges {
    /// Loading velocities of the maps, m/s.
    pub velocity: Decades,
    /// Normal stresses of the maps, Pa.
    pub stress: Decades,
    /// Loading velocities of the simulations, m/s: a decade less at the slow end.
    pub simulated_velocity: Decades,
    /// Normal stresses of the simulations, Pa: a decade less at either end.
    pub simulated_stress: Decades,
    /// Points by which each axis of the simulations was made shorter.
    pub points_less: i32,
}

/// Decades of the loading velocities of most laboratories, m/s: 1 um/s to 1 mm/s.
const LABORATORY: Decades = Decades { from: -6.0, to: -3.0 };

/// Decades beyond which coordinates are refused: the limits of a scene with room for the widest map.
const FARTHEST: f64 = 250.0;

/// Decades between an operating point and the edge of a map that shows all corners, at least.
const LEAST_ROOM: f64 = 0.25;

/// Decades between an operating range and the edge of a map.
const ROOM: f64 = 0.5;

/// Decades above the lower corner that are shown when there is no upper one.
const WITHOUT_UPPER_CORNER: f64 = 2.0;

/// Points of a simulated axis at most.
const MOST_SIMULATED: i32 = 13;

/// Points that an axis of the simulations may lose at most; the shortest has seven.
const MOST_POINTS_LESS: i32 = 3;

/// Working precision of the corners, in bits.
const WORKING_BITS: u32 = 96;

impl Ranges {
    /// From two decades (V) or one (σ) below the lower corner of the asymptotes to one above the upper corner.
    ///
    /// σ_c and V_c lie between the two corners: σ_c is the geometric mean of their normal stresses.
    pub fn around(parameters: &Slider<Rational>) -> Result<Self, String> {
        let (low_stress, low_velocity) = corner(parameters, Arc::Lower)?;
        let has_upper = parameters.direct_effect != parameters.evolution_effect;
        let (high_stress, high_velocity) = if has_upper {
            corner(parameters, Arc::Upper)?
        } else {
            (low_stress + WITHOUT_UPPER_CORNER, low_velocity + WITHOUT_UPPER_CORNER)
        };
        let (low_velocity, high_velocity) = (low_velocity.floor(), high_velocity.ceil());
        let (low_stress, high_stress) = (low_stress.floor(), high_stress.ceil());
        let velocity = Decades { from: low_velocity - 2.0, to: high_velocity + 1.0 };
        Ok(Self {
            velocity: if velocity.meets(LABORATORY) { velocity.with(LABORATORY) } else { velocity },
            stress: Decades { from: low_stress - 1.0, to: high_stress + 1.0 },
            simulated_velocity: Decades { from: low_velocity - 1.0, to: high_velocity + 1.0 },
            simulated_stress: Decades { from: low_stress, to: high_stress },
            points_less: 0,
        })
    }

    /// The same with axes of the maps that also show an operating point, with room around it.
    pub fn showing(mut self, point: Option<&OperatingPoint<Rational>>) -> Self {
        let Some(point) = point else { return self };
        let around = |value: &Rational| {
            let decade = libm::log10(nearest_f64(value));
            Decades { from: (decade - LEAST_ROOM).floor(), to: (decade + LEAST_ROOM).ceil() }
        };
        self.velocity = self.velocity.with(around(&point.loading_velocity_m_per_s));
        self.stress = self.stress.with(around(&point.normal_stress_pa));
        self
    }

    /// The axes that show an operating range, for the maps and for the simulations.
    pub fn of_laboratory([[low_stress, _, high_stress], [slow, _, fast]]: &[OwnRange; 2]) -> Self {
        let stress = Decades::around([low_stress, high_stress]);
        let velocity = Decades::around([slow, fast]);
        Self { velocity, stress, simulated_velocity: velocity, simulated_stress: stress, points_less: 0 }
    }

    /// Takes a point from each simulated axis; false when enough were taken.
    pub fn coarsen(&mut self) -> bool {
        let more = self.points_less < MOST_POINTS_LESS;
        self.points_less += i32::from(more);
        more
    }

    /// Points of the simulated axes, along V and along σ: three a decade where that is no more than a modest grid.
    pub fn simulated_points(&self) -> (i32, i32) {
        let points = |axis: Decades| {
            (whole((3.0 * (axis.to - axis.from)).round()) + 1).min(MOST_SIMULATED) - self.points_less
        };
        (points(self.simulated_velocity), points(self.simulated_stress))
    }
}

/// log10 of σ and V0 where the two asymptotes of an arc cross.
fn corner(slider: &Slider<Rational>, arc: Arc) -> Result<(f64, f64), String> {
    let slider = slider.map(|value| Ball::from_rational(value, WORKING_BITS));
    let corner = asymptote::corner(arc, &slider);
    let decades =
        [corner.normal_stress_pa, corner.loading_velocity_m_per_s].map(|value| libm::log10(value.to_f64()));
    let [stress, velocity] = decades;
    if decades.iter().all(|decade| decade.abs() <= FARTHEST) {
        return Ok((stress, velocity));
    }
    Err("the boundary of this slider lies beyond 1e-250 to 1e250 m/s or Pa: no map can show it".into())
}

/// An exponent whose size was checked.
#[expect(clippy::cast_possible_truncation, reason = "within the decades that were checked")]
fn whole(exponent: f64) -> i32 {
    exponent as i32
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::number::parse_decimal;

    fn slider(a: &str, b: &str, stiffness: &str) -> Slider<Rational> {
        Slider::from([a, b, "1e-5", stiffness, "1000"].map(|text| parse_decimal(text).unwrap()))
    }

    #[test]
    fn the_papers_slider_is_shown_where_the_paper_shows_it() {
        let ranges = Ranges::around(&slider("0.004", "0.006", "1e7")).unwrap();
        assert_eq!(ranges.velocity, Decades { from: -6.0, to: -1.0 });
        assert_eq!(ranges.stress, Decades { from: 2.0, to: 7.0 });
        assert_eq!(ranges.simulated_points(), (13, 10));
    }

    #[test]
    fn equal_effects_have_no_upper_corner_and_near_ones_a_far_one() {
        let equal = Ranges::around(&slider("0.005", "0.005", "1e7")).unwrap();
        assert_eq!(equal.stress, Decades { from: 2.0, to: 7.0 });
        let near = Ranges::around(&slider("0.005", "0.0050000001", "1e7")).unwrap();
        assert!(near.stress.to > 15.0 && near.simulated_points().1 == MOST_SIMULATED);
    }

    #[test]
    fn maps_show_the_operating_point() {
        let ranges = Ranges::around(&slider("0.004", "0.006", "1e7")).unwrap();
        let point = |stress: &str, velocity: &str| {
            let [normal_stress_pa, loading_velocity_m_per_s] =
                [stress, velocity].map(|text| parse_decimal(text).unwrap());
            OperatingPoint { normal_stress_pa, loading_velocity_m_per_s }
        };
        assert_eq!(ranges.showing(Some(&point("1e5", "1e-3"))), ranges);
        let far = ranges.showing(Some(&point("5e9", "1e-7")));
        assert_eq!(far.velocity, Decades { from: -8.0, to: -1.0 });
        assert_eq!(far.stress, Decades { from: 2.0, to: 10.0 });
        assert_eq!(far.simulated_points(), ranges.simulated_points());
    }

    #[test]
    fn maps_show_the_operating_range_and_usual_velocities() {
        let [stress, velocity] = [("5e6", USUAL[0]), ("1e-5", USUAL[1])]
            .map(|(value, decades)| usual(&parse_decimal(value).unwrap(), decades));
        assert_eq!([&stress[0], &stress[2]].map(nearest_f64), [1.6e6, 1.6e7]);
        let ranges = Ranges::of_laboratory(&[stress, velocity]);
        assert_eq!(ranges.stress.decimals(), ["500000", "5.1e7"]);
        assert_eq!(ranges.velocity.decimals(), ["3.1e-7", "0.00032"]);
        assert_eq!(ranges.simulated_points(), (10, 7));
        // A slider whose corners lie at 1 cm/s and faster, and one far from any laboratory.
        let fast = Ranges::around(&slider("0.004", "0.006", "1e13")).unwrap();
        assert_eq!((fast.velocity.from, fast.velocity.to), (-6.0, 2.0));
        assert!(Ranges::around(&slider("0.004", "0.006", "1e25")).unwrap().velocity.from > 0.0);
    }

    #[test]
    fn a_plane_that_no_map_can_show_is_refused() {
        assert!(Ranges::around(&slider("0.004", "0.006", "1e300")).is_err());
    }
}
