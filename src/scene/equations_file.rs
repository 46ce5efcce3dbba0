//! `equations.toml`: a paper's equations, the thing under test.

use serde::de::DeserializeOwned;
use slipmode_theory::{Equations, EquationsText};

use crate::scene::file_text::line_at;
use crate::scene::{Fault, Faults, Problem, file_text};

/// Reads `equations.toml`.
///
/// # Errors
/// All the faults at once: TOML that does not parse, unknown keys, and what [`Equations::read`] refuses.
pub fn read_equations(file: &str, bytes: &[u8]) -> Result<Equations, Faults> {
    let (equations, faults) = read_equations_partly(file, bytes)?;
    if faults.is_empty() { Ok(equations) } else { Err(faults) }
}

/// The equations of the file that can be read, and the faults of the others.
///
/// # Errors
/// TOML that does not parse, and unknown keys.
pub fn read_equations_partly(file: &str, bytes: &[u8]) -> Result<(Equations, Faults), Faults> {
    read_toml(file, bytes).map(|text| equations_of(file, text))
}

/// The equations that can be read, and the faults of the others.
pub(super) fn equations_of(file: &str, text: EquationsText) -> (Equations, Faults) {
    let (equations, faults) = Equations::read_partly(text);
    (equations, faults.iter().map(|fault| equation_fault(file, &fault.key, &fault.message)).collect())
}

/// What serde reads of a file; TOML that does not parse is a fault with its line, and so is each unknown key.
pub(super) fn read_toml<T: DeserializeOwned>(file: &str, bytes: &[u8]) -> Result<T, Faults> {
    let mut text = file_text(file, bytes).map_err(|fault| vec![fault])?.to_owned();
    let mut faults = Vec::new();
    loop {
        let error = match toml::from_str(&text) {
            Ok(read) if faults.is_empty() => return Ok(read),
            Ok(_) => return Err(faults),
            Err(error) => error,
        };
        let start = error.span().map(|span| span.start);
        let line = start.map(|start| line_at(text.as_bytes(), start));
        faults.push(equation_fault(file, "", error.message()).at(line));
        // An unknown key hides the faults after it: its line is left out, and the rest is read again.
        let Some(start) = start.filter(|_| error.message().starts_with("unknown field")) else {
            return Err(faults);
        };
        let length = text[start..].find('\n').unwrap_or(text.len() - start);
        text.replace_range(start..start + length, "");
        if text.parse::<toml::Table>().is_err() {
            return Err(faults);
        }
    }
}

pub(super) fn equation_fault(file: &str, key: &str, message: &str) -> Fault {
    let problem = Problem::Equation(message.trim_end().replace('\n', "; "));
    Fault::of(file, key, problem)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = include_str!("../../reports/im-avouac/equations.toml");

    fn faults(text: &str) -> String {
        let faults = read_equations("equations.toml", text.as_bytes()).expect_err("a fault");
        faults.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
    }

    #[test]
    fn unknown_keys_are_refused() {
        let message = faults(&FILE.replace("note =", "nota ="));
        assert!(message.starts_with("equations.toml:") && message.contains("nota"), "{message}");
        assert_eq!(message.lines().count(), FILE.matches("note =").count());
        let inline = faults(
            "wrong = { x = 1 }\n[assumptions]\npositive = [\"x\"]\n[[equation]]\nother = 1\nnumber = \"1\"\nequation = \"x = y\"\n",
        );
        assert_eq!(inline.lines().count(), 2, "{inline}");
        assert!(inline.contains("equations.toml:1:") && inline.contains("equations.toml:5:"), "{inline}");
    }
}
