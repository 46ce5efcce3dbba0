//! The integration tests: what a user of the library and of the command line sees.

mod archive;
mod arguments;
mod bad_points;
mod bad_scenes;
mod boundary;
mod boundary_command;
mod classify;
mod compare;
mod compare_bad;
mod digit_for_digit;
mod full_disk;
mod grid;
mod hard_cases;
mod hard_points;
mod harness;
mod near_transition;
mod outputs;
mod points;
mod readme;
mod reports;
mod roots;
mod sabotage;
mod simulate;
mod simulate_points;
