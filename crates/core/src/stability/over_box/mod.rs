//! The classification of all points of a box of parameters: what is certain, and what is possible at which point.
//!
//! ```
//! use slipmode_core::stability::{ParameterBox, over_box};
//! use slipmode_core::{stability::InertialThreshold, friction::{Parameters, SlipMode}, number::parse_decimal};
//!
//! // b = 0.006 ± 0.001; the other six values are certain.
//! let point = |b: &str| {
//!     Parameters::from(["0.004", b, "1e-5", "1e7", "1000", "1e6", "1e-5"].map(|text| parse_decimal(text).unwrap()))
//! };
//! let uncertain = ParameterBox::new(point("0.005"), point("0.007")).unwrap();
//! let found = over_box(&uncertain, &InertialThreshold::default()).unwrap();
//! assert_eq!(found.certain_mode(), Some(SlipMode::StickSlip));
//! ```

mod classes;
mod coefficient;
mod corners;
mod extreme_point;
#[cfg(test)]
mod fixtures;
mod lower_area;
mod pair_conditions;
mod pair_point;
mod pair_search;
mod polynomials;
mod ranges;
mod ranked;
mod root_discs;
mod shares;
mod summit;
mod tensor;
#[cfg(test)]
mod tests;
mod threshold;

pub use crate::friction::ParameterBox;
pub(super) use pair_search::Sought;
pub use ranges::{Ranges, ValueRange, ranges_over_box};
pub(super) use ranges::{Scaled, sought_in};
pub(super) use root_discs::{RootPart, Values};
pub use shares::{Distribution, SampledShare, sampled_shares};

use std::cell::LazyCell;
use std::rc::Rc;

use super::{InertialThreshold, SlipMode, SpectralClass};
use crate::friction::Parameters;
use crate::number::Rational;
use classes::Classes;
use corners::{A, B, Corner, D, Filtered, M, Point, S, State, V};
use threshold::Search;

/// Something that points of a box have, with such a point.
#[derive(Debug, Clone, PartialEq)]
pub struct Possible<T> {
    /// What the points have.
    pub what: T,
    /// A point of the box that has it, exactly; none where such points need not have rational coordinates.
    pub witness: Option<Parameters<Rational>>,
}

/// All that the points of a box have in common, or not.
#[derive(Debug, Clone, PartialEq)]
pub struct OverBox {
    /// The least and the greatest sign of K − K_c.
    pub transition_signs: [i8; 2],
    /// An enclosure of the signs of the discriminant. The least one is attained; the greatest one is 1 also where an area of
    /// real roots is met on its boundary alone.
    pub boundary_signs: [i8; 2],
    /// The spectral classes of the box's points: exactly these.
    pub spectral_classes: Vec<Possible<SpectralClass>>,
    /// The slip modes that points of the box have, in the order of [`SlipMode::ALL`].
    pub slip_modes: Vec<Possible<SlipMode>>,
    /// Slip modes that are neither found nor excluded, and the largest share of the box that could have them.
    pub undecided: Vec<(SlipMode, Rational)>,
    /// What the decision took.
    pub effort: Effort,
    /// The least and the greatest K_c (eq 9), Pa/m.
    pub critical_stiffness_pa_per_m: [Rational; 2],
}

/// What a decision took beyond the states of corners; all are 0 when corners decided.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Effort {
    /// Edges of the box along which the signs of polynomials were decided.
    pub edges: usize,
    /// Slip modes for which the threshold of the frequency was decided over the box.
    pub searches: usize,
    /// Parts of the box that were halved for it.
    pub halvings: usize,
}

impl OverBox {
    /// The slip mode that all points have; none when several are possible or one is undecided.
    #[must_use]
    pub fn certain_mode(&self) -> Option<SlipMode> {
        match self.slip_modes.as_slice() {
            [only] if self.undecided.is_empty() => Some(only.what),
            _ => None,
        }
    }

    /// The largest share of the box in which a further slip mode could be; 0 when all is decided.
    #[must_use]
    pub fn undecided_share(&self) -> Rational {
        let shares = self.undecided.iter().map(|(_, share)| share);
        shares.fold(Rational::new(), |sum, share| sum + share).min(Rational::from(1))
    }
}

