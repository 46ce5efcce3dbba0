//! What the readers of CSV promise of any bytes: they end, without a panic, and what they accept is the same when it is written and read again.

use std::io::Cursor;

use slipmode::comparison::recording::{LEAST_SAMPLES, Recording};
use slipmode::csv::{Cells, Dialect, Input, Remark, RowReader, RowWork, Work, push_cell, read_recording};
use slipmode::scene::{Faults, Problem};
use slipmode_core::friction::Parameters;
use slipmode_core::number::Rational;

/// Reads the seven numbers of a row and adds nothing.
struct OnlyRead;

impl RowWork for OnlyRead {
    type Input = Parameters<Rational>;
    type Kept = ();

    const APPENDED: &'static [&'static str] = &[];
    const BLOCK_ROWS: usize = 16;
    const BLOCKS_PER_THREAD: usize = 1;

    fn header_faults(&self, _names: &[String]) -> Vec<(String, Problem)> {
        Vec::new()
    }

    fn read(&self, cells: Cells<'_>) -> Result<Self::Input, Faults> {
        cells.parameters()
    }

    fn append(&self, _input: &Self::Input, _out: &mut Vec<u8>) -> Remark {
        Remark::default()
    }
}

/// Points that are accepted are written as rows that are accepted and written the same way.
pub fn points(bytes: &[u8]) {
    match written(bytes) {
        Ok(text) => assert_eq!(written(&text).map(|again| again == text), Ok(true)),
        Err(faults) => assert!(is_told(&faults), "{faults:?}"),
    }
}

/// What the points' rows look like in the output.
fn written(bytes: &[u8]) -> Result<Vec<u8>, Faults> {
    let mut reader = reader(bytes);
    let first = reader.block(1).map_err(|fault| vec![fault])?;
    let header = OnlyRead.read_header("f", first.rows().next(), false)?;
    let work = Work { file: "f".into(), header, command: OnlyRead, keep_going: false };
    let mut text = Vec::new();
    for (index, name) in work.header.names.iter().enumerate() {
        text.extend_from_slice(if index > 0 { b"," } else { b"" });
        push_cell(&mut text, name.as_bytes());
    }
    text.push(b'\n');
    loop {
        let block = reader.block(OnlyRead::BLOCK_ROWS).map_err(|fault| vec![fault])?;
        if block.is_empty() {
            return Ok(text);
        }
        let mut worked = work.block(&block, false);
        if !worked.faults.is_empty() {
            return Err(worked.faults);
        }
        text.append(&mut worked.text);
    }
}

/// A trajectory that is accepted has increasing times and finite values, and is the same with another system's line ends.
pub fn recording(bytes: &[u8]) {
    let read = |bytes: &[u8]| read_recording(reader(bytes), 0.0);
    match read(bytes) {
        Ok(found) => {
            assert_orderly(&found);
            if !bytes.contains(&b'"') && !bytes.contains(&b'\r') {
                let other = String::from_utf8_lossy(bytes).replace('\n', "\r\n");
                assert_eq!(read(other.as_bytes()), Ok(found));
            }
        }
        Err(faults) => assert!(is_told(&faults), "{faults:?}"),
    }
}

fn assert_orderly(found: &Recording) {
    let samples = found.times_s.len();
    assert!(samples >= LEAST_SAMPLES && found.log_velocities.len() == samples);
    assert!(found.stresses_pa.is_empty() || found.stresses_pa.len() == samples);
    assert!(found.times_s.windows(2).all(|pair| pair[0] < pair[1]));
    let all = [&found.times_s, &found.log_velocities, &found.stresses_pa];
    assert!(all.into_iter().flatten().all(|value| value.is_finite()));
}

fn reader(bytes: &[u8]) -> RowReader {
    let reader = Box::new(Cursor::new(bytes.to_vec()));
    RowReader::new(Input { name: "f".into(), reader, size: None }, Dialect::default())
}

fn is_told(faults: &Faults) -> bool {
    !faults.is_empty() && faults.iter().all(|fault| fault.to_string().starts_with("f:"))
}
