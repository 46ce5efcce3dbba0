//! `equations.toml`: a paper's equations, the thing under test.

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
    let text = file_text(file, bytes).map_err(|fault| vec![fault])?;
    let equations: EquationsText =
        toml::from_str(text).map_err(|error| vec![toml_fault(file, text, &error)])?;
    Ok(equations_of(file, equations))
}

/// The equations that can be read, and the faults of the others.
pub(super) fn equations_of(file: &str, text: EquationsText) -> (Equations, Faults) {
    let (equations, faults) = Equations::read_partly(text);
    (equations, faults.iter().map(|fault| equation_fault(file, &fault.key, &fault.message)).collect())
}

/// TOML that does not parse, with its line.
pub(super) fn toml_fault(file: &str, text: &str, error: &toml::de::Error) -> Fault {
    let line = error.span().map(|span| line_at(text.as_bytes(), span.start));
    Fault { line, ..equation_fault(file, "", error.message()) }
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
        assert!(
            message.starts_with("equations.toml:") && message.contains("nota") && !message.contains('\n'),
            "{message}"
        );
    }
}
