//! `cargo xtask wheel`: the Python package as a wheel and a source archive in `target/wheels/`.
//!
//! The tools are those of `python/tests/requirements.txt`, installed by pip below `target/wheel/`. With `--test`, the wheel is built
//! with the profile of the other tasks, whose parts it shares; it is then installed where no compiler is found, tested and checked.
//! With `--pages`, the site of `docs/` is made with such a wheel, whose docstrings it shows.

use std::ffi::OsString;

use crate::prelude::*;
use crate::validate::{environment, new_environment, pip};
use crate::{machine, verify};

/// The first use of the package, without the packages that are optional.
pub const FIRST_USE: &str = "import slipmode; s = slipmode.Slider(a='0.004', b='0.006', d_c='10um', k='1e7', m='1000'); \
                         assert s.classify('1MPa', '10um/s').slip_mode == 'stick-slip'";

/// Where wheels and source packages lie.
pub const WHEELS: &str = "target/wheels";

/// Builds the wheel; with `--test`, tests it; with `--pages`, makes the site.
///
/// # Errors
/// With exit code 2 when Python or a tool is missing, 1 when the build or a test fails.
pub fn run(option: &str) -> Result {
    machine::require(&["python3"])?;
    if option == "--test" && machine::is_continuous_integration() {
        // Elsewhere, the tests on older processors are skipped without it.
        machine::require(&["qemu-x86_64"])?;
    }
    machine::run()?;
    let tools = tools()?;
    // An earlier version's wheel would be taken for this one's.
    make_empty(&root().join(WHEELS))?;
    let profile = if option.is_empty() { "dist" } else { verify::profile() };
    let wheel = maturin(&tools, &format!("build --locked --profile {profile}"), &[])?;
    if option == "--pages" {
        install(&tools, &wheel)?;
        return pages(&tools);
    }
    maturin(&tools, "sdist", &[])?;
    if option == "--test" { test(&tools, &wheel) } else { Ok(()) }
}

/// The folder of the tools.
pub fn tools() -> Result<PathBuf> {
    environment(&workshop("tools"), &root().join("python/tests/requirements.txt"))
}

/// Has maturin make a wheel or a source package, which is returned.
pub fn maturin(tools: &Path, words: &str, variables: &[(&str, OsString)]) -> Result<PathBuf> {
    let folder = root().join(WHEELS);
    let before = entries(&folder)?;
    let mut command = program(tools.join("maturin"), words);
    command.arg("--out").arg(&folder).envs(variables.iter().cloned());
    command.current_dir(root().join("python")).check()?;
    let made = entries(&folder)?.into_iter().find(|path| !before.contains(path));
    made.ok_or_else(|| Failure::check("maturin made no new file"))
}

/// Installs a wheel where no compiler is found, and tests and checks it.
pub fn test(tools: &Path, wheel: &Path) -> Result {
    let fresh = new_environment(&workshop("fresh"))?;
    // Without the folders of compilers.
    pip(&fresh).arg(wheel).env("PATH", &fresh).check()?;
    use_first(&fresh).env("PATH", &fresh).check()?;
    install(tools, wheel)?;
    let of_python = |path: &str| root().join("python").join(path);
    let check = |name: &str, words: &str, files: &[PathBuf]| {
        program(tools.join(name), words).args(files).current_dir(workshop("")).check()
    };
    let settings = of_python("pyproject.toml");
    let pytest = "-m pytest --quiet --numprocesses=auto --dist=worksteal --rootdir";
    check("python", pytest, &[of_python(""), "-c".into(), settings.clone(), of_python("tests")])?;
    check("mypy", "--config-file", &[settings.clone(), of_python("examples")])?;
    let allowed = of_python("tests/stubtest_allowed.txt");
    check("stubtest", "slipmode --mypy-config-file", &[settings, "--allowlist".into(), allowed])?;
    pages(tools)?;
    check("twine", "check --strict", &entries(&root().join(WHEELS))?)?;
    if cfg!(target_os = "linux") { check("auditwheel", "show", &[wheel.to_path_buf()]) } else { Ok(()) }
}

/// The first use, in the environment with these programs and in its folder.
pub fn use_first(programs: &Path) -> Command {
    let mut python = program(programs.join("python"), "-c");
    python.arg(FIRST_USE).current_dir(programs.with_file_name(""));
    python
}

/// Installs a wheel beside the tools.
fn install(tools: &Path, wheel: &Path) -> Result {
    pip(tools).args(["--force-reinstall", "--no-deps"]).arg(wheel).check()
}

/// Makes the site of `docs/`. Warnings are errors, such as a link that leads nowhere.
fn pages(tools: &Path) -> Result {
    let mut sphinx = program(tools.join("sphinx-build"), "--quiet --fail-on-warning --fresh-env");
    sphinx.arg(root().join("docs")).arg(workshop("pages")).check()
}

/// A folder for environments.
pub fn workshop(name: &str) -> PathBuf {
    root().join("target/wheel").join(name)
}
