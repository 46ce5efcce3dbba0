//! A sweep's rows summed up: counted by bins of numbers and by words, with extremes and sums of some columns.
//!
//! Counts and extremes do not depend on the order of rows. Sums are those of blocks, added in the order of blocks, so that
//! they too are the same for any number of shards.

mod values;

use std::collections::HashMap;

use crate::sweep::csv_records::{cells, records};
use crate::sweep::{ColumnBins, MOST_SUMMARY_CELLS, Statistic, SummarySection};
use values::{bin, key_order, number};

/// The column of the number of rows, between the keys and the statistics.
const ROWS: &str = "rows";
/// The end of the name of a column of bin numbers.
const BIN: &str = "bin";

/// Rows summed up by key.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    keys: Vec<String>,
    fields: Vec<Field>,
    tallies: HashMap<Vec<u8>, Tally>,
}

/// A column of statistics.
#[derive(Debug, Clone, PartialEq)]
struct Field {
    name: String,
    statistic: Statistic,
}

/// What is known of the rows of one key; a value for each field, none before there is a number.
#[derive(Debug, Clone, PartialEq)]
struct Tally {
    rows: u64,
    values: Vec<Option<f64>>,
}

/// One line of a summary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SummaryRow<'s> {
    key: &'s [u8],
    /// How many rows it sums up.
    pub rows: u64,
    /// A value for each statistic; none where no row had a number.
    pub values: &'s [Option<f64>],
}

impl<'s> SummaryRow<'s> {
    /// The cells of its key as they stand.
    pub fn key(&self) -> impl Iterator<Item = &'s str> {
        cells(self.key).map(|cell| std::str::from_utf8(cell).unwrap_or_default())
    }
}

/// Where a row's cells go.
#[derive(Debug, Clone, PartialEq)]
pub struct RowPlaces {
    bins: Vec<(usize, Vec<f64>)>,
    words: Vec<usize>,
    /// The column of each field.
    numbers: Vec<usize>,
}

/// Why a summary cannot be made.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SummaryError {
    /// A column that rows do not have.
    #[error("sweep.summary names the column `{0}`, which rows do not have (they have: {1})")]
    NoColumn(String, String),
    /// Words of endless variety.
    #[error(
        "the summary has more than {MOST_SUMMARY_CELLS} cells; count by words of fewer kinds, or in fewer bins"
    )]
    TooManyCells,
    /// Lines that are not those of a summary.
    #[error("holds no summary of the stated form")]
    Malformed,
}

impl Summary {
    /// An empty summary of rows with these columns, and where their cells go.
    ///
    /// # Errors
    /// When the section names a column that is not there.
    pub fn of_rows(section: &SummarySection, columns: &[u8]) -> Result<(Self, RowPlaces), SummaryError> {
        let names: Vec<String> = cells(columns.trim_ascii_end()).map(text).collect();
        let place = |name: &String| {
            let found = names.iter().position(|column| column == name);
            found.ok_or_else(|| SummaryError::NoColumn(name.clone(), names.join(", ")))
        };
        let edges = |bins: &ColumnBins| Ok((place(&bins.column)?, bins.edges.coordinates()));
        let bins = section.bins.iter().map(edges).collect::<Result<Vec<_>, _>>()?;
        let words = section.by.iter().map(place).collect::<Result<Vec<_>, _>>()?;
        let (mut fields, mut numbers) = (Vec::new(), Vec::new());
        for column in &section.numbers {
            for &statistic in &column.statistics {
                numbers.push(place(&column.column)?);
                fields.push(Field { name: format!("{}_{}", column.column, statistic.as_str()), statistic });
            }
        }
        let binned = section.bins.iter().map(|bins| format!("{}_{BIN}", bins.column));
        let keys = binned.chain(section.by.iter().cloned()).collect();
        Ok((Self { keys, fields, tallies: HashMap::new() }, RowPlaces { bins, words, numbers }))
    }

    /// An empty summary to which others with this line of columns are added; the first `keys` of them are keys.
    ///
    /// # Errors
    /// When the line is not that of a summary.
    pub fn of_columns(columns: &[u8], keys: usize) -> Result<Self, SummaryError> {
        let names: Vec<String> = cells(columns.trim_ascii_end()).map(text).collect();
        let (Some(key_names), Some(ROWS)) = (names.get(..keys), names.get(keys).map(String::as_str)) else {
            return Err(SummaryError::Malformed);
        };
        let field = |name: &String| {
            let (_, end) = name.rsplit_once('_')?;
            let statistic = Statistic::ALL.into_iter().find(|statistic| statistic.as_str() == end)?;
            Some(Field { name: name.clone(), statistic })
        };
        let fields = names[keys + 1..].iter().map(field).collect::<Option<Vec<_>>>();
        let fields = fields.ok_or(SummaryError::Malformed)?;
        Ok(Self { keys: key_names.to_vec(), fields, tallies: HashMap::new() })
    }

    /// How many columns are keys.
    pub(crate) fn key_count(&self) -> usize {
        self.keys.len()
    }

