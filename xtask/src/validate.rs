//! `cargo xtask validate`: external programs validate every report's page, Markdown, archive and citation.
//!
//! `xtask/validate/` lists them and fixes their versions; they are installed below `target/validate/`. A validator whose tools are
//! missing is named and skipped, except under continuous integration (`CI` is set), where all are required.

use crate::prelude::*;
use crate::repository;
use crate::{machine, verify};

const VALIDATORS: &str = include_str!("../validate/validators.txt");

/// Makes every report and its archive, and runs every validator on them.
///
/// # Errors
/// With exit code 1 when a validator finds a fault, 2 when a required one cannot be installed.
pub fn run() -> Result {
    verify::build()?;
    let reports = repository::reports()?;
    let tools: BTreeSet<&str> = rows(VALIDATORS).flat_map(|[_, tools, _]| tools.split(' ')).collect();
    machine::provide(&Vec::from_iter(tools))?;
    let pages = std::thread::scope(|scope| {
        // Packages are loaded while reports are made. If that fails, the validator that needs them tries again and reports it.
        scope.spawn(|| (npm().is_ok(), venv().is_ok()));
        reports.iter().map(|name| make(name)).collect::<Result<Vec<_>>>()
    })?;
    let (mut failed, mut skipped, mut passed) = (Vec::new(), Vec::new(), 0);
    for [name, tools, command] in rows(VALIDATORS) {
        let missing = machine::missing(&tools.split(' ').collect::<Vec<_>>());
        if !missing.is_empty() {
            println!("validate: {name} skipped: no {}", missing.join(", "));
            skipped.push(name);
        } else if accepts(name, command, &reports, &pages.concat())? {
            passed += 1;
        } else {
            failed.push(name);
        }
    }
    ensure(failed.is_empty(), || Failure::check(format!("faults found by {}", failed.join(", "))))?;
    let required = || Failure::bad_input(format!("required here, but not installed: {}", skipped.join(", ")));
    ensure(skipped.is_empty() || !machine::is_continuous_integration(), required)?;
    println!("validate: {passed} validators passed, {} skipped", skipped.len());
    Ok(())
}

/// Runs a validator: once, or once for each report.
fn accepts(name: &str, command: &str, reports: &[String], pages: &[String]) -> Result<bool> {
    println!("validate: {name}");
    let each = if command.contains("{report}") { reports } else { &[String::new()] };
    let mut accepts = true;
    for report in each {
        let words = command.split(' ').map(|word| match word {
            "{pages}" => Ok(pages.to_vec()),
            word => Ok(vec![filled_in(word, report)?]),
        });
        let words = words.collect::<Result<Vec<_>>>()?.concat();
        let mut command = program(&words[0], "");
        accepts &= command.args(&words[1..]).current_dir(root().join("target/report")).code()? == 0;
    }
    Ok(accepts)
}

/// A word of a command with its places filled in.
fn filled_in(word: &str, report: &str) -> Result<String> {
    let (head, rest) = word.split_once('{').unwrap_or((word, ""));
    let Some((place, tail)) = rest.split_once('}') else { return Ok(word.to_owned()) };
    let value = match place {
        "npm" => npm()?,
        "venv" => venv()?,
        "here" => definition(""),
        "root" => root(),
        "made" => workshop(),
        "report" => report.into(),
        "program" => verify::binary(),
        "browser" => machine::path_of("chromium"),
        _ => return Err(Failure::bad_input(format!("validators.txt: {{{place}}} is unknown"))),
    };
    Ok(format!("{head}{}{}", value.display().to_string().trim_end_matches('/'), filled_in(tail, report)?))
}

/// Makes a report and its archive. Its page, and the explorers of its scenes that have a slider and a map.
fn make(name: &str) -> Result<Vec<String>> {
    let folder = format!("reports/{name}");
    let page = root().join("target/report").join(name).join("index.html");
    if !is_current(&page, &root().join(&folder))? {
        verify::slipmode("report").arg(&folder).check()?;
    }
    fs::create_dir_all(workshop()).map_err(at(&workshop()))?;
    let archive = workshop().join(format!("{name}.zip"));
    verify::slipmode("archive --codecheck --output").arg(&archive).arg(&folder).check()?;
    let mut pages = vec![page.display().to_string()];
    let scenes = root().join(folder).join("scenes");
    let names = if scenes.exists() { below(&scenes)? } else { Vec::new() };
    for scene in names.iter().map(|name| scenes.join(name)) {
        if read(&scene)?.contains("\n[map]") {
            let page = workshop().join(file_name(&scene.with_extension("html")));
            verify::slipmode("explore").arg(&scene).arg("--output").arg(&page).check()?;
            pages.push(page.display().to_string());
        }
    }
    Ok(pages)
}

