//! `cargo xtask machine`: the tools that the one-time build of GMP, MPFR and MPC needs, found or installed.
//!
//! The bundled libraries are configured and made from source once per machine, which needs a C compiler, `make`, `m4`
//! and `diff`; afterwards they lie in a cache and only the linker is needed.

use std::env;
use std::fs;
use std::process::Command;

use crate::failure::Failure;
use crate::gmp_cache::{self, Surroundings};
use crate::{process, repository};

const INSTRUCTIONS: &str = "\
install what is missing, then run the command again:
  Debian, Ubuntu   apt-get install gcc libc6-dev make m4 diffutils
  Fedora           dnf install gcc make m4 diffutils
  macOS            xcode-select --install   (and, if m4 is still missing: brew install m4)";

/// Finds every tool that the build will need, or installs what is missing as root with apt-get.
///
/// # Errors
/// With exit code 2, naming what is missing and how to install it.
pub fn run() -> Result<(), Failure> {
    let ready = gmp_cache::holds_libraries(&surroundings()?, &locked_version()?);
    if missing_tools(ready).is_empty() {
        let state = if ready { "in the cache" } else { "to be built once (about two minutes of CPU time)" };
        println!("machine: all tools found; GMP, MPFR and MPC {state}");
        return Ok(());
    }
    provide(
        || missing_tools(ready),
        |missing| if can_install() { install_packages(&debian_packages(missing)) } else { Ok(()) },
        |_| INSTRUCTIONS.into(),
    )
}

/// Finds the formatter and the linter, or adds them where rustup manages the toolchain.
///
/// # Errors
/// With exit code 2 when one of them is missing.
pub fn require_rust_components() -> Result<(), Failure> {
    let add = |missing: &[String]| match process::find_program("rustup", &search_path()) {
        Some(_) => process::status(Command::new("rustup").args(["component", "add"]).args(missing)).map(drop),
        None => Ok(()),
    };
    provide(missing_components, add, |still| format!("run `rustup component add {}`", still.join(" ")))
}

/// Installs what is missing, and refuses to go on without it.
fn provide(
    missing: impl Fn() -> Vec<String>,
    install: impl FnOnce(&[String]) -> Result<(), Failure>,
    instructions: impl FnOnce(&[String]) -> String,
) -> Result<(), Failure> {
    let before = missing();
    if before.is_empty() {
        return Ok(());
    }
    println!("machine: missing {}", before.join(", "));
    install(&before)?;
    match missing() {
        none if none.is_empty() => Ok(()),
        still => Err(Failure::bad_input(format!("missing {}; {}", still.join(", "), instructions(&still)))),
    }
}

fn missing_components() -> Vec<String> {
    let works = |subcommand: &str| {
        process::cargo(&[subcommand, "--version"]).output().is_ok_and(|output| output.status.success())
    };
    [("fmt", "rustfmt"), ("clippy", "clippy")]
        .into_iter()
        .filter(|(subcommand, _)| !works(subcommand))
        .map(|(_, component)| component.to_string())
        .collect()
}

fn missing_tools(libraries_ready: bool) -> Vec<String> {
    let compiler = variable("CC").unwrap_or_else(|| "gcc".to_string());
    missing_among(&needed_tools(libraries_ready, &compiler), &search_path())
}

/// `cc` links every Rust program; the rest is needed only while the libraries are still to be built.
fn needed_tools(libraries_ready: bool, compiler: &str) -> Vec<String> {
    let build_only: &[&str] = if libraries_ready { &[] } else { &[compiler, "make", "m4", "diff"] };
    std::iter::once("cc").chain(build_only.iter().copied()).map(str::to_string).collect()
}

fn missing_among(tools: &[String], search_path: &str) -> Vec<String> {
    // CC may hold flags after the program's name.
    let absent = |tool: &&String| {
        let program = tool.split_whitespace().next().unwrap_or_default();
        process::find_program(program, search_path).is_none()
    };
    tools.iter().filter(absent).cloned().collect()
}

