//! `cargo xtask tidy`: the source rules that no compiler checks.
//!
//! Each rule is a function from texts to complaints, tested with good and bad samples.

mod circles;
mod floors;
mod imports;
mod references;
mod rust_rules;
mod rust_source;
mod text_rules;
mod views;
mod wording;

use crate::prelude::*;
use rust_source::RustSource;
pub use rust_source::comment_length;

/// A text file of the repository.
#[derive(Debug)]
pub struct TextFile {
    /// Relative to the root, with `/`.
    pub path: String,
    /// The whole content.
    pub text: String,
}

impl TextFile {
    /// Whether the file's name ends with this extension.
    fn has_extension(&self, extension: &str) -> bool {
        self.path.rsplit_once('.').is_some_and(|(_, found)| found == extension)
    }

    /// A complaint about one line of this file, counted from 1; 0 is the file as a whole.
    fn complaint(&self, line: usize, message: impl Into<String>) -> Complaint {
        Complaint { path: self.path.clone(), line, message: message.into() }
    }
}

/// A broken rule and where.
#[derive(Debug)]
pub struct Complaint {
    path: String,
    line: usize,
    message: String,
}

/// Checks every rule on every file.
///
/// # Errors
/// When a rule is broken; all complaints at once.
pub fn run() -> Result {
    let paths = below(&root())?;
    let files = read(&paths)?;
    let mut found = Vec::new();
    for file in &files {
        text_rules::check(file, &mut found);
        views::check_template(file, &mut found);
        references::check_links(file, &paths, &mut found);
        wording::check_text(file, &mut found);
    }
    let sources = rust_sources(&files);
    for source in &sources {
        rust_rules::check(source, &mut found);
        floors::check(source, &mut found);
        wording::check_command_line(source, &mut found);
    }
    circles::check(&sources, &mut found);
    references::check_data_is_read(&files, &paths, &mut found);
    let shown = |Complaint { path, line, message }: &Complaint| match line {
        0 => format!("\n{path}: {message}"),
        line => format!("\n{path}:{line}: {message}"),
    };
    let lines: String = found.iter().map(shown).collect();
    ensure(found.is_empty(), || Failure::check(format!("tidy: {} complaints{lines}", found.len())))?;
    println!("tidy: {} files, no complaint", files.len());
    Ok(())
}

/// All Rust files; those that another declares as tests are marked so.
pub fn rust_sources(files: &[TextFile]) -> Vec<RustSource<'_>> {
    let rust_files = files.iter().filter(|file| file.has_extension("rs"));
    let mut sources: Vec<RustSource> = rust_files.map(RustSource::new).collect();
    let test_files: BTreeSet<String> = sources.iter().flat_map(RustSource::test_modules).collect();
    for source in sources.iter_mut().filter(|source| test_files.contains(&source.file.path)) {
        source.set_all_tests();
    }
    sources
}

/// Reads every file that is text; binary files (fonts, archives) have no rules here.
pub fn read(paths: &[String]) -> Result<Vec<TextFile>> {
    let mut files = Vec::new();
    for path in paths {
        let place = root().join(path);
        let text = String::from_utf8(fs::read(&place).map_err(at(&place))?).ok();
        files.extend(text.map(|text| TextFile { path: path.clone(), text }));
    }
    Ok(files)
}

/// What one rule says about one sample: the lines it complains about.
#[cfg(test)]
fn lines_of(path: &str, text: &str, rule: impl Fn(&RustSource, &mut Vec<Complaint>)) -> Vec<usize> {
    let file = TextFile { path: path.to_string(), text: text.to_string() };
    let mut found = Vec::new();
    rule(&RustSource::new(&file), &mut found);
    found.iter().map(|complaint| complaint.line).collect()
}
