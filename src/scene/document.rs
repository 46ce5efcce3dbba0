//! A TOML file under reading: its text, its lines, and the faults found so far.

use std::cell::RefCell;

use toml::de::DeTable;

use crate::scene::file_text::file_text;
use crate::scene::section::{Section, Source};
use crate::scene::{Faults, Limits, Problem};

/// The most syntax faults reported of one file: after the first few the rest follow from them.
const MOST_SYNTAX_FAULTS: usize = 5;

/// Parses a file and hands its top table to `read`; every key that it did not ask for is a fault.
///
/// # Errors
/// All the faults: those of the text and syntax alone when there are any, else those of the content.
pub(crate) fn read_document<T>(
    file: &str,
    bytes: &[u8],
    limits: Limits,
    read: impl FnOnce(&mut Section<'_>) -> Option<T>,
) -> Result<T, Faults> {
    let text = file_text(file, bytes).map_err(|fault| vec![fault])?;
    let source = Source { file, text, limits, faults: RefCell::default() };
    let (document, errors) = DeTable::parse_recoverable(text);
    if !errors.is_empty() {
        for error in errors.iter().take(MOST_SYNTAX_FAULTS) {
            let offset = error.span().map_or(0, |span| span.start);
            let message = error.message().lines().collect::<Vec<_>>().join("; ");
            source.fault(offset, String::new(), None, Problem::Syntax(message));
        }
        return Err(source.faults.into_inner());
    }
    let mut section = Section::top(&source, document.get_ref());
    let value = read(&mut section);
    section.finish();
    let mut faults = source.faults.take();
    faults.sort_by_key(|fault| fault.line);
    match value {
        Some(value) if faults.is_empty() => Ok(value),
        _ => Err(faults),
    }
}
