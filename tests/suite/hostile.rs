//! The hostile suite: every command against outputs that fail, streams that are closed, signals, and kills at system calls.
//!
//! In the end each output holds its old content or its new one, nothing hidden is left, and the same command works again.

#![cfg(target_os = "linux")]

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::Write;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use crate::harness::{HEADER, ROW, Workplace};

const SLIDER: &str = "-a 0.004 -b 0.006 -d 1e-5 -k 1e7 -m 1000";
const PARAMETERS: &str = "[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\ncritical_slip_distance_m = 1e-5\n\
    stiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n";

/// A command, and the exit code that it has when nothing is in its way.
struct Case {
    arguments: String,
    code: i32,
    /// Whether it prints on standard output.
    prints: bool,
    /// Its output file or folder, if it has one; `OUT` stands for it in the arguments.
    output: Option<&'static str>,
}

/// Every command in every form that reads or writes differently.
fn cases() -> Vec<Case> {
    let case = |arguments: &str, code, prints, output| Case {
        arguments: arguments.replace("SLIDER", SLIDER),
        code,
        prints,
        output,
    };
    vec![
        case("classify SLIDER -s 1e5 -v 1e-3", 0, true, None),
        case("classify SLIDER -s 1e5 -v 1e-3 --json", 0, true, None),
        case(
            "classify SLIDER --grid-loading-velocity 1e-5:1e-1:7 --grid-normal-stress 1e3:1e7:9",
            0,
            true,
            None,
        ),
        case("classify --points in.csv", 0, true, None),
        case("classify --points in.csv -o OUT", 0, false, Some("out.csv")),
        case("roots SLIDER -s 1e5 -v 1e-3 --digits 40", 0, true, None),
        case("solve SLIDER -v 1e-3 --for normal-stress --boundary", 0, true, None),
        case("boundary SLIDER --points 20", 0, true, None),
        case("boundary SLIDER --points 20 -o OUT", 0, false, Some("out.csv")),
        case("simulate SLIDER -s 1e5 -v 1e-3 --law slip", 0, true, None),
        case("simulate SLIDER -s 1e5 -v 1e-3 --law slip --trajectory OUT", 0, true, Some("out.csv")),
        case("simulate --points in.csv --law slip -o OUT", 0, false, Some("out.csv")),
        case("tolerance SLIDER", 0, true, None),
        case("compare --runs differs.csv", 1, true, None),
        case("compare --runs differs.csv -o OUT", 1, true, Some("out.csv")),
        case("compare --runs differs.csv --report OUT", 1, true, Some("out")),
        case("explore s.toml -o OUT", 0, true, Some("out.html")),
        case("run s.toml -o OUT", 0, true, Some("out")),
        case("report small -o OUT", 0, true, Some("out")),
        case("verify small -o OUT", 1, true, Some("out")),
        case("verify small --claim S1", 1, true, None),
        case("archive small -o OUT", 0, true, Some("out.zip")),
        case("replay small.zip", 1, true, None),
        case("diff small.json other.json", 1, true, None),
        case("sweep sweep.toml --out OUT", 0, false, Some("out")),
        case("sweep sweep.toml --plan", 0, true, None),
        case("merge blocks", 0, true, None),
        case("merge blocks -o OUT", 0, false, Some("out.csv")),
    ]
}

