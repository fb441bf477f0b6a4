//! Extremes of pairs that deviate along the face: bounds over cells of the mesh cycle, for [`CycleSearch`].
//!
//! Each side of a cell is bounded on its own: by [`FaceSideCell`], or by [`HeldSide`] where profiles deviate. The bounds hold while only
//! involutes and their ends can touch, and corners on fillets, whose additional room [`SideStretch`] bounds. Gears whose flanks spread over
//! all turns by leads, leans and profile deviations, at the least distance of any section, show that.

use super::held_side::HeldSide;
use super::mesh_cycle::{CycleSide, MeshCycle, PosedSide, posed_sides};
use super::side_over_face::{FaceSideCell, ProfileDeviations, SideBound, start};
use super::side_stretch::SideStretch;
use crate::contact::cycle_search::{Cell, CycleCells};
use crate::contact::effort::Effort;
use crate::contact::exact::leaning::LeaningFrame;
use crate::contact::exact::teeth::reduced;
use crate::contact::exact::{Doubt, End, ExactKernel};
use crate::contact::lost_motion::Contact;
use crate::gear::Side;
use crate::pair::{GearPair, Mating, Member, Pose};

/// Half the width of a cell, pitches, below which its whole bound counts as open: narrower cells hardly improve it.
const NARROW: f64 = 1e-5;

/// The cells of a cycle.
pub(super) struct AlongFaceCells<'a> {
    kernel: &'a ExactKernel,
    assembly: &'a GearPair,
    first: Mating,
    sides: [CycleSide<'a>; 2],
    deviations: ProfileDeviations,
}

impl<'a> AlongFaceCells<'a> {
    /// The cells of `cycle`; `None` where nothing deviates along the face, profiles deviate beside leaning axes, or other curves can touch.
    pub fn new(cycle: &MeshCycle<'a>) -> Option<AlongFaceCells<'a>> {
        let assembly = cycle.assembly;
        let has_bounds = if assembly.is_modified() {
            assembly.varies_along_face() && !assembly.leans()
        } else {
            assembly.deviates_along_face()
        };
        if !has_bounds {
            return None;
        }
        // Heights of a point of contact over its section, and turns of flanks by their twist.
        let height = assembly.height_bound();
        let twist = assembly.gear(Member::Wheel).gear().basic_data();
        let turned = height * (twist.base_helix_angle().tan() + assembly.lean_bound());
        let [from, to] = assembly.face();
        let spread = |member: Member| {
            let gear = assembly.gear(member);
            gear.spread_by_leads([from - height, to + height], turned)
        };
        let (wheel, pinion) = (spread(Member::Wheel).ok()?, spread(Member::Pinion).ok()?);
        let distance = assembly.center_distance() - assembly.shift_bound();
        let pair = assembly.with_gears(wheel, pinion, distance).ok()?;
        let kernel = ExactKernel::new(&pair);
        let effort = Effort::endless();
        let spread = MeshCycle::new(&kernel, &pair, (cycle.first, 1), &effort);
        if !super::stays_on_involutes_and_fillets(&spread) {
            return None;
        }
        let mut sides = cycle.sides.clone();
        for (side, spread) in sides.iter_mut().zip(spread.sides) {
            side.tips_at_fillets = spread.tips_at_fillets;
        }
        Some(AlongFaceCells {
            kernel: cycle.kernel,
            assembly,
            first: cycle.first,
            sides,
            deviations: ProfileDeviations::new(assembly),
        })
    }
}

impl AlongFaceCells<'_> {
    /// The bounds of side `k` over a cell about `posed`, with this contact and room there: above for a least, below for a greatest.
    fn side_bounds(
        &self,
        k: usize,
        posed: &PosedSide,
        half: f64,
        contact: Option<(Contact, f64)>,
        ends: &[End],
        effort: &Effort,
    ) -> [Option<SideBound>; 2] {
        let both = [posed.after(-half), posed.after(half)];
        let side = FaceSideCell {
            assembly: self.assembly,
            deviations: self.deviations,
            starts: both.each_ref().map(start),
            leaning: LeaningFrame::new(self.assembly, &both[0].flanks)
                .zip(LeaningFrame::new(self.assembly, &both[1].flanks))
                .map(|(one, other)| [one, other]),
            plane: SideStretch {
                stretch: [-half, half],
                side: &self.sides[k],
                ends: both,
                faces: Vec::new(),
                effort,
            },
        };
        let wants = |end| ends.contains(&end);
        if !self.assembly.is_modified() {
            let below = contact.filter(|_| wants(End::Greatest));
            return [
                wants(End::Least)
                    .then(|| side.above(side.pairs()?, None))
                    .flatten(),
                below.and_then(|(contact, _)| side.below(&contact)),
            ];
        }
        let held = contact.and_then(|(contact, room)| HeldSide::new(&side, contact, posed, room));
        let Some(held) = held else {
            return [None; 2];
        };
        [
            wants(End::Least).then(|| held.above()).flatten(),
            wants(End::Greatest).then(|| held.below()).flatten(),
        ]
    }
}

impl CycleCells for AlongFaceCells<'_> {
    const DOUBT_OF_BOUNDS: Doubt = Doubt::Sections;

    fn cells_a_pitch(&self) -> u64 {
        // Poses take long where profiles deviate, and shifts along the face hardly widen a cell (both tuned).
        if self.assembly.is_modified() { 2 } else { 4 }
    }

    fn mating(&self, pitches: f64) -> Mating {
        self.first.onward(self.assembly, pitches)
    }

    fn examine(&self, pitches: f64, half: f64, ends: &[End], _width: f64) -> Cell {
        let assembly = self.assembly;
        let mut cell = Cell::unknown(pitches, half);
        let effort = Effort::of_pose();
        let pose = Pose::new(assembly, self.mating(pitches));
        let found = self.kernel.found_within(&pose, &effort);
        cell.effort = effort.used();
        let Ok(found) = found.map(|found| found.lost_motion) else {
            return cell;
        };
        cell.status = found.status();
        cell.angle = found.angle().zip(found.error());
        let Some((angle, _)) = cell.angle.filter(|_| half <= 0.5) else {
            return cell;
        };
        let posed = posed_sides(&self.sides, self.kernel.plane(), &pose);
        let bounds = [0, 1].map(|k| {
            let contact = found.on(Side::BOTH[k]).map(|contact| {
                let beyond = reduced(contact.rotation - pose.free_rotation());
                (contact, Side::BOTH[k].sense() * beyond)
            });
            self.side_bounds(k, &posed[k], half, contact, ends, &effort)
        });
        let sums = |which: usize| {
            let (right, left) = bounds[0][which].zip(bounds[1][which])?;
            let ends = [0, 1].map(|k| right.ends[k] + left.ends[k]);
            Some((ends, right.open + left.open))
        };
        if let Some(([one, other], open)) = sums(0) {
            cell.low = rest_of(half, -one.max(other), angle, open);
        }
        if let Some(([one, other], open)) = sums(1) {
            let (high, open) = rest_of(half, one.min(other), -angle, open);
            cell.high = (-high, open);
        }
        cell.effort = effort.used();
        cell
    }
}

/// The `bound` of a cell that is `half` pitches wide on either side, with the value `angle` in its middle, and the rest that narrower cells do
/// not exclude, rad.
fn rest_of(half: f64, bound: f64, angle: f64, open: f64) -> (f64, f64) {
    let rest = angle - bound;
    if half < NARROW && rest > 0.0 {
        (angle, open + rest)
    } else {
        (bound, open)
    }
}
