//! What every reader promises of any bytes: it ends, without a panic, and what it accepts is the same when it is printed and read again.
//!
//! Nothing here knows where the bytes come from, so that any source of them can be compared with the promises.

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::sync::LazyLock;

use rug::ops::Pow;
use slipmode::archive::{Caps, pack, unpack};
use slipmode::claims::procedures;
use slipmode::experiments::References;
use slipmode::experiments::Scene;
use slipmode::experiments::{figure_makers, table_makers};
use slipmode::report::{Folder, produce};
use slipmode::scene::{
    Chapter, Faults, Limits, Measured, ReportPlan, check_name, read_claims, read_equations,
    read_equations_and_claims, with_rows,
};
use slipmode_algebra::Expression;
use slipmode_core::number::{MAX_EXPONENT, Rational, parse_decimal};
use slipmode_theory::Equations;

/// A number that is accepted is the same when it is printed in full and read again.
pub fn number(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Ok(value) = parse_decimal(text) {
        assert_eq!(parse_decimal(&in_full(&value)), Ok(value), "{text:?}");
    }
}

/// Every digit of a decimal, within the grammar's limits on digits and exponent.
fn in_full(value: &Rational) -> String {
    // Denominators divide a power of ten; most divide a small one.
    let scaled = |places: u32| value.clone() * Rational::from(10).pow(places);
    let places = [0, 400, 20_000].into_iter().find(|places| scaled(*places).is_integer()).expect("a decimal");
    let scaled = scaled(places);
    let sign = if *value < 0 { "-" } else { "" };
    let mut digits = scaled.numer().clone().abs().to_string();
    let mut exponent = -i64::from(places);
    while digits.len() > 1 && digits.ends_with('0') && exponent < MAX_EXPONENT {
        digits.pop();
        exponent += 1;
    }
    // What the exponent cannot say goes behind the point.
    let behind = usize::try_from((-MAX_EXPONENT - exponent).max(0)).unwrap();
    let digits = format!("{digits:0>width$}", width = behind + 1);
    let (whole, fraction) = digits.split_at(digits.len() - behind);
    format!("{sign}{whole}.{fraction}e{}", exponent.max(-MAX_EXPONENT))
}

/// A scene that is accepted is the same with another system's line ends, and its name is one that can be written.
pub fn scene(bytes: &[u8]) {
    if let Some(scene) = document(bytes, |bytes| Scene::parse(FILE, bytes, &Limits::default())) {
        assert_eq!(check_name(&scene.name), Ok(()));
    }
}

/// A list of claims and the plan of a report that are accepted are the same with another system's line ends.
pub fn ledger(bytes: &[u8]) {
    let _ = document(bytes, |bytes| read_claims(FILE, bytes, &procedures(), Some(&EQUATIONS)));
    let _ = document(bytes, |bytes| Ok(read_equations_and_claims(FILE, bytes, &procedures())?.1));
    if let Some(plan) = document(bytes, |bytes| ReportPlan::parse(FILE, bytes)) {
        let names = plan.scenes.iter().chain(plan.chapters.iter().map(|chapter| &chapter.id));
        assert!(names.chain([&plan.name]).all(|name| check_name(name).is_ok()));
    }
}

/// Measured tables and charts that are accepted are drawn with finite coordinates, and written with the rows that were read.
///
/// The bytes before the first NUL are `contents.toml`, those after it the rows of each table.
pub fn measured(bytes: &[u8]) {
    let end = bytes.iter().position(|byte| *byte == 0).unwrap_or(bytes.len());
    let (contents, rows) = (&bytes[..end], String::from_utf8_lossy(bytes.get(end + 1..).unwrap_or_default()));
    let Ok(found) = Measured::parse(FILE, contents) else { return };
    let words = String::from_utf8_lossy(contents);
    for measured in &found.charts {
        let svg = measured.chart.svg();
        for none in ["NaN", "inf"].into_iter().filter(|none| !words.contains(none)) {
            assert!(!svg.contains(none), "{none} in {svg}");
        }
    }
    for table in found.tables {
        if let Ok(read) = with_rows(table.clone(), FILE, &rows) {
            assert_eq!(with_rows(table, FILE, &read.to_csv()).map(|again| again.rows), Ok(read.rows));
        }
    }
}

/// The name that readers of documents are given.
const FILE: &str = "s.toml";

/// What a reader accepts, read again with another system's line ends; its faults name the file.
fn document<T: Debug + PartialEq>(bytes: &[u8], read: impl Fn(&[u8]) -> Result<T, Faults>) -> Option<T> {
    match read(bytes) {
        Ok(found) => {
            let text = std::str::from_utf8(bytes).expect("an accepted document is text");
            let other = text.replace("\r\n", "\n").replace('\n', "\r\n");
            // A text over several lines may hold line ends of its own.
            if !text.contains("\"\"\"") && !text.contains("'''") {
                assert_eq!(read(other.as_bytes()).as_ref(), Ok(&found));
            }
            Some(found)
        }
        Err(faults) => {
            assert!(!faults.is_empty());
            assert!(faults.iter().all(|fault| fault.to_string().starts_with(FILE)), "{faults:?}");
            None
        }
    }
}

