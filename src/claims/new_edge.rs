//! The edge of bistability of the aging law as η → 0, by the balance of small terms along the closed orbits without inertia.

use crate::claims::computed::Asked;
use crate::claims::reading::{Draft, of_readings};
use crate::claims::simulated::extent;
use crate::claims::{Evidence, Finding};
use crate::experiments::Context;
use crate::experiments::near_transition::Edge;
use slipmode_core::dynamics::edge_orbit;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;
use slipmode_core::number::search::minimum_between;

/// The largest η at which the law is required.
const LARGEST: f64 = 0.01;

/// Values of η below [`LARGEST`] that must be known.
const FEWEST: usize = 4;

/// Step along an orbit, and distance of the orbits from which the largest value is refined, in ln V_peak.
const STEP: f64 = 0.04;
const STENCIL: f64 = 0.03;

/// η at which only the law is evaluated, to show its exponent.
const BEYOND: [f64; 3] = [1e-6, 1e-9, 1e-12];

/// The fold by the law.
#[derive(Clone, Copy)]
struct Fold {
    excess: f64,
    log_peak: f64,
}

/// A measured edge and the law at its η.
struct Compared<'c> {
    eta: f64,
    edge: &'c Edge,
    fold: Fold,
}

impl Compared<'_> {
    fn deviation(&self) -> f64 {
        self.edge.excess / self.fold.excess - 1.0
    }

    /// η V_peak², the relative size of what the law leaves out, and the error of the measured edge.
    fn allowed(&self) -> f64 {
        self.eta * libm::exp(2.0 * self.fold.log_peak) + self.edge.error / self.fold.excess
    }
}

pub(super) fn decide(context: &Context, asked: Asked) -> Result<Finding, Finding> {
    let missing = || Finding::not_checked("The report has no edge of bistability with the aging law.");
    let scene = context.outcome.potentially_unstable().ok_or_else(missing)?;
    let near = scene.near_transition.as_ref().ok_or_else(missing)?;
    let effect_ratio = nearest_f64(&scene.slider().ok_or_else(missing)?.effect_ratio());
    let mut all = Vec::new();
    for family in near.families.iter().filter(|family| family.law == EvolutionLaw::Aging) {
        let edge = family.edge.as_ref().map_err(|failure| {
            Finding::not_checked(format!("A family of cycles could not be followed: {failure}"))
        })?;
        let eta = nearest_f64(&family.inertial_parameter);
        if let Some((edge, fold)) = edge.as_ref().zip(fold(effect_ratio, eta)) {
            all.push(Compared { eta, edge, fold });
        }
    }
    all.sort_by(|one, other| one.eta.total_cmp(&other.eta));
    let small: Vec<&Compared> = all.iter().filter(|one| one.eta <= LARGEST).collect();
    if small.len() < FEWEST {
        return Err(missing());
    }
    let proofs = asked.proved();
    let written = Draft::new("the fold of the cycles of the aging law as η → 0")
        .part("the first integral without inertia changes only by the mass and by K − K_c", proofs)
        .part(
            "(1 + η)(K/K_c − 1) at the fold is the largest value of [η ∮Ω'² dt − η² (β − 1)/2 ∮V V'² dt]/[(β − 1) ∮(Ω − 1)² dt] − η over the closed orbits, but for a relative O(η V_peak²) = O(η^(1/3))",
            agreement(&small, &all),
        );
    Ok(of_readings([written]).with_supporting(exponents(effect_ratio, &small)?))
}

/// The largest K/K_c − 1 over the closed orbits, and where.
fn fold(effect_ratio: f64, eta: f64) -> Option<Fold> {
    let below = |log_peak: f64| Some(-edge_orbit(effect_ratio, log_peak, STEP)?.stiffness_excess(eta) / eta);
    let ends = (0.1, 1.0 - libm::log(0.1 * eta) / 3.0);
    let log_peak = minimum_between(below, ends, STENCIL, f64::EPSILON)?.at;
    let excess = edge_orbit(effect_ratio, log_peak, STEP)?.stiffness_excess(eta);
    Some(Fold { excess, log_peak })
}

fn agreement(small: &[&Compared], all: &[Compared]) -> Finding {
    let line = |one: &&Compared| {
        format!(
            "η = {}: {}, {}, {} (allowed {})",
            round_digits(one.eta, 2),
            round_digits(one.edge.excess, 5),
            round_digits(one.fold.excess, 5),
            round_digits(one.deviation(), 2),
            round_digits(one.allowed(), 2)
        )
    };
    let parts = extent(small.iter().map(|one| one.deviation().abs() / one.allowed()));
    let peaks = extent(small.iter().map(|one| one.edge.log_peak - one.fold.log_peak));
    let error = small.iter().map(|one| one.edge.error / one.edge.excess).fold(0.0, f64::max);
    let ends = all.iter().find(|one| one.deviation().abs() > one.allowed());
    let [first, .., last] = small else { return Finding::not_checked("Too few values of η.") };
    Finding::from_evidence(Evidence::Simulation {
        quantity: "K/K_c − 1 at the fold, measured; by the law; measured/law − 1".into(),
        value: small.iter().map(line).collect::<Vec<_>>().join("; "),
        error: format!("{} relative", round_digits(error, 1)),
        runs: small.len(),
    })
    .with_evidence(Evidence::Simulation {
        quantity: "ln(V_peak/V_l) of the cycle at the fold, measured less by the law".into(),
        value: format!("{} to {}", round_digits(peaks.0, 2), round_digits(peaks.1, 2)),
        error: format!("{} relative", round_digits(error, 1)),
        runs: small.len(),
    })
    .require(parts.1 <= 1.0, || {
        format!("the deviation is up to {} of the allowed one", round_digits(parts.1, 3))
    })
    .on(format!(
        "{} values of η from {} to {}, deviation {} % to {} %{}",
        small.len(),
        round_digits(first.eta, 2),
        round_digits(last.eta, 2),
        round_digits(100.0 * first.deviation(), 2),
        round_digits(100.0 * last.deviation(), 2),
        ends.map_or_else(String::new, |one| format!(
            "; the law ends before η = {}",
            round_digits(one.eta, 2)
        ))
    ))
}

/// d ln(K/K_c − 1)/d ln η: measured between neighbours, and by the law far below.
fn exponents(effect_ratio: f64, small: &[&Compared]) -> Result<Evidence, Finding> {
    let measured = small.windows(2).map(|pair| {
        libm::log(pair[1].edge.excess / pair[0].edge.excess) / libm::log(pair[1].eta / pair[0].eta)
    });
    let of_law = |eta: f64| {
        let [at, beyond] = [eta, 10.0 * eta].map(|eta| Some(fold(effect_ratio, eta)?.excess));
        Some(libm::log10(beyond? / at?))
    };
    let of_law: Option<Vec<f64>> = BEYOND.into_iter().map(of_law).collect();
    let of_law = of_law.ok_or_else(|| Finding::not_checked("The law has no value at a small η."))?;
    let list = |values: &mut dyn Iterator<Item = f64>| {
        values.map(|value| round_digits(value, 3)).collect::<Vec<_>>().join(", ")
    };
    Ok(Evidence::Sample {
        quantity: "d ln(K/K_c − 1)/d ln η: measured between neighbours by rising η; by the law over one decade from η = 1e-6, 1e-9 and 1e-12".into(),
        value: format!("{}; {}", list(&mut measured.into_iter()), list(&mut of_law.into_iter())),
        points: small.len() - 1 + BEYOND.len(),
    })
}
