//! `cargo xtask wheel`: the Python package as a wheel and a source archive in `target/wheels/`.
//!
//! The tools are those of `python/tests/requirements.txt`, installed by pip below `target/wheel/`. With `--test`, the wheel is built
//! with the profile of the other tasks, whose parts it shares; it is then installed where no compiler is found, tested and checked.
//! With `--pages`, the site of `docs/` is made with such a wheel, whose docstrings it shows.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::failure::Failure;
use crate::repository::{entries, root};
use crate::validate::{environment, new_environment, pip};
use crate::{machine, process, verify};

/// The first use of the package, without the packages that are optional.
pub const FIRST_USE: &str = "import slipmode; s = slipmode.Slider(a='0.004', b='0.006', d_c='10um', k='1e7', m='1000'); \
                         assert s.classify('1MPa', '10um/s').slip_mode == 'stick-slip'";

/// Where wheels and source packages lie.
pub const WHEELS: &str = "target/wheels";

/// Builds the wheel; with `--test`, tests it; with `--pages`, makes the site.
///
/// # Errors
/// With exit code 2 when Python or a tool is missing, 1 when the build or a test fails.
pub fn run(arguments: &[String]) -> Result<(), Failure> {
    let (is_test, is_site) = (arguments == ["--test"], arguments == ["--pages"]);
    if !is_test && !is_site && !arguments.is_empty() {
        return Err(Failure::bad_input("`wheel` takes `--test`, `--pages` or nothing"));
    }
    machine::require(&["python3"])?;
    if is_test && machine::is_continuous_integration() {
        // Elsewhere, the tests on older processors are skipped without it.
        machine::require(&["qemu-x86_64"])?;
    }
    machine::run()?;
    let tools = tools()?;
    remove_wheels();
    let profile = if is_test || is_site { verify::profile() } else { "dist" };
    let wheel = maturin(&tools, &["build", "--locked", "--profile", profile], &[])?;
    if is_site {
        install(&tools, &wheel)?;
        return pages(&tools);
    }
    maturin(&tools, &["sdist"], &[])?;
    if is_test { test(&tools, &wheel) } else { Ok(()) }
}

/// The environment of the tools.
pub fn tools() -> Result<PathBuf, Failure> {
    let folder = workshop("tools");
    environment(&folder, &root().join("python/tests/requirements.txt"))?;
    Ok(folder)
}

/// An earlier version's wheel would be taken for this one's.
pub fn remove_wheels() {
    let _ = fs::remove_dir_all(root().join(WHEELS));
}

/// Has maturin make a wheel or a source package, which is returned.
pub fn maturin(tools: &Path, arguments: &[&str], variables: &[(&str, OsString)]) -> Result<PathBuf, Failure> {
    let folder = root().join(WHEELS);
    let before = entries(&folder).unwrap_or_default();
    let mut command = Command::new(tools.join("bin/maturin"));
    command.args(arguments).arg("--out").arg(&folder).envs(variables.iter().cloned());
    process::check(command.current_dir(root().join("python")))?;
    let made = entries(&folder)?.into_iter().find(|path| !before.contains(path));
    made.ok_or_else(|| Failure::check("maturin made no new file"))
}

/// Installs a wheel where no compiler is found, and tests and checks it.
pub fn test(tools: &Path, wheel: &Path) -> Result<(), Failure> {
    let fresh = workshop("fresh");
    new_environment(&fresh)?;
    // Without the folders of compilers.
    let search_path = fresh.join("bin");
    process::check(pip(&fresh).arg(wheel).env("PATH", &search_path))?;
    let mut python = Command::new(fresh.join("bin/python"));
    process::check(python.args(["-c", FIRST_USE]).env("PATH", &search_path).current_dir(&fresh))?;
    install(tools, wheel)?;
    let folder = root().join("python");
    let check = |program: &str, arguments: &[&str], files: &[PathBuf]| {
        let mut command = Command::new(tools.join("bin").join(program));
        process::check(command.args(arguments).args(files).current_dir(workshop("")))
    };
    let (settings, allowed) = (folder.join("pyproject.toml"), folder.join("tests/stubtest_allowed.txt"));
    check(
        "python",
        &["-m", "pytest", "--quiet", "--numprocesses=auto", "--dist=worksteal", "--rootdir"],
        &[folder.clone(), "-c".into(), settings.clone(), folder.join("tests")],
    )?;
    check("mypy", &["--config-file"], &[settings.clone(), folder.join("examples")])?;
    check("stubtest", &["slipmode", "--mypy-config-file"], &[settings, "--allowlist".into(), allowed])?;
    pages(tools)?;
    check("twine", &["check", "--strict"], &entries(&root().join(WHEELS))?)?;
    if cfg!(target_os = "linux") { check("auditwheel", &["show"], &[wheel.to_path_buf()]) } else { Ok(()) }
}

/// Installs a wheel beside the tools.
fn install(tools: &Path, wheel: &Path) -> Result<(), Failure> {
    process::check(pip(tools).args(["--force-reinstall", "--no-deps"]).arg(wheel))
}

/// Makes the site of `docs/`. Warnings are errors, such as a link that leads nowhere.
fn pages(tools: &Path) -> Result<(), Failure> {
    let mut sphinx = Command::new(tools.join("bin/sphinx-build"));
    sphinx.args(["--quiet", "--fail-on-warning", "--fresh-env"]).arg(root().join("docs"));
    process::check(sphinx.arg(workshop("pages")))
}

/// A folder for environments.
pub fn workshop(name: &str) -> PathBuf {
    root().join("target/wheel").join(name)
}
