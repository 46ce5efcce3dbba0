//! Tables with units in their column names, and figures as data: written as CSV, Markdown and SVG.
//!
//! ```
//! use slipmode_plot::table::{Cell, Column, Table};
//!
//! let columns = vec![Column::text("law", "Law"), Column::number("period_s", "Period", "s")];
//! let mut table = Table::new("periods", "Periods by law", columns);
//! table.push(vec![Cell::text("aging"), Cell::number("12.5")]);
//! assert_eq!(table.to_csv(), "law,period_s\naging,12.5\n");
//! assert!(table.to_markdown().contains("| aging | 12.5 |"));
//! ```

pub mod figure;
pub mod table;
