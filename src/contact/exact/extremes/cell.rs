//! Bounds of the lost motion over a stretch of one mating, which close with the square of its length.

use super::mesh_cycle::{FaceEnd, MeshCycle, PARTS, PosedSide};
use super::room::{PairRoom, greatest, least};
use super::side_stretch::SideStretch;
use super::table::{CycleTable, PartBounds};

/// A stretch of one mating with the bounds of its lost motion, rad.
#[derive(Debug, Clone, Copy)]
pub(super) struct MatingCell {
    pub mating: u64,
    pub part: usize,
    /// Fractions of the pitch.
    pub from: f64,
    pub to: f64,
    pub low: f64,
    pub high: f64,
    /// The places between `from` and `to` where the least and the greatest lost motion are expected.
    pub expected: [f64; 2],
    /// An examined pose in it or at its end, as a fraction of the pitch.
    pub seen: Option<f64>,
}

impl MatingCell {
    /// The cell of a part of a mating, without bounds yet.
    pub fn of_part(mating: u64, part: usize) -> MatingCell {
        let from = part as f64 / PARTS as f64;
        MatingCell {
            mating,
            part,
            from,
            to: (part as f64 + 1.0) / PARTS as f64,
            low: f64::NEG_INFINITY,
            high: f64::INFINITY,
            expected: [from; 2],
            seen: None,
        }
    }

    /// The cell of a part of a mating, with the bounds of the table.
    pub fn of_bounds(bounds: &PartBounds) -> MatingCell {
        MatingCell {
            low: bounds.low,
            high: bounds.high,
            ..MatingCell::of_part(bounds.mating, bounds.part)
        }
    }

    /// The two cells on either side of `at`, a pose that was examined; the cut is kept off the ends.
    pub fn cut(&self, at: f64) -> [MatingCell; 2] {
        let width = self.to - self.from;
        let border = at.clamp(self.from + 0.25 * width, self.to - 0.25 * width);
        let whole = MatingCell {
            seen: Some(at),
            ..*self
        };
        [
            MatingCell {
                to: border,
                ..whole
            },
            MatingCell {
                from: border,
                ..whole
            },
        ]
    }

    /// This cell with the bounds of its table, taken from the line of action at both ends.
    pub fn bounded_by_line(self, cycle: &MeshCycle, table: &CycleTable) -> MatingCell {
        let posed = cycle.posed(self.mating);
        let rooms = [0, 1].map(|k| {
            let over = self.over(cycle, &posed, k, Vec::new());
            let beside = table.beside_line(k, self.mating, self.part)?;
            over.of_all(beside).map(|room| vec![room])
        });
        match rooms {
            [Some(right), Some(left)] => self.within(&[right, left]),
            _ => self,
        }
    }

    /// This cell with the bounds of its pairs of half teeth.
    pub fn bounded(self, cycle: &MeshCycle, table: &CycleTable) -> MatingCell {
        let posed = cycle.posed(self.mating);
        let ends = cycle.posed_at_ends(self.mating);
        let rooms = [0, 1].map(|k| {
            let faces = ends.iter().map(|end| end[k]).collect();
            let over = self.over(cycle, &posed, k, faces);
            over.rooms(table.steps(k, self.mating, self.part))
        });
        self.within(&rooms)
    }

