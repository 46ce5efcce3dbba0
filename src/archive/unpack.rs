//! Reading a container that may be hostile: everything is bounded while it is read, and every fault is named.

use std::io::{Cursor, Read};

use zip::ZipArchive;
use zip::read::ZipFile;

use super::Files;
use super::container::ReleaseTime;
use super::names::{check_path, meeting};

/// Bounds on what is unpacked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Caps {
    /// Bytes of the container.
    pub container_bytes: u64,
    /// Files.
    pub entries: usize,
    /// Bytes of one file.
    pub file_bytes: u64,
    /// Bytes of all files together.
    pub total_bytes: u64,
    /// Bytes of a file per byte of it in the container.
    pub ratio: u64,
}

impl Default for Caps {
    /// Far above any report's archive, far below what a machine cannot hold.
    fn default() -> Self {
        Self {
            container_bytes: 1 << 28,
            entries: 10_000,
            file_bytes: 1 << 26,
            total_bytes: 1 << 28,
            ratio: 200,
        }
    }
}

/// Unpacks a container, and gives the one time that all its entries state.
///
/// # Errors
/// Every fault found: what is not a zip file, a path that leaves its folder, links, folders, doubled or case-equal names, encryption,
/// a wrong checksum, a cut end, entries that overlap, bytes before or behind, and whatever is beyond the caps.
pub fn unpack(container: &[u8], caps: &Caps) -> Result<(Files, ReleaseTime), Vec<String>> {
    let mut archive = ZipArchive::new(Cursor::new(container))
        .map_err(|error| vec![format!("is not a complete zip file: {error}")])?;
    if archive.len() > caps.entries {
        return Err(vec![format!("{} files; at most {} are read", archive.len(), caps.entries)]);
    }
    let mut faults = shape_faults(&mut archive);
    let mut reader = Reader { caps, files: Files::new(), total: 0, time: None };
    for index in 0..archive.len() {
        match archive.by_index(index) {
            Ok(entry) => reader.read(entry).unwrap_or_else(|fault| faults.push(fault)),
            Err(error) => faults.push(format!("file {}: {error}", index + 1)),
        }
    }
    let meet = |(one, other): (&str, &str)| format!("{one}: the same as {other} where case is ignored");
    faults.extend(meeting(reader.files.keys().map(String::as_str)).into_iter().map(meet));
    match reader.time {
        Some(time) if faults.is_empty() => Ok((reader.files, time)),
        None if faults.is_empty() => Err(vec!["holds no file".into()]),
        _ => Err(faults),
    }
}

/// Faults of the container as a whole.
fn shape_faults(archive: &mut ZipArchive<Cursor<&[u8]>>) -> Vec<String> {
    let overlapping = archive.has_overlapping_entries().unwrap_or(true);
    let found = [
        (archive.has_duplicate_names(), "two files have the same name"),
        (overlapping, "files overlap"),
        (archive.offset() != 0, "has bytes before the first file"),
        (!archive.comment().is_empty(), "it carries a comment"),
    ];
    found.into_iter().filter(|(is_so, _)| *is_so).map(|(_, fault)| fault.to_string()).collect()
}

struct Reader<'c> {
    caps: &'c Caps,
    files: Files,
    total: u64,
    time: Option<ReleaseTime>,
}