/// The lowest (ω/ω_n)² of a threshold over a box: above it the threshold is crossed in one direction only
/// with each of K, M, σ and V0.
#[must_use]
pub fn is_allowed_over_box(threshold: &InertialThreshold) -> bool {
    Rational::from(threshold.squared_ratio() * 5u32) >= 1
}

/// Decides which classes and slip modes the points of a box have. Nothing is rounded and no point is left out.
///
/// None for a threshold (ω/ω_n)² below 1/5.
#[must_use]
pub fn over_box(region: &ParameterBox, threshold: &InertialThreshold) -> Option<OverBox> {
    if !is_allowed_over_box(threshold) {
        return None;
    }
    let filtered = Filtered::new(region, threshold);
    let classes = Classes::of(&filtered);
    let mut search = Search::new(&filtered);
    let (slip_modes, undecided) = modes(&filtered, &classes, &mut search);
    Some(OverBox {
        transition_signs: classes.transition,
        boundary_signs: classes.boundary,
        spectral_classes: spectral_classes(classes),
        slip_modes,
        undecided,
        effort: Effort { edges: filtered.edges.get(), ..search.effort },
        critical_stiffness_pa_per_m: extremes_of_critical_stiffness(region).map(|at| at.critical_stiffness()),
    })
}

/// Whether a point of the box is on K = K_c.
pub(super) fn transition_sought(region: &ParameterBox) -> Sought {
    let threshold = InertialThreshold::default();
    zero_sought(Classes::transition_signs(&Filtered::new(region, &threshold)))
}

/// Whether a quantity vanishes somewhere, from its least and its greatest sign.
const fn zero_sought(signs: [i8; 2]) -> Sought {
    if let [-1, -1] | [1, 1] = signs { Sought::Nowhere } else { Sought::Somewhere }
}

/// The least and the greatest sign of the distance from the boundary, exactly.
fn boundary_signs(region: &ParameterBox) -> [i8; 2] {
    Classes::of(&Filtered::new(region, &InertialThreshold::default())).boundary
}

/// Whether a point of the box has a double root.
pub(super) fn boundary_sought(region: &ParameterBox) -> Sought {
    zero_sought(boundary_signs(region))
}

/// Whether a point of the box has a pair at this ω/ω_n; unknown for a threshold that is not allowed over a box.
///
/// A box that the line touches from below at single points, with no point above it, counts as one without.
pub(super) fn threshold_sought(region: &ParameterBox, threshold: &InertialThreshold) -> Sought {
    let Some(found) = over_box(region, threshold) else { return Sought::Unknown };
    let is_above = |mode: SlipMode| {
        matches!(mode, SlipMode::InertialUnderdampedOscillation | SlipMode::HarmonicVibration)
    };
    let count = |above: bool| found.slip_modes.iter().filter(|mode| is_above(mode.what) == above).count();
    let is_open = |above: bool| found.undecided.iter().any(|(mode, _)| is_above(*mode) == above);
    match [true, false].map(|above| (count(above) > 0, is_open(above))) {
        [(true, _), (true, _)] => Sought::Somewhere,
        [(false, false), _] | [_, (false, false)] => Sought::Nowhere,
        _ => Sought::Unknown,
    }
}

/// Finds a point; none where the points that there are need not be rational.
type Find<'a> = Box<dyn FnOnce() -> Option<Point> + 'a>;

/// Whether a box meets a set, and where: the point is found when it is asked for.
#[derive(Clone)]
struct Met<'a>(Option<Rc<LazyCell<Option<Point>, Find<'a>>>>);

impl<'a> Met<'a> {
    const NOWHERE: Self = Self(None);

    fn found_by(find: impl FnOnce() -> Option<Point> + 'a) -> Self {
        Self(Some(Rc::new(LazyCell::new(Box::new(find)))))
    }

    fn at_corner(filtered: &'a Filtered<'_>, corner: Corner) -> Self {
        Self::found_by(move || Some(filtered.region.corner(corner)))
    }

    fn is_somewhere(&self) -> bool {
        self.0.is_some()
    }

    fn point(&self) -> Option<&Point> {
        LazyCell::force(self.0.as_ref()?).as_ref()
    }

    fn possible<T>(&self, what: T) -> Option<Possible<T>> {
        let witness = self.point().map(|point| Parameters::from(point.clone()));
        self.is_somewhere().then_some(Possible { what, witness })
    }
}

