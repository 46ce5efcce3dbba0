//! How values are spread along an axis.

/// How values are spread along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Scale {
    /// Evenly.
    #[default]
    Linear,
    /// By log10; only positive values have a place.
    Log10,
    /// Both signs by log10 of the size, with a linear stretch of one decade's width on either side of zero.
    SignedLog10 {
        /// Size below which the stretch is linear; positive.
        smallest: f64,
    },
}

impl Scale {
    /// The coordinate in which the axis is even; `None` for values without one.
    pub(crate) fn coordinate(self, value: f64) -> Option<f64> {
        let at = match self {
            Self::Linear => value,
            Self::Log10 if value > 0.0 => libm::log10(value),
            Self::Log10 => return None,
            Self::SignedLog10 { smallest } if value.abs() <= smallest => value / smallest,
            Self::SignedLog10 { smallest } => value.signum() * (1.0 + libm::log10(value.abs() / smallest)),
        };
        at.is_finite().then_some(at)
    }

    pub(super) fn value(self, coordinate: f64) -> f64 {
        match self {
            Self::Linear => coordinate,
            Self::Log10 => libm::exp10(coordinate),
            Self::SignedLog10 { smallest } if coordinate.abs() <= 1.0 => coordinate * smallest,
            Self::SignedLog10 { smallest } => {
                coordinate.signum() * smallest * libm::exp10(coordinate.abs() - 1.0)
            }
        }
    }
}
