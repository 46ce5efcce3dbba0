//! The three routes to the boundary side by side.

use rug::{Float, Rational};

use crate::friction::Slider;
use crate::number::Ball;
use crate::stability::boundary::{BoundaryCurve, Section, by_bisection, by_discriminant};
use crate::stability::inverse::SolutionKind;

/// What came of the comparison.
#[derive(Debug, Clone)]
pub struct RouteComparison {
    /// Crossings that all three routes found, with overlapping enclosures.
    pub compared: usize,
    /// Sections on which the routes disagree: in the number of crossings, in an arc, or by disjoint enclosures.
    pub disagreements: Vec<Section>,
    /// An upper bound of the largest relative difference between two routes' true answers, from enclosures alone.
    pub largest_difference: Float,
}

/// Compares the routes on sections through `count` points of each arc, alternately at given V0 and at given σ.
///
/// The points are spread over each arc from where its asymptotes are off by 10⁻⁶ on one end to the same on the other; the
/// section goes through the f64 nearest to the point's coordinate, taken exactly.
#[must_use]
pub fn compare_routes(slider: &Slider<Rational>, count: usize, digits: u32) -> RouteComparison {
    let curve = BoundaryCurve::new(slider, digits);
    let mut comparison =
        RouteComparison { compared: 0, disagreements: Vec::new(), largest_difference: Float::new(32) };
    for &arc in curve.arcs() {
        for (index, parameter) in curve.sample_parameters(count, 1e-6).iter().enumerate() {
            let place = curve.position(arc, parameter);
            let section = if index % 2 == 0 {
                short_rational(&place.loading_velocity_m_per_s).map(Section::AtVelocity)
            } else {
                short_rational(&place.normal_stress_pa).map(Section::AtNormalStress)
            };
            if let Some(section) = section {
                comparison.add(slider, &curve, section, digits);
            }
        }
    }
    comparison
}

impl RouteComparison {
    fn add(&mut self, slider: &Slider<Rational>, curve: &BoundaryCurve, section: Section, digits: u32) {
        let along_curve = in_order(curve, &section);
        // Undecided is no agreement either.
        let of_discriminant = by_discriminant(slider, &section, digits).unwrap_or_default();
        let separators = separators(&along_curve);
        let mut agree = along_curve.len() == of_discriminant.len();
        for (index, (first, second)) in along_curve.iter().zip(&of_discriminant).enumerate() {
            let bracket = (&separators[index], &separators[index + 1]);
            let third = by_bisection(slider, &section, bracket, digits);
            agree &=
                first.1 == second.kind && self.agree([Some(&first.0), Some(&second.value), third.as_ref()]);
        }
        if !agree {
            self.disagreements.push(section);
        }
    }

    /// Whether the three enclosures overlap pairwise; notes how far the true values can be apart.
    fn agree(&mut self, answers: [Option<&Ball>; 3]) -> bool {
        let [Some(curve), Some(discriminant), Some(bisection)] = answers else { return false };
        for (one, other) in [(curve, discriminant), (curve, bisection), (discriminant, bisection)] {
            let difference = (one.clone() - other) / one;
            let bound = Float::with_val(32, difference.lower().abs())
                .max(&Float::with_val(32, difference.upper().abs()));
            if bound > self.largest_difference {
                self.largest_difference = bound;
            }
        }
        self.compared += 1;
        curve.overlaps(discriminant) && curve.overlaps(bisection) && discriminant.overlaps(bisection)
    }
}

type Located = (Ball, SolutionKind);

/// The coordinates of the curve's crossings, ascending, with their arcs.
fn in_order(curve: &BoundaryCurve, section: &Section) -> Vec<Located> {
    let crossings = curve.crossings(section).into_iter();
    let mut located: Vec<Located> =
        crossings.map(|crossing| (section.sought(crossing.position), crossing.arc.into())).collect();
    located.sort_by(|x, y| x.0.centre().total_cmp(y.0.centre()));
    located
}

/// Numbers that keep the answers apart: half the first, the middles, twice the last. The class must differ between
/// neighbouring ones, which bisection finds out for itself.
fn separators(located: &[Located]) -> Vec<Rational> {
    let centres: Vec<Rational> =
        located.iter().map(|(ball, _)| ball.centre().to_rational().unwrap_or_default()).collect();
    let mut separators = Vec::with_capacity(centres.len() + 1);
    separators.extend(centres.first().map(|first| first.clone() / 2_u32));
    separators.extend(centres.windows(2).map(|pair| Rational::from(&pair[0] + &pair[1]) / 2_u32));
    separators.extend(centres.last().map(|last| last.clone() * 2_u32));
    separators
}

