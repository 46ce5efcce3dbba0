//! Which double roots a line of given σ or V0 has on the boundary, and the unknown group at each.
//!
//! A certain root of F is on its arc, and is the only one of its branch, by Descartes' rule of signs:
//!
//! * upper arc, b > a: F has one positive root at which it rises. Between r = 0 and the arc's end √β − 1 it has opposite signs.
//! * upper arc, b < a: F has one root between −1 and 0.
//! * lower arc: F has at most two positive roots. It falls at the one before the cusp and rises at the one beyond.
//!
//! Where the quantity that decides whether a branch has a root is too close to zero, or 64-bit numbers cannot follow,
//! there is no answer, and the caller takes the general way of `exactly`.

use std::cmp::Ordering;

use super::GivenGroup;
use super::enclosure::{Enclosure, Loss};
use super::equation::coefficients;
use super::start::{Start, root_between, values};
use super::unknown::unknown;
use super::work::Work;
use crate::number::{Ball, Dd, Field};
use crate::stability::Arc;
use slipmode_algebra::horner;

/// Bits of the unknown beyond those requested: what its evaluation and the bound of its error lose.
const SPARE_BITS: u32 = 12;

/// Bits of the inputs that the double root of a full row lacks: most of their guard bits.
const LAST_BITS: u32 = 56;

/// How far, relative to the terms compared, two 64-bit numbers must lie apart for their order to be certain: the
/// roundings before it are some dozens, each of 1.1e-16.
const MARGIN: f64 = 1e-12;

/// A minimum of F between its two roots, relative to its terms, above which 64-bit numbers tell the two apart.
const WELL_SEPARATED: f64 = 1e-6;

/// β and what follows from it, in the number types of the search.
#[derive(Debug, Clone)]
pub(in crate::stability) struct Constants {
    effect_ratio: Ball,
    excess: Ball,
    root_ratio: Ball,
    /// −1 − r of the cusp.
    cusp: Ball,
    short: Short,
}

/// The same to 64 and 106 bits.
#[derive(Debug, Clone, Copy)]
struct Short {
    effect_ratio: Dd,
    excess: Dd,
    root_ratio: f64,
    cusp: f64,
}

/// A double root of the boundary, enclosed to half the digits, and the unknown group to all of them.
#[derive(Debug, Clone)]
pub(in crate::stability) struct DoubleRoot {
    /// The arc.
    pub(in crate::stability) arc: Arc,
    /// g at given κ; 1/κ at given g.
    pub(in crate::stability) unknown: Ball,
    enclosure: Enclosure,
    start: Start,
}

impl DoubleRoot {
    /// What it took.
    pub(in crate::stability) fn work(&self) -> Work {
        Work {
            double_double_steps: self.start.steps,
            newton_bits: self.enclosure.precisions.clone(),
            evaluation_bits: self.unknown.precision_bits(),
        }
    }
}

/// One group given, in the number types of the search.
struct Line<'c> {
    constants: &'c Constants,
    given: GivenGroup,
    value: &'c Ball,
    short: Dd,
}

/// Where the roots of an arc may be.
struct Branch {
    start: f64,
    /// Whether F rises at the root.
    rises: bool,
}

fn double_double(value: &Ball) -> Dd {
    let hi = value.to_f64();
    Dd::exact_sum(hi, rug::Float::with_val(64, value.centre() - hi).to_f64())
}

impl Constants {
    /// β, β − 1, √β and −1 − r of the cusp, each with the same precision.
    pub(in crate::stability) fn new(effect_ratio: Ball, excess: Ball, root_ratio: Ball, cusp: Ball) -> Self {
        let short = Short {
            effect_ratio: double_double(&effect_ratio),
            excess: double_double(&excess),
            root_ratio: root_ratio.to_f64(),
            cusp: cusp.to_f64(),
        };
        Self { effect_ratio, excess, root_ratio, cusp, short }
    }

    /// The double roots on an arc where κ or g is `value`, from the quasi-static end on, with the unknown to 2^−bits.
    pub(in crate::stability) fn found(
        &self,
        arc: Arc,
        given: GivenGroup,
        value: &Ball,
        bits: u32,
    ) -> Option<Vec<DoubleRoot>> {
        let line = Line { constants: self, given, value, short: double_double(value) };
        let branches = match arc {
            Arc::Upper => line.upper_branch()?.into_iter().collect(),
            Arc::Lower => line.lower_branches()?,
        };
        branches.into_iter().map(|branch| line.found(arc, &branch, bits)).collect()
    }

