//! The container has one form: packed again, the same files must give the same bytes.

use super::Files;
use super::container::{ReleaseTime, pack};

/// The first byte in which a container differs from what this version of the program packs from its files; none when it is the same.
///
/// Checksums and digests cover the files; this covers what is between them, such as a mode or a time in the directory.
pub(crate) fn container_fault(container: &[u8], files: &Files, time: ReleaseTime) -> Option<String> {
    let difference = |packed: Vec<u8>| {
        let same = packed.iter().zip(container).take_while(|(one, other)| one == other).count();
        let fault = format!("the container differs from what its files pack to, from byte {same} on");
        (packed != container).then_some(fault)
    };
    pack(files, time).map_or_else(Some, difference)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::archive::{Caps, unpack};

    fn files() -> Files {
        Files::from([
            ("a/b.txt".into(), b"abc".repeat(40)),
            ("c".into(), Vec::new()),
            ("d.csv".into(), b"1,2\n".to_vec()),
        ])
    }

    #[test]
    fn what_is_packed_unpacks_to_the_same_files_and_time() {
        let time = ReleaseTime::from_unix(1_795_243_404).unwrap();
        let container = pack(&files(), time).unwrap();
        let (unpacked, found) = unpack(&container, &Caps::default()).unwrap();
        assert_eq!((unpacked, found), (files(), time));
        assert_eq!(container_fault(&container, &files(), time), None);
    }

    proptest! {
        #[test]
        fn no_flipped_bit_goes_unnoticed(place: prop::sample::Index, bit in 0..8_u32) {
            let mut container = pack(&files(), ReleaseTime::UNSTATED).unwrap();
            let place = place.index(container.len());
            container[place] ^= 1 << bit;
            let noticed = match unpack(&container, &Caps::default()) {
                Err(faults) => !faults.is_empty(),
                Ok((unpacked, time)) => {
                    unpacked != files() || container_fault(&container, &unpacked, time).is_some()
                }
            };
            prop_assert!(noticed, "byte {place}");
        }

        #[test]
        fn no_bytes_make_the_reader_panic(bytes: Vec<u8>) {
            prop_assert!(unpack(&bytes, &Caps::default()).is_err());
        }
    }
}
