//! The evidence of a run's poses for the checks, so that the poses need not be kept.

use super::contact_count::ContactCount;
use crate::analysis::compare::{ComparedPose, ComparedRun};
use crate::analysis::study::Material;
use crate::contact::{
    Contact, ContactClass, ContactKind, ExactKernel, FacePlace, LostMotion, ToothPlace, Unproven,
};
use crate::error::{Error, Tick};
use crate::gear::Side;
use crate::numeric::GOLDEN;
use crate::pair::{GearPair, Mating, Member, Pose, ToothNumbers};
use crate::parallel;
use std::collections::HashSet;

/// Contacts whose radii differ by less than this, mm, count as at one radius. Platforms round differently; so all of them name the first.
const EQUAL_RADIUS: f64 = 1e-9;

/// Poses over the cycle for the share of each end of the face (tuned: a percent).
const CYCLE_POSES: u32 = 128;

/// The evidence of poses of one centre distance and material.
#[derive(Debug, Clone, PartialEq)]
pub struct PoseEvidence {
    /// The pair.
    pub assembly: GearPair,
    /// The thickness.
    pub material: Material,
    /// Counts of the contacts, and their cost.
    pub contact: ContactCount,
    /// Least `j_wt`, mm, of these poses and of the cycle's extremes; `None` if no pose has one.
    pub least: Option<f64>,
    /// Unproven poses.
    pub(super) unproven: usize,
    /// The first unproven pose, and the reason.
    pub(super) first_unproven: Option<(Mating, Unproven)>,
    /// Contacts on the wheel and on the pinion.
    touched: [Touched; 2],
    /// Contacts of right and of left flanks by their place along the face, in the order of [`FacePlace::ALL`].
    pub(super) places: [[usize; FacePlace::ALL.len()]; 2],
    /// Whether a contact of the cycle's extremes is at an end of the face.
    pub(super) extreme_at_end: bool,
    /// Sections, mm, of the right and the left contact at the cycle's least.
    pub(super) least_sections: Option<[f64; 2]>,
}

/// The contacts on one gear.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Touched {
    /// Poses with contact below its involute, including the edge of an undercut flank.
    pub below: usize,
    /// Greatest and least radius of a contact, mm.
    pub greatest: Option<f64>,
    pub least: Option<f64>,
    /// Pairs of teeth with contact below the involute, and the first of the contacts nearest to the root.
    pub pairs: HashSet<(u32, u32)>,
    pub lowest: Option<Contact>,
}

impl PoseEvidence {
    /// The evidence before the first pose of `assembly`.
    pub fn new(assembly: &GearPair, material: Material) -> PoseEvidence {
        PoseEvidence {
            assembly: assembly.clone(),
            material,
            contact: ContactCount::default(),
            least: None,
            unproven: 0,
            first_unproven: None,
            touched: Default::default(),
            places: Default::default(),
            extreme_at_end: false,
            least_sections: None,
        }
    }

    /// The evidence of the poses of `run`; `None` for a pair with a drawn gear.
    pub fn of(run: &ComparedRun) -> Option<PoseEvidence> {
        let mut evidence = PoseEvidence::new(run.run.assembly.data()?, run.run.material);
        run.poses.iter().for_each(|pose| evidence.add(pose));
        Some(evidence)
    }

    /// Its centre distance, mm, and its material.
    pub(super) fn group_key(&self) -> (f64, Material) {
        (self.assembly.center_distance(), self.material)
    }

    /// Adds a pose.
    pub(crate) fn add(&mut self, pose: &ComparedPose) {
        let result = &pose.simulated;
        self.contact.add(&self.assembly, self.material, pose);
        self.least = least(self.least, result.backlash);
        if result.is_unproven() {
            self.unproven += 1;
            if self.first_unproven.is_none() {
                let why = result.unproven().next();
                self.first_unproven = why.map(|why| (*result.pose.mating(), why.clone()));
            }
        }
        let Some(found) = result.proven() else {
            return;
        };
        self.count(places(&self.assembly, &result.pose, Some(found)));
        for (touched, member) in self.touched.iter_mut().zip(Member::BOTH) {
            let mut is_below = false;
            for side in Side::BOTH {
                if let Some(contact) = found.on(side) {
                    is_below |= touched.add(&self.assembly, member, side, &contact);
                }
            }
            touched.below += usize::from(is_below);
        }
    }

    /// Adds the least `j_wt` of the cycle from the poses of `extremes`, if they have any.
    pub(super) fn with_least_of(mut self, extremes: &[ComparedRun]) -> PoseEvidence {
        let here = self.group_key();
        let mut least_found = None;
        for run in extremes.iter().filter(|run| run.run.group_key() == here) {
            for pose in &run.poses {
                let found = &pose.simulated;
                self.least = least(self.least, found.backlash);
                least_found = least(least_found, found.backlash);
                if found.backlash == least_found {
                    let on = |side| found.proven().and_then(|found| found.on(side));
                    let sections = Side::BOTH.map(|side| on(side).map(|contact| contact.section));
                    self.least_sections = sections[0].zip(sections[1]).map(<[f64; 2]>::from);
                }
                let assembly = run.run.assembly.data();
                let places = assembly.map(|pair| places(pair, &found.pose, found.proven()));
                let places = places.unwrap_or_default();
                let is_at_end = |at| matches!(at, FacePlace::NearEnd | FacePlace::FarEnd);
                self.extreme_at_end |= places.into_iter().flatten().any(is_at_end);
            }
        }
        self
    }

