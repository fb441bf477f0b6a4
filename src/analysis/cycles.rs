//! The mesh cycles of a study, and the search of each: at its centre distance, and at both ends of the bearing clearance.

use super::assembles_from::{
    AtDistance, Threshold, assembles_from, assembles_from_of_outlines, meshes_to,
};
use super::axes::{Axes, Axis, BearingEnds};
use super::directions::{self, AnyDirection, PosedPair, Poses, Search, has_open_runout};
use super::face_loss::FaceLoss;
use super::phases::phase;
use super::study::{Run, RunPlan, Study};
use crate::analytic::InvolutePair;
use crate::contact::{
    Doubt, Effort, End, ExactKernel, Extreme, Extremes, OutlineCycle, OutlineKernel, PROVEN_WIDTH,
    PROVEN_WIDTH_DRAWN, Status, cycle_extremes, cycle_extremes_within, first_least,
};
use crate::error::{Error, Tick, go_on};
use crate::gear::{Side, has_different_teeth, thickness};
use crate::outline::{AssembledPair, OutlinePair};
use crate::pair::{FaceDeviation, GearPair, Mating, Member, ToothNumbers};

/// Width of a proven bracket of `j_wt`, mm.
pub const WIDTH: f64 = PROVEN_WIDTH;

/// Width, mm, of a bracket of the greatest `j_wt` that proves a pair in mesh: any finite one does.
const IN_MESH: f64 = 0.1;

/// Width, mm, of a bracket of `j_wt` of `assembly` that counts as proven.
pub fn proven_width(assembly: &AssembledPair) -> f64 {
    match assembly {
        AssembledPair::Data(_) => PROVEN_WIDTH,
        AssembledPair::Drawn(_) => PROVEN_WIDTH_DRAWN,
    }
}

/// A pair whose mesh cycle is searched. Gears by data and drawn gears have a kernel each.
pub(super) trait CyclePair {
    /// The search of `cycle`, over all leans of the axes that are open.
    fn search(&self, cycle: &CyclePlan) -> Result<CycleResult, Error>;

    /// The extremes over `cycle` for this pair, in place of the pair of the cycle, and over all open leans of its axes. Without an open runout
    /// the other end may be missing.
    fn extremes_at(&self, cycle: &CyclePlan, end: End, effort: &Effort) -> Result<Extremes, Error>;

    /// The extremes over these matings, in brackets of about `width` mm. If the direction of a runout is unknown, they cover all directions.
    fn extremes(&self, over: (Mating, u64), width: f64) -> Result<Extremes, Error>;

    /// Whether wheel and pinion have unlike teeth.
    fn have_unlike_teeth(&self) -> [bool; 2];

    /// Effort of a change that meets the requirements: as much as one verdict may take.
    fn effort_of_remedy<'t>(&self, cycle: &CyclePlan<'t>) -> Effort<'t>;

    /// How its teeth get thinner; `None` if only one gear's can.
    fn thinned_teeth(&self) -> Option<ThinnedTeeth>;
}

/// How teeth get thinner. The variable is the reduction of thickness or of a flank offset from nominal, mm, so that backlash grows with it.
pub(super) struct ThinnedTeeth {
    /// Material of wheel and pinion beyond nominal: the negative of their reduction.
    pub material: [f64; 2],
    /// The greatest further reduction.
    pub most: f64,
    /// `dj_wt` per reduction of one gear.
    pub slope: f64,
    /// Reduction per flank offset.
    pub per_offset: f64,
    /// Tooth thickness per reduction.
    pub thickness: f64,
}

/// `assembly` as its kernel searches it.
pub(super) fn cycle_pair(assembly: &AssembledPair) -> &dyn CyclePair {
    match assembly {
        AssembledPair::Data(pair) => pair,
        AssembledPair::Drawn(pair) => pair,
    }
}

