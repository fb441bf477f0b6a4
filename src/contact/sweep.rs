//! Many poses of one assembly, in parallel and in order.

use super::by_sections::CutSections;
use super::effort::Effort;
use super::exact::ExactKernel;
use super::kernel::{Proof, Prover};
use super::lost_motion::LostMotion;
use super::outline::{OutlineCertifier, OutlineKernel};
use super::over_face::FoundOverFace;
use super::polygon::{Certifier, CutPair, PolygonKernel};
use super::pose_result::{PolygonDifference, PoseResult, Unproven};
use crate::error::{Error, REPORT_PAIR, Tick};
use crate::outline::{AssembledPair, OutlinePair};
use crate::pair::{GearPair, Mating, Member, Pose};
use crate::parallel;

/// The method that finds lost motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// On the smooth curves.
    Exact {
        /// Whether directions prove each pose. Polygons check one pose in [`POLYGONS_EVERY`], and each pose without such a proof.
        certify: bool,
    },
    /// On the smooth curves. Each pose is proven by directions and checked by polygons.
    Checked,
    /// On polygons that are cut finer around each contact.
    Polygon,
    /// By both methods. The result is the exact one, with the difference of the other. A pose is [`Unproven`] if they
    /// differ by more than [`METHODS_AGREE_WITHIN`] and more than both error bounds.
    Both,
}

/// Difference of both methods, mm, that is always allowed: 1e-6 µm of `j_wt`.
pub const METHODS_AGREE_WITHIN: f64 = 1e-9;

/// Polygons check one pose in this many, starting with the first of a sweep.
pub const POLYGONS_EVERY: usize = 64;

impl Method {
    /// The method for poses of extremes, which polygons also check.
    pub fn of_extremes(self) -> Method {
        if self == (Method::Exact { certify: true }) {
            Method::Checked
        } else {
            self
        }
    }

    /// Whether exact results are proven.
    fn proves(self) -> bool {
        matches!(self, Method::Exact { certify: true } | Method::Checked)
    }
}

/// The methods for one assembly.
struct Solver<'a> {
    assembly: &'a GearPair,
    kernel: Option<ExactKernel>,
    /// Whether the kernel only tells polygons which sections of helical gears to examine.
    guides: bool,
    polygon: Option<PolygonKernel<'a>>,
    certifier: Option<Certifier<'a>>,
    prover: Option<Prover>,
    /// Replaces polygon method and certifier for helical gears.
    sections: Option<CutSections<'a>>,
    method: Method,
}