/// Everything that the commands read; the recorded verdict of the report's claim is a wrong one.
fn workplace() -> Workplace {
    let place = Workplace::new();
    place.write("in.csv", format!("{HEADER}\n{}", format!("{ROW}\n").repeat(40)));
    place.write("differs.csv", format!("{HEADER},peak_velocity_m_per_s\n{ROW},123\n"));
    let scene = format!("name = \"s\"\ntitle = \"S\"\n{PARAMETERS}");
    place.write("s.toml", format!("{scene}[boundary]\npoints = 40\ndigits = 20\n"));
    place.write(
        "sweep.toml",
        format!(
            "{scene}[sweep]\nwork = \"classify\"\nblock_points = 20\n[sweep.grid]\n\
             normal_stress_pa = {{ from = 1e3, to = 1e7, points = 8 }}\n\
             loading_velocity_m_per_s = {{ from = 1e-6, to = 1e-1, points = 8 }}\n"
        ),
    );
    place.write(
        "small/report.toml",
        "name = \"small\"\ntitle = \"Small\"\nscenes = [\"s\"]\n[[chapter]]\nid = \"c\"\ntitle = \"C\"\nprose = \"c.md\"\n",
    );
    place.write("small/scenes/s.toml", format!("{scene}[boundary]\npoints = 3\ndigits = 20\n"));
    place.write("small/prose/c.md", "Words.\n\n[[table:boundary]]\n");
    place.write(
        "small/claims.toml",
        "[[claim]]\nid = \"S1\"\nplace = \"eq 9\"\nwords = \"W\"\nexpected = \"fails\"\n",
    );
    place.write("small/equations.toml", include_str!("../../reports/im-avouac/equations.toml"));
    place.run(["sweep", "sweep.toml", "--out", "blocks"]).expect_success();
    place.run(["archive", "small", "-o", "small.zip"]).expect_warnings();
    place.run(["report", "small", "-o", "first"]).expect_warnings();
    let ledger = place.read("first/ledger.json");
    place.write("other.json", ledger.replace("\"verdict\": \"holds\"", "\"verdict\": \"fails\""));
    place.write("small.json", ledger);
    fs::remove_dir_all(place.path("first")).unwrap();
    place
}

/// Runs of the binary in this suite.
static RUNS: AtomicU64 = AtomicU64::new(0);

fn command(place: &Workplace, arguments: &str) -> Command {
    RUNS.fetch_add(1, Ordering::Relaxed);
    let mut command = Command::new(env!("CARGO_BIN_EXE_slipmode"));
    command.args(arguments.split(' ')).current_dir(place.path("")).stdin(Stdio::null());
    command
}

/// Prints a count past the test harness, which keeps the words of tests that pass to itself.
fn report(what: &str) {
    let _ =
        writeln!(std::io::stderr(), "hostile suite, {what}: {} runs so far", RUNS.load(Ordering::Relaxed));
}

/// The files of a folder tree by their paths, but for those that say when and where a run was.
fn snapshot(place: &Workplace) -> BTreeMap<String, Vec<u8>> {
    fn collect(folder: &Path, prefix: &str, files: &mut BTreeMap<String, Vec<u8>>) {
        for entry in fs::read_dir(folder).unwrap() {
            let entry = entry.unwrap();
            let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if entry.file_type().unwrap().is_dir() {
                collect(&entry.path(), &format!("{name}/"), files);
            } else if !name.ends_with("environment.json") && !name.ends_with(".timings.json") {
                files.insert(name, fs::read(entry.path()).unwrap());
            }
        }
    }
    let mut files = BTreeMap::new();
    collect(&place.path(""), "", &mut files);
    files
}

/// Names of unfinished outputs.
fn hidden(place: &Workplace) -> Vec<String> {
    place.names().into_iter().filter(|name| name.starts_with('.')).collect()
}

/// Removes an output, file or folder, and what an archive writes next to it.
fn clear(place: &Workplace, output: Option<&str>) {
    let Some(output) = output else { return };
    let path = place.path(output);
    let _ = fs::remove_file(&path).or_else(|_| fs::remove_dir_all(&path));
    let _ = fs::remove_file(place.path(&format!("{output}.timings.json")));
}

/// A writing end of a pipe whose reader has gone.
fn closed_pipe() -> Stdio {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    Stdio::from(writer)
}

fn full() -> Stdio {
    Stdio::from(File::options().write(true).open("/dev/full").unwrap())
}

/// Exit code, results and files are the same whatever becomes of standard error, and the exit code whoever reads standard output.
#[test]
fn closed_and_full_streams_change_neither_result_nor_exit_code() {
    let place = workplace();
    for case in cases() {
        let arguments = case.arguments.replace("OUT", case.output.unwrap_or_default());
        let run = |stdout: Stdio, stderr: Stdio| -> (Option<i32>, Vec<u8>, BTreeMap<String, Vec<u8>>) {
            let child = command(&place, &arguments).stdout(stdout).stderr(stderr).spawn().unwrap();
            let ended = child.wait_with_output().unwrap();
            let files = snapshot(&place);
            clear(&place, case.output);
            (ended.status.code(), ended.stdout, files)
        };
        let (code, stdout, files) = run(Stdio::piped(), Stdio::piped());
        assert_eq!((code, !stdout.is_empty()), (Some(case.code), case.prints), "{arguments}");
        let timed = arguments.ends_with("--plan");
        for (what, stderr) in [("closed", closed_pipe()), ("full", full())] {
            let (code, again, other) = run(Stdio::piped(), stderr);
            assert_eq!(code, Some(case.code), "{arguments}, standard error {what}");
            assert!(timed || again == stdout, "{arguments}, standard error {what}");
            assert!(other == files, "{arguments}, standard error {what}");
        }
        let (code, _, other) = run(closed_pipe(), closed_pipe());
        assert_eq!(code, Some(case.code), "{arguments}, nobody reads");
        assert!(other == files, "{arguments}, nobody reads");
        let (code, ..) = run(full(), Stdio::piped());
        assert_eq!(code, Some(if case.prints { 2 } else { case.code }), "{arguments}, standard output full");
        assert_eq!(hidden(&place), [""; 0], "{arguments}");
    }
    report("streams");
}

