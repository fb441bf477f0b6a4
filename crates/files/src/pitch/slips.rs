//! A single pitch value that stands out.

use super::{Kind, PitchSheet};
use crate::slips::{FEWEST, Outlier, STANDS_OUT, coarse, median};
use crate::table::Table;
use gearlash::gear::{BasicGearData, GradedQuantity, Side};

impl PitchSheet {
    /// The value that lies farthest from its neighbours (cumulative) or from the others (single), where that is more than all the
    /// others do and than two neighbours of even a coarse gear differ.
    ///
    /// A step in cumulative values, such as the last tooth cut leaves, lies half its height off either neighbours' mean.
    pub fn slip(&self, gear: &Table, basic_data: &BasicGearData) -> Option<Outlier> {
        let plausible = 1000.0 * coarse(GradedQuantity::SinglePitch, basic_data);
        let flanks = [(Side::Right, &self.right_um), (Side::Left, &self.left_um)];
        let farthest = |(side, um): (Side, &Vec<f64>)| {
            let off = self.off(um);
            let spread = median(off.iter().map(|off| off.abs()));
            let (index, far) = (0..)
                .zip(&off)
                .max_by(|a: &(usize, _), b| a.1.abs().total_cmp(&b.1.abs()))?;
            let out = far.abs() > (STANDS_OUT * spread).max(plausible) && um.len() >= FEWEST;
            out.then(|| (far.abs(), spread, side, index, um[index]))
        };
        let (far, spread, side, index, value) = flanks
            .into_iter()
            .filter_map(farthest)
            .max_by(|a, b| a.0.total_cmp(&b.0))?;
        let from = match self.kind {
            Kind::Cumulative => "its neighbours' mean",
            Kind::Single => "the median",
        };
        Some(Outlier {
            key: gear.path_of(self.key(side)),
            what: format!(
                "tooth {} of the {} flanks, {value} µm,",
                index + 1,
                side.name()
            ),
            off: format!("{far:.1} µm from {from}"),
            why: format!(
                "more than the {plausible:.0} µm of even a coarse gear, half of the others within {spread:.1} µm"
            ),
        })
    }

    /// How far each value lies off, µm.
    fn off(&self, um: &[f64]) -> Vec<f64> {
        match self.kind {
            Kind::Single => {
                let middle = median(um.iter().copied());
                um.iter().map(|f| f - middle).collect()
            }
            Kind::Cumulative => {
                let (mut before, mut after) = (um.to_vec(), um.to_vec());
                // Of no teeth nothing can be turned.
                before.rotate_right(1.min(um.len()));
                after.rotate_left(1.min(um.len()));
                let beside = before.iter().zip(&after);
                um.iter()
                    .zip(beside)
                    .map(|(f, (b, a))| f - (b + a) / 2.0)
                    .collect()
            }
        }
    }
}