impl<'a> Solver<'a> {
    fn new(assembly: &'a GearPair, cut: &'a CutPair, method: Method) -> Solver<'a> {
        let certify = method.proves();
        let exact = method != Method::Polygon;
        let polygon = matches!(method, Method::Polygon | Method::Both);
        let spur = !assembly.varies_along_face();
        let kernel = (exact || !spur).then(|| ExactKernel::new(assembly));
        let sections = (polygon || certify) && !spur;
        let places = kernel.as_ref().filter(|_| sections);
        Solver {
            assembly,
            polygon: (polygon && spur).then(|| cut.refined_kernel(assembly)),
            certifier: (certify && spur).then(|| Certifier::new(cut.kernel(assembly))),
            prover: kernel
                .as_ref()
                .filter(|_| certify || method == Method::Both)
                .map(|kernel| Prover::new(assembly, kernel)),
            sections: places.map(|kernel| CutSections {
                assembly,
                cut,
                places: kernel.sections(),
            }),
            kernel,
            guides: !exact,
            method,
        }
    }

    /// The contacts at `pose`, and the difference of the polygon method if both are used. `index` counts the poses of a sweep.
    fn find(&self, pose: &Pose, index: usize) -> Result<SolvedPose, Error> {
        // One budget for all work at this pose.
        let effort = Effort::of_pose();
        let kernel = self.kernel.as_ref();
        let found = kernel.map(|kernel| kernel.found_within(pose, &effort));
        let seen = found.as_ref().and_then(|found| found.as_ref().ok());
        let polygon = match (&self.sections, &self.polygon) {
            // Without a guide the sections are unknown.
            (Some(sections), _) if !self.method.proves() && (seen.is_some() || !self.guides) => {
                Some(sections.lost_motion(pose, seen, &effort))
            }
            (_, kernel) => kernel
                .as_ref()
                .map(|kernel| kernel.lost_motion_within(pose, &effort)),
        };
        let (exact, polygon) = if self.guides {
            (
                None,
                polygon.or_else(|| Some(found?.map(|found| found.lost_motion))),
            )
        } else {
            (found, polygon)
        };
        // A lost contact is kept as its reason; any other error ends the sweep.
        let exact = exact.map(settle).transpose()?;
        let polygon = polygon.map(settle).transpose()?;
        let jam = exact.as_ref().and_then(|found| found.as_ref().ok()?.jam);
        let exact = exact.map(|found| found.map(|found| found.lost_motion));
        let mut polygon_checked = polygon.is_some();
        let value = |found: &LostMotion| self.backlash(found);
        let found_by =
            |tried: &Option<Result<LostMotion, String>>| tried.as_ref().map(Result::is_ok);
        let one_alone = found_by(&exact).zip(found_by(&polygon));
        let one_alone = one_alone.is_some_and(|(exact, polygon)| exact != polygon);
        let found = match (exact, polygon) {
            (Some(Ok(exact)), Some(Ok(polygon))) => {
                return Ok(self.of_both(pose, exact, &polygon));
            }
            (Some(Ok(lost_motion)), None) => {
                let found = FoundOverFace { lost_motion, jam };
                let not_proven = match &self.prover {
                    Some(prover) => prover.check_within(pose, &lost_motion, &effort).err(),
                    None => None,
                };
                polygon_checked = self.method == Method::Checked
                    || self.method.proves() && index.is_multiple_of(POLYGONS_EVERY)
                    || not_proven.is_some();
                let refused = if polygon_checked {
                    self.certificate(pose, &found, &effort)?
                } else {
                    None
                };
                match refused {
                    None => Ok(lost_motion),
                    Some(reason) => Err(Unproven {
                        reason,
                        exact: value(&lost_motion),
                        polygon: None,
                    }),
                }
            }
            (None, Some(Ok(polygon))) => Ok(polygon),
            (exact, polygon) => {
                let reason = |name: &str, tried: &Option<Result<LostMotion, String>>| {
                    let reason = tried.as_ref()?.as_ref().err()?;
                    Some(format!("{name} method: {reason}"))
                };
                let reasons = [reason("exact", &exact), reason("polygon", &polygon)];
                let of = |tried: Option<Result<LostMotion, String>>| value(&tried?.ok()?);
                Err(Unproven {
                    reason: reasons.into_iter().flatten().collect::<Vec<_>>().join("; "),
                    exact: of(exact),
                    polygon: of(polygon),
                })
            }
        };
        Ok(SolvedPose {
            lost_motion: found,
            polygon_difference: one_alone.then_some(PolygonDifference::OneAlone),
            polygon_checked,
            proof: None,
        })
    }

    /// The exact result, if the polygons' result is within the allowed difference.
    fn of_both(&self, pose: &Pose, exact: LostMotion, polygon: &LostMotion) -> SolvedPose {
        let values = [self.backlash(&exact), self.backlash(polygon)];
        let bound = |found: &LostMotion| Some(found.error()? * self.pitch_radius());
        let (difference, reason) = match values {
            [Some(exact_value), Some(polygon_value)] => {
                let difference = polygon_value - exact_value;
                let bounds = [bound(&exact), bound(polygon)];
                let bounds: f64 = bounds.into_iter().flatten().sum();
                let allowed = bounds.max(METHODS_AGREE_WITHIN);
                let reason = (!(difference.abs() <= allowed)).then(|| {
                    format!(
                        "the exact and the polygon method differ by {:.3e} µm of j_wt, more than both error bounds, {:.1e} µm, and more than {:.0e} µm. {REPORT_PAIR}",
                        difference.abs() * 1e3,
                        bounds * 1e3,
                        METHODS_AGREE_WITHIN * 1e3
                    )
                });
                (PolygonDifference::Value(difference), reason)
            }
            _ if exact.status() == polygon.status() => (PolygonDifference::Value(0.0), None),
            _ => {
                let name = |found: &LostMotion| found.status().name().replace('_', " ");
                let reason = format!(
                    "the exact method finds {}, the polygon method {}. {REPORT_PAIR}",
                    name(&exact),
                    name(polygon)
                );
                (PolygonDifference::OneAlone, Some(reason))
            }
        };
        let unproven = |reason| Unproven {
            reason,
            exact: values[0],
            polygon: values[1],
        };
        SolvedPose {
            lost_motion: reason.map_or(Ok(exact), |reason| Err(unproven(reason))),
            polygon_difference: Some(difference),
            polygon_checked: true,
            proof: self.proof(pose, &exact),
        }
    }

    /// The proof of `found` by directions.
    fn proof(&self, pose: &Pose, found: &LostMotion) -> Option<Box<Proof>> {
        let proof = self.prover.as_ref()?.proof(pose, found);
        proof.ok().map(Box::new)
    }

    /// The reason why the certificate of `found` fails; `None` if it holds.
    fn certificate(
        &self,
        pose: &Pose,
        found: &FoundOverFace,
        effort: &Effort,
    ) -> Result<Option<String>, Error> {
        let checked = match (&self.certifier, &self.sections) {
            (Some(certifier), _) => certifier.check_within(pose, &found.lost_motion, effort),
            (None, Some(sections)) => sections.check(pose, found, effort),
            _ => return Ok(None),
        };
        Ok(settle(checked)?.err())
    }

    /// `j_wt = φ_j r_w` of the free gear, mm.
    fn backlash(&self, lost_motion: &LostMotion) -> Option<f64> {
        Some(lost_motion.angle()? * self.pitch_radius())
    }

    fn pitch_radius(&self) -> f64 {
        self.assembly.operating_pitch_radius(self.assembly.free())
    }
}

