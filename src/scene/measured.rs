//! Tables and charts that another program measured and a report shows as they are: read, never computed here.
//!
//! A folder of the report has them: `contents.toml` with words, columns and charts, and `tables/ID.csv` with the rows.

use crate::scene::document::read_document;
use crate::scene::report_plan::distinct_name;
use crate::scene::section::{Entry, Section};
use crate::scene::sections::NAME_RULE;
use crate::scene::{AllowedRange, CsvProblem, Fault, Faults, Limits, Problem};
use slipmode_core::number::nearest_f64;
use slipmode_plot::figure::{Axis, Caption, LineChart, Reference, Series};
use slipmode_plot::table::{Cell, Column, Kind, Table};

/// What a report's folder of measurements holds.
#[derive(Debug, Clone, Default)]
pub struct Measured {
    /// Files of the folder from which the rows were computed: they belong to the report's inputs, and nothing reads them.
    pub sources: Vec<String>,
    /// The tables, without rows until [`with_rows`] adds them.
    pub tables: Vec<Table>,
    /// The charts.
    pub charts: Vec<MeasuredChart>,
}

/// A line chart and its place in a report.
#[derive(Debug, Clone)]
pub struct MeasuredChart {
    /// Label such as `Figure 1`.
    pub label: String,
    /// What it shows and what to look at, in Markdown.
    pub caption_markdown: String,
    /// Ids of the tables that hold its numbers.
    pub data: Vec<String>,
    /// The chart; its id is the id by which prose places it.
    pub chart: LineChart,
}

impl Measured {
    /// Reads `contents.toml` from its bytes.
    ///
    /// # Errors
    /// All the faults at once.
    pub fn parse(file: &str, bytes: &[u8]) -> Result<Self, Faults> {
        read_document(file, bytes, Limits::default(), |top| {
            let (mut table_ids, mut chart_ids) = (Vec::new(), Vec::new());
            Some(Self {
                sources: names(top, "sources"),
                tables: top.list("table", "[[table]] sections", |member| table(member, &mut table_ids)),
                charts: top.list("chart", "[[chart]] sections", |member| chart(member, &mut chart_ids)),
            })
        })
    }

    /// The table of this id.
    pub(crate) fn table(&self, id: &str) -> Option<&Table> {
        self.tables.iter().find(|table| table.id == id)
    }

    /// The chart of this id.
    pub(crate) fn chart(&self, id: &str) -> Option<&MeasuredChart> {
        self.charts.iter().find(|measured| measured.chart.caption.id == id)
    }
}

/// The table with the rows of its CSV text.
///
/// # Errors
/// When the header has other columns, a row has another number of cells, or a cell of a column of numbers is neither a number
/// nor empty.
pub fn with_rows(mut table: Table, file: &str, text: &str) -> Result<Table, Faults> {
    let fault = |line, key: &str, problem: CsvProblem| vec![Fault::of(file, key, problem).at(line)];
    let mut reader = csv::ReaderBuilder::new().flexible(true).has_headers(false).from_reader(text.as_bytes());
    // A flexible reader of text in memory has no way to fail.
    let mut records = reader.records().flatten();
    let header = records.next().unwrap_or_default();
    let mut names = table.columns.iter().map(|column| column.name.as_str()).enumerate();
    if let Some((_, name)) = names.find(|(at, name)| header.get(*at) != Some(name)) {
        return Err(fault(Some(1), name, CsvProblem::MissingColumn { nearest: None, allowed: name.into() }));
    }
    let wanted = table.columns.len();
    let checked = |record: csv::StringRecord| {
        let line = record.position().and_then(|position| usize::try_from(position.line()).ok());
        let problem = CsvProblem::CellCount { found: record.len(), wanted };
        if record.len() == wanted { Ok((record, line)) } else { Err(fault(line, "", problem)) }
    };
    checked(header)?;
    for record in records {
        let (record, line) = checked(record)?;
        let cells = record.iter().zip(&table.columns).map(|(text, column)| {
            cell(text, column).map_err(|problem| {
                vec![Fault { value: Some(text.into()), ..Fault::of(file, &column.name, problem).at(line) }]
            })
        });
        table.rows.push(cells.collect::<Result<_, Faults>>()?);
    }
    Ok(table)
}