impl CyclePair for OutlinePair {
    fn search(&self, cycle: &CyclePlan) -> Result<CycleResult, Error> {
        let kernel = OutlineKernel::new(self);
        let over = cycle_of_outlines(self, cycle.over, (cycle.divisor, cycle.tick));
        let found = over.extremes(&kernel, self, cycle.wanted, PROVEN_WIDTH_DRAWN);
        let (mut assembles_from, mut to) = (None, None);
        if !cycle.is_alone {
            assembles_from = assembles_from_of_outlines(&kernel, self, &over, &found)?;
            let pose = |at, mating: &Mating| Ok(kernel.lost_motion_at(&self.at(at)?, mating).ok());
            let search = |at| {
                let (there, ends) = (self.at(at)?, &[End::Greatest]);
                Ok(over.extremes(&kernel, &there, ends, IN_MESH))
            };
            let nearest = self.tip_on_root().max(self.least_distance() + WIDTH);
            let between = [nearest, self.center_distance()];
            let at_distance = AtDistance {
                pose: &pose,
                search: &search,
                onward: &|mating, pitches| mating.onward(self, pitches),
                pitches: cycle.over.1,
                tick: cycle.tick,
            };
            to = meshes_to(between, &found, &at_distance, &Effort::endless())?;
        }
        Ok(CycleResult {
            poses: cycle.poses_of(&found, assembles_from),
            found,
            assembles_from,
            meshes_to: to,
            effort: 0,
            face_loss: None,
        })
    }

    fn extremes_at(&self, cycle: &CyclePlan, end: End, _: &Effort) -> Result<Extremes, Error> {
        let over = cycle_of_outlines(self, cycle.over, (cycle.divisor, cycle.tick));
        Ok(over.extremes(&OutlineKernel::new(self), self, &[end], PROVEN_WIDTH_DRAWN))
    }

    fn extremes(&self, over: (Mating, u64), width: f64) -> Result<Extremes, Error> {
        let over = cycle_of_outlines(self, over, (1, &go_on));
        let width = width.max(PROVEN_WIDTH_DRAWN);
        Ok(over.extremes(&OutlineKernel::new(self), self, &End::BOTH, width))
    }

    fn have_unlike_teeth(&self) -> [bool; 2] {
        Member::BOTH.map(|member| !self.gear(member).tooth_classes().is_one())
    }

    /// Each search has its own.
    fn effort_of_remedy<'t>(&self, _: &CyclePlan<'t>) -> Effort<'t> {
        Effort::endless()
    }

    /// By the flank offset alone, which changes a tooth's thickness on both sides.
    fn thinned_teeth(&self) -> Option<ThinnedTeeth> {
        let [wheel, pinion] = Member::BOTH.map(|member| self.gear(member));
        Some(ThinnedTeeth {
            material: [wheel.flank_offset()?, pinion.flank_offset()?],
            most: 0.25 * MOST_THICKNESS * wheel.pitch() * wheel.root_radius(),
            slope: 4.0 * DRAWN_SLOPE,
            per_offset: 1.0,
            thickness: 2.0,
        })
    }
}

impl CyclePair for GearPair {
    fn search(&self, cycle: &CyclePlan) -> Result<CycleResult, Error> {
        if cycle.open_lean != [0.0; 2] {
            return cycle.over_axes(&Axes::new(self, cycle.open_lean, None), self);
        }
        let mut searched = cycle.search_as_stated(self)?;
        searched.face_loss = cycle.face_loss(self, &searched.found)?;
        Ok(searched)
    }

    fn extremes_at(&self, cycle: &CyclePlan, end: End, effort: &Effort) -> Result<Extremes, Error> {
        if cycle.open_lean != [0.0; 2] {
            let wanted: &[End] = match end {
                End::Least => &[End::Least],
                End::Greatest => &[End::Greatest],
            };
            let whole = Effort::of_extremes(self, cycle.tick).left();
            let divisor = AXES * whole / (effort.left() / PARTS_OF_REST).max(1);
            let there = CyclePlan {
                wanted,
                divisor: divisor.max(1),
                is_alone: true,
                ..cycle.with(self.clone().into())
            };
            let searched = there.search()?;
            effort.spend(searched.effort);
            return Ok(searched.found);
        }
        if has_open_runout(self) {
            return Ok(any_direction(self, cycle.over, cycle.wanted, WIDTH, effort)?.found);
        }
        let kernel = &ExactKernel::new(self);
        cycle_extremes_within(kernel, self, cycle.over, WIDTH, effort, &[end])
    }

