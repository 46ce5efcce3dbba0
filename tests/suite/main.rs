//! The integration tests: what a user of the library and of the command line sees.

mod arguments;
mod bad_points;
mod bad_scenes;
mod boundary;
mod classify;
mod hard_cases;
mod hard_points;
mod harness;
mod outputs;
mod points;
mod readme;
mod reports;
mod roots;
mod sabotage;