impl Reader<'_> {
    fn read(&mut self, mut entry: ZipFile<'_, Cursor<&[u8]>>) -> Result<(), String> {
        let path = std::str::from_utf8(entry.name_raw())
            .map_err(|_| format!("{:?}: is not UTF-8", String::from_utf8_lossy(entry.name_raw())))?
            .to_string();
        let refuse = |why: &str| format!("{path:?}: {why}");
        check_path(&path).map_err(|why| refuse(&why))?;
        let is_special = entry.unix_mode().is_some_and(|mode| mode & 0o170_000 != 0o100_000);
        let (size, Caps { file_bytes, total_bytes, ratio, .. }) = (entry.size(), *self.caps);
        let total = self.total.saturating_add(size);
        let faults = [
            (entry.is_dir() || entry.is_symlink() || is_special, "is not a regular file".into()),
            (entry.encrypted(), "is encrypted".into()),
            (size > file_bytes, format!("{size} bytes; at most {file_bytes} are read of one file")),
            (
                size > ratio.saturating_mul(entry.compressed_size().max(64)),
                format!("unpacks to more than {ratio} times its packed size"),
            ),
            (total > total_bytes, format!("with it the files exceed {total_bytes} bytes")),
        ];
        if let Some((_, why)) = faults.iter().find(|(is_so, _)| *is_so) {
            return Err(refuse(why));
        }
        self.total = total;
        self.note_time(entry.last_modified()).map_err(refuse)?;
        let mut bytes = Vec::new();
        // One byte more than declared shows a file that lies about its size, and never more is unpacked.
        entry.by_ref().take(size + 1).read_to_end(&mut bytes).map_err(|error| format!("{path}: {error}"))?;
        if bytes.len() as u64 != size {
            return Err(refuse("is not as long as it declares"));
        }
        self.files.insert(path, bytes);
        Ok(())
    }

    fn note_time(&mut self, time: Option<zip::DateTime>) -> Result<(), &'static str> {
        let time = time.map(ReleaseTime).ok_or("states no valid time")?;
        let first = *self.time.get_or_insert(time);
        if first == time { Ok(()) } else { Err("states another time than the files before it") }
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use zip::ZipWriter;
    use zip::unstable::write::FileOptionsExt;
    use zip::write::SimpleFileOptions;

    use super::*;
    use crate::archive::pack;

    fn plain() -> SimpleFileOptions {
        SimpleFileOptions::default().last_modified_time(zip::DateTime::default()).unix_permissions(0o644)
    }

    fn packed(build: impl FnOnce(&mut ZipWriter<Cursor<Vec<u8>>>)) -> Vec<u8> {
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        build(&mut writer);
        writer.finish().unwrap().into_inner()
    }

    fn with_file(path: &str, content: &[u8]) -> Vec<u8> {
        packed(|writer| {
            writer.start_file(path, plain()).unwrap();
            writer.write_all(content).unwrap();
        })
    }

    #[track_caller]
    fn assert_refused(container: &[u8], why: &str) {
        let faults = unpack(container, &Caps::default()).unwrap_err().join("\n");
        assert!(faults.contains(why), "{faults}");
    }

    #[test]
    fn paths_links_and_folders_that_could_do_harm_are_refused() {
        for path in ["../evil", "/etc/passwd", "a/../../b", "con.txt"] {
            assert_refused(&with_file(path, b"x"), &format!("{path:?}: a name"));
        }
        assert_refused(
            &packed(|writer| writer.add_symlink("a", "/etc/passwd", plain()).unwrap()),
            "not a regular file",
        );
        assert_refused(&packed(|writer| writer.add_directory("a", plain()).unwrap()), "a name");
        let twice = Files::from([("a/b".into(), b"1".to_vec()), ("A/B".into(), b"2".to_vec())]);
        assert_refused(
            &pack(&twice, ReleaseTime::UNSTATED).unwrap(),
            "A/B: the same as a/b where case is ignored",
        );
    }

    #[test]
    fn a_doubled_name_is_refused() {
        let mut container = with_file("aa", b"1");
        container = packed(|writer| {
            writer.merge_archive(ZipArchive::new(Cursor::new(container)).unwrap()).unwrap();
            writer.start_file("ab", plain()).unwrap();
        });
        // Both in the local header and in the directory.
        let named: Vec<usize> =
            (0..container.len() - 1).filter(|&at| &container[at..at + 2] == b"ab").collect();
        assert_eq!(named.len(), 2);
        named.into_iter().for_each(|at| container[at + 1] = b'a');
        assert_refused(&container, "two files have the same name");
    }

    #[test]
    fn a_bomb_is_not_unpacked() {
        assert_refused(
            &with_file("bomb", &vec![0; 50 << 20]),
            "unpacks to more than 200 times its packed size",
        );
        let caps = Caps { file_bytes: 10, ..Caps::default() };
        assert!(
            unpack(&with_file("a", &[1; 11]), &caps).unwrap_err()[0]
                .contains("at most 10 are read of one file")
        );
        let caps = Caps { total_bytes: 10, ..Caps::default() };
        assert!(unpack(&with_file("a", &[1; 11]), &caps).unwrap_err()[0].contains("exceed 10 bytes"));
        let caps = Caps { entries: 0, ..Caps::default() };
        assert_eq!(unpack(&with_file("a", b"x"), &caps).unwrap_err(), ["1 files; at most 0 are read"]);
    }

    #[test]
    fn damage_is_an_error() {
        let content: Vec<u8> = (0..2000_u32).map(|i| (i * i % 251) as u8).collect();
        let whole = with_file("a.bin", &content);
        assert_refused(&whole[..whole.len() - 30], "is not a complete zip file");
        assert_refused(b"", "is not a complete zip file");
        let mut flipped = whole.clone();
        flipped[100] ^= 4;
        assert_refused(&flipped, "a.bin");
        let mut longer = b"MZ".to_vec();
        longer.extend(&whole);
        assert_refused(&longer, "has bytes before the first file");
        let commented = packed(|writer| writer.set_comment("hello").unwrap());
        assert_refused(&commented, "it carries a comment");
    }

    #[test]
    fn an_encrypted_file_is_refused() {
        let container = packed(|writer| {
            writer.start_file("secret", plain().with_deprecated_encryption(b"key").unwrap()).unwrap();
            writer.write_all(b"x").unwrap();
        });
        assert_refused(&container, "file 1:");
    }

    #[test]
    fn times_that_differ_are_refused() {
        let later = zip::DateTime::from_date_and_time(2020, 1, 1, 0, 0, 0).unwrap();
        let container = packed(|writer| {
            writer.start_file("a", plain()).unwrap();
            writer.start_file("b", plain().last_modified_time(later)).unwrap();
        });
        assert_refused(&container, "\"b\": states another time");
    }
}
