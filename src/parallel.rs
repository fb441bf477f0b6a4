//! One function of many things, on all cores where the feature `rayon` is on; the results in order, whatever the number of threads.

/// `f` of each of `items`, in their order.
#[cfg(feature = "rayon")]
pub(crate) fn map<T: Send, R: Send>(
    items: impl IntoIterator<Item = T>,
    f: impl Fn(T) -> R + Sync + Send,
) -> Vec<R> {
    use rayon::prelude::*;
    let items: Vec<T> = items.into_iter().collect();
    items.into_par_iter().map(f).collect()
}

/// `f` of each of `items`, in their order.
#[cfg(not(feature = "rayon"))]
pub(crate) fn map<T: Send, R: Send>(
    items: impl IntoIterator<Item = T>,
    f: impl Fn(T) -> R + Sync + Send,
) -> Vec<R> {
    items.into_iter().map(f).collect()
}
