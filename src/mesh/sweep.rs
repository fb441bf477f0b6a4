//! Many poses of one assembly, in parallel and in order.

use super::lost_motion::LostMotion;
use super::polygon::{CutGear, PolygonKernel};
use crate::error::Error;
use crate::gear::AsBuilt;
use crate::pair::{Assembly, Mating, Member, Pose};
use rayon::prelude::*;
use std::ops::ControlFlow;

/// One pose of a sweep and what was found there.
#[derive(Debug, Clone, PartialEq)]
pub struct SweptPose {
    /// Where the gears stand.
    pub pose: Pose,
    /// Contacts of the free gear.
    pub lost_motion: LostMotion,
    /// `j_wt`, mm; `None` when jammed or out of mesh.
    pub backlash: Option<f64>,
    /// Bound on the error of `backlash`, mm.
    pub error_bound: Option<f64>,
    /// `j_wt`, mm, at `a − c` and at `a + c`, `c` the sum of both bearing clearances; `None` without clearance.
    pub with_clearance: Option<[Option<f64>; 2]>,
}

impl SweptPose {
    /// `j_wt`, mm, at the two ends of the bearing clearance; `backlash` twice where there is none.
    pub fn range(&self) -> [Option<f64>; 2] {
        self.with_clearance.unwrap_or([self.backlash; 2])
    }
}

/// The gears of one material, cut once for all centre distances.
pub struct CutPair {
    wheel: CutGear,
    pinion: CutGear,
}

impl CutPair {
    /// Cuts both gears with chords within `chord` mm of their curves.
    pub fn new(wheel: &AsBuilt, pinion: &AsBuilt, chord: f64) -> CutPair {
        CutPair {
            wheel: CutGear::new(wheel, chord),
            pinion: CutGear::new(pinion, chord),
        }
    }

    /// The polygon method on `assembly`, which must be of these gears.
    pub fn kernel<'a>(&'a self, assembly: &'a Assembly) -> PolygonKernel<'a> {
        PolygonKernel::new(assembly, &self.wheel, &self.pinion)
    }

    /// The same, cut finer round each contact: right to about a picometre.
    pub fn refined_kernel<'a>(&'a self, assembly: &'a Assembly) -> PolygonKernel<'a> {
        PolygonKernel::refined(assembly, &self.wheel, &self.pinion)
    }
}

/// The lost motion of `assembly` at each of `matings`, in their order, whatever the number of threads.
///
/// `cut` are the gears of `assembly`; `clearance` is the sum `c` of both radial
/// bearing clearances, mm. `tick` is called after each pose, from any thread; a break ends the sweep.
///
/// # Errors
/// The first pose, in order, whose contact was lost; [`Error::Interrupted`] after a break; a centre
/// distance `a − c` at which the base circles overlap.
pub fn sweep(
    assembly: &Assembly,
    cut: &CutPair,
    matings: &[Mating],
    clearance: f64,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Vec<SweptPose>, Error> {
    let apart = |distance: f64| assembly.at(assembly.center_distance() + distance);
    let ends = match clearance > 0.0 {
        true => Some([apart(-clearance)?, apart(clearance)?]),
        false => None,
    };
    let poses: Vec<Result<SweptPose, Error>> = matings
        .par_iter()
        .map(|mating| {
            let (pose, lost_motion) = at(assembly, cut, mating)?;
            let with_clearance = match &ends {
                None => None,
                Some([near, far]) => Some([
                    backlash(near, &at(near, cut, mating)?.1),
                    backlash(far, &at(far, cut, mating)?.1),
                ]),
            };
            if tick().is_break() {
                return Err(Error::Interrupted);
            }
            Ok(SweptPose {
                pose,
                lost_motion,
                backlash: backlash(assembly, &lost_motion),
                error_bound: lost_motion.error().map(|e| e * pitch_radius(assembly)),
                with_clearance,
            })
        })
        .collect();
    poses.into_iter().collect()
}

fn at(assembly: &Assembly, cut: &CutPair, mating: &Mating) -> Result<(Pose, LostMotion), Error> {
    let pose = Pose::new(assembly, *mating);
    Ok((pose, cut.kernel(assembly).lost_motion(&pose)?))
}

/// `j_wt = φ_j r_w` of the free gear, mm.
fn backlash(assembly: &Assembly, lost_motion: &LostMotion) -> Option<f64> {
    Some(lost_motion.angle()? * pitch_radius(assembly))
}

fn pitch_radius(assembly: &Assembly) -> f64 {
    let free: Member = assembly.free();
    assembly.operating_pitch_radius(free)
}
