//! The classification of a point: exact signs, their names, and the growth rate and frequency.

use rug::Float;

use super::certain_signs::{self, BoundedGroups};
use super::point_values::in_si;
use super::slip_mode::slip_mode_given;
use super::{InertialThreshold, SlipMode, SpectralClass};
use crate::friction::{Groups, Parameters};
use crate::number::{Dd, Rational, Wide, nearest_f64};
use crate::roots::{Bounded, CertifiedRoots, Pair, PrecisionLevel, Spectrum, certified_roots};

/// Digits of the enclosures behind the values when double-double does not suffice.
const EXACT_DIGITS: u32 = 19;

/// The relative error up to which double-double values are taken; half of the promised 1e-14.
const TOLERANCE: f64 = 5e-15;

/// What is known of a point: signs and names exactly, values to 1e-14.
///
/// ```
/// use slipmode_core::stability::{Classification, InertialThreshold, SpectralClass, classify};
/// # use slipmode_core::{friction::Slider, number::parse_decimal};
/// # let number = |text| parse_decimal(text).unwrap();
/// # let slider = Slider::from(["0.004", "0.006", "1e-5", "1e7", "1000"].map(number));
/// let found: Classification = classify(&slider.at(number("1e3"), number("1e-5")), &InertialThreshold::default());
/// assert_eq!(found.transition_sign, 1);
/// assert_eq!(found.spectral_class, SpectralClass::from_signs(found.transition_sign, found.boundary_sign));
/// assert!(found.max_real_per_s.to_f64().unwrap() < 0.0); // disturbances die
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Classification {
    /// Sign of K − K_c: +1 linearly stable, 0 on the transition.
    pub transition_sign: i8,
    /// Sign of the discriminant: +1 all roots real, −1 a complex pair, 0 on the boundary.
    pub boundary_sign: i8,
    /// The class those two signs give.
    pub spectral_class: SpectralClass,
    /// The slip mode.
    pub slip_mode: SlipMode,
    /// Largest Re(s), 1/s, with a relative error of at most 1e-14 however near to the transition, and so with the sign of
    /// K_c − K; exactly 0 on the transition.
    pub max_real_per_s: Wide,
    /// Largest Im(s), 1/s, with a relative error of at most 1e-14; exactly 0 when no root is complex.
    pub max_imaginary_per_s: Wide,
    /// The precision level that decided the signs.
    pub precision_level: PrecisionLevel,
    /// The precision level that gave the values: 64-bit cannot guarantee 1e-14, so double-double or exact.
    pub value_precision_level: PrecisionLevel,
    /// The imaginary part of the pair with its bound, 1/s; none where double-double does not give it.
    pub(super) angular_frequency: OfPair,
}

/// The imaginary part of a pair with its bound. It is on the way to the frequencies and no part of the answer: a point's
/// classification is the same on each way, this number is not.
#[derive(Debug, Clone)]
pub(super) struct OfPair(pub(super) Option<Bounded<Dd>>);

