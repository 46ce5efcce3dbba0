//! What certificates decide of limit cycles, from the ends of their enclosures; the runs decide where a certificate is missing.

use std::collections::BTreeSet;
use std::ptr::from_ref;

use crate::claims::simulated::{Run, Runs, error_of};
use crate::claims::{Evidence, Finding};
use crate::experiments::certificates::Certificates;
use slipmode_core::dynamics::certified::Certificate;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::stability::SlipMode;

/// Two neighbours, the one with the smaller coordinates first.
pub(super) type Pair<'r, 'c> = (&'r Run<'c>, &'r Run<'c>);

/// Whether a statement is true, and whether certificates decide it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Decided {
    pub(super) is_true: bool,
    pub(super) is_certified: bool,
}

impl Decided {
    /// By two enclosures that do not overlap, or else by the runs.
    fn larger(lower: Option<[f64; 2]>, upper: Option<[f64; 2]>, by_run: bool) -> Self {
        match (lower, upper) {
            (Some([_, high]), Some([low, _])) if low > high => Self { is_true: true, is_certified: true },
            (Some([low, _]), Some([_, high])) if high < low => Self { is_true: false, is_certified: true },
            _ => Self { is_true: by_run, is_certified: false },
        }
    }

    /// Both statements; one that is certified to be false decides alone.
    fn and(self, other: Self) -> Self {
        let refutes = |one: Self| one.is_certified && !one.is_true;
        let is_certified = refutes(self) || refutes(other) || (self.is_certified && other.is_certified);
        Self { is_true: self.is_true && other.is_true, is_certified }
    }

    /// The opposite.
    pub(super) const fn not(self) -> Self {
        Self { is_true: !self.is_true, is_certified: self.is_certified }
    }

    /// Certified only where the choice of the pair is certified too.
    pub(super) const fn among(self, choice_is_certified: bool) -> Self {
        Self { is_true: self.is_true, is_certified: self.is_certified && choice_is_certified }
    }
}

fn peak(run: &Run) -> Option<[f64; 2]> {
    run.certificate.map(|proof| proof.peak_velocity_m_per_s)
}

/// Whether the peak velocity rises from the first to the second.
pub(super) fn rises((first, second): &Pair) -> Decided {
    let by_run = second.simulation.peak_velocity_m_per_s > first.simulation.peak_velocity_m_per_s;
    Decided::larger(peak(first), peak(second), by_run)
}

/// Whether stress drop and period both rise from the first to the second.
pub(super) fn grows_and_slows((first, second): &Pair) -> Decided {
    let drop = |run: &Run| run.certificate.map(|proof| proof.stress_drop_pa);
    let period = |run: &Run| run.certificate.and_then(Certificate::period_s);
    let by_run = |of: fn(&Run) -> Option<f64>| of(second) > of(first);
    Decided::larger(drop(first), drop(second), by_run(|run| Some(run.simulation.stress_drop_pa)))
        .and(Decided::larger(period(first), period(second), by_run(|run| run.simulation.period_s)))
}

/// More than the error of the limit below, in 64 bits.
const ROUNDING: f64 = 1e-14;

/// Whether certificates prove that both runs are limit cycles of this mode: stick-slip has a period above √2 natural ones.
pub(super) fn both_certainly((first, second): &Pair, mode: SlipMode, natural_period_s: f64) -> bool {
    let limit = std::f64::consts::SQRT_2 * natural_period_s;
    let is = |run: &Run| {
        run.certificate.and_then(Certificate::period_s).is_some_and(|[low, high]| match mode {
            SlipMode::StickSlip => low > limit * (1.0 + ROUNDING),
            _ => high < limit * (1.0 - ROUNDING),
        })
    };
    is(first) && is(second)
}

/// Whether certificates prove that both runs are limit cycles.
pub(super) fn both_cycle((first, second): &Pair) -> bool {
    [first, second].into_iter().all(|run| run.certificate.and_then(Certificate::period_s).is_some())
}

/// Pairs of neighbours of several grids, and what is decided of each.
pub(super) struct Pairs<'r, 'c> {
    grids: &'r [Runs<'c>],
    pairs: Vec<(EvolutionLaw, Pair<'r, 'c>, Decided)>,
}

