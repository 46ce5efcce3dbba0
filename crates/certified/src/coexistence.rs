//! Bistability: steady sliding and a larger limit cycle both attract, and a limit cycle between them repels.

use crate::attraction::Ellipsoid;
use crate::cycle::{Test, largest_multiplier, repels};
use crate::{Constants, Reason};
use slipmode_core::dynamics::{Member, Model};
use slipmode_core::friction::{EvolutionLaw, Groups};
use slipmode_core::number::{Rational, nearest_f64};

/// Three objects that are proved to exist at the same parameters: steady sliding, which attracts, and two limit cycles.
#[derive(Debug, Clone, PartialEq)]
pub struct Coexistence {
    /// Lower and upper bound of ln(V_peak/V_l) of the cycle that attracts.
    pub attracting_log_peak: [f64; 2],
    /// A bound of the sizes of its multipliers, below 1.
    pub contraction: f64,
    /// Lower and upper bound of ln(V_peak/V_l) of the cycle that repels, below those of the other.
    pub repelling_log_peak: [f64; 2],
}

/// Proves that steady sliding attracts and that two limit cycles exist, one that attracts and a smaller one that repels.
///
/// The members of a family of cycles say where to look for the two cycles; nothing depends on their accuracy.
///
/// # Errors
/// A [`Reason`] when one of the three is not proved.
pub fn certify_coexistence(
    groups: &Groups<Rational>,
    law: EvolutionLaw,
    attracting: &Member,
    repelling: &Member,
) -> Result<Coexistence, Reason> {
    let constants = Constants::of(groups, law);
    Ellipsoid::around_steady_sliding(&constants).ok_or(Reason::NoAttraction)?;
    let model = Model::new(groups.map(nearest_f64), law);
    let (_, crossing, observed) = Test::near(&constants, &model, &attracting.cycle())?;
    let contraction = largest_multiplier(&crossing.derivative);
    if !(contraction < 1.0) {
        return Err(Reason::NotAttracting);
    }
    let attracting_log_peak = observed.peak();
    let (_, crossing, observed) = Test::near(&constants, &model, &repelling.cycle())?;
    if !repels(&crossing.derivative) {
        return Err(Reason::NotRepelling);
    }
    separate(Coexistence { attracting_log_peak, contraction, repelling_log_peak: observed.peak() })
}

/// The three objects, if each peak of the cycle that repels is below each of the other: different peaks are those of different cycles.
fn separate(found: Coexistence) -> Result<Coexistence, Reason> {
    let is_below = found.repelling_log_peak[1] < found.attracting_log_peak[0];
    is_below.then_some(found).ok_or(Reason::NotSeparate)
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::dynamics::CycleFamily;
    use slipmode_core::friction::critical_stiffness_group;
    use slipmode_core::number::parse_decimal;

    /// η with β = 3/2 and the aging law, half-way from K_c to the fold: the groups, and the small and the large cycle.
    fn half_way(inertia: &str) -> (Groups<Rational>, [Member; 2]) {
        let (inertial_parameter, effect_ratio) = (parse_decimal(inertia).unwrap(), Rational::from((3, 2)));
        let critical = nearest_f64(&critical_stiffness_group(&effect_ratio, &inertial_parameter));
        let family = CycleFamily {
            law: EvolutionLaw::Aging,
            inertial_parameter: nearest_f64(&inertial_parameter),
            effect_ratio: nearest_f64(&effect_ratio),
            local_tolerance: 1e-8,
        };
        let turn = 0.05 * 0.5f64.sqrt();
        let guess = [turn * family.inertial_parameter, critical];
        let first = family.member(turn * (1.0 + family.inertial_parameter), guess).unwrap();
        let members = family.follow(first, 1.1, |member| member.stiffness_group > 0.99 * critical);
        let fold = family.fold(&members).unwrap().unwrap().member.stiffness_group;
        let stiffness_group = 0.5 * (critical + fold);
        let cycles = family.at(&members, stiffness_group).map(Result::unwrap).collect::<Vec<_>>();
        let stiffness_group = Rational::from_f64(stiffness_group).unwrap();
        (Groups { inertial_parameter, stiffness_group, effect_ratio }, cycles.try_into().unwrap())
    }

    #[test]
    fn three_objects_coexist_half_way_to_the_fold_and_no_fault_survives() {
        let mut refused = Vec::new();
        for inertia in ["0.02", "0.1"] {
            let (groups, [small, large]) = half_way(inertia);
            let certify =
                |groups: &Groups<Rational>, law, large, small| certify_coexistence(groups, law, large, small);
            let found = certify(&groups, EvolutionLaw::Aging, &large, &small).unwrap();
            assert!(found.contraction < 1.0);
            for ([low, high], cycle) in
                [(found.attracting_log_peak, &large), (found.repelling_log_peak, &small)]
            {
                // The member's own error is that of a return, about 1e-8, over 1 less its multiplier.
                let peak = cycle.orbit.peak;
                assert!(high - low < 1e-8 && low - 1e-6 < peak && peak < high + 1e-6, "{low} {high} {peak}");
            }
            let stiffer = |by: (u32, u32)| Groups {
                stiffness_group: groups.stiffness_group.clone() * Rational::from(by),
                ..groups.clone()
            };
            let wrong = [
                certify(&groups, EvolutionLaw::Slip, &large, &small),
                certify(&groups, EvolutionLaw::Aging, &small, &small),
                certify(&groups, EvolutionLaw::Aging, &large, &large),
                certify(&groups, EvolutionLaw::Aging, &small, &large),
                certify(&stiffer((101, 100)), EvolutionLaw::Aging, &large, &small),
                certify(&stiffer((99, 100)), EvolutionLaw::Aging, &large, &small),
            ];
            refused.extend(wrong.into_iter().filter_map(Result::err));
        }
        assert_eq!(refused.len(), 12, "{refused:?}");
        for reason in [Reason::NoAttraction, Reason::NotAttracting, Reason::NotRepelling] {
            assert!(refused.contains(&reason), "{reason}: {refused:?}");
        }
    }

    /// Peaks that touch, overlap or come in the other order are refused.
    #[test]
    fn the_peak_that_repels_is_below_the_other_one() {
        let is_found = |attracting_log_peak, repelling_log_peak| {
            separate(Coexistence { attracting_log_peak, contraction: 0.5, repelling_log_peak }).is_ok()
        };
        let ends = [0.0, 1.0, 2.0, 3.0];
        let ranges = || ends.into_iter().flat_map(|low| ends.into_iter().map(move |high| [low, high]));
        for (first, second) in ranges().flat_map(|first| ranges().map(move |second| (first, second))) {
            if first[0] <= first[1] && second[0] <= second[1] {
                let numbers = |[low, high]: [f64; 2]| [low, 0.5 * (low + high), high];
                let all = numbers(first).iter().all(|a| numbers(second).iter().all(|b| a < b));
                assert_eq!(is_found(second, first), all, "{first:?} {second:?}");
            }
        }
        assert!(!is_found([1.0, 2.0], [0.0, f64::NAN]) && !is_found([f64::NAN, 2.0], [0.0, 1.0]));
    }
}
