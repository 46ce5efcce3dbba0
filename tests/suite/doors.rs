//! Ways in from outside: the action of a workflow, the image, the development container and the recipe for conda.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::harness::{Ended, Workplace};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

fn read(name: &str) -> String {
    fs::read_to_string(Path::new(ROOT).join(name)).unwrap()
}

/// What the action of a workflow runs, on the folder `report` of a workplace.
fn verified(place: &Workplace) -> Ended {
    let folder = Path::new(env!("CARGO_BIN_EXE_slipmode")).parent().unwrap();
    let path = std::env::join_paths(
        [folder.to_path_buf()].into_iter().chain(std::env::split_paths(&std::env::var_os("PATH").unwrap())),
    );
    let output = Command::new("sh")
        .arg(Path::new(ROOT).join("action/verify.sh"))
        .args(["report", "junit.xml"])
        .current_dir(place.path(""))
        .env("PATH", path.unwrap())
        .env("GITHUB_STEP_SUMMARY", place.path("summary.md"))
        .output();
    Ended::from(output.unwrap())
}

#[test]
fn the_action_is_red_where_an_equation_was_changed_and_names_the_claim() {
    let place = Workplace::new();
    let report = Path::new(ROOT).join("reports/rice-ruina-1983");
    for name in ["report.toml", "claims.toml", "equations.toml"] {
        place.write(&format!("report/{name}"), fs::read(report.join(name)).unwrap());
    }
    for prose in fs::read_dir(report.join("prose")).unwrap() {
        let prose = prose.unwrap();
        let name = prose.file_name().into_string().unwrap();
        place.write(&format!("report/prose/{name}"), fs::read(prose.path()).unwrap());
    }
    let sound = verified(&place);
    assert_eq!(sound.code, 0, "{}", sound.stdout);
    assert!(place.read("junit.xml").contains("failures=\"0\""));
    assert!(place.read("summary.md").starts_with("### slipmode verify report: passed\n\n    "));

    let equations = place.read("report/equations.toml");
    place.write("report/equations.toml", equations.replace("K_cr = (B - A)/L", "K_cr = (B + A)/L"));
    let changed = verified(&place);
    assert_eq!(changed.code, 1, "{}", changed.stdout);
    let junit = place.read("junit.xml");
    let failed: Vec<&str> = junit.split("<testcase ").filter(|case| case.contains("<failure")).collect();
    assert!(failed.iter().any(|case| case.contains("name=\"R2")), "{junit}");
    assert!(place.read("summary.md").contains("### slipmode verify report: failed\n"));
}

#[test]
fn the_doors_install_what_the_build_needs() {
    let tools = read("xtask/tools.txt");
    let packages = ["cc", "make", "m4", "diff"].map(|tool| {
        let row = tools.lines().find(|line| line.starts_with(&format!("{tool} |"))).unwrap();
        row.rsplit('|').next().unwrap().trim().to_owned()
    });
    let installed = format!("--no-install-recommends {}", packages.join(" "));
    for door in ["action.yml", "Dockerfile", ".devcontainer/devcontainer.json"] {
        assert!(read(door).contains(&installed), "{door}: {installed}");
    }
    let rust = read("rust-toolchain.toml").parse::<toml::Table>().unwrap();
    let version = rust["toolchain"]["channel"].as_str().unwrap().rsplit_once('.').unwrap().0.to_owned();
    assert!(read("Dockerfile").contains(&format!("FROM rust:{version}-")), "{version}");
    assert!(serde_json::from_str::<serde_json::Value>(&read(".devcontainer/devcontainer.json")).is_ok());
    let action = read("action.yml");
    for part in ["$GITHUB_ACTION_PATH/action/verify.sh", "inputs.report", "inputs.junit"] {
        assert!(action.contains(part), "{part}");
    }
}

#[test]
fn the_recipe_for_conda_states_what_the_manifests_state() {
    let [cargo, python] =
        ["Cargo.toml", "python/pyproject.toml"].map(|name| read(name).parse::<toml::Table>().unwrap());
    let (package, workspace) = (&cargo["package"], &cargo["workspace"]["package"]);
    let text = |value: &toml::Value| value.as_str().unwrap().to_owned();
    let recipe = read("conda/recipe.yaml");
    let stated =
        |line: String| assert_eq!(recipe.lines().filter(|found| found.trim() == line).count(), 1, "{line}");
    stated(format!("name: {}", text(&package["name"])));
    stated(format!("version: \"{}\"", text(&workspace["version"])));
    stated(format!("- rust >={}", text(&workspace["rust-version"])));
    stated(format!("summary: {}", text(&package["description"])));
    // A compiled program has the licence of the wheel, which has the same parts.
    let licence = text(&python["project"]["license"]);
    assert!(licence.contains(&format!("({})", text(&workspace["license"]))), "{licence}");
    stated(format!("license: {licence}"));
    for line in recipe.lines().skip_while(|line| *line != "  license_file:").skip(1) {
        let file = line.trim().trim_start_matches("- ");
        assert!(Path::new(ROOT).join(file).is_file(), "{file}");
    }
    for tool in ["make", "m4", "diff"] {
        let tools = read("xtask/tools.txt");
        let row = tools.lines().find(|line| line.starts_with(&format!("{tool} |"))).unwrap();
        stated(format!("- {}", row.rsplit('|').next().unwrap().trim()));
    }
}