/// Where no file may grow, and where none may be: exit code 2, the earlier output as it was, nothing left behind.
#[test]
fn full_and_forbidden_places_leave_the_earlier_output() {
    let place = workplace();
    for case in cases() {
        let Some(output) = case.output else { continue };
        let good = case.arguments.replace("OUT", output);
        assert_eq!(command(&place, &good).output().unwrap().status.code(), Some(case.code), "{good}");
        let before = snapshot(&place);
        let limited = Command::new("sh")
            .args(["-c", "trap '' XFSZ; ulimit -f 1; exec \"$0\" \"$@\"", env!("CARGO_BIN_EXE_slipmode")])
            .args(good.split(' '))
            .current_dir(place.path(""))
            .output()
            .unwrap();
        RUNS.fetch_add(1, Ordering::Relaxed);
        let stderr = String::from_utf8_lossy(&limited.stderr).into_owned();
        // A sweep that is done already writes nothing.
        let is_done = good.starts_with("sweep");
        let code = limited.status.code();
        assert!(code == Some(2) || (is_done && code == Some(0)), "{good}: {code:?} {stderr}");
        assert!(is_done || stderr.contains("File too large"), "{good}: {stderr}");
        assert!(snapshot(&place) == before, "{good}: the earlier output moved");
        assert_eq!(hidden(&place), [""; 0], "{good}");
        // Nobody, not even root, writes there.
        let forbidden = case.arguments.replace("OUT", &format!("/proc/{output}"));
        let ended = command(&place, &forbidden).output().unwrap();
        let stderr = String::from_utf8_lossy(&ended.stderr).into_owned();
        assert!(ended.status.code() == Some(2) && stderr.contains("/proc"), "{forbidden}: {stderr}");
        assert!(!stderr.contains(".partial"), "{forbidden}: {stderr}");
        clear(&place, case.output);
    }
    report("places");
}

/// The longest that a process may take to reach a state, as a test build on a busy machine.
const PATIENCE: Duration = Duration::from_secs(60);

/// Waits until something is so.
fn wait_for(what: &str, mut is_so: impl FnMut() -> bool) {
    let start = Instant::now();
    while !is_so() {
        assert!(start.elapsed() < PATIENCE, "{what}");
        std::thread::sleep(Duration::from_millis(2));
    }
}

