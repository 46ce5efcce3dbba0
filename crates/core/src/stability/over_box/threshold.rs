//! Which modes of a complex pair a box contains: the transition together with the threshold of the frequency.
//!
//! For thresholds T = (ω/ω_n)² ≥ 1/5 the set of pairs above the threshold is up in K, M V0² and down in σ. With time in
//! units of 1/ω_n, c = V0/D_c, and x the real part of a pair at the threshold, u = x² and r = T + u < 1: the derivative of ω²
//! by ln K has the sign of c²u + cxr(1 + u − T) + (1 − T)r³, which is positive when (1 − r)² < 4T(1 − T); that by ln M V0²
//! has the sign of c²(T − T² + u²) + cxr(r² − T + u) + ur³, which is positive when (r² + r − 2T)² < 4r(T + r² − 2rT). Both hold
//! for all r from T to 1 when T ≥ 1/5. Less σ is more K and then more M V0². So no path of growing K or M V0² leaves the set.
//!
//! Of K, M V0² and σ each mode then needs one corner, or, where it needs K, M V0² or σ to be both large and small, a place on
//! K = K_c, and there (ω/ω_n)² = η/(1 + η). The remaining a, b, D_c are subdivided; Bernstein coefficients exclude parts, exact points witness.

use std::cell::OnceCell;
use std::collections::VecDeque;

use rug::{Complete, Integer};

use super::Effort;
use super::coefficient::{Coefficient, Rough};
use super::corners::{A, B, Corner, D, Filtered, K, M, Point, S, V};
use super::polynomials::Lines;
use super::tensor::{AXES, Tensor};
use crate::friction::SlipMode;
use crate::number::{Rational, nearest_f64};

/// The parameters that are subdivided, one an axis.
const SUBDIVIDED: [usize; AXES] = [A, B, D];

/// How many parts of a box are looked at for one mode.
const MOST_PARTS: usize = 1500;

/// How many of them in 64-bit arithmetic, before integers are used.
const MOST_ROUGH_PARTS: usize = 64;

/// The corner of K, M, V0, σ that is farthest above the threshold, and that farthest below.
const ABOVE: Corner = Corner::high(&[K, M, V]);
const BELOW: Corner = Corner::high(&[S]);

/// A point with the mode, or none if no point of the box has it; the largest share of the box in which it could be if this is undecided.
type PointFound = Result<Option<Point>, Rational>;

/// A sign that a polynomial has to have.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Sign {
    Positive,
    NotNegative,
    /// Positive, or zero at single points inside the set.
    Inside,
}

impl Sign {
    /// Whether certainly no value with these Bernstein coefficients has the sign.
    fn is_excluded<T: Coefficient>(self, tensor: &Tensor<T>) -> bool {
        match self {
            Self::Positive => tensor.all(|value| !self.may_hold(value)),
            Self::NotNegative => tensor.all(T::is_negative),
            Self::Inside => {
                tensor.all(|value| value.is_negative() || value.is_zero())
                    && !tensor.all(|value| !value.is_negative())
            }
        }
    }

    /// Whether a value may have the sign, as far as it is known.
    fn may_hold<T: Coefficient>(self, value: &T) -> bool {
        !(value.is_negative() || self == Self::Positive && value.is_zero())
    }
}

/// One way in which a point (a, b, D_c) has a mode for some K, M, V0, σ of the box.
#[derive(Clone)]
struct Way<T> {
    conditions: Vec<(Tensor<T>, Sign)>,
    at: TestedAt,
}

/// Where: at a corner of K, M, V0, σ, or next to K = K_c between an unstable and a stable one.
#[derive(Clone, Copy)]
enum TestedAt {
    Corner(Corner),
    Transition { unstable: Corner, stable: Corner },
}

/// A part of the box, with the ways that are not excluded there.
struct Part<T> {
    lower: [Rational; AXES],
    upper: [Rational; AXES],
    halvings: u32,
    ways: Vec<Way<T>>,
}

/// The search for the modes of one box.
pub(super) struct Search<'a> {
    filtered: &'a Filtered<'a>,
    rough: Frequencies<Rough>,
    exact: Frequencies<Integer>,
    /// The searches, and the halvings of parts that they took.
    pub(super) effort: Effort,
}

/// [`Lines::frequency`] at the corners above and below.
type Frequencies<T> = [OnceCell<Tensor<T>>; 2];

