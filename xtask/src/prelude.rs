//! What almost every task uses.

pub use std::collections::{BTreeMap, BTreeSet};
pub use std::env;
pub use std::fs;
pub use std::path::{Path, PathBuf};
pub use std::process::{Command, Stdio};
pub use std::time::Instant;

pub use crate::failure::{Failure, Result, ensure};
pub use crate::process::{Run, cargo, find_program, program, root, search_path};
pub use crate::repository::{at, below, copy, entries, file_name, git, make_empty, once, read, rows, write};
