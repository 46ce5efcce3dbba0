//! `CITATION.cff`, `codemeta.json` and `.zenodo.json` follow from `metadata.toml` and `Cargo.toml`.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::json;
use toml::{Table, Value};

const VARIABLE: &str = "SLIPMODE_WRITE_METADATA";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf()
}

fn read(path: &str) -> Table {
    fs::read_to_string(root().join(path)).unwrap().parse().unwrap()
}

fn text<'t>(table: &'t Table, key: &str) -> &'t str {
    table[key].as_str().unwrap_or_else(|| panic!("{key} is no text"))
}

fn tables<'t>(table: &'t Table, key: &str) -> impl Iterator<Item = &'t Table> {
    table[key].as_array().unwrap().iter().filter_map(Value::as_table)
}

/// What the three files are made from.
struct Source {
    metadata: Table,
    package: Table,
    workspace: Table,
}

impl Source {
    fn read() -> Self {
        let cargo = read("Cargo.toml");
        let workspace = cargo["workspace"]["package"].as_table().unwrap().clone();
        Self {
            metadata: read("metadata.toml"),
            package: cargo["package"].as_table().unwrap().clone(),
            workspace,
        }
    }

    fn licences(&self) -> Vec<&str> {
        text(&self.workspace, "license").split(" OR ").collect()
    }

    fn names(&self) -> Vec<&str> {
        tables(&self.metadata, "author").map(|author| text(author, "name")).collect()
    }

    /// Families and given names of a reference.
    fn people(reference: &Table) -> Vec<(&str, &str)> {
        let people = reference["authors"].as_array().unwrap().iter();
        people.map(|name| (name[0].as_str().unwrap(), name[1].as_str().unwrap())).collect()
    }

    fn citation(&self) -> String {
        let (metadata, version) = (&self.metadata, text(&self.workspace, "version"));
        let mut file = format!(
            "cff-version: 1.2.0\nmessage: {}\ntitle: {}\ntype: software\nversion: {version}\n",
            metadata["message"], metadata["title"],
        );
        let mut list = |key: &str, items: Vec<String>| {
            let _ = writeln!(file, "{key}:\n{}", items.join("\n"));
        };
        list("license", self.licences().iter().map(|licence| format!("  - {licence}")).collect());
        list("authors", self.names().iter().map(|name| format!("  - name: {}", json!(name))).collect());
        let keywords = metadata["keywords"].as_array().unwrap();
        list("keywords", keywords.iter().map(|word| format!("  - {word}")).collect());
        list("references", tables(metadata, "reference").map(Self::citation_of).collect());
        file
    }

    fn citation_of(reference: &Table) -> String {
        let mut item = format!("  - type: article\n    title: {}\n    authors:", reference["title"]);
        for (family, given) in Self::people(reference) {
            let _ = write!(
                item,
                "\n      - family-names: {}\n        given-names: {}",
                json!(family),
                json!(given)
            );
        }
        for key in ["journal", "volume", "start", "year"] {
            if let Some(value) = reference.get(key) {
                let _ = write!(item, "\n    {key}: {value}");
            }
        }
        item
    }

    fn codemeta(&self) -> String {
        let authors: Vec<_> =
            self.names().iter().map(|name| json!({ "type": "Organization", "name": name })).collect();
        let licences: Vec<String> =
            self.licences().iter().map(|licence| format!("https://spdx.org/licenses/{licence}")).collect();
        let article = |reference: &Table| {
            let people = Self::people(reference);
            let people: Vec<_> = people
                .iter()
                .map(|(family, given)| json!({ "type": "Person", "familyName": family, "givenName": given }))
                .collect();
            json!({ "type": "ScholarlyArticle", "name": reference["title"].as_str(), "author": people })
        };
        let file = json!({
            "@context": "https://w3id.org/codemeta/3.0",
            "type": "SoftwareSourceCode",
            "name": self.metadata["title"].as_str(),
            "alternateName": text(&self.package, "name"),
            "description": text(&self.package, "description"),
            "version": text(&self.workspace, "version"),
            "license": licences,
            "keywords": self.metadata["keywords"],
            "programmingLanguage": ["Rust", "Python"],
            "softwareRequirements": format!("Rust {} or newer", text(&self.workspace, "rust-version")),
            "author": authors,
            "citation": tables(&self.metadata, "reference").map(article).collect::<Vec<_>>(),
        });
        format!("{file:#}\n")
    }

