//! The smallest kicks that end stable steady sliding, each compared with the unstable cycle and with runs.

use std::cell::Cell;

use crate::experiments::near_transition::KicksSection;
use crate::experiments::near_transition::bistability::ends_on_cycle;
use crate::experiments::near_transition::cycle_families::CycleFamilyOutcome;
use crate::parallel;
use slipmode_core::dynamics::{Failure, Kick, Model};
use slipmode_core::friction::{EvolutionLaw, Groups, critical_stiffness_group};
use slipmode_core::number::{Rational, nearest_f64};

/// The smallest kick of one kind.
#[derive(Debug, Clone)]
pub struct SmallestKick {
    /// The evolution law.
    pub law: EvolutionLaw,
    /// η.
    pub inertial_parameter: Rational,
    /// K/K_c.
    pub stiffness_over_critical: Rational,
    /// What changes suddenly.
    pub kick: Kick,
    /// Where the border lies between kicks that decay and kicks that do not; none when no tried kick ends steady sliding.
    pub border: Result<Option<Border>, Failure>,
    /// Lower bound, value by Newton's method and upper bound of ln(V_peak/V_l) of the unstable cycle, where it is proved.
    pub unstable_log_peak: Option<[f64; 3]>,
    /// K/K_c at the limit of bistability, and its error; none where the law has none.
    pub fold_over_critical: Option<[f64; 2]>,
}

/// The border between kicks that decay and kicks that do not; each pair is of a kick below and of one above it.
#[derive(Debug, Clone, PartialEq)]
pub struct Border {
    /// V/V_l − 1, or the change of stress over aσ.
    pub changes: [f64; 2],
    /// ln(V_peak/V_l) when the run moves along the slow direction.
    pub log_peaks: [f64; 2],
    /// Whether runs from kicks that are smaller and larger by 5 % end in sliding and on a cycle; none when one has no result.
    pub confirmed: Option<bool>,
}

/// Part of a kick by which runs that confirm the border are moved off it.
const APART: f64 = 0.05;

/// Searches the smallest kicks of both laws.
pub(crate) fn smallest_kicks(section: &KicksSection, families: &[CycleFamilyOutcome]) -> Vec<SmallestKick> {
    let families = families.iter().filter(|family| family.inertial_parameter == section.inertial_parameter);
    let ratios = |family| section.stiffness_over_critical.iter().map(move |ratio| (family, ratio));
    let cases: Vec<_> = families.flat_map(ratios).collect();
    parallel::flat_map(&cases, |(family, ratio)| of_slider(family, ratio))
}

fn of_slider(family: &CycleFamilyOutcome, ratio: &Rational) -> [SmallestKick; 4] {
    let inertial_parameter = family.inertial_parameter.clone();
    let effect_ratio = family.effect_ratio.clone();
    let stiffness_group = critical_stiffness_group(&effect_ratio, &inertial_parameter) * ratio;
    let groups = Groups { inertial_parameter, stiffness_group, effect_ratio };
    let model = Model::new(groups.map(nearest_f64), family.law);
    let decayed = Cell::new(0.0);
    let edge = family.edge.as_ref().ok().and_then(Option::as_ref);
    let unstable_log_peak = family.unstable_log_peak_at(&groups);
    Kick::ALL.map(|kick| SmallestKick {
        law: family.law,
        inertial_parameter: groups.inertial_parameter.clone(),
        stiffness_over_critical: ratio.clone(),
        kick,
        border: kick
            .smallest(&model, &decayed)
            .and_then(|ends| ends.map(|ends| border(&model, kick, ends)).transpose()),
        unstable_log_peak,
        fold_over_critical: edge.map(|edge| [1.0 + edge.excess, edge.error]),
    })
}

fn border(model: &Model<f64>, kick: Kick, [decays, leaves]: [f64; 2]) -> Result<Border, Failure> {
    let periodic = |size| ends_on_cycle(model, kick.state(model, size)).ok();
    let ends = periodic((1.0 - APART) * decays).zip(periodic((1.0 + APART) * leaves));
    Ok(Border {
        changes: [kick.change(decays), kick.change(leaves)],
        log_peaks: [kick.late_peak(model, decays)?, kick.late_peak(model, leaves)?],
        confirmed: ends.map(|ends| ends == (false, true)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::near_transition::NearTransitionSection;
    use crate::experiments::near_transition::run::near_transition;
    use crate::experiments::shared::fixtures::paper;
    use slipmode_core::friction::EvolutionLaw::{Aging, Slip};
    use slipmode_core::number::parse_decimal;

    #[test]
    fn kicks_end_sliding_below_the_fold_of_the_aging_law_only_and_come_to_the_unstable_cycle() {
        let number = |text| parse_decimal(text).unwrap();
        let section = NearTransitionSection {
            inertial_parameter: Vec::new(),
            stiffness_over_critical: Vec::new(),
            edge_inertial_parameter: Vec::new(),
            tolerance: number("1e-6"),
            kicks: Some(KicksSection {
                inertial_parameter: number("0.025"),
                stiffness_over_critical: vec![number("1.003"), number("1.006")],
            }),
        };
        let found = near_transition(&paper(), &section).kicks;
        assert_eq!(found.len(), 16);
        for kick in &found {
            let border = kick.border.as_ref().unwrap();
            let fold = kick.fold_over_critical.map_or(0.0, |[fold, _]| fold);
            let ends = nearest_f64(&kick.stiffness_over_critical) < fold && kick.kick != Kick::VelocityDown;
            assert_eq!((border.is_some(), kick.law == Slip && ends), (ends, false), "{kick:?}");
            let Some(border) = border else { continue };
            let ([low, peak, high], [below, above]) = (kick.unstable_log_peak.unwrap(), border.log_peaks);
            assert!(below < high && low < above && above - below < 1e-5, "{kick:?}");
            // A member has its stiffness to a part of 1e-10, and its peak to 1e-10/(K/K_c − 1).
            assert!((0.5 * (below + above) - peak).abs() < 1e-7 + 0.5 * (above - below), "{kick:?}");
            assert_eq!(border.confirmed, Some(true), "{kick:?}");
        }
        assert_eq!(found.iter().filter(|kick| kick.law == Aging && kick.border != Ok(None)).count(), 3);
    }
}
