//! The problems of a pair file, collected so that the user sees all of them at once.

use crate::error::Problem;

/// How many problems of one list are reported one by one; of the rest only the number.
/// Tuned: they fit a screen beside other problems.
const TOLD_OF_A_LIST: usize = 12;

/// Problems in the order in which they were met.
#[derive(Debug)]
pub struct Problems {
    listed: Vec<Problem>,
    most: usize,
    untold: usize,
}

impl Problems {
    /// None yet, and no limit.
    pub fn new() -> Problems {
        Problems {
            listed: Vec::new(),
            most: usize::MAX,
            untold: 0,
        }
    }

    /// None yet, for the elements of one list: only the first dozen will be reported.
    pub fn of_list() -> Problems {
        Problems {
            most: TOLD_OF_A_LIST,
            ..Problems::new()
        }
    }

    /// Adds one.
    pub fn add(&mut self, problem: Problem) {
        if self.listed.len() < self.most {
            self.listed.push(problem);
        } else {
            self.untold += 1;
        }
    }

    /// Adds each.
    pub fn extend(&mut self, problems: impl IntoIterator<Item = Problem>) {
        problems.into_iter().for_each(|problem| self.add(problem));
    }

    /// Whether one more will only be counted.
    pub fn is_full(&self) -> bool {
        self.listed.len() >= self.most
    }

    /// Counts one that is not reported.
    pub fn count_one(&mut self) {
        self.untold += 1;
    }

    /// The value, or `None` with its problem added.
    pub fn keep<T>(&mut self, result: Result<T, Problem>) -> Option<T> {
        result.map_err(|problem| self.add(problem)).ok()
    }

    /// Adds those of the list at `key`.
    pub fn add_list(&mut self, key: &str, list: Problems) {
        self.listed.extend(list.listed);
        if list.untold > 0 {
            self.listed.push(Problem {
                key: key.to_owned(),
                value: None,
                reason: format!("{} more problems like the last one", list.untold),
                help: "fix those first".to_owned(),
            });
        }
    }

    /// The result of `read` for the list at `key`; `None` where it has a problem. Only the first dozen are reported.
    pub fn of_list_at<T>(
        &mut self,
        key: &str,
        read: impl FnOnce(&mut Problems) -> Option<T>,
    ) -> Option<T> {
        let mut bad = Problems::of_list();
        let read = read(&mut bad);
        let good = bad.is_empty();
        self.add_list(key, bad);
        read.filter(|_| good)
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.listed.is_empty()
    }

    /// All that are reported.
    pub fn into_list(self) -> Vec<Problem> {
        self.listed
    }
}
