//! The integration tests: what a user of the library and of the command line sees.

mod boundary;
mod digit_for_digit;
mod hard_cases;
mod hard_points;
mod readme;
mod sabotage;
