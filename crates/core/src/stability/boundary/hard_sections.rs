//! Sections for measurements of cost: spread over the plane, and crowded where a crossing is hard to find.

use rug::Rational;

use crate::friction::Slider;
use crate::number::{nearest_f64, parse_decimal};
use crate::stability::Arc;
use crate::stability::asymptote::corner;
use crate::stability::boundary::{BoundaryCurve, Section};

/// The digits between which the cost is compared.
pub const DIGITS: [u32; 8] = [15, 20, 30, 40, 57, 60, 100, 200];

/// Ratios b/a of the sliders, with factors of D_c, K and M of the paper's.
const SLIDERS: [(&str, [&str; 3]); 25] = [
    ("1.5", ["1", "1", "1"]),
    ("0.001", ["1", "1", "1"]),
    ("0.02", ["10", "1", "0.1"]),
    ("0.1", ["0.1", "3", "1"]),
    ("0.2", ["3", "0.02", "1"]),
    ("0.3", ["1", "1", "1"]),
    ("0.5", ["0.3", "10", "7"]),
    ("0.7", ["1", "0.1", "1"]),
    ("0.9", ["1", "1", "30"]),
    ("0.99", ["1", "1", "1"]),
    ("0.9999", ["1", "7", "1"]),
    ("0.99999999", ["1", "1", "1"]),
    ("1", ["1", "1", "1"]),
    ("1.0000001", ["1", "1", "0.01"]),
    ("1.001", ["10", "0.1", "1"]),
    ("1.01", ["1", "1", "1"]),
    ("1.1", ["1", "1", "5"]),
    ("1.3", ["0.1", "30", "1"]),
    ("2", ["1", "1", "1"]),
    ("3", ["100", "1", "1"]),
    ("5", ["1", "1", "1"]),
    ("10", ["1", "0.01", "1"]),
    ("30", ["0.1", "1", "1"]),
    ("100", ["1", "1", "1"]),
    ("1000", ["1", "1", "1"]),
];

/// Sections of one kind on each slider.
const SECTIONS: u32 = 40;

/// A slider with sections at given σ and at given V0.
#[derive(Debug, Clone)]
pub struct HardSections {
    /// The slider.
    pub slider: Slider<Rational>,
    /// At given σ.
    pub at_normal_stress: Vec<Section>,
    /// At given V0.
    pub at_velocity: Vec<Section>,
}

impl HardSections {
    /// 25 sliders with b/a from 1e-3 to 1e3, each with 40 sections at given σ and 40 at given V0.
    ///
    /// Half of them spread over ten decades around the cusp and the corners. The others approach the cusp, the corner 15∩18 and the corner 16∩20
    /// to relative distances between 0.1 and 1e-9.
    #[must_use]
    pub fn all() -> Vec<Self> {
        SLIDERS.iter().map(|(ratio, factors)| Self::of(&slider(ratio, factors))).collect()
    }

    fn of(slider: &Slider<Rational>) -> Self {
        let rounded = slider.map(nearest_f64);
        let cusp = BoundaryCurve::new(slider, 30).cusp();
        let cusp = [cusp.normal_stress_pa.to_f64(), cusp.loading_velocity_m_per_s.to_f64()];
        let [upper, lower] = [Arc::Upper, Arc::Lower].map(|arc| {
            let corner = corner(arc, &rounded);
            let all = [corner.normal_stress_pa, corner.loading_velocity_m_per_s];
            // For a = b the upper arc and its corner do not exist.
            if all.iter().all(|value| value.is_finite() && *value > 0.0) { all } else { cusp }
        });
        let places =
            |axis: usize| (0..SECTIONS).map(move |index| place(index, cusp[axis], upper[axis], lower[axis]));
        Self {
            slider: slider.clone(),
            at_normal_stress: places(0).map(Section::AtNormalStress).collect(),
            at_velocity: places(1).map(Section::AtVelocity).collect(),
        }
    }
}

fn number(text: &str) -> Rational {
    parse_decimal(text).unwrap_or_default()
}

