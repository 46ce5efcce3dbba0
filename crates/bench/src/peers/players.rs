//! The players: slipmode and the other programs, looked for and, where they are C or C++, compiled.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use crate::{process, repository};

/// How a player is started.
#[derive(Debug, Clone, Copy)]
enum Program {
    /// Our own benchmark.
    Ours,
    /// A Python script.
    Python(&'static str),
    /// A PARI/GP script.
    Gp(&'static str),
    /// A C or C++ file and what it links.
    Compiled { compiler: &'static str, source: &'static str, libraries: &'static [&'static str] },
}

/// One player.
#[derive(Debug, Clone)]
pub struct Player {
    /// The program or library.
    pub name: &'static str,
    /// What it says of its version.
    pub version: String,
    /// The beginnings of the works that it does.
    works: &'static [&'static str],
    /// Whether one round has to do.
    pub is_slow: bool,
    program: Program,
}

const fn player(name: &'static str, works: &'static [&'static str], program: Program) -> Player {
    Player { name, version: String::new(), works, is_slow: false, program }
}

const fn compiled(
    compiler: &'static str,
    source: &'static str,
    libraries: &'static [&'static str],
) -> Program {
    Program::Compiled { compiler, source, libraries }
}

fn all() -> [Player; 10] {
    let roots = &["roots"];
    [
        player(
            "slipmode",
            &["classes", "roots", "boundary", "hard-cases", "cycles", "smooth", "sweep"],
            Program::Ours,
        ),
        player("NumPy", &["classes"], Program::Python("numpy_classes.py")),
        player("GSL", &["classes"], compiled("cc", "gsl_classes.c", &["gsl", "gslcblas", "m"])),
        player("FLINT", &["roots", "boundary"], Program::Python("flint_roots.py")),
        player("PARI/GP", roots, Program::Gp("pari_roots.gp")),
        player("MPSolve", roots, compiled("cc", "mpsolve_roots.c", &["mps", "gmp", "m"])),
        // Ten thousand digits take minutes.
        player("mpmath", &["roots-50-", "roots-100-", "roots-1000-"], Program::Python("mpmath_roots.py")),
        player(
            "CVODE",
            &["cycles"],
            compiled("cc", "cvode_cycles.c", &["sundials_cvode", "sundials_nvecserial", "m"]),
        ),
        player("boost.odeint", &["cycles", "sweep"], compiled("c++", "rosenbrock4.cpp", &[])),
        player("heyoka", &["smooth"], Program::Python("heyoka_smooth.py")),
    ]
}

fn scipy() -> Player {
    Player { is_slow: true, ..player("SciPy", &["cycles"], Program::Python("scipy_cycles.py")) }
}

/// Where inputs and compiled players lie.
pub fn folder() -> PathBuf {
    repository::root().join("target").join("peers")
}

/// The players that are wanted and there; the others are skipped, by name.
///
/// # Errors
/// When a folder cannot be made.
pub fn find(wanted: impl Fn(&Player) -> bool) -> Result<Vec<Player>, String> {
    fs::create_dir_all(folder()).map_err(|error| format!("target/peers: {error}"))?;
    let mut found = Vec::new();
    for mut player in all().into_iter().chain([scipy()]).filter(|player| wanted(player)) {
        match player.look() {
            Ok(version) => {
                println!("peer {}: {version}", player.name);
                player.version = version;
                found.push(player);
            }
            Err(reason) => println!("peer {} skipped: {reason}", player.name),
        }
    }
    Ok(found)
}

impl Player {
    /// Whether it does this work.
    pub fn does(&self, work: &str) -> bool {
        self.works.iter().any(|beginning| work.starts_with(beginning))
    }

    /// The command that does a piece of work, in the repository's root, on one thread.
    pub fn command(&self, work: &str) -> Command {
        let mut command = match self.program {
            Program::Ours => process::cargo(&[
                "bench",
                "--quiet",
                "--locked",
                "-p",
                "slipmode-bench",
                "--bench",
                "peers",
                "--",
                "play",
            ]),
            Program::Python(script) => program("python3", &[&path_of(script)]),
            Program::Gp(script) => program("gp", &["-q", "-f", "-s", "1000000000", &path_of(script)]),
            Program::Compiled { source, .. } => program(&executable(source), &[]),
        };
        if let Program::Gp(_) = self.program {
            command.env("PEERS_WORK", work).env("PEERS_FOLDER", "target/peers/inputs").stdin(Stdio::null());
        } else {
            command.args([work, "target/peers/inputs"]);
        }
        for variable in ["RAYON_NUM_THREADS", "OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"] {
            command.env(variable, "1");
        }
        command.env("PYTHONDONTWRITEBYTECODE", "1");
        command
    }

    /// Its version, after compiling it where that is needed; or why it cannot play.
    fn look(&self) -> Result<String, String> {
        let mut command = match self.program {
            Program::Ours => return Ok(env!("CARGO_PKG_VERSION").to_string()),
            Program::Python(script) => program("python3", &[&path_of(script), "version"]),
            Program::Gp(_) => program("gp", &["--version-short"]),
            Program::Compiled { compiler, source, libraries } => {
                compile(compiler, source, libraries)?;
                program(&executable(source), &[])
            }
        };
        command.env("PYTHONDONTWRITEBYTECODE", "1");
        match command.stderr(Stdio::null()).output() {
            Ok(done) if done.status.success() => Ok(String::from_utf8_lossy(&done.stdout).trim().to_string()),
            Ok(_) => Err("not installed for the python3 on the search path".to_string()),
            Err(error) => Err(format!("{}: {error}", command.get_program().to_string_lossy())),
        }
    }
}

fn compile(compiler: &str, source: &str, libraries: &[&str]) -> Result<(), String> {
    let output = executable(source);
    let mut command =
        program(compiler, &["-O3", "-DNDEBUG", "-march=native", "-w", "-o", &output, &path_of(source)]);
    command.args(libraries.iter().map(|library| format!("-l{library}")));
    match command.stderr(Stdio::null()).status() {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(format!("{compiler} cannot compile {} (headers or library absent)", path_of(source))),
        Err(error) => Err(format!("{compiler}: {error}")),
    }
}

fn program(name: &str, arguments: &[&str]) -> Command {
    let mut command = Command::new(name);
    command.args(arguments).current_dir(repository::root());
    command
}

fn path_of(script: &str) -> String {
    format!("crates/bench/benches/peers/{script}")
}

fn executable(source: &str) -> String {
    format!("target/peers/{}", source.split('.').next().unwrap_or(source))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_players_script_is_there_and_every_work_has_a_player_beside_ours() {
        for player in all().into_iter().chain([scipy()]) {
            let script = match player.program {
                Program::Ours => "main.rs",
                Program::Python(script) | Program::Gp(script) => script,
                Program::Compiled { source, .. } => source,
            };
            assert!(repository::root().join(path_of(script)).is_file(), "{script}");
        }
        // The textbook methods beside ours in the suite of hard cases are this repository's own.
        for work in super::super::WORKS.into_iter().filter(|work| *work != "hard-cases") {
            assert!(all().iter().filter(|player| player.does(work)).count() >= 2, "{work}");
        }
    }

    #[test]
    fn what_cannot_be_compiled_is_a_reason_and_no_failure() {
        assert!(compile("cc", "no-such-file.c", &[]).is_err());
        assert!(compile("no-such-compiler", "gsl_classes.c", &[]).is_err());
    }
}