    /// Counts the places along the face at [`CYCLE_POSES`] poses over the whole cycle from `first` on, in place of those of its poses. Poses without
    /// a contact, or with an unproven one, do not count.
    ///
    /// # Errors
    /// [`Error::Stopped`] after a break of `tick`.
    pub(super) fn with_places_from(
        mut self,
        first: &Mating,
        tick: &Tick,
    ) -> Result<PoseEvidence, Error> {
        let pair = &self.assembly;
        let kernel = ExactKernel::new(pair);
        let pitches = pair.hunting_pitches();
        // Whole pitches at equal steps, and fractions by the golden section: every part of the cycle, and every phase of a pitch.
        let of_pose = |number: u32| {
            Error::if_stopped(tick(1))?;
            let whole = u64::from(number) * pitches / u64::from(CYCLE_POSES);
            let at = whole as f64 + (GOLDEN * f64::from(number)).fract();
            let pose = Pose::new(pair, first.onward(pair, at));
            Ok::<_, Error>(places(pair, &pose, kernel.lost_motion(&pose).ok().as_ref()))
        };
        let of_poses = parallel::map(0..CYCLE_POSES, of_pose);
        self.places = Default::default();
        for places in of_poses {
            self.count(places?);
        }
        Ok(self)
    }

    fn count(&mut self, places: [Option<FacePlace>; 2]) {
        for (counts, at) in self.places.iter_mut().zip(places) {
            if let Some(at) = at {
                counts[at as usize] += 1;
            }
        }
    }

    /// The sum of several; `None` for none.
    pub(super) fn sum<'a>(all: impl IntoIterator<Item = &'a PoseEvidence>) -> Option<PoseEvidence> {
        let mut all = all.into_iter();
        let mut sum = all.next()?.clone();
        for other in all {
            sum.contact.extend(&other.contact);
            sum.least = least(sum.least, other.least);
            let places = sum.places.as_flattened_mut().iter_mut();
            for (own, other) in places.zip(other.places.as_flattened()) {
                *own += other;
            }
            sum.unproven += other.unproven;
            sum.first_unproven = sum.first_unproven.or_else(|| other.first_unproven.clone());
            for (own, member) in sum.touched.iter_mut().zip(Member::BOTH) {
                own.extend(member, other.touched(member));
            }
        }
        Some(sum)
    }

    pub(super) fn touched(&self, member: Member) -> &Touched {
        &self.touched[member as usize]
    }

    /// The reason why poses are unproven; `None` if all are proven.
    pub(super) fn doubt<'a>(all: impl IntoIterator<Item = &'a PoseEvidence>) -> Option<String> {
        let sum = PoseEvidence::sum(all)?;
        let (mating, why) = sum.first_unproven.as_ref()?;
        Some(format!(
            "{} of {} poses are unproven; the first is {}: {}",
            sum.unproven,
            sum.contact.poses(),
            pose_in_words(mating),
            why.reason
        ))
    }
}

/// Places of the right and the left contact along the face; `None` without a contact, and for a pair that does not deviate along it.
fn places(pair: &GearPair, pose: &Pose, found: Option<&LostMotion>) -> [Option<FacePlace>; 2] {
    Side::BOTH.map(|side| FacePlace::of(pair, pose, &found?.on(side)?))
}

impl Touched {
    /// Adds a contact of `member`. Returns whether it is below the involute.
    fn add(&mut self, assembly: &GearPair, member: Member, side: Side, contact: &Contact) -> bool {
        let here = *contact.touch(member);
        self.greatest = greatest(self.greatest, Some(here.radius));
        self.least = least(self.least, Some(here.radius));
        let below = match here.curve {
            ToothPlace::Fillet | ToothPlace::Root => true,
            ToothPlace::Tip | ToothPlace::Flank => false,
            // An undercut edge: the class tells which gear has it.
            ToothPlace::Involute => {
                let form = assembly.gear(member).gear().form_radius();
                here.radius <= form + 1e-7
                    && ContactClass::of(assembly, side, contact).kind == ContactKind::Edge
            }
        };
        if below {
            self.pairs
                .insert((contact.wheel.tooth, contact.pinion.tooth));
            self.lower(member, contact);
        }
        below
    }

    fn lower(&mut self, member: Member, contact: &Contact) {
        let lowest = self.lowest.as_ref();
        let radius = |contact: &Contact| contact.touch(member).radius;
        if lowest.is_none_or(|lowest| radius(contact) < radius(lowest) - EQUAL_RADIUS) {
            self.lowest = Some(*contact);
        }
    }