fn slider(ratio: &str, factors: &[&str; 3]) -> Slider<Rational> {
    let [distance, stiffness, mass] = factors.map(number);
    let a = Rational::from((4, 1000));
    Slider::from([
        a.clone(),
        a * number(ratio),
        Rational::from((1, 100_000)) * distance,
        stiffness * 10_000_000_u32,
        mass * 1_000_u32,
    ])
}

/// A coordinate by its index, from those of the cusp and the corners.
fn place(index: u32, cusp: f64, upper: f64, lower: f64) -> Rational {
    // The golden ratio spreads the values evenly.
    let fraction = (f64::from(index) * 0.618_033_988_749_894_8).fract();
    let spread = libm::exp10(5.0 * (2.0 * fraction - 1.0));
    let near = libm::exp10(-1.0 - 8.0 * fraction);
    let (value, decimals) = match index {
        0..=9 => (cusp * spread, 3),
        10..=19 => (upper * spread, 5),
        20..=26 => (cusp * (1.0 - near), 14),
        27..=33 => (upper * (1.0 + near), 14),
        34..=36 => (lower * (1.0 - near), 14),
        _ => (lower * (1.0 + near), 14),
    };
    number(&format!("{value:.decimals$e}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::bits_for_digits;

    /// The bound of the precision of the last Newton step: half the bits, and what the curvature of F and its rounding take.
    const MORE_BITS: u32 = 64;

    #[test]
    fn a_crossing_takes_few_newton_steps_at_half_the_precision_and_no_general_way() {
        let sections = HardSections::all();
        let mut crossings = 0;
        for one in &sections {
            for digits in [1, 6].into_iter().chain(DIGITS) {
                let curve = BoundaryCurve::new(&one.slider, digits);
                for section in one.at_normal_stress.iter().chain(&one.at_velocity) {
                    for work in curve.work(section) {
                        let context = format!("{digits} {section:?} {:?}", one.slider);
                        let work = work.unwrap_or_else(|| panic!("the general way: {context}"));
                        let half = bits_for_digits(digits) / 2;
                        // From 90 bits one step reaches half of 60 digits, two of 100 and three of 200.
                        let most_steps = 1 + usize::from(digits > 60) + usize::from(digits > 100);
                        assert!(work.newton_bits.len() <= most_steps, "{work:?} {context}");
                        assert!(
                            work.newton_bits.iter().all(|bits| *bits <= half + MORE_BITS),
                            "{work:?} {context}"
                        );
                        assert!(work.double_double_steps <= 4, "{work:?} {context}");
                        crossings += 1;
                    }
                }
            }
        }
        assert!(crossings > 2_000 * DIGITS.len(), "{crossings}");
    }

    #[test]
    fn a_crossing_is_the_place_of_its_parameter_on_the_rational_curve() {
        let mut crossings = 0;
        for (index, one) in HardSections::all().iter().enumerate() {
            let digits = [1, 6, 15, 20, 57, 100, 200][index % 7];
            let curve = BoundaryCurve::new(&one.slider, digits);
            for section in one.at_normal_stress.iter().chain(&one.at_velocity) {
                for (point, crossing) in curve.on_section(section).iter().zip(curve.crossings(section)) {
                    let context = format!("{digits} {section:?} {:?}", one.slider);
                    let place = curve.position(point.arc, &point.parameter);
                    assert_eq!(point.arc, crossing.arc);
                    let found = &crossing.position;
                    assert!(place.normal_stress_pa.overlaps(&found.normal_stress_pa), "{context}");
                    assert!(
                        place.loading_velocity_m_per_s.overlaps(&found.loading_velocity_m_per_s),
                        "{context}"
                    );
                    let sought = section.sought(crossing.position);
                    let wanted = -f64::from(bits_for_digits(digits));
                    assert!(sought.relative_radius_log2() <= wanted, "{context}");
                    assert!(point.parameter.relative_radius_log2() <= wanted, "{context}");
                    crossings += 1;
                }
            }
        }
        assert!(crossings > 2_000, "{crossings}");
    }
}