/// The nearest 53-bit number, as a rational.
fn short_rational(value: &Ball) -> Option<Rational> {
    Float::with_val(53, value.centre()).to_rational()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_decimal;
    use crate::stability::fixtures::{paper, with_effects};

    fn compare(ratio: &Rational, count: usize, digits: u32) -> usize {
        let a = Rational::from((4, 1000));
        let b = Rational::from(&a * ratio);
        let comparison = compare_routes(&with_effects(a, b), count, digits);
        assert!(comparison.disagreements.is_empty(), "beta {ratio}: {:?}", comparison.disagreements);
        // Enclosures of relative radius 10^-digits that overlap are at most four radii apart.
        let limit = parse_decimal(&format!("4e-{digits}")).unwrap();
        assert!(comparison.largest_difference < limit, "beta {ratio}: {}", comparison.largest_difference);
        comparison.compared
    }

    #[test]
    fn the_three_routes_agree_to_fifty_digits_for_every_ratio_of_effects() {
        let ratios = [
            "1e-3",
            "3e-3",
            "0.01",
            "0.03",
            "0.1",
            "0.2",
            "0.3",
            "0.5",
            "0.7",
            "0.9",
            "0.99",
            "0.9999",
            "0.999999999999",
            "1",
            "1.000000000001",
            "1.0001",
            "1.01",
            "1.1",
            "1.3",
            "1.5",
            "2",
            "3",
            "5",
            "10",
            "30",
            "100",
            "300",
            "1000",
        ];
        let compared: usize = ratios.iter().map(|text| compare(&parse_decimal(text).unwrap(), 40, 50)).sum();
        assert!(compared >= 2_000, "{compared}");
    }

    #[test]
    fn the_three_routes_agree_to_a_thousand_digits() {
        let ratios = ["0.001", "0.7", "1", "1.5", "1000"];
        let compared: usize =
            ratios.iter().map(|text| compare(&parse_decimal(text).unwrap(), 2, 1_000)).sum();
        assert!(compared >= 10, "{compared}");
    }

    /// The leading coefficient of the curve's equation cancels there to as many digits as σ agrees with its asymptote's.
    #[test]
    fn lines_next_to_the_stress_of_a_quasi_static_asymptote_lose_no_crossing() {
        for distance in ["4e-20", "-4e-40", "4e-57", "4e-200"] {
            let excess = parse_decimal(distance).unwrap();
            let slider = with_effects(Rational::from((4, 1000)), (excess.clone() + 1_u32) * 4_u32 / 1000_u32);
            let square = Rational::from(excess.square_ref());
            // Eq 16 lies at κ = 4 + 2(β − 1) nearly, eq 15 at a quarter of (β − 1)².
            let all =
                [excess.clone() + 4_u32, excess * 3_u32 + 4_u32, square.clone() / 5_u32, square / 3_u32];
            for (kappa, digits) in all.iter().flat_map(|kappa| [15, 50].map(|digits| (kappa, digits))) {
                let stress = crossing_stress(&slider, kappa);
                let section = Section::AtNormalStress(stress);
                let curve = in_order(&BoundaryCurve::new(&slider, digits), &section);
                let isolated = by_discriminant(&slider, &section, digits).unwrap();
                assert_eq!(curve.len(), isolated.len(), "{distance} {digits} {kappa}");
                for (one, other) in curve.iter().zip(&isolated) {
                    assert!(
                        one.0.overlaps(&other.value) && one.1 == other.kind,
                        "{distance} {digits} {kappa}"
                    );
                    assert!(one.0.relative_radius_log2() < -3.3 * f64::from(digits), "{distance} {digits}");
                }
            }
        }
    }

    /// σ at which κ has this value.
    fn crossing_stress(slider: &Slider<Rational>, kappa: &Rational) -> Rational {
        slider.stress_scale_pa() / kappa
    }

    #[test]
    fn the_papers_values_are_compared_too() {
        assert!(compare_routes(&paper(), 20, 50).compared > 40);
    }
}
