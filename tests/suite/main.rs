//! The integration tests: what a user of the library and of the command line sees.

mod hard_cases;
