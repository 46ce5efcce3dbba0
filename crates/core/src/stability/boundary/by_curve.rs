//! Points of the boundary from the rational curve, at a given parameter.

use rug::Rational;

use crate::friction::{OperatingPoint, Slider};
use crate::number::{Ball, Real, bits_for_digits};
use crate::stability::boundary::{BoundaryPoint, Mark};
use crate::stability::cusp::cusp_abscissa;
use crate::stability::double_root::Constants;
use crate::stability::{Arc, ArcFrame};

/// Bits beyond the digits requested: the forms of `arc_point` lose four or five, square roots and logarithms two more.
pub(super) const GUARD_BITS: u32 = 24;

/// Bits beyond these for points of given σ, whose V0 is this much worse conditioned next to eqs 15 and 16.
const SECTION_GUARD_BITS: u32 = 40;

/// The boundary of one friction, spring and mass, ready for points of a given number of digits.
///
/// ```
/// use slipmode_core::stability::{BoundaryCurve, Section};
/// # use slipmode_core::{friction::Slider, number::parse_decimal};
/// # let number = |text| parse_decimal(text).unwrap();
/// # let slider = Slider::from(["0.004", "0.006", "1e-5", "1e7", "1000"].map(number));
/// let curve = BoundaryCurve::new(&slider, 20);
/// // At 10 µm/s steady sliding changes between oscillating and not oscillating at three normal stresses.
/// let points = curve.on_section(&Section::AtVelocity(number("1e-5")));
/// assert_eq!(points.iter().map(|point| point.arc.as_str()).collect::<Vec<_>>(), ["upper", "lower", "lower"]);
/// assert!(points.iter().all(|point| point.normal_stress_pa.relative_radius_log2() < -60.0));
/// ```
#[derive(Debug, Clone)]
pub struct BoundaryCurve {
    pub(super) slider: Slider<Rational>,
    pub(super) effect_ratio: Rational,
    pub(super) frame: ArcFrame<Ball>,
    pub(super) bits: u32,
    pub(super) cusp_parameter: Ball,
    stress_scale_pa: Ball,
    velocity_scale_m_per_s: Ball,
    /// The numbers of the sections, to more bits.
    pub(super) constants: Constants,
    pub(super) section_bits: u32,
    pub(super) section_stress_scale_pa: Ball,
    pub(super) section_velocity_scale_m_per_s: Ball,
}

impl BoundaryCurve {
    /// The boundary to this many digits.
    ///
    /// This takes about as long as three crossings at given σ or V0: 9 µs at 20 digits, 14 µs at 200 digits. Keep the curve if
    /// several points of the same slider are needed.
    #[must_use]
    pub fn new(slider: &Slider<Rational>, digits: u32) -> Self {
        let bits = bits_for_digits(digits) + GUARD_BITS;
        let section_bits = bits + SECTION_GUARD_BITS;
        let effect_ratio = slider.effect_ratio();
        let excess = Ball::from_rational(&Rational::from(&effect_ratio - 1_u32), section_bits);
        let ratio = Ball::from_rational(&effect_ratio, section_bits);
        let root_ratio = ratio.sqrt();
        let frame = ArcFrame::new(excess.with_precision(bits), root_ratio.with_precision(bits));
        let cusp = cusp_abscissa(&effect_ratio, section_bits);
        let section_stress_scale_pa = Ball::from_rational(&slider.stress_scale_pa(), section_bits);
        let section_velocity_scale_m_per_s =
            Ball::from_rational(&slider.velocity_scale_squared(), section_bits).sqrt();
        Self {
            cusp_parameter: frame.sum.clone() / (cusp.clone() - &root_ratio).with_precision(bits),
            stress_scale_pa: section_stress_scale_pa.with_precision(bits),
            velocity_scale_m_per_s: section_velocity_scale_m_per_s.with_precision(bits),
            constants: Constants::new(ratio, excess, root_ratio, cusp),
            section_stress_scale_pa,
            section_velocity_scale_m_per_s,
            frame,
            slider: slider.clone(),
            effect_ratio,
            bits,
            section_bits,
        }
    }