fn spectral_classes(classes: Classes<'_>) -> Vec<Possible<SpectralClass>> {
    let stable_real = if classes.lower.point().is_some() || !classes.upper.is_somewhere() {
        classes.lower
    } else {
        classes.upper
    };
    let all = [
        (stable_real, SpectralClass::StableReal),
        (classes.stable_complex, SpectralClass::StableComplex),
        (classes.unstable_real, SpectralClass::UnstableReal),
        (classes.unstable_complex, SpectralClass::UnstableComplex),
        (classes.neutral, SpectralClass::Neutral),
    ];
    all.into_iter().filter_map(|(met, class)| met.possible(class)).collect()
}

/// The possible slip modes, and those left undecided.
fn modes(
    filtered: &Filtered<'_>,
    classes: &Classes<'_>,
    search: &mut Search<'_>,
) -> (Vec<Possible<SlipMode>>, Vec<(SlipMode, Rational)>) {
    let complex = [&classes.unstable_complex, &classes.stable_complex, &classes.neutral];
    let known = complex[..2].iter().filter_map(|met| met.point()).map(|point| (filtered.mode(point), point));
    let known: Vec<(SlipMode, &Point)> = known.collect();
    let is_below = threshold::is_clearly_below(filtered);
    let mut found = |mode: SlipMode| match mode {
        SlipMode::OverdampedStableSliding => Ok(classes.lower.possible(mode)),
        SlipMode::OverdampedOscillation => Ok(classes.upper.possible(mode)),
        SlipMode::StickSlip if classes.unstable_real.is_somewhere() => {
            Ok(classes.unstable_real.possible(mode))
        }
        of_a_pair => {
            let unstable = matches!(of_a_pair, SlipMode::StickSlip | SlipMode::HarmonicVibration);
            let above =
                matches!(of_a_pair, SlipMode::InertialUnderdampedOscillation | SlipMode::HarmonicVibration);
            let exists = !(above && is_below)
                && complex.iter().enumerate().any(|(i, met)| (i == 0) == unstable && met.is_somewhere());
            let point = known.iter().find(|(mode, _)| *mode == of_a_pair).map(|(_, point)| (*point).clone());
            let at = |point| Possible { what: mode, witness: Some(Parameters::from(point)) };
            match point.or_else(|| beside_real_roots(filtered, classes, of_a_pair)) {
                Some(point) => Ok(Some(at(point))),
                None if !exists => Ok(None),
                None => search.run(of_a_pair).map(|found| found.map(at)),
            }
        }
    };
    let (mut possible, mut undecided) = (Vec::new(), Vec::new());
    for mode in SlipMode::ALL {
        match found(mode) {
            Ok(found) => possible.extend(found),
            Err(share) => undecided.push((mode, share)),
        }
    }
    (possible, undecided)
}

/// A slow stable oscillation next to an area of stable real roots, when the box has points in and outside of that area.
fn beside_real_roots(filtered: &Filtered<'_>, classes: &Classes<'_>, mode: SlipMode) -> Option<Point> {
    let wanted = SlipMode::NonInertialUnderdampedOscillation;
    let real = classes.lower.point().or(classes.upper.point()).filter(|_| mode == wanted)?;
    let ends = [real.clone(), classes.stable_complex.point()?.clone()];
    let area = filtered.at(real).real_mode;
    let is_wanted = |point: &Point, state: State| state.real_mode.is_none() && filtered.mode(point) == wanted;
    filtered.between(ends, |state| state.real_mode == area, is_wanted)
}

/// The corners of a box at which K_c is least and greatest: K_c = (b − a)(σ/D_c + M V0²/(a D_c²)) is up in b and down in a;
/// where it is positive, it is up in σ, M, V0 and down in D_c. K plays no part.
#[must_use]
pub fn extremes_of_critical_stiffness(region: &ParameterBox) -> [Parameters<Rational>; 2] {
    [(Corner::high(&[A]), false), (Corner::high(&[B]), true)].map(|(effects, is_largest)| {
        let is_positive = region.end(B, effects) > region.end(A, effects);
        let rest = if is_positive == is_largest { Corner::high(&[S, M, V]) } else { Corner::high(&[D]) };
        Parameters::from(region.corner(effects.with(rest)))
    })
}