/// The result of a solver at a pose.
struct SolvedPose {
    lost_motion: Result<LostMotion, Unproven>,
    polygon_difference: Option<PolygonDifference>,
    polygon_checked: bool,
    proof: Option<Box<Proof>>,
}

/// A result, or its reason if the failure concerns this pose alone; otherwise the error.
fn settle<T>(tried: Result<T, Error>) -> Result<Result<T, String>, Error> {
    tried.map(Ok).or_else(|error| match error.pose_failure() {
        Some(reason) => Ok(Err(reason)),
        None => Err(error),
    })
}

/// The lost motion of `assembly` at each of `matings`, in their order, with any number of threads.
///
/// `cut` are the gears of `assembly`; `clearance` is the sum `c` of both radial bearing clearances, mm. `tick` is
/// called as each pose begins, from any thread; a break ends the sweep.
///
/// A pose is [`Unproven`] if its contact is lost, its certificate fails or both methods disagree. The other poses are still found.
///
/// # Errors
/// [`Error::Interrupted`] after a break; a centre distance `a − c` at which the base circles overlap.
pub fn sweep(
    assembly: &GearPair,
    cut: &CutPair,
    method: Method,
    matings: &[Mating],
    clearance: f64,
    tick: &Tick,
) -> Result<Vec<PoseResult>, Error> {
    let assembly = AssembledPair::from(assembly.clone());
    let mut all = Vec::with_capacity(matings.len());
    let each = &mut |poses: Vec<PoseResult>| {
        all.extend(poses);
        Ok::<(), Error>(())
    };
    sweep_blocks(&assembly, Some(cut), method, matings, clearance, tick, each)?;
    Ok(all)
}

