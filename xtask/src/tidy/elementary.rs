//! Elementary functions come from the `libm` crate or MPFR: the system's differ from machine to machine in the last bit.

use super::Complaint;
use super::rust_source::{RustSource, word_positions};
use crate::repository;

/// Methods of `f64` (and of complex numbers over it) that call the system's library, or leave accuracy open.
const METHODS: [&str; 32] = [
    "acos", "acosh", "arg", "asin", "asinh", "atan", "atan2", "atanh", "cbrt", "cos", "cosh", "exp", "exp2",
    "exp_m1", "hypot", "ln", "ln_1p", "log", "log10", "log2", "norm", "powc", "powf", "powi", "sin",
    "sin_cos", "sinh", "tan", "tanh", "to_polar", "gamma", "ln_gamma",
];

/// These names mean something else when they take an argument.
const WITHOUT_ARGUMENTS: [&str; 2] = ["arg", "norm"];

/// Text cannot tell an `f64` from an MPFR number: this comment, on the line or the one above, does.
const NOT_BINARY64: &str = "// not f64:";

/// A statement that makes an MPFR number says so itself.
const MULTIPLE_PRECISION: &str = "Float::with_val(";

/// Complains about calls that may reach the system's library of elementary functions.
pub fn check(source: &RustSource, found: &mut Vec<Complaint>) {
    if repository::inside_package(&source.file.path).is_none() {
        return;
    }
    let mut excused = false;
    for (number, code, text) in source.lines_outside_tests() {
        let is_excused = text.contains(NOT_BINARY64) || code.contains(MULTIPLE_PRECISION);
        if !is_excused && !excused {
            for method in METHODS.iter().filter(|method| calls(code, method)) {
                let message = format!(
                    "`{method}` may call the system's library: use `libm`, or say `{NOT_BINARY64} …` on the line above"
                );
                found.push(source.file.complaint(number, message));
            }
        }
        // An excuse holds for the rest of a chain of calls, but for nothing after the statement's end.
        excused = (is_excused || excused) && !code.contains(';') && !code.contains('}');
    }
}

fn calls(code: &str, method: &str) -> bool {
    let call = if WITHOUT_ARGUMENTS.contains(&method) { "()" } else { "(" };
    word_positions(code, method).any(|at| {
        let (before, after) = (&code[..at], &code[at + method.len()..]);
        let is_path = before.ends_with("f64::") || before.ends_with("f32::");
        is_path || (before.ends_with('.') && after.starts_with(call))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::lines_of;

    fn complaints(text: &str) -> Vec<usize> {
        lines_of("src/stability/x.rs", text, check)
    }

    #[test]
    fn methods_of_binary64_are_refused() {
        for bad in [
            "x.ln()",
            "x.powf(2.0)",
            "x.powi(2)",
            "v.map(f64::exp)",
            "f64::log10(x)",
            "z.norm()",
            "y.atan2(x)",
        ] {
            assert_eq!(complaints(bad), [1], "{bad}");
        }
    }

    #[test]
    fn exact_operations_libm_and_other_names_pass() {
        for good in [
            "x.sqrt()",
            "x.abs()",
            "libm::log(x)",
            "libm::exp(x)",
            "x.ln_ref()",
            "self.exponent()",
            "command.arg(x)",
            "x.norm(2)",
            "ln(x)",
            "// x.ln()",
            "\"x.ln()\"",
        ] {
            assert_eq!(complaints(good), [0; 0], "{good}");
        }
    }

    #[test]
    fn a_comment_excuses_one_statement() {
        assert_eq!(complaints("// not f64: MPFR.\nlet y = x\n    .ln();\nlet z = x.ln();"), [4]);
        assert_eq!(complaints("let y = x.ln(); // not f64: MPFR.\nlet z = 1;"), [0; 0]);
        assert_eq!(complaints("let y = Float::with_val(64, x).ln();\nlet z = y.ln();"), [2]);
    }

    #[test]
    fn tests_may_compare_with_the_system() {
        assert_eq!(complaints("#[cfg(test)]\nmod tests { fn f() { x.ln(); } }"), [0; 0]);
        assert_eq!(lines_of("tests/suite/a.rs", "x.ln()", check), [0; 0]);
    }
}
