//! The quick path for a certified pair: the line of action first, then the corners it may have missed.
//!
//! At the greatest gap found so far most corners stand clear of the mate's metal, which a table
//! of lines shows ([`super::envelope`]); only the rest are put on the curves.

use super::branch::{Hit, Placed, Unsettled};
use super::certificate::{Certificate, Setting};
use super::corner::{Beyond, meet, own_frame};
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
/// As [`plain::touching`], which it falls back on where the certificate does not reach.
pub(super) fn touching(stand: &Stand) -> Result<Option<Touching>, (i64, Unsettled)> {
    if let Some(shortcut) = &stand.facing.shortcut {
        let mut ties = Ties::new(stand.facing);
        if stand.on_line(&shortcut.swerve, &mut ties)
            && stand.on_corners(shortcut, &mut ties).is_ok()
        {
            return Ok(ties.choose());
        }
    }
    plain::touching(stand)
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
    fn on_corners(&self, shortcut: &Shortcut, ties: &mut Ties) -> Result<(), Beyond> {
        let mut level = Level::new(self, ties);
        for step in self.steps() {
            let (locked, free) = (self.locked(step), self.free(step));
            for (curve_end, point) in locked.shape.corners() {
                self.locked_corner(
                    shortcut,
                    &locked,
                    &free,
                    (curve_end, point),
                    &level,
                    |hit| {
                        ties.admits(hit.gap).then(|| ties.offer(step, hit));
                    },
                )?;
                level.follow(self, ties);
            }
            for (curve_end, point) in free.shape.corners() {
                self.free_corner(
                    shortcut,
                    &locked,
                    &free,
                    (curve_end, point),
                    &level,
                    |hit| {
                        ties.admits(hit.gap).then(|| ties.offer(step, hit));
                    },
                )?;
                level.follow(self, ties);
            }
        }
        Ok(())
    }

    fn locked_corner(
        &self,
        shortcut: &Shortcut,
        locked: &Placed,
        free: &Placed,
        (roll, corner): (f64, C),
        level: &Level,
        mut offer: impl FnMut(Hit),
    ) -> Result<(), Beyond> {
        let point = locked.centre + locked.direction * corner;
        let near = own_frame(free, point * level.rotation.conj());
        if level.known {
            let outmost = free.shape.tip_radius + shortcut.free_off;
            match shortcut.free.place(near) {
                Place::Clear => return Ok(()),
                Place::Above if point.norm_sqr() > outmost * outmost => return Ok(()),
                Place::Above | Place::Unsure => {}
            }
        }
        let rho = point.norm_sqr().sqrt();
        if let Some((curve, t, mate)) = meet(free, shortcut.certificate.free_fillet, rho, near)? {
            offer(Hit {
                gap: (point * mate.conj() * self.origin).arg(),
                slack: 0.0,
                locked: (Curve::Involute, roll),
                free: (curve, t),
                point,
            });
        }
        Ok(())
    }

    fn free_corner(
        &self,
        shortcut: &Shortcut,
        locked: &Placed,
        free: &Placed,
        (roll, corner): (f64, C),
        level: &Level,
        mut offer: impl FnMut(Hit),
    ) -> Result<(), Beyond> {
        let mate = free.centre + free.direction * corner;
        let near = own_frame(locked, mate * level.rotation);
        if level.known {
            match shortcut.locked.place(near) {
                Place::Clear => return Ok(()),
                Place::Above if mate.norm_sqr() < square_of_least(locked) => return Ok(()),
                Place::Above | Place::Unsure => {}
            }
        }
        let rho = mate.norm_sqr().sqrt();
        let met = meet(locked, shortcut.certificate.locked_fillet, rho, near)?;
        if let Some((curve, t, point)) = met {
            offer(Hit {
                gap: (point * mate.conj() * self.origin).arg(),
                slack: 0.0,
                locked: (curve, t),
                free: (Curve::Involute, roll),
                point,
            });
        }
        Ok(())
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
