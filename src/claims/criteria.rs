//! How good the criteria for oscillation are.

use crate::claims::check::Asked;
use crate::claims::{BITS, Evidence, Finding};
use crate::experiments::Context;
use slipmode_core::number::format::certain_digits;
use slipmode_core::stability::cusp::cusp_inertial_parameter;

pub(super) fn sufficient_inertia(context: &Context, asked: Asked) -> Finding {
    let finding = asked.proved();
    let bound = "η > η_c suffices, with (1 − 2η_c)³ = 27 (b/a) η_c², that is η_c = 1/(2 + 6√(b/a) cos(⅓ arccos √(a/b)))";
    let all = "η ≥ 1/8 suffices for all a < b; no smaller bound does";
    let slider = context.outcome.potentially_unstable().and_then(|scene| scene.slider());
    let value =
        slider.map(|slider| certain_digits(&cusp_inertial_parameter(&slider.effect_ratio(), BITS), 6));
    let of_scene = value.as_ref().map(|value| format!(" = {value} at the scene's b/a")).unwrap_or_default();
    let finding = finding
        .on("the upper area, which has real roots at every η")
        .remark(format!("For a < b and K > K_c every point with η > 1 is underdamped, so there the criterion is sufficient: {bound}{of_scene}; {all}."));
    match value {
        None => finding,
        Some(value) => finding.with_evidence(Evidence::enclosure("η_c at the scene's b/a", value)),
    }
}
