//! Claims B6 to B8: what stays when a and b are exchanged.

use crate::claims::reading::{Draft, of_readings};
use crate::claims::{Evidence, Finding};
use crate::experiments::Context;
use crate::experiments::map::MapPoint;
use slipmode_core::number::format::round_digits;
use slipmode_core::theory::exchange::{self, Exchange};

pub(super) fn b6(context: &Context) -> Finding {
    let exchanges = match exchange::asymptotes(context.equations) {
        Ok(exchanges) => exchanges,
        Err(refutation) => return Finding::from_proofs([Err(refutation)]),
    };
    let exchanged =
        unchanged("no equation changes when a and b are exchanged, as the paper concludes", &exchanges);
    let one_formula =
        Draft::new("each equation is one formula for a < b and for a > b, without separate cases");
    let one_formula = exchanges.iter().fold(one_formula, |draft, exchange| {
        // The proof has the same formula on both domains, where it is defined.
        draft.part(format!("eq {}", exchange.equation), Finding::from_proofs([Ok(exchange.proof.clone())]))
    });
    let fixed_a: Vec<&str> = exchanges.iter().filter(|e| !e.contains_b).map(|e| e.equation).collect();
    let other = Finding::from_disproof(
        exchange::no_other_choice(context.equations),
        "eq 20 stays for a' = a only, and then eq 16 rises for every b' < a",
    );
    let other = Draft::new("some other pair a' > b' in place of a < b changes none of the four equations")
        .part("eqs 16 and 20 stay", other);
    let finding = of_readings([exchanged, one_formula, other]).remark(
        "Eqs 15, 16 and 18 stay when a and b are exchanged. Eqs 18 and 20 stay for b' = 2a − b, if b < 2a.",
    );
    match fixed_a.is_empty() {
        true => finding,
        false => finding.remark(format!("Eq {} does not contain b at all.", fixed_a.join(", "))),
    }
}

/// Each of the four equations as a part: whether it is the same after the exchange of a and b.
fn unchanged(words: &str, exchanges: &[Exchange]) -> Draft {
    exchanges.iter().fold(Draft::new(words), |draft, exchange| {
        let finding = Finding::from_proofs([Ok(exchange.proof.clone())]);
        let changed =
            || format!("when a and b are exchanged, its solution is multiplied by {}", exchange.factor);
        draft.part(format!("eq {}", exchange.equation), finding.require(exchange.invariant, changed))
    })
}

pub(super) fn b7(context: &Context) -> Finding {
    let finding = Finding::from_disproof(
        exchange::frequency_contours(context.equations),
        "Without inertia the exchange multiplies every frequency by a/b. With inertia the contour of zero frequency moves too.",
    );
    frequency_changes(context).into_iter().flatten().fold(finding, Finding::with_supporting)
}

/// How max Im(s) differs on the maps of the scenes with a < b and a > b: the ratio where both oscillate, and where one does.
fn frequency_changes(context: &Context) -> Option<[Evidence; 2]> {
    let (one, other) = (context.outcome.potentially_unstable()?, context.outcome.intrinsically_stable()?);
    let (one, other) = (one.map.as_ref()?, other.map.as_ref()?);
    if one.loading_velocity_m_per_s != other.loading_velocity_m_per_s
        || one.normal_stress_pa != other.normal_stress_pa
    {
        return None;
    }
    let pairs = || {
        let frequency = |point: &MapPoint| point.max_imaginary_per_s.to_f64().unwrap_or(0.0);
        one.values.iter().zip(&other.values).map(move |(one, other)| (frequency(one), frequency(other)))
    };
    let differing = pairs().filter(|(one, other)| (*one == 0.0) != (*other == 0.0)).count();
    let ratios: Vec<f64> =
        pairs().filter(|(one, other)| *one > 0.0 && *other > 0.0).map(|(one, other)| one / other).collect();
    let [least, largest] =
        [ratios.iter().fold(f64::INFINITY, |a, b| a.min(*b)), ratios.iter().fold(0.0, |a: f64, b| a.max(*b))];
    let sample =
        |quantity: &str, value, points| Evidence::Sample { quantity: quantity.into(), value, points };
    Some([
        sample(
            "max Im(s) with a < b over that with a > b, where both oscillate",
            format!("{} to {}", round_digits(least, 4), round_digits(largest, 4)),
            ratios.len(),
        ),
        sample(
            "Grid points that oscillate in one map and not in the other",
            differing.to_string(),
            one.values.len(),
        ),
    ])
}

pub(super) fn b8(context: &Context) -> Finding {
    match exchange::asymptotes(context.equations) {
        Err(refutation) => Finding::from_proofs([Err(refutation)]),
        Ok(exchanges) => of_readings([unchanged("each asymptote stays where it is", &exchanges)]),
    }
}
