//! The floors: a module imports lower floors only. `xtask/tidy/floors.txt` is the one place that says which is which.

use super::imports::brought;
use super::source::{Source, line_at, word_positions};
use crate::prelude::*;

const LIBRARIES: &str = include_str!("../../tidy/floors.txt");

/// Complains about imports of an equal or higher floor, and about paths that hide their floor.
pub fn check(source: &Source, found: &mut Vec<String>) {
    let inside = |[folder, floors]: [&'static str; 2]| Some((floors, source.path.strip_prefix(folder)?));
    let Some((floors, inside)) = rows(LIBRARIES).find_map(inside) else { return };
    let module = inside.split('/').next().unwrap_or(inside).trim_end_matches(".rs");
    // The library's root stands on no floor.
    if module == "lib" {
        return;
    }
    let Some(height) = floor(floors, module) else {
        let message = format!("module `{module}` has no floor in the table of xtask tidy");
        return found.push(source.complaint(0, message));
    };
    for (position, name) in imports(&source.code) {
        let message = match floor(floors, &name) {
            _ if name == module => continue,
            Some(other) if other < height => continue,
            Some(_) => format!("`{module}` may not import `{name}`, which is not on a lower floor"),
            None => format!("`{name}` is not a floor: name the module that holds it"),
        };
        found.push(source.complaint(line_at(&source.code, position), message));
    }
    let depth = inside.matches('/').count() + 1 - usize::from(inside.ends_with("/mod.rs"));
    check_super(source, depth, found);
}

/// A chain of `super` that is as long as the module is deep reaches the crate's root, where every floor is.
fn check_super(source: &Source, depth: usize, found: &mut Vec<String>) {
    for (number, code, _) in source.lines() {
        let in_test_module = source.is_test_line(number) && !source.path.ends_with("/tests.rs");
        let chain = "super::".repeat(depth + usize::from(in_test_module));
        if code.contains(&chain) {
            let message = "write the path from `crate::`, so that its floor can be seen";
            found.push(source.complaint(number, message));
        }
    }
}

fn floor(floors: &str, module: &str) -> Option<usize> {
    floors.split(" < ").position(|floor| floor.split(' ').any(|name| name == module))
}

/// Position and name of every module that a path from the crate's root names, groups such as `crate::{a::B, c}` included.
fn imports(code: &str) -> BTreeSet<(usize, String)> {
    let starts = ["crate::", "slipmode::"].iter().flat_map(|root| word_positions(code, root));
    let heads = |start| {
        let statement = code[start..].split(';').next().unwrap_or_default();
        let is_end = |c: char| !c.is_alphanumeric() && c != '_' && c != ':';
        let (path, rest) = statement.split_at(statement.find(is_end).unwrap_or(statement.len()));
        let is_group = path.ends_with("::") && rest.starts_with('{');
        let names = brought(if is_group { statement } else { path }, &[String::new()]);
        names.into_iter().filter_map(move |(_, place)| Some((start, place.get(1)?.clone())))
    };
    starts.flat_map(heads).collect()
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
        assert_eq!(complaints("crates/core/src/dynamics/mod.rs", "use crate::stability::Arc;"), [1]);
        assert_eq!(complaints("crates/core/src/dynamics/x.rs", "fn f() { crate::checked::g() }"), [1]);
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
