//! `simulate --certify`: proofs of limit cycles and decays, as columns behind those of the simulation, as keys and as lines of text.

use serde_json::{Map, Value, json};
use slipmode::csv::{Cells, Column, Datum, Remark, RowWork, push_cells};
use slipmode::experiments::certificates::BOUNDS;
use slipmode::scene::{Faults, Problem};
use slipmode_core::dynamics::Start;
use slipmode_core::dynamics::certified::{Certificate, Proved, Reason, certify_over, second_coordinate};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::stability::ParameterBox;

use crate::cli::options::uncertain_box;
use crate::cli::simulate::rows::SimulateRows;
use crate::cli::terminal;

/// A certificate, or why there is none.
#[derive(Debug)]
pub struct Certified(Result<Certificate, Reason>);

/// The columns behind those of `simulate`; without a certificate all but the last are empty.
const COLUMNS: [Column<Certified>; 7] = [
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

    /// The columns as keys, and what the proof rests on.
    pub fn json(&self) -> Map<String, Value> {
        let columns = COLUMNS.iter().map(|(name, cell)| (name.to_string(), cell(self).json()));
        let proof = match self.0.as_ref().map(|proof| &proof.proved) {
            Ok(Proved::Cycle {
                section_log_velocity,
                state_box,
                second_box,
                is_on_slow_manifold,
                contraction,
                ..
            }) => json!({
                "section_log_velocity": section_log_velocity,
                "log_state_box": state_box,
                "second_coordinate": second_coordinate(*is_on_slow_manifold),
                "second_box": second_box,
                "contraction_factor": contraction,
            }),
            Ok(Proved::Decay { captured_after_s }) => json!({ "captured_after_s": captured_after_s }),
            Err(_) => Value::Null,
        };
        columns.chain([("proof".to_string(), proof)]).collect()
    }

    /// Lines for people.
    pub fn text(&self) -> String {
        let between = |[low, high]: [f64; 2], unit: &str| format!("{low:e} to {high:e} {unit}");
        let mut lines = vec![("certificate", self.word(), "(proved)")];
        if let Ok(proof) = &self.0 {
            lines.push(("peak velocity", between(proof.peak_velocity_m_per_s, "m/s"), "(enclosed)"));
            lines.push(("stress drop", between(proof.stress_drop_pa, "Pa"), "(enclosed)"));
            lines.extend(proof.period_s().map(|period| ("period", between(period, "s"), "(enclosed)")));
        } else {
            lines[0].2 = "";
        }
        terminal::named_values(&lines)
    }
}

/// Simulates the middle of each row's error bars, and certifies all values within them.
#[derive(Debug)]
pub struct CertifiedRows(pub SimulateRows);

impl RowWork for CertifiedRows {
    type Input = (ParameterBox, EvolutionLaw);
    type Kept = ();

    const APPENDED: &'static [&'static str] = &{
        let first = SimulateRows::APPENDED.len();
        let mut names = [""; SimulateRows::APPENDED.len() + COLUMNS.len()];
        let mut index = 0;
        while index < names.len() {
            names[index] =
                if index < first { SimulateRows::APPENDED[index] } else { COLUMNS[index - first].0 };
            index += 1;
        }
        names
    };
    const BLOCK_ROWS: usize = SimulateRows::BLOCK_ROWS;
    const BLOCKS_PER_THREAD: usize = SimulateRows::BLOCKS_PER_THREAD;

    fn header_faults(&self, names: &[String]) -> Vec<(String, Problem)> {
        self.0.header_faults(names)
    }

    fn read(&self, cells: Cells<'_>) -> Result<Self::Input, Faults> {
        let needs =
            || vec![cells.fault(None, Problem::Needs("positive values within all error bars".into()))];
        self.0.with_law(cells, cells.uncertain().and_then(|values| uncertain_box(values).ok_or_else(needs)))
    }

    fn append(&self, (region, law): &Self::Input, out: &mut Vec<u8>) -> Remark {
        let remark = self.0.append(&(region.middle(), *law), out);
        push_cells(&COLUMNS, &Certified::new(region, *law, self.0.settings.start), out);
        remark
    }
}
