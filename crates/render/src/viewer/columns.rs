//! The results as the script reads them: a column a quantity, an entry a pose.

use super::contacts::touching;
use super::precision::Precision;
use super::run_columns::RunColumns;
use super::viewed::Viewed;
use gearlash::compare::ComparedRun;
use gearlash::curves::Course;
use gearlash::gear::Side;
use gearlash::mesh::{PoseResult, Status};
use gearlash::study::Study;
use gearlash_files::numbers::rounded;
use serde::Serialize;

/// Decimals of a rotation in degrees: 2 nm at a radius of 130 mm.
pub const DEGREES: usize = 6;

/// All runs.
#[derive(Serialize)]
pub struct Columns {
    free: &'static str,
    /// What the contacts' classes count.
    classes: Vec<String>,
    /// What each run's statuses counts.
    statuses: [&'static str; 5],
    runs: Vec<RunColumns>,
    /// Run and pose shown first.
    start: [usize; 2],
}

impl Columns {
    /// The columns of `runs`, first shown at `start`: a run and a pose of those viewed.
    pub fn new(
        study: &Study,
        runs: &[Viewed],
        charts: &[(&str, &Course)],
        start: [usize; 2],
        precision: Precision,
    ) -> Columns {
        let mut classes = Vec::new();
        let runs = runs
            .iter()
            .map(|viewed| RunColumns::new(study, viewed, charts, precision, &mut classes));
        Columns {
            free: study.locked.mate().name(),
            runs: runs.collect(),
            classes,
            statuses: STATUSES.map(Status::name),
            start,
        }
    }
}

const STATUSES: [Status; 5] = [
    Status::Clear,
    Status::Interference,
    Status::Jammed,
    Status::NoContact,
    Status::Unproven,
];

/// Where a status stands in [`STATUSES`]. A status that is not there does not compile.
pub fn place_of(status: Status) -> usize {
    match status {
        Status::Clear => 0,
        Status::Interference => 1,
        Status::Jammed => 2,
        Status::NoContact => 3,
        Status::Unproven => 4,
    }
}

/// Which of the study's materials `run` has, in their order.
pub fn outlines(study: &Study, run: &ComparedRun) -> usize {
    let mut materials = study.materials.iter();
    materials
        .position(|(material, ..)| *material == run.run.material)
        .unwrap_or(0)
}

/// Where the free gear is drawn first: in right-flank contact, or else at its nominal rotation.
pub fn free_rotation(pose: &PoseResult) -> f64 {
    touching(pose, Side::Right).map_or(pose.pose.free_rotation(), |contact| contact.rotation)
}

/// A rotation, rad, in degrees as shown.
pub fn degrees(rotation: f64) -> f64 {
    rounded(rotation.to_degrees(), DEGREES)
}

#[cfg(test)]
mod tests {
    use super::{STATUSES, place_of};

    /// A status that had no place left its entry out, and every later pose of the run had its neighbour's.
    #[test]
    fn every_status_has_its_place() {
        for (place, status) in STATUSES.into_iter().enumerate() {
            assert_eq!(place_of(status), place);
        }
    }
}
