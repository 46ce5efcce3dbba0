//! The asymptotes' worst errors against b/a: placeholder types until the deviation module lands.
