//! The family of cycles of a slider whose stiffness is free: each member is found with the stiffness at which it has a given size.
//!
//! A simulation can only end on a stable cycle, and never on the edge of stability. With the size given and the stiffness sought,
//! Newton's method on the return map finds stable and unstable members alike, and passes the fold where two members merge.

use super::integrator::{Control, Integrator};
use super::lap::{Lap, LapEnd, run_lap};
use super::settle::Cycle;
use super::{Failure, Model, Radau, floquet_multipliers};
use crate::friction::{EvolutionLaw, Groups};

/// The cycles of a slider with given η, β and law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CycleFamily {
    /// The evolution law.
    pub law: EvolutionLaw,
    /// η.
    pub inertial_parameter: f64,
    /// β.
    pub effect_ratio: f64,
    /// Local tolerance of the laps.
    pub local_tolerance: f64,
}

/// One cycle and the stiffness that it needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// κ.
    pub stiffness_group: f64,
    /// The cycle, from one upward passage of V = V_l to the next.
    pub lap: Lap<f64>,
}

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

/// What Newton's method solves for: logarithms of the imbalance ζ − φ at the passage and of κ.
type Unknowns = [f64; 2];

/// Newton's method ends when both unknowns move by less than this; a lap has an error of about 1e-12.
const CLOSED: f64 = 1e-10;

/// Where η is small the imbalance is a small difference with few digits. Changes below this that no longer shrink are its rounding.
const ROUNDING: f64 = 1e-6;

/// Differences for the derivative: larger than the root of the lap's error, small beside 1.
const DIFFERENCE: f64 = 1e-5;

/// Most iterations; a prediction from neighbouring members needs two or three.
const MOST_ITERATIONS: u64 = 20;

/// The largest change of a logarithm in one iteration.
const LARGEST_CHANGE: f64 = 1.0;

/// Most steps of a lap.
const MOST_STEPS: u64 = 100_000;

impl CycleFamily {
    /// The member whose spring stress at the upward passage of V = V_l is `stress` (ζ > 0).
    ///
    /// The guess is ζ − φ at the passage and κ.
    ///
    /// # Errors
    /// Those of the integrator, and [`Failure::Undecided`] when Newton's method does not end.
    pub fn member(&self, stress: f64, guess: [f64; 2]) -> Result<Member, Failure> {
        let mut unknowns = guess.map(libm::log);
        let mut change = f64::INFINITY;
        for _ in 0..MOST_ITERATIONS {
            let residual = self.residual(stress, unknowns)?;
            let step = self.newton_step(stress, unknowns, residual)?;
            let last = change;
            change = step[0].abs().max(step[1].abs());
            let share = (LARGEST_CHANGE / change).min(1.0);
            unknowns = [unknowns[0] + share * step[0], unknowns[1] + share * step[1]];
            if change < CLOSED || change < ROUNDING && change > 0.5 * last {
                let lap = self.lap(stress, unknowns)?;
                return Ok(Member { stiffness_group: libm::exp(unknowns[1]), lap });
            }
        }
        Err(Failure::Undecided { cycles: MOST_ITERATIONS, change })
    }

