//! Span `W_k`: two parallel anvils closed on the flanks of `k` teeth.
//!
//! Both anvils are plane and reach down to the form circle. A space is narrow, so an anvil can touch only the flank that bounds the spanned
//! teeth. The closed anvils measure the distance of the two contacts along their common normal. Rocking keeps that distance while both
//! touch involutes, because the contacts move along one line of action. It falls once an anvil tilts over a tip corner or leaves the
//! involute's lower end. The reading is the greatest distance, with the anvils in the middle of the plateau.
//!
//! Flanks whose profiles deviate have no plateau: with a slope on one of them the distance grows to its end. Then the
//! anvils are perpendicular to the middle of the spanned teeth, so that both touch at the same height, as a shop reads
//! them. A span in a gear file means that reading ([`crate::metrology`]).
//!
//! On helical teeth the anvils are tilted by the base helix angle, parallel to the straight lines of the flanks. Their normal is that of
//! the helix. Both contacts are on one such normal, in sections `W_k sin β_b` apart, with the measuring plane in the middle.

use super::workpiece::Workpiece;
use super::{Summary, Unmeasured};
use crate::contact::Touch;
use crate::gear::{Flank, ProfilePart};
use crate::parallel;
use nalgebra::{UnitComplex, Vector2};

/// One span.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Span {
    /// First of the spanned teeth, in ascending numbers.
    pub first_tooth: u32,
    /// `W_k`, mm; both anvils touch involutes.
    pub length: f64,
    /// Bound on its error, mm.
    pub error: f64,
    /// Contacts of the anvils: the first tooth's own left flank, the last one's own right flank.
    pub touched: [Touch; 2],
    /// Axial positions of the contacts, mm from the measuring plane; 0 on a spur gear.
    pub sections: [f64; 2],
}

/// `W_k` at every first tooth.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Spans {
    /// `k`.
    pub teeth: u32,
    /// Readings by first tooth, from tooth 1.
    pub readings: Vec<Span>,
}

impl Spans {
    /// The readings in short.
    pub fn summary(&self) -> Summary {
        Summary::of(self.readings.iter().map(|span| (span.length, span.error)))
    }
}

/// Limit of rocking steps. By symmetry the first direction is right, except for flanks that do not mirror each other.
const MOST_ROCKS: usize = 20;

/// Measures the span over `k` teeth all round.
pub(super) fn spans(work: &Workpiece, k: u32) -> Result<Spans, Unmeasured> {
    let teeth = work.as_built.gear().basic_data().teeth();
    check_spanned(k, teeth)?;
    let readings = parallel::map(1..=teeth, |first| span(work, k, first));
    let spans = Spans {
        teeth: k,
        readings: readings.into_iter().collect::<Result<_, _>>()?,
    };
    match off_involute(work, &spans) {
        None => Ok(spans),
        Some(reason) => Err(Unmeasured(reason)),
    }
}

/// An error unless `k` of `teeth` can be spanned.
pub(super) fn check_spanned(k: u32, teeth: u32) -> Result<(), Unmeasured> {
    if (1..=teeth / 2).contains(&k) {
        return Ok(());
    }
    Err(Unmeasured(format!(
        "a span over {k} of {teeth} teeth: allowed is 1 up to half of them"
    )))
}

/// The reason why `spans` are not valid: a span needs both anvils on involutes between the form circle and the tip corner.
fn off_involute(work: &Workpiece, spans: &Spans) -> Option<String> {
    let gear = work.as_built.gear();
    let off = |ends: fn(&Workpiece, &Touch) -> bool| {
        let touches = |span: &&Span| span.touched.iter().any(|touch| ends(work, touch));
        spans.readings.iter().filter(touches).count()
    };
    let [tip, form] = [
        off(|_, touch| touch.curve == ProfilePart::Tip),
        off(|work, touch| work.ends_involute(touch.radius)),
    ];
    let (count, place, help) = match (tip, form) {
        (0, 0) => return None,
        (0, form) => {
            let place = format!(
                "the involute's lower end, the form circle of {:.3} mm",
                2.0 * gear.form_radius()
            );
            (form, place, "more")
        }
        (tip, _) => (tip, "the tip corner".to_owned(), "fewer"),
    };
    Some(format!(
        "over {} of {} teeth, {count} of {} readings touch {place}: span {help} teeth",
        spans.teeth,
        gear.basic_data().teeth(),
        spans.readings.len(),
    ))
}

