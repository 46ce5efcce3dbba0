//! `sbom.cdx.json`: the packages of `Cargo.lock` as a CycloneDX 1.6 bill of materials.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::{Value, json};

/// What is read of `Cargo.lock`.
#[derive(Debug, Default, Deserialize)]
struct Lock {
    #[serde(default)]
    package: Vec<Package>,
}

#[derive(Debug, Deserialize)]
struct Package {
    name: String,
    version: String,
    checksum: Option<String>,
    #[serde(default)]
    dependencies: Vec<String>,
}

impl Package {
    /// The package's address, <https://github.com/package-url/purl-spec>.
    fn address(&self) -> String {
        format!("pkg:cargo/{}@{}", self.name, self.version)
    }

    fn component(&self) -> Value {
        let address = self.address();
        let mut component = json!({
            "type": "library", "bom-ref": address, "name": self.name, "version": self.version, "purl": address,
        });
        if let Some(checksum) = &self.checksum {
            component["hashes"] = json!([{ "alg": "SHA-256", "content": checksum }]);
        }
        component
    }
}

/// The bill of materials of a program of this version that is built with this lock file; without packages if it is none.
pub(super) fn bill_of_materials(lock: &str, version: &str) -> String {
    let Lock { package: packages } = toml::from_str(lock).unwrap_or_default();
    let by_name: BTreeMap<&str, String> =
        packages.iter().map(|package| (package.name.as_str(), package.address())).collect();
    // A dependency is "name", or "name version" where there are several.
    let address = |dependency: &String| match dependency.split_once(' ') {
        Some((name, version)) => format!("pkg:cargo/{name}@{version}"),
        None => by_name.get(dependency.as_str()).cloned().unwrap_or_default(),
    };
    let depends = |package: &Package| {
        let on: Vec<String> = package.dependencies.iter().map(address).collect();
        json!({ "ref": package.address(), "dependsOn": on })
    };
    let bill = json!({
        "$schema": "http://cyclonedx.org/schema/bom-1.6.schema.json",
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "version": 1,
        "metadata": { "component": { "type": "application", "bom-ref": "slipmode", "name": "slipmode", "version": version } },
        "components": packages.iter().map(Package::component).collect::<Vec<_>>(),
        "dependencies": packages.iter().map(depends).collect::<Vec<_>>(),
    });
    format!("{bill:#}\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_locked_package_is_listed_with_its_digest_and_dependencies() {
        let lock = "[[package]]\nname = \"a\"\nversion = \"1.0.0\"\ndependencies = [\"b 2.0.0\", \"c\"]\n\
            [[package]]\nname = \"b\"\nversion = \"2.0.0\"\nchecksum = \"ab\"\n[[package]]\nname = \"c\"\nversion = \"3.0.0\"\n";
        let bill: Value = serde_json::from_str(&bill_of_materials(lock, "0.1.0")).unwrap();
        assert_eq!(
            (bill["bomFormat"].as_str(), bill["specVersion"].as_str()),
            (Some("CycloneDX"), Some("1.6"))
        );
        assert_eq!(bill["components"].as_array().unwrap().len(), 3);
        assert_eq!(bill["components"][1]["hashes"][0]["content"], "ab");
        assert_eq!(bill["dependencies"][0]["dependsOn"], json!(["pkg:cargo/b@2.0.0", "pkg:cargo/c@3.0.0"]));
        let own: Value =
            serde_json::from_str(&bill_of_materials(include_str!("Cargo.lock"), "0.1.0")).unwrap();
        let components = own["components"].as_array().unwrap();
        assert!(components.iter().any(|component| component["name"] == "rug"), "the arithmetic is listed");
    }
}
