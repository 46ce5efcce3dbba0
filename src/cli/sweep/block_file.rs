//! A block's file: a heading of nine lines and an empty one, then CSV; written whole or not at all, checked by its digest.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};
use slipmode::archive::finished_hex;

use crate::cli::failure::Failure;
use crate::cli::input::open_regular;
use crate::cli::output::{Output, check_input};

/// The first line of every block.
const FORMAT: &str = "slipmode block 1";
/// The longest heading that is read, in bytes.
const LONGEST_HEADING: u64 = 1024;
/// The lines of a heading, the empty one included.
const HEADING_LINES: usize = 10;

/// The most blocks of a sweep, each of which is a file.
pub const MOST_BLOCKS: u64 = 10_000_000;

/// What all blocks of a sweep have in common.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Origin {
    /// SHA-256 of the scene and of the list that it names.
    pub scene: String,
    /// The program's version with the digest of its sources.
    pub version: String,
    /// The number of blocks of the sweep.
    pub blocks: u64,
    /// What its lines are.
    pub content: Content,
}

/// What the lines of a block are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Content {
    /// A row for each point.
    Rows,
    /// Rows summed up; so many columns are keys.
    Summary(usize),
}

impl Content {
    fn text(self) -> String {
        match self {
            Self::Rows => "rows".into(),
            Self::Summary(keys) => format!("summary {keys}"),
        }
    }

    fn parse(text: &str) -> Option<Self> {
        match text.split_once(' ') {
            None => (text == "rows").then_some(Self::Rows),
            Some((word, keys)) => (word == "summary").then_some(Self::Summary(keys.parse().ok()?)),
        }
    }
}

impl Origin {
    /// How many blocks there are, if no sweep has so many.
    pub fn count_fault(&self) -> Option<String> {
        (self.blocks > MOST_BLOCKS)
            .then(|| format!("is one of {} blocks (allowed: at most {MOST_BLOCKS})", self.blocks))
    }

    /// How a block of this origin does not belong to another's sweep, if it does not.
    pub fn difference(&self, other: &Self) -> Option<String> {
        if self.scene != other.scene {
            let [own, others] = [&self.scene, &other.scene].map(|digest| short(digest));
            return Some(format!("belongs to another scene ({own}, not {others})"));
        }
        if self.version != other.version {
            return Some(format!("is of another program version ({}, not {})", self.version, other.version));
        }
        if self.blocks != other.blocks {
            return Some(format!("is one of {} blocks, not of {}", self.blocks, other.blocks));
        }
        // All blocks of one scene and one program agree here, unless their headings were edited.
        (self.content != other.content)
            .then(|| format!("holds {}, not {}", self.content.text(), other.content.text()))
    }
}

/// The beginning of a digest, enough to tell two apart by eye.
fn short(digest: &str) -> String {
    digest.chars().take(12).collect()
}

/// The heading of a block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Heading {
    /// Whose block it is.
    pub origin: Origin,
    /// Its number, counted from 0.
    pub block: u64,
    /// Its points.
    pub points: u64,
    /// The bytes of the line of column names, the first of its CSV.
    pub columns: u64,
    /// All bytes of its CSV.
    pub bytes: u64,
    /// SHA-256 of the heading before this line, and of the CSV.
    sha256: String,
}

/// The file of a block.
pub fn block_name(block: u64) -> String {
    format!("block-{block:09}.csv")
}

/// The number of the block whose file has this name, exactly.
pub fn block_of_name(name: &str) -> Option<u64> {
    let block = name.strip_prefix("block-")?.strip_suffix(".csv")?.parse().ok()?;
    (block_name(block) == name).then_some(block)
}

impl Heading {
    /// A heading without its digest.
    pub fn of(origin: Origin, block: u64, points: u64, columns: u64, bytes: u64) -> Self {
        Self { origin, block, points, columns, bytes, sha256: String::new() }
    }

    fn stated(&self) -> String {
        let Self { origin, block, points, columns, bytes, .. } = self;
        let Origin { scene, version, blocks, content } = origin;
        let content = content.text();
        format!(
            "{FORMAT}\nscene {scene}\nversion {version}\nblock {block} of {blocks}\npoints {points}\n\
             holds {content}\ncolumns {columns}\nbytes {bytes}\n"
        )
    }