    /// λ of a point.
    pub(in crate::stability) fn parameter(
        &self,
        found: DoubleRoot,
        given: GivenGroup,
        value: &Ball,
    ) -> Option<Ball> {
        let DoubleRoot { arc, unknown, enclosure, start } = found;
        let precision = value.precision_bits();
        let line = Line { constants: self, given, value, short: double_double(value) };
        let coefficients = line.coefficients(arc);
        let root = enclosure.refined(Loss::of(&start), &coefficients, precision - LAST_BITS)?;
        let root = root.with_precision(precision);
        let inertial = given.inertial_parameter(value, &unknown);
        Some(parameter_at(arc, root, inertial, &self.root_ratio))
    }
}

/// λ of a point, from (d − r)(1 + r + √β) = 2rηu² on the upper arc and (x − √β)(x + √β) = 2ηx²(1 + x) on the lower one.
pub(super) fn parameter_at(arc: Arc, root: Ball, inertial_parameter: Ball, root_ratio: &Ball) -> Ball {
    let twice = inertial_parameter.clone() + inertial_parameter;
    let (one, q) = (Ball::from(1), root_ratio);
    match arc {
        Arc::Upper => {
            let next = root + one;
            (next.clone() + q) / (twice * next.square())
        }
        Arc::Lower => {
            let farther = root.clone() + &one;
            (q.clone() + one) * (root.clone() + q) / (twice * root.square() * farther)
        }
    }
}

