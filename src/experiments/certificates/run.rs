//! Stored certificates, some of which are proved again; and new ones for a grid.

use std::collections::{BTreeMap, BTreeSet};

use crate::parallel;

use crate::experiments::certificates::Stored;
use crate::experiments::certificates::grid::Grid;
use crate::experiments::simulations::SimulationsSection;
use slipmode_certified::{Certificate, Proved, certify};
use slipmode_core::dynamics::Start;
use slipmode_core::friction::{EvolutionLaw, Parameters, Slider};
use slipmode_core::number::format::rational_to_decimal;
use slipmode_core::number::{Rational, nearest_f64, parse_decimal};

/// The certificates of a scene.
#[derive(Debug, Clone)]
pub struct Certificates {
    /// All rows of all files.
    pub rows: Vec<Stored>,
    /// What this run proved again.
    pub again: Vec<ProvedAgain>,
    places: BTreeMap<Key, usize>,
}

/// The law, and velocity and stress in 64 bits.
type Key = (&'static str, [u64; 2]);

/// A row that was proved again, or not.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ProvedAgain {
    /// The row, from 0.
    pub row: usize,
    /// Why it is not proved.
    pub refusal: Option<String>,
}

impl Certificates {
    /// Proves this many rows of each file again, evenly chosen from the first on, and those that are extreme.
    pub(crate) fn of(files: Vec<Vec<Stored>>, again: usize) -> Self {
        let mut chosen = BTreeSet::new();
        let mut first = 0;
        for file in &files {
            let step = file.len().div_ceil(again).max(1);
            chosen.extend((0..file.len()).step_by(step).chain(extremes(file)).map(|row| first + row));
            first += file.len();
        }
        let rows: Vec<Stored> = files.into_iter().flatten().collect();
        let places = rows.iter().enumerate().map(|(row, stored)| (stored.key(), row)).collect();
        Self { again: prove_again(&rows, &chosen.into_iter().collect::<Vec<_>>()), rows, places }
    }

    /// The certificate of a point of a grid, if it has one.
    pub(crate) fn at(
        &self,
        law: EvolutionLaw,
        velocity_m_per_s: f64,
        stress_pa: f64,
    ) -> Option<&Certificate> {
        let row = self.places.get(&(law.as_str(), [velocity_m_per_s, stress_pa].map(f64::to_bits)))?;
        self.rows[*row].certificate.as_ref().ok()
    }

    /// The first row that was not proved again, in words.
    pub(crate) fn refusal(&self) -> Option<String> {
        self.again.iter().find_map(|again| {
            let reason = again.refusal.as_ref()?;
            Some(format!(
                "The certificate of {} is not proved again: {reason}.",
                self.rows[again.row].place()
            ))
        })
    }
}

impl Stored {
    fn key(&self) -> Key {
        let point = &self.parameters.point;
        let place = [&point.loading_velocity_m_per_s, &point.normal_stress_pa];
        (self.law.as_str(), place.map(|value| nearest_f64(value).to_bits()))
    }

    /// Where the point lies, for people.
    pub(crate) fn place(&self) -> String {
        let point = &self.parameters.point;
        format!(
            "σ = {} Pa, V_l = {} m/s, {} law",
            rational_to_decimal(&point.normal_stress_pa, 4),
            rational_to_decimal(&point.loading_velocity_m_per_s, 4),
            self.law.as_str()
        )
    }

    /// Why the row is not proved; none where it is, or where it states no certificate.
    fn refusal(&self) -> Option<String> {
        let stated = self.certificate.as_ref().ok()?;
        match slipmode_certified::prove_again(&self.parameters, self.law, Start::default(), &stated.proved) {
            Ok(proof) => self.contradiction(&proof).map(|what| format!("the stored {what} is another one")),
            Err(reason) => Some(reason.to_string()),
        }
    }
}