/// Poses that are found before delivery (tuned: 2 MB; blocks of a tenth leave threads idle).
pub const BLOCK: usize = 4096;

/// [`sweep`] of any pair that delivers the poses to `each` in blocks of [`BLOCK`], so that they need not be kept.
///
/// Gears by data are cut for certificates if `cut` is `None`. A drawn gear needs no cut: its drawing is the only curve, and
/// polygons check every pose unless [`Method::Exact`] is not certified.
///
/// # Errors
/// As [`sweep`], and of `each`.
pub fn sweep_blocks<E: From<Error>>(
    assembly: &AssembledPair,
    cut: Option<&CutPair>,
    method: Method,
    matings: &[Mating],
    clearance: f64,
    tick: &Tick,
    each: &mut dyn FnMut(Vec<PoseResult>) -> Result<(), E>,
) -> Result<(), E> {
    let apart = |distance: f64| assembly.at(assembly.center_distance() + distance);
    if !(clearance > 0.0) {
        let here = |here: &dyn PoseSolver| each_pose(here, None, matings, tick, each);
        return with_solver(assembly, cut, method, here);
    }
    let [near, far] = [apart(-clearance)?, apart(clearance)?];
    with_solver(assembly, cut, method, |here| {
        with_solver(&near, cut, method, |near| {
            with_solver(&far, cut, method, |far| {
                each_pose(here, Some([near, far]), matings, tick, each)
            })
        })
    })
}

/// The result of `then` with the solver of `assembly`, whose gears are `cut`.
fn with_solver<T>(
    assembly: &AssembledPair,
    cut: Option<&CutPair>,
    method: Method,
    then: impl FnOnce(&dyn PoseSolver) -> T,
) -> T {
    match assembly {
        AssembledPair::Data(pair) => {
            let own;
            let cut = match cut {
                Some(cut) => cut,
                None => {
                    let [wheel, pinion] = Member::BOTH.map(|member| pair.gear(member));
                    own = CutPair::for_certificates(wheel, pinion);
                    &own
                }
            };
            then(&Solver::new(pair, cut, method))
        }
        AssembledPair::Drawn(pair) => {
            let kernel = OutlineKernel::new(pair);
            let certify = method != Method::Exact { certify: false };
            then(&OutlineSolver {
                pair,
                kernel: &kernel,
                certifier: certify.then(|| OutlineCertifier::new(&kernel)),
            })
        }
    }
}

/// The solver of a pair with a drawn gear.
struct OutlineSolver<'a> {
    pair: &'a OutlinePair,
    kernel: &'a OutlineKernel<'a>,
    certifier: Option<OutlineCertifier<'a>>,
}

/// Finds the lost motion at poses of one pair.
trait PoseSolver: Sync {
    /// The pose of `mating` and its result. `index` counts the poses of a sweep.
    fn find_at(&self, mating: &Mating, index: usize) -> Result<(Pose, SolvedPose), Error>;
    /// Operating pitch radius of the free gear, mm.
    fn pitch_radius(&self) -> f64;
    /// The proof by directions of what was found at `pose`, if the method gives one.
    fn proof_of(&self, pose: &Pose, found: &LostMotion) -> Option<Box<Proof>>;
}

impl PoseSolver for Solver<'_> {
    fn find_at(&self, mating: &Mating, index: usize) -> Result<(Pose, SolvedPose), Error> {
        let pose = Pose::new(self.assembly, *mating);
        Ok((pose, self.find(&pose, index)?))
    }

    fn pitch_radius(&self) -> f64 {
        Solver::pitch_radius(self)
    }

    fn proof_of(&self, pose: &Pose, found: &LostMotion) -> Option<Box<Proof>> {
        self.proof(pose, found)
    }
}