impl Line<'_> {
    fn coefficients(&self, arc: Arc) -> Vec<Ball> {
        let Constants { effect_ratio, excess, .. } = self.constants;
        coefficients(arc, self.given, self.value, effect_ratio, excess)
    }

    fn double_double_coefficients(&self, arc: Arc) -> Vec<Dd> {
        let Short { effect_ratio, excess, .. } = &self.constants.short;
        coefficients(arc, self.given, &self.short, effect_ratio, excess)
    }

    fn f64_coefficients(&self, arc: Arc) -> Vec<f64> {
        let Short { effect_ratio, excess, .. } = &self.constants.short;
        coefficients(arc, self.given, &self.short.hi(), &effect_ratio.hi(), &excess.hi())
    }

    /// Whether κ is below (√β ∓ 1)², that of eq 15 or 16; at given g there is no such condition.
    fn is_below_the_end(&self, arc: Arc) -> Option<bool> {
        if self.given == GivenGroup::VelocitySquared {
            return Some(true);
        }
        let Constants { excess, root_ratio, short, .. } = self.constants;
        let (sum, kappa) = (short.root_ratio + 1.0, self.short.hi());
        let end = if arc == Arc::Upper { (short.excess.hi() / sum).square() } else { sum * sum };
        if (kappa - end).abs() > MARGIN * (kappa + end) {
            return Some(kappa < end);
        }
        let sum = root_ratio.clone() + Ball::from(1);
        let end = if arc == Arc::Upper { (excess.clone() / sum).square() } else { sum.square() };
        (end - self.value).sign().map(|sign| sign == Ordering::Greater)
    }

    /// The upper arc runs from r = 0 to √β − 1, and κ rises and g falls on the way.
    fn upper_branch(&self) -> Option<Option<Branch>> {
        if !self.is_below_the_end(Arc::Upper)? {
            return Some(None);
        }
        let Short { excess, root_ratio, .. } = self.constants.short;
        let sum = root_ratio + 1.0;
        let (end, value) = (excess.hi() / sum, self.short.hi());
        let start = match self.given {
            GivenGroup::StiffnessGroup => end * (2.0 * value / (end * end * sum)).min(1.0),
            GivenGroup::VelocitySquared => end.signum() * end.abs().min(1.0 / value.sqrt()),
        };
        // F is negative at 0 for given κ; at given g it has the sign of −e there.
        let is_negative_at_zero = self.given == GivenGroup::StiffnessGroup || end > 0.0;
        let ends = if is_negative_at_zero { (0.0, end) } else { (end, 0.0) };
        let start = root_between(&self.f64_coefficients(Arc::Upper), ends, start);
        Some(Some(Branch { start, rises: true }))
    }

    /// The lower arc runs from x = √β through the cusp to infinity. F is negative between its two roots.
    fn lower_branches(&self) -> Option<Vec<Branch>> {
        let Short { effect_ratio, root_ratio, cusp, .. } = self.constants.short;
        let coefficients = self.f64_coefficients(Arc::Lower);
        let at_cusp = values(&coefficients, cusp);
        let depth = at_cusp.value / at_cusp.terms;
        if depth > MARGIN {
            return Some(Vec::new());
        }
        let has_quasi_static = self.is_below_the_end(Arc::Lower)?;
        let mut starts = [0.0; 2];
        if depth < -WELL_SEPARATED {
            let farthest = match self.given {
                GivenGroup::StiffnessGroup => 2.0 * (self.short.hi() - effect_ratio.hi()) - 1.0,
                GivenGroup::VelocitySquared => 1.0 / self.short.hi().sqrt(),
            };
            starts[0] = root_between(&coefficients, (cusp, root_ratio), root_ratio);
            starts[1] = root_between(&coefficients, (cusp, farthest), farthest);
        } else {
            // The parabola at the cusp, from a value that does not cancel.
            let value = horner(self.coefficients(Arc::Lower), &self.constants.cusp);
            if value.sign()? != Ordering::Less {
                return Some(Vec::new()).filter(|_| value.sign() == Some(Ordering::Greater));
            }
            let distance = (-2.0 * value.to_f64() / at_cusp.curvature).sqrt();
            starts = [cusp - distance, cusp + distance];
        }
        let [before, beyond] =
            [(starts[0], false), (starts[1], true)].map(|(start, rises)| Branch { start, rises });
        Some(if has_quasi_static { vec![before, beyond] } else { vec![beyond] })
    }

    /// The certain root of a branch and the unknown there.
    fn found(&self, arc: Arc, branch: &Branch, bits: u32) -> Option<DoubleRoot> {
        let start = Start::polished(&self.double_double_coefficients(arc), branch.start)?;
        let loss = Loss::of(&start);
        let goal = self.half_of_the_bits(arc, &start, bits + SPARE_BITS)?;
        let enclosure = Enclosure::around(&start, loss, &self.coefficients(arc), goal)?;
        self.is_on_branch(arc, branch, &enclosure).then_some(())?;
        let Constants { effect_ratio, excess, .. } = self.constants;
        let unknown = unknown((arc, self.given), self.value, (effect_ratio, excess), &enclosure)?;
        let reached = unknown.relative_radius_log2() <= -f64::from(bits);
        reached.then_some(DoubleRoot { arc, unknown, enclosure, start })
    }

    /// Relative bits of x whose square gives the unknown that many: estimated, as the enclosure says what was reached.
    fn half_of_the_bits(&self, arc: Arc, start: &Start, bits: u32) -> Option<u32> {
        let Short { effect_ratio, excess, .. } = self.constants.short;
        let (x, value) = (start.root.hi(), self.short.hi());
        let (root, next, rest) = match arc {
            Arc::Upper => (x, x + 1.0, excess.hi() - x),
            Arc::Lower => (x + 1.0, x, effect_ratio.hi() + x),
        };
        let inertia = match self.given {
            GivenGroup::VelocitySquared => value * root * root,
            // 1 + gr² = h/κ.
            GivenGroup::StiffnessGroup => root * rest / (next * value) - 1.0,
        };
        let denominator = match self.given {
            GivenGroup::VelocitySquared => root * rest * next * (1.0 + inertia),
            GivenGroup::StiffnessGroup => value * root * next * next * inertia,
        };
        let change = libm::log2((start.values.slope * x * x / denominator).abs());
        let half = (f64::from(bits) + change.max(-f64::from(bits))) / 2.0;
        half.is_finite().then(|| half.max(0.0) as u32 + 1)
    }

    fn is_on_branch(&self, arc: Arc, branch: &Branch, enclosure: &Enclosure) -> bool {
        let one = Ball::from(1);
        let is_positive = |ball: &Ball| ball.sign() == Some(Ordering::Greater);
        let slope = if branch.rises { Ordering::Greater } else { Ordering::Less };
        let in_reach = match arc {
            Arc::Upper if self.constants.short.excess.hi() < 0.0 => {
                return is_positive(&-enclosure.root.clone()) && is_positive(&(enclosure.root.clone() + one));
            }
            Arc::Upper | Arc::Lower => is_positive(&enclosure.root),
        };
        in_reach && enclosure.slope.sign() == Some(slope)
    }
}
