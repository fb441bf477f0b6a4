//! A rig's measured backlash with the predicted and the simulated band, mating by mating.

use crate::analysis::compare::{ComparedPose, ComparedRun};
use crate::analysis::study::{Material, MeasuredRow, Study};
use crate::pair::Mating;
use std::collections::{HashMap, HashSet};

/// A band of backlash, µm.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Band {
    /// At most material, unless there is only one.
    pub min_um: f64,
    /// At least material.
    pub max_um: f64,
}

impl Band {
    /// Position of `value_um`: −1 below, 0 inside (including the ends), 1 above.
    pub fn side_of(&self, value_um: f64) -> i8 {
        i8::from(value_um > self.max_um) - i8::from(value_um < self.min_um)
    }
}

/// A measured mating and its bands. Bands are means of the right-flank and the left-flank pose; `None` if a pose has no
/// value or was not run.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct MeasuredMating {
    /// The measured values.
    pub row: MeasuredRow,
    /// The prediction published with the measurement; `None` without one.
    pub printed: Option<Band>,
    /// Model 2.
    pub analytic: Option<Band>,
    /// Simulated.
    pub simulated: Option<Band>,
    /// Simulated, from most material at `a − c` to least material at `a + c`.
    pub with_clearance: Option<Band>,
}

/// The bands of a mating: means of the right-flank and the left-flank pose; `None` if a pose has no value or was not run.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Bands {
    /// Model 2.
    pub analytic: Option<Band>,
    /// Model 3.
    pub line_of_action: Option<Band>,
    /// Simulated.
    pub simulated: Option<Band>,
    /// Simulated, from most material at `a − c` to least material at `a + c`.
    pub with_clearance: Option<Band>,
}

/// The measured matings of `study`, in the order of their file, with their values in `runs`.
pub fn measured_matings(study: &Study, runs: &[ComparedRun]) -> Vec<MeasuredMating> {
    let mut tally = MeasuredTally::new(study);
    for run in runs {
        tally.begin(run.run.assembly.center_distance(), run.run.material);
        tally.add(&run.poses);
    }
    tally.matings(study)
}

/// The bits of the centre distance, material, wheel and pinion tooth of a mating.
type Key = (u64, Material, u32, u32);

fn key(row: &MeasuredRow, material: Material) -> Key {
    let distance = row.center_distance.to_bits();
    (distance, material, row.wheel_tooth, row.pinion_tooth)
}

/// The measured matings of a study whose poses arrive one by one.
#[derive(Debug)]
pub struct MeasuredTally {
    means: HashMap<Key, Means>,
    /// Centre distances and materials that have begun. If several runs (phases) share one, the first counts.
    begun: HashSet<(u64, Material)>,
    /// The current run, if it counts.
    now: Option<(u64, Material)>,
}

impl MeasuredTally {
    /// A tally without poses.
    pub fn new(study: &Study) -> MeasuredTally {
        let keys = study.material_names().flat_map(|material| {
            let rows = study.measured.iter();
            rows.map(move |row| key(row, material))
        });
        MeasuredTally {
            means: keys.map(|key| (key, Means::default())).collect(),
            begun: HashSet::new(),
            now: None,
        }
    }

    /// Starts a run of `material` at `center_distance`, mm.
    pub fn begin(&mut self, center_distance: f64, material: Material) {
        let run = (center_distance.to_bits(), material);
        self.now = self.begun.insert(run).then_some(run);
    }

    /// Adds the next poses of the run.
    pub fn add(&mut self, poses: &[ComparedPose]) {
        let Some((distance, material)) = self.now.filter(|_| !self.means.is_empty()) else {
            return;
        };
        for pose in poses {
            let at = pose.simulated.pose.mating();
            let key = (distance, material, at.wheel_tooth, at.pinion_tooth);
            if at.fraction == 0.0
                && let Some(means) = self.means.get_mut(&key)
            {
                means.add(pose);
            }
        }
    }

