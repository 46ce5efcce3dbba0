//! Paths inside an archive: safe in every file system, and no two of them the same file anywhere.

use crate::scene::check_name;

/// The most parts of a path.
const DEEPEST: usize = 8;

/// Whether a path is relative, plain and safe in every file system.
///
/// # Errors
/// What is wrong with it.
pub fn check_path(path: &str) -> Result<(), String> {
    if path.split('/').count() > DEEPEST {
        return Err(format!("more than {DEEPEST} parts"));
    }
    path.split('/').try_for_each(check_name).map_err(|error| error.to_string())
}

/// Pairs of paths that are one file where case is ignored, in order.
pub(super) fn meeting<'p>(paths: impl Iterator<Item = &'p str>) -> Vec<(&'p str, &'p str)> {
    let mut folded: Vec<(String, &str)> = paths.map(|path| (path.to_ascii_lowercase(), path)).collect();
    folded.sort_unstable();
    let meet = |pair: &[(String, &'p str)]| match pair {
        [(one, first), (other, second)] if one == other => Some((*first, *second)),
        _ => None,
    };
    folded.windows(2).filter_map(meet).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_stays_inside_its_folder() {
        assert_eq!(check_path("report/tables/claims.csv"), Ok(()));
        for bad in [
            "../x",
            "a/../b",
            "/etc/passwd",
            "a//b",
            "a/",
            "",
            "a\\b",
            "C:/x",
            "a/.git",
            "con/x",
            "a/\u{202e}b",
        ] {
            assert!(check_path(bad).is_err(), "{bad:?}");
        }
        assert!(check_path(&["a"; 9].join("/")).is_err());
    }

    #[test]
    fn paths_that_differ_by_case_alone_meet() {
        let paths = ["a/B", "a/c", "A/b", "a/C", "d"];
        assert_eq!(meeting(paths.into_iter()), [("A/b", "a/B"), ("a/C", "a/c")]);
    }
}
