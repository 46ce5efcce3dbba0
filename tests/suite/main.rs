//! The integration tests: what a user of the library and of the command line sees.

mod boundary;
mod hard_cases;
mod hard_points;
mod readme;
