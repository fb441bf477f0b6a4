//! Bounds of the lost motion over a stretch of one mating, which close with the square of its length.

use super::course::{Course, FaceEnd, PARTS, Posed};
use super::over::Over;
use super::room::{PairRoom, greatest, least};
use super::table::{Bounds, Table};

/// A stretch of one mating with the bounds of its lost motion, rad.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    pub mating: u64,
    pub part: usize,
    /// Fractions of the pitch.
    pub from: f64,
    pub to: f64,
    pub low: f64,
    pub high: f64,
    /// The places between `from` and `to` where the least and the greatest lost motion are expected.
    pub lowest: f64,
    pub highest: f64,
    /// A pose in it, or at its end, that was examined.
    pub seen: Option<f64>,
}

impl Cell {
    /// The cell of a part of a mating, without bounds yet.
    pub fn of_part(mating: u64, part: usize) -> Cell {
        let from = part as f64 / PARTS as f64;
        Cell {
            mating,
            part,
            from,
            to: (part as f64 + 1.0) / PARTS as f64,
            low: f64::NEG_INFINITY,
            high: f64::INFINITY,
            lowest: from,
            highest: from,
            seen: None,
        }
    }

    /// The cell of a part of a mating, with the bounds of the table.
    pub fn of_bounds(bounds: &Bounds) -> Cell {
        Cell {
            low: bounds.low,
            high: bounds.high,
            ..Cell::of_part(bounds.mating, bounds.part)
        }
    }

    /// The two cells on either side of `at`, a pose that was examined; the cut is kept off the ends.
    pub fn cut(&self, at: f64) -> [Cell; 2] {
        let width = self.to - self.from;
        let border = at.clamp(self.from + 0.25 * width, self.to - 0.25 * width);
        let whole = Cell {
            seen: Some(at),
            ..*self
        };
        [
            Cell {
                to: border,
                ..whole
            },
            Cell {
                from: border,
                ..whole
            },
        ]
    }

    /// This cell with the bounds of its table, taken from the line of action at both ends.
    pub fn bounded_by_line(self, course: &Course, table: &Table) -> Cell {
        let posed = course.posed(self.mating);
        let rooms = [0, 1].map(|k| {
            let over = self.over(course, &posed, k, Vec::new());
            let beside = table.beside_line(k, self.mating, self.part)?;
            over.of_all(beside).map(|room| vec![room])
        });
        match rooms {
            [Some(right), Some(left)] => self.within(&[right, left]),
            _ => self,
        }
    }

    /// The cell with its bounds.
    pub fn bounded(self, course: &Course, table: &Table) -> Cell {
        let posed = course.posed(self.mating);
        let ends = course.posed_at_ends(self.mating);
        let rooms = [0, 1].map(|k| {
            let faces = ends.iter().map(|end| end[k]).collect();
            let over = self.over(course, &posed, k, faces);
            over.rooms(table.steps(k, self.mating, self.part))
        });
        self.within(&rooms)
    }

    fn over<'a>(
        &self,
        course: &'a Course,
        posed: &[Posed<'a>; 2],
        side: usize,
        faces: Vec<FaceEnd<'a>>,
    ) -> Over<'a> {
        Over {
            stretch: [self.from, self.to],
            side: &course.sides[side],
            ends: [self.from, self.to].map(|at| posed[side].on(at)),
            faces,
            effort: course.effort,
        }
    }

    /// The same cell with the bounds that `rooms` give.
    fn within(self, rooms: &[Vec<PairRoom>; 2]) -> Cell {
        let (lowest, low) = least(rooms);
        let (highest, high) = greatest(rooms);
        let width = self.to - self.from;
        Cell {
            low: low.max(self.low),
            high: high.min(self.high),
            lowest: self.from + lowest * width,
            highest: self.from + highest * width,
            ..self
        }
    }
}