    /// The members from a known one on, each larger than the one before by a factor in stress, as long as `go_on` says so of the last
    /// one; ends early where Newton's method does.
    #[must_use]
    pub fn follow(&self, first: Member, factor: f64, go_on: impl Fn(&Member) -> bool) -> Vec<Member> {
        let mut members = vec![first];
        while let Some(last) = members.last().filter(|last| go_on(last)) {
            let here = [self.imbalance(last), last.stiffness_group];
            let guess = match members.len().checked_sub(2).map(|index| &members[index]) {
                Some(before) => {
                    let there = [self.imbalance(before), before.stiffness_group];
                    [0, 1].map(|n| here[n] * here[n] / there[n])
                }
                None => [factor * here[0], here[1]],
            };
            match self.member(factor * last.lap.end[2], guess) {
                Ok(next) => members.push(next),
                Err(_) => break,
            }
        }
        members
    }

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
        let mut width = libm::log(middle.lap.end[2] / before.lap.end[2]);
        for _ in 0..HALVINGS {
            width *= 0.5;
            for side in [self.beside(&best, -width)?, self.beside(&best, width)?] {
                if side.stiffness_group > best.stiffness_group {
                    best = side;
                }
            }
        }
        let member = self.vertex(&best, width)?;
        let raised = (member.stiffness_group / best.stiffness_group - 1.0).abs();
        Ok(Some(Fold { member, relative_error: 2.0 * raised + ROUNDING_OF_STIFFNESS }))
    }

    /// The member at a logarithmic distance in stress.
    fn beside(&self, member: &Member, shift: f64) -> Result<Member, Failure> {
        let factor = libm::exp(shift);
        self.member(factor * member.lap.end[2], [factor * self.imbalance(member), member.stiffness_group])
    }

    /// The member at the top of the parabola through this one, which is the highest, and its neighbours.
    fn vertex(&self, middle: &Member, width: f64) -> Result<Member, Failure> {
        let height = |member: &Member| libm::log(member.stiffness_group / middle.stiffness_group);
        let (below, above) = (height(&self.beside(middle, -width)?), height(&self.beside(middle, width)?));
        let curvature = above + below;
        if curvature < 0.0 {
            self.beside(middle, -0.5 * width * (above - below) / curvature)
        } else {
            Ok(middle.clone())
        }
    }

    /// The member at a stiffness between those of two members, by the secant that keeps the bracket (the Illinois rule).
    ///
    /// # Errors
    /// Those of [`CycleFamily::member`], and [`Failure::Undecided`] when the stiffness is not between theirs.
    pub fn between(&self, ends: [&Member; 2], stiffness_group: f64) -> Result<Member, Failure> {
        let height = |member: &Member| libm::log(member.stiffness_group / stiffness_group);
        let place = |member: &Member| libm::log(member.lap.end[2]);
        let [mut one, mut other] = ends.map(|end| (place(end), height(end)));
        let mut nearest = ends[0].clone();
        if one.1 * other.1 > 0.0 {
            return Err(Failure::Undecided { cycles: 0, change: one.1 });
        }
        for _ in 0..MOST_ITERATIONS {
            let to = other.0 - other.1 * (other.0 - one.0) / (other.1 - one.1);
            nearest = self.beside(&nearest, to - place(&nearest))?;
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

    /// The leading Floquet multiplier's real part: above 1 the member is unstable.
    ///
    /// # Errors
    /// Those of the integrator.
    pub fn leading_multiplier(&self, member: &Member) -> Result<f64, Failure> {
        let cycle = Cycle { lap: member.lap.clone(), laps_per_cycle: 1, contraction: None, distance: 0.0 };
        floquet_multipliers(&self.model(member.stiffness_group), &cycle).map(|[leading, _]| leading.0)
    }

    /// ζ − φ at a member's passage.
    #[must_use]
    pub fn imbalance(&self, member: &Member) -> f64 {
        member.lap.end[2] - self.effect_ratio * member.lap.end[1]
    }

    fn model(&self, stiffness_group: f64) -> Model<f64> {
        let groups = Groups {
            inertial_parameter: self.inertial_parameter,
            stiffness_group,
            effect_ratio: self.effect_ratio,
        };
        Model::new(groups, self.law)
    }

    fn lap(&self, stress: f64, [imbalance, stiffness]: Unknowns) -> Result<Lap<f64>, Failure> {
        let model = self.model(libm::exp(stiffness));
        let start = [0.0, (stress - libm::exp(imbalance)) / self.effect_ratio, stress];
        let control = Control { local_tolerance: self.local_tolerance, most_steps: MOST_STEPS };
        let mut run = Integrator::new(&model, Radau::<f64, 5>::new(), start, control)?;
        match run_lap(&mut run)? {
            (lap, LapEnd::Rise) => Ok(lap),
            (_, LapEnd::Quiet) => Err(Failure::Undecided { cycles: 1, change: 1.0 }),
        }
    }

    /// How far the logarithms of imbalance and stress move in one lap.
    fn residual(&self, stress: f64, unknowns: Unknowns) -> Result<[f64; 2], Failure> {
        let end = self.lap(stress, unknowns)?.end;
        let imbalance = end[2] - self.effect_ratio * end[1];
        Ok([libm::log(imbalance) - unknowns[0], libm::log(end[2] / stress)])
    }

    fn newton_step(&self, stress: f64, at: Unknowns, residual: [f64; 2]) -> Result<Unknowns, Failure> {
        let column = |n: usize| {
            let mut moved = at;
            moved[n] += DIFFERENCE;
            let there = self.residual(stress, moved)?;
            Ok([0, 1].map(|m| (there[m] - residual[m]) / DIFFERENCE))
        };
        let ([a, c], [b, d]) = (column(0)?, column(1)?);
        let determinant = a * d - b * c;
        Ok([
            (b * residual[1] - d * residual[0]) / determinant,
            (c * residual[0] - a * residual[1]) / determinant,
        ])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EFFECT_RATIO: f64 = 1.5;

    fn family(law: EvolutionLaw, inertial_parameter: f64) -> CycleFamily {
        CycleFamily { law, inertial_parameter, effect_ratio: EFFECT_RATIO, local_tolerance: 1e-8 }
    }

    fn critical(family: &CycleFamily) -> f64 {
        (family.effect_ratio - 1.0) * (1.0 + family.inertial_parameter)
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
            let smaller = member.lap.end[2] < fold.member.lap.end[2];
            let multiplier = family.leading_multiplier(member).unwrap();
            assert_eq!(multiplier > 1.0, smaller, "{multiplier} {member:?}");
            assert!(member.stiffness_group < fold.member.stiffness_group);
        }
        assert!((family.leading_multiplier(&fold.member).unwrap() - 1.0).abs() < 1e-3);
    }

    #[test]
    fn the_edge_does_not_depend_on_the_tolerance_of_the_laps() {
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
        assert!((member.lap.peak - simulated.log_peak()).abs() < 1e-8, "{member:?}");
    }
}
