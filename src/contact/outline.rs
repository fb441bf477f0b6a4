//! Lost motion of outlines: any curves, by branch and bound over all pairs of pieces that can meet.
//!
//! The frame is that of the exact method ([`super::ExactKernel`]): the free gear's axis at the origin, the locked one's at `(a, 0)`, the left
//! side mirrored; of a side the contact is the greatest gap of its facing half teeth. A half tooth's whole tip counts on both sides.
//! Nothing is asked of a curve but its points, its normals, and how far both stray over a piece.

use super::exact::lens_half;
use super::gap::{
    Arc, C, MOST_NODES, Meeting, PlacedCurve, common_normal, greatest, rounding, turn,
};
use super::lost_motion::Framed;
use super::outline_contact::{OutlineContact, OutlineLostMotion, OutlineTouch, Region, Unsettled};
use crate::gear::Side;
use crate::outline::{HalfOutline, HalfPiece, OutlineGear, OutlinePair};
use crate::pair::{Mating, Member};
use std::f64::consts::TAU;

/// Lost motion of one pair of outlines.
#[derive(Debug)]
pub struct OutlineKernel<'a> {
    pair: &'a OutlinePair,
    sides: [SideKernel<'a>; 2],
    /// Least radius about the free axis of the free outline, mm: within it the free gear is solid.
    solid: f64,
}

/// One side, the left one mirrored.
#[derive(Debug)]
struct SideKernel<'a> {
    side: Side,
    locked: SideTeeth<'a>,
    free: SideTeeth<'a>,
    /// Whole pieces of each free half tooth, by number, at rotation 0.
    free_arcs: Vec<FreeArcs<'a>>,
}

/// The pieces of a free half tooth, by their least radius ascending.
#[derive(Debug)]
struct FreeArcs<'a> {
    arcs: Vec<Arc<'a>>,
    /// Greatest range of radii of a piece, mm.
    widest: f64,
}

impl<'a> FreeArcs<'a> {
    fn new(mut arcs: Vec<Arc<'a>>) -> FreeArcs<'a> {
        arcs.sort_by(|a, b| a.radii().0.total_cmp(&b.radii().0));
        let widths = arcs.iter().map(|arc| arc.radii().1 - arc.radii().0);
        FreeArcs {
            widest: widths.fold(0.0, f64::max),
            arcs,
        }
    }

    /// The range of places of pieces among which all are that may have a point at a radius of `arc`.
    fn near(&self, arc: &Arc) -> std::ops::Range<usize> {
        let (least, most) = arc.radii();
        let from = self
            .arcs
            .partition_point(|free| free.radii().0 < least - self.widest);
        let to = self.arcs.partition_point(|free| free.radii().0 <= most);
        from..to.max(from)
    }
}

/// One side of a gear's teeth, in the frame of the side.
#[derive(Debug)]
struct SideTeeth<'a> {
    gear: &'a OutlineGear,
    side: Side,
    displacement: C,
    /// Sense in which tooth numbers ascend in this frame.
    ascending: i64,
    /// Of each piece of each half tooth its middle, mm, and the distance within which it lies.
    middles: Vec<Vec<(C, f64)>>,
}

impl<'a> SideTeeth<'a> {
    fn new(gear: &'a OutlineGear, side: Side) -> SideTeeth<'a> {
        let mirror = -side.sense();
        let displacement = gear.displacement();
        let middle = |piece: &HalfPiece| {
            let (low, high) = piece.range();
            let (reach, _) = piece.curve.spread(low, high);
            (piece.point(0.5 * (low + high)), reach)
        };
        let middles = (1..=gear.teeth()).map(|tooth| {
            let half = gear.half(side, tooth);
            half.pieces.iter().map(middle).collect()
        });
        SideTeeth {
            gear,
            side,
            displacement: if mirror > 0.0 {
                displacement
            } else {
                displacement.conj()
            },
            ascending: (mirror * gear.face().ascending()) as i64,
            middles: middles.collect(),
        }
    }

    fn half(&self, tooth: u32) -> &'a HalfOutline {
        self.gear.half(self.side, tooth)
    }