/// The cell of a column: any text, or a number where the column holds numbers. It may be missing, and an error may be infinite.
fn cell(text: &str, column: &Column) -> Result<Cell, Problem> {
    // Errors of thousands of digits round to zero here, which only asks for the form.
    let is_number = || text.parse().is_ok_and(|number: f64| !number.is_nan());
    let is_sound = column.kind != Kind::Number || text.is_empty() || is_number();
    is_sound
        .then(|| Cell { kind: column.kind, ..Cell::text(text) })
        .ok_or_else(|| Problem::OutOfRange { allowed: "a number, `inf`, or an empty cell".into() })
}

fn names(section: &mut Section<'_>, key: &'static str) -> Vec<String> {
    section.list(key, &format!("a list of names, each {NAME_RULE}"), Entry::name)
}

/// A text that may be absent, which is then empty.
fn optional_words(section: &mut Section<'_>, key: &'static str) -> String {
    section.optionally(key, Entry::text).unwrap_or_default()
}

fn table(entry: &Entry<'_>, earlier: &mut Vec<String>) -> Option<Table> {
    entry.table(|section| {
        let id = section.read("id", NAME_RULE, |entry| distinct_name(entry, earlier));
        let title = section.text("title", "a text");
        let note = optional_words(section, "note");
        let mut names = Vec::new();
        let columns = section
            .list("columns", "a list of { name = …, header = … }", |member| column(member, &mut names));
        Table::new(&id, &title, columns).with_note(&note)
    })
}

fn column(entry: &Entry<'_>, earlier: &mut Vec<String>) -> Option<Column> {
    entry.table(|section| {
        let name = section.read("name", NAME_RULE, |entry| distinct_name(entry, earlier));
        let header = section.text("header", "a text");
        let unit = optional_words(section, "unit");
        let is_number = section.optionally("number", Entry::truth) == Some(true);
        Column { name, header, unit, kind: if is_number { Kind::Number } else { Kind::Text } }
    })
}

fn chart(entry: &Entry<'_>, earlier: &mut Vec<String>) -> Option<MeasuredChart> {
    let read = |section: &mut Section<'_>| {
        let id = section.read("id", NAME_RULE, |entry| distinct_name(entry, earlier));
        let [label, title, caption_markdown, description] =
            ["label", "title", "caption", "description"].map(|key| section.text(key, "a text"));
        let data = names(section, "data");
        let [x, y] = ["x", "y"].map(|key| axis(section, key));
        let series = section.list("series", "a list of { label = …, points = … }", series);
        let verticals = section.optionally("verticals", |entry| entry.list(vertical));
        let chart = LineChart {
            caption: Caption::new(&id, &title, &description),
            x: x?,
            y: y?,
            series,
            references: verticals.unwrap_or_default(),
        };
        Some(MeasuredChart { label, caption_markdown, data, chart })
    };
    entry.table(read)?
}

/// A logarithmic axis.
fn axis(section: &mut Section<'_>, key: &'static str) -> Option<Axis> {
    section.required(key, "{ title = …, from = …, to = … }")?.table(|section| {
        let title = section.text("title", "a text");
        let unit = optional_words(section, "unit");
        let (from, to) = section.ends();
        Axis::log10(&title, &unit, nearest_f64(&from), nearest_f64(&to))
    })
}

fn series(entry: &Entry<'_>) -> Option<Series> {
    entry.table(|section| {
        let label = section.text("label", "a text");
        Series::marked(label, section.list("points", "a list of [x, y]", point))
    })
}

fn vertical(entry: &Entry<'_>) -> Option<Reference> {
    entry.table(|section| Reference::Vertical {
        at: nearest_f64(&section.decimal("at", AllowedRange::PHYSICAL)),
        label: section.text("label", "a text"),
    })
}

