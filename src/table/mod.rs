//! Tables: rows with units in their column names.