    /// The number of the tooth `steps` counter-clockwise of `tooth` in this frame.
    fn beside(&self, tooth: u32, steps: i64) -> u32 {
        let index = i64::from(tooth) - 1 + self.ascending * steps;
        index.rem_euclid(i64::from(self.gear.teeth())) as u32 + 1
    }
}

/// A frame of a gear: `centre + direction · P`.
#[derive(Debug, Clone, Copy)]
struct Frame {
    centre: C,
    direction: C,
}

impl Frame {
    fn placed<'a>(&self, piece: &'a HalfPiece) -> PlacedCurve<'a> {
        PlacedCurve {
            curve: &piece.curve,
            mirrored: piece.mirrored,
            centre: self.centre,
            direction: self.direction * piece.turn,
        }
    }

    fn arc<'a>(&self, piece: &'a HalfPiece, name: usize) -> Arc<'a> {
        let (low, high) = piece.range();
        Arc::new(self.placed(piece), name, low, high)
    }

    /// The same of the free gear: about the axis an arc has one radius, on which only its clockwise end, the one nearer the root, can touch.
    fn free_arc<'a>(&self, piece: &'a HalfPiece, name: usize) -> Arc<'a> {
        match self.centre == C::ZERO && piece.curve.is_about_the_origin() {
            true => Arc::new(self.placed(piece), name, piece.ends[1], piece.ends[1]),
            false => self.arc(piece, name),
        }
    }
}

impl<'a> OutlineKernel<'a> {
    /// The kernel of `pair`.
    pub fn new(pair: &'a OutlinePair) -> OutlineKernel<'a> {
        let sides = Side::BOTH.map(|side| {
            let teeth = |member| SideTeeth::new(pair.gear(member), side);
            let free = teeth(pair.free());
            let still = Frame {
                centre: free.displacement,
                direction: C::ONE,
            };
            let arcs = (1..=free.gear.teeth()).map(|tooth| {
                let pieces = free.half(tooth).pieces.iter().enumerate();
                FreeArcs::new(
                    pieces
                        .map(|(name, piece)| still.free_arc(piece, name))
                        .collect(),
                )
            });
            SideKernel {
                side,
                locked: teeth(pair.locked()),
                free_arcs: arcs.collect(),
                free,
            }
        });
        let free = pair.gear(pair.free());
        OutlineKernel {
            solid: free.root_radius() - free.eccentricity(),
            pair,
            sides,
        }
    }

    /// Right- and left-flank contact at `mating`.
    ///
    /// # Errors
    /// [`Unsettled`], never a pair of curves left out.
    pub fn lost_motion(&self, mating: &Mating) -> Result<OutlineLostMotion, Unsettled> {
        self.lost_motion_at(self.pair, mating)
    }

    /// The same of `pair`: these gears, perhaps at another centre distance.
    ///
    /// # Errors
    /// As [`OutlineKernel::lost_motion`].
    pub(crate) fn lost_motion_at(
        &self,
        pair: &OutlinePair,
        mating: &Mating,
    ) -> Result<OutlineLostMotion, Unsettled> {
        let [right, left] = self.sides.each_ref().map(|side| side.contact(pair, mating));
        let (right, left) = (right?, left?);
        let overlap = right
            .zip(left)
            .map_or(0.0, |(right, left)| right.rotation - left.rotation);
        let free = pair.gear(pair.free());
        let deep = || self.sides[0].reaches_within(pair, mating, self.solid);
        Ok(OutlineLostMotion {
            right,
            left,
            solid: overlap >= free.pitch() || deep(),
        })
    }
}

impl SideKernel<'_> {
    /// Rotation of the locked gear, in this frame, and its frame.
    fn locked_frame(&self, pair: &OutlinePair, mating: &Mating) -> (f64, Frame) {
        let rotation = -self.side.sense() * pair.rotation(pair.locked(), mating);
        let turned = turn(rotation);
        let frame = Frame {
            centre: C::from(pair.center_distance()) - turned * self.locked.displacement,
            direction: -turned,
        };
        (rotation, frame)
    }

