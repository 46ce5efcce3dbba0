//! `sweep` and `merge` refuse what is not a whole, own block, name it, and lose nothing.

use std::fs;
use std::process::Command;

use crate::harness::Workplace;
use crate::sweep::{BLOCKS, SCENE, block, merged, swept, workplace};

/// Checks that a merge names a block and what is wrong with it, and writes nothing.
#[track_caller]
fn expect_refused_merge(place: &Workplace, parts: &[&str]) {
    place.run(["merge", "blocks", "-o", "out.csv"]).expect_refusal(parts);
    assert!(!place.path("out.csv").exists());
}

#[test]
fn a_damaged_block_is_refused_by_name_and_computed_again() {
    let content = swept().read(&block(5));
    let swapped: String = content.chars().rev().collect();
    let cases = [
        (content[..content.len() - 20].to_string(), "truncated: "),
        (String::new(), "has no valid heading"),
        (content[..40].to_string(), "has no valid heading"),
        (format!("{content}x"), "too long: "),
        (content.replacen("\n", "\r\n", 1), "has no valid heading"),
        (swapped, "has no valid heading"),
        (flipped(&content), "its SHA-256 is not the stated one"),
        (content.replacen("points 100", "points 101", 1), "its SHA-256 is not the stated one"),
    ];
    let place = swept();
    let whole = merged(&place, "blocks");
    for (damaged, reason) in cases {
        place.write(&block(5), &damaged);
        expect_refused_merge(&place, &["block-000000005.csv: ", reason]);
        assert_eq!(
            place.run(["merge", "blocks", "--missing", "--shards", "4"]).expect_success(),
            "1\n",
            "{reason}"
        );
        place.run(["sweep", "s.toml", "--shard", "1/4", "--out", "blocks"]).expect_success();
        assert_eq!(place.read(&block(5)), content, "{reason}");
    }
    assert_eq!(merged(&place, "blocks"), whole);
}

/// The same text with one digit of its last line changed.
fn flipped(content: &str) -> String {
    let at = content.rfind(|c: char| c.is_ascii_digit()).unwrap();
    let other = if &content[at..=at] == "7" { "8" } else { "7" };
    format!("{}{other}{}", &content[..at], &content[at + 1..])
}

#[test]
fn a_block_of_elsewhere_is_refused_by_name_and_never_overwritten() {
    let place = swept();
    let good = place.read(&block(5));
    place.write("other.toml", SCENE.replace("1e7, points", "2e7, points"));
    place.run(["sweep", "other.toml", "--out", "other"]).expect_success();
    let foreign = place.read("other/block-000000005.csv");
    place.write(&block(5), &foreign);
    expect_refused_merge(
        &place,
        &["block-000000005.csv: belongs to another scene", "as in block-000000000.csv"],
    );
    place.run(["merge", "blocks", "--missing"]).expect_refusal(&["block-000000005.csv", "another scene"]);
    place
        .run(["sweep", "s.toml", "--out", "blocks"])
        .expect_refusal(&["block-000000005.csv: belongs to another scene", "choose another folder"]);
    assert_eq!(place.read(&block(5)), foreign);

    let version = good.lines().nth(2).unwrap();
    let (heading, csv) = good.split_once("\nsha256 ").unwrap();
    let csv = csv.split_once("\n\n").unwrap().1;
    let stated = heading.replacen(version, "version 0.0.9 0123", 1) + "\n";
    place.write(&block(5), crate::sweep_forgeries::sealed(&stated, csv));
    expect_refused_merge(&place, &["block-000000005.csv: is of another program version (0.0.9 0123, not "]);
    place.write(&block(5), place.read(&block(4)));
    expect_refused_merge(&place, &["block-000000005.csv: contains block 4: duplicated or renamed"]);
    place.write(&block(5), &good);
    place.write("blocks/block-000000005 (copy).csv", &good);
    expect_refused_merge(&place, &["block-000000005 (copy).csv: is not the name of a block"]);
    fs::remove_file(place.path("blocks/block-000000005 (copy).csv")).unwrap();
    place.write("blocks/block-000000077.csv", &good);
    expect_refused_merge(&place, &["block-000000077.csv: is beyond the 12 blocks"]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_and_a_folder_that_takes_nothing_are_named_and_nothing_is_lost() {
    let place = swept();
    let whole = merged(&place, "blocks");
    for number in 6..BLOCKS {
        fs::remove_file(place.path(&block(number))).unwrap();
    }
    let command = "trap '' XFSZ; ulimit -f 1; exec \"$0\" sweep s.toml --out blocks";
    let output = Command::new("sh")
        .args(["-c", command, env!("CARGO_BIN_EXE_slipmode")])
        .current_dir(place.path(""))
        .output()
        .unwrap();
    crate::harness::Ended::from(output)
        .expect_refusal(&["block-0000000", "cannot be written: File too large"]);
    assert_eq!(
        crate::harness::names_in(&place.path("blocks")).len(),
        6,
        "six blocks as before, nothing half written"
    );
    place
        .run(["sweep", "s.toml", "--out", "/proc/blocks"])
        .expect_refusal(&["/proc/blocks", "cannot be created"]);
    place.run(["sweep", "s.toml", "--out", "s.toml"]).expect_refusal(&["s.toml", "cannot be created"]);
    place.run(["sweep", "s.toml", "--out", "blocks"]).expect_success();
    assert_eq!(merged(&place, "blocks"), whole);
}

#[test]
fn faulty_arguments_are_refused_at_once() {
    let place = workplace();
    place
        .run(["sweep", "s.toml", "--shard", "4/4", "--minutes", "0", "--out", "o"])
        .expect_refusal(&["--shard = 4/4: out of range (allowed: I/N", "--minutes = 0: out of range"]);
    place.write("none.toml", "name = \"n\"\ntitle = \"N\"\n");
    place.run(["sweep", "none.toml", "--out", "o"]).expect_refusal(&["none.toml: sweep: missing"]);
    place.write(
        "many.toml",
        SCENE.replace("block_points = 100", "block_points = 1").replace("points = 37", "points = 999999"),
    );
    place.run(["sweep", "many.toml", "--out", "o"]).expect_refusal(&["30999969 blocks", "block_points"]);
    place.run(["merge", "nowhere"]).expect_refusal(&["nowhere: cannot be read"]);
    place.write("empty/x", "");
    place.run(["merge", "empty"]).expect_refusal(&["empty: has no valid block; run every shard"]);
}
