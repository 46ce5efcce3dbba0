//! A certificate as a row of a file: the decimals it holds for, what is proved, and bounds that the proof leaves room for.
//!
//! The columns of the bounds are those of `simulate --certify`. A stored bound lies outside the bound of the proof that it was
//! made from, by a tenth of the width and a relative 10⁻¹¹ and more, so that a later proof of the same box can confirm it.

use crate::experiments::certificates::CertificateFile;
use crate::scene::{CsvProblem, Fault, Faults, Problem, Quantity};
use slipmode_certified::{Certificate, Proved, Reason, second_coordinate};
use slipmode_core::friction::{EvolutionLaw, Parameters};
use slipmode_core::number::format::shortest;
use slipmode_core::number::{Rational, parse_decimal};

/// What is stored of one point.
#[derive(Debug, Clone, PartialEq)]
pub struct Stored {
    /// The decimals of the row.
    pub parameters: Parameters<Rational>,
    /// The evolution law.
    pub law: EvolutionLaw,
    /// What is proved, with bounds; or why nothing is.
    pub certificate: Result<Certificate, String>,
    /// The seven decimals as written.
    inputs: Vec<String>,
}

/// The columns of the bounds, as of `simulate --certify`.
pub const BOUNDS: [&str; 6] = [
    "peak_velocity_low_m_per_s",
    "peak_velocity_high_m_per_s",
    "period_low_s",
    "period_high_s",
    "stress_drop_low_pa",
    "stress_drop_high_pa",
];
/// The columns behind these: the box, and what else the proof states.
const PROOF: [&str; 8] = [
    "section_log_velocity",
    "log_state_low",
    "log_state_high",
    "second_coordinate",
    "second_low",
    "second_high",
    "contraction_factor",
    "captured_after_s",
];
const INPUTS: usize = Quantity::ALL.len();
const NONE: &str = "none: ";

/// The header: the seven inputs, the law, the kind of certificate, the bounds and the proof.
fn columns() -> Vec<&'static str> {
    let inputs = Quantity::ALL.map(Quantity::as_str);
    [&inputs[..], &["law", "certificate"], &BOUNDS, &PROOF].concat()
}

/// The part of its width by which a stored enclosure is wider at each end, and the relative part of the value.
const ROOM: [f64; 2] = [0.1, 1e-11];

/// An enclosure with room for another proof, of twelve digits; both ends are positive.
fn with_room([low, high]: [f64; 2]) -> [f64; 2] {
    let slack = ROOM[0] * (high - low);
    // Rounding to twelve digits changes a number by at most half of the second part of the room.
    let rounded = |value: f64| format!("{value:.11e}").parse().unwrap_or(value);
    [rounded(low - slack - ROOM[1] * low), rounded(high + slack + ROOM[1] * high)]
}

/// The same for a bound of the multipliers, which stays below 1.
fn below_one(contraction: f64) -> f64 {
    contraction + 1e-3 * (1.0 - contraction)
}

fn is_inside(inner: [f64; 2], outer: [f64; 2]) -> bool {
    outer[0] <= inner[0] && inner[1] <= outer[1]
}

impl Stored {
    /// Stores what was found at a point of these decimals.
    pub(crate) fn of(
        inputs: [String; INPUTS],
        parameters: Parameters<Rational>,
        law: EvolutionLaw,
        found: Result<Certificate, Reason>,
    ) -> Self {
        let certificate = found.map_err(|reason| reason.to_string()).map(|mut proof| {
            proof.peak_velocity_m_per_s = with_room(proof.peak_velocity_m_per_s);
            proof.stress_drop_pa = with_room(proof.stress_drop_pa);
            match &mut proof.proved {
                Proved::Cycle { period_s, contraction, .. } => {
                    *period_s = with_room(*period_s);
                    *contraction = below_one(*contraction);
                }
                Proved::Decay { captured_after_s } => {
                    *captured_after_s = with_room([*captured_after_s; 2])[1]
                }
            }
            proof
        });
        Self { parameters, law, certificate, inputs: inputs.to_vec() }
    }

