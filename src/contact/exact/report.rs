//! Converts a touching pair in the frame of [`super::flank_problem`] to a [`Contact`] in the picture.

use super::flank_problem::PosedFlanks;
use super::shape::HalfToothShape;
use super::tightest::FirstContact;
use crate::contact::lost_motion::{Contact, ContactInFrame, Touch};
use crate::gear::ProfilePart;
use crate::pair::Member;

/// Distance, mm, within which a contact is on a circle: on the tip circle at the tip corner (the rule of the reference
/// data), on the root circle at the root. Below the root circle the gear is solid all round.
const CORNER_MM: f64 = 1e-7;

/// The contact of `first_contact`; its rotation is not yet normalised.
pub(super) fn contact(posed: &PosedFlanks, first_contact: &FirstContact, free: Member) -> Contact {
    let (problem, candidate) = (posed.problem, &first_contact.candidate);
    let radius = candidate.point.norm_sqr().sqrt();
    let error = problem.rounding(radius, candidate.slope) + candidate.slack;
    let (locked_place, free_place) = posed.places(first_contact.step);
    let locked = touch(
        problem.locked.shape_at(locked_place),
        problem.locked.number(locked_place),
        candidate.locked,
    );
    let mated = touch(
        problem.free.shape_at(free_place),
        problem.free.number(free_place),
        candidate.free,
    );
    ContactInFrame {
        side: problem.side,
        free,
        center_distance: problem.distance,
        rotation: posed.rotation(first_contact.greatest),
        error,
        locked,
        mated,
        point: candidate.point,
        normal: candidate.normal,
    }
    .contact()
}

/// The curve as results name it. The end of an involute at the tip circle is the tip corner. The end of a fillet
/// belongs to the involute or to the root.
fn touch(shape: &HalfToothShape, tooth: u32, (curve, t): (ProfilePart, f64)) -> Touch {
    let radius = shape.radius(curve, t);
    let curve = match curve {
        ProfilePart::Involute if radius > shape.tip_radius - CORNER_MM => ProfilePart::Tip,
        ProfilePart::Fillet if t >= shape.fillet_end => ProfilePart::Involute,
        ProfilePart::Fillet if radius < shape.root_radius + CORNER_MM => ProfilePart::Root,
        other => other,
    };
    Touch {
        tooth,
        curve: curve.into(),
        radius,
    }
}
