//! One side of a cell of flanks whose profiles deviate, with the free gear held at a gap.
//!
//! The gap follows the involutes of the pair in contact, a chord between both ends of the cell. A side is no tighter than that by more than the
//! greatest height of any pair over the cell ([`profiles`](crate::contact::exact::helical::profiles)). The involutes of another pair leave that
//! chord by what theirs do beside it. The pair in contact loses no more than its height does.

use super::mesh_cycle::PosedSide;
use super::side_over_face::{FaceSideCell, HIGHER_ORDERS, PairInCell, SideBound, start};
use crate::contact::exact::helical::profiles::{AlongFlanks, Plays};
use crate::contact::exact::separation::Separation;
use crate::contact::lost_motion::{Contact, ToothPlace, Touch};

/// Part of the moves of a cell that the heights of profiles may leave open (tuned).
const SHARE_OF_HEIGHTS: f64 = 0.02;

/// One side of a cell of flanks whose profiles deviate, with the free gear held at a gap that follows the pair in contact.
pub(super) struct HeldSide<'b, 'a> {
    cell: &'b FaceSideCell<'a>,
    /// The side in the middle of the cell.
    middle: &'b PosedSide<'a>,
    contact: Contact,
    step: i64,
    /// The endless involutes of the pair in contact at both ends.
    found: [Separation; 2],
    /// Tightness at which the free gear is held at both ends of the cell, rad; it is a line between them.
    line: [f64; 2],
    plays: Plays,
}

impl<'b, 'a> HeldSide<'b, 'a> {
    /// The side with `contact` in the middle of its cell, at this room; `None` if the pair in contact is not known.
    pub fn new(
        cell: &'b FaceSideCell<'a>,
        contact: Contact,
        middle: &'b PosedSide<'a>,
        room: f64,
    ) -> Option<HeldSide<'b, 'a>> {
        let flanks = &middle.flanks;
        let teeth = cell.members().map(|member| contact.touch(member).tooth);
        let step = cell.steps().find(|step| flanks.numbers(*step) == teeth)?;
        let found = cell.endless(step);
        if !found.iter().all(|one| one.touches) {
            return None;
        }
        let own = cell.tightness(&found);
        let more = -room - 0.5 * (own[0] + own[1]);
        let (bases, turns) = (cell.bases(), cell.turns().map(|turn| 0.5 * turn));
        let off = cell.plane.side.off;
        let moved = HIGHER_ORDERS * (off[0] * turns[0] + off[1] * turns[1]);
        let by_locked = moved / cell.line_length(&found);
        let mut roll = by_locked.max((moved + bases[0] * by_locked) / bases[1]);
        let [twist, _] = cell.twists();
        let along = if twist == 0.0 {
            roll += turns[0].max(turns[1]);
            0.0
        } else {
            turns[0] / twist.abs()
        };
        let led = cell.assembly.steepest_leads() * along;
        let led = led.min(cell.deviations.moved);
        roll += led / bases[0].min(bases[1]);
        let open = SHARE_OF_HEIGHTS * (led + bases[0].max(bases[1]) * roll);
        Some(HeldSide {
            cell,
            middle,
            contact,
            step,
            found,
            line: own.map(|own| own + more),
            plays: Plays { along, roll, open },
        })
    }

    fn flanks(&self) -> Option<AlongFlanks<'_>> {
        let gap = self.middle.gap(-0.5 * (self.line[0] + self.line[1]));
        let (assembly, effort) = (self.cell.assembly, self.cell.plane.effort);
        let flanks = AlongFlanks::new(assembly, &self.middle.flanks, gap, effort)?;
        Some(flanks.over(self.plays))
    }

    /// Least arm by which a height turns the free gear, mm.
    fn arm(&self) -> f64 {
        self.cell.bases()[1] - self.cell.plane.side.off[1]
    }

    /// An upper bound of the side's tightness.
    pub fn above(&self) -> Option<SideBound> {
        let (cell, bases) = (self.cell, self.cell.bases());
        let flanks = self.flanks()?;
        let height = flanks.height_bound().ok()?;
        let start = start(self.middle);
        let middle = 0.5 * (self.line[0] + self.line[1]);
        let pairs = cell.pairs()?;
        let mut beside = 0.0f64;
        for PairInCell { step, found, bend } in &pairs {
            let here = Separation::endless_near(&self.middle.flanks, *step, [0.0; 2], &start);
            if !here.touches {
                return None;
            }
            let own = cell.tightness(found);
            let apart = middle + self.middle.room(here.gap);
            let nearer = |k: usize| apart - (self.line[k] - own[k]);
            beside = beside.max(nearer(0).max(nearer(1)) + bend);
        }
        let arms = [self.arm(), bases[1] + cell.plane.side.off[1]];
        // Where arms change over the cell, so does the room of pairs that their deviations close.
        let off = cell.plane.side.off[1] * (cell.turns()[1] + beside.max(0.0));
        let off = off / arms[0] * cell.deviations.moved;
        let height = height + arms[1] * beside + off;
        let more = height / (arms[0] - flanks.steepest()?);
        cell.above(pairs, Some(self.line.map(|line| line + more)))
    }

    /// A lower bound of the side's tightness, from the pair in contact; `None` where it touches on a fillet or a root.
    pub fn below(&self) -> Option<SideBound> {
        let (cell, b) = (self.cell, self.contact.section);
        let touches = cell.members().map(|member| self.contact.touch(member));
        let is_on_flank =
            |touch: &&Touch| matches!(touch.curve, ToothPlace::Involute | ToothPlace::Tip);
        if !touches.iter().all(is_on_flank) {
            return None;
        }
        let radii = touches.map(|touch| touch.radius);
        let flanks = self.flanks()?;
        let loss = flanks.loss(self.step, b, radii)?;
        let bend = cell.bend(&self.found)?;
        let less = loss / (self.arm() - flanks.steepest()?) + bend + self.contact.error;
        Some(SideBound {
            ends: self.line.map(|line| line - less),
            open: 0.0,
        })
    }
}