/// An expression that is accepted is the same when it is printed and read again.
pub fn expression(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if let Ok(read) = text.parse::<Expression>() {
        let printed = read.to_string();
        assert_eq!(printed.parse::<Expression>().map(|again| again.to_string()), Ok(printed), "{text:?}");
    }
}

/// A file of equations that is accepted prints equations that are read as the same ones.
pub fn equations(bytes: &[u8]) {
    expression(bytes);
    match read_equations("equations.toml", bytes) {
        Ok(found) => {
            for equation in found.iter() {
                let again =
                    found.altered(&equation.number, &equation.to_string()).expect("what was printed is read");
                assert_eq!(again.equation(&equation.number).to_string(), equation.to_string());
            }
        }
        Err(faults) => assert!(faults.iter().all(|fault| !fault.to_string().is_empty())),
    }
}

/// Prose that is rendered brings no element of its own that runs or loads anything, and no link but to the known schemes.
///
/// Prose that places figures or tables made from the paper's equations alone promises nothing here: that takes proofs and
/// decisions of the whole ledger, up to a minute however short the prose is, and nothing in them comes from it.
pub fn prose(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    if places_proofs(text) {
        return;
    }
    let Some(page) = page(text) else { return };
    for dangerous in
        ["<script", "<style", "<img", "<iframe", "<object", "<embed", "<form", "<base", "<link", "<meta"]
    {
        assert_eq!(
            page.matches(dangerous).count(),
            PLAIN_PAGE.matches(dangerous).count(),
            "{dangerous}: {text:?}"
        );
    }
    for scheme in ["javascript:", "data:", "vbscript:", "file:"] {
        let link = format!("href=\"{scheme}");
        assert_eq!(page.matches(&link).count(), PLAIN_PAGE.matches(&link).count(), "{scheme} {text:?}");
    }
}

/// Whether a placing line names a table or figure that needs no scene.
fn places_proofs(text: &str) -> bool {
    let tables = table_makers().filter(|maker| maker.needs.is_empty()).map(|maker| maker.id);
    let figures = figure_makers().filter(|maker| maker.needs.is_empty()).map(|maker| maker.id);
    let proofs: Vec<&str> = tables.chain(figures).collect();
    let mut placing = text.lines().map(str::trim).filter(|line| line.starts_with("[["));
    placing.any(|line| proofs.iter().any(|id| line.contains(id)))
}

static PLAIN_PAGE: LazyLock<String> = LazyLock::new(|| page("Plain.").expect("plain prose is rendered"));

static EQUATIONS: LazyLock<Equations> = LazyLock::new(|| {
    read_equations("equations.toml", include_bytes!("../../reports/im-avouac/equations.toml"))
        .expect("the paper's equations")
});

/// The page of a report that is nothing but this prose, in lower case.
fn page(prose: &str) -> Option<String> {
    let chapter = Chapter { id: "c".into(), title: "C".into(), prose: "c.md".into(), part: None };
    let plan = ReportPlan {
        name: "p".into(),
        folder: "p".into(),
        title: "P".into(),
        authors: Vec::new(),
        date: None,
        publish_page: true,
        question: slipmode::scene::Question::Claims,
        scenes: Vec::new(),
        proofs: Vec::new(),
        charts: Vec::new(),
        measured: None,
        paper: Default::default(),
        chapters: vec![chapter],
    };
    let folder = Folder {
        plan,
        claims: Vec::new(),
        equations: EQUATIONS.clone(),
        scenes: Vec::new(),
        prose: BTreeMap::from([("c.md".to_string(), prose.to_string())]),
        references: References::default(),
        measured: Measured::default(),
        charts: Vec::new(),
        inputs: Vec::new(),
    };
    let mut product = produce(&folder, Vec::new(), &|_, _, _| ()).ok()?;
    product.files.remove("index.html").map(|page| page.to_ascii_lowercase())
}

/// An archive that is accepted holds the same files when they are packed and unpacked again.
pub fn archive(bytes: &[u8]) {
    let caps = Caps { file_bytes: 1 << 20, total_bytes: 1 << 22, ..Caps::default() };
    match unpack(bytes, &caps) {
        Ok((files, time)) => {
            let again = pack(&files, time).expect("what was unpacked can be packed");
            assert_eq!(unpack(&again, &caps), Ok((files, time)));
        }
        Err(faults) => assert!(!faults.is_empty()),
    }
}