    fn extend(&mut self, member: Member, other: &Touched) {
        self.below += other.below;
        self.greatest = greatest(self.greatest, other.greatest);
        self.least = least(self.least, other.least);
        self.pairs.extend(&other.pairs);
        if let Some(lowest) = &other.lowest {
            self.lower(member, lowest);
        }
    }
}

fn least(one: Option<f64>, other: Option<f64>) -> Option<f64> {
    [one, other].into_iter().flatten().reduce(f64::min)
}

fn greatest(one: Option<f64>, other: Option<f64>) -> Option<f64> {
    [one, other].into_iter().flatten().reduce(f64::max)
}

/// A pose in words: mating, flank, fraction.
pub(super) fn pose_in_words(mating: &Mating) -> String {
    let beyond = match mating.fraction {
        0.0 => String::new(),
        fraction => format!(", {fraction:.4} pitch beyond"),
    };
    format!(
        "wheel {} with pinion {} at the {} flank{beyond}",
        mating.wheel_tooth,
        mating.pinion_tooth,
        mating.flank.name()
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Touch;
    use crate::gear::ProfilePart::{self, Fillet, Involute, Tip};
    use nalgebra::{Point2, Vector2};

    /// A contact at these radii. Only radius, curve and tooth matter here.
    fn contact(wheel: (ProfilePart, f64), pinion: (ProfilePart, f64), teeth: [u32; 2]) -> Contact {
        let touch = |(curve, radius): (ProfilePart, f64), tooth| Touch {
            tooth,
            curve: curve.into(),
            radius,
        };
        Contact {
            rotation: 0.0,
            error: 1e-14,
            wheel: touch(wheel, teeth[0]),
            pinion: touch(pinion, teeth[1]),
            point: Point2::origin(),
            normal: Vector2::x(),
            section: 0.0,
        }
    }

    fn pair(teeth: [u32; 2]) -> GearPair {
        let distance = f64::from(teeth[0] + teeth[1]) + 0.1;
        GearPair::plain(teeth, [0.0; 2], distance, Member::Wheel)
    }

    /// Least, greatest and lowest contact, by hand: 42.5 and 42.3 on the fillet, 45 on the flank, 46.1 on the tip. The
    /// lowest is the first of two at one radius.
    #[test]
    fn the_lowest_contact_is_the_first_at_the_least_radius() {
        let pair = pair([44, 44]);
        let all = [
            (Fillet, 42.5, 1),
            (Tip, 46.1, 2),
            (Fillet, 42.3, 3),
            (Involute, 45.0, 4),
            (Fillet, 42.3 - 1e-12, 5),
            (Fillet, 42.4, 6),
        ];
        let tell = |contacts: &[(ProfilePart, f64, u32)]| {
            let mut touched = Touched::default();
            for &(curve, radius, tooth) in contacts {
                let contact = contact((curve, radius), (Involute, 44.0), [tooth, tooth + 1]);
                let below = touched.add(&pair, Member::Wheel, Side::Right, &contact);
                assert_eq!(below, curve == Fillet, "{curve:?} at {radius}");
                touched.below += usize::from(below);
            }
            touched
        };
        let joined = |[one, other]: [&[(ProfilePart, f64, u32)]; 2]| {
            let mut sum = tell(one);
            sum.extend(Member::Wheel, &tell(other));
            sum
        };
        let (early, late) = (&all[..2], &all[2..]);
        for touched in [tell(&all), joined([early, late]), joined([late, early])] {
            assert_eq!(touched.greatest, Some(46.1));
            assert_eq!(touched.least, Some(42.3 - 1e-12));
            assert_eq!(touched.below, 4);
            assert_eq!(touched.lowest.unwrap().wheel.tooth, 3);
            let pairs: HashSet<(u32, u32)> = [(1, 2), (3, 4), (5, 6), (6, 7)].into();
            assert_eq!(touched.pairs, pairs);
        }
    }

    /// The edge that undercut leaves is below the involute of its own gear, not of the mate. A flank without undercut has none.
    #[test]
    fn an_edge_is_below_the_involute_of_its_own_gear() {
        for (teeth, undercut) in [([44, 9], true), ([44, 44], false)] {
            let pair = pair(teeth);
            let [wheel, pinion] = Member::BOTH.map(|member| pair.gear(member).gear());
            assert_eq!(pinion.is_undercut(), undercut);
            for (off, at_edge) in [(0.0, true), (5e-8, true), (2e-7, false), (1.0, false)] {
                let radii = [wheel.form_radius() + 1.0, pinion.form_radius() + off];
                let contact = contact((Involute, radii[0]), (Involute, radii[1]), [1, 1]);
                let is_below = Member::BOTH
                    .map(|member| Touched::default().add(&pair, member, Side::Left, &contact));
                assert_eq!(is_below, [false, undercut && at_edge], "{teeth:?} {off}");
            }
        }
    }
}
