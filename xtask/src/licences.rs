//! `cargo xtask licences`: every dependency's licence against the allow list.

use crate::failure::Failure;
use crate::{process, spdx};

/// Permissive licences, compatible with MIT OR Apache-2.0.
const ALLOWED: [&str; 12] = [
    "0BSD",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "BSL-1.0",
    "CC0-1.0",
    "ISC",
    "MIT",
    "Unicode-3.0",
    "Unlicense",
    "Zlib",
];

/// The LGPL is accepted for the arithmetic alone; README.md states this for users of a binary.
const LESSER_GPL: [&str; 2] = ["LGPL-3.0+", "LGPL-3.0-or-later"];
const LESSER_GPL_PACKAGES: [&str; 2] = ["gmp-mpfr-sys", "rug"];

/// Asks cargo for every package of the build, tests included, and its licence.
///
/// # Errors
/// When a licence is not allowed; each such package is named.
pub fn run() -> Result<(), Failure> {
    let arguments = [
        "tree",
        "--workspace",
        "--locked",
        "--edges=normal,build,dev",
        "--prefix=none",
        "--no-dedupe",
        "--format={p}|{l}",
    ];
    let listing = process::output(&mut process::cargo(&arguments))?;
    let packages = packages(&listing);
    let refused = refused(&packages);
    if packages.is_empty() {
        return Err(Failure::check("licences: cargo lists no packages"));
    }
    if refused.is_empty() {
        println!("licences: {} packages, all allowed", packages.len());
        return Ok(());
    }
    let lines: Vec<String> =
        refused.iter().map(|(name, licence)| format!("{name}: licence `{licence}` is not allowed")).collect();
    Err(Failure::check(format!("licences:\n{}", lines.join("\n"))))
}

/// Name and licence of each package of a listing, once each.
fn packages(listing: &str) -> Vec<(&str, &str)> {
    let mut packages: Vec<(&str, &str)> = listing
        .lines()
        .filter_map(|line| line.rsplit_once('|'))
        // cargo marks a package that depends on itself in tests with `(*)`.
        .map(|(package, licence)| (package, licence.trim().trim_end_matches("(*)").trim_end()))
        .map(|(package, licence)| (package.split_whitespace().next().unwrap_or_default(), licence))
        .collect();
    packages.sort_unstable();
    packages.dedup();
    packages
}

fn refused<'a>(packages: &[(&'a str, &'a str)]) -> Vec<(&'a str, &'a str)> {
    packages.iter().filter(|(name, licence)| !is_allowed(name, licence)).copied().collect()
}

fn is_allowed(package: &str, licence: &str) -> bool {
    spdx::is_satisfied(licence, &|name| {
        ALLOWED.contains(&name) || (LESSER_GPL.contains(&name) && LESSER_GPL_PACKAGES.contains(&package))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_listing_gives_each_package_once() {
        let listing = "b v1.0.0|MIT\nrug v1.30.0|LGPL-3.0+\nb v1.0.0|MIT (*)\n\na v0.1.0 (proc-macro)|\n";
        assert_eq!(packages(listing), [("a", ""), ("b", "MIT"), ("rug", "LGPL-3.0+")]);
    }

    #[test]
    fn the_lesser_gpl_is_for_the_arithmetic_alone() {
        assert!(is_allowed("rug", "LGPL-3.0+"));
        assert!(!is_allowed("other", "LGPL-3.0+"));
        assert_eq!(
            refused(&[("x", "GPL-3.0-only"), ("y", "MIT"), ("z", "")]),
            [("x", "GPL-3.0-only"), ("z", "")]
        );
    }
}
