//! The position of a pin or ball at rest in a tooth space.
//!
//! Its centre is half its diameter from both flanks of the space, in the measuring plane of a helical gear. The gradient of the distance
//! from an outline is the unit vector from the nearest place. So Newton's method on the two distances converges quadratically. It starts on
//! the tip circle in the middle of the space. The half teeth include fillets, root and tip corners; a ball that stops there reports it.

use super::Unmeasured;
use super::flank_distance::{Nearest, OneFlank, nearest};
use super::workpiece::Workpiece;
use crate::contact::Touch;
use crate::gear::{Flank, ProfilePart};
use crate::parallel;
use nalgebra::{Matrix2, Point2, UnitComplex, Vector2};

/// A pin or ball at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Seat {
    /// The space after this tooth, towards the next number.
    pub tooth: u32,
    /// The pin's centre, mm, about the gear's own centre; the undisturbed tooth 1 points to +x.
    pub centre: Point2<f64>,
    /// Bound on the error of the centre, mm.
    pub error: f64,
    /// Touched places: own right flank of `tooth`, own left flank of the next.
    pub touched: [Touch; 2],
    /// Axial position of these places, mm from the measuring plane through its centre; 0 on a spur gear.
    pub sections: [f64; 2],
}

/// Limit of Newton steps; a dozen is already much.
const MOST_STEPS: usize = 60;
/// Longest step, modules. Distances have no sign, so a step must not pass through a tooth.
const LONGEST: f64 = 0.25;

/// Lays a pin of `diameter` into every space.
pub(super) fn seats(work: &Workpiece, diameter: f64) -> Result<Vec<Seat>, Unmeasured> {
    let teeth = 1..=work.as_built.gear().basic_data().teeth();
    let seats = parallel::map(teeth, |tooth| seat(work, tooth, diameter));
    // In order, so that the first of several faults is reported with any number of threads.
    seats.into_iter().collect()
}

/// Lays a pin of `diameter` into the space after `tooth`.
fn seat(work: &Workpiece, tooth: u32, diameter: f64) -> Result<Seat, Unmeasured> {
    let face = work.as_built.face();
    let gear = work.as_built.gear();
    let radius = 0.5 * diameter;
    let half = 0.5 * face.ascending();
    let ends = [
        (face.seen_from_front(Flank::Right), tooth, half),
        (
            face.seen_from_front(Flank::Left),
            work.tooth_after(tooth, 1),
            -half,
        ),
    ];
    // From the middle of the space.
    let flanks = ends.map(|(side, tooth, pitches)| OneFlank {
        side,
        tooth,
        turn: work.turn(side, tooth, pitches),
    });
    let query = |centre: Point2<f64>| flanks.each_ref().map(|flank| nearest(work, flank, centre));
    let seated = |centre: Point2<f64>, error: f64, found: [Nearest; 2]| {
        let to_tooth_1 = UnitComplex::new(work.as_built.tooth_angle(f64::from(tooth) + 0.5));
        Seat {
            tooth,
            centre: to_tooth_1 * centre,
            error,
            touched: [0, 1].map(|i: usize| Touch {
                tooth: flanks[i].tooth,
                curve: found[i].place.curve.into(),
                radius: found[i].place.at.coords.norm(),
            }),
            sections: found.map(|one| one.section),
        }
    };
    // A ball that reaches the root land with room on both sides rests on the root alone.
    let on_root = Point2::new(gear.root_radius() + radius, 0.0);
    let mut found = query(on_root);
    if found.iter().all(|f| f.distance >= radius - work.bound()) {
        for one in &mut found {
            one.place.curve = ProfilePart::Root;
        }
        return Ok(seated(on_root, work.bound(), found));
    }
    let longest = LONGEST * gear.basic_data().module();
    let mut centre = Point2::new(gear.tip_radius(), 0.0);
    for _ in 0..MOST_STEPS {
        let found = query(centre);
        let gradients = Matrix2::from_rows(&found.map(|f| f.gradient.transpose()));
        let lack = Vector2::new(radius - found[0].distance, radius - found[1].distance);
        let Some(step) = gradients.try_inverse().map(|inverse| inverse * lack) else {
            break;
        };
        let length = step.norm();
        if !length.is_finite() {
            break;
        }
        centre += step * (longest / length).min(1.0);
        if length <= work.bound() {
            // Each distance is within the bound. A centre between two gradients of the determinant D moves by at most √2 · √2/|D| as much.
            let error = length + 2.0 * work.bound() / gradients.determinant().abs();
            return Ok(seated(centre, error, found));
        }
    }
    Err(Unmeasured(format!(
        "a ball of {diameter} mm finds no rest in the space after tooth {tooth}"
    )))
}
