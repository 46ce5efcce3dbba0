//! A slider and its relatives: b, K and M multiplied by stated factors, with the boundary of each b and the slip mode of
//! named points for every combination.
//!
//! For a given β the boundary and the transition are curves of the groups η and κ alone, and so move on the logarithmic
//! (V, σ) plane without changing their shape when K or M changes: σ in proportion to K, V in proportion to √(K/M).
//! The curves are therefore computed once for each b, and moved.

use crate::parallel;
use slipmode_core::friction::{OperatingPoint, Parameters, Slider};

use crate::experiments::boundary::END_ERROR;
use slipmode_core::number::{Rational, Wide, parse_decimal};
use slipmode_core::stability::boundary::{BoundaryCurve, BoundaryPoint};
use slipmode_core::stability::{InertialThreshold, ParameterBox, SlipMode, classify, over_box};

/// Factors of b: closer where β passes 1 for common sliders.
const EVOLUTION_EFFECT_FACTORS: [&str; 19] = [
    "0.01", "0.02", "0.05", "0.1", "0.2", "0.5", "0.6", "0.7", "0.8", "0.9", "1", "1.2", "1.5", "2", "5",
    "10", "20", "50", "100",
];

/// Factors of K and of M.
const OTHER_FACTORS: [&str; 13] =
    ["0.01", "0.02", "0.05", "0.1", "0.2", "0.5", "1", "2", "5", "10", "20", "50", "100"];

/// Points on each arc of a boundary.
const ARC_POINTS: usize = 160;

/// Digits of a boundary's points: far more than a drawing shows.
const DIGITS: u32 = 20;

/// One of the three parameters that vary, with its factors in ascending order.
#[derive(Debug, Clone)]
pub struct Factors {
    /// The factors, as exact decimals.
    pub texts: &'static [&'static str],
    /// The factors.
    pub values: Vec<Rational>,
    /// The place of the factor 1.
    pub base: usize,
}

impl Factors {
    fn of(texts: &'static [&'static str]) -> Self {
        let values = texts.iter().filter_map(|text| parse_decimal(text).ok()).collect();
        Self { texts, values, base: texts.iter().position(|text| *text == "1").unwrap_or(0) }
    }
}

/// A point of operation that keeps its σ and V0 while the slider changes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedPoint {
    /// What it is called.
    pub name: String,
    /// Its σ and V0.
    pub place: OperatingPoint<Rational>,
    /// Whether σ and V0 have the error bars of the slider's box.
    pub has_error_bars: bool,
}

/// What is known of a point for one combination.
#[derive(Debug, Clone, PartialEq)]
pub struct PointState {
    /// The slip mode, decided exactly.
    pub slip_mode: SlipMode,
    /// The slip modes that are possible within the error bars, decided exactly but for the threshold of the frequency; empty without
    /// error bars.
    pub possible: Vec<SlipMode>,
    /// Largest Im(s), 1/s: relative error at most 1e-14, exactly 0 where all roots are real.
    pub max_imaginary_per_s: Wide,
}

impl PointState {
    /// The slip mode, or all that are possible within the error bars.
    pub(crate) fn mode(&self) -> String {
        match self.possible.as_slice() {
            [] => self.slip_mode.words().into(),
            possible => possible.iter().map(|mode| mode.words()).collect::<Vec<_>>().join(" or "),
        }
    }

    /// Largest Im(s) as a 64-bit number.
    pub(crate) fn imaginary(&self) -> f64 {
        self.max_imaginary_per_s.to_f64().unwrap_or(0.0)
    }
}

/// A slider with its relatives.
#[derive(Debug, Clone)]
pub struct Families {
    /// The slider itself.
    pub parameters: Slider<Rational>,
    /// All values within its error bars, when it has some.
    pub error_bars: Option<ParameterBox>,
    /// Factors of b, K and M.
    pub factors: [Factors; 3],
    /// The boundary for each factor of b, with the slider's own K and M.
    pub boundaries: Vec<Vec<BoundaryPoint>>,
    /// The points.
    pub points: Vec<NamedPoint>,
    /// For each point its states, M varying fastest, b slowest.
    pub states: Vec<Vec<PointState>>,
}

