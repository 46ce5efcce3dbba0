//! The two decisions in 64-bit, double-double or exact arithmetic. Each precision level answers only when its error bound allows.

use std::ops::Range;

use super::{boundary_sign, transition_sign};
use crate::friction::{Groups, Parameters};
use crate::number::{Dd, Rational};
use crate::roots::{Bounded, BoundedCubic, PrecisionLevel, Working};

/// Groups outside 2^±110 (about 1e±33) go to exact arithmetic: inside, no fourth-order product over- or underflows,
/// not even the rounding errors that double-double keeps (2^±440 · 2^-106).
const RANGE: Range<f64> = power_of_two(-110)..power_of_two(110);

/// Inputs outside 2^±200 (about 1e±60) go to exact arithmetic as well.
const INPUT_RANGE: Range<f64> = power_of_two(-200)..power_of_two(200);

const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// The groups of a point in the arithmetic R, each within `relative_error` of the true one.
#[derive(Debug, Clone)]
pub(super) struct BoundedGroups<R> {
    pub(super) groups: Groups<R>,
    relative_error: f64,
}

/// How well the inputs are known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InputError {
    /// Exactly.
    None,
    /// To a relative [`Dd::UNIT`].
    Unit,
}

impl InputError {
    /// The relative error of the groups. η takes four products (5·2^-106 each) and a quotient (15·2^-106) of six inputs, which is
    /// below 3 [`Dd::UNIT`] = 48·2^-106; the inputs' own errors come on top.
    const fn of_groups(self) -> f64 {
        match self {
            Self::None => 3.0 * Dd::UNIT,
            Self::Unit => 12.0 * Dd::UNIT,
        }
    }
}

/// The two signs and the precision level that gave the less easy one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Signs {
    pub(super) transition: i8,
    pub(super) boundary: i8,
    pub(super) precision_level: PrecisionLevel,
}

impl BoundedGroups<Dd> {
    /// The groups in double-double, or `None` when they lie outside the range where its error bounds hold.
    pub(super) fn of(groups: &Groups<Rational>) -> Option<Self> {
        let groups = groups.map(Dd::from_rational);
        groups_in_range(&groups.map(Dd::hi)).then_some(Self { groups, relative_error: Dd::UNIT })
    }

    /// The groups of parameters that are each known to [`Dd::UNIT`]: η takes five operations on six of them.
    pub(super) fn of_parameters(parameters: &Parameters<Dd>) -> Option<Self> {
        let (groups, usable) = Self::with_range(parameters, InputError::Unit);
        usable.then_some(groups)
    }

    /// The groups, and whether they and the parameters lie in the range where the error bounds hold. Without branches.
    #[inline(always)]
    pub(super) fn with_range(parameters: &Parameters<Dd>, input_error: InputError) -> (Self, bool) {
        let groups = parameters.groups();
        let usable = inputs_in_range(&parameters.map(Dd::hi)) & groups_in_range(&groups.map(Dd::hi));
        (Self { groups, relative_error: input_error.of_groups() }, usable)
    }

    /// Both signs when 64-bit, or else double-double, is certain of both.
    pub(super) fn signs_below_exact(&self) -> Option<Signs> {
        self.leading().signs(PrecisionLevel::F64).or_else(|| self.signs(PrecisionLevel::DoubleDouble))
    }

    /// The leading parts.
    #[inline(always)]
    pub(super) fn leading(&self) -> BoundedGroups<f64> {
        BoundedGroups { groups: self.groups.map(Dd::hi), relative_error: 2.0 * f64::UNIT }
    }
}