/// Proves these rows again, those that state a certificate.
pub(crate) fn prove_again(rows: &[Stored], chosen: &[usize]) -> Vec<ProvedAgain> {
    let chosen: Vec<usize> = chosen.iter().copied().filter(|row| rows[*row].certificate.is_ok()).collect();
    parallel::map(&chosen, |&row| ProvedAgain { row, refusal: rows[row].refusal() })
}

/// The most rows that are extreme.
pub(super) const EXTREMES: usize = 4;

/// The rows of the cycle that attracts least, of the widest enclosure of a peak, and of the two neighbours in the file whose peaks
/// differ least.
fn extremes(rows: &[Stored]) -> impl Iterator<Item = usize> {
    let proofs =
        || rows.iter().enumerate().filter_map(|(row, stored)| Some((row, stored.certificate.as_ref().ok()?)));
    let weakest = proofs().filter_map(|(row, proof)| match proof.proved {
        Proved::Cycle { contraction, .. } => Some((row, contraction)),
        Proved::Decay { .. } => None,
    });
    let width = |proof: &Certificate| proof.peak_velocity_m_per_s[1] / proof.peak_velocity_m_per_s[0];
    let widest = proofs().map(|(row, proof)| (row, width(proof)));
    let cycles = || proofs().filter(|(_, proof)| proof.period_s().is_some());
    let gap = |one: &Certificate, other: &Certificate| {
        let [a, b] = [one, other].map(|proof| proof.peak_velocity_m_per_s[0]);
        -libm::fabs(libm::log(a / b))
    };
    let near = cycles().zip(cycles().skip(1)).filter(|((row, _), (next, _))| row + 1 == *next);
    let nearest = greatest(near.map(|((row, one), (_, other))| (row, gap(one, other))));
    let found: [Option<usize>; EXTREMES] =
        [greatest(weakest), greatest(widest), nearest, nearest.map(|row| row + 1)];
    found.into_iter().flatten()
}

fn greatest(values: impl Iterator<Item = (usize, f64)>) -> Option<usize> {
    values.max_by(|one, other| one.1.total_cmp(&other.1)).map(|(row, _)| row)
}

