//! The real binary in a folder of its own: write files, run, look at what it said and what it left.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use tempfile::TempDir;

/// The paper's slider without its point of operation.
pub const SLIDER: [&str; 10] = ["-a", "0.004", "-b", "0.006", "-d", "1e-5", "-k", "1e7", "-m", "1000"];

/// The header of a points file.
pub const HEADER: &str = "direct_effect,evolution_effect,critical_slip_distance_m,stiffness_pa_per_m,\
    mass_per_area_kg_per_m2,normal_stress_pa,loading_velocity_m_per_s";

/// The paper's slider at 0.1 MPa and 1 mm/s, as a row below [`HEADER`].
pub const ROW: &str = "0.004,0.006,1e-5,1e7,1000,1e5,1e-3";

/// Whether slow tests run, as `cargo xtask test --slow` says: more repetitions of what quick runs check as well.
pub fn is_slow() -> bool {
    std::env::var_os("SLIPMODE_SLOW").is_some()
}

/// A temporary folder in which the binary runs.
pub struct Workplace {
    folder: TempDir,
}

/// How a run ended.
#[derive(Debug)]
pub struct Ended {
    /// The exit code.
    pub code: i32,
    /// Standard output.
    pub stdout: String,
    /// Standard error.
    pub stderr: String,
}

impl Workplace {
    pub fn new() -> Self {
        Self { folder: TempDir::new().unwrap() }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// A page with what it shows only when it is opened.
    pub fn page(&self, name: &str) -> String {
        let page = self.read(name);
        let (start, rest) = page.split_once("<template id=\"packed\">").expect("a block of pieces");
        let (block, end) = rest.split_once("</template>").expect("the end of the block");
        let list = miniz_oxide::inflate::decompress_to_vec_zlib(&BASE64_STANDARD.decode(block).unwrap());
        let pieces: Vec<String> = serde_json::from_slice(&list.unwrap()).unwrap();
        format!("{start}{}{end}", pieces.concat())
    }

    /// Writes a file, and the folders it lies in.
    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, content).unwrap();
    }

    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// A folder `r` with a report of these equations and claims, whose only chapter is this prose.
    pub fn with_report(equations: &str, claims: &str, prose: &str) -> Self {
        let place = Self::new();
        place.write(
            "r/report.toml",
            "name = \"r\"\ntitle = \"R\"\nscenes = [\"a\"]\n[[chapter]]\nid = \"c\"\ntitle = \"C\"\nprose = \"c.md\"\n",
        );
        place.write("r/claims.toml", claims);
        place.write("r/equations.toml", equations);
        place.write("r/scenes/a.toml", "name = \"a\"\ntitle = \"A\"\n");
        place.write("r/prose/c.md", prose);
        place
    }

    /// The names of everything in the folder, hidden files too, sorted.
    pub fn names(&self) -> Vec<String> {
        names_in(self.folder.path())
    }

    /// Runs the binary.
    pub fn run<'a>(&self, arguments: impl IntoIterator<Item = &'a str>) -> Ended {
        self.run_with_input(arguments, "")
    }

    /// Runs the binary with a text on its standard input.
    pub fn run_with_input<'a>(&self, arguments: impl IntoIterator<Item = &'a str>, input: &str) -> Ended {
        let mut child = Command::new(env!("CARGO_BIN_EXE_slipmode"))
            .args(arguments)
            .current_dir(self.folder.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // A program that refuses its arguments does not read its input.
        let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
        Ended::from(child.wait_with_output().unwrap())
    }
}

/// A value as messages show it: one that is not one plain word stands between quotation marks.
pub fn quoted(value: &str) -> String {
    let is_plain = |character: char| character.is_alphanumeric() || "._-+/^*@%".contains(character);
    let is_one_word = !value.is_empty() && value.chars().all(is_plain);
    if is_one_word { value.to_string() } else { format!("\"{value}\"") }
}

/// The names in a folder, sorted.
pub fn names_in(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

impl From<Output> for Ended {
    fn from(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).unwrap();
        Self { code: output.status.code().unwrap(), stdout: text(output.stdout), stderr: text(output.stderr) }
    }
}

impl Ended {
    /// Standard output of a run that must have succeeded without a word on standard error.
    #[track_caller]
    pub fn expect_success(self) -> String {
        assert_eq!((self.code, self.stderr.as_str()), (0, ""));
        self.stdout
    }

    /// Standard output of a run that must have succeeded with nothing but warnings on standard error.
    #[track_caller]
    pub fn expect_warnings(self) -> String {
        let has_only_warnings = self.stderr.lines().all(|line| line.starts_with("warning: "));
        assert!(self.code == 0 && has_only_warnings, "{}: {}", self.code, self.stderr);
        self.stdout
    }

    /// Checks that the input was refused: exit code 2, nothing on standard output but the errors for who asked for JSON, every part of the
    /// message there.
    #[track_caller]
    pub fn expect_refusal(self, parts: &[&str]) {
        let is_errors = |output: &str| {
            let found: Option<serde_json::Value> = serde_json::from_str(output).ok();
            found.is_some_and(|found| found["schema"] == 1 && found["errors"].is_array())
        };
        assert_eq!(self.code, 2, "{}", self.stderr);
        assert!(self.stdout.is_empty() || is_errors(&self.stdout), "{}", self.stdout);
        for part in parts {
            assert!(self.stderr.contains(part), "{part:?} is not in:\n{}", self.stderr);
        }
        assert!(!self.stderr.contains("panicked"), "{}", self.stderr);
    }
}