    fn extremes(&self, over: (Mating, u64), width: f64) -> Result<Extremes, Error> {
        if has_open_runout(self) {
            let effort = &Effort::of_extremes(self, &go_on);
            Ok(any_direction(self, over, &End::BOTH, width, effort)?.found)
        } else {
            // A population has thousands of cycles, too many for searches of outlines.
            cycle_extremes(&ExactKernel::new(self), self, over.0, over.1, width)
        }
    }

    /// An eccentricity alone, in any direction, keeps all teeth equal.
    fn have_unlike_teeth(&self) -> [bool; 2] {
        Member::BOTH.map(|one| has_different_teeth(&self.gear(one).centred()))
    }

    fn effort_of_remedy<'t>(&self, cycle: &CyclePlan<'t>) -> Effort<'t> {
        let places = if cycle.open_lean == [0.0; 2] { 1 } else { AXES };
        let one = Effort::of_extremes(self, cycle.tick).left();
        Effort::new(places * one, cycle.tick)
    }

    /// By the allowance.
    fn thinned_teeth(&self) -> Option<ThinnedTeeth> {
        let wheel = self.gear(Member::Wheel).gear();
        let basic_data = wheel.basic_data();
        let per_allowance = thickness::per_normal_thickness(basic_data);
        let allowance = |member: Member| thickness::allowance(self.gear(member).gear());
        Some(ThinnedTeeth {
            material: Member::BOTH.map(allowance),
            most: MOST_THICKNESS * wheel.base_thickness() / per_allowance,
            slope: per_allowance / self.operating_pressure_angle().cos(),
            // Two offsets along the normals increase the base tooth thickness like an allowance.
            per_offset: thickness::base_from_span(basic_data, 1, 2.0) / per_allowance,
            thickness: 1.0,
        })
    }
}

/// Increase of a drawn pair's backlash with the distance, from which searches start: `2 tan α_wt` of 14°.
pub(super) const DRAWN_SLOPE: f64 = 0.5;

/// Greatest change of a tooth's thickness, as a part of its base tooth thickness.
const MOST_THICKNESS: f64 = 0.5;

/// Places of open axes that are searched, about.
const AXES: u64 = 8;

/// Parts of the remaining effort of which one search of open axes takes one (tuned).
const PARTS_OF_REST: u64 = 4;

/// A run and the start of its cycle.
#[derive(Clone)]
pub(super) struct CyclePlan<'t> {
    pub run: Run,
    /// The first mating of the cycle, and the number of distinct ones.
    over: (Mating, u64),
    /// Whether the pair has several distinct assembly phases.
    has_distinct_phases: bool,
    /// Number of phases of the same pair that are searched; they share the effort of one pair.
    phases: u64,
    /// Its assembly phase, if several are searched.
    pub phase: Option<(u32, u32)>,
    /// [`Study::open_lean`].
    open_lean: [f64; 2],
    /// [`Study::bearing_ends`].
    bearing_ends: Option<BearingEnds>,
    /// The extremes to search.
    pub wanted: &'static [End],
    /// Divisor of the effort.
    pub divisor: u64,
    /// Whether the extremes alone are searched: no distances that follow from them, and no losses along the face.
    pub is_alone: bool,
    tick: &'t Tick<'t>,
}

/// Extremes of a cycle.
pub(super) struct CycleResult {
    /// Units of effort used.
    pub effort: u64,
    pub found: Extremes,
    pub poses: Poses,
    pub assembles_from: Option<Threshold>,
    pub meshes_to: Option<Threshold>,
    pub face_loss: Option<FaceLoss>,
}

/// Extremes at one end of the bearing clearance.
pub(super) struct SearchedEnd {
    /// The pair there.
    pub assembly: AssembledPair,
    pub status: Status,
    pub extreme: Option<Extreme>,
    /// The pose of that extreme.
    pub pose: Option<PosedPair>,
}

/// The status that says more of the worst pose.
pub(super) fn worse(one: Status, other: Status) -> Status {
    let ranked = [
        Status::Clear,
        Status::Interference,
        Status::Unproven,
        Status::NoContact,
        Status::Jammed,
    ];
    let rank = |status| ranked.iter().position(|ranked| *ranked == status);
    if rank(other) > rank(one) { other } else { one }
}

