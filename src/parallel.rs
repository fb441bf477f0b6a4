//! One function of many things, on all cores where the feature `rayon` is on; the results in order, whatever the number of threads.

/// `f` of each of `items`, in their order.
#[cfg(feature = "rayon")]
pub(crate) fn map<T: Send, R: Send>(
    items: impl IntoIterator<Item = T>,
    f: impl Fn(T) -> R + Sync + Send,
) -> Vec<R> {
    use std::sync::{Mutex, PoisonError};
    let item_cell = |item| Mutex::new((Some(item), None));
    let cells: Vec<Mutex<(Option<T>, Option<R>)>> = items.into_iter().map(item_cell).collect();
    for_each_index(cells.len(), &|index| {
        let mut cell = cells[index].lock().unwrap_or_else(PoisonError::into_inner);
        cell.1 = cell.0.take().map(&f);
    });
    let result = |cell: Mutex<(_, Option<R>)>| cell.into_inner().map_or(None, |cell| cell.1);
    cells.into_iter().filter_map(result).collect()
}

/// Calls `f` with each index below `count`. The function is `dyn` so that the parallel loop is compiled once, not for each caller.
#[cfg(feature = "rayon")]
fn for_each_index(count: usize, f: &(dyn Fn(usize) + Sync)) {
    use rayon::prelude::*;
    (0..count).into_par_iter().for_each(f);
}

/// `f` of each of `items`, in their order.
#[cfg(not(feature = "rayon"))]
pub(crate) fn map<T: Send, R: Send>(
    items: impl IntoIterator<Item = T>,
    f: impl Fn(T) -> R + Sync + Send,
) -> Vec<R> {
    items.into_iter().map(f).collect()
}