    fn text(&self) -> String {
        format!("{}sha256 {}\n\n", self.stated(), self.sha256)
    }

    /// Parses a heading; only the very text that the writer would write is one.
    fn parse(text: &str) -> Option<Self> {
        let mut lines = text.lines().skip(1);
        let mut value = |key: &str| lines.next()?.strip_prefix(key)?.strip_prefix(' ');
        let (scene, version) = (value("scene")?.to_string(), value("version")?.to_string());
        let (block, blocks) = value("block")?.split_once(" of ")?;
        let number = |text: &str| text.parse::<u64>().ok();
        let (block, blocks) = (number(block)?, number(blocks)?);
        let points = number(value("points")?)?;
        let content = Content::parse(value("holds")?)?;
        let heading = Self {
            origin: Origin { scene, version, blocks, content },
            block,
            points,
            columns: number(value("columns")?)?,
            bytes: number(value("bytes")?)?,
            sha256: value("sha256")?.to_string(),
        };
        (heading.text() == text && heading.columns <= heading.bytes && heading.block < heading.origin.blocks)
            .then_some(heading)
    }
}

/// A block's file, its heading read.
pub struct OpenBlock {
    /// The heading, not yet compared with the content.
    pub heading: Heading,
    reader: BufReader<File>,
    name: PathBuf,
}

/// What the CSV of a block consists of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Contents {
    /// The line of column names.
    pub columns: Vec<u8>,
    /// The first fault of its rows and columns, if any.
    pub fault: Option<String>,
}

impl OpenBlock {
    /// Opens a block of a folder and reads its heading; a length other than the stated one is found here. The inner error is
    /// that there is no such file, which `merge` has listed, or that it does not hold.
    ///
    /// # Errors
    /// When it cannot be read.
    pub fn open(folder: &Path, block: u64) -> Result<Result<Self, String>, Failure> {
        let name = folder.join(block_name(block));
        let unreadable = |error| Failure::io(&name, "cannot be read")(error);
        // A block that the command is going to overwrite must not be read by it.
        let file = match open_regular(&name).and_then(|file| check_input(&file).map(|()| file)) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                return Ok(Err("changed while the blocks were merged".into()));
            }
            file => file.map_err(unreadable)?,
        };
        let size = file.metadata().map_err(unreadable)?.len();
        let mut reader = BufReader::with_capacity(1 << 16, file);
        let mut text = Vec::new();
        let mut limited = (&mut reader).take(LONGEST_HEADING);
        for _ in 0..HEADING_LINES {
            limited.read_until(b'\n', &mut text).map_err(unreadable)?;
        }
        let heading = std::str::from_utf8(&text).ok().and_then(Heading::parse);
        let Some(heading) = heading else { return Ok(Err("has no valid heading".into())) };
        let stated = text.len() as u64 + heading.bytes;
        Ok(match size {
            size if size < stated => Err(format!("truncated: {size} of {stated} bytes")),
            size if size > stated => Err(format!("too long: {size} bytes, not {stated}")),
            _ => Ok(Self { heading, reader, name }),
        })
    }

    /// Writes the CSV, without its column names unless `with_columns`, and then gives its contents; the inner error is that the digest
    /// is not the stated one.
    ///
    /// # Errors
    /// When it cannot be read or written.
    pub fn copy(
        mut self,
        with_columns: bool,
        out: &mut impl Write,
    ) -> Result<Result<Contents, String>, Failure> {
        let mut digest = Sha256::new().chain_update(self.heading.stated());
        let mut shape = Shape::default();
        let mut skipped = if with_columns { 0 } else { self.heading.columns };
        let mut buffer = vec![0; 1 << 16];
        loop {
            let count = self.reader.read(&mut buffer).map_err(Failure::io(&self.name, "cannot be read"))?;
            if count == 0 {
                break;
            }
            digest.update(&buffer[..count]);
            shape.add(&buffer[..count]);
            let from = usize::try_from(skipped).unwrap_or(usize::MAX).min(count);
            skipped -= from as u64;
            out.write_all(&buffer[from..count])?;
        }
        if finished_hex(digest) == self.heading.sha256 {
            let fault = shape.fault(&self.heading);
            return Ok(Ok(Contents { columns: shape.columns, fault }));
        }
        Ok(Err("damaged or altered: its SHA-256 is not the stated one".into()))
    }
}

