//! The integration tests: what a user of the library and of the command line sees.

// Tests compare with the system's elementary functions.
#![allow(clippy::disallowed_methods)]

mod archive;
mod arguments;
mod bad_archives;
mod bad_inputs;
mod bad_inputs_index;
mod bad_points;
mod bad_scenes;
mod boundary;
mod boundary_command;
mod claim_formulas;
mod claim_guide;
mod claim_limits;
mod claim_motions;
mod claim_names;
mod claims_over_rows;
mod classify;
mod compare;
mod compare_bad;
mod csv_promises;
mod decimal_layouts;
mod digit_for_digit;
mod estimated_errors;
mod explore;
mod full_disk;
mod grid;
mod hard_cases;
mod hard_points;
mod harness;
mod hostile;
mod messages;
mod mutation;
mod mutations;
mod near_transition;
mod new;
mod option_pairs;
mod outputs;
mod planted_faults;
mod points;
mod promises;
mod readme;
mod replay_budget;
mod reports;
mod roots;
mod sabotage;
mod simulate;
mod simulate_points;
mod solve;
mod sweep;
mod sweep_disks;
mod sweep_forgeries;
mod sweep_refusals;
mod sweep_summary;
mod tampering;
