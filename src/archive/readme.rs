//! The archive's README: what is inside, and for each claim the command that decides it again and what to expect.

use std::fmt::Write;

use super::codecheck::CODECHECK_FILE;
use super::{
    CHECKER_FILE, INPUT_FOLDER, Parts, REPORT_FOLDER, SOURCES_FILE, STATEMENT_FILE, THEOREMS_FOLDER,
    VERSIONS_FILE,
};

/// The text of the README.
pub(super) fn readme(parts: &Parts<'_>) -> String {
    let (name, title, version) = (parts.name, parts.title, parts.facts.version());
    let mut text = format!(
        "# {title}\n\n\
         The report `{name}`, with all its inputs, archived by slipmode {version}.\n\n\
         | path | content |\n| --- | --- |\n\
         | `{REPORT_FOLDER}/index.html` | the report as one page; `ledger.md` is the same in Markdown, `report.md` its reader's edition |\n\
         | `{REPORT_FOLDER}/ledger.json` | every claim with its verdict and evidence |\n\
         | `{REPORT_FOLDER}/tables/`, `{REPORT_FOLDER}/figures/` | all numbers and figures |\n\
         | `{THEOREMS_FOLDER}/` | the proofs as theorems for Coq, with their library; `sh check.sh` there has Coq check them |\n\
         | `{INPUT_FOLDER}/` | inputs of the report: scenes, claims, equations, prose, hard cases |\n\
         | `{VERSIONS_FILE}`, `Cargo.lock`, `sbom.cdx.json` | the program, its libraries, its sources' digest; the packages also as a CycloneDX bill of materials |\n\
         | `SHA256SUMS` | digests, for `sha256sum --check SHA256SUMS` |\n\
         | `ro-crate-metadata.json`, `{STATEMENT_FILE}` | the same for machines: an RO-Crate, and an unsigned in-toto statement |\n\n\
         ## Check it\n\n\
         {}\n\n\
         `slipmode replay FILE.zip` checks all digests, computes every verdict again from `{INPUT_FOLDER}/`, and compares all results with `{REPORT_FOLDER}/`.\n\
         To check one claim, from the unpacked archive:\n\n\
         | claim | command | expected |\n| --- | --- | --- |\n",
        install(parts)
    );
    for entry in &parts.ledger.claims {
        let (id, verdict) = (&entry.id, entry.finding.verdict.as_str());
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| {id} | `slipmode verify {INPUT_FOLDER} --claim {id}` | {verdict} |");
    }
    let mut certificates = parts.certificate_files().peekable();
    if certificates.peek().is_some() {
        // As above.
        let _ = write!(
            text,
            "\n## Certificates\n\n\
             `slipmode certificates {INPUT_FOLDER}/scenes/SCENE.toml` proves all certificates of a scene again. \
             `{CHECKER_FILE}` shares no code with slipmode and proves certified cycles again, here one of each file (`pip install python-flint`):\n\n"
        );
        for (file, bytes) in certificates {
            let row = row_to_prove(&String::from_utf8_lossy(bytes))
                .map_or_else(String::new, |row| format!("--rows {row} "));
            let _ = writeln!(text, "    python {CHECKER_FILE} {row}{INPUT_FOLDER}/{file}");
        }
    }
    if parts.codecheck.is_some() {
        // As above.
        let _ = write!(
            text,
            "\n## CODECHECK\n\n\
             The manifest of `{CODECHECK_FILE}` lists every file below `{REPORT_FOLDER}/`. `LICENSE` names the licences of all files.\n\
             `slipmode report {INPUT_FOLDER} --output again` makes these files again, below `again/`. \
             `index.html` and `ledger.md` then end with the versions and the machine of the run; nothing else differs.\n"
        );
    }
    text
}

/// How a stranger gets the program.
fn install(parts: &Parts<'_>) -> String {
    if parts.sources.is_none() {
        return "You need the program slipmode, of the version above or a newer one. `slipmode archive --with-sources` makes archives that have its sources."
            .into();
    }
    format!(
        "`{SOURCES_FILE}` is meant to have the sources of slipmode with all packages that it is built from; the archive does not prove it. You need Rust {} or newer, a C compiler, make, m4 and diff, and no network:\n\n\
         ```sh\n\
         tar --extract --file {SOURCES_FILE}\n\
         cd slipmode-sources\n\
         cargo install --offline --locked --path . --root ../program\n\
         ```\n\n\
         The program is then `program/bin/slipmode`. `program/bin/slipmode --version` prints the digest of its sources, which must be {}. `docker build -t slipmode slipmode-sources` makes a container with it instead.",
        env!("CARGO_PKG_RUST_VERSION"),
        parts.facts.source_sha256,
    )
}

/// The number of a row whose cycle is proved within seconds: of the cycles that pass the section at V = V_l, which hardly stick, the one in the middle.
fn row_to_prove(text: &str) -> Option<usize> {
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next()?;
    let column = |name: &str| header.iter().position(|cell| *cell == name);
    let (certificate, section) = (column("certificate")?, column("section_log_velocity")?);
    let is_mild =
        |cells: &Vec<&str>| cells.get(certificate) == Some(&"cycle") && cells.get(section) == Some(&"0");
    let mild: Vec<usize> = lines.zip(1..).filter(|(cells, _)| is_mild(cells)).map(|(_, row)| row).collect();
    mild.get(mild.len() / 2).copied()
}
