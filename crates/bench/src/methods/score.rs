//! Every method on every hard case: textbook formulas, and our precision levels one by one.
//!
//! Textbook methods get what a 64-bit program has: the seven inputs rounded, and the cubic of η, κ and β made from them.
//! Their class is read off their roots as they come. Our precision levels get the exact groups rounded once, because the relative
//! error of an input below the normal range has no bound; they may leave a point open, which is no answer but no lie.

use super::method::{Method, signs_of};
use num_complex::Complex;
use rayon::prelude::*;
use rug::Float;

use super::HardCase;
use crate::textbook::{Three, aberth, cardano, companion, newton, viete};
use slipmode_core::friction::Groups;
use slipmode_core::number::{Dd, Rational, Real, nearest_f64};
use slipmode_core::roots::{Bounded, BoundedCubic, Pair, Working, certified_roots};

/// Digits requested of the certified roots: the references have thirty.
const CERTIFIED_DIGITS: u32 = 35;

/// Roundings between exact groups and a coefficient, relative to the sum of its terms' magnitudes: one of each group,
/// one of each of two additions, and one to spare for their products.
const ROUNDINGS: f64 = 4.0;

/// The spacing of 64-bit numbers next to 1: the unit of the errors.
const ULP: f64 = f64::EPSILON;

/// Coefficients must lie within these for the bounds of 64-bit and double-double roots to hold.
const SAFE: std::ops::Range<f64> = 1e-60..1e60;

/// How a method fared on some points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MethodScore {
    /// The method.
    pub method: Method,
    /// Points with a wrong sign of the growth rate, or real for complex, or the reverse.
    pub wrong: usize,
    /// Points without an answer: parts that are not finite.
    pub failed: usize,
    /// Points that bounds leave open.
    pub open: usize,
    /// The largest error of max Re(s), in 2^-52 of that root's modulus.
    pub worst_real_ulps: f64,
    /// The largest error of max Im(s) in 2^-52 of itself, where there is a pair and one was found.
    pub worst_imaginary_ulps: f64,
}

impl MethodScore {
    const fn none(method: Method) -> Self {
        Self { method, wrong: 0, failed: 0, open: 0, worst_real_ulps: 0.0, worst_imaginary_ulps: 0.0 }
    }

    /// Adds the points of another score of the same method.
    fn absorb(&mut self, other: &Self) {
        self.wrong += other.wrong;
        self.failed += other.failed;
        self.open += other.open;
        self.worst_real_ulps = self.worst_real_ulps.max(other.worst_real_ulps);
        self.worst_imaginary_ulps = self.worst_imaginary_ulps.max(other.worst_imaginary_ulps);
    }
}

/// What a method says of a point; parts in 1/s.
struct Answer {
    transition: i8,
    boundary: i8,
    real: Float,
    imaginary: Float,
}

enum Said {
    Answer(Answer),
    Open,
    Failed,
}

/// How every method fared on one family of hard cases.
#[derive(Debug, Clone, PartialEq)]
pub struct FamilyScores {
    /// The family.
    pub family: String,
    /// How many points it has.
    pub points: usize,
    /// Method by method, in the order of [`Method::ALL`].
    pub methods: Vec<MethodScore>,
}

/// Every method on every case, family by family in the order of the file.
#[must_use]
pub fn score_families(cases: &[HardCase]) -> Vec<FamilyScores> {
    let families: Vec<&[HardCase]> = cases.chunk_by(|one, next| one.family == next.family).collect();
    families.into_par_iter().map(score_family).collect()
}

fn score_family(cases: &[HardCase]) -> FamilyScores {
    let mut methods = Method::ALL.map(MethodScore::none).to_vec();
    for case in cases {
        let scores = Method::ALL.map(|method| score(method, &said(method, case), case));
        methods.iter_mut().zip(&scores).for_each(|(total, score)| total.absorb(score));
    }
    let family = cases.first().map(|case| case.family.clone()).unwrap_or_default();
    FamilyScores { family, points: cases.len(), methods }
}

fn score(method: Method, said: &Said, case: &HardCase) -> MethodScore {
    let none = MethodScore::none(method);
    let answer = match said {
        Said::Failed => return MethodScore { failed: 1, ..none },
        Said::Open => return MethodScore { open: 1, ..none },
        Said::Answer(answer) => answer,
    };
    let expected = &case.expected;
    let is_right = answer.transition.to_string() == expected.transition_sign
        && answer.boundary.to_string() == expected.boundary_sign;
    let ulps = |found: &Float, wanted: &Rational, measure: &Rational| {
        let difference = found.to_rational().unwrap_or_default() - wanted;
        if difference.is_zero() {
            0.0
        } else {
            nearest_f64(&Rational::from(&difference / measure).abs()) / ULP
        }
    };
    let has_both = !answer.imaginary.is_zero() && !expected.max_imaginary_per_s.is_zero();
    MethodScore {
        wrong: usize::from(!is_right),
        worst_real_ulps: ulps(&answer.real, &expected.max_real_per_s, &expected.its_modulus_per_s),
        worst_imaginary_ulps: if has_both {
            ulps(&answer.imaginary, &expected.max_imaginary_per_s, &expected.max_imaginary_per_s)
        } else {
            0.0
        },
        ..none
    }
}