impl CycleResult {
    /// One end of the bearing clearance of `pair`.
    fn clearance_end(&self, pair: &AssembledPair, end: End) -> SearchedEnd {
        let pose = self.poses[end as usize].clone();
        let assembly = pose.as_ref().map_or(pair, |pose| &pose.assembly);
        SearchedEnd {
            assembly: assembly.clone(),
            status: self.found.status,
            extreme: self.found.at(end),
            pose,
        }
    }
}

impl<'t> CyclePlan<'t> {
    /// Wheel and pinion tooth that name its assembly phase; `None` if the pair has only one, or all are equal.
    pub fn own_phase(&self) -> Option<(u32, u32)> {
        self.has_distinct_phases
            .then_some((self.over.0.wheel_tooth, self.over.0.pinion_tooth))
    }

    /// The extremes, over all leans of the axes that are open.
    pub fn search(&self) -> Result<CycleResult, Error> {
        let searched = cycle_pair(&self.run.assembly).search(self)?;
        // A search that was stopped has less effort.
        Error::if_stopped((self.tick)(0))?;
        Ok(searched)
    }

    /// The extremes of `pair` over all places of its axes. The bounds are derived in [`super::axes`].
    fn over_axes(&self, axes: &Axes, pair: &GearPair) -> Result<CycleResult, Error> {
        let here = |axis: &Axis| {
            let there = axis.of(pair)?;
            self.as_stated(there.clone()).search_as_stated(&there)
        };
        let all = |list: &[Axis]| {
            list.iter()
                .map(here)
                .collect::<Result<Vec<CycleResult>, Error>>()
        };
        let (possible, corners) = (all(&axes.possible)?, all(&axes.corners)?);
        let slack = axes.second_order_bound(pair) / pair.operating_pressure_angle().cos();
        let every = || possible.iter().chain(&corners);
        let status = every()
            .map(|one| one.found.status)
            .fold(Status::Clear, worse);
        let is_lost = |one: &&CycleResult| one.found.lost.is_some() && one.found.status == status;
        let lost = possible.iter().find(is_lost);
        let lost = lost.and_then(|one| one.poses[2].clone());
        let best = |end: End, hidden: Status| {
            let each = possible.iter().filter(|_| status != hidden);
            let each = each.filter_map(|one| {
                let (pose, extreme) = (one.poses[end as usize].as_ref()?, one.found.at(end)?);
                Some(((extreme, pose), end.sign() * extreme.found, 0.0))
            });
            let best = first_least(each);
            best.map(|(extreme, pose)| (extreme, pose.clone())).unzip()
        };
        let (least, least_pose) = best(End::Least, Status::Jammed);
        let (greatest, greatest_pose) = best(End::Greatest, Status::NoContact);
        let low = every().map(|one| one.found.least.map_or(f64::NEG_INFINITY, |least| least.low));
        let possible_ends = |end: End| {
            possible
                .iter()
                .filter_map(move |one: &CycleResult| one.found.at(end))
        };
        let high = possible_ends(End::Least).map(|least| least.high);
        let least = least.map(|extreme| Extreme {
            low: low.fold(f64::INFINITY, f64::min) - slack,
            high: high.fold(f64::INFINITY, f64::min),
            ..extreme
        });
        let low = possible_ends(End::Greatest).map(|greatest| greatest.low);
        let low = low.fold(f64::NEG_INFINITY, f64::max);
        let greatest = match greatest {
            Some(extreme) => Some(Extreme {
                low,
                high: self.section_bound(axes, pair)?.max(low),
                ..extreme
            }),
            None => None,
        };
        let doubted = |extreme: Extreme| Extreme {
            doubt: extreme
                .doubt
                .or((!extreme.is_proven()).then_some(Doubt::Axes)),
            ..extreme
        };
        let from = possible.iter().filter_map(|one| one.assembles_from);
        let to = possible.iter().filter_map(|one| one.meshes_to);
        let value = |one: &CycleResult| one.found.least.map_or(f64::INFINITY, |least| least.found);
        let tightest = possible
            .iter()
            .zip(&axes.possible)
            .min_by(|(one, _), (other, _)| value(one).total_cmp(&value(other)));
        let face_loss = match tightest {
            Some((one, axis)) => {
                let pair = axis.of(pair)?;
                self.as_stated(pair.clone()).face_loss(&pair, &one.found)?
            }
            None => None,
        };
        Ok(CycleResult {
            effort: every().map(|one| one.effort).sum(),
            face_loss,
            found: Extremes {
                matings: possible.first().map_or(0, |one| one.found.matings),
                status,
                least: least.map(doubted),
                greatest: greatest.map(doubted),
                lost: lost.as_ref().map(|pose| pose.mating),
            },
            poses: [least_pose, greatest_pose, lost, None],
            assembles_from: Threshold::farthest(from),
            meshes_to: Threshold::nearest(to),
        })
    }