    /// What a proof of the same row does not confirm; none where all stored bounds hold.
    pub(crate) fn contradiction(&self, proof: &Certificate) -> Option<&'static str> {
        let stored = self.certificate.as_ref().ok()?;
        let proved = match (&stored.proved, &proof.proved) {
            (
                Proved::Cycle { period_s: outer, contraction: most, .. },
                Proved::Cycle { period_s: inner, contraction, .. },
            ) => [(is_inside(*inner, *outer), "period"), (contraction <= most, "contraction factor")],
            (Proved::Decay { captured_after_s: latest }, Proved::Decay { captured_after_s: after }) => {
                [(after <= latest, "time of capture"); 2]
            }
            _ => [(false, "long-term behaviour"); 2],
        };
        let observed = [
            (is_inside(proof.peak_velocity_m_per_s, stored.peak_velocity_m_per_s), "peak velocity"),
            (is_inside(proof.stress_drop_pa, stored.stress_drop_pa), "stress drop"),
        ];
        proved.into_iter().chain(observed).find(|(holds, _)| !holds).map(|(_, what)| what)
    }

    /// The seven decimals as written.
    pub(super) fn inputs(&self) -> &[String] {
        &self.inputs
    }

    fn cells(&self) -> Vec<String> {
        let mut cells = self.inputs.clone();
        cells.push(self.law.as_str().into());
        let proof = match &self.certificate {
            Ok(proof) => proof,
            Err(reason) => {
                cells.push(format!("{NONE}{reason}"));
                cells.resize(columns().len(), String::new());
                return cells;
            }
        };
        let [peak, drop] = [proof.peak_velocity_m_per_s, proof.stress_drop_pa].map(|ends| ends.map(shortest));
        let empty = || [String::new(), String::new()];
        let (period, rest) = match &proof.proved {
            Proved::Cycle {
                section_log_velocity,
                state_box,
                second_box,
                is_on_slow_manifold,
                contraction,
                period_s,
            } => {
                let [state, second] = [state_box, second_box].map(|ends| ends.map(shortest));
                let second_word = second_coordinate(*is_on_slow_manifold).to_string();
                let mut rest = vec![shortest(*section_log_velocity)];
                rest.extend(state.into_iter().chain([second_word]).chain(second));
                rest.extend([shortest(*contraction), String::new()]);
                (period_s.map(shortest), rest)
            }
            Proved::Decay { captured_after_s } => {
                let mut rest = vec![String::new(); 7];
                rest.push(shortest(*captured_after_s));
                (empty(), rest)
            }
        };
        cells.push(proof.proved.as_str().into());
        cells.extend(peak.into_iter().chain(period).chain(drop).chain(rest));
        cells
    }

    /// A row; the fault names its column.
    fn read(record: &csv::StringRecord) -> Result<Self, (usize, Problem)> {
        let wanted = columns().len();
        if record.len() != wanted {
            return Err((0, CsvProblem::CellCount { found: record.len(), wanted }.into()));
        }
        let cell = |at: usize| record.get(at).unwrap_or_default();
        let allowed = |allowed: &str| Problem::OutOfRange { allowed: allowed.into() };
        let positive = |at: usize| {
            let value = parse_decimal(cell(at)).ok().filter(|value| *value > 0);
            value.ok_or_else(|| (at, allowed("a positive decimal")))
        };
        let number = |at: usize| {
            let value = cell(at).parse::<f64>().ok().filter(|value| value.is_finite());
            value.ok_or_else(|| (at, allowed("a number")))
        };
        let ends = |at: usize| {
            let ends = [number(at)?, number(at + 1)?];
            if ends[0] <= ends[1] { Ok(ends) } else { Err((at, allowed("at most the upper end"))) }
        };
        let texts = (0..INPUTS).map(positive).collect::<Result<Vec<_>, _>>()?;
        let texts: [Rational; INPUTS] = texts.try_into().map_err(|_| (0, allowed("seven decimals")))?;
        let law = EvolutionLaw::from_word(cell(INPUTS));
        let law = law.ok_or_else(|| (INPUTS, allowed("`slip` or `aging`")))?;
        let proved = match cell(8) {
            "cycle" => Ok(Proved::Cycle {
                section_log_velocity: number(15)?,
                state_box: ends(16)?,
                second_box: ends(19)?,
                is_on_slow_manifold: [true, false]
                    .into_iter()
                    .find(|is| second_coordinate(*is) == cell(18))
                    .ok_or_else(|| (18, allowed("`psi` or `force`")))?,
                contraction: Some(number(21)?)
                    .filter(|factor| (0.0..1.0).contains(factor))
                    .ok_or_else(|| (21, allowed("0 to below 1")))?,
                period_s: ends(11)?,
            }),
            "decay" => Ok(Proved::Decay { captured_after_s: number(22)? }),
            word => {
                let reason = word.strip_prefix(NONE).map(str::to_string);
                Err(reason.ok_or_else(|| (8, allowed("`cycle`, `decay` or `none: ` with a reason")))?)
            }
        };
        let certificate = match proved {
            Ok(proved) => {
                Ok(Certificate { proved, peak_velocity_m_per_s: ends(9)?, stress_drop_pa: ends(13)? })
            }
            Err(reason) => Err(reason),
        };
        let inputs = (0..INPUTS).map(|at| cell(at).to_string()).collect();
        let stored = Self { parameters: Parameters::from(texts), law, certificate, inputs };
        let unread =
            stored.cells().iter().zip(record).position(|(own, given)| own.is_empty() && !given.is_empty());
        unread.map_or(Ok(stored), |at| Err((at, allowed("nothing in a row of this certificate"))))
    }
}

/// The file of some rows.
#[must_use]
pub fn written(rows: &[Stored]) -> String {
    let lines = rows.iter().map(|row| row.cells().join(","));
    let lines: Vec<String> = std::iter::once(columns().join(",")).chain(lines).collect();
    lines.join("\n") + "\n"
}

/// The rows of a file whose digest the scene states, each with its line.
///
/// # Errors
/// When the file is another one, has other columns, or a cell is at fault.
pub(super) fn read_stored(
    entry: &CertificateFile,
    digest: &str,
    (file, text): (&str, &str),
) -> Result<Vec<(usize, Stored)>, Faults> {
    let fault = |line, key: &str, value, problem| {
        vec![Fault { file: file.to_string(), line, key: key.into(), value, problem }]
    };
    if digest != entry.sha256 {
        let wanted = format!("to be the file of SHA-256 {}, not {digest}", entry.sha256);
        return Err(fault(None, "sha256", None, Problem::Needs(wanted)));
    }
    let mut reader = csv::ReaderBuilder::new().flexible(true).has_headers(false).from_reader(text.as_bytes());
    // A flexible reader of text in memory has no way to fail.
    let mut records = reader.records().flatten();
    if records.next().is_none_or(|header| header.iter().ne(columns())) {
        let wanted = CsvProblem::NoHeader(columns().join(","));
        return Err(fault(Some(1), "header", None, wanted.into()));
    }
    let row = |record: csv::StringRecord| {
        let line = record.position().and_then(|position| usize::try_from(position.line()).ok());
        let stored = Stored::read(&record).map_err(|(column, problem)| {
            let value = record.get(column).filter(|_| record.len() == columns().len()).map(str::to_string);
            fault(line, columns()[column], value, problem)
        })?;
        Ok((line.unwrap_or(1), stored))
    };
    records.map(row).collect()
}