impl<'r, 'c> Pairs<'r, 'c> {
    pub(super) fn new<I: Iterator<Item = Pair<'r, 'c>>>(
        grids: &'r [Runs<'c>],
        pairs: impl Fn(&'r Runs<'c>) -> I,
        decide: impl Fn(&Pair<'r, 'c>) -> Decided,
    ) -> Self {
        let pairs = grids.iter().flat_map(|grid| {
            let decide = &decide;
            pairs(grid).map(move |pair| (grid.law, pair, decide(&pair)))
        });
        Self { grids, pairs: pairs.collect() }
    }

    pub(super) fn count(&self) -> usize {
        self.pairs.len()
    }

    pub(super) fn passed(&self) -> usize {
        self.pairs.iter().filter(|(_, _, decided)| decided.is_true).count()
    }

    /// `197 of 215`.
    pub(super) fn share(&self) -> String {
        format!("{} of {}", self.passed(), self.count())
    }

    /// A pair that does not pass, one with certificates if there is any.
    pub(super) fn failing(&self) -> Option<Pair<'r, 'c>> {
        let failing = || self.pairs.iter().filter(|(_, _, decided)| !decided.is_true);
        let certified = failing().find(|(_, _, decided)| decided.is_certified);
        certified.or_else(|| failing().next()).map(|(_, pair, _)| *pair)
    }

    /// The finding that all pairs pass, refuted by `counter_example` if one does not.
    pub(super) fn finding(&self, quantity: &str, counter_example: impl FnOnce(&Self) -> String) -> Finding {
        let refutes = self.of(true).any(|(_, _, decided)| !decided.is_true);
        let add = if refutes { Finding::with_supporting } else { Finding::with_evidence };
        let mut evidence = self.evidence(quantity).into_iter();
        let first = evidence.next().map(Finding::from_evidence);
        let finding = first.unwrap_or_else(|| Finding::not_checked("There are no neighbours."));
        let finding = evidence.fold(finding, add);
        finding.require(self.passed() == self.count(), || counter_example(self))
    }

    /// The pairs that certificates decide, then those that only the runs decide.
    pub(super) fn evidence(&self, quantity: &str) -> Vec<Evidence> {
        let is_enclosed = self.of(true).next().is_some();
        let enclosure = Evidence::Enclosure { quantity: quantity.into(), value: self.shares(true) };
        let runs: BTreeSet<_> =
            self.of(false).flat_map(|(_, pair, _)| [from_ref(pair.0), from_ref(pair.1)]).collect();
        let suffix = if is_enclosed { ", where a certificate is missing" } else { "" };
        let by_runs = Evidence::Simulation {
            quantity: format!("{quantity}{suffix}"),
            value: self.shares(false),
            error: error_of(self.grids),
            runs: runs.len(),
        };
        let has_runs = !runs.is_empty();
        [is_enclosed.then_some(enclosure), has_runs.then_some(by_runs)].into_iter().flatten().collect()
    }

    fn of(&self, is_certified: bool) -> impl Iterator<Item = &(EvolutionLaw, Pair<'r, 'c>, Decided)> {
        self.pairs.iter().filter(move |(_, _, decided)| decided.is_certified == is_certified)
    }

    /// `slip: 304 of 304; aging: 299 of 299`.
    fn shares(&self, is_certified: bool) -> String {
        let share = |grid: &Runs| {
            let of_law = |is_true: Option<bool>| {
                let chosen = self.of(is_certified).filter(|(law, _, _)| *law == grid.law);
                chosen
                    .filter(|(_, _, decided)| is_true.is_none_or(|wanted| decided.is_true == wanted))
                    .count()
            };
            let all = of_law(None);
            (all > 0).then(|| format!("{}: {} of {all}", grid.law.as_str(), of_law(Some(true))))
        };
        self.grids.iter().filter_map(share).collect::<Vec<_>>().join("; ")
    }
}

/// How many points have a certificate, and how many of these this run proved again; none without certificates.
pub(super) fn remark(certificates: Option<&Certificates>) -> Option<String> {
    let all = certificates?;
    Some(format!(
        "{} of {} grid points have a certificate; this run proved {} of them again.",
        all.count(),
        all.rows.len(),
        all.again.len(),
    ))
}

/// The first run that contradicts its certificate by more than its estimated error, in words.
pub(super) fn contradiction(run: &Run) -> Option<String> {
    let proof = run.certificate?;
    let found = run.simulation;
    let mut compared =
        vec![(proof.peak_velocity_m_per_s, found.peak_velocity_m_per_s, found.peak_relative_error)];
    if run.periodic() != proof.period_s().is_some() {
        return Some(format!("The long-term behaviour at {} is not the certified one.", run.place()));
    }
    if let Some(period) = proof.period_s() {
        compared.push((proof.stress_drop_pa, found.stress_drop_pa, found.stress_drop_relative_error));
        compared.extend(
            found.period_s.zip(found.period_relative_error).map(|(value, error)| (period, value, error)),
        );
    }
    let is_off = |([low, high], value, error): &([f64; 2], f64, f64)| {
        value * (1.0 + error) < *low || value * (1.0 - error) > *high
    };
    compared.iter().any(is_off).then(|| {
        format!("The run at {} differs from its certificate by more than its estimated error.", run.place())
    })
}

