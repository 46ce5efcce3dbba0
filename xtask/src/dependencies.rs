//! `cargo xtask licences`: every dependency's licence expression against the list of allowed ones.
//! `cargo xtask advisories`: the locked packages against the RustSec database.

use crate::prelude::*;

/// The licence expressions that are allowed, as packages write them, and those that are for one package only.
const ALLOWED: &str = include_str!("../licences.txt");

/// Asks cargo for every package of the build, tests included, and its licence.
///
/// # Errors
/// When a licence is not allowed; each such package is named.
pub fn licences() -> Result {
    let tree =
        "tree --workspace --locked --edges=normal,build,dev --prefix=none --no-dedupe --format={p}|{l}";
    let listing = cargo(tree).text()?;
    let packages = packages(&listing);
    ensure(!packages.is_empty(), || Failure::check("licences: cargo lists no packages"))?;
    let refused = packages.iter().filter(|(name, licence)| !is_allowed(name, licence));
    let refused: String =
        refused.map(|(name, licence)| format!("\n{name}: licence `{licence}` is not allowed")).collect();
    ensure(refused.is_empty(), || Failure::check(format!("licences:{refused}")))?;
    println!("licences: {} packages, all allowed", packages.len());
    Ok(())
}

/// Name and licence of each package of a listing.
fn packages(listing: &str) -> BTreeSet<(&str, &str)> {
    let package = |line| {
        let (package, licence) = str::rsplit_once(line, '|')?;
        // cargo marks a package that depends on itself in tests with `(*)`.
        Some((package.split_whitespace().next()?, licence.trim().trim_end_matches("(*)").trim_end()))
    };
    listing.lines().filter_map(package).collect()
}

fn is_allowed(package: &str, licence: &str) -> bool {
    let for_this_package = format!("{licence} | {package}");
    !licence.is_empty() && ALLOWED.lines().any(|line| line == licence || line == for_this_package)
}

/// Checks every locked package against the database, which comes over the network.
/// Without the database or the program `cargo-deny`, the check is skipped with a message.
///
/// # Errors
/// With exit code 1 when there is an advisory against a locked package.
pub fn advisories() -> Result {
    let deny = |words: &str| cargo(&format!("deny --workspace --locked {words}"));
    if find_program("cargo-deny").is_none() {
        println!("advisories: skipped: no cargo-deny (cargo install cargo-deny)");
    } else if deny("fetch db").code()? != 0 {
        println!("advisories: skipped: the database cannot be fetched");
    } else {
        deny("check --disable-fetch advisories").check()?;
        println!("advisories: none against the locked packages");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Otherwise a part of the program is compiled twice: for its tests and for `verify`.
    #[test]
    fn tests_have_the_features_of_the_program() {
        // Each package with its version, and its features.
        let features = |of: &str| -> BTreeSet<(String, String)> {
            let tree = format!("tree --locked --prefix=none --no-dedupe --format={{p}}|{{f}} {of}");
            let listing = cargo(&tree).text().unwrap();
            let pairs = listing.lines().filter_map(|line| line.split_once('|'));
            pairs.map(|(name, features)| (name.into(), features.trim_end_matches(" (*)").into())).collect()
        };
        let program = features("--package=slipmode --package=slipmode-python --edges=normal");
        let tests = features("--workspace --edges=normal,dev");
        assert!(program.len() > 50);
        let more: Vec<_> = tests
            .difference(&program)
            .filter(|(name, _)| program.iter().any(|(own, _)| own == name))
            .collect();
        assert!(more.is_empty(), "{more:?}");
    }

    #[test]
    fn a_listing_gives_each_package_once() {
        let listing = "b v1.0.0|MIT\nrug v1.30.0|LGPL-3.0+\nb v1.0.0|MIT (*)\n\na v0.1.0 (proc-macro)|\n";
        assert_eq!(Vec::from_iter(packages(listing)), [("a", ""), ("b", "MIT"), ("rug", "LGPL-3.0+")]);
    }

    #[test]
    fn an_expression_is_allowed_as_it_is_listed() {
        for good in ["MIT", "MIT/Apache-2.0", "(MIT OR Apache-2.0) AND Unicode-3.0"] {
            assert!(is_allowed("x", good), "{good}");
        }
        for bad in ["", "GPL-3.0-only", "GPL-3.0 OR MIT", "MIT AND GPL-3.0", "MIT OR", "MIT MIT"] {
            assert!(!is_allowed("x", bad), "{bad:?}");
        }
    }

    #[test]
    fn the_lesser_gpl_is_for_the_arithmetic_alone() {
        assert!(is_allowed("rug", "LGPL-3.0+"));
        assert!(!is_allowed("other", "LGPL-3.0+"));
    }
}
