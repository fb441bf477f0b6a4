//! The gauge against formulas, published values and the deviations that were put in. Lengths in mm.

mod as_built;
mod drawn;
mod helical;
#[path = "../common/kit.rs"]
mod kit;
mod lead;
mod outlines;
#[path = "../common/paths.rs"]
mod paths;
mod perfect;
mod profile;
mod roll;

#[path = "../common/made_up.rs"]
mod made_up;

use gearlash::analytic::InvolutePair;
use gearlash::contact::{ContactKind, CutPair, PoseClass, ToothPlace};
use gearlash::error::go_on;
use gearlash::gauge::{
    FaceReadings, Gauged, OverPins, Pins, ProfileReadings, Roll, RollPose, Seat, Settings, Span,
    StatedThickness, Unmeasured, gauge, gauge_outline,
};
use gearlash::gear::{
    AsBuilt, Deviations, Face, Flank, Gear, Hand, Lead, MeasuringBody, Modification, PinReadings,
    Pitch, PitchAxis, Probe, ProfilePart, Readings, Relief, RunoutReadings, Side, Spans, Trace,
    involute, separate_eccentricity, thickness,
};
use gearlash::metrology::{
    Measurements, PitchKind, PitchSense, PitchStatement, ProbeReadings, ReadWith, Runout,
    RunoutStatement, ThicknessStatement, Toleranced,
};
use gearlash::outline::{
    OutlineDifference, OutlineGear, OutlineReading, PathSegment, fit_involute, of_gear,
};
use gearlash::pair::{GearPair, Member, Pose};
use kit::{Make, ends, inv, near, rows, spur, spur_of_angle};
use made_up::{made_up, scaled};
use nalgebra::{Point2, Point3, Rotation2, Vector2, Vector3};
use paths::{READING, arc, polar, polygon, repeated, symmetrical, turned};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Issue 5: 1e-6 µm.
const PICOMETRE: f64 = 1e-9;

const ALPHA: f64 = PI / 9.0;

fn measure(gear: &AsBuilt, settings: Settings) -> Gauged {
    gauge(gear, &settings, &|_| (), &go_on).unwrap()
}

/// A few poses of the roll test only: for tests of the other gauges.
fn quick() -> Settings {
    Settings {
        steps_per_pitch: 1,
        ..Settings::default()
    }
}

fn with_ball(ball: f64) -> Settings {
    Settings {
        ball: Some(ball),
        ..quick()
    }
}

fn with_span(teeth: u32) -> Settings {
    Settings {
        span_teeth: Some(teeth),
        ..quick()
    }
}

fn with_pin(pin: f64, span_teeth: Option<u32>) -> Settings {
    Settings {
        pin: Some(pin),
        span_teeth,
        ..quick()
    }
}

fn over_face(face: [f64; 2]) -> Settings {
    Settings { face, ..quick() }
}

/// Cumulative pitch about the axis of the teeth.
fn own_pitch(right_um: Vec<f64>, left_um: Vec<f64>) -> PitchStatement {
    PitchStatement {
        kind: PitchKind::Cumulative,
        axis: PitchAxis::Own,
        sense: PitchSense::Numbers,
        eccentricity: None,
        right_um,
        left_um,
    }
}

/// A helical gear of module 3 with room at its tips.
fn helical(teeth: u32, beta_deg: f64, hand: Hand, shift: f64) -> Make {
    let gear = spur(teeth, 3.0).rack(1.0, 1.25, 0.25).shift(shift);
    gear.helix(beta_deg, hand)
}

fn read(path: &[PathSegment], face: Face, teeth: Option<u32>, bound: f64) -> OutlineGear {
    let reading = OutlineReading {
        face,
        teeth,
        bound,
        ..READING
    };
    OutlineGear::new(path, &reading).unwrap()
}

/// A gear with deviations of every kind: per-tooth thickness ±8 µm in the normal section, pitch ±12 µm, runout. Its flanks are written out as surfaces:
/// the section at the measuring plane turned by `−η tan β/r` a mm, every flank where its tooth has it.
struct Made {
    gear: AsBuilt,
    deviations: Deviations,
    per_tooth: Vec<f64>,
    right: Vec<f64>,
    left: Vec<f64>,
    teeth: u32,
    beta: f64,
    /// Reference radius.
    radius: f64,
    base: f64,
    /// Half the base thickness, as an angle.
    half: f64,
    twist: f64,
}