    /// Steps, counter-clockwise of the mating's locked tooth, whose teeth can reach the free gear.
    fn steps(
        &self,
        pair: &OutlinePair,
        mating: &Mating,
        rotation: f64,
    ) -> std::ops::RangeInclusive<i64> {
        let (gear, mate) = (self.locked.gear, self.free.gear);
        let pitch = gear.pitch();
        let tooth = f64::from(mating.tooth(pair.locked()));
        let there = rotation - self.side.sense() * gear.tooth_angle(tooth);
        let there = there - TAU * (there / TAU).round();
        let half = lens_half(gear.reach(), mate.reach(), pair.center_distance()).unwrap_or(0.0);
        // A tooth and a half on either side: its own width, and teeth off their even places by less than half a pitch.
        let (low, high) = (-half - 1.5 * pitch, half + 1.5 * pitch);
        let most = (i64::from(gear.teeth()) - 1) / 2;
        let first = ((low - there) / pitch).ceil() as i64;
        let last = ((high - there) / pitch).floor() as i64;
        // Never more than once round.
        let middle = (-there / pitch).round() as i64;
        first.max(middle - most)..=last.min(middle + most)
    }

    fn contact(
        &self,
        pair: &OutlinePair,
        mating: &Mating,
    ) -> Result<Option<OutlineContact>, Unsettled> {
        let (rotation, locked_frame) = self.locked_frame(pair, mating);
        let free_rotation = -self.side.sense() * pair.rotation(pair.free(), mating);
        // Gaps count from the nominal rotation.
        let origin = turn(-free_rotation);
        let (locked_tooth, free_tooth) = (mating.tooth(pair.locked()), mating.tooth(pair.free()));
        let beyond = i64::from(mating.flank != self.side);
        let still = Frame {
            centre: self.free.displacement,
            direction: C::ONE,
        };
        let mut nodes_left = MOST_NODES;
        let mut best: Option<(Meeting, u32, u32)> = None;
        let mut level = f64::NEG_INFINITY;
        let steps = self.steps(pair, mating, rotation);
        // From the middle outwards: what touches stands there most often, and rules the rest out.
        let middle = (steps.start() + steps.end()).div_euclid(2);
        let mut order: Vec<i64> = steps.collect();
        order.sort_by_key(|step| (step - middle).abs());
        for step in order {
            let teeth = (
                self.locked.beside(locked_tooth, step),
                self.free.beside(free_tooth, beyond - step),
            );
            let nodes = self.nodes(teeth, &locked_frame, origin, level);
            let found = greatest(nodes, origin, level, &mut nodes_left);
            let found = found.map_err(|_| self.unsettled(pair, teeth))?;
            if let Some(meeting) = found {
                level = meeting.gap;
                best = Some((meeting, teeth.0, teeth.1));
            }
        }
        Ok(best.map(|(meeting, locked, free)| {
            let frames = [locked_frame, still];
            self.report(pair, &meeting, [locked, free], frames, free_rotation)
        }))
    }

    /// Pairs of pieces of a locked and a free half tooth that may have a greater gap than `level` and than any other pair surely has.
    fn nodes(
        &self,
        (locked, free): (u32, u32),
        frame: &Frame,
        origin: C,
        mut level: f64,
    ) -> Vec<(Arc<'_>, Arc<'_>)> {
        let pieces = self.locked.half(locked).pieces.iter();
        let middles = &self.locked.middles[locked as usize - 1];
        let frees = &self.free_arcs[free as usize - 1];
        let outermost = self.free.gear.reach();
        let reached = pieces.zip(middles).enumerate();
        let reached = reached.filter(|(_, (_, (middle, reach)))| {
            (frame.centre + frame.direction * middle).norm() - reach <= outermost
        });
        let arcs: Vec<Arc> = reached
            .map(|(name, (piece, _))| frame.arc(piece, name))
            .collect();
        let mut bounded: Vec<(f64, u32, u32)> = Vec::new();
        for (k, arc) in arcs.iter().enumerate() {
            for m in frees.near(arc) {
                let free = &frees.arcs[m];
                if !arc.meets(free) {
                    continue;
                }
                let (least, most) = arc.gap_with(free, origin);
                // One that is there is found again below: a strictly greater gap counts.
                level = level.max(least - f64::EPSILON);
                if most > level {
                    bounded.push((most, k as u32, m as u32));
                }
            }
        }
        // The most promising last, where it is taken first.
        bounded.retain(|(most, ..)| *most > level);
        bounded.sort_by(|a, b| a.0.total_cmp(&b.0));
        let arc = |&(_, k, m): &(f64, u32, u32)| (arcs[k as usize], frees.arcs[m as usize]);
        bounded.iter().map(arc).collect()
    }