    /// As [`measured_matings`].
    pub fn matings(&self, study: &Study) -> Vec<MeasuredMating> {
        let of_row = |row: &MeasuredRow| {
            let means = |material| self.means.get(&key(row, material)).copied();
            let bands = Bands::of(study, |material| means(material).unwrap_or_default());
            MeasuredMating {
                printed: (row.predicted_min_um.zip(row.predicted_max_um))
                    .map(|(min_um, max_um)| Band { min_um, max_um }),
                analytic: bands.analytic,
                simulated: bands.simulated,
                with_clearance: bands.with_clearance,
                row: row.clone(),
            }
        };
        study.measured.iter().map(of_row).collect()
    }
}

/// Number of measured values, right and left of each mating, that are below, inside and above their band. Values
/// without a band are not counted.
pub fn sides(measured: &[MeasuredMating], band: fn(&MeasuredMating) -> Option<Band>) -> [usize; 3] {
    let mut sides = [0; 3];
    for mating in measured {
        let Some(band) = band(mating) else { continue };
        for value in [mating.row.right_um, mating.row.left_um] {
            sides[(1 + band.side_of(value)) as usize] += 1;
        }
    }
    sides
}

/// Bands of the `wanted` poses of `runs` at `center_distance`, mm.
pub fn bands(
    study: &Study,
    runs: &[ComparedRun],
    center_distance: f64,
    wanted: impl Fn(&Mating) -> bool,
) -> Bands {
    let is_wanted = |pose: &&ComparedPose| wanted(pose.simulated.pose.mating());
    Bands::of(study, |material| {
        let here = (center_distance, material);
        let run = runs.iter().find(|run| run.run.group_key() == here);
        let mut means = Means::default();
        let poses = run.into_iter().flat_map(|run| &run.poses);
        for pose in poses.filter(is_wanted) {
            means.add(pose);
        }
        means
    })
}

impl Bands {
    /// From the thickest to the thinnest material of `study`.
    fn of(study: &Study, means: impl Fn(Material) -> Means) -> Bands {
        let (thick, thin) = match study.material_count() {
            1 => (Material::AsMeasured, Material::AsMeasured),
            _ => (Material::Most, Material::Least),
        };
        let (thick, thin) = (means(thick), means(thin));
        let band = |least: Mean, most: Mean| {
            Some(Band {
                min_um: least.um()?,
                max_um: most.um()?,
            })
        };
        Bands {
            analytic: band(thick.analytic, thin.analytic),
            line_of_action: band(thick.line_of_action, thin.line_of_action),
            simulated: band(thick.simulated, thin.simulated),
            with_clearance: band(thick.ends[0], thin.ends[1]),
        }
    }
}

/// Means over poses of one material.
#[derive(Debug, Clone, Copy, Default)]
struct Means {
    analytic: Mean,
    line_of_action: Mean,
    simulated: Mean,
    /// At `a − c` and at `a + c`.
    ends: [Mean; 2],
}

impl Means {
    fn add(&mut self, pose: &ComparedPose) {
        let [near, far] = pose.simulated.range();
        self.analytic.add(pose.involute);
        self.line_of_action.add(pose.line_of_action);
        self.simulated.add(pose.simulated.backlash);
        self.ends[0].add(near);
        self.ends[1].add(far);
    }
}

/// A mean of values that arrive one by one, mm.
#[derive(Debug, Clone, Copy, Default)]
struct Mean {
    sum: f64,
    count: u32,
    /// Whether a pose has no value, so that there is no mean.
    incomplete: bool,
}

impl Mean {
    fn add(&mut self, value: Option<f64>) {
        match value {
            Some(value) => {
                self.sum += value;
                self.count += 1;
            }
            None => self.incomplete = true,
        }
    }

    /// The mean in µm; `None` if a pose has no value or there are none.
    fn um(&self) -> Option<f64> {
        let known = self.count > 0 && !self.incomplete;
        known.then(|| self.sum / f64::from(self.count) * 1e3)
    }
}