fn span(work: &Workpiece, k: u32, first_tooth: u32) -> Result<Span, Unmeasured> {
    let face = work.as_built.face();
    let last_tooth = work.tooth_after(first_tooth, k - 1);
    let half = 0.5 * f64::from(k - 1) * face.ascending();
    // From the middle of the spanned teeth; sides of flanks are those of the picture.
    let ends = [
        (face.seen_from_front(Flank::Left), first_tooth, half),
        (face.seen_from_front(Flank::Right), last_tooth, -half),
    ];
    let turns = ends.map(|(side, tooth, pitches)| work.turn(side, tooth, pitches));
    let data = work.as_built.gear().basic_data();
    let (sin, cos) = data.base_helix_angle().sin_cos();
    // The contacts are `apart` mm apart along the face and `along` within it.
    let read = |along: Vector2<f64>, apart: f64| {
        let sections = [0.5 * apart, -0.5 * apart];
        let turned = |i: usize| {
            if sections[i] == 0.0 {
                turns[i]
            } else {
                let (side, tooth, _) = ends[i];
                let gear = work.as_built;
                let lead = gear.lead_change(side, tooth, [0.0, sections[i]]);
                let by_lead = side.sense() * lead / gear.gear().base_radius();
                UnitComplex::new(data.twist() * sections[i] + by_lead) * turns[i]
            }
        };
        let placed = [0, 1].map(|i: usize| {
            let outward = if i == 0 { along } else { -along };
            let turn = turned(i);
            let place = work.foremost(ends[i].0, ends[i].1, turn.inverse() * outward);
            (place, turn * place.at)
        });
        let [(_, one), (_, other)] = placed;
        let join = one - other;
        let touch = |i: usize| Touch {
            tooth: ends[i].1,
            curve: placed[i].0.curve.into(),
            radius: placed[i].0.at.coords.norm(),
        };
        // If turning sections bring the first flank back along its normal, the normal of the helix leads.
        let ahead = -(data.twist() * one.coords.perp(&along)).signum();
        let span = Span {
            first_tooth,
            length: match data.hand() {
                None => along.dot(&join),
                Some(_) => cos * along.dot(&join) + sin * ahead * apart,
            },
            error: 2.0 * work.bound(),
            touched: [touch(0), touch(1)],
            sections,
        };
        (span, join, ahead)
    };
    if work.as_built.is_modified() {
        let square = Vector2::new(0.0, -face.ascending());
        let (span, _, ahead) = read(square, 0.0);
        return Ok(match data.hand() {
            None => span,
            Some(_) => read(square, ahead * sin * span.length).0,
        });
    }
    let corner = |i: usize| {
        let profile = work.as_built.profile(ends[i].0, ends[i].1);
        let (tip, _) = profile.range(ProfilePart::Involute);
        let corner = profile.point(ProfilePart::Involute, tip, ends[i].0);
        turns[i] * corner
    };
    // Anvils perpendicular to the line between the tip corners touch two mirrored flanks at mirrored places.
    let mut along = (corner(0) - corner(1)).normalize();
    let mut apart = 0.0;
    for _ in 0..MOST_ROCKS {
        let (span, join, ahead) = read(along, apart);
        // Each place is at most a chord behind its curve. No direction gives more than the distance of its two contacts.
        if join.norm().hypot(apart) - span.length <= work.bound() {
            return Ok(span);
        }
        along = join.normalize();
        if data.hand().is_some() {
            apart = ahead * sin * span.length;
        }
    }
    Err(Unmeasured(format!(
        "the anvils found no hold on the teeth from {first_tooth} to {last_tooth}"
    )))
}