impl PoseSolver for OutlineSolver<'_> {
    fn find_at(&self, mating: &Mating, _: usize) -> Result<(Pose, SolvedPose), Error> {
        let found = self
            .kernel
            .lost_motion(mating)
            .map_err(|why| why.to_string());
        let found = found.and_then(|found| match &self.certifier {
            Some(certifier) => match certifier.check(mating, &found) {
                Ok(()) => Ok(found),
                Err(why) => Err(why.to_string()),
            },
            None => Ok(found),
        });
        let solved = SolvedPose {
            lost_motion: found.map_err(|reason| Unproven {
                reason,
                exact: None,
                polygon: None,
            }),
            polygon_difference: None,
            polygon_checked: self.certifier.is_some(),
            proof: None,
        };
        Ok((self.pair.pose(*mating), solved))
    }

    fn pitch_radius(&self) -> f64 {
        self.pair.operating_pitch_radius(self.pair.free())
    }

    fn proof_of(&self, _: &Pose, _: &LostMotion) -> Option<Box<Proof>> {
        None
    }
}

/// Delivers to `each` the results of `here` at `matings`, with those at both `ends` of the bearing clearance.
fn each_pose<E: From<Error>>(
    here: &dyn PoseSolver,
    ends: Option<[&dyn PoseSolver; 2]>,
    matings: &[Mating],
    tick: &Tick,
    each: &mut dyn FnMut(Vec<PoseResult>) -> Result<(), E>,
) -> Result<(), E> {
    let find = |(index, mating): (usize, &Mating)| {
        Error::if_stopped(tick(1))?;
        pose_result(here, ends, mating, index)
    };
    for block in matings.chunks(BLOCK) {
        let poses = parallel::map(block.iter().enumerate(), find).into_iter();
        each(poses.collect::<Result<_, Error>>()?)?;
    }
    Ok(())
}

/// The result of `here` at `mating`, with those at both `ends` of the bearing clearance.
fn pose_result(
    here: &dyn PoseSolver,
    ends: Option<[&dyn PoseSolver; 2]>,
    mating: &Mating,
    index: usize,
) -> Result<PoseResult, Error> {
    let (pose, found) = here.find_at(mating, index)?;
    let backlash =
        |solver: &dyn PoseSolver, found: &LostMotion| Some(found.angle()? * solver.pitch_radius());
    let at_end = |end: &dyn PoseSolver| -> Result<Result<Option<f64>, Unproven>, Error> {
        let (_, found) = end.find_at(mating, index)?;
        Ok(found.lost_motion.map(|found| backlash(end, &found)))
    };
    let with_clearance = match ends {
        None => None,
        Some([near, far]) => Some([at_end(near)?, at_end(far)?]),
    };
    let lost_motion = found.lost_motion.as_ref().ok();
    let j_wt = lost_motion.and_then(|found| backlash(here, found));
    let error = j_wt.and(lost_motion).and_then(LostMotion::error);
    Ok(PoseResult {
        pose,
        backlash: j_wt,
        error_bound: error.map(|error| error * here.pitch_radius()),
        found: found.lost_motion,
        with_clearance,
        polygon_difference: found.polygon_difference,
        polygon_checked: found.polygon_checked,
        proof: found.proof,
    })
}

/// Lost motion of `pair` where the teeth of `mating` meet, by [`Method::Checked`]. For many poses use [`sweep_blocks`].
///
/// The result of gears by data keeps its proof by directions.
///
/// # Errors
/// None for a pose: an unproven one is [`Unproven`] in the result.
pub fn lost_motion_at(pair: &AssembledPair, mating: Mating) -> Result<PoseResult, Error> {
    with_solver(pair, None, Method::Checked, |here| {
        let mut result = pose_result(here, None, &mating, 0)?;
        if let Ok(found) = &result.found {
            result.proof = here.proof_of(&result.pose, found);
        }
        Ok(result)
    })
}
