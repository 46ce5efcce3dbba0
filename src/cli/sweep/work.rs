//! What a sweep does at a point: the same work that `--points` does with a row, on points that are made instead of read.

use slipmode::csv::{Block, RowWork, Work};
use slipmode::scene::Quantity;
use slipmode::sweep::{PointSource, Varying};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::shortest;
use slipmode_core::stability::{NearestPlace, classify, classify_quickly};

use crate::cli::classify::rows::{Classified, ClassifyRows, RowFound};
use crate::cli::simulate::rows::SimulateRows;
use crate::cli::sweep::asymptote_rows::AsymptoteRows;
use crate::cli::sweep::boundary_rows::BoundaryRows;
use crate::cli::words::LAW_COLUMN;

/// Work that takes points which were made.
pub trait PointWork: RowWork + Send {
    /// What the work takes, of a point and a law.
    fn input(&self, source: &PointSource, point: &Varying, law: EvolutionLaw) -> Self::Input;
}

impl PointWork for ClassifyRows<false> {
    fn input(&self, source: &PointSource, point: &Varying, _law: EvolutionLaw) -> Self::Input {
        let at_point = || {
            classify_quickly(&source.double_double(point), &self.threshold)
                .unwrap_or_else(|| classify(&source.exact(point), &self.threshold))
        };
        let region = source.region(point);
        let found = region.and_then(|region| RowFound::over(&region, &self.threshold));
        // The scene's units are checked once, not at each point.
        Classified {
            found: found.unwrap_or_else(|| RowFound::Point(at_point())),
            derived: None,
            warnings: Vec::new(),
        }
    }
}

impl PointWork for BoundaryRows {
    fn input(&self, source: &PointSource, point: &Varying, _law: EvolutionLaw) -> Self::Input {
        source.exact(point)
    }
}

impl PointWork for AsymptoteRows {
    fn input(&self, source: &PointSource, point: &Varying, _law: EvolutionLaw) -> Self::Input {
        NearestPlace::quickly(&source.double_double(point))
            .unwrap_or_else(|_| NearestPlace::of(&source.exact(point)))
    }
}

impl PointWork for SimulateRows<false> {
    fn input(&self, source: &PointSource, point: &Varying, law: EvolutionLaw) -> Self::Input {
        (source.exact(point), source.region(point), law)
    }
}

/// The lines of a block, and how many of its points have no answer.
#[derive(Debug, Default)]
pub struct Lines {
    /// The text.
    pub text: Vec<u8>,
    /// Points whose row says why it has no answer, or what is wrong with it.
    pub unanswered: u64,
}

/// Points that are made, and the work at each.
#[derive(Debug)]
pub struct Made<W> {
    /// The points.
    pub source: PointSource,
    /// The laws, each taken at every point; empty when the work knows none.
    pub laws: Vec<EvolutionLaw>,
    /// The work.
    pub work: W,
}

/// Points that are made, whatever the work at each is.
pub trait MadePoints: Send + Sync {
    /// How many rows there are.
    fn count(&self) -> u64;

    /// The line of column names.
    fn columns(&self) -> Vec<u8>;

    /// The rows of these numbers.
    fn lines(&self, numbers: &mut dyn Iterator<Item = u64>) -> Lines;
}

impl<W: PointWork> MadePoints for Made<W> {
    fn count(&self) -> u64 {
        self.source.count().saturating_mul(self.laws.len().max(1) as u64)
    }

    fn columns(&self) -> Vec<u8> {
        let varying = self.source.varying().into_iter().map(|index| Quantity::ALL[index].as_str());
        let law = (!self.laws.is_empty()).then_some(LAW_COLUMN);
        let names: Vec<&str> = varying.chain(law).chain(W::APPENDED.iter().copied()).collect();
        format!("{}\n", names.join(",")).into_bytes()
    }

    fn lines(&self, numbers: &mut dyn Iterator<Item = u64>) -> Lines {
        let (varying, laws) = (self.source.varying(), self.laws.len().max(1) as u64);
        let mut lines = Lines::default();
        for number in numbers {
            let point = self.source.at(number / laws);
            for (place, index) in varying.iter().enumerate() {
                if place > 0 {
                    lines.text.push(b',');
                }
                lines.text.extend_from_slice(shortest(point[*index]).as_bytes());
            }
            let law = self.laws.get((number % laws) as usize);
            if let Some(law) = law {
                lines.text.push(b',');
                lines.text.extend_from_slice(law.as_str().as_bytes());
            }
            let input = self.work.input(&self.source, &point, law.copied().unwrap_or(EvolutionLaw::Slip));
            lines.unanswered += u64::from(self.work.append(&input, &mut lines.text).is_unanswered);
            lines.text.push(b'\n');
        }
        lines
    }
}

/// The rows of a list.
pub fn listed_lines<W: RowWork>(work: &Work<W>, rows: &Block) -> Lines {
    let worked = work.block(rows, false);
    Lines { text: worked.text, unanswered: worked.counts.unanswered + worked.counts.faulty }
}