impl PartialEq for OfPair {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// The largest real and imaginary parts of the dimensionless roots p.
pub(super) struct LargestParts<R> {
    pub(super) real: R,
    pub(super) imaginary: R,
}

/// Classifies a point. Signs and names are right for the decimals as written, of any length.
///
/// ```
/// use slipmode_core::stability::{InertialThreshold, classify};
/// # use slipmode_core::{friction::Slider, number::parse_decimal};
/// # let number = |text| parse_decimal(text).unwrap();
/// # let slider = Slider::from(["0.004", "0.006", "1e-5", "1e7", "1000"].map(number));
/// let fast = slider.at(number("1e4"), number("0.5"));
/// let found = classify(&fast, &InertialThreshold::default());
/// assert_eq!(found.slip_mode.as_str(), "harmonic-vibration");
/// ```
#[must_use]
pub fn classify(parameters: &Parameters<Rational>, threshold: &InertialThreshold) -> Classification {
    let groups = parameters.groups();
    let approximate = BoundedGroups::of(&groups);
    let signs = certain_signs::signs(&groups, approximate.as_ref());
    let spectral_class = SpectralClass::from_signs(signs.transition, signs.boundary);
    let rate_per_s = parameters.rate_per_s();

    let parts = approximate
        .and_then(|approximate| LargestParts::of_bounded(&approximate.cubic().spectrum(), signs.transition));
    let in_si = parts.as_ref().and_then(|parts| parts.times_rate(Dd::from_rational(&rate_per_s)));
    let value_precision_level =
        if in_si.is_some() { PrecisionLevel::DoubleDouble } else { PrecisionLevel::Exact };
    let angular_frequency = OfPair(in_si.as_ref().map(|parts| parts.imaginary));
    let LargestParts { real, imaginary } = in_si
        .and_then(|parts| parts.rounded())
        .unwrap_or_else(|| LargestParts::exactly(&groups).times_rate(&rate_per_s));

    let inertial = || {
        let imaginary = parts.as_ref().map(|parts| parts.imaginary.value.hi());
        let natural_squared = groups.map(nearest_f64).natural_angular_frequency_squared();
        imaginary
            .and_then(|p| clearly_inertial(p, natural_squared, nearest_f64(threshold.squared_ratio())))
            .unwrap_or_else(|| threshold.exceeded_at(&groups))
    };
    Classification {
        transition_sign: signs.transition,
        boundary_sign: signs.boundary,
        spectral_class,
        slip_mode: slip_mode_given(&groups, spectral_class, inertial),
        max_real_per_s: real,
        max_imaginary_per_s: imaginary,
        precision_level: signs.precision_level,
        value_precision_level,
        angular_frequency,
    }
}

/// Whether ω² > T·κ/η, when 64-bit can tell: ω is known to 5e-15, and the few operations lose less than as much again. T is the
/// rounded threshold.
pub(super) fn clearly_inertial(omega: f64, natural_squared: f64, squared_ratio: f64) -> Option<bool> {
    let ratio = omega * omega / (natural_squared * squared_ratio);
    ((ratio - 1.0).abs() > 1e-12).then_some(ratio > 1.0)
}

impl LargestParts<Bounded<Dd>> {
    /// From roots with error bounds, when each is at most [`TOLERANCE`] of its own part.
    ///
    /// On the transition itself the growth rate is zero, and its bound is compared with the pair's modulus.
    pub(super) fn of_bounded(spectrum: &Spectrum<Dd>, transition_sign: i8) -> Option<Self> {
        let zero = Bounded { value: Dd::from(0.0), error: 0.0 };
        let within = |bounded: &Bounded<Dd>, size: f64| bounded.error <= TOLERANCE * size;
        let own_size = |bounded: &Bounded<Dd>| within(bounded, bounded.value.hi().abs());
        let (pair, imaginary) = match &spectrum.pair {
            Pair::NotSeparated => return None,
            Pair::Real([lower, upper]) => (own_size(lower) && own_size(upper)).then_some((*upper, zero))?,
            Pair::Complex { re, im } if transition_sign == 0 => {
                let (x, y) = (re.value.hi(), im.value.hi());
                (own_size(im) && within(re, (x * x + y * y).sqrt())).then_some((*re, *im))?
            }
            Pair::Complex { re, im } => (own_size(im) && own_size(re)).then_some((*re, *im))?,
        };
        let largest = if pair.value > spectrum.real.value { pair } else { spectrum.real };
        let real = if transition_sign == 0 { zero } else { largest };
        own_size(&spectrum.real).then_some(Self { real, imaginary })
    }

    /// The parts in 1/s, if the rate and they lie well inside f64's range.
    pub(super) fn times_rate(&self, rate: Dd) -> Option<Self> {
        let part = |part: &Bounded<Dd>| {
            let in_si = in_si(part, rate);
            let size = in_si.value.hi().abs();
            (size > 1e-250 && size < 1e250 || part.value.hi() == 0.0).then_some(in_si)
        };
        let usable = rate.hi() > 1e-100 && rate.hi() < 1e100;
        usable.then_some(Self { real: part(&self.real)?, imaginary: part(&self.imaginary)? })
    }

