//! The grid that a file of certificates must have, row by row: neither a point less, nor one more, nor another order.

use std::cmp::Ordering;

use crate::experiments::Scene;
use crate::experiments::certificates::stored::read_stored;
use crate::experiments::certificates::{CertificateFile, Stored};
use crate::experiments::simulations::SimulationsSection;
use crate::scene::{CsvProblem, Fault, Faults, Problem, Quantity};
use slipmode_core::friction::{EvolutionLaw, Parameters, Slider};
use slipmode_core::number::format::shortest;
use slipmode_core::number::{Rational, nearest_f64, parse_decimal};

/// The points of `[simulations]`, row by row of constant normal stress, as the decimals that a file of certificates has.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    slider: [String; 5],
    stresses_pa: Vec<f64>,
    velocities_m_per_s: Vec<f64>,
    laws: Vec<EvolutionLaw>,
}

impl Grid {
    /// The grid of a slider.
    pub(super) fn of(slider: &Slider<Rational>, section: &SimulationsSection) -> Self {
        Self {
            slider: slider.map(|value| shortest(nearest_f64(value))).into(),
            stresses_pa: section.rectangle.normal_stress_pa.coordinates(),
            velocities_m_per_s: section.rectangle.loading_velocity_m_per_s.coordinates(),
            laws: section.laws.clone(),
        }
    }

    /// The number of points.
    pub(super) fn points(&self) -> usize {
        self.stresses_pa.len() * self.velocities_m_per_s.len()
    }

    /// The seven decimals of a point.
    pub(super) fn inputs(&self, point: usize) -> [String; 7] {
        let count = self.velocities_m_per_s.len();
        let place = [self.stresses_pa[point / count], self.velocities_m_per_s[point % count]];
        let [a, b, d, k, m] = self.slider.clone();
        let [stress, velocity] = place.map(shortest);
        [a, b, d, k, m, stress, velocity]
    }

    /// Whether a row is for a point.
    fn is_at(&self, row: &Stored, point: usize) -> bool {
        let texts = self.inputs(point);
        row.parameters
            == Parameters::from(texts.each_ref().map(|text| parse_decimal(text).unwrap_or_default()))
    }

    /// The point of a row, if the grid has it.
    fn point_of(&self, row: &Stored) -> Option<usize> {
        let place = &row.parameters.point;
        let index = |value: &Rational, coordinates: &[f64]| {
            coordinates.iter().position(|coordinate| *coordinate == nearest_f64(value))
        };
        let stress = index(&place.normal_stress_pa, &self.stresses_pa)?;
        let velocity = index(&place.loading_velocity_m_per_s, &self.velocities_m_per_s)?;
        let point = stress * self.velocities_m_per_s.len() + velocity;
        self.is_at(row, point).then_some(point)
    }

    /// A point, in words.
    fn words(&self, point: usize) -> String {
        let [.., stress, velocity] = self.inputs(point);
        format!("σ = {stress} Pa, V_l = {velocity} m/s")
    }

    /// The first row, each with its line, that is not the one that the grid has there.
    fn fault(&self, file: &str, rows: &[(usize, Stored)]) -> Option<Fault> {
        let rest = rows.len().max(self.points());
        (0..rest).find_map(|index| {
            let row = rows.get(index);
            let (key, value, problem) = match row {
                Some((_, row)) => self.fault_of_row(row, index, rows)?,
                None => (row_key(index), None, self.missing(index, rows)),
            };
            let line = row.or(rows.last()).map_or(1, |(line, _)| *line);
            Some(Fault { file: file.into(), line: Some(line), key, value, problem })
        })
    }

