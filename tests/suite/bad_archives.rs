//! Archives that are at fault, through `replay`: each kind is refused by name, in time, and nothing is written.

use std::io::{Cursor, Write};
use std::time::{Duration, Instant};

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use crate::harness::Workplace;

type Writer = ZipWriter<Cursor<Vec<u8>>>;

fn options() -> SimpleFileOptions {
    SimpleFileOptions::default().last_modified_time(zip::DateTime::default()).unix_permissions(0o644)
}

fn packed(build: impl FnOnce(&mut Writer)) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    build(&mut writer);
    writer.finish().unwrap().into_inner()
}

fn add(writer: &mut Writer, path: &str, content: &[u8]) {
    writer.start_file(path, options()).unwrap();
    writer.write_all(content).unwrap();
}

/// Replays a container, which must be refused in time with this among the faults.
fn refuse(container: &[u8], problem: &str) {
    let place = Workplace::new();
    place.write("a.zip", container);
    let start = Instant::now();
    place.run(["replay", "a.zip"]).expect_refusal(&["a.zip: ", problem]);
    assert!(start.elapsed() < Duration::from_secs(20), "{problem}: {:?}", start.elapsed());
    assert_eq!(place.names(), ["a.zip"]);
}

#[test]
fn paths_that_leave_the_folder_and_links_are_refused() {
    for path in ["../evil", "/etc/passwd", "a/../../b", "C:/x", "a/CON"] {
        refuse(&packed(|writer| add(writer, path, b"x")), &format!("{path:?}: a name"));
    }
    refuse(
        &packed(|writer| writer.add_symlink("a", "/etc/passwd", options()).unwrap()),
        "is not a regular file",
    );
}

#[test]
fn a_bomb_and_seventy_thousand_files_are_refused() {
    let bomb = packed(|writer| add(writer, "bomb", &vec![0; 50 << 20]));
    assert!(bomb.len() < 100_000, "{} bytes", bomb.len());
    refuse(&bomb, "unpacks to more than 200 times its packed size");
    let many = packed(|writer| (0..70_000).for_each(|i| add(writer, &format!("f{i}"), b"")));
    refuse(&many, "70000 files; at most 10000 are read");
}

#[test]
fn names_that_meet_are_refused() {
    let cases = packed(|writer| {
        add(writer, "A/b", b"1");
        add(writer, "a/B", b"2");
    });
    refuse(&cases, "A/b: the same as a/B where case is ignored");
    let mut doubled = packed(|writer| {
        add(writer, "aa", b"1");
        add(writer, "ab", b"2");
    });
    let places: Vec<usize> = (0..doubled.len() - 1).filter(|&at| &doubled[at..at + 2] == b"ab").collect();
    places.into_iter().for_each(|at| doubled[at + 1] = b'a');
    refuse(&doubled, "two files have the same name");
}

#[test]
fn damage_is_named() {
    let content: Vec<u8> = (0..2000_u32).map(|i| (i * i % 251) as u8).collect();
    let whole = packed(|writer| add(writer, "a.bin", &content));
    refuse(b"", "is not a complete zip file");
    refuse(&whole[..whole.len() - 30], "is not a complete zip file");
    refuse(&whole[whole.len() / 2..], "a.zip: ");
    let mut wrong_checksum = whole.clone();
    // Bytes 14 to 17 of the local header and 16 to 19 of the directory's entry hold the checksum.
    let directory = (0..whole.len() - 4).rfind(|&at| &whole[at..at + 4] == b"PK\x01\x02").unwrap();
    wrong_checksum[14] ^= 1;
    wrong_checksum[directory + 16] ^= 1;
    refuse(&wrong_checksum, "a.bin");
    let mut encrypted = whole;
    encrypted[6] |= 1;
    encrypted[directory + 8] |= 1;
    refuse(&encrypted, "a.zip: file 1");
}
