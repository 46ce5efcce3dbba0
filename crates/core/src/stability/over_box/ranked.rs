//! What a search does next: the candidate of the highest rank.

use std::cmp::Ordering;

/// A candidate with its rank, by which candidates are ordered.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ranked<T> {
    pub rank: f64,
    pub of: T,
}

impl<T> PartialEq for Ranked<T> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<T> Eq for Ranked<T> {}

impl<T> PartialOrd for Ranked<T> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<T> Ord for Ranked<T> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.rank.total_cmp(&other.rank)
    }
}