    /// Upper bound of `j_wt`, mm, by one section.
    fn section_bound(&self, axes: &Axes, pair: &GearPair) -> Result<f64, Error> {
        let section = axes.section(pair)?;
        let radii = [pair, &section].map(|pair| pair.operating_pitch_radius(pair.free()));
        let (cycle, effort) = (self.as_stated(section.clone()), &self.effort(&section));
        let found = section.extremes_at(&cycle, End::Greatest, effort)?;
        let high = found
            .greatest
            .map_or(f64::INFINITY, |greatest| greatest.high);
        let more = axes.contact_height_bound(pair) / pair.operating_pressure_angle().cos();
        // The lost motion of a section at a greater distance is that at a lesser radius.
        Ok(high * (radii[0] / radii[1]).max(1.0) + more)
    }

    /// This cycle of another pair with the same teeth, whose axes are where it states them.
    fn as_stated(&self, pair: GearPair) -> CyclePlan<'t> {
        CyclePlan {
            open_lean: [0.0; 2],
            bearing_ends: None,
            ..self.with(pair.into())
        }
    }

    /// This cycle of another pair with the same teeth.
    fn with(&self, assembly: AssembledPair) -> CyclePlan<'t> {
        CyclePlan {
            run: Run {
                assembly,
                ..self.run.clone()
            },
            ..self.clone()
        }
    }

    /// The search with the axes where `pair` states them, without the losses along the face.
    fn search_as_stated(&self, pair: &GearPair) -> Result<CycleResult, Error> {
        let effort = &self.effort(pair);
        let all = if has_open_runout(pair) {
            any_direction(pair, self.over, self.wanted, WIDTH, effort)?
        } else {
            let (kernel, over) = (&ExactKernel::new(pair), self.over);
            let found = cycle_extremes_within(kernel, pair, over, WIDTH, effort, self.wanted)?;
            AnyDirection {
                poses: Poses::default(),
                ends: [Some((pair.clone(), found)), Some((pair.clone(), found))],
                off: 0.0,
                found,
            }
        };
        let [near, far] = &all.ends;
        let from = near.as_ref().map(|(near, nearest)| {
            let from = self.assembles_from(near, nearest, effort)?;
            Ok::<_, Error>(from.map(|from| from.farther(all.off)))
        });
        let to = far.as_ref().map(|(far, farthest)| {
            let to = self.meshes_to(far, farthest, effort)?;
            Ok::<_, Error>(to.map(|to| to.farther(-all.off)))
        });
        let assembles_from = from.transpose()?.flatten();
        Ok(CycleResult {
            poses: if has_open_runout(pair) {
                all.poses
            } else {
                self.poses_of(&all.found, assembles_from)
            },
            assembles_from,
            meshes_to: to.transpose()?.flatten(),
            effort: effort.used(),
            face_loss: None,
            found: all.found,
        })
    }

    /// The loss of the least `found` by deviations along the face; `None` for a pair without any.
    fn face_loss(&self, pair: &GearPair, found: &Extremes) -> Result<Option<FaceLoss>, Error> {
        if self.is_alone || !pair.deviates_along_face() {
            return Ok(None);
        }
        let held = |found: &Extremes| {
            let holds = |least: &Extreme| least.low.is_finite() && least.high.is_finite();
            Some(found.least.filter(holds)?.found)
        };
        let without = |kinds: &[FaceDeviation]| {
            let pair = pair.without(kinds);
            let effort = &self.effort(&pair);
            Ok(held(&pair.extremes_at(self, End::Least, effort)?))
        };
        FaceLoss::new(|kind| pair.has(kind), held(found), without).map(Some)
    }

    /// The poses of `found`, and the binding pose at the distance from which the pair assembles. Checks that search distances use the latter.
    fn poses_of(&self, found: &Extremes, from: Option<Threshold>) -> Poses {
        let [least, greatest] = End::BOTH.map(|end| found.at(end).map(|extreme| extreme.mating));
        let matings = [least, greatest, found.lost, from.map(|from| from.mating)];
        matings.map(|mating| {
            Some(PosedPair {
                assembly: self.run.assembly.clone(),
                mating: mating?,
            })
        })
    }

    /// The least with the axes nearer by `clearance`, mm, and the greatest with them further apart by it. Backlash grows with the distance,
    /// so no pose in between has less or more.
    pub fn at_clearance_ends(&self, clearance: f64) -> Result<[SearchedEnd; 2], Error> {
        if let (AssembledPair::Data(pair), Some(_)) = (&self.run.assembly, self.bearing_ends) {
            let axes = Axes::new(pair, self.open_lean, self.bearing_ends);
            let searched = self.over_axes(&axes, pair)?;
            return Ok(End::BOTH.map(|end| searched.clearance_end(&self.run.assembly, end)));
        }
        Ok([
            self.at_clearance_end(-clearance, End::Least)?,
            self.at_clearance_end(clearance, End::Greatest)?,
        ])
    }

    fn at_clearance_end(&self, farther: f64, end: End) -> Result<SearchedEnd, Error> {
        let assembly = &self.run.assembly;
        let there = CyclePlan {
            is_alone: true,
            ..self.with(assembly.at(assembly.center_distance() + farther)?)
        };
        let end = there.search()?.clearance_end(&there.run.assembly, end);
        if self.open_lean != [0.0; 2] {
            return Ok(end);
        }
        // The pair itself, not that with its high teeth at the worst place.
        let assembly = there.run.assembly;
        Ok(SearchedEnd { assembly, ..end })
    }

    /// Effort of the search of `assembly`.
    fn effort(&self, assembly: &GearPair) -> Effort<'t> {
        Effort::of_extremes(assembly, self.tick).part(self.phases * self.divisor)
    }

    /// The distance from which `pair`, with the result `found`, assembles.
    fn assembles_from(
        &self,
        pair: &GearPair,
        found: &Extremes,
        effort: &Effort,
    ) -> Result<Option<Threshold>, Error> {
        let least = found.least.map(|least| least.low);
        let is_clear = least.is_some_and(|least| least >= 0.0);
        if self.is_alone || found.status == Status::NoContact || is_clear {
            return Ok(None);
        }
        // A pair that needs no search has as much effort once more: with a share of the rest, what can be proven would not be.
        let own = &self.effort(pair);
        let is_short = !pair.varies_along_face() && ExactKernel::new(pair).is_direct();
        let effort = if is_short { own } else { effort };
        assembles_from(pair, self.over, least, 0.1 * WIDTH, effort)
    }

    /// The distance up to which `pair`, with the result `found`, is in mesh.
    fn meshes_to(
        &self,
        pair: &GearPair,
        found: &Extremes,
        effort: &Effort,
    ) -> Result<Option<Threshold>, Error> {
        let nearest = InvolutePair::of(pair).center_distance(0.0);
        let Some(nearest) = nearest.filter(|_| !self.is_alone) else {
            return Ok(None);
        };
        let kernel = ExactKernel::new(pair);
        let pose = |at, mating: &Mating| {
            let there = pair.at(at)?;
            kernel.at(&there).lost_motion_at(&there, *mating)
        };
        let search = |at| {
            let there = pair.at(at)?;
            let (kernel, ends) = (kernel.at(&there), &[End::Greatest]);
            cycle_extremes_within(&kernel, &there, self.over, IN_MESH, effort, ends)
        };
        let at_distance = AtDistance {
            pose: &pose,
            search: &search,
            onward: &|mating, pitches| mating.onward(pair, pitches),
            pitches: self.over.1,
            tick: self.tick,
        };
        let between = [nearest, pair.center_distance()];
        meshes_to(between, found, &at_distance, effort)
    }
}

