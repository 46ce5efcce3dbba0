//! What double-double says of a point, without branches: signs, roots, growth rate and frequency, each with its proof.

use super::certain_signs::{BoundedGroups, InputError};
use crate::friction::{Groups, Parameters};
use crate::number::{Dd, fields, select};
use crate::roots::{Bounded, BranchlessRoots};

/// The relative error of V0/D_c and of the product with it, beyond the inputs' own: three operations.
const RATE_ERROR: f64 = 6.0 * Dd::UNIT;

/// Covers the rounding of bounds that are computed in 64-bit.
const SLACK: f64 = 1.05;

/// The relative error of a root before it is rounded: 2^-64.
pub(super) const WORKING_ERROR: f64 = f64::EPSILON / 4096.0;

/// How the three roots are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Route {
    /// By division by a root: where roots may lie many decades apart.
    Deflation,
    /// By the depressed cubic: next to a triple root.
    Shift,
}

fields! {
    /// What is said of a point; every field is a number, so that a block of points is a few columns.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub(super) struct PointValues<R>[FIELDS] {
        /// 0 when 64-bit is not certain of both signs, else 1, plus 1 when K > K_c, plus 2 when all roots are real.
        pub(super) filtered,
        /// +1 when all roots are real, −1 when two are a pair, 0 when some root is not within its bound.
        pub(super) sign,
        /// A real root, 1/s.
        pub(super) real,
        /// Another real root, or the real part of the pair, 1/s.
        pub(super) first,
        /// The third real root, or the imaginary part of the pair, 1/s.
        pub(super) second,
        /// Its trailing part in double-double, 1/s.
        pub(super) second_trailing,
        /// Bound on the error of both parts together, 1/s.
        pub(super) second_error,
        /// The largest real part, 1/s.
        pub(super) max_real,
        /// Bound on its error, rounding included, 1/s.
        pub(super) max_real_error,
        /// 1 when the largest real part and a pair's imaginary part are certain to be correctly rounded.
        pub(super) rounded,
        /// The imaginary part of the pair in units of V0/D_c.
        pub(super) frequency,
        /// V0/D_c, 1/s.
        pub(super) rate,
        /// η.
        pub(super) inertial_parameter,
        /// κ.
        pub(super) stiffness_group,
        /// β.
        pub(super) effect_ratio,
    }
}

/// The number of the fields of [`PointValues`].
pub(super) const FIELDS: usize = 15;

/// A root in 1/s, with its bound before it is rounded to 64-bit.
#[inline(always)]
pub(super) fn in_si(root: &Bounded<Dd>, rate: Dd) -> Bounded<Dd> {
    let value = root.value * rate;
    Bounded { value, error: (root.error * rate.hi() + value.hi().abs() * RATE_ERROR) * SLACK }
}

/// The larger of two numbers in 64-bit, with its bound.
#[inline(always)]
fn larger((one, one_error): (f64, f64), (other, other_error): (f64, f64)) -> (f64, f64) {
    let is_one = one > other;
    let (value, error) = (select(is_one, one, other), select(is_one, one_error, other_error));
    let rest = select(is_one, other + other_error, one + one_error);
    // Where the two bounds overlap, either may be the larger.
    (value, select(value - error > rest, error, one_error.max(other_error)))
}

impl PointValues<f64> {
    /// The groups in 64-bit.
    pub(super) const fn groups(&self) -> Groups<f64> {
        Groups {
            inertial_parameter: self.inertial_parameter,
            stiffness_group: self.stiffness_group,
            effect_ratio: self.effect_ratio,
        }
    }

    /// [`PointValues::second`] in double-double.
    pub(super) const fn second_bounded(&self) -> Bounded<Dd> {
        Bounded { value: Dd::from_parts(self.second, self.second_trailing), error: self.second_error }
    }

    /// The values of a point whose inputs are known so well.
    #[inline(always)]
    pub(super) fn of(parameters: &Parameters<Dd>, input_error: InputError, route: Route) -> Self {
        let (bounded, usable) = BoundedGroups::with_range(parameters, input_error);
        let (certain, stable, real) = bounded.leading().filter();
        let cubic = bounded.cubic();
        let roots = match route {
            Route::Deflation => cubic.roots_by_deflation(),
            Route::Shift => cubic.roots_by_shift(),
        };
        let groups = bounded.groups.map(Dd::hi);
        Self {
            filtered: select(usable & certain, 1.0 + select(stable, 1.0, 0.0) + select(real, 2.0, 0.0), 0.0),
            inertial_parameter: groups.inertial_parameter,
            stiffness_group: groups.stiffness_group,
            effect_ratio: groups.effect_ratio,
            ..Self::of_roots(&roots, parameters.rate_per_s(), usable)
        }
    }

    #[inline(always)]
    pub(super) fn of_roots(roots: &BranchlessRoots, rate: Dd, usable: bool) -> Self {
        let is_pair = roots.sign < 0.0;
        let parts = [&roots.real, &roots.first, &roots.second].map(|root| in_si(root, rate));
        let rounded = parts.each_ref().map(|part| part.value.rounds_surely(part.error));
        let [real, first, second] = parts.each_ref().map(|part| part.value.hi());
        let [of_real, of_first, of_second] = parts
            .each_ref()
            .map(|part| (part.value.hi(), (part.value.lo().abs() + part.error) * (1.0 + f64::EPSILON)));
        let of_both = larger(of_first, of_second);
        let of_others = (select(is_pair, of_first.0, of_both.0), select(is_pair, of_first.1, of_both.1));
        let (max_real, max_real_error) = larger(of_real, of_others);
        Self {
            filtered: 0.0,
            sign: select(usable & roots.are_within(WORKING_ERROR), roots.sign, 0.0),
            real,
            first,
            second,
            second_trailing: parts[2].value.lo(),
            second_error: parts[2].error,
            max_real,
            max_real_error,
            rounded: select(rounded[0] & rounded[1] & rounded[2], 1.0, 0.0),
            frequency: select(is_pair, roots.second.value.hi(), 0.0),
            rate: rate.hi(),
            inertial_parameter: 0.0,
            stiffness_group: 0.0,
            effect_ratio: 0.0,
        }
    }
}
