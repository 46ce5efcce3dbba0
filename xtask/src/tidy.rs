//! `cargo xtask tidy`: the source rules that no compiler checks.
//!
//! Each rule is a function from texts to complaints, tested with good and bad samples.

mod circles;
mod floors;
mod imports;
mod references;
mod source;
mod text_rules;
mod views;
mod words;

use crate::prelude::*;
pub use source::{Source, comment_length, read};

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
        words::check(file, &mut found);
        views::check(file, &mut found);
        references::check_links(file, &paths, &mut found);
        if file.is_rust() {
            words::check_file(file, &mut found);
            floors::check(file, &mut found);
        }
    }
    circles::check(&files, &mut found);
    references::check_data_is_read(&files, &paths, &mut found);
    // A line may have several words that one rule refuses for the same reason.
    found.dedup();
    let complaints = || format!("tidy: {} complaints\n{}", found.len(), found.join("\n"));
    ensure(found.is_empty(), || Failure::check(complaints()))?;
    println!("tidy: {} files, no complaint", files.len());
    Ok(())
}

/// What one rule says about one sample: the lines it complains about.
#[cfg(test)]
fn lines_of(path: &str, text: &str, rule: impl Fn(&Source, &mut Vec<String>)) -> Vec<usize> {
    let mut found = Vec::new();
    rule(&Source::new(path, text), &mut found);
    let line = |complaint: &String| {
        let (place, _) = complaint.strip_prefix(path).unwrap().split_once(": ").unwrap();
        place.strip_prefix(':').map_or(0, |line| line.parse().unwrap())
    };
    found.iter().map(line).collect()
}