impl<R: Working> BoundedGroups<R> {
    /// Eq 8 with its coefficients' errors: at most two operations on groups, so three relative errors of the terms.
    #[inline(always)]
    pub(super) fn cubic(&self) -> BoundedCubic<R> {
        let Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta } =
            self.groups.map(|group| group.leading());
        BoundedCubic {
            coefficients: self.groups.characteristic_cubic(),
            magnitudes: [kappa, kappa + 1.0 + beta, 1.0 + eta, eta],
            relative_error: 2.0 * (self.relative_error + R::UNIT),
        }
    }

    /// κ − κ_c with its bound: a product of two sums, added to the third group.
    #[inline(always)]
    fn transition_margin(&self) -> Bounded<R> {
        let Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta } =
            self.groups.map(|group| group.leading());
        let terms = kappa + (1.0 + beta) * (1.0 + eta);
        let error = terms * 4.0 * (self.relative_error + 2.0 * R::UNIT);
        Bounded { value: self.groups.transition_margin(), error }
    }

    /// Both signs when both are certain.
    fn signs(&self, precision_level: PrecisionLevel) -> Option<Signs> {
        let transition = certain_sign(&self.transition_margin())?;
        let boundary = certain_sign(&self.cubic().discriminant())?;
        Some(Signs { transition, boundary, precision_level })
    }
}

/// The sign of a value farther from zero than its error bound.
fn certain_sign<R: Working>(bounded: &Bounded<R>) -> Option<i8> {
    let value = bounded.value.leading();
    // Written so that a value or bound that is not a number decides nothing.
    (value.abs() > bounded.error).then_some(if value > 0.0 { 1 } else { -1 })
}

/// The signs of a point, by the lowest precision level that is certain.
pub(super) fn signs(exact: &Groups<Rational>, approximate: Option<&BoundedGroups<Dd>>) -> Signs {
    approximate
        .and_then(|groups| groups.leading().signs(PrecisionLevel::F64))
        .unwrap_or_else(|| signs_above_f64(exact, approximate))
}

/// The signs of a point, by double-double if it is certain and by rationals otherwise.
pub(super) fn signs_above_f64(exact: &Groups<Rational>, approximate: Option<&BoundedGroups<Dd>>) -> Signs {
    approximate.and_then(|groups| groups.signs(PrecisionLevel::DoubleDouble)).unwrap_or_else(|| Signs {
        transition: transition_sign(exact),
        boundary: boundary_sign(exact),
        precision_level: PrecisionLevel::Exact,
    })
}

/// The 64-bit precision level without branches, for vectorised loops: (both signs certain?, stable, all roots real).
///
/// With every input within 2^±200 no intermediate of the groups over- or underflows. η then takes five roundings,
/// κ three and β one.
#[inline(always)]
pub(super) fn filter(point: &Parameters<f64>) -> (bool, bool, bool) {
    let groups = point.groups();
    let usable = inputs_in_range(point) & groups_in_range(&groups);
    let (certain, stable, real) = BoundedGroups { groups, relative_error: 6.0 * f64::UNIT }.filter();
    (usable & certain, stable, real)
}

impl BoundedGroups<f64> {
    /// The same for groups in the range: (both signs certain?, stable, all roots real).
    #[inline(always)]
    pub(super) fn filter(&self) -> (bool, bool, bool) {
        let (transition, boundary) = (self.transition_margin(), self.cubic().discriminant());
        let certain = (transition.value.abs() > transition.error) & (boundary.value.abs() > boundary.error);
        (certain, transition.value > 0.0, boundary.value > 0.0)
    }
}

/// Whether every input lies within 2^±200, so that products and quotients of five of them stay normal numbers.
#[inline(always)]
fn inputs_in_range(point: &Parameters<f64>) -> bool {
    all_within(&INPUT_RANGE, point.clone().into())
}

/// Whether the groups lie in the range where the error bounds hold.
#[inline(always)]
fn groups_in_range(groups: &Groups<f64>) -> bool {
    all_within(&RANGE, [groups.inertial_parameter, groups.stiffness_group, groups.effect_ratio])
}

/// Whether all values lie strictly inside the range; false if one is not a number. Without branches.
#[inline(always)]
fn all_within<const N: usize>(range: &Range<f64>, values: [f64; N]) -> bool {
    let mut inside = true;
    for value in values {
        inside &= value > range.start;
        inside &= value < range.end;
    }
    inside
}

#[cfg(test)]
mod data_error_tests;
