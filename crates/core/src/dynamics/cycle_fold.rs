//! The fold of a family of cycles, where its stable and unstable members merge, and its members at a given stiffness.

use super::Failure;
use super::cycle_family::{CLOSED, CycleFamily, MOST_ITERATIONS, Member};

/// The edge of the stretch of stiffnesses at which a family has cycles.
#[derive(Debug, Clone, PartialEq)]
pub struct Fold {
    /// The member on the edge.
    pub member: Member,
    /// Estimated relative error of its κ: twice the height of the last parabola over its middle.
    pub relative_error: f64,
}

/// How often the bracket of a fold is halved before a parabola takes over: neighbours a tenth apart end a third of a percent apart.
const HALVINGS: u32 = 5;

/// Relative error of κ that Newton's method leaves.
const ROUNDING_OF_STIFFNESS: f64 = 1e-12;

impl CycleFamily {
    /// The member of greatest stiffness: where two members merge and beyond which there is none. Nothing when the stiffness has no
    /// greatest value inside the stretch.
    ///
    /// # Errors
    /// Those of [`CycleFamily::member`].
    pub fn fold(&self, members: &[Member]) -> Result<Option<Fold>, Failure> {
        let stiffest = |three: &&[Member]| {
            let [before, middle, after] = three else { return false };
            middle.stiffness_group > before.stiffness_group && middle.stiffness_group >= after.stiffness_group
        };
        let Some([before, middle, _]) = members.windows(3).find(stiffest) else { return Ok(None) };
        let mut best = middle.clone();
        let mut width = libm::log(middle.orbit.end[2] / before.orbit.end[2]);
        for _ in 0..HALVINGS {
            width *= 0.5;
            for side in [self.neighbour(&best, -width)?, self.neighbour(&best, width)?] {
                if side.stiffness_group > best.stiffness_group {
                    best = side;
                }
            }
        }
        let member = self.vertex(&best, width)?;
        let raised = (member.stiffness_group / best.stiffness_group - 1.0).abs();
        Ok(Some(Fold { member, relative_error: 2.0 * raised + ROUNDING_OF_STIFFNESS }))
    }

    /// The member at the top of the parabola through this one, which is the highest, and its neighbours.
    fn vertex(&self, middle: &Member, width: f64) -> Result<Member, Failure> {
        let height = |member: &Member| libm::log(member.stiffness_group / middle.stiffness_group);
        let (below, above) =
            (height(&self.neighbour(middle, -width)?), height(&self.neighbour(middle, width)?));
        let curvature = above + below;
        if curvature < 0.0 {
            self.neighbour(middle, -0.5 * width * (above - below) / curvature)
        } else {
            Ok(middle.clone())
        }
    }

