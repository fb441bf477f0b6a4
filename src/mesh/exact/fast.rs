//! The quick path for a certified pair: the line of action first, then the corners it may have missed.
//!
//! At the greatest gap found so far most corners stand clear of the mate's metal, which a table
//! of lines shows ([`super::envelope`]); only the rest are put on the curves.

use super::branch::{Hit, Placed, Unsettled, search};
use super::certificate::{Certificate, Setting};
use super::corner::{meet, own_frame, turns_back};
use super::envelope::{Envelope, Place};
use super::facing::Stand;
use super::line::Swerve;
use super::plain;
use super::shape::{C, Shape, turn};
use super::ties::{Ties, Touching};
use crate::gear::Curve;
use crate::pair::Assembly;

/// What a certified pair needs besides its teeth.
#[derive(Debug, Clone)]
pub(super) struct Shortcut {
    pub certificate: Certificate,
    pub swerve: Swerve,
    pub locked: Envelope,
    pub free: Envelope,
    /// Eccentricity of the free gear.
    free_off: f64,
}

/// The pair that touches first.
///
/// # Errors
/// The step whose pair could not be settled.
pub(super) fn touching(stand: &Stand) -> Result<Option<Touching>, (i64, Unsettled)> {
    let Some(shortcut) = &stand.facing.shortcut else {
        return plain::touching(stand);
    };
    let mut ties = Ties::new(stand.facing);
    if !stand.on_line(&shortcut.swerve, &mut ties) {
        return plain::touching(stand);
    }
    stand.on_corners(shortcut, &mut ties);
    let open = shortcut.certificate.open;
    if !open.is_empty() {
        for step in stand.steps() {
            let (locked, free) = (stand.locked(step), stand.free(step));
            let found = search(&locked, &free, stand.origin, ties.level(), open);
            if let Some(hit) = found.map_err(|lost| (step, lost))? {
                ties.offer(step, hit);
            }
        }
    }
    Ok(ties.choose())
}

impl Shortcut {
    /// The shortcut of a certified pair, `None` for any other.
    pub fn new(assembly: &Assembly, margin: f64) -> Option<Shortcut> {
        let (ours, theirs) = (
            assembly.gear(assembly.locked()),
            assembly.gear(assembly.free()),
        );
        let setting = Setting {
            locked: &Shape::new(ours.gear()),
            free: &Shape::new(theirs.gear()),
            locked_off: ours.eccentricity(),
            free_off: theirs.eccentricity(),
            distance: assembly.center_distance(),
        };
        let swerve = Swerve::new(
            setting.distance - setting.locked_off - setting.free_off,
            setting.free_off,
            setting.free.base,
            setting.free.base + setting.locked.base,
        )?;
        Some(Shortcut {
            certificate: setting.certify()?,
            free_off: setting.free_off,
            swerve,
            locked: Envelope::new(ours.gear(), margin),
            free: Envelope::new(theirs.gear(), margin),
        })
    }
}

impl Stand<'_> {
    /// Offers every corner whose gap may exceed what `ties` holds: tip corners, and undercut joints.
    fn on_corners(&self, shortcut: &Shortcut, ties: &mut Ties) {
        let mut level = Level::new(self, ties);
        for step in self.steps() {
            let (locked, free) = (self.locked(step), self.free(step));
            let mut offer = |hit: Option<Hit>, level: &mut Level| {
                if let Some(hit) = hit.filter(|hit| ties.admits(hit.gap)) {
                    ties.offer(step, hit);
                    level.follow(self, ties);
                }
            };
            for corner in locked.shape.corners() {
                let hit = self.locked_corner(shortcut, &locked, &free, corner, &level);
                offer(hit, &mut level);
            }
            for corner in free.shape.corners() {
                let hit = self.free_corner(shortcut, &locked, &free, corner, &level);
                offer(hit, &mut level);
            }
        }
    }

    fn locked_corner(
        &self,
        shortcut: &Shortcut,
        locked: &Placed,
        free: &Placed,
        (roll, corner): (f64, C),
        level: &Level,
    ) -> Option<Hit> {
        let point = locked.centre + locked.direction * corner;
        let near = own_frame(free, point * level.rotation.conj());
        if level.known {
            let outmost = free.shape.tip_radius + shortcut.free_off;
            match shortcut.free.place(near) {
                Place::Clear => return None,
                Place::Above if point.norm_sqr() > outmost * outmost => return None,
                Place::Above | Place::Unsure => {}
            }
        }
        let rho = point.norm_sqr().sqrt();
        let (curve, t, mate) = meet(free, shortcut.certificate.free_fillet, rho, near)?;
        Some(Hit {
            gap: (point * mate.conj() * self.origin).arg(),
            slack: 0.0,
            locked: (Curve::Involute, roll),
            free: (curve, t),
            point,
        })
    }

    fn free_corner(
        &self,
        shortcut: &Shortcut,
        locked: &Placed,
        free: &Placed,
        (roll, corner): (f64, C),
        level: &Level,
    ) -> Option<Hit> {
        let mate = free.centre + free.direction * corner;
        let near = own_frame(locked, mate * level.rotation);
        // Past a flank that turns back a clear point may still lie behind it.
        let behind = shortcut.certificate.turns_back && turns_back(locked);
        if level.known && !behind {
            match shortcut.locked.place(near) {
                Place::Clear => return None,
                Place::Above if mate.norm_sqr() < square_of_least(locked) => return None,
                Place::Above | Place::Unsure => {}
            }
        }
        let rho = mate.norm_sqr().sqrt();
        let (curve, t, point) = meet(locked, shortcut.certificate.locked_fillet, rho, near)?;
        Some(Hit {
            gap: (point * mate.conj() * self.origin).arg(),
            slack: 0.0,
            locked: (curve, t),
            free: (Curve::Involute, roll),
            point,
        })
    }
}

/// Rotation of the free gear at the greatest gap so far.
struct Level {
    greatest: f64,
    /// False before the first hit: nothing can be ruled out.
    known: bool,
    rotation: C,
}

impl Level {
    fn new(stand: &Stand, ties: &Ties) -> Level {
        let mut level = Level {
            greatest: f64::NEG_INFINITY,
            known: false,
            rotation: stand.origin.conj(),
        };
        level.follow(stand, ties);
        level
    }

    fn follow(&mut self, stand: &Stand, ties: &Ties) {
        if ties.greatest() > self.greatest {
            self.greatest = ties.greatest();
            self.known = true;
            self.rotation = turn(self.greatest) * stand.origin.conj();
        }
    }
}

/// Square of a locked half tooth's least radius about the free axis, on its tip land: at an end of it,
/// or where it crosses the line of centres.
fn square_of_least(locked: &Placed) -> f64 {
    let ends =
        [locked.shape.corner, C::from(locked.shape.tip_radius)].map(|end| locked.direction * end);
    let side = ends.map(|end| end.re * locked.centre.im - end.im * locked.centre.re);
    if side[0] * side[1] <= 0.0 {
        let least = locked.centre.norm_sqr().sqrt() - locked.shape.tip_radius;
        return least * least;
    }
    let squares = ends.map(|end| (locked.centre + end).norm_sqr());
    squares[0].min(squares[1])
}
