//! The box in the mesh zone that an inset enlarges, and the leader between them.

use super::view::View;
use crate::kit::clip;
use crate::kit::sheet::{Frame, INK, Spot, line};
use svg::node::element::Group;

/// What ties an inset to its place in the main view.
#[derive(Debug, Clone, Copy)]
pub struct Link {
    /// What the inset shows, or a box of its shape round it where that would be too small to see.
    shown: Frame,
    inset: Frame,
}

impl Link {
    /// TightestContacts what `enlarged` shows to its place in `main`.
    pub fn new(main: &View, enlarged: &View) -> Link {
        let inset = *enlarged.frame();
        let half = f64::max(0.5 * inset.width() * main.scale() / enlarged.scale(), 14.0);
        let [x, y] = main.spot(enlarged.middle());
        let rise = half * inset.height() / inset.width();
        Link {
            shown: Frame {
                left: x - half,
                top: y - rise,
                right: x + half,
                bottom: y + rise,
            },
            inset,
        }
    }

    /// The box in the main view.
    pub fn shown(&self) -> &Frame {
        &self.shown
    }

    /// The box, and a leader to that place on the inset's side, of some from its middle outwards,
    /// which it reaches across none of the `taken` rooms.
    pub fn draw(&self, taken: &[Frame]) -> Group {
        let from = self.shown.middle();
        let leaders = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9].map(|part| {
            let to = [self.inset.left, self.inset.top + part * self.inset.height()];
            let along = [0, 1].map(|i| to[i] - from[i]);
            let leave = f64::min(
                0.5 * self.shown.width() / along[0].abs(),
                0.5 * self.shown.height() / along[1].abs(),
            );
            [[0, 1].map(|i| from[i] + leave * along[i]), to]
        });
        let is_clear = |leader: &&[Spot; 2]| {
            !taken
                .iter()
                .any(|room| clip::segment(leader[0], leader[1], &room.grown(6.0)).is_some())
        };
        let leader = leaders.iter().find(is_clear).unwrap_or(&leaders[0]);
        Group::new()
            .add(self.shown.border().set("stroke-width", "1.00"))
            .add(line(leader, INK, 1.0))
    }
}