/// Whether a box clearly has no pair above the threshold.
///
/// The real root −q of eq 8 is below −1 and |s|² = ω_n²/q, so that a pair above it has q < 1/T or F(−1/T) < 0:
/// μ + T²KD_c² > TσD_c (a + bT/(1 − T)).
pub(super) fn is_clearly_below(filtered: &Filtered<'_>) -> bool {
    const MARGIN: f64 = 1e-9;
    let t = nearest_f64(filtered.threshold.squared_ratio());
    [ABOVE, ABOVE.flipped(D)].into_iter().all(|corner| {
        let [a, b, d, k, m, s, v] = filtered.rounded(corner).map(|value| value.hi());
        let terms = [m * v * v, t * t * k * d * d, t * s * d * a, t * s * d * b * t / (1.0 - t)];
        let normal = terms.iter().all(|term| *term > 1e-250 && *term < 1e250);
        normal && terms[0] + terms[1] < (1.0 - MARGIN) * (terms[2] + terms[3])
    })
}

impl<'a> Search<'a> {
    pub(super) fn new(filtered: &'a Filtered<'a>) -> Self {
        Self {
            filtered,
            rough: Frequencies::default(),
            exact: Frequencies::default(),
            effort: Effort::default(),
        }
    }

    /// Searches the box for a mode of a complex pair, or for a stick-slip. 64-bit bounds exclude most of what can be excluded.
    pub(super) fn run(&mut self, mode: SlipMode) -> PointFound {
        self.effort.searches += 1;
        let ways = self.ways(mode, &self.rough);
        self.search(mode, ways, MOST_ROUGH_PARTS).or_else(|_| {
            let ways = self.ways(mode, &self.exact);
            self.search(mode, ways, MOST_PARTS)
        })
    }

    fn search<T: Coefficient>(&mut self, mode: SlipMode, ways: Vec<Way<T>>, most_parts: usize) -> PointFound {
        let region = self.filtered.region;
        let axes: Vec<usize> = (0..AXES).filter(|axis| region.is_wide(SUBDIVIDED[*axis])).collect();
        let whole = Part {
            lower: SUBDIVIDED.map(|i| region.lower[i].clone()),
            upper: SUBDIVIDED.map(|i| region.upper[i].clone()),
            halvings: 0,
            ways,
        };
        let mut parts = VecDeque::from([whole]);
        // A point on K = K_c has a mode, but grows as little as it decays: another witness is better.
        let mut neutral = None;
        for _ in 0..most_parts {
            let Some(mut part) = parts.pop_front() else { break };
            part.ways.retain(|way| !way.conditions.iter().any(|(tensor, sign)| sign.is_excluded(tensor)));
            if part.ways.is_empty() {
                continue;
            }
            if let Some(point) = part.witness(self.filtered, mode) {
                if self.filtered.at(&point).transition != 0 {
                    return Ok(Some(point));
                }
                neutral = Some(point);
            }
            if let Some(axis) = axes.get(part.halvings as usize % axes.len().max(1)) {
                parts.extend(part.halves(*axis));
                self.effort.halvings += 1;
            }
        }
        let share =
            parts.iter().fold(Rational::new(), |sum, part| sum + (Rational::from(1) >> part.halvings));
        match neutral {
            None if share > 0 => Err(share),
            found => Ok(found),
        }
    }

    /// The parameters that are subdivided run over the box, the others are those of the corner.
    fn lines<T: Coefficient>(&self, corner: Corner) -> Lines<T> {
        let running: Vec<(usize, usize)> = SUBDIVIDED.into_iter().zip(0..).collect();
        let subdivided = Corner::high(&SUBDIVIDED);
        Lines::between(self.filtered, [corner.without(subdivided), corner.with(subdivided)], &running)
    }