    /// The cycles at a stiffness, in the order of their size: one between each two neighbours of the followed members on either side of it.
    pub fn at<'m>(
        &'m self,
        members: &'m [Member],
        stiffness_group: f64,
    ) -> impl DoubleEndedIterator<Item = Result<Member, Failure>> + 'm {
        let stiffer = move |member: &Member| member.stiffness_group > stiffness_group;
        let pairs = members.windows(2).filter(move |pair| stiffer(&pair[0]) != stiffer(&pair[1]));
        pairs.map(move |pair| self.between([&pair[0], &pair[1]], stiffness_group))
    }

    /// The member at a stiffness between those of two members, by the secant that keeps the bracket (the Illinois rule).
    ///
    /// # Errors
    /// Those of [`CycleFamily::member`], and [`Failure::Undecided`] when the stiffness is not between theirs.
    pub fn between(&self, ends: [&Member; 2], stiffness_group: f64) -> Result<Member, Failure> {
        let height = |member: &Member| libm::log(member.stiffness_group / stiffness_group);
        let place = |member: &Member| libm::log(member.orbit.end[2]);
        let [mut one, mut other] = ends.map(|end| (place(end), height(end)));
        let mut nearest = ends[0].clone();
        if one.1 * other.1 > 0.0 {
            return Err(Failure::Undecided { cycles: 0, change: one.1 });
        }
        for _ in 0..MOST_ITERATIONS {
            let to = other.0 - other.1 * (other.0 - one.0) / (other.1 - one.1);
            nearest = self.neighbour(&nearest, to - place(&nearest))?;
            let reached = height(&nearest);
            if reached.abs() <= ROUNDING_OF_STIFFNESS {
                return Ok(nearest);
            }
            one = if reached * other.1 < 0.0 { other } else { (one.0, 0.5 * one.1) };
            other = (to, reached);
        }
        let change = height(&nearest).abs();
        if change < CLOSED {
            Ok(nearest)
        } else {
            Err(Failure::Undecided { cycles: MOST_ITERATIONS, change })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Model;
    use crate::friction::{EvolutionLaw, Groups, critical_stiffness_group};

    const EFFECT_RATIO: f64 = 1.5;

    fn family(law: EvolutionLaw, inertial_parameter: f64) -> CycleFamily {
        CycleFamily { law, inertial_parameter, effect_ratio: EFFECT_RATIO, local_tolerance: 1e-8 }
    }

    fn critical(family: &CycleFamily) -> f64 {
        critical_stiffness_group(&family.effect_ratio, &family.inertial_parameter)
    }

    /// From an amplitude of 0.05 of ln(V/V_l), where the cycle is nearly that of the linear equations.
    fn members(family: &CycleFamily) -> Vec<Member> {
        let imbalance = 0.05 * (EFFECT_RATIO - 1.0).sqrt() * family.inertial_parameter;
        let stress = imbalance * (1.0 + family.inertial_parameter) / family.inertial_parameter;
        let first = family.member(stress, [imbalance, critical(family)]).unwrap();
        family.follow(first, 1.1, |member| member.stiffness_group > 0.98 * critical(family))
    }

    #[test]
    fn stability_changes_at_the_fold_of_the_aging_law() {
        let family = family(EvolutionLaw::Aging, 0.03);
        let members = members(&family);
        let fold = family.fold(&members).unwrap().unwrap();
        for member in &members {
            let smaller = member.orbit.end[2] < fold.member.orbit.end[2];
            let multiplier = family.leading_multiplier(member).unwrap();
            assert_eq!(multiplier > 1.0, smaller, "{multiplier} {member:?}");
            assert!(member.stiffness_group < fold.member.stiffness_group);
        }
        assert!((family.leading_multiplier(&fold.member).unwrap() - 1.0).abs() < 1e-3);
    }

    #[test]
    fn the_edge_does_not_depend_on_the_tolerance_of_the_returns() {
        let loose = family(EvolutionLaw::Aging, 0.003);
        let tight = CycleFamily { local_tolerance: 1e-9, ..loose };
        let [one, other] = [loose, tight].map(|family| family.fold(&members(&family)).unwrap().unwrap());
        let difference = (one.member.stiffness_group / other.member.stiffness_group - 1.0).abs();
        assert!(difference < one.relative_error, "{difference:e} {:e}", one.relative_error);
        assert!(one.relative_error < 1e-6, "{:e}", one.relative_error);
    }

    #[test]
    fn the_slip_law_has_no_fold_and_no_cycle_above_the_critical_stiffness() {
        let family = family(EvolutionLaw::Slip, 0.03);
        let members = members(&family);
        assert_eq!(family.fold(&members), Ok(None));
        assert!(members.len() > 3 && members.iter().all(|member| member.stiffness_group < critical(&family)));
    }

    #[test]
    fn a_stable_member_is_the_cycle_on_which_a_simulation_ends() {
        let family = family(EvolutionLaw::Slip, 1.0);
        let members = members(&family);
        let wanted = 0.99 * critical(&family);
        let pair = members.windows(2).find(|pair| pair[1].stiffness_group < wanted).unwrap();
        let member = family.between([&pair[0], &pair[1]], wanted).unwrap();
        let groups = Groups { inertial_parameter: 1.0, stiffness_group: wanted, effect_ratio: EFFECT_RATIO };
        let model = Model::new(groups, EvolutionLaw::Slip);
        let simulated =
            crate::dynamics::simulate_model(&model, &crate::dynamics::Options::default()).unwrap();
        assert!((member.orbit.peak - simulated.log_peak()).abs() < 1e-8, "{member:?}");
    }
}