fn said(method: Method, case: &HardCase) -> Said {
    let groups = case.parameters.groups();
    let rounded = case.parameters.map(nearest_f64);
    let textbook = |solve: fn([f64; 4]) -> Three| {
        of_three(&solve(rounded.groups().characteristic_cubic()), rounded.rate_per_s())
    };
    match method {
        Method::Cardano => textbook(cardano),
        Method::Viete => textbook(viete),
        Method::Companion => textbook(companion),
        Method::Newton => textbook(newton),
        Method::Aberth => textbook(aberth),
        Method::Ours64 => bounded(&groups.map(nearest_f64), &case.parameters.rate_per_s()),
        Method::DoubleDouble => bounded(&groups.map(Dd::from_rational), &case.parameters.rate_per_s()),
        Method::Certified => certified(&groups, &case.parameters.rate_per_s()),
    }
}

/// The class and the largest parts, read off three roots in units of the rate as they come.
fn of_three(roots: &Three, rate_per_s: f64) -> Said {
    let in_si = roots.map(|root: Complex<f64>| Complex::new(root.re * rate_per_s, root.im * rate_per_s));
    let Some((transition, boundary)) = signs_of(&in_si) else { return Said::Failed };
    let real = in_si.iter().map(|root| root.re).fold(f64::NEG_INFINITY, f64::max);
    let imaginary = in_si.iter().map(|root| root.im).fold(0.0, f64::max);
    Said::Answer(Answer {
        transition,
        boundary,
        real: Float::with_val(53, real),
        imaginary: Float::with_val(53, imaginary),
    })
}

/// One precision level with forward error bounds, from groups that are themselves rounded.
fn bounded<R: Working + Real>(groups: &Groups<R>, rate_per_s: &Rational) -> Said {
    let coefficients = groups.characteristic_cubic();
    let [eta, kappa, beta] =
        [groups.inertial_parameter, groups.stiffness_group, groups.effect_ratio].map(Working::leading);
    let magnitudes = [kappa, kappa + 1.0 + beta, 1.0 + eta, eta];
    if !magnitudes.iter().all(|magnitude| SAFE.contains(magnitude)) {
        return Said::Open;
    }
    let found = BoundedCubic { coefficients, magnitudes, relative_error: ROUNDINGS * R::UNIT }.spectrum();
    let (parts, imaginary) = match &found.pair {
        Pair::NotSeparated => return Said::Open,
        Pair::Real([low, high]) => (vec![found.real, *low, *high], None),
        Pair::Complex { re, im } => (vec![found.real, *re], Some(im)),
    };
    let Some(transition) = transition_of(&parts) else { return Said::Open };
    let largest = parts
        .iter()
        .map(|part| part.value)
        .fold(parts[0].value, |a, b| if b.leading() > a.leading() { b } else { a });
    let in_si = |value: R| Float::with_val(240, wide(value) * rate_per_s);
    Said::Answer(Answer {
        transition,
        boundary: if imaginary.is_some() { -1 } else { 1 },
        real: in_si(largest),
        imaginary: imaginary.map_or_else(|| Float::new(53), |im| in_si(im.value)),
    })
}

/// Minus the sign of the largest part, where every bound allows to tell it.
fn transition_of<R: Working>(parts: &[Bounded<R>]) -> Option<i8> {
    let low = |part: &Bounded<R>| part.value.leading() - part.error;
    let high = |part: &Bounded<R>| part.value.leading() + part.error;
    if parts.iter().any(|part| low(part) > 0.0) {
        return Some(-1);
    }
    parts.iter().all(|part| high(part) < 0.0).then_some(1)
}

/// A 64-bit or double-double number without loss.
pub fn wide<R: Working>(value: R) -> Float {
    let leading = value.leading();
    let rest = (value - R::from(leading)).leading();
    Float::with_val(180, leading) + rest
}

fn certified(groups: &Groups<Rational>, rate_per_s: &Rational) -> Said {
    let found = certified_roots(&groups.characteristic_cubic(), CERTIFIED_DIGITS);
    let Some(largest) = found.roots.iter().max_by(|one, other| one.re.total_cmp(&other.re)) else {
        return Said::Failed;
    };
    let imaginary = found.roots.iter().map(|root| &root.im).max_by(|one, other| one.total_cmp(other));
    let in_si = |value: &Float| Float::with_val(240, value * rate_per_s);
    Said::Answer(Answer {
        transition: largest.re.cmp0().map_or(0, |order| -(order as i8)),
        boundary: found.discriminant_sign,
        real: in_si(&largest.re),
        imaginary: imaginary.map_or_else(|| Float::new(53), in_si),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::methods::read_hard_cases;

    /// The vectors of the report, and every method's score over all of them.
    fn totals() -> (usize, Vec<MethodScore>) {
        let text = include_str!("../../../../reports/im-avouac/timings/classification-hard.txt");
        let cases = read_hard_cases("classification-hard.txt", text).unwrap();
        let mut totals = Method::ALL.map(MethodScore::none).to_vec();
        for family in score_families(&cases) {
            totals.iter_mut().zip(&family.methods).for_each(|(total, score)| total.absorb(score));
        }
        (cases.len(), totals)
    }

    #[test]
    fn ours_are_never_wrong_and_the_certified_roots_answer_everything() {
        let (count, totals) = totals();
        assert!(count >= 300, "{count} cases");
        for score in totals.iter().filter(|score| score.method as u8 >= Method::Ours64 as u8) {
            assert_eq!((score.wrong, score.failed), (0, 0), "{score:?}");
        }
        let certified = totals[7];
        assert_eq!(certified.open, 0);
        // The references are rounded to thirty digits.
        assert!(certified.worst_real_ulps < 1e-12 && certified.worst_imaginary_ulps < 1e-12, "{certified:?}");
    }

    #[test]
    fn every_textbook_method_is_wrong_somewhere() {
        let (_, totals) = totals();
        for score in &totals[..5] {
            assert!(score.wrong > 0 && score.failed > 0, "{score:?}");
        }
    }
}