impl Families {
    /// Computes a slider's families.
    pub(crate) fn of(
        parameters: &Slider<Rational>,
        error_bars: Option<&ParameterBox>,
        points: Vec<NamedPoint>,
        threshold: &InertialThreshold,
    ) -> Self {
        let factors = [&EVOLUTION_EFFECT_FACTORS[..], &OTHER_FACTORS, &OTHER_FACTORS].map(Factors::of);
        let mut families = Self {
            parameters: parameters.clone(),
            error_bars: error_bars.cloned(),
            factors,
            boundaries: Vec::new(),
            points,
            states: Vec::new(),
        };
        families.boundaries = parallel::map(&families.effects(), boundary);
        let factors = families.combinations();
        let state = |point| parallel::map(&factors, |factors| families.state(*factors, point, threshold));
        families.states = families.points.iter().map(state).collect();
        families
    }

    /// The slider with each b, and its own K and M.
    pub(crate) fn effects(&self) -> Vec<Slider<Rational>> {
        let one = Rational::from(1);
        self.factors[0].values.iter().map(|effect| scaled(&self.parameters, [effect, &one, &one])).collect()
    }

    /// Every combination, M varying fastest, b slowest.
    pub(crate) fn sliders(&self) -> Vec<Slider<Rational>> {
        self.combinations().into_iter().map(|factors| scaled(&self.parameters, factors)).collect()
    }

    /// The error bars of the slider with each b, and its own K and M: a factor multiplies both ends.
    pub(crate) fn uncertain_effects(&self) -> Vec<ParameterBox> {
        let one = Rational::from(1);
        self.factors[0].values.iter().filter_map(|effect| self.region([effect, &one, &one], None)).collect()
    }

    /// The factors of every combination, M varying fastest, b slowest.
    fn combinations(&self) -> Vec<[&Rational; 3]> {
        let [effects, stiffnesses, masses] = &self.factors;
        let mut combinations = Vec::new();
        for effect in &effects.values {
            for stiffness in &stiffnesses.values {
                combinations.extend(masses.values.iter().map(|mass| [effect, stiffness, mass]));
            }
        }
        combinations
    }

    /// The error bars of a combination, at σ and V0 of a point.
    fn region(&self, factors: [&Rational; 3], point: Option<&NamedPoint>) -> Option<ParameterBox> {
        let own = self.error_bars.as_ref()?;
        let exact = point.filter(|point| !point.has_error_bars);
        let end = |end: Parameters<Rational>| Parameters {
            slider: scaled(&end.slider, factors),
            point: exact.map_or(end.point, |point| point.place.clone()),
        };
        ParameterBox::new(end(own.lower()), end(own.upper()))
    }

    fn state(
        &self,
        factors: [&Rational; 3],
        point: &NamedPoint,
        threshold: &InertialThreshold,
    ) -> PointState {
        let place = Parameters { slider: scaled(&self.parameters, factors), point: point.place.clone() };
        let found = classify(&place, threshold);
        let over = self.region(factors, Some(point)).and_then(|region| over_box(&region, threshold));
        let possible = over.map_or_else(Vec::new, |over| {
            let undecided = over.undecided.iter().map(|(mode, _)| *mode);
            over.slip_modes.iter().map(|possible| possible.what).chain(undecided).collect()
        });
        PointState { slip_mode: found.slip_mode, possible, max_imaginary_per_s: found.max_imaginary_per_s }
    }

    /// The place of a combination among [`Families::sliders`].
    pub(crate) fn place(&self, [effect, stiffness, mass]: [usize; 3]) -> usize {
        let [_, stiffnesses, masses] = &self.factors;
        (effect * stiffnesses.values.len() + stiffness) * masses.values.len() + mass
    }
}