/// Writes a block: next to its place, synced, renamed.
///
/// # Errors
/// When it cannot be written; nothing is left behind then.
pub fn write_block(
    folder: &Path,
    origin: &Origin,
    (block, points): (u64, u64),
    columns: &[u8],
    lines: &[u8],
) -> Result<(), Failure> {
    let bytes = (columns.len() + lines.len()) as u64;
    let mut heading = Heading::of(origin.clone(), block, points, columns.len() as u64, bytes);
    let digest = Sha256::new().chain_update(heading.stated()).chain_update(columns).chain_update(lines);
    heading.sha256 = finished_hex(digest);
    let mut output = Output::replace(&folder.join(block_name(block)))?;
    for part in [heading.text().as_bytes(), columns, lines] {
        output.write_all(part)?;
    }
    output.commit()
}

/// The longest line of column names that is kept, in bytes.
const LONGEST_COLUMNS: u64 = 1 << 21;

/// What is known of a CSV text after a part of it.
#[derive(Default)]
pub struct Shape {
    /// The line of column names.
    pub columns: Vec<u8>,
    bytes: u64,
    rows: u64,
    /// Bytes of the first row, with its end.
    first_row_bytes: u64,
    /// Cells of the first row.
    width: u64,
    separators: u64,
    is_quoted: bool,
    is_row_open: bool,
    ragged_row: Option<u64>,
    has_nul: bool,
}

impl Shape {
    /// Adds the next bytes.
    pub fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.bytes += 1;
            if self.rows == 0 && self.bytes <= LONGEST_COLUMNS {
                self.columns.push(*byte);
            }
            self.is_row_open = true;
            match byte {
                b'"' => self.is_quoted = !self.is_quoted,
                b',' if !self.is_quoted => self.separators += 1,
                b'\n' if !self.is_quoted => self.end_row(),
                0 => self.has_nul = true,
                _ => {}
            }
        }
    }

    fn end_row(&mut self) {
        let cells = std::mem::take(&mut self.separators) + 1;
        if self.rows == 0 {
            (self.width, self.first_row_bytes) = (cells, self.bytes);
        } else if cells != self.width && self.ragged_row.is_none() {
            self.ragged_row = Some(self.rows);
        }
        self.rows += 1;
        self.is_row_open = false;
    }

    /// How the text is not what its heading states, if it is not.
    pub fn fault(&self, heading: &Heading) -> Option<String> {
        if self.has_nul {
            return Some("contains the character U+0000".into());
        }
        if self.is_row_open || self.first_row_bytes != heading.columns {
            return Some("a line does not end where its heading says".into());
        }
        if let Some(row) = self.ragged_row {
            return Some(format!("row {row} has another number of cells than there are columns"));
        }
        let rows = self.rows.saturating_sub(1);
        (heading.origin.content == Content::Rows && rows != heading.points)
            .then(|| format!("contains {rows} rows, not {}", heading.points))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(csv: &str, columns: u64, points: u64) -> Option<String> {
        let origin = Origin { scene: "s".into(), version: "v".into(), blocks: 1, content: Content::Rows };
        let mut shape = Shape::default();
        // In parts, as a file is read.
        csv.as_bytes().chunks(3).for_each(|part| shape.add(part));
        shape.fault(&Heading::of(origin, 0, points, columns, csv.len() as u64))
    }

    #[test]
    fn rows_and_columns_are_those_of_the_heading() {
        assert_eq!(fault("a,b\n1,2\n\"x\n,\",4\n", 4, 2), None);
        for (csv, columns, points, problem) in [
            ("a,b\n1,2\n", 4, 2, "contains 1 rows, not 2"),
            ("a,b\n1,2\n3,4\n", 4, 1, "contains 2 rows, not 1"),
            ("a,b\n1,2,3\n", 4, 1, "row 1 has another number of cells"),
            ("a,b\n1,2", 4, 1, "does not end"),
            ("a,b\n1,2\n", 8, 1, "does not end"),
            ("a,b\n\"1,2\n", 4, 1, "does not end"),
            ("a,b\n1,\0\n", 4, 1, "U+0000"),
        ] {
            let found = fault(csv, columns, points).unwrap_or_default();
            assert!(found.contains(problem), "{csv:?}: {found:?}");
        }
    }
}
