//! What simpler ways of pairing would come to.

use super::matrix::Matrix;

/// Thickness classes that are tried at most: more are not kept apart in a shop.
pub const MOST_CLASSES: usize = 10;

/// Pairs within what is required, as many as are to be expected.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expected {
    /// Put together in any phase.
    pub any_phase: f64,
    /// In the best phase of the pair: teeth are marked.
    pub best_phase: f64,
}

impl Matrix {
    /// Gears taken as they come.
    pub fn at_random(&self) -> Expected {
        let [wheels, pinions] = self.size();
        let (wheels, pinions) = ((0..wheels).collect(), (0..pinions).collect());
        self.expected(&[(wheels, pinions)])
    }

    /// Gears sorted by their mean thickness into as many classes as do best, up to [`MOST_CLASSES`], the thickest wheels taken with the
    /// thinnest pinions and at random within a class; with the number of classes. `None` without gears.
    pub fn by_classes(&self) -> Option<(usize, Expected)> {
        let most = self.most().min(MOST_CLASSES);
        let each = (1..=most).map(|count| (count, self.expected(&self.classes(count))));
        each.reduce(|best, one| match one.1.any_phase > best.1.any_phase {
            true => one,
            false => best,
        })
    }

    /// Wheels and pinions of each class.
    fn classes(&self, count: usize) -> Vec<(Vec<usize>, Vec<usize>)> {
        let sorted = |member: usize, sign: f64| {
            let thickness = &self.thicknesses[member];
            let mut order: Vec<usize> = (0..thickness.len()).collect();
            order.sort_by(|a, b| (sign * thickness[*a]).total_cmp(&(sign * thickness[*b])));
            order
        };
        let (wheels, pinions) = (sorted(0, 1.0), sorted(1, -1.0));
        let part = |order: &[usize], class: usize| {
            let border = |class: usize| class * order.len() / count;
            order[border(class)..border(class + 1)].to_vec()
        };
        let each = (0..count).map(|class| (part(&wheels, class), part(&pinions, class)));
        each.collect()
    }

    fn expected(&self, classes: &[(Vec<usize>, Vec<usize>)]) -> Expected {
        let (mut any_phase, mut best_phase) = (0.0, 0.0);
        for (wheels, pinions) in classes {
            let (mut meeting, mut meets) = (0u64, 0u64);
            for &wheel in wheels {
                for found in pinions
                    .iter()
                    .filter_map(|pinion| self.pair_fit(wheel, *pinion))
                {
                    meeting += u64::from(found.meeting);
                    meets += u64::from(found.best.meets);
                }
            }
            let places = wheels.len() * pinions.len();
            if places == 0 {
                continue;
            }
            // Each of the pairs that a class makes is any of its places.
            let pairs = wheels.len().min(pinions.len()) as f64 / places as f64;
            any_phase += pairs * meeting as f64 / f64::from(self.phases);
            best_phase += pairs * meets as f64;
        }
        Expected {
            any_phase,
            best_phase,
        }
    }
}
