//! The part of the (V, σ) plane that a slider's report shows: all corners of its boundary, in whole decades.

use slipmode_core::friction::{OperatingPoint, Slider};
use slipmode_core::number::{Ball, Rational, nearest_f64};
use slipmode_core::stability::{Arc, asymptote};

/// Two powers of ten.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Decades {
    /// The exponent of the lower end.
    pub from: i32,
    /// The exponent of the upper end, greater than `from`.
    pub to: i32,
}

impl Decades {
    /// The two powers.
    pub fn ends(self) -> (f64, f64) {
        (libm::exp10(f64::from(self.from)), libm::exp10(f64::from(self.to)))
    }

    fn meets(self, other: Self) -> bool {
        self.from <= other.to && other.from <= self.to
    }

    /// The shortest range that contains both.
    fn with(self, other: Self) -> Self {
        Self { from: self.from.min(other.from), to: self.to.max(other.to) }
    }
}

/// The axes of the maps and of the grid of simulations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
const LABORATORY: Decades = Decades { from: -6, to: -3 };

/// Decades beyond which coordinates are refused: the limits of a scene with room for the widest map.
const FARTHEST: f64 = 250.0;

/// Decades between an operating point and the edge of a map, at least.
const ROOM: f64 = 0.25;

/// Decades above the lower corner that are shown when there is no upper one.
const WITHOUT_UPPER_CORNER: i32 = 2;

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
            let up = f64::from(WITHOUT_UPPER_CORNER);
            (low_stress + up, low_velocity + up)
        };
        let (low_velocity, high_velocity) = (whole(low_velocity.floor()), whole(high_velocity.ceil()));
        let (low_stress, high_stress) = (whole(low_stress.floor()), whole(high_stress.ceil()));
        let velocity = Decades { from: low_velocity - 2, to: high_velocity + 1 };
        Ok(Self {
            velocity: if velocity.meets(LABORATORY) { velocity.with(LABORATORY) } else { velocity },
            stress: Decades { from: low_stress - 1, to: high_stress + 1 },
            simulated_velocity: Decades { from: low_velocity - 1, to: high_velocity + 1 },
            simulated_stress: Decades { from: low_stress, to: high_stress },
            points_less: 0,
        })
    }

    /// The same with axes of the maps that also show an operating point, with room around it.
    #[must_use]
    pub fn showing(mut self, point: Option<&OperatingPoint<Rational>>) -> Self {
        let Some(point) = point else { return self };
        let around = |value: &Rational| {
            let decade = libm::log10(nearest_f64(value));
            Decades { from: whole((decade - ROOM).floor()), to: whole((decade + ROOM).ceil()) }
        };
        self.velocity = self.velocity.with(around(&point.loading_velocity_m_per_s));
        self.stress = self.stress.with(around(&point.normal_stress_pa));
        self
    }

    /// Takes a point from each simulated axis; false when enough were taken.
    pub fn coarsen(&mut self) -> bool {
        let more = self.points_less < MOST_POINTS_LESS;
        self.points_less += i32::from(more);
        more
    }

    /// Points of the simulated axes, along V and along σ: three a decade where that is no more than a modest grid.
    pub fn simulated_points(&self) -> (i32, i32) {
        let points = |axis: Decades| (3 * (axis.to - axis.from) + 1).min(MOST_SIMULATED) - self.points_less;
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
        assert_eq!(ranges.velocity, Decades { from: -6, to: -1 });
        assert_eq!(ranges.stress, Decades { from: 2, to: 7 });
        assert_eq!(ranges.simulated_points(), (13, 10));
    }

    #[test]
    fn equal_effects_have_no_upper_corner_and_near_ones_a_far_one() {
        let equal = Ranges::around(&slider("0.005", "0.005", "1e7")).unwrap();
        assert_eq!(equal.stress, Decades { from: 2, to: 7 });
        let near = Ranges::around(&slider("0.005", "0.0050000001", "1e7")).unwrap();
        assert!(near.stress.to > 15 && near.simulated_points().1 == MOST_SIMULATED);
    }

    #[test]
    fn maps_show_the_operating_point_and_usual_velocities() {
        let ranges = Ranges::around(&slider("0.004", "0.006", "1e7")).unwrap();
        let point = |stress: &str, velocity: &str| {
            let [normal_stress_pa, loading_velocity_m_per_s] =
                [stress, velocity].map(|text| parse_decimal(text).unwrap());
            OperatingPoint { normal_stress_pa, loading_velocity_m_per_s }
        };
        assert_eq!(ranges.showing(Some(&point("1e5", "1e-3"))), ranges);
        let far = ranges.showing(Some(&point("5e9", "1e-7")));
        assert_eq!((far.velocity, far.stress), (Decades { from: -8, to: -1 }, Decades { from: 2, to: 10 }));
        assert_eq!(far.simulated_points(), ranges.simulated_points());
        // A slider whose corners lie at 1 cm/s and faster, and one far from any laboratory.
        let fast = Ranges::around(&slider("0.004", "0.006", "1e13")).unwrap();
        assert_eq!((fast.velocity.from, fast.velocity.to), (-6, 2));
        assert!(Ranges::around(&slider("0.004", "0.006", "1e25")).unwrap().velocity.from > 0);
    }

    #[test]
    fn a_plane_that_no_map_can_show_is_refused() {
        assert!(Ranges::around(&slider("0.004", "0.006", "1e300")).is_err());
    }
}