    /// All ways to a mode.
    fn ways<T: Coefficient>(&self, mode: SlipMode, frequencies: &Frequencies<T>) -> Vec<Way<T>> {
        use Sign::{Inside, NotNegative, Positive};
        let is_above = matches!(mode, SlipMode::HarmonicVibration | SlipMode::InertialUnderdampedOscillation);
        let is_stable = !matches!(mode, SlipMode::HarmonicVibration | SlipMode::StickSlip);
        let corner = if is_above { ABOVE } else { BELOW };
        let threshold = self.filtered.threshold;
        let lines = |corner: Corner| self.lines::<T>(corner);
        // Below the threshold is the opposite sign, and zero counts.
        let side = |above: Tensor<T>, sign: Sign| {
            if is_above {
                (above.into_bernstein(), sign)
            } else {
                (negated(above.into_bernstein()), NotNegative)
            }
        };
        let stable = |corner: Corner| (lines(corner).transition().into_bernstein(), NotNegative);
        let unstable = |corner: Corner| (negated(lines(corner).transition().into_bernstein()), Positive);
        let of_transition = if is_stable { stable(corner) } else { unstable(corner) };
        let frequency = frequencies[usize::from(is_above)]
            .get_or_init(|| lines(corner).frequency(threshold).into_bernstein())
            .clone();
        let frequency = if is_above { (negated(frequency), Inside) } else { (frequency, NotNegative) };
        let mut ways = vec![Way { conditions: vec![of_transition, frequency], at: TestedAt::Corner(corner) }];
        // On K = K_c the side of the threshold has three forms: without K, without M V0² and without σ. A form decides where
        // what it leaves out is what reaches K = K_c; the other two are necessary there.
        let forms = [
            lines(corner).inertial_at_transition(threshold),
            lines(corner).inertial_by_stress(threshold),
            lines(corner.flipped(K)).inertial_by_stiffness(threshold),
        ]
        .map(|form| side(form, Positive));
        let mut crossing = |unstable_at: Corner, stable_at: Corner| {
            let mut conditions = vec![unstable(unstable_at), stable(stable_at)];
            conditions.extend(forms.iter().cloned());
            ways.push(Way {
                conditions,
                at: TestedAt::Transition { unstable: unstable_at, stable: stable_at },
            });
        };
        let end = |corner: Corner, parameters: &[usize], high: bool| {
            let moved: fn(Corner, Corner) -> Corner = if high { Corner::with } else { Corner::without };
            moved(corner, Corner::high(parameters))
        };
        if is_above == is_stable {
            // M V0² has to be large for one sign and small for the other.
            crossing(end(corner, &[M, V], true), end(corner, &[M, V], false));
        } else {
            // So have K and σ. Of the points of K = K_c the one with the most favourable σ counts: σ at its end, or K at its end.
            crossing(end(corner, &[K], false), end(corner, &[K], true));
            let stiff = end(corner, &[K], !is_above);
            crossing(end(stiff, &[S], true), end(stiff, &[S], false));
        }
        ways
    }
}

impl<T: Coefficient> Part<T> {
    /// A point at a corner of the part, at which all conditions of a way hold.
    fn witness(&self, filtered: &Filtered<'_>, mode: SlipMode) -> Option<Point> {
        let corners = (0..1 << AXES).map(|bits| std::array::from_fn(|axis| bits >> axis & 1 == 1));
        for (way, corner) in self.ways.iter().flat_map(|way| corners.clone().map(move |corner| (way, corner)))
        {
            let holds = |(tensor, sign): &(Tensor<T>, Sign)| sign.may_hold(tensor.at_corner(corner));
            if !way.conditions.iter().all(holds) {
                continue;
            }
            let with_effects = |corner_of_rest: Corner| {
                let mut point = filtered.region.corner(corner_of_rest);
                for (axis, i) in SUBDIVIDED.into_iter().enumerate() {
                    let end = if corner[axis] { &self.upper } else { &self.lower };
                    point[i].clone_from(&end[axis]);
                }
                point
            };
            let has_mode = |point: &Point| filtered.mode(point) == mode;
            let found = match way.at {
                TestedAt::Corner(corner) => Some(with_effects(corner)).filter(has_mode),
                TestedAt::Transition { unstable, stable } => {
                    let ends = [with_effects(unstable), with_effects(stable)];
                    filtered.between(ends, |state| state.transition < 0, |point, _| has_mode(point))
                }
            };
            if found.is_some() {
                return found;
            }
        }
        None
    }

    fn halves(self, axis: usize) -> [Self; 2] {
        let middle = (&self.lower[axis] + &self.upper[axis]).complete() / 2u32;
        let half = |upper_half: bool| {
            let halved = |(tensor, sign): &(Tensor<T>, Sign)| {
                let [low, high] = tensor.halves(axis);
                (if upper_half { high } else { low }, *sign)
            };
            let conditions = |way: &Way<T>| way.conditions.iter().map(halved).collect();
            let ways = self.ways.iter().map(|way| Way { conditions: conditions(way), at: way.at }).collect();
            let (mut lower, mut upper) = (self.lower.clone(), self.upper.clone());
            let end = if upper_half { &mut lower } else { &mut upper };
            end[axis].clone_from(&middle);
            Self { lower, upper, halvings: self.halvings + 1, ways }
        };
        [half(false), half(true)]
    }
}

fn negated<T: Coefficient>(tensor: Tensor<T>) -> Tensor<T> {
    tensor.scaled(&Integer::from(-1))
}
