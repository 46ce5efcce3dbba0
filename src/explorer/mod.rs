//! The explorer page of one slider: a family of sliders with b, K and M changed, as curves, formulas and words.

pub(crate) mod families;
pub(crate) mod formulas;
pub(crate) mod live;
pub(crate) mod points;
pub(crate) mod tables;
pub(crate) mod view;

pub use families::{Factors, Families, NamedPoint, PointState};
pub use live::{LiveControl, LiveMap, LiveMode, live_map};
pub use points::points;
pub use view::{Control, Explorer, FormulaRow, PointRow, Varying, Window, explorer};
