//! The loops over many points: on all processors with the feature `rayon`, on one without it, with the same results.

#[cfg(feature = "rayon")]
use rayon::prelude::*;

/// Applies a function to every item; the answers are in the order of the items.
#[cfg(feature = "rayon")]
pub(super) fn map<I: Send, T: Send>(items: Vec<I>, apply: impl Fn(I) -> T + Sync + Send) -> Vec<T> {
    items.into_par_iter().map(apply).collect()
}

/// Applies a function to every item; the answers are in the order of the items.
#[cfg(not(feature = "rayon"))]
pub(super) fn map<I, T>(items: Vec<I>, apply: impl Fn(I) -> T) -> Vec<T> {
    items.into_iter().map(apply).collect()
}

/// Folds 0..count in stretches of neighbours, each from a fresh state, and merges what they give in their order.
///
/// `None` as soon as one step is `None`. The stretches depend on the number of processors.
#[cfg(feature = "rayon")]
pub(super) fn fold_in_stretches<S: Send, T: Send>(
    count: u32,
    fresh: impl Fn() -> S + Sync + Send,
    step: impl Fn(S, u32) -> Option<S> + Sync + Send,
    result: impl Fn(S) -> T + Sync + Send,
    merge: impl Fn(T, T) -> T + Sync + Send,
) -> Option<T> {
    (0..count)
        .into_par_iter()
        .try_fold(&fresh, &step)
        .map(|state| state.map(&result))
        .try_reduce(|| result(fresh()), |left, right| Some(merge(left, right)))
}

/// Folds 0..count in one stretch. `None` as soon as one step is `None`.
#[cfg(not(feature = "rayon"))]
pub(super) fn fold_in_stretches<S, T>(
    count: u32,
    fresh: impl Fn() -> S,
    step: impl Fn(S, u32) -> Option<S>,
    result: impl Fn(S) -> T,
    _merge: impl Fn(T, T) -> T,
) -> Option<T> {
    (0..count).try_fold(fresh(), step).map(result)
}
