//! How the frequency changes when a and b are exchanged.

use crate::claims::Evidence;
use crate::experiments::Context;
use slipmode_core::number::format::round_digits;
use slipmode_core::stability::Classification;

/// How max Im(s) differs on the maps of the scenes with a < b and a > b: the ratio where both oscillate, and where one does.
pub(super) fn frequency_changes(context: &Context) -> Option<Vec<Evidence>> {
    let (one, other) = (context.outcome.potentially_unstable()?, context.outcome.intrinsically_stable()?);
    let (one, other) = (one.map.as_ref()?, other.map.as_ref()?);
    if one.loading_velocity_m_per_s != other.loading_velocity_m_per_s
        || one.normal_stress_pa != other.normal_stress_pa
    {
        return None;
    }
    let pairs = || {
        let frequency = |point: &Classification| point.max_imaginary_per_s.to_f64().unwrap_or(0.0);
        one.values.iter().zip(&other.values).map(move |(one, other)| (frequency(one), frequency(other)))
    };
    let differing = pairs().filter(|(one, other)| (*one == 0.0) != (*other == 0.0)).count();
    let ratios: Vec<f64> =
        pairs().filter(|(one, other)| *one > 0.0 && *other > 0.0).map(|(one, other)| one / other).collect();
    let [least, largest] =
        [ratios.iter().fold(f64::INFINITY, |a, b| a.min(*b)), ratios.iter().fold(0.0, |a: f64, b| a.max(*b))];
    Some(vec![
        Evidence::sample(
            "max Im(s) with a < b over that with a > b, where both oscillate",
            format!("{} to {}", round_digits(least, 4), round_digits(largest, 4)),
            ratios.len(),
        ),
        Evidence::sample(
            "Grid points that oscillate in one map and not in the other",
            differing.to_string(),
            one.values.len(),
        ),
    ])
}