    /// The arcs that exist: both, or only the lower one when a = b.
    #[must_use]
    pub fn arcs(&self) -> &'static [Arc] {
        if self.effect_ratio == 1 { &[Arc::Lower] } else { &[Arc::Upper, Arc::Lower] }
    }

    /// σ and V0 at the parameter λ of an arc.
    #[must_use]
    pub fn position(&self, arc: Arc, parameter: &Ball) -> OperatingPoint<Ball> {
        let (inverse_stiffness_group, velocity_squared) = self.frame.place(arc, &self.lifted(parameter));
        OperatingPoint {
            normal_stress_pa: self.stress_scale_pa.clone() * inverse_stiffness_group,
            loading_velocity_m_per_s: self.velocity_scale_m_per_s.clone() * velocity_squared.sqrt(),
        }
    }

    /// The full row at the parameter λ of an arc.
    #[must_use]
    pub fn point(&self, arc: Arc, parameter: &Ball, mark: Option<Mark>) -> BoundaryPoint {
        let lifted = self.lifted(parameter);
        BoundaryPoint::new(&self.frame, (arc, &lifted), self.position(arc, &lifted), mark)
    }

    /// The same number with room for this curve's precision, so that λ + 1 is not rounded to λ's own.
    fn lifted(&self, parameter: &Ball) -> Ball {
        parameter.with_precision(self.bits.max(parameter.precision_bits()))
    }

    /// The same boundary to another number of digits.
    pub(in crate::stability) fn with_digits(&self, digits: u32) -> Self {
        Self::new(&self.slider, digits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::format::certain_digits;
    use crate::stability::boundary::Section;
    use crate::stability::fixtures::{paper, with_effects};
    use crate::stability::{Asymptote, asymptote};

    #[test]
    fn the_cusp_of_the_papers_values() {
        let cusp = BoundaryCurve::new(&paper(), 50).cusp();
        assert_eq!(certain_digits(&cusp.loading_velocity_m_per_s, 5), "0.00015964");
        assert_eq!(certain_digits(&cusp.normal_stress_pa, 5), "5857.9");
        assert!(cusp.normal_stress_pa.relative_radius_log2() < -f64::from(bits_for_digits(50)));
        // The area pokes past the corner of eqs 16 and 20.
        let corner = asymptote::corner(Arc::Lower, &paper().map(|value| Ball::from_rational(value, 200)));
        assert!(cusp.normal_stress_pa.lower() > corner.normal_stress_pa.upper());
        assert!(cusp.loading_velocity_m_per_s.lower() > corner.loading_velocity_m_per_s.upper());
    }

    #[test]
    fn lines_through_a_cusp_of_short_numbers_meet_it_once() {
        // β = 1 with κ = 27/8 and η = 1/8: balls hold the cusp exactly, and its equation is exactly zero there.
        let one = Rational::from(1);
        let slider = Slider {
            direct_effect: one.clone(),
            evolution_effect: one.clone(),
            critical_slip_distance_m: one.clone(),
            stiffness_pa_per_m: Rational::from((27, 8)),
            mass_per_area_kg_per_m2: Rational::from((1, 8)),
        };
        let curve = BoundaryCurve::new(&slider, 50);
        for section in [Section::AtVelocity(one.clone()), Section::AtNormalStress(one.clone())] {
            let found = curve.on_section(&section);
            assert_eq!(found.len(), 1, "{section:?}");
            assert!((found[0].normal_stress_pa.clone() - Ball::from(1)).contains_zero());
            assert!((found[0].loading_velocity_m_per_s.clone() - Ball::from(1)).contains_zero());
        }
    }

    #[test]
    fn every_number_of_every_sample_has_the_requested_digits() {
        for (a, b) in [(4, 6), (6, 4), (5, 5), (1, 1000), (1000, 1)] {
            let slider = with_effects(Rational::from((a, 1000)), Rational::from((b, 1000)));
            let curve = BoundaryCurve::new(&slider, 50);
            let points = curve.sample(30, 1e-8);
            assert_eq!(points.len(), curve.arcs().len() * 30 + if a == b { 4 } else { 5 });
            let goal = -f64::from(bits_for_digits(50));
            for point in points {
                for ball in [&point.normal_stress_pa, &point.loading_velocity_m_per_s, &point.asymptote_value]
                {
                    assert!(ball.relative_radius_log2() < goal, "{a} {b} {point:?}");
                }
                let balls = slider.map(|value| Ball::from_rational(value, 300));
                let value = point.asymptote.value(&balls, &point.normal_stress_pa);
                assert!(value.overlaps(&point.asymptote_value));
                assert_eq!(point.asymptote.arc(), point.arc);
            }
        }
    }

    #[test]
    fn the_number_of_points_on_a_section_is_that_of_the_theory() {
        let curve = BoundaryCurve::new(&paper(), 30);
        let arcs = |section: Section| curve.on_section(&section).iter().map(|p| p.arc).collect::<Vec<_>>();
        let number = |text: &str| crate::number::parse_decimal(text).unwrap_or_default();
        use Arc::{Lower, Upper};
        assert_eq!(arcs(Section::AtVelocity(number("1e-6"))), [Upper, Lower, Lower]);
        assert_eq!(arcs(Section::AtVelocity(number("1.6e-4"))), [Upper]);
        assert_eq!(arcs(Section::AtNormalStress(number("1e3"))), [Lower]);
        assert_eq!(arcs(Section::AtNormalStress(number("5.5e3"))), [Lower, Lower]);
        assert_eq!(arcs(Section::AtNormalStress(number("1e4"))), []);
        assert_eq!(arcs(Section::AtNormalStress(number("1e6"))), [Upper]);
        let asymptote = curve.on_section(&Section::AtVelocity(number("1e-6"))).remove(0).asymptote;
        assert_eq!(asymptote, Asymptote::QuasiStaticUpper);
    }
}
