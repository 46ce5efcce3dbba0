//! The points of a sweep from both kinds of source, block by block.

use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};
use slipmode::archive::finished_hex;
use slipmode::csv::{Block, Dialect, RowReader, Work};
use slipmode::sweep::{Blocks, Shard};

use crate::cli::failure::Failure;
use crate::cli::input::open_named_csv;
use crate::cli::points::print_columns;
use crate::cli::sweep::block_file::MOST_BLOCKS;
use crate::cli::sweep::work::{Lines, MadePoints, PointWork, listed_lines};

/// Where points come from, with the work at each.
pub enum Points {
    /// From the scene.
    Made(Box<dyn MadePoints>),
    /// From a CSV file.
    Listed(Listed),
}

/// The rows of a CSV file.
pub struct Listed {
    place: PathBuf,
    columns: Vec<u8>,
    work: Box<dyn Fn(&Block) -> Lines + Send + Sync>,
    rows: u64,
    /// SHA-256 of the header, and then of each block's rows: what is computed from is compared with it again.
    digests: Vec<[u8; 32]>,
}

/// A block to be worked on.
pub struct Job {
    /// Its number.
    pub block: u64,
    rows: Option<Block>,
}

/// Points of a part of a block whose rows are not kept.
const PART_POINTS: u64 = 1 << 12;

impl Listed {
    /// Reads the header of a file, counts its rows, and digests them block by block.
    ///
    /// # Errors
    /// When it cannot be read, or its header or form is at fault.
    pub fn new<W: PointWork + 'static>(place: &Path, command: W, block_points: u64) -> Result<Self, Failure> {
        let mut reader = open_named_csv(place, Dialect::default())?;
        let file = reader.name().to_string();
        let first = reader.block(1)?;
        // A faulty row gets a cell that says so: one of them must not cost the others their results.
        let keep_going = true;
        let header = command.read_header(&file, first.rows().next(), keep_going)?;
        print_columns(&header);
        let (mut rows, mut digests) = (0, vec![rows_digest(&first)]);
        loop {
            let block = reader.block(usize::try_from(block_points).unwrap_or(usize::MAX))?;
            if block.is_empty() {
                break;
            }
            rows += block.rows().count() as u64;
            digests.push(rows_digest(&block));
        }
        let work = Work { file, header, command, keep_going };
        let columns = work.header_line();
        let work = Box::new(move |rows: &Block| listed_lines(&work, rows));
        Ok(Self { place: place.to_path_buf(), columns, work, rows, digests })
    }

    /// A reader behind the header.
    fn reader(&self) -> Result<RowReader, Failure> {
        let mut reader = open_named_csv(&self.place, Dialect::default())?;
        let header = reader.block(1)?;
        self.check(0, &header)?;
        Ok(reader)
    }

    /// Refuses rows that are not those of the first reading: the origin of blocks names these.
    fn check(&self, index: u64, rows: &Block) -> Result<(), Failure> {
        let first = usize::try_from(index).ok().and_then(|index| self.digests.get(index));
        if first == Some(&rows_digest(rows)) {
            return Ok(());
        }
        Err(Failure::place(&self.place, "changed while it was read; run the sweep again"))
    }
}

/// SHA-256 of rows: the number of cells, then each cell with its length.
fn rows_digest(rows: &Block) -> [u8; 32] {
    let mut digest = Sha256::new();
    for row in rows.rows() {
        digest.update((row.cell_count() as u64).to_le_bytes());
        for cell in (0..row.cell_count()).map(|index| row.cell(index)) {
            digest.update((cell.len() as u64).to_le_bytes());
            digest.update(cell);
        }
    }
    digest.finalize().into()
}

impl Points {
    /// SHA-256 of what the points come from: the scene, and the rows of its list.
    pub fn digest(&self, scene: &str) -> String {
        match self {
            Self::Made(_) => scene.to_string(),
            Self::Listed(listed) => {
                let digest = Sha256::new_with_prefix(scene);
                finished_hex(listed.digests.iter().fold(digest, |digest, rows| digest.chain_update(rows)))
            }
        }
    }

    /// The blocks of the sweep.
    ///
    /// # Errors
    /// When there are more of them than a folder should hold.
    pub fn blocks(&self, block_points: u64) -> Result<Blocks, Failure> {
        let points = match self {
            Self::Made(made) => made.count(),
            Self::Listed(listed) => listed.rows,
        };
        let blocks = Blocks { points, block_points };
        match blocks.count() {
            0 => Err(Failure::Refused("the sweep has no points".into())),
            count if count > MOST_BLOCKS => Err(Failure::Refused(format!(
                "{points} points make {count} blocks of {block_points} (allowed: at most {MOST_BLOCKS} blocks; \
                 sweep.block_points sets their size)"
            ))),
            _ => Ok(blocks),
        }
    }

    /// The line of column names.
    pub fn columns(&self) -> Vec<u8> {
        match self {
            Self::Made(made) => made.columns(),
            Self::Listed(listed) => listed.columns.clone(),
        }
    }