#[cfg(test)]
mod tests {
    use std::sync::OnceLock;

    use super::*;
    use crate::claims::Strength;
    use crate::claims::simulated_trends::{drop_and_period_fall, peak_rises};
    use crate::claims::{Finding, Verdict};
    use crate::experiments::certificates::certify_grid;
    use crate::experiments::shared::fixtures::paper;
    use crate::experiments::{Context, Need, Outcome, References, Scene, run};
    use crate::scene::{Limits, read_equations};

    const SCENE: &str = "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
        critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n[simulations]\n\
        loading_velocity_m_per_s = { from = 1e-4, to = 1e-3, points = 2 }\n\
        normal_stress_pa = { from = 1e5, to = 2e5, points = 2 }\nlaws = [\"slip\"]\ntolerance = 1e-8\n";

    /// Four stick-slip cycles with their certificates; `alter` changes these before the claims see them.
    fn outcome(alter: impl FnOnce(&mut Certificates)) -> Outcome {
        static UNALTERED: OnceLock<Outcome> = OnceLock::new();
        let mut outcome = UNALTERED.get_or_init(certified_outcome).clone();
        alter(outcome.scenes[0].certificates.as_mut().unwrap());
        outcome
    }

    fn certified_outcome() -> Outcome {
        let scene = Scene::parse("s.toml", SCENE.as_bytes(), &Limits::default()).unwrap();
        let rows = certify_grid(&paper(), scene.simulations.as_ref().unwrap(), EvolutionLaw::Slip);
        let mut outcome = run(&[scene], &[Need::Simulations].into(), &References::default(), &|_, _, _| {});
        outcome.scenes[0].certificates = Some(Certificates::of(vec![rows], 1));
        outcome
    }

    fn found(outcome: &Outcome, decide: fn(&Context) -> Result<Finding, Finding>) -> Finding {
        let text = include_bytes!("../../reports/im-avouac/equations.toml");
        let equations = read_equations("equations.toml", text).unwrap();
        decide(&Context::new(&equations, outcome)).unwrap_or_else(|undecided| undecided)
    }

    #[test]
    fn enclosures_decide_only_where_they_do_not_overlap() {
        let [low, high] = [Some([1.0, 2.0]), Some([3.0, 4.0])];
        let decided = |is_true, is_certified| Decided { is_true, is_certified };
        assert_eq!(Decided::larger(low, high, false), decided(true, true));
        assert_eq!(Decided::larger(high, low, true), decided(false, true));
        assert_eq!(Decided::larger(low, Some([1.5, 9.0]), true), decided(true, false));
        assert_eq!(Decided::larger(low, None, false), decided(false, false));
        let [yes, no, open] = [decided(true, true), decided(false, true), decided(true, false)];
        assert_eq!((yes.and(yes), yes.and(open), open.and(no)), (yes, open, no));
        assert_eq!((no.not(), yes.among(false)), (yes, open));
    }

    #[test]
    fn claims_on_cycles_are_certified_where_every_cycle_has_a_certificate() {
        let all = outcome(|_| {});
        let [trend, drops] = [peak_rises, drop_and_period_fall].map(|decide| found(&all, decide));
        assert_eq!((drops.verdict, drops.strength), (Verdict::Holds, Strength::Certified));
        assert_eq!(trend.strength, Strength::Certified, "{trend:?}");
        let counted = remark(all.scenes[0].certificates.as_ref()).unwrap();
        assert!(counted.starts_with("4 of 4 grid points have a certificate; this run proved "), "{counted}");
        let one_less = outcome(|all| all.rows[3].certificate = Err("because".into()));
        let drops = found(&one_less, drop_and_period_fall);
        assert_eq!((drops.verdict, drops.strength), (Verdict::Holds, Strength::Converged));
        let values: Vec<_> = drops.evidence.iter().map(|one| one.is_empty()).collect();
        assert_eq!(values, [false, false]);
    }

    #[test]
    fn a_run_outside_of_its_enclosure_and_a_certificate_that_is_not_proved_leave_a_claim_open() {
        let moved = outcome(|all| {
            let proof = all.rows[0].certificate.as_mut().unwrap();
            proof.peak_velocity_m_per_s = proof.peak_velocity_m_per_s.map(|end| 1.001 * end);
        });
        let finding = found(&moved, peak_rises);
        assert_eq!(finding.verdict, Verdict::NotChecked);
        assert!(finding.remarks[0].contains("differs from its certificate"), "{finding:?}");
        let refused = outcome(|all| all.again[0].refusal = Some("because".into()));
        let finding = found(&refused, drop_and_period_fall);
        assert_eq!(finding.verdict, Verdict::NotChecked);
        assert!(finding.remarks[0].ends_with("is not proved again: because."), "{finding:?}");
    }
}