    /// What is wrong with a row: key, value and problem.
    fn fault_of_row(
        &self,
        row: &Stored,
        index: usize,
        rows: &[(usize, Stored)],
    ) -> Option<(String, Option<String>, Problem)> {
        let of_row = |text: String| Some((row_key(index), None, off_grid(text)));
        let law = &rows[0].1.law;
        if index == 0 && !self.laws.contains(law) {
            let laws: Vec<&str> = self.laws.iter().map(|law| law.as_str()).collect();
            let allowed = format!("a law of [simulations]: {}", laws.join(", "));
            return Some(("law".into(), Some(law.as_str().into()), Problem::OutOfRange { allowed }));
        }
        if row.law != *law {
            let words = [row.law, *law].map(EvolutionLaw::as_str);
            return of_row(format!(
                "out of place: {} law (all other rows have the {} law)",
                words[0], words[1]
            ));
        }
        if index < self.points() && self.is_at(row, index) {
            return None;
        }
        let inputs = row.inputs().iter().zip(&self.slider).zip(Quantity::ALL);
        for ((text, wanted), quantity) in inputs {
            if parse_decimal(text) != parse_decimal(wanted) {
                let problem = off_grid(format!("another slider's (the scene has {wanted})"));
                return Some((quantity.as_str().into(), Some(text.clone()), problem));
            }
        }
        let here = match index < self.points() {
            true => format!("the grid of [simulations] has here {}", self.words(index)),
            false => self.counts(rows),
        };
        let Some(point) = self.point_of(row) else {
            let [.., stress, velocity] = row.inputs() else { return None };
            return of_row(format!("σ = {stress} Pa, V_l = {velocity} m/s is no point of the grid ({here})"));
        };
        let words = self.words(point);
        match point.cmp(&index) {
            Ordering::Less => of_row(format!("repeated: {words} is row {} already ({here})", point + 1)),
            _ if rows[index..].iter().any(|(_, other)| self.is_at(other, index)) => {
                of_row(format!("out of place: {words} belongs into row {} ({here})", point + 1))
            }
            _ => Some((row_key(index), None, self.missing(index, rows))),
        }
    }

    fn missing(&self, point: usize, rows: &[(usize, Stored)]) -> Problem {
        off_grid(format!("missing: {} ({})", self.words(point), self.counts(rows)))
    }

    fn counts(&self, rows: &[(usize, Stored)]) -> String {
        format!("points of the grid of [simulations]: {}; rows of the file: {}", self.points(), rows.len())
    }
}

fn row_key(index: usize) -> String {
    format!("row {}", index + 1)
}

fn off_grid(text: String) -> Problem {
    CsvProblem::OffGrid(text).into()
}

/// The files of certificates of one scene, each of which must have the scene's grid with a law of its own.
#[derive(Debug)]
pub struct StoredFiles {
    scene: String,
    grid: Option<Grid>,
    laws: Vec<(EvolutionLaw, String)>,
}

impl StoredFiles {
    /// The files of a scene, none of which is read yet.
    pub(crate) fn of(scene: &Scene) -> Self {
        let both = scene.parameters.as_ref().zip(scene.simulations.as_ref());
        let grid = both.map(|(parameters, section)| Grid::of(&parameters.slider, section));
        Self { scene: scene.name.clone(), grid, laws: Vec::new() }
    }

    /// The rows of a file.
    ///
    /// # Errors
    /// When the file is another one, has other columns, or a cell is at fault; when the rows are not those of the scene's grid; when an earlier file has the same law.
    pub fn read(
        &mut self,
        entry: &CertificateFile,
        digest: &str,
        (file, text): (&str, &str),
    ) -> Result<Vec<Stored>, Faults> {
        let fault = |key: &str, value, problem| {
            vec![Fault { file: file.into(), line: None, key: key.into(), value, problem }]
        };
        let rows = read_stored(entry, digest, (file, text))?;
        let Some(grid) = &self.grid else {
            let needed =
                format!("a section [simulations] in the scene `{}`: its grid has the rows", self.scene);
            return Err(fault("", None, Problem::Needs(needed)));
        };
        if let Some(fault) = grid.fault(file, &rows) {
            return Err(vec![fault]);
        }
        let law = rows.first().map(|(_, row)| row.law);
        if let Some((law, first)) = self.laws.iter().find(|(earlier, _)| Some(*earlier) == law) {
            let problem = Problem::Duplicate { of: format!("the law of {first}"), folded: false };
            return Err(fault("law", Some(law.as_str().into()), problem));
        }
        self.laws.extend(law.map(|law| (law, file.to_string())));
        Ok(rows.into_iter().map(|(_, row)| row).collect())
    }
}
