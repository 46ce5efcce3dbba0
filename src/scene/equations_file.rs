//! `equations.toml`: the paper's equations, the thing under test.

use slipmode_core::theory::{EquationFault, EquationsText, PaperEquations};

use crate::scene::file_text::line_at;
use crate::scene::{Fault, Faults, Problem, file_text};

/// Reads `equations.toml`.
///
/// # Errors
/// All the faults at once: TOML that does not parse, unknown keys, and what [`PaperEquations::read`] refuses.
pub fn read_equations(file: &str, bytes: &[u8]) -> Result<PaperEquations, Faults> {
    let text = file_text(file, bytes).map_err(|fault| vec![fault])?;
    let fault = |line, key: &str, message: &str| Fault {
        file: file.to_string(),
        line,
        key: key.to_string(),
        value: None,
        problem: Problem::Equation(message.trim_end().replace('\n', "; ")),
    };
    let equations: EquationsText = toml::from_str(text).map_err(|error| {
        let line = error.span().map(|span| line_at(text.as_bytes(), span.start));
        vec![fault(line, "", error.message())]
    })?;
    PaperEquations::read(equations).map_err(|error| {
        error.faults.iter().map(|EquationFault { key, message }| fault(None, key, message)).collect()
    })
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

    #[test]
    fn a_wrong_equation_is_named_with_its_file() {
        let message = faults(&FILE.replace("number = \"16\"", "number = \"61\""));
        assert!(message.contains("equation 61") && message.contains("equation 16"), "{message}");
    }
}
