//! `cargo xtask machine`, and what other tasks need of the machine: tools are found, or installed by root with apt-get or rustup.
//!
//! `xtask/tools.txt` lists the tools. The bundled GMP, MPFR and MPC are made from source once per machine. They lie in a cache
//! afterwards, and only the linker is needed.

use crate::prelude::*;

const TOOLS: &str = include_str!("../tools.txt");

/// Finds every tool that the build will need, or installs what is missing.
///
/// # Errors
/// With exit code 2, naming what is missing and how to install it.
pub fn run() -> Result {
    let lock = read(&root().join("Cargo.lock"))?;
    let is_ready = gmp_cache().is_some_and(|cache| holds_libraries(&cache, &lock));
    require(if is_ready { &["cc"] } else { &["cc", "make", "m4", "diff"] })?;
    let state = if is_ready { "in the cache" } else { "to be built once (about two minutes of CPU time)" };
    println!("machine: all tools found; GMP, MPFR and MPC {state}");
    Ok(())
}

/// Refuses to go on without these tools.
///
/// # Errors
/// With exit code 2, naming what is missing and how to install it.
pub fn require(tools: &[&str]) -> Result {
    let missing = provide(tools)?;
    let (names, packages) = (missing.join(", "), Vec::from_iter(packages(&missing)).join(" "));
    let message =
        || format!("missing {names}; install these packages (their names in Debian and Ubuntu): {packages}");
    ensure(missing.is_empty(), || Failure::bad_input(message()))
}

/// Installs what is missing of these tools where that is possible. Those that are missing still.
///
/// # Errors
/// When an installer cannot be started.
pub fn provide<'a>(tools: &[&'a str]) -> Result<Vec<&'a str>> {
    let before = missing(tools);
    if before.is_empty() {
        return Ok(before);
    }
    println!("machine: missing {}", before.join(", "));
    let (components, packages): (Vec<&str>, Vec<&str>) =
        packages(&before).into_iter().partition(|package| package.starts_with("rustup:"));
    if !components.is_empty() && find_program("rustup").is_some() {
        program("rustup", &format!("component add {}", components.join(" ").replace("rustup:", "")))
            .code()?;
    }
    if !packages.is_empty() && is_root() && find_program("apt-get").is_some() {
        install(&packages.join(" "))?;
    }
    Ok(missing(tools))
}

/// Those of these tools that are not found.
pub fn missing<'a>(tools: &[&'a str]) -> Vec<&'a str> {
    tools.iter().copied().filter(|tool| !is_found(row(tool)[1])).collect()
}

/// A tool, how it is found, and its packages.
fn row(tool: &str) -> [&'static str; 3] {
    rows(TOOLS).find(|[name, _, _]| *name == tool).unwrap_or_default()
}

/// Where the first program is of those that a tool is found by.
pub fn path_of(tool: &str) -> PathBuf {
    row(tool)[1].split(',').find_map(find_program).unwrap_or_default()
}

fn packages(tools: &[&str]) -> BTreeSet<&'static str> {
    tools.iter().flat_map(|tool| row(tool)[2].split(' ')).collect()
}

fn is_found(ways: &str) -> bool {
    ways.split(',').any(|way| match way.split_once(' ') {
        None => find_program(way).is_some(),
        // Its standard input is empty.
        Some((name, words)) => program(name, words).output().is_ok_and(|it| it.status.success()),
    })
}

/// Installs packages of Debian. A fresh image has no package lists, or stale ones; and a mirror may fail once.
fn install(packages: &str) -> Result {
    let apt_get = |words: &str| {
        program("apt-get", &format!("--quiet {words}")).env("DEBIAN_FRONTEND", "noninteractive").code()
    };
    let install = format!("install --yes --no-install-recommends {packages}");
    for _ in 0..2 {
        if apt_get(&install)? == 0 {
            return Ok(());
        }
        apt_get("update")?;
    }
    apt_get(&install).map(drop)
}

/// Whether this is continuous integration, where nothing may be skipped.
pub fn is_continuous_integration() -> bool {
    env::var_os("CI").is_some()
}

/// Whether this program has root's rights.
pub fn is_root() -> bool {
    program("id", "-u").output().is_ok_and(|output| output.stdout.trim_ascii() == b"0")
}

/// Where `gmp-mpfr-sys` keeps what it has built. Flags of the compiler are a part of the path that only it knows.
fn gmp_cache() -> Option<PathBuf> {
    let folder = |name: &str| env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from);
    let of_home = |inner: &str| Some(folder("HOME")?.join(inner).join("gmp-mpfr-sys"));
    let of_system = || match folder("XDG_CACHE_HOME") {
        _ if cfg!(target_os = "macos") => of_home("Library/Caches"),
        Some(cache) => Some(cache.join("gmp-mpfr-sys")),
        None => of_home(".cache"),
    };
    if folder("CFLAGS").is_some() { None } else { folder("GMP_MPFR_SYS_CACHE").or_else(of_system) }
}

/// Whether a cache has the libraries for the version that a lock file names; they are shared by all versions such as 1.7.x.
fn holds_libraries(cache: &Path, lock: &str) -> bool {
    let version = lock.split("name = \"gmp-mpfr-sys\"\nversion = \"").nth(1).unwrap_or_default();
    let version: Vec<&str> = version.split('.').take(2).collect();
    let built = below(&cache.join(version.join("."))).unwrap_or_default();
    ["libgmp.a", "libmpfr.a", "libmpc.a"].iter().all(|name| built.iter().any(|path| path.ends_with(name)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_libraries_are_found_where_the_package_puts_them() {
        let cache = env::temp_dir().join(format!("slipmode-machine-{}", std::process::id()));
        let lock = |version: &str| format!("name = \"gmp-mpfr-sys\"\nversion = \"{version}\"\n");
        assert!(!holds_libraries(&cache, &lock("1.7.1")));
        for name in ["libgmp.a", "libmpfr.a", "libmpc.a"] {
            write(&cache.join("1.7/x86_64-unknown-linux-gnu/1.7.3/c-no-tests").join(name), "").unwrap();
        }
        assert!(holds_libraries(&cache, &lock("1.7.1")) && !holds_libraries(&cache, &lock("1.8.0")));
        std::fs::remove_file(cache.join("1.7/x86_64-unknown-linux-gnu/1.7.3/c-no-tests/libmpc.a")).unwrap();
        assert!(!holds_libraries(&cache, &lock("1.7.1")), "all three libraries are needed");
        std::fs::remove_dir_all(cache).unwrap();
    }

    #[test]
    fn a_tool_is_a_program_one_of_several_or_a_command_that_succeeds() {
        assert!(is_found("cargo") && is_found("no-such-program,cargo") && is_found("cargo --version"));
        assert!(!is_found("no-such-program") && !is_found("cargo no-such-subcommand") && !is_found(""));
    }

    #[test]
    fn every_tool_has_its_packages() {
        let packages = packages(&["cc", "slurmd", "sbatch", "diff"]);
        assert_eq!(Vec::from_iter(packages), ["diffutils", "gcc", "libc6-dev", "slurm-wlm"]);
        assert!(rows(TOOLS).all(|[tool, ..]: [&str; 3]| row(tool).iter().all(|field| !field.is_empty())));
    }
}