fn send(signal: &str, child: &Child) {
    let sent = Command::new("kill").args([&format!("-{signal}"), &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
}

/// Starts a program with no signal ignored, whatever the caller of the tests ignores (`nohup` ignores HUP).
const NOTHING_IGNORED: &str = "exec env --default-signal";

/// A command that waits for the end of its standard input with its output begun; `start` is how a shell starts it.
fn begun(place: &Workplace, arguments: &str, start: &str) -> Child {
    let script = format!("{start} \"$0\" \"$@\"");
    let mut child = Command::new("sh")
        .args(["-c", &script, env!("CARGO_BIN_EXE_slipmode")])
        .args(arguments.split(' '))
        .current_dir(place.path(""))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    RUNS.fetch_add(1, Ordering::Relaxed);
    // A period to compare with is an observed value for `compare`, and a column of the output for the others.
    let (column, cell) = if arguments.starts_with("compare") { (",period_s", ",1") } else { ("", "") };
    writeln!(child.stdin.as_mut().unwrap(), "{HEADER}{column}\n{ROW}{cell}").unwrap();
    wait_for(arguments, || !hidden(place).is_empty());
    child
}

fn end_of(mut child: Child) -> ExitStatus {
    drop(child.stdin.take());
    child.wait().unwrap()
}

/// Signals that can be caught remove what is unfinished, and end the process as signals do.
#[test]
fn a_signal_leaves_the_earlier_output_and_nothing_hidden() {
    let place = workplace();
    let kept = "earlier\n";
    for arguments in [
        "classify --points - -o kept.csv",
        "simulate --law slip --points - -o kept.csv",
        "compare --runs - -o kept.csv",
        "compare --runs - --report kept",
    ] {
        for (signal, number) in [("INT", 2), ("TERM", 15), ("HUP", 1), ("ALRM", 14), ("XCPU", 24)] {
            place.write("kept.csv", kept);
            let child = begun(&place, arguments, NOTHING_IGNORED);
            send(signal, &child);
            let mut child = child;
            // `wait` closes the input, at whose end the command would finish its output.
            let input = child.stdin.take();
            let status = child.wait().unwrap();
            drop(input);
            assert_eq!(status.signal(), Some(number), "{arguments}");
            assert_eq!(hidden(&place), [""; 0], "{arguments}, {signal}");
            assert_eq!(place.read("kept.csv"), kept);
            assert!(!place.path("kept").exists());
        }
        // What cannot be caught leaves a hidden file, in the way of nobody.
        let mut child = begun(&place, arguments, NOTHING_IGNORED);
        child.kill().unwrap();
        child.wait().unwrap();
        assert_eq!(hidden(&place).len(), 1, "{arguments}");
        assert_eq!(place.read("kept.csv"), kept);
        let left = hidden(&place);
        let path = place.path(&left[0]);
        fs::remove_file(&path).or_else(|_| fs::remove_dir_all(&path)).unwrap();
    }
    report("signals");
}

/// `nohup` has HUP ignored, and so has the program.
#[test]
fn a_signal_that_the_caller_has_ignored_stays_ignored() {
    let place = workplace();
    let child = begun(&place, "classify --points - -o out.csv", "trap '' HUP; exec");
    send("HUP", &child);
    assert_eq!(end_of(child).code(), Some(0));
    assert_eq!(place.read("out.csv").lines().count(), 2);
}

/// System calls that put bytes and names on a disk.
const CALLS: [&str; 10] =
    ["openat", "write", "fsync", "fchmod", "mkdir", "rename", "renameat2", "unlink", "unlinkat", "rmdir"];

/// Whether system calls can be traced here.
fn can_trace() -> bool {
    let traced = Command::new("strace").args(["-f", "-o", "/dev/null", "true"]).output();
    traced.is_ok_and(|output| output.status.success())
}

/// A command under attack: what it writes, and how an earlier output comes into being.
struct Target {
    arguments: &'static str,
    output: &'static str,
    earlier: Option<&'static str>,
    calls: &'static [&'static str],
}

const TARGETS: [Target; 4] = [
    Target {
        arguments: "classify --points in.csv -o out.csv",
        output: "out.csv",
        earlier: Some("classify --points one.csv -o out.csv"),
        calls: &CALLS,
    },
    Target {
        arguments: "run s.toml -o out",
        output: "out",
        earlier: Some("run t.toml -o out"),
        calls: &CALLS,
    },
    Target { arguments: "sweep sweep.toml --out out", output: "out", earlier: None, calls: &CALLS },
    Target {
        arguments: "archive small -o out.zip",
        output: "out.zip",
        earlier: None,
        calls: &["fsync", "rename"],
    },
];

/// The most calls of a kind that are attacked: the first ones of a long row are all alike.
const MOST_CALLS: usize = 40;

/// What the attacks of one kind came to.
struct Attack<'p> {
    place: &'p Workplace,
    target: &'p Target,
    /// What strace does to the call: `signal=KILL` or `error=EIO`.
    harm: &'static str,
    old: BTreeMap<String, Vec<u8>>,
    new: BTreeMap<String, Vec<u8>>,
}

impl<'p> Attack<'p> {
    fn new(place: &'p Workplace, target: &'p Target, harm: &'static str) -> Self {
        let made = |arguments: &str| {
            let ended = command(place, arguments).output().unwrap();
            assert_eq!(ended.status.code(), Some(0), "{arguments}: {ended:?}");
            of_output(place, target.output)
        };
        clear(place, Some(target.output));
        let new = made(target.arguments);
        clear(place, Some(target.output));
        let old = target.earlier.map(made).unwrap_or_default();
        Self { place, target, harm, old, new }
    }