/// Every centre distance and material in every assembly phase of the study: those of its listed matings, or all.
pub(super) fn plans<'t>(study: &Study, tick: &'t Tick) -> Result<Vec<CyclePlan<'t>>, Error> {
    let mut plans: Vec<CyclePlan> = Vec::new();
    for RunPlan { run, matings } in study.runs()? {
        let mut phases: Vec<u32> = if study.all_phases {
            (1..=run.assembly.phase_count()).collect()
        } else {
            let matings = matings.iter();
            matings.map(|mating| phase(&run.assembly, mating)).collect()
        };
        phases.sort_unstable();
        phases.dedup();
        // Against perfect teeth the mating tooth does not matter.
        let distinct = distinct(&run.assembly);
        let has_distinct_phases = run.assembly.phase_count() > 1 && phases_differ(&run.assembly);
        if !has_distinct_phases {
            phases.truncate(1);
        }
        // A run of one phase among all has the others beside it.
        let count = match run.phase {
            Some(_) => u64::from(run.assembly.phase_count()),
            None => phases.len() as u64,
        };
        for pinion_tooth in phases {
            let first = first_of_phase(pinion_tooth);
            let own = (count > 1).then_some((first.wheel_tooth, first.pinion_tooth));
            plans.push(CyclePlan {
                phase: run.phase.or(own),
                run: run.clone(),
                over: (first, distinct),
                has_distinct_phases,
                phases: count,
                open_lean: study.open_lean,
                bearing_ends: study.bearing_ends,
                wanted: &End::BOTH,
                divisor: 1,
                is_alone: false,
                tick,
            });
        }
    }
    Ok(plans)
}