    /// The parts without their bounds.
    pub(super) fn rounded(&self) -> Option<LargestParts<Wide>> {
        let part = |part: &Bounded<Dd>| Wide::from_f64(part.value.hi());
        Some(LargestParts { real: part(&self.real)?, imaginary: part(&self.imaginary)? })
    }
}

impl LargestParts<Float> {
    /// From certified roots: each part to 19 digits before it is rounded.
    pub(super) fn exactly(groups: &Groups<Rational>) -> Self {
        let CertifiedRoots { roots, .. } = certified_roots(&groups.characteristic_cubic(), EXACT_DIGITS);
        let parts = |part: fn(&crate::roots::CertifiedRoot) -> &Float| {
            let largest = roots.iter().map(part).max_by(|x, y| x.total_cmp(y));
            largest.map_or_else(|| Float::new(80), |part| Float::with_val(80, part))
        };
        Self { real: parts(|root| &root.re), imaginary: parts(|root| &root.im) }
    }

    /// The parts in 1/s.
    pub(super) fn times_rate(&self, rate_per_s: &Rational) -> LargestParts<Wide> {
        let in_si = |part: &Float| Wide::from_float(&Float::with_val(80, part * rate_per_s));
        LargestParts { real: in_si(&self.real), imaginary: in_si(&self.imaginary) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::Slider;
    use crate::number::parse_decimal;
    use crate::stability::fixtures::{self, double_root_and_effect_ratio};
    use proptest::prelude::*;

    /// Unit a, D_c, V and σ make the groups the parameters: η = M, κ = K, β = b.
    fn with_groups(eta: &Rational, kappa: &Rational, beta: &Rational) -> Parameters<Rational> {
        let one = Rational::from(1);
        let slider = Slider {
            direct_effect: one.clone(),
            evolution_effect: beta.clone(),
            critical_slip_distance_m: one.clone(),
            stiffness_pa_per_m: kappa.clone(),
            mass_per_area_kg_per_m2: eta.clone(),
        };
        slider.at(one.clone(), one)
    }

    /// Checks every promise of [`Classification`] against the exact signs and 60-digit roots.
    fn assert_promises(parameters: &Parameters<Rational>) -> Classification {
        let found = classify(parameters, &InertialThreshold::default());
        let groups = parameters.groups();
        assert_eq!(found.transition_sign, super::super::transition_sign(&groups));
        assert_eq!(found.boundary_sign, super::super::boundary_sign(&groups));
        let class = found.spectral_class;
        let named = super::super::slip_mode(&groups, class, &InertialThreshold::default());
        assert_eq!(found.slip_mode, named);
        let roots = certified_roots(&groups.characteristic_cubic(), 60).roots;
        let rate = Float::with_val(300, &parameters.rate_per_s());
        let largest_im = roots.iter().map(|root| root.im.clone()).max_by(Float::total_cmp).unwrap() * &rate;
        let top = roots.iter().max_by(|x, y| x.re.total_cmp(&y.re)).unwrap();
        let im_error = (found.max_imaginary_per_s.to_float() - &largest_im).abs();
        assert!(im_error <= largest_im * 1e-14, "{parameters:?} {found:?}");
        let largest_re = top.re.clone() * rate;
        let re_error = (found.max_real_per_s.to_float() - &largest_re).abs();
        assert!(re_error <= largest_re.abs() * 1e-14, "{parameters:?} {found:?}");
        let growth = found.max_real_per_s.to_float().cmp0().unwrap() as i8;
        assert_eq!(growth, -found.transition_sign, "growth has the sign of K_c − K");
        found
    }

    fn group() -> impl Strategy<Value = Rational> {
        (1i64..1_000_000, -36i32..31).prop_map(|(n, e)| parse_decimal(&format!("{n}e{e}")).unwrap())
    }

    proptest! {
        #[test]
        fn promises_hold_for_groups_of_all_sizes(eta in group(), kappa in group(), beta in group()) {
            assert_promises(&with_groups(&eta, &kappa, &beta));
        }

        #[test]
        fn promises_hold_on_and_next_to_the_boundary((r, beta) in double_root_and_effect_ratio(), depth in 1i32..60) {
            let (eta, kappa) = (fixtures::inertial_parameter(&r, &beta), fixtures::stiffness_group(&r, &beta));
            assert_promises(&with_groups(&eta, &kappa, &beta));
            let shift = parse_decimal(&format!("1e-{depth}")).unwrap() + 1u32;
            assert_promises(&with_groups(&eta, &(kappa * shift), &beta));
        }

        #[test]
        fn promises_hold_next_to_the_transition(eta in group(), excess in group(), depth in 1i32..60) {
            let beta = Rational::from(&excess + 1);
            let kappa = excess * Rational::from(&eta + 1);
            let shift = parse_decimal(&format!("1e-{depth}")).unwrap() + 1u32;
            assert_promises(&with_groups(&eta, &kappa, &beta));
            assert_promises(&with_groups(&eta, &(kappa * shift), &beta));
        }
    }

    /// K from 1e-13 to 1e-31 beside K_c, as an exact decimal and as the 64-bit number nearest to it.
    #[test]
    fn the_growth_rate_keeps_its_digits_next_to_the_transition() {
        for beta in ["1.05704", "1.5", "20"] {
            let beta = parse_decimal(beta).unwrap();
            for eta in ["751.6935666428407", "1", "1e-6"] {
                let eta = parse_decimal(eta).unwrap();
                let critical = crate::friction::critical_stiffness_group(&beta, &eta);
                for exponent in 13..=31 {
                    for sign in ["", "-"] {
                        let shift = parse_decimal(&format!("{sign}1e-{exponent}")).unwrap() + 1u32;
                        assert_promises(&with_groups(&eta, &(critical.clone() * shift), &beta));
                    }
                }
                let [beta, eta, critical] =
                    [&beta, &eta, &critical].map(|value| Rational::from_f64(nearest_f64(value)).unwrap());
                for steps in -3i32..=3 {
                    let kappa =
                        critical.clone() * Rational::from_f64(1.0 + f64::from(steps) * f64::EPSILON).unwrap();
                    assert_promises(&with_groups(&eta, &kappa, &beta));
                }
            }
        }
    }

    #[test]
    fn on_the_cusp_all_is_decided_and_nothing_oscillates() {
        let [eta, kappa, beta] = ["0.125", "3.375", "1"].map(|text| parse_decimal(text).unwrap());
        let found = assert_promises(&with_groups(&eta, &kappa, &beta));
        assert_eq!((found.boundary_sign, found.spectral_class), (0, SpectralClass::StableReal));
        assert!(found.max_imaginary_per_s.is_zero());
        assert_eq!(found.max_real_per_s.to_f64(), Some(-3.0));
    }

    #[test]
    fn inputs_at_the_ends_of_the_number_grammar_are_classified() {
        let ends = ["1e-10000", "7", "1e10000"].map(|text| parse_decimal(text).unwrap());
        // Every input at an end of the grammar in turn, in a fixed pattern of all three.
        for pattern in 0..9 {
            let end = |k: usize| ends[(pattern * (k + 1) + k / 3) % 3].clone();
            assert_promises(&Parameters::from([0, 1, 2, 3, 4, 5, 6].map(end)));
        }
    }

    #[test]
    fn values_far_beyond_f64_are_neither_infinite_nor_zero() {
        let [eta, kappa, beta] = ["1e-1000", "1e5000", "2"].map(|text| parse_decimal(text).unwrap());
        let found = assert_promises(&with_groups(&eta, &kappa, &beta));
        assert_eq!(found.max_imaginary_per_s.to_f64(), None, "about 1e3000");
    }
}