    fn zenodo(&self) -> String {
        let creators: Vec<_> = self.names().iter().map(|name| json!({ "name": name })).collect();
        let reference = |reference: &Table| {
            let people = Self::people(reference);
            let people: Vec<String> =
                people.iter().map(|(family, given)| format!("{given} {family}")).collect();
            format!("{}: {}", people.join(", "), text(reference, "title"))
        };
        let file = json!({
            "upload_type": "software",
            "access_right": "open",
            "title": self.metadata["title"].as_str(),
            "description": text(&self.package, "description"),
            "version": text(&self.workspace, "version"),
            // A deposit has one licence: the first.
            "license": self.licences()[0],
            "keywords": self.metadata["keywords"],
            "creators": creators,
            "references": tables(&self.metadata, "reference").map(reference).collect::<Vec<_>>(),
        });
        format!("{file:#}\n")
    }
}

#[test]
fn citation_codemeta_and_zenodo_have_one_source() {
    let source = Source::read();
    let files = [
        ("CITATION.cff", source.citation()),
        ("codemeta.json", source.codemeta()),
        (".zenodo.json", source.zenodo()),
    ];
    for (path, wanted) in files {
        let place = root().join(path);
        if std::env::var_os(VARIABLE).is_some() {
            fs::write(&place, &wanted).unwrap();
        }
        let found = fs::read_to_string(&place).unwrap_or_default();
        assert!(
            found == wanted,
            "metadata.toml or Cargo.toml changed: run this test with {VARIABLE}=1, commit {path}"
        );
    }
}

#[test]
fn every_package_states_the_same_least_version_of_rust() {
    let least = text(&Source::read().workspace, "rust-version").to_owned();
    let libraries = fs::read_dir(root().join("crates")).unwrap().map(|entry| entry.unwrap().file_name());
    let libraries = libraries.map(|name| format!("crates/{}/Cargo.toml", name.to_str().unwrap()));
    for path in libraries.chain(["Cargo.toml", "python/Cargo.toml", "xtask/Cargo.toml"].map(String::from)) {
        let of_workspace = read(&path)["package"]["rust-version"]["workspace"].as_bool();
        assert_eq!(of_workspace, Some(true), "{path}");
    }
    assert_eq!(read("fuzz/Cargo.toml")["package"]["rust-version"].as_str(), Some(least.as_str()));
    for path in [
        "README.md",
        "crates/algebra/README.md",
        "crates/certified/README.md",
        "crates/core/README.md",
        "crates/plot/README.md",
        "crates/theory/README.md",
        "docs/releases.md",
    ] {
        let page = fs::read_to_string(root().join(path)).unwrap();
        let stated: Vec<&str> = page.split("Rust ").skip(1).filter(|rest| rest.starts_with("1.")).collect();
        assert!(!stated.is_empty(), "{path} states no version");
        assert!(stated.iter().all(|rest| rest.starts_with(&least)), "{path} states another version");
    }
}

#[test]
fn manifests_changelog_and_the_page_on_releases_state_one_version() {
    let version = text(&Source::read().workspace, "version").to_owned();
    let cargo = read("Cargo.toml");
    let dependencies = cargo["workspace"]["dependencies"].as_table().unwrap();
    let own = dependencies.iter().filter(|(name, _)| name.starts_with("slipmode-"));
    assert!(own.map(|(_, own)| own["version"].as_str()).all(|stated| stated == Some(&version)));
    let page = |path: &str| fs::read_to_string(root().join(path)).unwrap();
    let changelog = page("CHANGELOG.md");
    let heading = changelog.lines().find(|line| line.starts_with("## ")).unwrap();
    assert!(heading.split([' ', ':']).any(|word| word == version), "CHANGELOG.md: {heading}");
    assert!(page("docs/releases.md").contains(&format!("tag `v{version}`")));
}