fn point(entry: &Entry<'_>) -> Option<(f64, f64)> {
    match entry.list(|member| member.decimal(AllowedRange::PHYSICAL))?.as_slice() {
        [x, y] => Some((nearest_f64(x), nearest_f64(y))),
        _ => entry.refuse(Problem::OutOfRange { allowed: "two numbers, x and y".into() }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CONTENTS: &str = "sources = [\"raw.csv\"]\n\
        [[table]]\nid = \"t\"\ntitle = \"T\"\nnote = \"N\"\n\
        columns = [{ name = \"what\", header = \"What\" }, { name = \"time_s\", header = \"Time\", unit = \"s\", number = true }]\n\
        [[chart]]\nid = \"c\"\nlabel = \"Figure\"\ntitle = \"C\"\ncaption = \"C.\"\ndescription = \"C\"\ndata = [\"t\"]\n\
        x = { title = \"n\", from = 1, to = 10 }\ny = { title = \"Time\", unit = \"s\", from = 0.1, to = 1e2 }\n\
        series = [{ label = \"<script>\", points = [[1, 2.5], [10, 50]] }]\nverticals = [{ at = 2, label = \"limit\" }]\n";

    fn read(text: &str) -> Result<Measured, Faults> {
        Measured::parse("contents.toml", text.as_bytes())
    }

    #[test]
    fn a_table_gets_its_rows_and_a_chart_is_drawn_with_escaped_words() {
        let found = read(CONTENTS).unwrap();
        let text = "what,time_s\n\"a, b\",1.5\nc,\n";
        let table = with_rows(found.tables[0].clone(), "t.csv", text).unwrap();
        assert_eq!((table.to_csv().as_str(), table.rows.len(), table.note.as_str()), (text, 2, "N"));
        let found = found.chart("c").unwrap();
        let svg = found.chart.svg();
        assert!(svg.contains("&lt;script") && !svg.contains("<script") && svg.contains("limit"), "{svg}");
        assert_eq!(found.data, ["t"]);
    }

    #[test]
    fn every_fault_is_named_with_its_key() {
        for (from, to, named) in [
            ("id = \"t\"", "id = \"../t\"", "table[1].id"),
            ("\"raw.csv\"", "\"a/b\"", "sources[1]"),
            ("from = 1,", "from = 10,", "chart[1].x"),
            ("from = 1,", "from = -1,", "chart[1].x.from"),
            ("[10, 50]", "[10]", "series[1].points[2]"),
            ("at = 2", "at = \"x\"", "verticals[1].at"),
            ("number = true", "number = 1", "columns[2].number"),
            ("note =", "notes =", "table[1].notes"),
            ("name = \"time_s\"", "name = \"what\"", "table[1].columns[2].name"),
            ("header = \"Time\"", "header = \"\\u202e\"", "table[1].columns[2].header"),
        ] {
            assert!(CONTENTS.contains(from));
            let faults = read(&CONTENTS.replace(from, to)).unwrap_err();
            assert!(faults[0].to_string().contains(named), "{} for {named}", faults[0]);
        }
        let twice = CONTENTS.replace(
            "[[chart]]",
            "[[table]]\nid = \"T\"\ntitle = \"T\"\ncolumns = [{ name = \"a\", header = \"A\" }]\n[[chart]]",
        );
        assert!(read(&twice).unwrap_err()[0].to_string().contains("when case is ignored"));
    }

    #[test]
    fn rows_that_do_not_fit_the_columns_are_refused_with_their_line() {
        let table = read(CONTENTS).unwrap().tables.remove(0);
        for (text, named) in [
            ("", "t.csv:1: what: missing column"),
            ("what,time\na,1\n", "t.csv:1: time_s: missing column"),
            ("what,time_s,more\n", "t.csv:1: 3 cells"),
            ("what,time_s\na,1\nb\n", "t.csv:3: 1 cells"),
            ("what,time_s\na,NaN\n", "t.csv:2: time_s = NaN"),
            ("what,time_s\na,1\nb,<b>\n", "t.csv:3: time_s = "),
        ] {
            let faults = with_rows(table.clone(), "t.csv", text).unwrap_err();
            assert!(faults[0].to_string().contains(named), "{}", faults[0]);
        }
    }
}
