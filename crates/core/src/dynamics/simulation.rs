//! One simulation from parameters in SI to observables in SI, each with an error estimate.
//!
//! Radau IIA of order 5 takes the least work for limit cycles to a hundredth or a thousandth (`loose_cycle`), order 9 for everything else
//! down to rounding. What is required of a search, and how its errors are known, is in the module of the search.
//! An oscillation that grows or dies too slowly for a search is followed to small amplitudes (`smooth_decay`), where eq 8 and the normal form say the rest.

use super::loose_cycle::loose_cycle;
use super::outcome::{Outcome, Simulation};
use super::search::Search;
use super::slow_pair::{Pace, SlowPair};
use super::smooth_decay::{slow_oscillation, smooth_decay};
use super::{Balance, Failure, Model, Options, Radau};
use crate::friction::{EvolutionLaw, Groups, Parameters};
use crate::number::{Rational, nearest_f64};

/// Simulates a slider.
///
/// ```
/// use slipmode_core::{friction::{EvolutionLaw, Parameters}, dynamics::{Options as SimulationOptions, simulate}, number::parse_decimal};
///
/// // a, b, D_c, K, M, σ, V0: a laboratory slider under 1 MPa is driven at 10 µm/s.
/// let number = |text| parse_decimal(text).unwrap();
/// let parameters = Parameters::from(["0.004", "0.006", "1e-5", "1e7", "1000", "1e6", "1e-5"].map(number));
/// let found = simulate(&parameters, EvolutionLaw::Aging, &SimulationOptions::at(1e-3)).unwrap();
/// assert_eq!(found.slip_mode.as_str(), "stick-slip");
/// assert!(found.peak_velocity_m_per_s > 1e-3 && found.peak_relative_error < 1e-3);
/// ```
///
/// # Errors
/// A [`Failure`] when the start is not admissible, the long-term behaviour is undecided or the tolerance is out of reach.
pub fn simulate(
    parameters: &Parameters<Rational>,
    law: EvolutionLaw,
    options: &Options,
) -> Result<Simulation, Failure> {
    let exact = parameters.groups();
    let groups = exact.map(nearest_f64);
    let parameters = parameters.map(nearest_f64);
    let balance = match options.regularised_reference_friction {
        Some(reference) => Balance::Regularised(reference / parameters.slider.direct_effect),
        None => Balance::Inertial,
    };
    let model = Model::with_balance(groups, law, balance);
    Ok(simulate_exact(&model, options, &exact)?.in_si(&parameters))
}

/// Simulates a slider without units.
///
/// # Errors
/// Those of [`simulate`].
pub fn simulate_model(model: &Model<f64>, options: &Options) -> Result<Outcome, Failure> {
    // Every finite f64 is a rational number; the integrator refuses the others.
    let exact = model.groups().map(|&group| Rational::from_f64(group).unwrap_or_default());
    simulate_exact(model, options, &exact)
}

/// Simulates a slider whose groups are known exactly: next to K = K_c those of the model are rounded by as much as what matters.
fn simulate_exact(
    model: &Model<f64>,
    options: &Options,
    exact: &Groups<Rational>,
) -> Result<Outcome, Failure> {
    if let Some(outcome) = smooth_decay(model, options) {
        return Ok(outcome);
    }
    let search = || {
        loose_cycle(model, options)
            .or_else(|leftover| Search::new(model, exact, Radau::<f64, 5>::new(), options, leftover).answer())
    };
    let requested = options.tolerance;
    let slowly = || {
        let outcome =
            SlowPair::of(model, exact).and_then(|pair| slow_oscillation(model, options, pair)).ok_or(None)?;
        let reached = outcome.largest_error();
        let missed = Failure::UnreachableTolerance { requested, reached };
        if reached <= requested { Ok(outcome) } else { Err(Some(missed)) }
    };
    match Pace::of(model) {
        Pace::Fast => search(),
        Pace::Slow => search().or_else(|failure| slowly().map_err(|missed| missed.unwrap_or(failure))),
        Pace::Lost => slowly().or_else(|missed| search().map_err(|failure| missed.unwrap_or(failure))),
    }
}
