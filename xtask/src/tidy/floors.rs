//! The floors: a module imports lower floors only. The table below is the one place that says which is which.

use super::Complaint;
use super::rust_source::{RustSource, word_positions};

/// Every top module of a library and its floor; modules on one floor may not import each other.
type Floors = &'static [(&'static str, u32)];

/// The source folder of each library with its floors. What one library may take from another is in its `Cargo.toml`.
const LIBRARIES: [(&str, Floors); 3] = [
    (
        "crates/core/src/",
        &[("number", 0), ("roots", 1), ("friction", 2), ("theory", 3), ("stability", 3), ("dynamics", 3)],
    ),
    ("crates/plot/src/", &[("table", 0), ("figure", 1)]),
    (
        "src/",
        &[
            ("scene", 0),
            ("sweep", 1),
            ("comparison", 1),
            ("csv", 2),
            ("experiments", 2),
            ("explorer", 3),
            ("claims", 3),
            ("theorems", 4),
            ("report", 5),
            ("archive", 6),
            ("cli", 7),
            ("main", 8),
        ],
    ),
];

/// Complains about imports of an equal or higher floor, and about paths that hide their floor.
pub fn check(source: &RustSource, found: &mut Vec<Complaint>) {
    let Some((floors, inside)) = library(&source.file.path) else { return };
    let Some(module) = top_module(inside) else { return };
    let Some(height) = floor(floors, module) else {
        found.push(
            source.file.complaint(0, format!("module `{module}` has no floor in the table of xtask tidy")),
        );
        return;
    };
    for root in ["crate::", "slipmode::"] {
        for (position, name) in imports(&source.code, root) {
            if let Some(message) = objection(floors, module, height, &name) {
                found.push(source.file.complaint(source.line_at(position), message));
            }
        }
    }
    check_super(source, depth(inside), found);
}

/// A chain of `super` that is as long as the module is deep reaches the crate's root, where every floor is.
fn check_super(source: &RustSource, depth: usize, found: &mut Vec<Complaint>) {
    for (number, code, _) in source.lines() {
        let in_test_module = source.is_test_line(number) && !source.file.path.ends_with("/tests.rs");
        let chain = "super::".repeat(depth + usize::from(in_test_module));
        if code.contains(&chain) {
            let message = "write the path from `crate::`, so that its floor can be seen";
            found.push(source.file.complaint(number, message));
        }
    }
}

/// How many modules deep a file's module is: 1 for `roots/mod.rs`, 2 for `roots/ladder.rs`.
fn depth(inside: &str) -> usize {
    inside.matches('/').count() + 1 - usize::from(inside.ends_with("/mod.rs"))
}

fn objection(floors: Floors, module: &str, height: u32, imported: &str) -> Option<String> {
    match floor(floors, imported) {
        _ if imported == module => None,
        None => Some(format!("`{imported}` is not a floor: name the module that holds it")),
        Some(other) if other < height => None,
        Some(other) => {
            Some(format!("`{module}` (floor {height}) may not import `{imported}` (floor {other})"))
        }
    }
}

fn floor(floors: Floors, module: &str) -> Option<u32> {
    floors.iter().find(|(name, _)| *name == module).map(|(_, height)| *height)
}

/// The floors of the library that a file belongs to, and its path inside the library.
fn library(path: &str) -> Option<(Floors, &str)> {
    LIBRARIES.iter().find_map(|(folder, floors)| Some((*floors, path.strip_prefix(folder)?)))
}

/// The first component, without `.rs`; the library's root stands on no floor.
fn top_module(inside: &str) -> Option<&str> {
    let first = inside.split('/').next()?;
    let name = first.strip_suffix(".rs").unwrap_or(first);
    (name != "lib").then_some(name)
}

/// Position and name of every module that follows `root`, groups such as `crate::{a::B, c}` included.
fn imports(code: &str, root: &str) -> Vec<(usize, String)> {
    let name = root.trim_end_matches(':');
    let starts = word_positions(code, name).filter(|start| code[*start..].starts_with(root));
    let mut found = Vec::new();
    for start in starts {
        let rest = &code[start + root.len()..];
        let heads = if rest.starts_with('{') { group_heads(rest) } else { vec![identifier(rest)] };
        found.extend(heads.into_iter().map(|head| (start, head)));
    }
    found
}

/// The first identifier of each entry of a braced group.
fn group_heads(group: &str) -> Vec<String> {
    let mut depth = 0_u32;
    let mut heads = Vec::new();
    for (position, character) in group.char_indices() {
        let opens_entry = match character {
            '{' => {
                depth += 1;
                depth == 1
            }
            '}' if depth == 1 => return heads,
            '}' => {
                depth -= 1;
                false
            }
            ',' => depth == 1,
            _ => false,
        };
        let head = identifier(group[position + 1..].trim_start());
        if opens_entry && !head.is_empty() {
            heads.push(head);
        }
    }
    heads
}

fn identifier(text: &str) -> String {
    text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::lines_of;

    fn complaints(path: &str, text: &str) -> Vec<usize> {
        lines_of(path, text, check)
    }

    #[test]
    fn a_module_may_import_lower_floors_and_itself() {
        let good = "use crate::number::Ball;\nuse crate::{friction::Groups, roots};\nuse crate::stability::Arc;\n// crate::cli";
        assert_eq!(complaints("crates/core/src/stability/curve.rs", good), [0; 0]);
        assert_eq!(complaints("src/lib.rs", "pub use crate::anything;"), [0; 0]);
        assert_eq!(
            complaints("src/cli/run.rs", "use slipmode::report::Page;\nuse crate::cli::options;"),
            [0; 0]
        );
    }

    #[test]
    fn equal_and_higher_floors_are_refused() {
        assert_eq!(complaints("crates/core/src/stability/curve.rs", "\nuse crate::dynamics::Slider;"), [2]);
        assert_eq!(complaints("crates/core/src/theory/mod.rs", "use crate::stability::Arc;"), [1]);
        assert_eq!(complaints("crates/core/src/dynamics/x.rs", "fn f() { crate::theory::g() }"), [1]);
        assert_eq!(
            complaints(
                "crates/core/src/number/ball.rs",
                "use crate::{\n    number::Dd,\n    roots::{Rung, x},\n};"
            ),
            [1]
        );
        assert_eq!(complaints("src/report/page.rs", "use slipmode::cli::x;"), [1]);
    }

    #[test]
    fn what_is_not_in_the_table_is_refused() {
        assert_eq!(complaints("src/helpers/mod.rs", ""), [0]);
        assert_eq!(complaints("crates/core/src/number/x.rs", "use crate::Ball;"), [1]);
    }

    #[test]
    fn super_may_not_leave_the_module() {
        assert_eq!(complaints("crates/core/src/roots/a.rs", "use super::super::report;"), [1]);
        assert_eq!(complaints("crates/core/src/roots/mod.rs", "use super::report;"), [1]);
        assert_eq!(
            complaints("crates/core/src/roots/mod.rs", "#[cfg(test)]\nmod tests {\n    use super::*;\n}"),
            [0; 0]
        );
        assert_eq!(complaints("crates/core/src/roots/a.rs", "use super::ladder;"), [0; 0]);
        let tests = "#[cfg(test)]\nmod tests {\n    use super::super::Ladder;\n}";
        assert_eq!(complaints("crates/core/src/roots/a.rs", tests), [0; 0]);
        assert_eq!(complaints("crates/core/src/roots/mod.rs", tests), [3]);
    }
}
