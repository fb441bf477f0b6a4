//! The known word nearest to a misspelt one.

/// The word of `known` with the least edit distance from `word`, and that distance.
///
/// The first wins a tie. A word over 64 characters has none: no known word is half as long.
pub fn nearest<'k>(word: &str, known: &[&'k str]) -> Option<(&'k str, usize)> {
    const LONGEST: usize = 64;
    if word.chars().nth(LONGEST).is_some() {
        return None;
    }
    known
        .iter()
        .map(|&candidate| (candidate, strsim::osa_distance(word, candidate)))
        .min_by_key(|&(_, distance)| distance)
}

/// Whether `distance` is so small that `word` must be a typing error: at most two in five of its letters.
///
/// Tuned: `theet` is `teeth`, `phases` is not `start`.
pub fn is_slip(word: &str, distance: usize) -> bool {
    5 * distance <= 2 * word.chars().count()
}