    /// Attacks each call of a kind in turn; the number of hits.
    fn each(&self, call: &str) -> usize {
        let mut hits = 0;
        for number in 1..=MOST_CALLS {
            self.restore();
            let status = self.run(call, number);
            let what = format!("{} with {} at {call} {number}", self.target.arguments, self.harm);
            self.check(&what);
            if status.code() == Some(0) {
                // No call was hit, or one that changes nothing.
                assert!(of_output(self.place, self.target.output) == self.new, "{what}");
                return hits;
            }
            hits += 1;
            if self.harm != "signal=KILL" {
                assert_eq!(hidden(self.place), [""; 0], "{what}");
            }
        }
        hits
    }

    fn restore(&self) {
        if of_output(self.place, self.target.output) == self.old {
            return;
        }
        clear(self.place, Some(self.target.output));
        if let Some(earlier) = self.target.earlier {
            assert!(command(self.place, earlier).output().unwrap().status.success());
        }
    }

    fn run(&self, call: &str, number: usize) -> ExitStatus {
        RUNS.fetch_add(1, Ordering::Relaxed);
        let (trace, inject) = (format!("trace={call}"), format!("inject={call}:{}:when={number}", self.harm));
        let mut strace = Command::new("strace");
        strace.args(["-f", "-qq", "-o", "/dev/null", "-e", &trace, "-e", &inject]);
        strace.arg(env!("CARGO_BIN_EXE_slipmode")).args(["--threads", "1"]);
        strace
            .args(self.target.arguments.split(' '))
            .current_dir(self.place.path(""))
            .output()
            .unwrap()
            .status
    }

    /// The output is the old or the new one; of a sweep each block is.
    fn check(&self, what: &str) {
        let now = of_output(self.place, self.target.output);
        if self.target.arguments.starts_with("sweep") {
            for (name, content) in now {
                assert!(self.new.get(&name) == Some(&content), "{what}: {name}");
            }
        } else {
            assert!(now == self.old || now == self.new, "{what}: {:?}", now.keys());
        }
    }

    /// The same command, unharmed, does its work next to whatever a kill left behind.
    fn recover(&self) {
        let ended = command(self.place, self.target.arguments).output().unwrap();
        assert!(ended.status.success(), "{}: {ended:?}", self.target.arguments);
        assert!(of_output(self.place, self.target.output) == self.new, "{}", self.target.arguments);
        for name in hidden(self.place) {
            let path = self.place.path(&name);
            fs::remove_file(&path).or_else(|_| fs::remove_dir_all(&path)).unwrap();
        }
    }
}

/// Kills and failures at each system call that writes: old content or new, never half, and the next run works.
#[test]
fn a_kill_or_failure_at_any_system_call_leaves_old_or_new() {
    if !can_trace() {
        report("strace is missing, or may not trace here: no kills at system calls");
        return;
    }
    let place = workplace();
    place.write("one.csv", format!("{HEADER}\n{ROW}\n"));
    place.write("t.toml", place.read("s.toml").replace("points = 40", "points = 4"));
    let (mut kills, mut failures) = (0, 0);
    for target in &TARGETS {
        let attack = Attack::new(&place, target, "signal=KILL");
        kills += target.calls.iter().map(|call| attack.each(call)).sum::<usize>();
        attack.recover();
        let attack = Attack::new(&place, target, "error=EIO");
        let calls = target.calls.iter().filter(|call| ["fsync", "mkdir", "rename"].contains(call));
        failures += calls.map(|call| attack.each(call)).sum::<usize>();
        attack.recover();
    }
    assert!(kills > 50 && failures > 10, "{kills} kills, {failures} failures");
    report(&format!("{kills} kills and {failures} failures at system calls"));
}

/// The files of one output that are not hidden.
fn of_output(place: &Workplace, output: &str) -> BTreeMap<String, Vec<u8>> {
    let mut files = snapshot(place);
    files.retain(|name, _| {
        let is_hidden = name.rsplit('/').next().is_some_and(|name| name.starts_with('.'));
        !is_hidden && (name == output || name.starts_with(&format!("{output}/")))
    });
    files
}
