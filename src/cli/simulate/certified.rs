//! `simulate --certify`: proofs of limit cycles and decays, as columns behind those of the simulation, as keys and as lines of text.

use serde_json::{Value, json};
use slipmode::csv::{Column, Datum};
use slipmode::experiments::certificates::BOUNDS;
use slipmode_certified::{Certificate, Proved, Reason, certify_over, second_coordinate};
use slipmode_core::dynamics::Start;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::stability::ParameterBox;

use crate::cli::answer::Answer;

/// A certificate, or why there is none.
#[derive(Debug)]
pub struct Certified(Result<Certificate, Reason>);

/// The columns behind those of `simulate`; without a certificate all but the last are empty.
pub const COLUMNS: [Column<Certified>; 7] = [
    (BOUNDS[0], |found| end(found, |proof| Some(proof.peak_velocity_m_per_s), 0)),
    (BOUNDS[1], |found| end(found, |proof| Some(proof.peak_velocity_m_per_s), 1)),
    (BOUNDS[2], |found| end(found, Certificate::period_s, 0)),
    (BOUNDS[3], |found| end(found, Certificate::period_s, 1)),
    (BOUNDS[4], |found| end(found, |proof| Some(proof.stress_drop_pa), 0)),
    (BOUNDS[5], |found| end(found, |proof| Some(proof.stress_drop_pa), 1)),
    ("certificate", |found| Datum::Text(found.word())),
];

fn end(found: &Certified, of: fn(&Certificate) -> Option<[f64; 2]>, side: usize) -> Datum {
    Datum::Number(found.0.as_ref().ok().and_then(of).map(|ends| ends[side]))
}

impl Certified {
    /// Certifies all sliders within error bars.
    pub fn new(region: &ParameterBox, law: EvolutionLaw, start: Start) -> Self {
        Self(certify_over(region, law, start))
    }

    /// `cycle`, `decay`, or `none` with the reason.
    fn word(&self) -> String {
        match &self.0 {
            Ok(proof) => proof.proved.as_str().into(),
            Err(reason) => format!("none: {reason}"),
        }
    }

    /// States the columns as keys, what the proof rests on, and lines for people.
    pub fn answer(&self) -> Answer {
        let answer = Answer::default().columns(&COLUMNS, self).named("certificate", &self.word());
        let Ok(proof) = &self.0 else { return answer.with("proof", Value::Null) };
        let enclosed = |answer: Answer, name: &str, [low, high]: [f64; 2], unit: &str| {
            answer.named(name, &format!("{low:e} to {high:e} {unit}")).note("(enclosed)")
        };
        let answer = answer.note("(proved)").with("proof", premises(&proof.proved));
        let answer = enclosed(answer, "peak velocity", proof.peak_velocity_m_per_s, "m/s");
        let drop = if proof.period_s().is_some() { "stress drop" } else { "stress range" };
        let answer = enclosed(answer, drop, proof.stress_drop_pa, "Pa");
        match proof.period_s() {
            Some(period) => enclosed(answer, "period", period, "s"),
            None => answer,
        }
    }
}

/// States what a proof rests on.
fn premises(proved: &Proved) -> Value {
    match proved {
        Proved::Cycle {
            section_log_velocity,
            state_box,
            second_box,
            is_on_slow_manifold,
            contraction,
            ..
        } => json!({
            "section_log_velocity": section_log_velocity,
            "log_state_box": state_box,
            "second_coordinate": second_coordinate(*is_on_slow_manifold),
            "second_box": second_box,
            "contraction_factor": contraction,
        }),
        Proved::Decay { captured_after_s } => json!({ "captured_after_s": captured_after_s }),
    }
}
