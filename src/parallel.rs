//! Work on all processors: the answers come in the order of the items.

use std::sync::Mutex;

use rayon::prelude::*;

/// Applies a function to every item.
#[must_use]
pub fn map<T: Sync, R: Send>(items: &[T], apply: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let places: Vec<Mutex<Option<R>>> = items.iter().map(|_| Mutex::new(None)).collect();
    each(items.len(), &|index| {
        let answer = apply(&items[index]);
        // No thread leaves a place in the middle of writing it.
        if let Ok(mut place) = places[index].lock() {
            *place = Some(answer);
        }
    });
    places.into_iter().filter_map(|place| place.into_inner().ok().flatten()).collect()
}

/// Applies a function to every item, and joins what it gives.
#[must_use]
pub fn flat_map<T: Sync, R: IntoIterator + Send>(
    items: &[T],
    apply: impl Fn(&T) -> R + Sync,
) -> Vec<R::Item> {
    map(items, apply).into_iter().flatten().collect()
}

/// One loop over processors for all functions: a loop for each was a fifteenth of what the compiler had to make of this package.
fn each(count: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().with_max_len(1).for_each(work);
}

#[cfg(test)]
mod tests {
    #[test]
    fn answers_come_in_the_order_of_the_items() {
        let items: Vec<usize> = (0..1000).collect();
        assert_eq!(
            super::map(&items, |item| item * item),
            items.iter().map(|item| item * item).collect::<Vec<_>>()
        );
        assert!(super::map(&[0u8; 0], |_| ()).is_empty());
    }
}
