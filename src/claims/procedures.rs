//! All procedures that claims can name.

use crate::claims::check::{Check, Show};
use crate::claims::{
    boundary, criteria, criticality, exchange, frequency, frequency_turns, friction_law, linearisation,
};
use crate::experiments::Need;
use crate::scene::Procedures;
use slipmode_theory::{Role, asymptote_series, hopf};

/// What decides.
pub(super) static CHECKS: [Check; 7] = [
    Check::new("difference-of-the-regularised-law", &[], friction_law::in_linear_analysis),
    Check::new("small-disturbances", &[], linearisation::small_disturbances).of_runs(&[Need::LinearRegime]),
    Check::new("error-series", &asymptote_series::EQUATIONS, boundary::error_series),
    Check::new(
        "largest-frequency-in-the-area",
        &[Role::Characteristic, Role::QuasiStaticCharacteristic],
        frequency::largest_in_the_area,
    ),
    Check::new(
        "turning-points-of-the-frequency",
        &[Role::Characteristic],
        frequency_turns::rises_in_the_area,
    ),
    Check::new("sufficient-inertia", &[], criteria::sufficient_inertia),
    Check::new(
        "sign-of-the-lyapunov-coefficient",
        &hopf::EQUATIONS,
        criticality::sign_of_lyapunov_coefficient,
    )
    .of_runs(&[]),
];

/// What is shown beside it.
pub(super) static SHOWS: [Show; 4] = [
    Show::new("areas-on-the-map-of-weakening", &[Need::Map], |context| {
        boundary::areas_on_map(context.outcome.potentially_unstable())
    }),
    Show::new("areas-on-the-map-of-strengthening", &[Need::Map], |context| {
        boundary::areas_on_map(context.outcome.intrinsically_stable())
    }),
    Show::new("frequencies-under-exchange", &[Need::Map], exchange::frequency_changes),
    Show::new("frequency-near-its-limits", &[Need::Frequency], frequency::near_the_limits),
];

/// Their names, as the reader of claims requires them.
#[must_use]
pub fn procedures() -> Procedures {
    Procedures {
        checks: CHECKS.iter().map(|check| check.name).collect(),
        shows: SHOWS.iter().map(|show| show.name).collect(),
    }
}
