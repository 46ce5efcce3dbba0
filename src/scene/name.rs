//! Names that are safe in every file system, and the nearest name to a misspelt one.

use thiserror::Error;

pub use slipmode_algebra::nearest;

/// The longest name, in characters.
const LONGEST: usize = 100;

/// Why a text cannot be a name (of a scene, a report, a file inside a report).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum NameError {
    /// Empty, or longer than 100 characters.
    #[error("a name has 1 to 100 characters")]
    Length,
    /// A character outside `A-Z a-z 0-9 . _ -`, such as a path separator.
    #[error("a name consists of A-Z a-z 0-9 . _ - only")]
    Character,
    /// Starts with `.` or `-`, or ends with `.`.
    #[error("a name does not start with `.` or `-`, nor end with `.`")]
    Edge,
    /// Reserved by Windows for a device (`CON`, `NUL`, `COM1` …), with any extension.
    #[error("a name reserved by Windows for a device")]
    Reserved,
}

/// Whether `name` can be a file name everywhere: `[A-Za-z0-9._-]{1,100}`, no leading `.` or `-`, no device.
///
/// # Errors
/// The first rule that the name breaks.
pub fn check_name(name: &str) -> Result<(), NameError> {
    if name.is_empty() || name.chars().nth(LONGEST).is_some() {
        return Err(NameError::Length);
    }
    if !name.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"._-".contains(&byte)) {
        return Err(NameError::Character);
    }
    if name.starts_with(['.', '-']) || name.ends_with('.') {
        return Err(NameError::Edge);
    }
    if is_device(name) { Err(NameError::Reserved) } else { Ok(()) }
}

fn is_device(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or(name).to_ascii_uppercase();
    let digit = stem.strip_prefix("COM").or_else(|| stem.strip_prefix("LPT"));
    ["CON", "PRN", "AUX", "NUL"].contains(&stem.as_str())
        || digit.is_some_and(|rest| rest.len() == 1 && rest.bytes().all(|byte| byte.is_ascii_digit()))
}

/// Whether two names meet in a file system that ignores case.
#[must_use]
pub fn same_name(one: &str, other: &str) -> bool {
    one.eq_ignore_ascii_case(other)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_safe_in_every_file_system() {
        for good in ["fig-1", "a", "A.b_c-9", "console", "COM10", &"x".repeat(100)] {
            assert_eq!(check_name(good), Ok(()), "{good}");
        }
        let bad = [
            ("", NameError::Length),
            (&"x".repeat(101), NameError::Length),
            ("../../x", NameError::Character),
            ("/x", NameError::Character),
            ("a\0b", NameError::Character),
            ("a b", NameError::Character),
            ("é", NameError::Character),
            ("-rf", NameError::Edge),
            (".hidden", NameError::Edge),
            ("..", NameError::Edge),
            ("dot.", NameError::Edge),
            ("CON", NameError::Reserved),
            ("nul.toml", NameError::Reserved),
            ("Lpt1", NameError::Reserved),
        ];
        for (name, reason) in bad {
            assert_eq!(check_name(name), Err(reason), "{name:?}");
        }
    }

    #[test]
    fn the_nearest_key_is_suggested_only_when_near() {
        let known = ["normal_stress_pa", "direct_effect", "points"];
        assert_eq!(nearest("normal_stres_pa", known), Some("normal_stress_pa"));
        assert_eq!(nearest("Pionts", known), Some("points"));
        assert_eq!(nearest("colour", known), None);
        assert_eq!(nearest(&"p".repeat(1_000_000), known), None);
    }
}