/// A slider with b, K and M multiplied.
fn scaled(own: &Slider<Rational>, [effect, stiffness, mass]: [&Rational; 3]) -> Slider<Rational> {
    Slider {
        evolution_effect: own.evolution_effect.clone() * effect,
        stiffness_pa_per_m: own.stiffness_pa_per_m.clone() * stiffness,
        mass_per_area_kg_per_m2: own.mass_per_area_kg_per_m2.clone() * mass,
        ..own.clone()
    }
}

/// The boundary of one slider.
fn boundary(slider: &Slider<Rational>) -> Vec<BoundaryPoint> {
    BoundaryCurve::new(slider, DIGITS).sample(ARC_POINTS, END_ERROR)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::shared::fixtures::paper;
    use slipmode_core::number::parse_decimal;

    fn families() -> Families {
        let point = NamedPoint {
            name: "A".into(),
            place: ["1e5", "1e-3"].map(|text| parse_decimal(text).unwrap()).into(),
            has_error_bars: false,
        };
        Families::of(&paper(), None, vec![point], &InertialThreshold::default())
    }

    #[test]
    fn modes_within_error_bars_include_that_of_the_middle() {
        let [low, high] = ["0.95", "1.05"].map(|factor| {
            let mut slider = paper();
            slider.evolution_effect *= parse_decimal(factor).unwrap();
            slider.at(parse_decimal("9e4").unwrap(), parse_decimal("1e-3").unwrap())
        });
        let error_bars = ParameterBox::new(low, high).unwrap();
        let point = NamedPoint {
            name: "A".into(),
            place: ["1e5", "1e-3"].map(|text| parse_decimal(text).unwrap()).into(),
            has_error_bars: false,
        };
        let families = Families::of(&paper(), Some(&error_bars), vec![point], &InertialThreshold::default());
        let states = &families.states[0];
        assert!(states.iter().all(|state| state.possible.contains(&state.slip_mode)));
        let certain = states.iter().filter(|state| state.possible.len() == 1).count();
        assert!(certain > states.len() / 2 && certain < states.len(), "{certain}");
        assert_eq!(families.uncertain_effects().len(), families.effects().len());
    }

    #[test]
    fn the_factors_are_exact_ascend_and_hold_one() {
        for factors in &families().factors {
            assert_eq!(factors.values.len(), factors.texts.len());
            assert!(factors.values.is_sorted() && factors.values[factors.base] == 1);
        }
    }

    #[test]
    fn the_combination_of_ones_is_the_slider_itself() {
        let families = families();
        let base = families.place([0, 1, 2].map(|at| families.factors[at].base));
        assert_eq!(families.sliders()[base], families.parameters);
        assert_eq!(families.states[0][base].slip_mode, SlipMode::StickSlip);
        assert_eq!(families.states[0].len(), families.sliders().len());
    }

    #[test]
    fn stiffness_and_mass_move_the_boundary_without_changing_it() {
        let families = families();
        // K twice and M five times: σ doubles, V grows by √(2/5).
        let [two, five] = ["2", "5"].map(|text| parse_decimal(text).unwrap());
        let moved = boundary(&scaled(&families.parameters, [&Rational::from(1), &two, &five]));
        let own = &families.boundaries[families.factors[0].base];
        assert_eq!(moved.len(), own.len());
        let close = |ratio: f64, expected: f64| (ratio / expected - 1.0).abs() < 1e-12;
        for (moved, own) in moved.iter().zip(own) {
            assert_eq!((moved.arc, moved.asymptote), (own.arc, own.asymptote));
            assert!(close(moved.normal_stress_pa.to_f64() / own.normal_stress_pa.to_f64(), 2.0));
            let velocities = moved.loading_velocity_m_per_s.to_f64() / own.loading_velocity_m_per_s.to_f64();
            assert!(close(velocities, 0.4_f64.sqrt()));
        }
    }
}