    /// The blocks of a shard in their order, those of a list with their rows.
    ///
    /// # Errors
    /// When the list cannot be opened.
    pub fn jobs(
        &self,
        blocks: Blocks,
        shard: Shard,
    ) -> Result<Box<dyn Iterator<Item = Result<Job, Failure>> + Send + '_>, Failure> {
        match self {
            Self::Made(_) => Ok(Box::new(blocks.of_shard(shard).map(|block| Ok(Job { block, rows: None })))),
            Self::Listed(listed) => {
                let mut reader = listed.reader()?;
                let read = move |block: u64| -> Result<Option<Job>, Failure> {
                    let range = blocks.range(block);
                    let wanted = usize::try_from(range.end - range.start).unwrap_or(usize::MAX);
                    let rows = reader.block(wanted)?;
                    listed.check(block + 1, &rows)?;
                    let is_ours = Shard::of_block(block, shard.count) == shard.index;
                    Ok(is_ours.then_some(Job { block, rows: Some(rows) }))
                };
                Ok(Box::new((0..blocks.count()).map(read).filter_map(Result::transpose)))
            }
        }
    }

    /// The lines of a block.
    pub fn lines(&self, blocks: Blocks, job: &Job) -> Lines {
        match (self, &job.rows) {
            (Self::Listed(listed), Some(rows)) => (listed.work)(rows),
            (Self::Made(made), _) => made.lines(&mut blocks.range(job.block)),
            (Self::Listed(_), None) => Lines::default(),
        }
    }

    /// The lines of a block in parts that take little memory; those of a list, whose rows were read already, in one.
    pub fn parts(&self, blocks: Blocks, job: &Job) -> impl Iterator<Item = Lines> {
        let range = blocks.range(job.block);
        let step = if job.rows.is_some() { u64::MAX } else { PART_POINTS };
        let starts = std::iter::successors(Some(range.start), move |start| start.checked_add(step))
            .take_while(move |start| *start < range.end);
        starts.map(move |start| match self {
            Self::Made(made) => made.lines(&mut (start..range.end.min(start.saturating_add(step)))),
            Self::Listed(_) => self.lines(blocks, job),
        })
    }

    /// The lines of `count` points spread evenly over the sweep, or of a list's first rows; and how many they are.
    ///
    /// # Errors
    /// When the list cannot be read.
    pub fn sample(&self, blocks: Blocks, count: u64) -> Result<(Lines, u64), Failure> {
        let count = count.clamp(1, blocks.points);
        match self {
            Self::Made(made) => {
                let number =
                    |index| (u128::from(blocks.points) * (2 * index + 1) / (2 * u128::from(count))) as u64;
                Ok((made.lines(&mut (0..u128::from(count)).map(number)), count))
            }
            Self::Listed(listed) => {
                let rows = listed.reader()?.block(usize::try_from(count).unwrap_or(usize::MAX))?;
                Ok(((listed.work)(&rows), count))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::cli::sweep::asymptote_rows::AsymptoteRows;

    const HEADER: &str = "direct_effect,evolution_effect,critical_slip_distance_m,stiffness_pa_per_m,\
        mass_per_area_kg_per_m2,normal_stress_pa,loading_velocity_m_per_s";

    fn list(stresses: &[u32]) -> String {
        let row = |stress: &u32| format!("0.004,0.006,1e-5,1e7,1000,{stress}e3,1e-3\n");
        format!("{HEADER}\n{}", stresses.iter().map(row).collect::<String>())
    }

    /// Reads a list, changes it, and gives the faults of the jobs that follow.
    fn faults_after(changed: &str) -> Vec<String> {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("points.csv");
        fs::write(&place, list(&[1, 2, 3, 4, 5])).unwrap();
        let points = Points::Listed(Listed::new(&place, AsymptoteRows, 2).unwrap());
        let blocks = points.blocks(2).unwrap();
        fs::write(&place, changed).unwrap();
        let message = |failure: Failure| match failure {
            Failure::Refused(message) => message,
            _ => "another failure".into(),
        };
        match points.jobs(blocks, Shard { index: 0, count: 1 }) {
            Ok(jobs) => jobs.filter_map(Result::err).map(message).collect(),
            Err(failure) => vec![message(failure)],
        }
    }

    #[test]
    fn a_list_that_changes_between_two_readings_is_refused() {
        assert!(faults_after(&list(&[1, 2, 3, 4, 5])).is_empty());
        let other_header = list(&[1, 2, 3, 4, 5])
            .replace("direct_effect,evolution_effect", "evolution_effect,direct_effect");
        for (changed, faults) in [
            (list(&[1, 2, 3, 4, 6]), 1),
            (list(&[1, 2, 4, 3, 5]), 1),
            (list(&[2, 1, 3, 4]), 2),
            (other_header, 1),
        ] {
            let found = faults_after(&changed);
            assert_eq!(found.len(), faults, "{found:?}");
            assert!(found[0].contains("points.csv: changed while it was read"), "{found:?}");
        }
    }

    #[test]
    fn the_digest_of_a_sweep_follows_from_scene_and_rows() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("points.csv");
        let digest = |text: &str, scene: &str| {
            fs::write(&place, text).unwrap();
            Points::Listed(Listed::new(&place, AsymptoteRows, 2).unwrap()).digest(scene)
        };
        let rows = list(&[1, 2, 3]);
        assert_eq!(digest(&rows, "s"), digest(&rows, "s"));
        assert_ne!(digest(&rows, "s"), digest(&rows, "t"));
        assert_ne!(digest(&rows, "s"), digest(&list(&[1, 2, 4]), "s"));
        // A cell's end is part of the digest.
        let name = |row: &str| format!("name,{HEADER}\n{row}");
        assert_ne!(
            digest(&name("a1,0.004,0.006,1e-5,1e7,1000,1e3,1e-3\n"), "s"),
            digest(&name("a,10.004,0.006,1e-5,1e7,1000,1e3,1e-3\n"), "s")
        );
    }
}
