//! `cargo xtask validate`: external programs validate every report's page, Markdown, archive and citation.
//!
//! `xtask/validate/` fixes their versions; they are installed below `target/validate/`. A validator whose programs are missing is named
//! and skipped, except under continuous integration (`CI` is set), where all are required.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::failure::Failure;
use crate::{machine, process, repository, verify};

/// What validators check of one report.
struct Made {
    folder: PathBuf,
    /// The report's page, and the explorers of its scenes.
    pages: Vec<PathBuf>,
    archive: PathBuf,
}

/// One validator: its name, the programs that it needs, and its commands for all reports.
struct Validator {
    name: &'static str,
    programs: &'static [&'static [&'static str]],
    commands: fn(&[Made]) -> Result<Vec<Command>, Failure>,
}

const NODE: &[&str] = &["node"];
const NPM: &[&str] = &["npm"];
const JAVA: &[&str] = &["java"];
/// Debian's Python needs this package to make virtual environments; `python3` alone is not enough.
pub const PYTHON: &[&str] = &["python3"];
/// It runs the wheel on older processors.
pub const EMULATOR: &[&str] = &["qemu-x86_64"];
const VENV: &str = "python3-venv";
const BROWSER: &[&str] = &["chromium", "chromium-browser", "google-chrome"];

const VALIDATORS: [Validator; 8] = [
    Validator { name: "Nu HTML checker", programs: &[NPM, JAVA], commands: nu_html_checker },
    Validator { name: "html-validate", programs: &[NODE, NPM], commands: html_validate },
    Validator { name: "axe-core in Chromium", programs: &[NODE, NPM, BROWSER], commands: pages_in_browser },
    Validator { name: "markdownlint", programs: &[NODE, NPM], commands: markdownlint },
    Validator { name: "RO-Crate validator", programs: &[PYTHON], commands: crate_validator },
    Validator { name: "CODECHECK rules", programs: &[PYTHON], commands: codecheck },
    Validator { name: "cffconvert", programs: &[PYTHON], commands: citation },
    Validator { name: "independent program for claims", programs: &[PYTHON], commands: independent_program },
];

/// Makes every report and its archive, and runs every validator on them.
///
/// # Errors
/// With exit code 1 when a validator finds a fault, 2 when a required one cannot be installed.
pub fn run() -> Result<(), Failure> {
    machine::run()?;
    verify::build()?;
    let lacking = VALIDATORS.each_ref().map(|validator| lacking_after_install(validator.programs));
    let made = std::thread::scope(|scope| {
        // Packages are loaded while reports are made. If that fails, the validator that needs them tries again and reports it.
        scope.spawn(|| (node_modules().is_ok(), python_program("python").is_ok()));
        repository::reports()?.iter().map(|name| make(name)).collect::<Result<Vec<Made>, Failure>>()
    })?;
    let (mut failed, mut skipped) = (Vec::new(), Vec::new());
    for (validator, lacking) in VALIDATORS.iter().zip(lacking) {
        let lacking = lacking?;
        if !lacking.is_empty() {
            println!("validate: {} skipped: no {}", validator.name, lacking.join(", "));
            skipped.push(validator.name);
        } else if !passes(validator, &made)? {
            failed.push(validator.name);
        }
    }
    if !failed.is_empty() {
        return Err(Failure::check(format!("faults found by {}", failed.join(", "))));
    }
    if !skipped.is_empty() && machine::is_continuous_integration() {
        return Err(Failure::bad_input(format!("required here, but not installed: {}", skipped.join(", "))));
    }
    println!("validate: {} validators passed, {} skipped", VALIDATORS.len() - skipped.len(), skipped.len());
    Ok(())
}

fn passes(validator: &Validator, made: &[Made]) -> Result<bool, Failure> {
    println!("validate: {}", validator.name);
    let mut passed = true;
    for mut command in (validator.commands)(made)? {
        passed &= process::status(&mut command)? == 0;
    }
    Ok(passed)
}

fn make(name: &str) -> Result<Made, Failure> {
    let archive = workshop()?.join(format!("{name}.zip"));
    let folder = format!("reports/{name}");
    let page = repository::root().join("target/report").join(name).join("index.html");
    if !is_current(&page, &folder)? {
        process::check(&mut verify::slipmode(&["report", &folder]))?;
    }
    process::check(verify::slipmode(&["archive", &folder, "--codecheck", "--output"]).arg(&archive))?;
    let mut pages = explorers(name)?;
    pages.insert(0, page);
    Ok(Made { pages, folder: repository::root().join("target/report").join(name), archive })
}

/// Whether `verify` has written this page after the program and all files of the report.
fn is_current(page: &Path, report: &str) -> Result<bool, Failure> {
    let written = |path: &Path| fs::metadata(path).and_then(|data| data.modified()).ok();
    let Some(made) = written(page) else { return Ok(false) };
    let inputs = repository::files()?.into_iter().filter(|path| path.starts_with(&format!("{report}/")));
    let mut sources = inputs.map(|path| repository::root().join(path)).chain([verify::binary()]);
    Ok(sources.all(|path| written(&path).is_some_and(|time| time < made)))
}

/// An explorer for each scene of a report that has a slider and a map; a report may have no scenes.
fn explorers(name: &str) -> Result<Vec<PathBuf>, Failure> {
    let scenes = repository::root().join("reports").join(name).join("scenes");
    if !scenes.exists() {
        return Ok(Vec::new());
    }
    let cannot = |error: std::io::Error| Failure::bad_input(format!("{}: {error}", scenes.display()));
    let entries = fs::read_dir(&scenes).map_err(cannot)?.collect::<Result<Vec<_>, _>>().map_err(cannot)?;
    let paths: std::collections::BTreeSet<PathBuf> = entries.into_iter().map(|entry| entry.path()).collect();
    let mut pages = Vec::new();
    for scene in paths {
        if fs::read_to_string(&scene).map_err(cannot)?.contains("\n[map]") {
            let page = workshop()?.join(scene.with_extension("html").file_name().unwrap_or_default());
            process::check(verify::slipmode(&["explore"]).arg(&scene).arg("--output").arg(&page))?;
            pages.push(page);
        }
    }
    Ok(pages)
}

/// The programs that are missing, after an attempt to install them where nothing may be skipped.
pub fn lacking_after_install(programs: &[&[&'static str]]) -> Result<Vec<&'static str>, Failure> {
    let missing = lacking(programs);
    if !missing.is_empty() && machine::is_continuous_integration() && machine::can_install() {
        machine::install_packages(&debian_packages(&missing))?;
    }
    Ok(lacking(programs))
}

/// The programs of which no spelling is found, and the package that Python lacks.
fn lacking(programs: &[&[&'static str]]) -> Vec<&'static str> {
    let absent = |spellings: &&&[&'static str]| find(spellings).is_none();
    let mut missing: Vec<&str> =
        programs.iter().filter(absent).filter_map(|spellings| spellings.first().copied()).collect();
    if programs.contains(&PYTHON) && missing.is_empty() && !python_makes_environments() {
        missing.push(VENV);
    }
    missing
}

fn python_makes_environments() -> bool {
    let run = Command::new("python3").args(["-c", "import ensurepip, venv"]).output();
    run.is_ok_and(|output| output.status.success())
}

fn find(spellings: &[&str]) -> Option<PathBuf> {
    spellings.iter().find_map(|name| process::find_program(name, &machine::search_path()))
}

fn debian_packages(programs: &[&str]) -> Vec<&'static str> {
    let package = |program: &&str| match *program {
        "node" => "nodejs",
        "npm" => "npm",
        "java" => "default-jre-headless",
        // This package installs Python too.
        "python3" => VENV,
        name if name == VENV => VENV,
        "qemu-x86_64" => "qemu-user",
        _ => "chromium",
    };
    programs.iter().map(package).collect()
}

/// The folder for tools and archives.
fn workshop() -> Result<PathBuf, Failure> {
    let folder = repository::root().join("target/validate");
    fs::create_dir_all(&folder)
        .map_err(|error| Failure::bad_input(format!("{}: {error}", folder.display())))?;
    Ok(folder)
}

fn definition(name: &str) -> PathBuf {
    repository::root().join("xtask/validate").join(name)
}

/// The file that an installation leaves when it has succeeded.
const INSTALLED: &str = ".installed-from";

/// Installs into a folder of the tools' folder, unless the last installation that succeeded used the same definitions.
fn install(
    workshop: &Path,
    folder: &str,
    definitions: &[&str],
    run: impl FnOnce() -> Result<(), Failure>,
) -> Result<PathBuf, Failure> {
    let cannot = |name: &str, error: std::io::Error| Failure::bad_input(format!("{name}: {error}"));
    let mut wanted = Vec::new();
    for name in definitions {
        let text = fs::read(definition(name)).map_err(|error| cannot(name, error))?;
        fs::write(workshop.join(name), &text).map_err(|error| cannot(name, error))?;
        wanted.extend(text);
    }
    let installed = workshop.join(folder);
    // Written last: an installation that failed or was killed is repeated.
    let stamp = installed.join(INSTALLED);
    if fs::read(&stamp).is_ok_and(|used| used == wanted) {
        return Ok(installed);
    }
    run()?;
    fs::write(&stamp, wanted).map_err(|error| cannot(INSTALLED, error))?;
    Ok(installed)
}

/// The folder of the packages that npm installs, each with the digest of the lock file.
fn node_modules() -> Result<PathBuf, Failure> {
    let workshop = workshop()?;
    install(&workshop, "node_modules", &["package.json", "package-lock.json", "pages.mjs"], || {
        let options = ["ci", "--no-audit", "--no-fund", "--ignore-scripts", "--loglevel=error"];
        process::check(Command::new("npm").args(options).current_dir(&workshop))
    })
}

/// A program of the virtual environment that pip fills with packages of the digests in `requirements.txt`.
fn python_program(name: &str) -> Result<PathBuf, Failure> {
    let workshop = workshop()?;
    let environment = install(&workshop, "venv", &["requirements.txt"], || {
        let create = ["-m", "venv", "--clear", "venv"];
        process::check(Command::new("python3").args(create).current_dir(&workshop))?;
        let options = ["install", "--quiet", "--disable-pip-version-check", "--require-hashes"];
        let mut pip = Command::new(workshop.join("venv/bin/pip"));
        process::check(pip.args(options).args(["--requirement", "requirements.txt"]).current_dir(&workshop))
    })?;
    Ok(environment.join("bin").join(name))
}

fn node_tool(name: &str) -> Result<Command, Failure> {
    Ok(Command::new(node_modules()?.join(".bin").join(name)))
}

fn all_pages(made: &[Made]) -> impl Iterator<Item = &PathBuf> {
    made.iter().flat_map(|report| &report.pages)
}

fn nu_html_checker(made: &[Made]) -> Result<Vec<Command>, Failure> {
    let mut command = Command::new("java");
    command
        .arg("-jar")
        .arg(node_modules()?.join("vnu-jar/build/dist/vnu.jar"))
        .arg("--errors-only")
        .args(all_pages(made));
    Ok(vec![command])
}

fn html_validate(made: &[Made]) -> Result<Vec<Command>, Failure> {
    let mut command = node_tool("html-validate")?;
    command.arg("--config").arg(definition("html-validate.json")).args(all_pages(made));
    Ok(vec![command])
}

fn pages_in_browser(made: &[Made]) -> Result<Vec<Command>, Failure> {
    node_modules()?;
    let browser = find(BROWSER).unwrap_or_else(|| Path::new("chromium").to_path_buf());
    let mut command = Command::new("node");
    command.arg("pages.mjs").arg(browser).args(all_pages(made)).current_dir(workshop()?);
    Ok(vec![command])
}

fn markdownlint(made: &[Made]) -> Result<Vec<Command>, Failure> {
    // The linter takes patterns below its own folder, not paths.
    let command = |report: &Made| {
        let mut command = node_tool("markdownlint-cli2")?;
        command.arg("--config").arg(definition(".markdownlint.json"));
        command.args(["report.md", "ledger.md"]).current_dir(&report.folder);
        Ok(command)
    };
    made.iter().map(command).collect()
}

fn crate_validator(made: &[Made]) -> Result<Vec<Command>, Failure> {
    let commands = checks_of_archives("validate_crate.py", made)?;
    Ok(commands
        .map(|mut command| {
            command.arg("process-run-crate-0.5");
            command
        })
        .collect())
}

fn codecheck(made: &[Made]) -> Result<Vec<Command>, Failure> {
    Ok(checks_of_archives("validate_codecheck.py", made)?.collect())
}

fn checks_of_archives<'a>(
    script: &'a str,
    made: &'a [Made],
) -> Result<impl Iterator<Item = Command> + 'a, Failure> {
    let python = python_program("python")?;
    Ok(made.iter().map(move |report| {
        let mut command = Command::new(&python);
        command.arg(definition(script)).arg(&report.archive);
        command
    }))
}

/// Random points for each formula of the reports, and wrong verdicts planted in the shortest one.
fn independent_program(_made: &[Made]) -> Result<Vec<Command>, Failure> {
    let root = repository::root();
    let runs = [
        vec!["--points".into(), "100".into(), "--quiet".into()],
        vec!["--points".into(), "5".into(), "--self-test".into(), root.join("reports/rice-ruina-1983")],
    ];
    let python = python_program("python")?;
    let command = |arguments: Vec<PathBuf>| {
        let mut command = Command::new(&python);
        command.arg("-B").arg(root.join("tests/independent")).args(arguments);
        command
    };
    Ok(runs.map(command).into())
}

fn citation(_made: &[Made]) -> Result<Vec<Command>, Failure> {
    let mut command = Command::new(python_program("cffconvert")?);
    command.args(["--validate", "--infile"]).arg(repository::root().join("CITATION.cff"));
    let mut conversion = Command::new(python_program("python")?);
    conversion.arg(definition("validate_metadata.py")).arg(repository::root());
    Ok(vec![command, conversion])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_installation_that_failed_is_repeated_and_one_that_succeeded_is_not() {
        let workshop = std::env::temp_dir().join(format!("slipmode-validate-{}", std::process::id()));
        fs::create_dir_all(workshop.join("venv")).unwrap();
        let mut runs = 0;
        let mut attempt = |result: Result<(), Failure>| {
            install(&workshop, "venv", &["requirements.txt"], || {
                runs += 1;
                result
            })
        };
        assert!(attempt(Err(Failure::check("no network"))).is_err());
        assert!(attempt(Ok(())).is_ok() && attempt(Ok(())).is_ok());
        assert_eq!(runs, 2);
        fs::remove_dir_all(workshop).unwrap();
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
        let read = |name: &str| fs::read_to_string(repository::root().join(name)).unwrap();
        let value = |text: &str, key: &str| -> String {
            let line = text.lines().find_map(|line| line.strip_prefix(key)).unwrap();
            line.trim_matches([' ', '=', '"']).to_string()
        };
        let channel = value(&read("rust-toolchain.toml"), "channel");
        assert_eq!(channel.split('.').count(), 3, "a channel such as `stable` moves");
        assert!(channel.starts_with(&value(&read("Cargo.toml"), "rust-version")));
    }
}
