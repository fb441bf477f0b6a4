//! Lines and boxes of a picture that labels avoid.

use super::clip;
use super::frame::{Frame, Spot};

/// The obstacles of a picture.
#[derive(Debug, Default)]
pub struct Occupied {
    lines: Vec<[Spot; 2]>,
    boxes: Vec<Frame>,
}

/// Clear space round a label, units of the sheet.
pub const CLEAR: f64 = 3.0;

impl Occupied {
    pub fn line(&mut self, points: &[Spot]) {
        self.lines
            .extend(points.windows(2).map(|pair| [pair[0], pair[1]]));
    }

    /// Adds the edge of a box.
    pub fn border(&mut self, frame: Frame) {
        let corners = frame.corners();
        self.line(&corners);
        self.line(&[corners[3], corners[0]]);
    }

    pub fn frame(&mut self, frame: Frame) {
        self.boxes.push(frame);
    }

    pub fn crosses_frame(&self, line: &[Spot; 2]) -> bool {
        let [from, to] = *line;
        let boxes = &mut self.boxes.iter();
        boxes.any(|taken| clip::segment(from, to, taken).is_some())
    }

    /// Whether `room` and its surroundings within `clear` are free.
    pub fn is_clear(&self, room: &Frame, clear: f64) -> bool {
        let room = room.grown(clear);
        !self.boxes.iter().any(|taken| taken.overlaps(&room))
            && !self
                .lines
                .iter()
                .any(|[from, to]| clip::segment(*from, *to, &room).is_some())
    }
}
