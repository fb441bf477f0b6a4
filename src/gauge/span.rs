//! Span `W_k`: two parallel anvils closed on the flanks of `k` teeth.
//!
//! Both anvils are plane and reach down to the form circle; a space is narrow, so only the flank that bounds the
//! teeth spanned can touch an anvil. Closed, they read the distance between the two places touched, along
//! their common normal. Rocking them leaves that distance alone while both touch involutes (the contacts move
//! along one line of action), and lets it fall once an anvil tilts over a tip corner or leaves the involute's lower end: the
//! reading is the greatest, and the anvils stand in the middle of the plateau.
//!
//! Flanks whose profiles deviate have no plateau: with a slope on one of them the distance grows all the way to its end. There the anvils
//! stand square to the middle of the teeth spanned, so that both touch at the same height, as a shop reads them; the thickness that is stated
//! by a span means that reading ([`crate::metrology`]).
//!
//! On helical teeth the anvils lean by the base helix angle, along the straight lines of the flanks: their normal is that of the helix, and the
//! places touched, on one such normal, stand in sections `W_k sin β_b` apart, the measuring plane in the middle.

use super::Unmeasured;
use super::spread::{ends, mean};
use super::workpiece::Workpiece;
use crate::contact::Touch;
use crate::gear::{Flank, ProfilePart};
use crate::parallel;
use nalgebra::{UnitComplex, Vector2};

/// One span.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Span {
    /// First of the teeth spanned, in ascending numbers.
    pub first_tooth: u32,
    /// `W_k`, mm; both anvils touch involutes.
    pub length: f64,
    /// Bound on its error, mm.
    pub error: f64,
    /// Where the anvils touched: the first tooth's own left flank, the last one's own right flank.
    pub touched: [Touch; 2],
    /// Where along the face, mm from the measuring plane; 0 on a spur gear.
    pub sections: [f64; 2],
}

/// `W_k` at every first tooth.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Spans {
    /// `k`.
    pub teeth: u32,
    /// By first tooth, from tooth 1.
    pub readings: Vec<Span>,
}

impl Spans {
    /// Mean span, mm.
    pub fn mean(&self) -> f64 {
        mean(self.readings.iter().map(|span| span.length))
    }

    /// Least and greatest span, mm.
    pub fn ends(&self) -> [f64; 2] {
        ends(self.readings.iter().map(|span| span.length))
    }

    /// Greatest bound on the error of a reading, mm.
    pub fn error(&self) -> f64 {
        self.readings
            .iter()
            .fold(0.0, |most, span| f64::max(most, span.error))
    }
}

/// Rocking steps; the first direction is right by symmetry unless a flank is not the other's mirror image.
const MOST_ROCKS: usize = 20;

/// Measures the span over `k` teeth all round.
pub(super) fn spans(work: &Workpiece, k: u32) -> Result<Spans, Unmeasured> {
    let basic_data = work.as_built.gear().basic_data();
    if k == 0 || k > basic_data.teeth() / 2 {
        return Err(Unmeasured(format!(
            "a span over {k} of {} teeth: allowed is 1 up to half of them",
            basic_data.teeth()
        )));
    }
    let readings = parallel::map(1..=basic_data.teeth(), |first| span(work, k, first));
    let spans = Spans {
        teeth: k,
        readings: readings.into_iter().collect::<Result<_, _>>()?,
    };
    match off_involute(work, &spans) {
        None => Ok(spans),
        Some(reason) => Err(Unmeasured(reason)),
    }
}

/// Why `spans` are none: a span is measured where both anvils touch involutes between the form circle and the tip corner.
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
    let last_tooth = work.after(first_tooth, k - 1);
    let half = 0.5 * f64::from(k - 1) * face.ascending();
    // Seen from the middle of the teeth spanned; the flanks' sides are the picture's.
    let ends = [
        (face.seen_from_front(Flank::Left), first_tooth, half),
        (face.seen_from_front(Flank::Right), last_tooth, -half),
    ];
    let turns = ends.map(|(side, tooth, pitches)| work.turn(side, tooth, pitches));
    let data = work.as_built.gear().basic_data();
    let (sin, cos) = data.base_helix_angle().sin_cos();
    // The places touched stand `apart` mm along the face, `along` within it.
    let read = |along: Vector2<f64>, apart: f64| {
        let sections = [0.5 * apart, -0.5 * apart];
        let turned = |i: usize| {
            if sections[i] == 0.0 {
                turns[i]
            } else {
                UnitComplex::new(data.twist() * sections[i]) * turns[i]
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
        // Where turning sections bring the first flank back along its normal, the helix's normal leads.
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
    // Anvils square to the line between the tip corners touch two mirrored flanks at mirrored places.
    let mut along = (corner(0) - corner(1)).normalize();
    let mut apart = 0.0;
    for _ in 0..MOST_ROCKS {
        let (span, join, ahead) = read(along, apart);
        // Each place is at most a chord behind its curve. No direction reads more than the distance of the places it touches.
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
