//! What almost every task uses.

pub use std::collections::{BTreeMap, BTreeSet};
pub use std::env;
pub use std::fs;
pub use std::path::{Path, PathBuf};
pub use std::process::Command;
pub use std::time::Instant;

pub use crate::failure::{Failure, Result, ensure};
pub use crate::process::{Run, cargo, program, root};
pub use crate::repository::{at, below, git, read, rows, write};
