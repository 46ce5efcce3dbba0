//! The players: slipmode and the other programs, looked for and, where they are C or C++, compiled.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use crate::{process, repository};

/// How a player is started.
#[derive(Debug, Clone, Copy)]
enum Program {
    /// This package's benchmark; the text follows the work's name.
    Bench(&'static str),
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

fn all() -> [Player; 14] {
    let roots = &["roots"];
    let points = &["signs", "extremes", "cubic"];
    [
        player(
            "slipmode",
            &[
                "signs",
                "extremes",
                "cubic",
                "roots",
                "boundary",
                "hard-cases",
                "cycles",
                "smooth",
                "throughput",
                "sweep",
            ],
            Program::Bench(""),
        ),
        player("NumPy", points, Program::Python("numpy_classes.py")),
        player("GSL", points, compiled("cc", "gsl_classes.c", &["gsl", "gslcblas", "m"])),
        player(
            "FLINT",
            &["roots", "boundary"],
            compiled("cc", "flint_roots.c", &["flint-arb", "flint", "m"]),
        ),
        player("python-flint", &["roots", "boundary"], Program::Python("flint_roots.py")),
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
        player("static Rosenbrock", &["cycles", "sweep"], compiled("c++", "static_rosenbrock.cpp", &[])),
        player(DIFFERENTIAL_EQUATIONS, &["cycles"], Program::Bench("-differential-equations")),
        player("heyoka", &["smooth", "throughput"], Program::Python("heyoka_smooth.py")),
        Player { is_slow: true, ..player("SciPy", &["cycles"], Program::Python("scipy_cycles.py")) },
    ]
}

/// The crate that is linked into this package's benchmark.
const DIFFERENTIAL_EQUATIONS: &str = "differential-equations";

/// The version of a crate in the lock file.
fn locked_version(name: &str) -> Result<String, String> {
    let path = repository::root().join("Cargo.lock");
    let lock = fs::read_to_string(path).map_err(|error| format!("Cargo.lock: {error}"))?;
    let package = format!("name = \"{name}\"\nversion = \"");
    let version = lock.split_once(&package).and_then(|(_, rest)| rest.split('"').next());
    version.map(str::to_string).ok_or_else(|| format!("Cargo.lock has no {name}"))
}

/// The players that are there, and the others with the reason why they are not.
#[derive(Debug, Default)]
pub struct AvailablePlayers {
    /// Those that play.
    pub players: Vec<Player>,
    /// Name and reason of those that are skipped.
    pub skipped: Vec<(&'static str, String)>,
}

/// Where inputs and compiled players lie.
pub fn folder() -> PathBuf {
    repository::root().join("target").join("peers")
}

/// The players that are wanted and there; the others are skipped, by name.
///
/// # Errors
/// When a folder cannot be made.
pub fn find(wanted: impl Fn(&Player) -> bool) -> Result<AvailablePlayers, String> {
    fs::create_dir_all(folder()).map_err(|error| format!("target/peers: {error}"))?;
    let mut found = AvailablePlayers::default();
    for mut player in all().into_iter().filter(|player| wanted(player)) {
        match player.look() {
            Ok(version) => {
                println!("peer {}: {version}", player.name);
                player.version = version;
                found.players.push(player);
            }
            Err(reason) => {
                println!("peer {} skipped: {reason}", player.name);
                found.skipped.push((player.name, reason));
            }
        }
    }
    Ok(found)
}

impl Player {
    /// Whether it does this work.
    pub fn does(&self, work: &str) -> bool {
        self.works.iter().any(|beginning| work.starts_with(beginning))
    }

    /// What the program says of itself, with its name in front where that is missing.
    pub fn program_and_version(&self) -> String {
        let is_named = self.version.starts_with(|first: char| first.is_alphabetic());
        if is_named { self.version.clone() } else { format!("{} {}", self.name, self.version) }
    }

    /// The command that does a piece of work, in the repository's root, on one thread.
    pub fn command(&self, work: &str) -> Command {
        let mut command = match self.program {
            Program::Bench(_) => {
                process::cargo("bench --quiet --locked -p slipmode-bench --bench peers -- play")
            }
            Program::Python(script) => program("python3", &[&path_of(script)]),
            Program::Gp(script) => program("gp", &["-q", "-f", "-s", "1000000000", &path_of(script)]),
            Program::Compiled { source, .. } => program(&executable(source), &[]),
        };
        match self.program {
            Program::Gp(_) => {
                let folder = ("PEERS_FOLDER", "target/peers/inputs");
                command.envs([("PEERS_WORK", work), folder]).stdin(Stdio::null());
            }
            Program::Bench(suffix) => {
                command.args([&format!("{work}{suffix}"), "target/peers/inputs"]);
            }
            Program::Python(_) | Program::Compiled { .. } => {
                command.args([work, "target/peers/inputs"]);
            }
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
            Program::Bench("") => return Ok(env!("CARGO_PKG_VERSION").to_string()),
            Program::Bench(_) => return locked_version(self.name),
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
    let mut command = program(
        compiler,
        &["-O3", "-DNDEBUG", "-march=native", "-fno-math-errno", "-w", "-o", &output, &path_of(source)],
    );
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
        for player in all() {
            let script = match player.program {
                Program::Bench(_) => "main.rs",
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
    fn a_program_is_named_with_its_version() {
        let program = |version: &str| {
            Player { version: version.into(), ..player("PARI/GP", &[], Program::Bench("")) }
                .program_and_version()
        };
        assert_eq!((program("2.15.2"), program("GSL 2.7")), ("PARI/GP 2.15.2".into(), "GSL 2.7".into()));
        assert!(locked_version(DIFFERENTIAL_EQUATIONS).unwrap().split('.').count() == 3);
        assert!(locked_version("no-such-crate").is_err());
    }

    #[test]
    fn what_cannot_be_compiled_is_a_reason_and_no_failure() {
        assert!(compile("cc", "no-such-file.c", &[]).is_err());
        assert!(compile("no-such-compiler", "gsl_classes.c", &[]).is_err());
    }
}
