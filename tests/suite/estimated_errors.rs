//! Estimated errors of simulations compared with references by heyoka and SciPy (tests/vectors) that were not used to make the estimates.

use slipmode_core::dynamics::{Failure, Options, simulate};
use slipmode_core::friction::{EvolutionLaw, Parameters};

use crate::hard_cases::{decimal, rows};

const REFERENCES: &str = include_str!("../vectors/estimated-errors.txt");
const NEAR_TRANSITION: &str = include_str!("../vectors/near-transition.txt");

/// A value with a bound of its error.
type Bounded = (f64, f64);

/// ln(V_peak/V0), ln(V_min/V0), stress drop over aσ and period over D_c/V0; σ = 1 MPa, V0 = 1 m/s. None where the tolerance is out of reach.
fn simulated(cells: &[&str], tolerance: f64) -> Option<[Bounded; 4]> {
    let law = EvolutionLaw::ALL.into_iter().find(|law| law.as_str() == cells[0]).unwrap();
    let inputs = ["0.01", cells[1], "1e-5", cells[2], cells[3], "1e6", "1"].map(decimal);
    let found = match simulate(&Parameters::from(inputs), law, &Options::at(tolerance)) {
        Err(Failure::UnreachableTolerance { .. }) => return None,
        found => found.unwrap_or_else(|failure| panic!("{cells:?} at {tolerance:e}: {failure}")),
    };
    let period = found.period_s.unwrap() / 1e-5;
    let (drop, ln_10) = (found.stress_drop_over_direct_effect, std::f64::consts::LN_10);
    Some([
        (libm::log(found.peak_velocity_m_per_s), libm::log1p(found.peak_relative_error)),
        (ln_10 * found.minimum_velocity_log10_ratio, ln_10 * found.minimum_velocity_log10_error),
        (drop, drop * found.stress_drop_relative_error),
        (period, period * found.period_relative_error.unwrap()),
    ])
}

/// Values with bounds of their errors from the cells of a reference.
fn reference(cells: &[&str]) -> Vec<Bounded> {
    let numbers: Vec<f64> = cells.iter().map(|cell| cell.parse().unwrap()).collect();
    numbers.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect()
}

#[test]
fn no_error_exceeds_its_estimate_where_a_slider_vibrates_or_stops() {
    let references: Vec<_> = rows(REFERENCES).skip(1).collect();
    let mut exceeding = Vec::new();
    for tolerance in [1e-2, 1e-3, 1e-5] {
        for cells in &references {
            for (ours, theirs) in simulated(cells, tolerance).unwrap().into_iter().zip(reference(&cells[5..]))
            {
                // A reference that is not ten times as exact would decide nothing.
                assert!(theirs.1 < 0.1 * ours.1, "{cells:?} at {tolerance:e}: {ours:?} {theirs:?}");
                if (ours.0 - theirs.0).abs() > ours.1 + theirs.1 {
                    exceeding.push(format!("{cells:?} at {tolerance:e}: {ours:?} {theirs:?}"));
                }
            }
        }
    }
    assert!(exceeding.is_empty(), "{} values: {exceeding:#?}", exceeding.len());
}

/// The fixed point of the return magnifies what rounding changes: half a unit in the last place of a group moves the peak by a thousand.
#[test]
fn no_error_exceeds_its_estimate_just_below_the_critical_stiffness() {
    let (mut exceeding, mut tight) = (Vec::new(), 0);
    for tolerance in [1e-8, 1e-10, 1e-11, 1e-12] {
        for cells in rows(NEAR_TRANSITION).skip(1) {
            let Some(found) = simulated(&cells, tolerance) else { continue };
            tight += usize::from(found[0].1 < 1e-12);
            for (ours, theirs) in found.into_iter().zip(reference(&cells[4..])) {
                // Units, logarithms and the decimals of the reference add up to four roundings.
                let rounding = 4.0 * f64::EPSILON * theirs.0.abs().max(1.0);
                if (ours.0 - theirs.0).abs() > ours.1 + theirs.1 + rounding {
                    exceeding.push(format!("{cells:?} at {tolerance:e}: {ours:?} {theirs:?}"));
                }
            }
        }
    }
    // Where double-double decides, errors are near the rounding of 64-bit numbers.
    assert!(tight >= 20, "{tight}");
    assert!(exceeding.is_empty(), "{} values: {exceeding:#?}", exceeding.len());
}
