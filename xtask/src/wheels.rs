//! `cargo xtask wheels`: what a release publishes for Python, in `target/wheels/`: wheels for old systems and the source package, tested.
//!
//! On Linux, zig compiles GMP, MPFR and MPC and links. It has all versions of glibc, and musl. PyPI has it as `ziglang`. Elsewhere, the
//! compiler of the system builds one wheel.

use std::env::consts::ARCH;

use crate::machine;
use crate::prelude::*;
use crate::validate::{environment, new_environment, pip};
use crate::wheel::{self, WHEELS, maturin, use_first, workshop};

/// A C library: its target of Rust and of zig, the platform that maturin states, and the one that `auditwheel` finds. It finds none
/// for musl where the system has another library.
const C_LIBRARIES: [[&str; 4]; 2] = [
    ["unknown-linux-gnu", "linux-gnu.2.17", "manylinux2014", "manylinux_2_17"],
    ["unknown-linux-musl", "linux-musl", "musllinux_1_2", ""],
];

const BUILD: &str = "build --locked --profile dist";

/// Builds and tests all wheels that this system can build, and the source package.
///
/// # Errors
/// With exit code 2 when a tool is missing, 1 when a build or a test fails.
pub fn run() -> Result {
    machine::require(&["python3", "cc", "make", "m4", "diff"])?;
    let tools = wheel::tools()?;
    make_empty(&root().join(WHEELS))?;
    let wheels = if cfg!(target_os = "linux") {
        let programs = environment(&workshop("zig"), &root().join("python/tests/zig.txt"))?;
        C_LIBRARIES.iter().map(|library| build(&tools, &programs, library)).collect::<Result<Vec<_>>>()?
    } else {
        vec![maturin(&tools, BUILD, &[])?]
    };
    let source = maturin(&tools, "sdist", &[])?;
    wheel::test(&tools, &wheels[0])?;
    // The source package is installed with one command, as on a machine for which no wheel is published.
    let fresh = new_environment(&workshop("source"))?;
    // The dependencies are those of the wheels.
    pip(&fresh).arg(source).env("CARGO_TARGET_DIR", root().join("target")).check()?;
    use_first(&fresh).check()?;
    println!("wheels: all tested; they lie in {WHEELS}");
    Ok(())
}

/// Builds a wheel for a C library with the compiler of `ziglang`, whose programs are given. maturin refuses the wheel if it needs a newer
/// library, or others, than its platform has.
fn build(tools: &Path, programs: &Path, [rust, zig, stated, found]: &[&str; 4]) -> Result<PathBuf> {
    let target = format!("{ARCH}-{rust}");
    if find_program("rustup").is_some() {
        program("rustup", "target add").arg(&target).check()?;
    }
    let place = "import os, ziglang; print(os.path.join(os.path.dirname(ziglang.__file__), 'zig'))";
    let compiler = program(programs.join("python"), "-c").arg(place).text()?;
    let compiler = format!("{} cc -target {ARCH}-{zig}", compiler.trim());
    // maturin looks for the package there.
    let folders = search_path(Some(programs));
    let libraries = workshop("gmp").into_os_string();
    let variables = [("PATH", folders), ("CC", compiler.into()), ("GMP_MPFR_SYS_CACHE", libraries)];
    let words = format!("{BUILD} --zig --target {target} --compatibility {stated}");
    let wheel = maturin(tools, &words, &variables)?;
    if !found.is_empty() {
        let shown = program(tools.join("auditwheel"), "show").arg(&wheel).text()?;
        println!("{shown}");
        let wrong = || Failure::check(format!("{}: needs more than {found}", wheel.display()));
        ensure(shown.contains(&format!("\"{found}_{ARCH}\"")), wrong)?;
    }
    Ok(wheel)
}
