//! An unsigned in-toto statement with SLSA provenance: which files came from which by what.

use serde_json::{Value, json};

use super::digests::sha256_hex;
use super::{Files, INPUT_FOLDER, Parts, REPORT_FOLDER, below};

/// The statement about the report's files, as JSON.
pub(super) fn statement(parts: &Parts<'_>, files: &Files) -> String {
    let described = |(path, _, bytes): (&String, &str, &Vec<u8>)| json!({ "name": path, "digest": { "sha256": sha256_hex(bytes) } });
    let subject: Vec<Value> = below(files, REPORT_FOLDER).map(described).collect();
    let program = json!({
        "name": format!("slipmode {} (sources)", parts.facts.version()),
        "digest": { "sha256": parts.facts.source_sha256 },
    });
    let dependencies: Vec<Value> = below(files, INPUT_FOLDER).map(described).chain([program]).collect();
    let statement = json!({
        "_type": "https://in-toto.io/Statement/v1",
        "subject": subject,
        "predicateType": "https://slsa.dev/provenance/v1",
        "predicate": {
            "buildDefinition": {
                "buildType": "urn:slipmode:report:1",
                "externalParameters": { "command": format!("slipmode report {INPUT_FOLDER}") },
                "internalParameters": { "versions": parts.facts.versions },
                "resolvedDependencies": dependencies,
            },
            "runDetails": { "builder": { "id": format!("urn:slipmode:{}", parts.facts.version()) } },
        },
    });
    format!("{statement:#}\n")
}
