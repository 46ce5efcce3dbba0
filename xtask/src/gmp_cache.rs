//! Whether the built GMP, MPFR and MPC lie ready in the cache of `gmp-mpfr-sys`, by that package's own rules.
//!
//! The folder is `GMP_MPFR_SYS_CACHE` (empty or `_` switches the cache off) or `gmp-mpfr-sys` in the user's cache
//! folder; below it `<major>.<minor>/<target>[/CC-<CC>]/<version>[/c-no-tests]`, where a later patch version will do.

use std::path::{Path, PathBuf};

const PACKAGE: &str = "gmp-mpfr-sys";
const FILES: [&str; 6] = ["libgmp.a", "gmp.h", "libmpfr.a", "mpfr.h", "libmpc.a", "mpc.h"];

/// What decides where the cache is: environment variables and the compiler's host triple.
#[derive(Debug, Clone, Default)]
pub struct Surroundings {
    /// `GMP_MPFR_SYS_CACHE`.
    pub explicit_cache: Option<String>,
    /// `XDG_CACHE_HOME`.
    pub xdg_cache_home: Option<String>,
    /// `HOME`.
    pub home: Option<String>,
    /// `CC`, which is part of the path when set.
    pub c_compiler: Option<String>,
    /// `CFLAGS`, a hash of which is part of the path when set.
    pub c_flags: Option<String>,
    /// The host triple, such as `x86_64-unknown-linux-gnu`.
    pub host: String,
}

/// Whether the build of `gmp-mpfr-sys` at this version will find all three libraries ready.
///
/// With `CFLAGS` set the answer is always no: the folder is named by a hash of them, and asking for a tool that turns
/// out not to be needed is better than a build that stops half-way.
pub fn holds_libraries(surroundings: &Surroundings, version: &str) -> bool {
    if surroundings.c_flags.is_some() {
        return false;
    }
    let Some((minor_version, patch)) = split_version(version) else { return false };
    let Some(base) = cache_folder(surroundings) else { return false };
    let mut folder = base.join(&minor_version).join(&surroundings.host);
    if let Some(compiler) = &surroundings.c_compiler {
        folder.push(format!("CC-{compiler}"));
    }
    let Ok(entries) = folder.read_dir() else { return false };
    entries.flatten().any(|entry| {
        let name = entry.file_name();
        split_version(&name.to_string_lossy())
            .is_some_and(|found| found.0 == minor_version && found.1 >= patch)
            && (is_complete(&entry.path()) || is_complete(&entry.path().join("c-no-tests")))
    })
}

/// The version of `gmp-mpfr-sys` that a lock file names.
pub fn locked_version(lock_file: &str) -> Option<&str> {
    let mut lines = lock_file.lines().skip_while(|line| *line != format!("name = \"{PACKAGE}\""));
    lines.next()?;
    lines.next()?.strip_prefix("version = \"")?.strip_suffix('"')
}

fn cache_folder(surroundings: &Surroundings) -> Option<PathBuf> {
    if let Some(explicit) = &surroundings.explicit_cache {
        return (!explicit.is_empty() && explicit != "_").then(|| PathBuf::from(explicit));
    }
    let home = surroundings.home.as_ref().filter(|home| !home.is_empty()).map(PathBuf::from);
    let system = if surroundings.host.contains("apple") {
        home.map(|home| home.join("Library").join("Caches"))
    } else {
        let xdg = surroundings.xdg_cache_home.as_ref().filter(|folder| !folder.is_empty());
        xdg.map(PathBuf::from).or_else(|| home.map(|home| home.join(".cache")))
    };
    system.map(|folder| folder.join(PACKAGE))
}

fn split_version(version: &str) -> Option<(String, u64)> {
    let (minor, patch) = version.rsplit_once('.')?;
    Some((minor.to_string(), patch.parse().ok()?))
}

fn is_complete(folder: &Path) -> bool {
    FILES.iter().all(|file| folder.join(file).is_file())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    const HOST: &str = "x86_64-unknown-linux-gnu";

    fn scratch(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("slipmode-xtask-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    fn fill(folder: &Path) {
        fs::create_dir_all(folder).unwrap();
        for file in FILES {
            fs::write(folder.join(file), "").unwrap();
        }
    }

    fn at(home: &Path) -> Surroundings {
        let home = Some(home.to_string_lossy().into_owned());
        Surroundings { home, host: HOST.to_string(), ..Surroundings::default() }
    }

    #[test]
    fn the_libraries_are_found_where_the_package_puts_them() {
        let home = scratch("found");
        assert!(!holds_libraries(&at(&home), "1.7.1"));
        let folder = home.join(".cache/gmp-mpfr-sys/1.7").join(HOST).join("1.7.3/c-no-tests");
        fill(&folder);
        assert!(holds_libraries(&at(&home), "1.7.1"), "a later patch version will do");
        assert!(!holds_libraries(&at(&home), "1.7.4"), "an earlier one will not");
        assert!(!holds_libraries(&at(&home), "1.8.0"));
        fs::remove_file(folder.join("libmpc.a")).unwrap();
        assert!(!holds_libraries(&at(&home), "1.7.1"), "all three libraries are needed");
        fs::remove_dir_all(home).unwrap();
    }

    #[test]
    fn the_environment_moves_or_switches_off_the_cache() {
        let home = scratch("moved");
        fill(&home.join("elsewhere/1.7").join(HOST).join("1.7.1"));
        let elsewhere = home.join("elsewhere").to_string_lossy().into_owned();
        let moved = Surroundings { explicit_cache: Some(elsewhere), ..at(&home) };
        assert!(holds_libraries(&moved, "1.7.1"));
        assert!(!holds_libraries(&Surroundings { c_flags: Some("-O3".into()), ..moved.clone() }, "1.7.1"));
        assert!(!holds_libraries(&Surroundings { c_compiler: Some("clang".into()), ..moved }, "1.7.1"));
        let off = Surroundings { explicit_cache: Some("_".into()), ..at(&home) };
        assert_eq!(cache_folder(&off), None);
        let xdg = Surroundings { xdg_cache_home: Some("/x".into()), ..at(&home) };
        assert_eq!(cache_folder(&xdg), Some(PathBuf::from("/x/gmp-mpfr-sys")));
        let apple = Surroundings { host: "aarch64-apple-darwin".into(), ..xdg };
        assert_eq!(cache_folder(&apple), Some(home.join("Library/Caches/gmp-mpfr-sys")));
        fs::remove_dir_all(home).unwrap();
    }

    #[test]
    fn the_version_is_read_from_the_lock_file() {
        let lock = "[[package]]\nname = \"gmp-mpfr-sys\"\nversion = \"1.7.1\"\n";
        assert_eq!(locked_version(lock), Some("1.7.1"));
        assert_eq!(locked_version("[[package]]\nname = \"rug\"\nversion = \"1.30.0\"\n"), None);
    }
}