fn debian_packages(tools: &[String]) -> Vec<&str> {
    let mut packages = Vec::new();
    for tool in tools {
        match tool.as_str() {
            "cc" | "gcc" => packages.extend(["gcc", "libc6-dev"]),
            "diff" => packages.push("diffutils"),
            other => packages.push(other),
        }
    }
    packages.sort_unstable();
    packages.dedup();
    packages
}

/// Whether this machine lets us install Debian's packages.
pub fn can_install() -> bool {
    is_root() && process::find_program("apt-get", &search_path()).is_some()
}

/// Whether this is continuous integration, where nothing may be skipped.
pub fn is_continuous_integration() -> bool {
    env::var_os("CI").is_some()
}

/// Installs Debian's packages; who needs them looks whether they are there.
///
/// # Errors
/// When apt-get cannot be started.
pub fn install_packages(packages: &[&str]) -> Result<(), Failure> {
    println!("machine: installing {} with apt-get", packages.join(", "));
    // A fresh image has no package lists, or stale ones; and a mirror may fail once.
    for _ in 0..2 {
        if apt_get_install(packages)? == 0 {
            return Ok(());
        }
        process::status(apt_get().arg("update"))?;
    }
    apt_get_install(packages)?;
    Ok(())
}

fn apt_get_install(packages: &[&str]) -> Result<u8, Failure> {
    process::status(apt_get().args(["install", "--yes", "--no-install-recommends"]).args(packages))
}

fn apt_get() -> Command {
    let mut command = Command::new("apt-get");
    command.env("DEBIAN_FRONTEND", "noninteractive").arg("--quiet");
    command
}

/// Whether this program has root's rights.
pub fn is_root() -> bool {
    let id = Command::new("id").arg("-u").output();
    id.is_ok_and(|output| output.stdout.trim_ascii() == b"0")
}

fn locked_version() -> Result<String, Failure> {
    let path = repository::root().join("Cargo.lock");
    let lock =
        fs::read_to_string(&path).map_err(|error| Failure::bad_input(format!("Cargo.lock: {error}")))?;
    let version = gmp_cache::locked_version(&lock);
    version.map(str::to_string).ok_or_else(|| Failure::bad_input("Cargo.lock does not name gmp-mpfr-sys"))
}

fn surroundings() -> Result<Surroundings, Failure> {
    let rustc = variable("RUSTC").unwrap_or_else(|| "rustc".to_string());
    let version = process::output(Command::new(rustc).arg("-vV"))?;
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).unwrap_or_default();
    Ok(Surroundings {
        explicit_cache: variable("GMP_MPFR_SYS_CACHE"),
        xdg_cache_home: variable("XDG_CACHE_HOME"),
        home: variable("HOME"),
        c_compiler: variable("CC"),
        c_flags: variable("CFLAGS"),
        host: host.to_string(),
    })
}

/// The folders in which programs are looked for.
pub fn search_path() -> String {
    variable("PATH").unwrap_or_default()
}

fn variable(name: &str) -> Option<String> {
    env::var_os(name).map(|value| value.to_string_lossy().into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_filled_cache_leaves_only_the_linker_to_ask_for() {
        assert_eq!(needed_tools(true, "gcc"), ["cc"]);
        assert_eq!(needed_tools(false, "clang"), ["cc", "clang", "make", "m4", "diff"]);
    }

    #[test]
    fn every_tool_is_missing_on_an_empty_search_path() {
        let tools = needed_tools(false, "gcc -m64");
        assert_eq!(missing_among(&tools, ""), tools);
    }

    #[test]
    fn tools_map_to_the_packages_that_hold_them() {
        let tools = ["cc", "gcc", "make", "m4", "diff"].map(String::from);
        assert_eq!(debian_packages(&tools), ["diffutils", "gcc", "libc6-dev", "m4", "make"]);
    }
}
