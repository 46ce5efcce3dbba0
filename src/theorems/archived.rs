//! The theorems of one report as an archive holds them: Coq checks them with the library, and without this program.

use std::collections::{BTreeMap, BTreeSet};

use super::{Published, STEPS_FILE, files};
use crate::claims::{ACCEPTED, LIBRARY};

/// What Coq's library of real numbers assumes; a theorem may assume no more.
const ASSUMPTIONS: [&str; 4] = [
    "ClassicalDedekindReals.sig_forall_dec",
    "ClassicalDedekindReals.sig_not_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
    "Classical_Prop.classic",
];

/// The library, the theorems of the report, what was accepted, and how all of it is checked, by path.
///
/// # Errors
/// When the ledger cannot be read.
pub fn archived(report: &Published) -> Result<BTreeMap<String, String>, String> {
    let made = files(std::slice::from_ref(report), ("", Vec::new()))?;
    let mut archived: BTreeMap<String, String> =
        made.into_iter().filter(|(path, _)| path != STEPS_FILE && !path.ends_with("_faults.v")).collect();
    let compiled: Vec<String> = library_in_order().map(|name| format!("library/{name}.v")).collect();
    let checks: String = compiled
        .iter()
        .chain(archived.keys())
        .map(|path| format!("coqc -R library Slipmode {path}\n"))
        .collect();
    let library = LIBRARY.iter().map(|(name, text)| (format!("library/{name}.v"), (*text).to_owned()));
    archived.extend(library);
    archived.insert("check.sh".to_owned(), format!("#!/bin/sh\nset -e\n{checks}"));
    archived.insert("accepted.txt".to_owned(), ACCEPTED.to_owned());
    archived.insert("README.md".to_owned(), readme());
    Ok(archived)
}

/// The modules of the library, each after those that it imports.
fn library_in_order() -> impl Iterator<Item = &'static str> {
    let (mut ordered, mut known): (Vec<&str>, BTreeSet<&str>) = Default::default();
    while let Some((name, _)) = LIBRARY.iter().find(|(name, text)| {
        let mut imports = text.lines().filter_map(|line| line.strip_prefix("From Slipmode Require Export "));
        !known.contains(name)
            && imports
                .all(|line| line.trim_end_matches('.').split_whitespace().all(|name| known.contains(name)))
    }) {
        known.insert(name);
        ordered.push(*name);
    }
    ordered.into_iter()
}

fn readme() -> String {
    let assumptions = ASSUMPTIONS.map(|name| format!("- `{name}`\n")).concat();
    format!(
        "# Theorems\n\n\
         `sh check.sh` has Coq check every theorem of this folder. It needs Debian's packages `coq`, `libcoq-coquelicot` and \
         `libcoq-interval`, and nothing of slipmode.\n\n\
         - `library/` has the lemmas and theorems that are written by hand.\n\
         - The other folder has a file for each claim: `claim_…_whole.v` states whole formulas, the other files state the steps of \
         the proofs in `ledger.json`.\n\
         - `accepted.txt` lists what Coq had accepted when slipmode was built, with the SHA-256 of each statement or certificate.\n\n\
         Each file ends with `Print Assumptions`. Coq then lists what the theorems of the file assume. It may list these axioms of \
         Coq's library and no other:\n\n{assumptions}"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_library_is_compiled_in_the_order_of_its_imports() {
        let ordered: Vec<&str> = library_in_order().collect();
        assert_eq!(ordered.len(), LIBRARY.len());
        let place = |name: &str| ordered.iter().position(|known| *known == name).unwrap();
        assert!(place("Tactics") < place("Functions") && place("Cubics") < place("Slider"));
        assert!(place("Branches") < place("Claims"));
    }
}