fn made(teeth: u32, beta_deg: f64, hand: Hand, face: Face, eccentricity: f64) -> Made {
    let per_tooth = scaled(&made_up(teeth, 1), 8e-3);
    let [right, left] = [2, 3].map(|seed| scaled(&made_up(teeth, seed), 12e-3));
    let make = helical(teeth, beta_deg, hand, 0.2).allowance(-0.06);
    let make = make.runout(eccentricity, 5.25).pitch(&right, &left);
    let make = make.per_tooth(per_tooth.clone());
    let eta = if hand == Hand::Right { 1.0 } else { -1.0 };
    let beta = beta_deg.to_radians();
    let radius = 1.5 * f64::from(teeth) / beta.cos();
    let base = radius * (ALPHA.tan() / beta.cos()).atan().cos();
    Made {
        half: make.gear().base_thickness() / (2.0 * base),
        twist: -eta * beta.tan() / radius,
        gear: make.built(face),
        deviations: make.deviations,
        per_tooth,
        right,
        left,
        teeth,
        beta,
        radius,
        base,
    }
}

/// The two helical ones.
fn in_space() -> [Made; 2] {
    [(Hand::Left, Face::Front), (Hand::Right, Face::Back)]
        .map(|(hand, face)| made(23, 24.0, hand, face, 0.021))
}

impl Made {
    /// Where the flank of a tooth stands ahead of its place along ascending numbers, as an arc in the transverse section: its pitch deviation, and half
    /// the thickness outwards. Own right flanks face ascending numbers.
    fn stands(&self, own: Flank, tooth: u32) -> f64 {
        let index = (tooth - 1) as usize % self.teeth as usize;
        let half_arc = 0.5 * self.per_tooth[index] / self.beta.cos();
        match own {
            Flank::Right => self.right[index] + half_arc,
            Flank::Left => self.left[index] - half_arc,
        }
    }

    /// −1 on a gear that shows its front, where numbers ascend clockwise.
    fn ascending(&self) -> f64 {
        self.gear.face().ascending()
    }

    /// `sin β_b`.
    fn base_sin(&self) -> f64 {
        self.beta.sin() * ALPHA.cos()
    }

    fn base_cos(&self) -> f64 {
        (1.0 - self.base_sin().powi(2)).sqrt()
    }

    fn alpha_t(&self) -> f64 {
        (ALPHA.tan() / self.beta.cos()).atan()
    }

    fn pitches(&self, count: u32) -> f64 {
        TAU * f64::from(count) / f64::from(self.teeth)
    }

    fn point(&self, own: Flank, tooth: u32, xi: f64, b: f64) -> Point3<f64> {
        let ahead = if own == Flank::Right { 1.0 } else { -1.0 };
        let along = self.pitches(tooth - 1)
            + ahead * (self.half - (xi - xi.atan()))
            + self.stands(own, tooth) / self.radius;
        let (sin, cos) = (self.ascending() * along + self.twist * b).sin_cos();
        let radius = self.base * xi.hypot(1.0);
        Point3::new(radius * cos, radius * sin, b)
    }

    /// The least `value` of a flank's points, by a grid that is narrowed round its least place.
    fn least(&self, own: Flank, tooth: u32, value: impl Fn(&Point3<f64>) -> f64) -> f64 {
        let (mut middle, mut reach) = ([0.5, 0.0], [0.4, 12.0]);
        let mut least = f64::INFINITY;
        for _ in 0..60 {
            let mut at = middle;
            for i in -20..=20 {
                for j in -20..=20 {
                    let xi = middle[0] + reach[0] * f64::from(i) / 20.0;
                    let b = middle[1] + reach[1] * f64::from(j) / 20.0;
                    let here = value(&self.point(own, tooth, xi, b));
                    if here < least {
                        (least, at) = (here, [xi, b]);
                    }
                }
            }
            middle = at;
            reach = reach.map(|reach| 0.7 * reach);
        }
        least
    }
}