    fn unsettled(&self, pair: &OutlinePair, (locked, free): (u32, u32)) -> Unsettled {
        let (wheel_tooth, pinion_tooth) = match pair.locked() {
            Member::Wheel => (locked, free),
            Member::Pinion => (free, locked),
        };
        Unsettled {
            wheel_tooth,
            pinion_tooth,
            flank: self.side.name(),
        }
    }

    /// The contact of a meeting, in the picture.
    fn report(
        &self,
        pair: &OutlinePair,
        meeting: &Meeting,
        [locked, free]: [u32; 2],
        frames: [Frame; 2],
        nominal: f64,
    ) -> OutlineContact {
        let halves = [self.locked.half(locked), self.free.half(free)];
        let at = [meeting.locked, meeting.free];
        let pieces = [0, 1].map(|k: usize| &halves[k].pieces[at[k].0]);
        let [p, q] = [0, 1].map(|k: usize| frames[k].placed(pieces[k]).at(at[k].1));
        let corners = [0, 1].map(|k: usize| pieces[k].is_corner(at[k].1));
        let turned = turn(meeting.gap + nominal);
        let (normal, slope) = common_normal(&p, &q, corners, || -q.normal * turned);
        let touch = |k: usize, tooth: u32| {
            let radius = pieces[k].point(at[k].1).norm();
            let region = match radius {
                _ if radius >= halves[k].tip_limit => Region::Tip,
                _ if radius <= halves[k].root_limit => Region::Root,
                _ => Region::Flank,
            };
            OutlineTouch {
                tooth,
                curve: region,
                radius,
            }
        };
        let radius = p.point.norm();
        let size =
            pair.center_distance() + 2.0 * (self.locked.gear.reach() + self.free.gear.reach());
        let drawn = self.locked.gear.bound() + self.free.gear.bound();
        let drawn = drawn * (1.0 + slope.abs()) / radius;
        Framed {
            side: self.side,
            free: pair.free(),
            center_distance: pair.center_distance(),
            rotation: nominal + meeting.gap,
            error: rounding(size, radius, slope) + meeting.slack + drawn,
            locked: touch(0, locked),
            mated: touch(1, free),
            point: p.point,
            normal,
        }
        .contact()
    }

    /// Whether a point of the locked outline lies within `radius`, mm, of the free axis.
    fn reaches_within(&self, pair: &OutlinePair, mating: &Mating, radius: f64) -> bool {
        let (rotation, frame) = self.locked_frame(pair, mating);
        let tooth = mating.tooth(pair.locked());
        let halves = self
            .steps(pair, mating, rotation)
            .map(|step| self.locked.beside(tooth, step));
        halves.into_iter().any(|tooth| {
            let pieces = self.locked.half(tooth).pieces.iter();
            let middles = self.locked.middles[tooth as usize - 1].iter();
            pieces.zip(middles).any(|(piece, (middle, reach))| {
                let there = (frame.centre + frame.direction * middle).norm();
                let (low, high) = piece.range();
                there - reach < radius && nearest(&frame.placed(piece), low, high, radius)
            })
        })
    }
}

/// Whether a curve comes within `radius`, mm, of the origin between two parameters: found at a point, or ruled out by its reach.
fn nearest(placed: &PlacedCurve, low: f64, high: f64, radius: f64) -> bool {
    let middle = 0.5 * (low + high);
    let there = placed.at(middle).point.norm();
    let (reach, _) = placed.curve.spread(low, high);
    if there < radius {
        return true;
    }
    // As near as rounding tells is not within.
    if there - reach >= radius
        || reach <= 16.0 * f64::EPSILON * there
        || !(low < middle && middle < high)
    {
        return false;
    }
    nearest(placed, low, middle, radius) || nearest(placed, middle, high, radius)
}
