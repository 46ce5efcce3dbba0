//! `slipmode new --paper`: a folder for the claims of another paper, with one example of each thing.

use crate::cli::tree::Files;

/// The files, by their path in the folder.
const FILES: [(&str, &str); 4] = [
    ("report.toml", include_str!("../../../templates/new/paper/report.toml")),
    ("equations.toml", include_str!("../../../templates/new/paper/equations.toml")),
    ("claims.toml", include_str!("../../../templates/new/paper/claims.toml")),
    ("prose/introduction.md", include_str!("../../../templates/new/paper/introduction.md")),
];

/// The files of a report of this name.
pub fn files(name: &str) -> Files {
    FILES.into_iter().map(|(path, text)| (path.to_owned(), text.replace("{name}", name))).collect()
}