    fn over<'a>(
        &self,
        cycle: &'a MeshCycle,
        posed: &[PosedSide<'a>; 2],
        side: usize,
        faces: Vec<FaceEnd<'a>>,
    ) -> SideStretch<'a> {
        SideStretch {
            stretch: [self.from, self.to],
            side: &cycle.sides[side],
            ends: [self.from, self.to].map(|at| posed[side].after(at)),
            faces,
            effort: cycle.effort,
        }
    }

    /// This cell with the bounds from `rooms`, the pairs of either side.
    fn within(self, rooms: &[Vec<PairRoom>; 2]) -> MatingCell {
        let (lowest, low) = least(rooms);
        let (highest, high) = greatest(rooms);
        let width = self.to - self.from;
        MatingCell {
            low: low.max(self.low),
            high: high.min(self.high),
            expected: [lowest, highest].map(|at| self.from + at * width),
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::stays_on_involutes_and_fillets;
    use super::*;
    use crate::contact::{Effort, ExactKernel};
    use crate::gear::{AsBuilt, Deviations, Face, Gear, GearDesign};
    use crate::pair::{GearPair, Mating};

    /// Pair `k` of random pairs. The first 60 have ordinary teeth, whose tables are near; others have few teeth and displaced racks.
    ///
    /// Pitch deviations of a fraction of a millimetre give each pair of teeth its own rotation of the free gear.
    fn random(k: u32) -> Option<GearPair> {
        let is_ordinary = k < 60;
        let part = |step: u32| f64::from((k * step + 7 * (k % 97) * k) % 101) / 101.0;
        let (shifts, most) = if is_ordinary {
            (0.0, 1.2)
        } else {
            (0.8, 1.5 * part(43))
        };
        let built = |teeth: u32, face, step: u32| {
            let list = |start: u32| -> Vec<f64> {
                let off = |tooth: u32| f64::from((tooth * 37 + start + k) % 11) / 11.0 - 0.5;
                (0..teeth).map(|tooth| most * off(tooth)).collect()
            };
            let deviations = Deviations::off_axis(0.7 * part(step), 1.5);
            let design = GearDesign::plain(teeth, 2.0);
            let design = design.shifted(shifts * (part(step + 30) - 0.25));
            let deviations = deviations.with_pitch(&list(3), &list(8));
            AsBuilt::new(Gear::nominal(design).ok()?, face, &deviations).ok()
        };
        let (teeth, farther) = if is_ordinary {
            ([24 + k % 19, 24 + k % 23], 1.6 * part(41))
        } else {
            ([7 + k % 41, 7 + k % 37], 3.0 * part(41) - 0.4)
        };
        let wheel = built(teeth[0], Face::Front, 17)?;
        let pinion = built(teeth[1], Face::Back, 29)?;
        GearPair::new(wheel, pinion, f64::from(teeth[0] + teeth[1]) + farther).ok()
    }

    /// No pose of a part of a mating is outside the bounds of its table, of its cell, or of the line of action. Source: five poses of every
    /// part, by the exact method.
    #[test]
    fn no_pose_of_a_part_is_outside_its_bounds() {
        let mut by_line = 0;
        // The last has a fillet just below the form circle.
        for k in (0..60u32).chain(150..400).chain([1474]) {
            let Some(pair) = random(k) else {
                continue;
            };
            let kernel = ExactKernel::new(&pair);
            let effort = Effort::endless();
            let cycle = MeshCycle::new(&kernel, &pair, (Mating::FIRST, 24), &effort);
            if !stays_on_involutes_and_fillets(&cycle) {
                continue;
            }
            let table = CycleTable::new(&cycle);
            table.each(0..24, &mut |bounds| {
                let cell = MatingCell::of_part(bounds.mating, bounds.part);
                let line = cell.bounded_by_line(&cycle, &table);
                by_line += u32::from(line.low.is_finite());
                let kinds = [
                    ("table", MatingCell::of_bounds(&bounds)),
                    ("line", line),
                    ("cell", cell.bounded(&cycle, &table)),
                ];
                for at in 0..5 {
                    let at = cell.from + (cell.to - cell.from) * f64::from(at) / 4.0;
                    let mating = cycle.mating(cell.mating, at);
                    let found = kernel.lost_motion_at(&pair, mating).unwrap().unwrap();
                    let Some(angle) = found.angle() else {
                        continue;
                    };
                    for (kind, cell) in &kinds {
                        let is_inside = cell.low - 1e-12 <= angle && angle <= cell.high + 1e-12;
                        assert!(is_inside, "{k}, {kind}, {mating:?}: {angle}, {cell:?}");
                    }
                }
            });
        }
        assert!(by_line > 5000, "{by_line}");
    }
}
