//! What a result depends on without being part of it: versions, machine, time. It is written apart and never compared.

use std::collections::BTreeMap;
use std::io::Read;
use std::path::Path;
use std::sync::LazyLock;
use std::time::{Instant, SystemTime, UNIX_EPOCH};

use gmp_mpfr_sys::{gmp, mpc, mpfr};
use slipmode::report::FactView;
use slipmode::scene::MAX_FILE_BYTES;

use crate::cli::input::open_regular;

/// The file of an output folder that holds the environment; it also marks the folder as one of ours.
pub const ENVIRONMENT_FILE: &str = "environment.json";

const FINISHED: &str = "finished, seconds since 1970";
const COMPUTED_IN: &str = "computed in, seconds";

/// Whether the environment of a folder is one that slipmode has written.
pub fn is_in(folder: &Path) -> bool {
    let Ok(file) = open_regular(&folder.join(ENVIRONMENT_FILE)) else { return false };
    let facts: Result<BTreeMap<String, String>, _> = serde_json::from_reader(file.take(MAX_FILE_BYTES));
    let has = |name: &&str| facts.as_ref().is_ok_and(|facts| facts.contains_key(*name));
    ["slipmode", "machine", "threads", FINISHED, COMPUTED_IN].iter().all(has)
}

/// The program, the libraries it computes with and its compiler, each with its version.
pub fn versions() -> [(&'static str, String); 5] {
    let version = |major, minor, patch| format!("{major}.{minor}.{patch}");
    [
        ("slipmode", env!("CARGO_PKG_VERSION").to_string()),
        ("GMP", version(gmp::VERSION, gmp::VERSION_MINOR, gmp::VERSION_PATCHLEVEL)),
        ("MPFR", version(mpfr::VERSION_MAJOR, mpfr::VERSION_MINOR, mpfr::VERSION_PATCHLEVEL)),
        ("MPC", version(mpc::VERSION_MAJOR, mpc::VERSION_MINOR, mpc::VERSION_PATCHLEVEL)),
        ("compiler", env!("SLIPMODE_RUSTC").to_string()),
    ]
}

/// The SHA-256 of the sources of this program.
pub const SOURCE_SHA256: &str = env!("SLIPMODE_SOURCE_SHA256");

/// The versions of the program and of its libraries, and the digest of its sources, one a line.
pub fn long_version() -> &'static str {
    static TEXT: LazyLock<String> = LazyLock::new(|| {
        let [program, others @ ..] = versions();
        let lines = others.iter().map(|(name, version)| format!("{name} {version}\n"));
        format!("{}\n{}sources {SOURCE_SHA256}", program.1, lines.collect::<String>())
    });
    &TEXT
}

/// The environment of one run, from its start.
#[derive(Debug)]
pub struct Environment {
    started: Instant,
}

impl Environment {
    /// Starts the clock.
    pub fn start() -> Self {
        Self { started: Instant::now() }
    }

    /// Versions and machine, as name and value.
    pub fn facts(&self) -> Vec<FactView> {
        let machine = [
            ("machine", format!("{} {}", std::env::consts::OS, std::env::consts::ARCH)),
            ("threads", rayon::current_num_threads().to_string()),
        ];
        let facts = versions().into_iter().chain(machine);
        facts.map(|(name, value)| FactView { name: name.into(), value }).collect()
    }

    /// The facts with the times, as `environment.json`.
    pub fn to_json(&self) -> String {
        let mut facts: BTreeMap<String, String> =
            self.facts().into_iter().map(|fact| (fact.name, fact.value)).collect();
        let since_epoch = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        facts.insert(FINISHED.into(), since_epoch.as_secs().to_string());
        facts.insert(COMPUTED_IN.into(), format!("{:.2}", self.started.elapsed().as_secs_f64()));
        format!("{:#}\n", serde_json::json!(facts))
    }
}
