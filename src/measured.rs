//! A rig's measured backlash beside the predicted and the simulated band, mating by mating.

use crate::compare::{ComparedPose, ComparedRun};
use crate::pair::Mating;
use crate::study::{Material, MeasuredRow, Study};

/// A band of backlash, µm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Band {
    /// At most material, unless there is only one.
    pub min_um: f64,
    /// At least material.
    pub max_um: f64,
}

impl Band {
    /// Where `value_um` lies: −1 below, 0 inside (ends included), 1 above.
    pub fn side_of(&self, value_um: f64) -> i8 {
        i8::from(value_um > self.max_um) - i8::from(value_um < self.min_um)
    }
}

/// A measured mating and the bands it should lie in. Bands are means of the right-flank and the
/// left-flank pose; `None` where a pose has no value or was not run.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredMating {
    /// As read.
    pub row: MeasuredRow,
    /// As printed beside the measurement.
    pub printed: Band,
    /// Model 2.
    pub analytic: Option<Band>,
    /// Simulated.
    pub simulated: Option<Band>,
    /// Simulated, from most material at `a − c` to least material at `a + c`.
    pub with_clearance: Option<Band>,
}

/// A mating's bands; means of the right-flank and the left-flank pose; `None` where a pose has no value or was not run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bands {
    /// Model 2.
    pub analytic: Option<Band>,
    /// Simulated.
    pub simulated: Option<Band>,
    /// Simulated, from most material at `a − c` to least material at `a + c`.
    pub with_clearance: Option<Band>,
}

/// The measured matings of `study`, in the order of their file, with what `runs` says of each.
pub fn measured_matings(study: &Study, runs: &[ComparedRun]) -> Vec<MeasuredMating> {
    let of_row = |row: &MeasuredRow| {
        let mating = (row.wheel_tooth, row.pinion_tooth);
        let bands = bands(study, runs, row.center_distance, |here| {
            (here.wheel_tooth, here.pinion_tooth) == mating && here.fraction == 0.0
        });
        MeasuredMating {
            printed: Band {
                min_um: row.predicted_min_um,
                max_um: row.predicted_max_um,
            },
            analytic: bands.analytic,
            simulated: bands.simulated,
            with_clearance: bands.with_clearance,
            row: row.clone(),
        }
    };
    study.measured.iter().map(of_row).collect()
}

/// How many measured values, right and left of each mating, lie below, inside and above its band; those without a
/// band are not counted.
pub fn sides(measured: &[MeasuredMating], band: fn(&MeasuredMating) -> Option<Band>) -> [usize; 3] {
    let mut sides = [0; 3];
    for mating in measured {
        let Some(band) = band(mating) else { continue };
        for value in [mating.row.right_um, mating.row.left_um] {
            match band.side_of(value) {
                0 => sides[1] += 1,
                1 => sides[2] += 1,
                _ => sides[0] += 1,
            }
        }
    }
    sides
}

/// What the poses of `runs` that are `wanted` say at `center_distance`, mm.
pub fn bands(
    study: &Study,
    runs: &[ComparedRun],
    center_distance: f64,
    wanted: impl Fn(&Mating) -> bool,
) -> Bands {
    let is_wanted = |pose: &&ComparedPose| wanted(pose.swept.pose.mating());
    let mean = |material: Material, value: &dyn Fn(&ComparedPose) -> Option<f64>| {
        let run = runs.iter().find(|compared| {
            compared.run.material == material
                && compared.run.assembly.center_distance() == center_distance
        })?;
        mean_um(run.poses.iter().filter(is_wanted), value)
    };
    let band = |least: &dyn Fn(&ComparedPose) -> Option<f64>,
                most: &dyn Fn(&ComparedPose) -> Option<f64>| {
        let (thick, thin) = match study.materials.len() {
            1 => (Material::AsMeasured, Material::AsMeasured),
            _ => (Material::Most, Material::Least),
        };
        Some(Band {
            min_um: mean(thick, least)?,
            max_um: mean(thin, most)?,
        })
    };
    let simulated = |pose: &ComparedPose| pose.swept.backlash;
    let clearance = |end: usize| move |pose: &ComparedPose| pose.swept.range()[end];
    Bands {
        analytic: band(&|pose| pose.involute, &|pose| pose.involute),
        simulated: band(&simulated, &simulated),
        with_clearance: band(&clearance(0), &clearance(1)),
    }
}

/// Mean over `poses`, µm; `None` where one has no value or there is none.
fn mean_um<'a>(
    poses: impl Iterator<Item = &'a ComparedPose>,
    value: &dyn Fn(&ComparedPose) -> Option<f64>,
) -> Option<f64> {
    let (mut sum, mut count) = (0.0, 0);
    for pose in poses {
        sum += value(pose)?;
        count += 1;
    }
    (count > 0).then(|| sum / f64::from(count) * 1e3)
}