/// Certifies every point of a section's grid with one law, row by row of constant normal stress.
pub(crate) fn certify_grid(
    slider: &Slider<Rational>,
    section: &SimulationsSection,
    law: EvolutionLaw,
) -> Vec<Stored> {
    let grid = Grid::of(slider, section);
    let certified = |&point: &usize| {
        let inputs = grid.inputs(point);
        // What is certified is what the row says.
        let parameters =
            Parameters::from(inputs.each_ref().map(|text| parse_decimal(text).unwrap_or_default()));
        let found = certify(&parameters, law, Start::default());
        Stored::of(inputs, parameters, law, found)
    };
    parallel::map(&Vec::from_iter(0..grid.points()), certified)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::certificates::stored::read_stored;
    use crate::experiments::certificates::{CertificateFile, written};
    use crate::experiments::shared::fixtures::paper;
    use crate::scene::{LogAxis, Rectangle};

    /// A decay and three cycles.
    fn rows() -> Vec<Stored> {
        let axis = |[from, to]: [&str; 2]| LogAxis {
            from: parse_decimal(from).unwrap(),
            to: parse_decimal(to).unwrap(),
            points: 2,
        };
        let rectangle = Rectangle {
            loading_velocity_m_per_s: axis(["1e-3", "1e-2"]),
            normal_stress_pa: axis(["1e3", "1e5"]),
        };
        let section = SimulationsSection {
            rectangle,
            laws: vec![EvolutionLaw::Slip],
            tolerance: parse_decimal("1e-8").unwrap(),
        };
        certify_grid(&paper(), &section, EvolutionLaw::Slip)
    }

    fn read(text: &str, sha256: &str) -> Result<Vec<Stored>, String> {
        let entry = CertificateFile { name: "c".into(), sha256: "0".repeat(64) };
        let read = read_stored(&entry, sha256, ("c.csv", text)).map_err(|faults| faults[0].to_string());
        read.map(|rows| rows.into_iter().map(|(_, row)| row).collect())
    }

    #[test]
    fn what_is_written_is_read_back_and_proved_again_and_another_file_is_refused() {
        let (rows, zeros) = (rows(), "0".repeat(64));
        let text = written(&rows);
        assert_eq!(read(&text, &zeros).unwrap(), rows);
        assert!(read(&text, "1").unwrap_err().contains("to be the file of SHA-256"));
        let kinds: Vec<bool> =
            rows.iter().map(|row| row.certificate.as_ref().unwrap().period_s().is_some()).collect();
        assert_eq!(kinds, [false, true, true, true]);
        let all = Certificates::of(vec![rows.clone(), rows.clone()], 1);
        let again: Vec<usize> = all.again.iter().map(|again| again.row).collect();
        // The first, and as extremes the two neighbouring cycles whose peaks differ least; one of them attracts least.
        assert_eq!(again[..3], [0, 1, 2]);
        assert!(again[3..].iter().zip(&again[..3]).all(|(second, first)| *second == first + 4), "{again:?}");
        assert_eq!((all.refusal(), all.rows.iter().filter(|row| row.certificate.is_ok()).count()), (None, 8));
        assert_eq!(all.at(EvolutionLaw::Slip, 1e-2, 1e5), rows[3].certificate.as_ref().ok());
        assert_eq!(all.at(EvolutionLaw::Aging, 1e-2, 1e5), None);
        for (from, to, named) in [
            (",cycle,", ",cycles,", "c.csv:3: certificate = cycles"),
            (",force,", ",x,", "c.csv:3: second_coordinate = x"),
            ("0.004,0.006", "0,0.006", "c.csv:2: direct_effect"),
            (",slip,", ",slipp,", "c.csv:2: law"),
            ("law,", "laws,", "c.csv:1: header"),
            (",decay,", ",decay,,", "c.csv:2: "),
        ] {
            assert!(text.contains(from), "{from}");
            let fault = read(&text.replacen(from, to, 1), &zeros).unwrap_err();
            assert!(fault.contains(named), "{fault}: {named}");
        }
    }

    /// A bound, a box, a law or a parameter that is a part of 10⁻⁹ off is not proved.
    #[test]
    fn a_stored_certificate_with_a_planted_fault_is_not_proved_again() {
        let rows = rows();
        let faults: [fn(&mut Stored, f64); 6] = [
            |row, by| {
                row.certificate.iter_mut().for_each(|proof| shift(&mut proof.peak_velocity_m_per_s, by))
            },
            |row, by| row.certificate.iter_mut().for_each(|proof| shift(&mut proof.stress_drop_pa, by)),
            |row, by| {
                if let Ok(Certificate { proved: Proved::Cycle { period_s, .. }, .. }) = &mut row.certificate {
                    shift(period_s, by);
                }
            },
            |row, by| {
                if let Ok(Certificate { proved: Proved::Cycle { state_box, .. }, .. }) = &mut row.certificate
                {
                    shift(state_box, by);
                }
            },
            |row, _| row.law = EvolutionLaw::Aging,
            |row, by| row.parameters.slider.mass_per_area_kg_per_m2 *= Rational::from_f64(1.0 + by).unwrap(),
        ];
        for row in &rows[2..] {
            assert_eq!(row.refusal(), None);
            for (number, fault) in faults.iter().enumerate() {
                for by in [-1e-9, 1e-9] {
                    let mut faulty = row.clone();
                    fault(&mut faulty, by);
                    assert!(faulty.refusal().is_some(), "{number} {by}");
                }
            }
        }
        let mut decay = rows[0].clone();
        decay.certificate.clone_from(&rows[2].certificate);
        assert!(decay.refusal().is_some());
        let all = Certificates::of(vec![vec![decay]], 1);
        assert!(all.refusal().unwrap().contains("is not proved again"));
    }

    fn shift(ends: &mut [f64; 2], by: f64) {
        *ends = ends.map(|end| end * (1.0 + by));
    }
}
