//! Tables with units in their column names, and figures as data: written as CSV, Markdown and SVG.

pub mod figure;
pub mod table;
