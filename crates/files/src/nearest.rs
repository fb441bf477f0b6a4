//! The known word nearest to a misspelt one.

/// The word of `known` with the least edit distance from `word`, and that distance.
///
/// On a tie the first. Of a very long word none: no known word is half as long.
pub fn nearest<'k>(word: &str, known: &[&'k str]) -> Option<(&'k str, usize)> {
    const LONGEST: usize = 64;
    let word: Vec<char> = word.chars().take(LONGEST + 1).collect();
    if word.len() > LONGEST {
        return None;
    }
    known
        .iter()
        .map(|&candidate| (candidate, edit_distance(&word, candidate)))
        .min_by_key(|&(_, distance)| distance)
}

/// Whether `distance` is so small that `word` can only be a slip: up to two in five of its letters.
///
/// Tuned: `theet` is `teeth`, `phases` is not `start`.
pub fn is_slip(word: &str, distance: usize) -> bool {
    5 * distance <= 2 * word.chars().count()
}

/// Letters to insert, delete, replace or swap with a neighbour (optimal string alignment).
fn edit_distance(from: &[char], to: &str) -> usize {
    let to: Vec<char> = to.chars().collect();
    let mut before = Vec::new();
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (i, &a) in from.iter().enumerate() {
        let mut next = vec![i + 1];
        for (j, &b) in to.iter().enumerate() {
            let mut least = (row[j] + usize::from(a != b))
                .min(row[j + 1] + 1)
                .min(next[j] + 1);
            if i > 0 && j > 0 && a == to[j - 1] && from[i - 1] == b {
                least = least.min(before[j - 1] + 1);
            }
            next.push(least);
        }
        before = std::mem::replace(&mut row, next);
    }
    row.last().copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn distance(from: &str, to: &str) -> usize {
        edit_distance(&from.chars().collect::<Vec<_>>(), to)
    }

    /// Counted by hand.
    #[test]
    fn each_slip_counts_once() {
        assert_eq!(distance("teeth", "teeth"), 0);
        assert_eq!(distance("teth", "teeth"), 1);
        assert_eq!(distance("teethh", "teeth"), 1);
        assert_eq!(distance("tooth", "teeth"), 2);
        assert_eq!(distance("tehet", "teeth"), 2);
        assert_eq!(distance("teteh", "teeth"), 1);
        assert_eq!(distance("", "teeth"), 5);
    }

    #[test]
    fn slips_are_told_from_other_words() {
        assert!(is_slip("theet", distance("theet", "teeth")));
        assert!(!is_slip("phases", distance("phases", "start")));
    }

    #[test]
    fn the_nearest_word_is_found() {
        let known = ["teeth", "module_mm", "runout"];
        assert_eq!(nearest("moduel_mm", &known), Some(("module_mm", 1)));
        assert_eq!(nearest("run_out", &known), Some(("runout", 1)));
        assert_eq!(nearest("x", &[]), None);
    }
}