/// The extremes of one pair over the mesh cycle on which the right flank of wheel tooth 1 meets that of pinion tooth `phase`, in brackets
/// of about `width` mm. If the direction of a runout is unknown, they cover all directions.
///
/// # Errors
/// As [`cycle_extremes`](crate::contact::cycle_extremes).
pub fn extremes_of_phase(
    assembly: &AssembledPair,
    phase: u32,
    width: f64,
) -> Result<Extremes, Error> {
    let over = (first_of_phase(phase), distinct(assembly));
    cycle_pair(assembly).extremes(over, width)
}

/// The cycle of a pair with a drawn gear: its first mating, and the number of distinct ones.
fn cycle_of_outlines<'t>(
    pair: &OutlinePair,
    (first, distinct): (Mating, u64),
    (parts_of_effort, tick): (u64, &'t Tick),
) -> OutlineCycle<'t> {
    OutlineCycle {
        first,
        distinct,
        matings: pair.hunting_pitches(),
        parts_of_effort,
        tick,
        classes: [pair.locked(), pair.free()].map(|member| pair.gear(member).tooth_classes()),
    }
}

/// The extremes `ends` of `pair` over matings and all directions of its runout, in brackets of about `width` mm.
fn any_direction(
    pair: &GearPair,
    over: (Mating, u64),
    ends: &[End],
    width: f64,
    effort: &Effort,
) -> Result<AnyDirection, Error> {
    // The bracket contains that of a search and the effect of the direction.
    let width = 0.4 * width;
    let search: &Search =
        &|pair, kernel, end| cycle_extremes_within(kernel, pair, over, width, effort, &[end]);
    directions::extremes(pair, ends, search)
}

/// The mating of wheel tooth 1 that names an assembly phase.
fn first_of_phase(pinion_tooth: u32) -> Mating {
    Mating::at(1, pinion_tooth, Side::Right)
}

/// Whether the extremes over the cycle depend on the assembly phase. They do not if all teeth of one gear are equal.
pub(crate) fn phases_differ(assembly: &AssembledPair) -> bool {
    cycle_pair(assembly).have_unlike_teeth() == [true, true]
}

/// Number of distinct matings; after them every deviation of both gears recurs.
pub(super) fn distinct(assembly: &AssembledPair) -> u64 {
    let teeth = |member| u64::from(assembly.teeth(member));
    match cycle_pair(assembly).have_unlike_teeth() {
        [true, true] => assembly.hunting_pitches(),
        [true, false] => teeth(Member::Wheel),
        [false, true] => teeth(Member::Pinion),
        [false, false] => 1,
    }
}
