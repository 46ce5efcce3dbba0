//! `cargo xtask sources`: the sources of the program with all packages that it is built from, as one file that builds without a network.
//!
//! The step `sources` of continuous integration then does what the README of an archive says, in an empty folder, with an empty folder of
//! cargo and, where the system allows it, without a network.

use crate::prelude::*;
use crate::{machine, verify};

/// Where the file is made.
const WORKSHOP: &str = "target/sources";

/// The folder in the file.
const NAME: &str = "slipmode-sources";

/// The folders of the program's packages.
const FOLDERS: [&str; 6] =
    ["", "crates/algebra/", "crates/certified/", "crates/core/", "crates/plot/", "crates/theory/"];

/// The packages of the workspace in the file, besides the first.
const MEMBERS: &str = "members = [\"crates/*\"]";

const VENDORED: &str =
    "[source.crates-io]\nreplace-with = \"vendored\"\n\n[source.vendored]\ndirectory = \"vendor\"\n";

/// Writes `target/sources/sources.tar.xz`.
///
/// # Errors
/// When a program is missing or a package cannot be listed or copied.
pub fn run() -> Result {
    let file = make()?;
    let bytes = fs::metadata(&file).map_err(at(&file))?.len();
    println!("{}: {bytes} bytes", file.display());
    Ok(())
}

fn make() -> Result<PathBuf> {
    machine::require(&["tar", "xz"])?;
    let workshop = root().join(WORKSHOP);
    let staging = workshop.join(NAME);
    make_empty(&staging)?;
    let take = |path: &str| copy(&root().join(path), &staging.join(path));
    for folder in FOLDERS {
        let listed = cargo("package --list --allow-dirty").current_dir(root().join(folder)).text()?;
        let paths = listed.lines().map(|line| format!("{folder}{line}"));
        // Cargo itself adds files to a package: those that the repository has are enough.
        paths.filter(|path| root().join(path).is_file()).try_for_each(|path| take(&path))?;
        shorten(&staging.join(format!("{folder}Cargo.toml")))?;
    }
    // Files besides those of the packages.
    ["Cargo.lock", "Dockerfile"].into_iter().try_for_each(take)?;
    // Leaves the packages out of the lock that nothing needs any more, and moves no version.
    cargo("metadata --format-version 1").current_dir(&staging).text()?;
    cargo("vendor --locked --quiet vendor").current_dir(&staging).text()?;
    write(&staging.join(".cargo/config.toml"), VENDORED)?;
    let fixed = "--sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --mode=u+rw,go-w,a+rX";
    let tar = format!("{fixed} --create --xz --file sources.tar.xz {NAME}");
    program("tar", &tar).env("XZ_OPT", "-6 -T1").current_dir(&workshop).check()?;
    Ok(workshop.join("sources.tar.xz"))
}

/// A manifest without what only tests and benchmarks need, and the workspace without the packages that are not here.
fn shorten(manifest: &Path) -> Result {
    const LEFT_OUT: [&str; 4] = ["dev-dependencies", "[bench", "[test", "[example"];
    let text = read(manifest)?;
    let is_kept = |section: &&str| !LEFT_OUT.iter().any(|start| section.starts_with(start));
    let kept = text.trim_end().split("\n[").filter(is_kept).collect::<Vec<_>>().join("\n[");
    let lines = kept.split('\n').map(|line| if line.starts_with("members = ") { MEMBERS } else { line });
    write(manifest, &lines.map(|line| format!("{line}\n")).collect::<String>())
}

/// Archives a report with the sources, builds the program from the archive alone, and has it compute the report again.
///
/// # Errors
/// With exit code 1 when the program does not build, or finds another result.
pub fn try_out() -> Result {
    let is_requested = env::args().any(|word| ["--all", "--record"].contains(&word.as_str()));
    if machine::is_continuous_integration() && !is_requested {
        println!("sources: left out: everything would be compiled once more; `--all` and `--record` run it");
        return Ok(());
    }
    let sources = make()?;
    verify::build()?;
    let place = root().join(WORKSHOP).join("trial");
    make_empty(&place)?;
    let archive = place.join("report.zip");
    let make_archive = "archive reports/rice-ruina-1983 --with-sources";
    verify::slipmode(make_archive).arg(&sources).arg("--output").arg(&archive).check()?;
    program("python3", "-m zipfile -e").arg(&archive).arg(&place).check()?;
    let (way, prefix) = match program("unshare", "--map-root-user --net true").text() {
        Ok(_) => ("without a network", "unshare --map-root-user --net "),
        Err(_) => ("with `--offline` alone: this system does not allow less", ""),
    };
    println!("sources: building {way}");
    let readme = read(&place.join("README.md"))?;
    // The commands of the first block for a shell.
    let steps = readme.split("```sh\n").nth(1).and_then(|rest| rest.split("```").next());
    let steps = steps.ok_or_else(|| Failure::check("the README of the archive has no commands"))?;
    let commands = format!("set -e; {steps}\ncd ..\nprogram/bin/slipmode replay report.zip");
    let mut shell = program("sh", "-c");
    shell.arg(format!("{prefix}sh -c \"$0\"")).arg(commands).current_dir(&place);
    shell.env("CARGO_HOME", place.join("cargo")).env("CARGO_NET_OFFLINE", "true");
    shell.env_remove("CARGO_TARGET_DIR").check()?;
    fs::remove_dir_all(&place).map_err(at(&place))
}