    /// The line of column names.
    #[must_use]
    pub fn columns(&self) -> Vec<u8> {
        let fields = self.fields.iter().map(|field| field.name.as_str());
        let names: Vec<&str> = self.keys.iter().map(String::as_str).chain([ROWS]).chain(fields).collect();
        format!("{}\n", names.join(",")).into_bytes()
    }

    /// Adds rows.
    ///
    /// # Errors
    /// When there are too many keys.
    pub fn add_rows(&mut self, places: &RowPlaces, lines: &[u8]) -> Result<(), SummaryError> {
        let (mut key, mut row) = (Vec::new(), Vec::new());
        for record in records(lines) {
            row.clear();
            row.extend(cells(record));
            key.clear();
            places.write_key(&row, &mut key);
            let fields = &self.fields;
            let tally = tally(&mut self.tallies, &key, fields)?;
            tally.rows += 1;
            for ((value, field), column) in tally.values.iter_mut().zip(fields).zip(&places.numbers) {
                if let Some(number) = number(row.get(*column).copied().unwrap_or_default()) {
                    let number = if field.statistic == Statistic::Count { 1.0 } else { number };
                    field.statistic.combine(value, number);
                }
            }
        }
        Ok(())
    }

    /// Adds the lines of another summary, that of the next block, and gives the number of rows that they sum up.
    ///
    /// # Errors
    /// When they are not lines of such a summary, or there are too many keys.
    pub fn add_summary(&mut self, lines: &[u8]) -> Result<u64, SummaryError> {
        let (keys, fields) = (self.keys.len(), &self.fields);
        let mut added: u64 = 0;
        for record in records(lines) {
            let row: Vec<&[u8]> = cells(record).collect();
            if row.len() != keys + 1 + fields.len() {
                return Err(SummaryError::Malformed);
            }
            let key = row[..keys].join(&b',');
            let rows = std::str::from_utf8(row[keys]).ok().and_then(|text| text.parse::<u64>().ok());
            let rows = rows.ok_or(SummaryError::Malformed)?;
            added = added.checked_add(rows).ok_or(SummaryError::Malformed)?;
            let tally = tally(&mut self.tallies, &key, fields)?;
            tally.rows = tally.rows.checked_add(rows).ok_or(SummaryError::Malformed)?;
            for ((value, field), cell) in tally.values.iter_mut().zip(fields).zip(&row[keys + 1..]) {
                if !cell.is_empty() || field.statistic == Statistic::Count {
                    let number = field.statistic.read(cell, rows).ok_or(SummaryError::Malformed)?;
                    field.statistic.combine(value, number);
                }
            }
        }
        Ok(added)
    }

    /// How many rows were added.
    #[must_use]
    pub fn rows(&self) -> u64 {
        self.tallies.values().map(|tally| tally.rows).sum()
    }

    /// The rows with their keys, by ascending keys.
    #[must_use]
    pub fn sorted(&self) -> Vec<SummaryRow<'_>> {
        let mut sorted: Vec<SummaryRow<'_>> = self
            .tallies
            .iter()
            .map(|(key, tally)| SummaryRow { key, rows: tally.rows, values: &tally.values })
            .collect();
        sorted.sort_by(|one, other| key_order(one.key, other.key));
        sorted
    }

    /// The lines, by ascending keys: bins by their number, words by their letters.
    #[must_use]
    pub fn lines(&self) -> Vec<u8> {
        let mut out = Vec::new();
        for row in self.sorted() {
            out.extend_from_slice(row.key);
            if !self.keys.is_empty() {
                out.push(b',');
            }
            out.extend_from_slice(row.rows.to_string().as_bytes());
            for (value, field) in row.values.iter().zip(&self.fields) {
                out.push(b',');
                out.extend_from_slice(field.statistic.written(*value).as_bytes());
            }
            out.push(b'\n');
        }
        out
    }
}

impl RowPlaces {
    fn write_key(&self, row: &[&[u8]], key: &mut Vec<u8>) {
        let cell = |column: usize| row.get(column).copied().unwrap_or_default();
        let mut between = false;
        let mut separate = |key: &mut Vec<u8>| {
            if std::mem::replace(&mut between, true) {
                key.push(b',');
            }
        };
        for (column, edges) in &self.bins {
            separate(key);
            if let Some(number) = number(cell(*column)) {
                key.extend_from_slice(bin(edges, number.abs()).to_string().as_bytes());
            }
        }
        for column in &self.words {
            separate(key);
            key.extend_from_slice(cell(*column));
        }
    }
}

fn tally<'t>(
    tallies: &'t mut HashMap<Vec<u8>, Tally>,
    key: &[u8],
    fields: &[Field],
) -> Result<&'t mut Tally, SummaryError> {
    if !tallies.contains_key(key) {
        if tallies.len() as u64 >= MOST_SUMMARY_CELLS {
            return Err(SummaryError::TooManyCells);
        }
        tallies.insert(key.to_vec(), Tally { rows: 0, values: vec![None; fields.len()] });
    }
    tallies.get_mut(key).ok_or(SummaryError::Malformed)
}

fn text(cell: &[u8]) -> String {
    String::from_utf8_lossy(cell).into_owned()
}

#[cfg(test)]
mod tests;
