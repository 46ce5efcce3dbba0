//! `SHA256SUMS`: the digest of every other file, in the format of `sha256sum --check`.

use std::collections::BTreeMap;
use std::io::{self, Read};

use sha2::{Digest, Sha256};

use super::Files;
use super::untrusted::shown;

/// The file that lists the digests.
pub const DIGESTS_FILE: &str = "SHA256SUMS";

/// SHA-256 in lower-case hexadecimal.
#[must_use]
pub fn sha256_hex(bytes: &[u8]) -> String {
    finished_hex(Sha256::new_with_prefix(bytes))
}

/// The end of a digest that was computed part by part, in lower-case hexadecimal.
#[must_use]
pub fn finished_hex(digest: Sha256) -> String {
    digest.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Whether a text is a SHA-256 as this program writes it.
pub(crate) fn is_digest(text: &str) -> bool {
    text.len() == 64 && text.bytes().all(|byte| b"0123456789abcdef".contains(&byte))
}

/// Length and SHA-256 of all that a reader gives, in constant memory.
///
/// # Errors
/// When the reader fails.
pub fn sha256_of_reader(mut reader: impl Read) -> io::Result<(u64, String)> {
    let (mut digest, mut bytes, mut buffer) = (Sha256::new(), 0, vec![0; 1 << 16]);
    loop {
        match reader.read(&mut buffer)? {
            0 => return Ok((bytes, finished_hex(digest))),
            count => {
                digest.update(&buffer[..count]);
                bytes += count as u64;
            }
        }
    }
}

/// The text of `SHA256SUMS` for these files.
pub(super) fn list(files: &Files) -> String {
    files.iter().map(|(path, bytes)| format!("{}  {path}\n", sha256_hex(bytes))).collect()
}

/// What disagrees between an archive's files and its `SHA256SUMS`: one line a file, undeclared and missing ones too.
#[must_use]
pub fn digest_faults(files: &Files) -> Vec<String> {
    let listed = files.get(DIGESTS_FILE).ok_or_else(|| format!("{DIGESTS_FILE}: missing"));
    let declared = match listed.and_then(|listed| parse(listed)) {
        Ok(declared) => declared,
        Err(fault) => return vec![fault],
    };
    let fault = |(path, bytes): (&String, &Vec<u8>)| match declared.get(path.as_str()) {
        None => Some(format!("{path}: not declared in {DIGESTS_FILE}")),
        Some(digest) if *digest == sha256_hex(bytes) => None,
        Some(_) => Some(format!("{path}: its SHA-256 is not the declared one")),
    };
    let others = files.iter().filter(|(path, _)| *path != DIGESTS_FILE);
    let mut faults: Vec<String> = others.filter_map(fault).collect();
    let gone = declared.keys().filter(|path| !files.contains_key(**path));
    faults.extend(gone.map(|path| format!("{}: declared in {DIGESTS_FILE}, but missing", shown(path))));
    faults
}

fn parse(listed: &[u8]) -> Result<BTreeMap<&str, &str>, String> {
    let text = std::str::from_utf8(listed).map_err(|_| format!("{DIGESTS_FILE}: is not UTF-8 text"))?;
    let mut declared = BTreeMap::new();
    for (index, line) in text.lines().enumerate() {
        let place = format!("{DIGESTS_FILE}:{}", index + 1);
        let (digest, path) = line
            .split_once("  ")
            .ok_or_else(|| format!("{place}: is not a digest, two spaces and a path"))?;
        if !is_digest(digest) {
            return Err(format!("{place}: does not begin with 64 hexadecimal digits"));
        }
        if declared.insert(path, digest).is_some() {
            return Err(format!("{place}: declares {} for the second time", shown(path)));
        }
    }
    Ok(declared)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sealed() -> Files {
        let mut files = Files::from([("a.txt".into(), b"abc".to_vec()), ("b/c".into(), Vec::new())]);
        let sums = list(&files);
        files.insert(DIGESTS_FILE.into(), sums.into_bytes());
        files
    }

    #[test]
    fn the_digest_is_that_of_the_standard() {
        // FIPS 180-2, appendix B.1.
        assert_eq!(sha256_hex(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        assert!(digest_faults(&sealed()).is_empty());
    }

    #[test]
    fn every_change_of_a_file_is_named() {
        let mut changed = sealed();
        changed.insert("a.txt".into(), b"abd".to_vec());
        assert_eq!(digest_faults(&changed), ["a.txt: its SHA-256 is not the declared one"]);
        let mut moved = sealed();
        let bytes = moved.remove("b/c").unwrap();
        moved.insert("b/d".into(), bytes);
        assert_eq!(
            digest_faults(&moved),
            ["b/d: not declared in SHA256SUMS", "b/c: declared in SHA256SUMS, but missing"]
        );
        let mut doubled = sealed();
        let twice = doubled[DIGESTS_FILE].repeat(2);
        doubled.insert(DIGESTS_FILE.into(), twice);
        assert_eq!(digest_faults(&doubled), ["SHA256SUMS:3: declares a.txt for the second time"]);
        let mut bare = sealed();
        bare.remove(DIGESTS_FILE);
        assert_eq!(digest_faults(&bare), ["SHA256SUMS: missing"]);
    }
}
