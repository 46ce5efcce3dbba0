//! The family of cycles of a slider whose stiffness is free: each member is found with the stiffness at which it has a given size.
//!
//! A simulation can only end on a stable cycle, and never on the edge of stability. With the size given and the stiffness sought,
//! Newton's method on the return map finds stable and unstable members alike, and passes the fold where two members merge.

use super::floquet::floquet_multipliers;
use super::integrator::{Control, Integrator, Work};
use super::long_term::Cycle;
use super::section_return::{Return, ReturnEnd, next_return};
use super::{Failure, Model, Radau};
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
    /// Local tolerance of the returns.
    pub local_tolerance: f64,
}

/// One cycle and the stiffness that it needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// κ.
    pub stiffness_group: f64,
    /// The cycle, from one upward crossing of V = V_l to the next.
    pub orbit: Return<f64>,
    /// What it cost to find.
    pub(super) work: Work,
}

impl Member {
    /// The cycle of a run that begins on it: a member closes on itself, and begins where it ends.
    #[must_use]
    pub fn cycle(&self) -> Cycle<f64> {
        let (orbit, from) = (self.orbit.clone(), self.orbit.end);
        Cycle { orbit, returns_per_cycle: 1, contraction: None, distance: 0.0, from }
    }
}

/// What Newton's method solves for: logarithms of the imbalance ζ − φ at the crossing and of κ.
type Unknowns = [f64; 2];

/// Newton's method ends when both unknowns move by less than this; a return has an error of about 1e-12.
pub(super) const CLOSED: f64 = 1e-10;

/// Where η is small the imbalance is a small difference with few digits. Changes below this that no longer shrink are its rounding.
const ROUNDING: f64 = 1e-6;

/// Differences for the derivative: larger than the root of the return's error, small compared with 1.
const DIFFERENCE: f64 = 1e-5;

/// Most iterations; a prediction from neighbouring members needs two or three.
pub(super) const MOST_ITERATIONS: u64 = 20;

/// The largest change of a logarithm in one iteration.
const LARGEST_CHANGE: f64 = 1.0;

/// Most steps of a return.
const MOST_STEPS: u64 = 100_000;

impl CycleFamily {
    /// The member whose spring stress at the upward crossing of V = V_l is `stress` (ζ > 0).
    ///
    /// The guess is ζ − φ at the crossing and κ.
    ///
    /// # Errors
    /// Those of the integrator, and [`Failure::Undecided`] when Newton's method does not end.
    pub fn member(&self, stress: f64, guess: [f64; 2]) -> Result<Member, Failure> {
        let mut unknowns = guess.map(libm::log);
        let (mut change, mut work) = (f64::INFINITY, Work::default());
        for _ in 0..MOST_ITERATIONS {
            let residual = self.residual(stress, unknowns, &mut work)?;
            let step = self.newton_step(stress, unknowns, residual, &mut work)?;
            let last = change;
            change = step[0].abs().max(step[1].abs());
            let share = (LARGEST_CHANGE / change).min(1.0);
            unknowns = [unknowns[0] + share * step[0], unknowns[1] + share * step[1]];
            if change < CLOSED || change < ROUNDING && change > 0.5 * last {
                let orbit = self.orbit(stress, unknowns, &mut work)?;
                return Ok(Member { stiffness_group: libm::exp(unknowns[1]), orbit, work });
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
            match self.member(factor * last.orbit.end[2], guess) {
                Ok(next) => members.push(next),
                Err(_) => break,
            }
        }
        members
    }

    /// The member at a logarithmic distance in stress.
    pub(super) fn neighbour(&self, member: &Member, shift: f64) -> Result<Member, Failure> {
        let factor = libm::exp(shift);
        self.member(factor * member.orbit.end[2], [factor * self.imbalance(member), member.stiffness_group])
    }

    /// The leading Floquet multiplier's real part: above 1 the member is unstable.
    ///
    /// # Errors
    /// Those of the integrator.
    pub fn leading_multiplier(&self, member: &Member) -> Result<f64, Failure> {
        floquet_multipliers(&self.model(member.stiffness_group), &member.cycle())
            .map(|[leading, _]| leading.0)
    }

    /// ζ − φ at a member's crossing.
    pub(crate) fn imbalance(&self, member: &Member) -> f64 {
        member.orbit.end[2] - self.effect_ratio * member.orbit.end[1]
    }

    fn model(&self, stiffness_group: f64) -> Model<f64> {
        let groups = Groups {
            inertial_parameter: self.inertial_parameter,
            stiffness_group,
            effect_ratio: self.effect_ratio,
        };
        Model::new(groups, self.law)
    }

    fn orbit(
        &self,
        stress: f64,
        [imbalance, stiffness]: Unknowns,
        work: &mut Work,
    ) -> Result<Return<f64>, Failure> {
        let model = self.model(libm::exp(stiffness));
        let start = [0.0, (stress - libm::exp(imbalance)) / self.effect_ratio, stress];
        let control = Control { local_tolerance: self.local_tolerance, most_steps: MOST_STEPS };
        let mut run = Integrator::new(&model, Radau::<f64, 5>::new(), start, control)?;
        let found = next_return(&mut run)?;
        *work += run.work();
        match found {
            (orbit, ReturnEnd::Crossing) => Ok(orbit),
            (_, ReturnEnd::AtRest) => Err(Failure::Undecided { cycles: 1, change: 1.0 }),
        }
    }

    /// How far the logarithms of imbalance and stress move in one return.
    fn residual(&self, stress: f64, unknowns: Unknowns, work: &mut Work) -> Result<[f64; 2], Failure> {
        let end = self.orbit(stress, unknowns, work)?.end;
        let imbalance = end[2] - self.effect_ratio * end[1];
        Ok([libm::log(imbalance) - unknowns[0], libm::log(end[2] / stress)])
    }

    fn newton_step(
        &self,
        stress: f64,
        at: Unknowns,
        residual: [f64; 2],
        work: &mut Work,
    ) -> Result<Unknowns, Failure> {
        let mut column = |n: usize| {
            let mut moved = at;
            moved[n] += DIFFERENCE;
            let there = self.residual(stress, moved, work)?;
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
