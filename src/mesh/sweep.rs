//! Many poses of one assembly, in parallel and in order.

use super::exact::ExactKernel;
use super::lost_motion::{LostMotion, Status};
use super::polygon::{Certifier, CutGear, PolygonKernel};
use crate::error::Error;
use crate::gear::AsBuilt;
use crate::pair::{Assembly, Mating, Pose};
use rayon::prelude::*;
use std::ops::ControlFlow;

/// How lost motion is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// On the smooth curves.
    Exact {
        /// Whether polygons must bear out each rotation found.
        certify: bool,
    },
    /// On polygons cut ever finer round each contact.
    Polygon,
    /// By both; the exact result is kept, and how far the other lies off.
    Both,
}

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
    /// With [`Method::Both`]: `j_wt` on polygons minus the exact one, mm; infinite when only one method has a value.
    pub polygon_difference: Option<f64>,
}

impl SweptPose {
    /// `j_wt`, mm, at the two ends of the bearing clearance; `backlash` twice where there is none.
    pub fn range(&self) -> [Option<f64>; 2] {
        self.with_clearance.unwrap_or([self.backlash; 2])
    }

    /// Whether `backlash` is negative beyond its error bound: rounding alone makes no interference.
    pub fn interferes(&self) -> bool {
        let surely = |(backlash, bound): (f64, f64)| backlash < -bound;
        self.backlash.zip(self.error_bound).is_some_and(surely)
    }

    /// Whether `backlash` cannot be told from none.
    pub fn just_touches(&self) -> bool {
        let none = |(backlash, bound): (f64, f64)| backlash.abs() <= bound;
        self.backlash.zip(self.error_bound).is_some_and(none)
    }
}

/// The worst of `poses`: the first that is jammed, or else the one with the least backlash, of several within their
/// error bounds the first; `None` when none is in mesh.
pub fn worst_pose<'a, T>(poses: impl Iterator<Item = (T, &'a SweptPose)> + Clone) -> Option<T> {
    let jammed = |pose: &SweptPose| pose.lost_motion.status() == Status::Jammed;
    if let Some((first, _)) = poses.clone().find(|(_, pose)| jammed(pose)) {
        return Some(first);
    }
    first_least(poses.filter_map(|(item, pose)| Some((item, pose.backlash?, pose.error_bound?))))
}

/// The first of `items` (each with a value and a bound on its error) that cannot be told from the least.
pub fn first_least<T>(items: impl Iterator<Item = (T, f64, f64)> + Clone) -> Option<T> {
    // The least that a value may at most be: whatever may lie as low cannot be told from it.
    let highest = items.clone().map(|(_, value, bound)| value + bound);
    let limit = highest.reduce(f64::min)?;
    let mut low = items.filter(|(_, value, bound)| value - bound <= limit);
    low.next().map(|(item, ..)| item)
}

/// Chordal error, in modules, of the polygons that a certificate starts from (tuned for speed: it is as
/// good from any; a tenth or ten times of this takes a third longer).
const CERTIFICATE_CHORD: f64 = 3e-4;

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

    /// Cuts both gears as coarsely as suits certificates.
    pub fn for_certificates(wheel: &AsBuilt, pinion: &AsBuilt) -> CutPair {
        CutPair::new(
            wheel,
            pinion,
            CERTIFICATE_CHORD * wheel.gear().toothing().module(),
        )
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

/// One assembly, ready to be asked for poses.
struct Solver<'a> {
    assembly: &'a Assembly,
    exact: Option<ExactKernel>,
    polygon: Option<PolygonKernel<'a>>,
    certifier: Option<Certifier<'a>>,
}

impl<'a> Solver<'a> {
    fn new(assembly: &'a Assembly, cut: &'a CutPair, method: Method) -> Solver<'a> {
        let certify = method == Method::Exact { certify: true };
        let exact = method != Method::Polygon;
        let polygon = matches!(method, Method::Polygon | Method::Both);
        Solver {
            assembly,
            exact: exact.then(|| ExactKernel::new(assembly)),
            polygon: polygon.then(|| cut.refined_kernel(assembly)),
            certifier: certify.then(|| Certifier::new(cut.kernel(assembly))),
        }
    }

    /// The contacts at `pose`, and how far the polygon method lies off where both are asked for.
    fn lost_motion(&self, pose: &Pose) -> Result<(LostMotion, Option<f64>), Error> {
        let exact = self.exact.as_ref().map(|kernel| kernel.lost_motion(pose));
        let polygon = self.polygon.as_ref().map(|kernel| kernel.lost_motion(pose));
        match (exact.transpose()?, polygon.transpose()?) {
            (Some(exact), Some(polygon)) => {
                let difference = match (self.backlash(&exact), self.backlash(&polygon)) {
                    (Some(exact), Some(polygon)) => polygon - exact,
                    (None, None) => 0.0,
                    _ => f64::INFINITY,
                };
                Ok((exact, Some(difference)))
            }
            (Some(found), None) | (None, Some(found)) => {
                if let Some(certifier) = &self.certifier {
                    certifier.check(pose, &found)?;
                }
                Ok((found, None))
            }
            // A solver is made with at least one method.
            (None, None) => Err(Error::Usage("no method to find lost motion by".to_owned())),
        }
    }

    /// `j_wt = φ_j r_w` of the free gear, mm.
    fn backlash(&self, lost_motion: &LostMotion) -> Option<f64> {
        Some(lost_motion.angle()? * self.pitch_radius())
    }

    fn pitch_radius(&self) -> f64 {
        self.assembly.operating_pitch_radius(self.assembly.free())
    }

    fn backlash_at(&self, mating: &Mating) -> Result<Option<f64>, Error> {
        let (found, _) = self.lost_motion(&Pose::new(self.assembly, *mating))?;
        Ok(self.backlash(&found))
    }
}

/// The lost motion of `assembly` at each of `matings`, in their order, whatever the number of threads.
///
/// `cut` are the gears of `assembly`; `clearance` is the sum `c` of both radial
/// bearing clearances, mm. `tick` is called as each pose begins, from any thread; a break ends the sweep.
///
/// # Errors
/// The first pose, in order, whose contact was lost or whose certificate failed; [`Error::Interrupted`]
/// after a break; a centre distance `a − c` at which the base circles overlap.
pub fn sweep(
    assembly: &Assembly,
    cut: &CutPair,
    method: Method,
    matings: &[Mating],
    clearance: f64,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Vec<SweptPose>, Error> {
    let apart = |distance: f64| assembly.at(assembly.center_distance() + distance);
    let moved = match clearance > 0.0 {
        true => Some([apart(-clearance)?, apart(clearance)?]),
        false => None,
    };
    let here = Solver::new(assembly, cut, method);
    let ends = moved
        .as_ref()
        .map(|ends| ends.each_ref().map(|end| Solver::new(end, cut, method)));
    let poses: Vec<Result<SweptPose, Error>> = matings
        .par_iter()
        .map(|mating| {
            if tick().is_break() {
                return Err(Error::Interrupted);
            }
            let pose = Pose::new(assembly, *mating);
            let (lost_motion, polygon_difference) = here.lost_motion(&pose)?;
            let with_clearance = match &ends {
                None => None,
                Some([near, far]) => Some([near.backlash_at(mating)?, far.backlash_at(mating)?]),
            };
            let backlash = here.backlash(&lost_motion);
            Ok(SweptPose {
                pose,
                lost_motion,
                backlash,
                error_bound: backlash
                    .and(lost_motion.error())
                    .map(|e| e * here.pitch_radius()),
                with_clearance,
                polygon_difference,
            })
        })
        .collect();
    poses.into_iter().collect()
}
