//! `ro-crate-metadata.json`: the archive as an RO-Crate 1.1 that follows Process Run Crate 0.5.

use serde_json::{Value, json};

use super::digests::{DIGESTS_FILE, sha256_hex};
use super::{Files, INPUT_FOLDER, Parts, REPORT_FOLDER, below};

/// The file with the metadata.
pub(super) const CRATE_FILE: &str = "ro-crate-metadata.json";

const PROFILE: &str = "https://w3id.org/ro/wfrun/process/0.5";
const LICENCE: &str = "https://spdx.org/licenses/MIT";

/// The metadata of these files, as JSON-LD.
pub(super) fn crate_metadata(parts: &Parts<'_>, files: &Files) -> String {
    let mut graph = vec![
        json!({
            "@id": CRATE_FILE,
            "@type": "CreativeWork",
            "about": id("./"),
            "conformsTo": id("https://w3id.org/ro/crate/1.1"),
        }),
        root(parts, files),
        json!({ "@id": PROFILE, "@type": "CreativeWork", "name": "Process Run Crate", "version": "0.5" }),
        json!({
            "@id": LICENCE, "@type": "CreativeWork", "name": "MIT License", "url": LICENCE,
            "description": "A short permissive licence; Apache-2.0 at your option.",
        }),
        json!({ "@id": "#authors", "@type": "Organization", "name": "The slipmode authors" }),
        program(parts),
        action(parts, files),
    ];
    graph.extend(files.iter().map(|(path, bytes)| file(path, bytes)));
    graph.push(json!({
        "@id": DIGESTS_FILE, "@type": "File", "name": "Digests of all other files", "encodingFormat": "text/plain",
    }));
    let context = json!(["https://w3id.org/ro/crate/1.1/context", { "sha256": "https://w3id.org/ro/terms/workflow-run#sha256" }]);
    format!("{:#}\n", json!({ "@context": context, "@graph": graph }))
}

fn id(id: &str) -> Value {
    json!({ "@id": id })
}

fn root(parts: &Parts<'_>, files: &Files) -> Value {
    let has_part: Vec<Value> = files.keys().map(|path| id(path)).chain([id(DIGESTS_FILE)]).collect();
    json!({
        "@id": "./",
        "@type": "Dataset",
        "name": parts.title,
        "description": format!("The report {}: inputs, tables, figures, verdicts and pages, to be run again by slipmode replay.", parts.name),
        "datePublished": parts.facts.time.to_rfc3339(),
        "license": id(LICENCE),
        "author": id("#authors"),
        "publisher": id("#authors"),
        "conformsTo": id(PROFILE),
        "hasPart": has_part,
        "mentions": id("#report"),
    })
}

/// The program's name among packages of Rust (a package URL), as in the bill of materials.
fn program_id(parts: &Parts<'_>) -> String {
    format!("pkg:cargo/slipmode@{}", parts.facts.version())
}

fn program(parts: &Parts<'_>) -> Value {
    json!({
        "@id": program_id(parts),
        "@type": "SoftwareApplication",
        "name": "slipmode",
        "softwareVersion": parts.facts.version(),
        "url": program_id(parts),
        "sha256": parts.facts.source_sha256,
    })
}

fn action(parts: &Parts<'_>, files: &Files) -> Value {
    let within = |folder: &str| below(files, folder).map(|(path, ..)| id(path)).collect::<Vec<_>>();
    json!({
        "@id": "#report",
        "@type": "CreateAction",
        "name": format!("slipmode report {INPUT_FOLDER}"),
        "description": "Proofs, roots, boundaries, simulations and verdicts computed from the inputs",
        "instrument": id(&program_id(parts)),
        "agent": id("#authors"),
        "object": within(INPUT_FOLDER),
        "result": within(REPORT_FOLDER),
        "endTime": parts.facts.time.to_rfc3339(),
        "actionStatus": "http://schema.org/CompletedActionStatus",
    })
}

fn file(path: &str, bytes: &[u8]) -> Value {
    json!({
        "@id": path,
        "@type": "File",
        "name": path,
        "contentSize": bytes.len().to_string(),
        "encodingFormat": media_type(path),
        "sha256": sha256_hex(bytes),
    })
}

fn media_type(path: &str) -> &'static str {
    let known = [
        (".html", "text/html"),
        (".md", "text/markdown"),
        (".csv", "text/csv"),
        (".svg", "image/svg+xml"),
        (".json", "application/json"),
        (".toml", "application/toml"),
        (".cff", "application/yaml"),
        (".yml", "application/yaml"),
    ];
    let found = known.into_iter().find(|(ending, _)| path.ends_with(ending));
    found.map_or("text/plain", |(_, media_type)| media_type)
}
