//! From the values of a pitch sheet to the cumulative curves.

use super::{Kind, PitchSheet, Sense};
use crate::problems::Problems;
use crate::table::Table;
use gearlash::gear::{BasicGearData, Pitch, Side};
use std::f64::consts::PI;

/// Sheets round single pitch deviations to 0.1 µm: half of that a tooth, 0.05 µm, may be left in
/// their sum; more is a slip, or not a list of single deviations.
const ROUNDING_UM: f64 = 0.05;

impl PitchSheet {
    /// The cumulative curves about the gear's own centre, each within half a pitch.
    pub fn curves(
        &self,
        gear: &Table,
        basic_data: &BasicGearData,
        problems: &mut Problems,
    ) -> Option<Pitch> {
        let mm = |um: &[f64]| -> Vec<f64> { um.iter().map(|um| um / 1000.0).collect() };
        let (right, left) = (mm(&self.right_um), mm(&self.left_um));
        let mut pitch = match self.kind {
            Kind::Cumulative => Pitch::from_cumulative(&right, &left),
            Kind::Single => Pitch::from_single(&right, &left),
        };
        if self.sense == Sense::Material {
            pitch = pitch.read_as_material();
        }
        self.check_half_pitch(gear, &pitch, basic_data, problems)?;
        Some(pitch)
    }

    fn check_half_pitch(
        &self,
        gear: &Table,
        pitch: &Pitch,
        basic_data: &BasicGearData,
        problems: &mut Problems,
    ) -> Option<()> {
        let half = PI * basic_data.module() / 2.0;
        let mut good = Some(());
        for side in Side::BOTH {
            let worst = pitch
                .flank(side)
                .iter()
                .enumerate()
                .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
            if let Some((index, f)) = worst.filter(|(_, f)| !(f.abs() < half)) {
                problems.add(gear.problem(
                    self.key(side),
                    format!(
                        "the {} flank of tooth {} stands {:.1} µm from the mean, allowed is less than half a pitch, {:.1} µm",
                        side.name(),
                        index + 1,
                        1000.0 * f,
                        1000.0 * half
                    ),
                    "check the unit (µm) and whether the values are single or cumulative",
                ));
                good = None;
            }
        }
        good
    }

    /// A warning for each flank whose single pitches do not close the circle.
    pub fn warnings(&self, gear: &Table) -> Vec<String> {
        if self.kind != Kind::Single {
            return Vec::new();
        }
        let flanks = [(Side::Right, &self.right_um), (Side::Left, &self.left_um)];
        flanks
            .into_iter()
            .filter_map(|(side, um)| {
                let sum: f64 = um.iter().sum();
                let rounding = ROUNDING_UM * um.len() as f64;
                (sum.abs() > rounding).then(|| {
                    format!(
                        "{}: the single pitch deviations of the {} flanks sum to {sum:.2} µm instead of 0 (rounding leaves up to {rounding:.2} µm); \
                         the rest is shared out evenly over the teeth",
                        gear.path_of(self.key(side)),
                        side.name(),
                    )
                })
            })
            .collect()
    }
}