/// Whether `verify` has written this page after the program and all files of the report.
fn is_current(page: &Path, report: &Path) -> Result<bool> {
    let written = |path: &Path| fs::metadata(path).and_then(|data| data.modified()).ok();
    let inputs = below(report)?.into_iter().map(|path| report.join(path)).chain([verify::binary()]);
    let inputs: Vec<_> = inputs.map(|path| written(&path)).collect();
    // A page that was not made has no time, and nothing is before it.
    Ok(inputs.iter().all(|time| time.is_some() && *time < written(page)))
}

/// The file in a folder that says from what it was installed.
const STAMP: &str = ".installed-from";

/// The folder for tools and archives.
fn workshop() -> PathBuf {
    root().join("target/validate")
}

fn definition(name: &str) -> PathBuf {
    root().join("xtask/validate").join(name)
}

/// The folder of the packages that npm installs, each with the digest of the lock file.
fn npm() -> Result<PathBuf> {
    let modules = workshop().join("node_modules");
    let sources = ["package.json", "package-lock.json", "pages.mjs"].map(definition);
    once(&modules.join(STAMP), &sources.iter().map(|path| read(path)).collect::<Result<String>>()?, || {
        sources.iter().try_for_each(|source| copy(source, &workshop().join(file_name(source))))?;
        let options = "ci --no-audit --no-fund --ignore-scripts --loglevel=error";
        program("npm", options).current_dir(workshop()).check()
    })?;
    Ok(modules)
}

/// The programs of the virtual environment of the validators.
fn venv() -> Result<PathBuf> {
    environment(&workshop().join("venv"), &definition("requirements.txt"))
}

/// The programs of a virtual environment that pip fills with the packages of a list, which has their digests.
pub fn environment(folder: &Path, list: &Path) -> Result<PathBuf> {
    once(&folder.join(STAMP), &read(list)?, || {
        pip(&new_environment(folder)?).args(["--require-hashes", "--requirement"]).arg(list).check()
    })?;
    Ok(folder.join("bin"))
}

/// Makes an empty virtual environment. The folder of its programs.
pub fn new_environment(folder: &Path) -> Result<PathBuf> {
    program("python3", "-m venv --clear").arg(folder).check().map(|()| folder.join("bin"))
}

/// A command that installs into the virtual environment with these programs.
pub fn pip(programs: &Path) -> Command {
    program(programs.join("python"), "-m pip install --quiet --disable-pip-version-check")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_of_the_list_is_a_validator_whose_places_and_tools_are_known() {
        let all: Vec<[&str; 3]> = rows(VALIDATORS).collect();
        let listed = include_str!("../tools.txt");
        let mut tools = all.iter().flat_map(|[_, tools, _]| tools.split(' '));
        assert!(tools.all(|tool| listed.contains(&format!("\n{tool} | "))));
        for place in all.iter().flat_map(|[_, _, command]| command.split('{').skip(1)) {
            let place = place.split('}').next().unwrap();
            assert!(
                ["npm", "venv", "here", "root", "made", "pages", "browser", "program", "report"]
                    .contains(&place)
            );
        }
        assert_eq!(filled_in("a", "r").unwrap(), "a");
        let archive = filled_in("{made}/{report}.zip", "r").unwrap();
        assert!(archive.ends_with("target/validate/r.zip"), "{archive}");
        assert!(filled_in("{nothing}", "r").is_err());
    }

    #[test]
    fn every_package_of_the_validators_has_a_version_and_a_digest() {
        let lock = fs::read_to_string(definition("package-lock.json")).unwrap();
        let packages = lock.matches("\"node_modules/").count();
        assert!(packages > 50);
        assert_eq!(lock.matches("\"integrity\": \"sha512-").count(), packages);
        let requirements = fs::read_to_string(definition("requirements.txt")).unwrap();
        let packages: Vec<&str> = requirements.split('\n').filter(|line| line.contains("==")).collect();
        for line in packages.iter().filter(|line| !line.starts_with('#')) {
            let block = requirements.split(line).nth(1).unwrap();
            assert!(block.trim_start().starts_with("--hash=sha256:"), "{line}");
        }
    }

    #[test]
    fn the_toolchain_file_names_the_least_version_of_the_manifest() {
        let read = |name: &str| fs::read_to_string(root().join(name)).unwrap();
        let value = |text: &str, key: &str| -> String {
            let line = text.lines().find_map(|line| line.strip_prefix(key)).unwrap();
            line.trim_matches([' ', '=', '"']).to_string()
        };
        let channel = value(&read("rust-toolchain.toml"), "channel");
        assert_eq!(channel.split('.').count(), 3, "a channel such as `stable` moves");
        assert!(channel.starts_with(&value(&read("Cargo.toml"), "rust-version")));
    }
}
