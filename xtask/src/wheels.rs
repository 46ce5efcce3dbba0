//! `cargo xtask wheels`: what a release publishes for Python, in `target/wheels/`: wheels for old systems and the source package, tested.
//!
//! On Linux, zig compiles GMP, MPFR and MPC and links. It has all versions of glibc, and musl. PyPI has it as `ziglang`. Elsewhere, the
//! compiler of the system builds one wheel.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::failure::Failure;
use crate::repository::root;
use crate::validate::{environment, new_environment, pip};
use crate::wheel::{self, FIRST_USE, WHEELS, maturin, workshop};
use crate::{machine, process};

/// A C library: its target of Rust and of zig, the platform that maturin states, and the one that `auditwheel` finds. It finds none
/// for musl where the system has another library.
const C_LIBRARIES: [[&str; 4]; 2] = [
    ["unknown-linux-gnu", "linux-gnu.2.17", "manylinux2014", "manylinux_2_17"],
    ["unknown-linux-musl", "linux-musl", "musllinux_1_2", ""],
];

/// Builds and tests all wheels that this system can build, and the source package.
///
/// # Errors
/// With exit code 2 when a tool is missing, 1 when a build or a test fails.
pub fn run() -> Result<(), Failure> {
    machine::require(&["python3", "cc", "make", "m4", "diff"])?;
    let tools = wheel::tools()?;
    wheel::remove_wheels();
    let wheels = if cfg!(target_os = "linux") {
        let zig = Zig::new()?;
        C_LIBRARIES.iter().map(|library| zig.build(&tools, library)).collect::<Result<Vec<_>, _>>()?
    } else {
        vec![maturin(&tools, &["build", "--locked", "--profile", "dist"], &[])?]
    };
    let source = maturin(&tools, &["sdist"], &[])?;
    wheel::test(&tools, &wheels[0])?;
    install_source(&source)
}

/// The compiler of `ziglang`.
struct Zig {
    programs: PathBuf,
    zig: String,
}

impl Zig {
    fn new() -> Result<Self, Failure> {
        let programs = environment(&workshop("zig"), &root().join("python/tests/zig.txt"))?;
        let place = "import os, ziglang; print(os.path.join(os.path.dirname(ziglang.__file__), 'zig'))";
        let zig = process::output(Command::new(programs.join("python")).args(["-c", place]))?;
        Ok(Self { programs, zig: zig.trim().to_owned() })
    }

    /// Builds a wheel for a C library. maturin refuses it if it needs a newer one, or other libraries, than its platform has.
    fn build(&self, tools: &Path, [rust, zig, stated, found]: &[&str; 4]) -> Result<PathBuf, Failure> {
        let target = format!("{}-{rust}", env::consts::ARCH);
        if process::find_program("rustup").is_some() {
            process::check(Command::new("rustup").args(["target", "add", &target]).current_dir(root()))?;
        }
        // maturin looks for the package there.
        let folders = process::search_path();
        let folders = std::iter::once(self.programs.clone()).chain(env::split_paths(&folders));
        let search_path =
            env::join_paths(folders).map_err(|error| Failure::bad_input(format!("PATH: {error}")))?;
        let cc = format!("{} cc -target {}-{zig}", self.zig, env::consts::ARCH);
        let libraries = workshop("gmp").into_os_string();
        let variables = [("PATH", search_path), ("CC", cc.into()), ("GMP_MPFR_SYS_CACHE", libraries)];
        let build = ["build", "--locked", "--profile", "dist", "--zig", "--target", &target];
        let wheel = maturin(tools, &[&build[..], &["--compatibility", stated]].concat(), &variables)?;
        if found.is_empty() {
            return Ok(wheel);
        }
        let shown = process::output(Command::new(tools.join("bin/auditwheel")).arg("show").arg(&wheel))?;
        println!("{shown}");
        if shown.contains(&format!("\"{found}_{}\"", env::consts::ARCH)) {
            return Ok(wheel);
        }
        Err(Failure::check(format!("{}: needs more than {found}", wheel.display())))
    }
}

/// Installs the source package with one command, as on a machine for which no wheel is published.
fn install_source(source: &Path) -> Result<(), Failure> {
    let folder = workshop("source");
    new_environment(&folder)?;
    // The dependencies are those of the wheels.
    process::check(pip(&folder).arg(source).env("CARGO_TARGET_DIR", root().join("target")))?;
    process::check(Command::new(folder.join("bin/python")).args(["-c", FIRST_USE]).current_dir(&folder))?;
    println!("wheels: all tested; they lie in {WHEELS}");
    Ok(())
}
