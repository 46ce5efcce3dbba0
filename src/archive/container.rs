//! The zip container: sorted names, one time, one mode, so that the same files give the same bytes.

use std::io::{Cursor, Write};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use super::Files;

/// The time that an archive states: a whole number of seconds in the years 1980 to 2107, which is what zip can hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ReleaseTime(pub(super) DateTime);

/// Seconds in a day.
const DAY: u64 = 86_400;

/// Days from 1970-01-01 to 1980-01-01, zip's first day.
const FIRST_DAY: u64 = 3_652;

impl ReleaseTime {
    /// The default time: the earliest that zip can store.
    pub const UNSTATED: Self = Self(DateTime::DEFAULT);

    /// From seconds since 1970 (UTC), as `SOURCE_DATE_EPOCH` has them; zip's clock ticks every two seconds, and odd ones are rounded down.
    ///
    /// None outside the years 1980 to 2107.
    pub(crate) fn from_unix(seconds: u64) -> Option<Self> {
        let days = seconds / DAY;
        let (year, month, day) = civil(days.checked_sub(FIRST_DAY)?)?;
        let part = |unit: u64, of: u64| u8::try_from(seconds / unit % of).ok();
        let (hour, minute, second) = (part(3600, 24)?, part(60, 60)?, part(1, 60)? & !1);
        DateTime::from_date_and_time(year, month, day, hour, minute, second).ok().map(Self)
    }

    /// `2026-11-21T06:43:24+00:00`.
    #[must_use]
    pub fn to_rfc3339(self) -> String {
        format!("{}+00:00", self.0.to_string().replace(' ', "T"))
    }
}

/// Year, month and day of a number of days since 1980-01-01; the years up to 2107 hold one exception, 2100, to leap years every fourth.
fn civil(mut days: u64) -> Option<(u16, u8, u8)> {
    for year in 1980..=2107_u16 {
        let leap = year.is_multiple_of(4) && year != 2100;
        let february = if leap { 29 } else { 28 };
        for (month, length) in (1..).zip([31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31]) {
            if days < length {
                return Some((year, month, u8::try_from(days + 1).ok()?));
            }
            days -= length;
        }
    }
    None
}

/// Packs files into a zip container.
///
/// # Errors
/// When the container cannot hold them: more than 4 GiB in one file.
pub fn pack(files: &Files, time: ReleaseTime) -> Result<Vec<u8>, String> {
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .compression_level(Some(6))
        .last_modified_time(time.0)
        .unix_permissions(0o644);
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for (path, bytes) in files {
        writer.start_file(path.as_str(), options).map_err(|error| format!("{path}: {error}"))?;
        writer.write_all(bytes).map_err(|error| format!("{path}: {error}"))?;
    }
    Ok(writer.finish().map_err(|error| error.to_string())?.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_those_of_the_calendar() {
        let rfc = |seconds| ReleaseTime::from_unix(seconds).map(ReleaseTime::to_rfc3339);
        // By `date -u -d @…`.
        assert_eq!(rfc(315_532_800).unwrap(), "1980-01-01T00:00:00+00:00");
        assert_eq!(rfc(951_782_400).unwrap(), "2000-02-29T00:00:00+00:00");
        assert_eq!(rfc(1_795_243_405).unwrap(), "2026-11-21T06:43:24+00:00");
        assert_eq!(rfc(4_107_542_400).unwrap(), "2100-03-01T00:00:00+00:00");
        assert_eq!(rfc(4_354_819_199).unwrap(), "2107-12-31T23:59:58+00:00");
        assert_eq!((rfc(315_532_799), rfc(4_354_819_200), rfc(u64::MAX)), (None, None, None));
        assert_eq!(ReleaseTime::from_unix(315_532_800), Some(ReleaseTime::UNSTATED));
    }
}
