//! The precision levels, from the fastest arithmetic to the one that is always right.

use serde::Serialize;

/// Which arithmetic gave an answer; a higher level is slower and decides more.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
pub enum PrecisionLevel {
    /// 64-bit with a forward error bound.
    #[serde(rename = "f64")]
    F64,
    /// Double-double with a forward error bound.
    #[serde(rename = "double-double")]
    DoubleDouble,
    /// Rationals for signs, balls of the needed precision for values.
    #[serde(rename = "exact")]
    Exact,
}

impl PrecisionLevel {
    /// The name in tables and JSON.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::F64 => "f64",
            Self::DoubleDouble => "double-double",
            Self::Exact => "exact",
        }
    }
}
