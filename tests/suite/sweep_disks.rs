//! Sweeps on a disk that is really full or really read-only: a clear error, nothing lost, and on with it when there is room.

#![cfg(target_os = "linux")]

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::harness::{Workplace, names_in};
use crate::sweep::{BLOCKS, merged, swept, workplace};

/// A file system in memory, gone with this value.
struct SmallDisk(PathBuf);

impl SmallDisk {
    /// Mounts one of 64 KiB; none where that is not allowed.
    fn mount(place: &Path) -> Option<Self> {
        std::fs::create_dir(place).unwrap();
        let disk = Self(place.to_path_buf());
        mount(&["-t", "tmpfs", "-o", "size=64k", "none", &disk.0.display().to_string()]).then_some(disk)
    }

    fn remount(&self, option: &str) {
        assert!(mount(&["-o", &format!("remount,{option}"), &self.0.display().to_string()]));
    }
}

impl Drop for SmallDisk {
    fn drop(&mut self) {
        // Not mounted when mounting was not allowed.
        let _ = Command::new("umount").arg(&self.0).output();
    }
}

fn mount(arguments: &[&str]) -> bool {
    Command::new("mount").args(arguments).output().is_ok_and(|output| output.status.success())
}

#[test]
fn a_sweep_goes_on_where_a_full_or_read_only_disk_stopped_it() {
    let place = workplace();
    let Some(disk) = SmallDisk::mount(&place.path("blocks")) else {
        eprintln!("skipped: a small disk (mount -t tmpfs) needs the rights of root");
        return;
    };
    let sweep = || place.run(["sweep", "s.toml", "--out", "blocks", "--threads", "1"]);
    sweep().expect_refusal(&["blocks/block-0000000", "No space left on device"]);
    let kept = names_in(&disk.0);
    assert!(!kept.is_empty() && kept.len() < BLOCKS, "{kept:?}");
    let state = place.run(["merge", "blocks", "-o", "out.csv"]);
    assert!(state.code == 1 && state.stderr.contains("blocks are missing"), "{}", state.stderr);

    disk.remount("size=4m,ro");
    sweep().expect_refusal(&["block-0000000", "cannot be created: Read-only file system"]);
    assert_eq!(names_in(&disk.0), kept, "what was there is there");

    disk.remount("rw");
    let contents =
        || -> Vec<String> { kept.iter().map(|name| place.read(&format!("blocks/{name}"))).collect() };
    let before = contents();
    sweep().expect_success();
    assert_eq!(contents(), before);
    assert_eq!(merged(&place, "blocks"), merged(&swept(), "blocks"));
}

#[test]
fn a_merge_onto_a_full_disk_leaves_nothing_and_succeeds_with_room() {
    let place: Workplace = swept();
    let Some(disk) = SmallDisk::mount(&place.path("small")) else {
        eprintln!("skipped: a small disk (mount -t tmpfs) needs the rights of root");
        return;
    };
    let merge = || place.run(["merge", "blocks", "-o", "small/out.csv"]);
    merge().expect_refusal(&["small/out.csv", "No space left on device"]);
    assert!(names_in(&disk.0).is_empty());
    disk.remount("size=4m");
    merge().expect_success();
    assert_eq!(place.read("small/out.csv"), merged(&place, "blocks"));
}
