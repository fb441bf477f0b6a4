//! A deviated eccentric gear in closed form.
//!
//! Sources: involute and tooth thickness, ISO 21771. The distance of the fillet from the path of the tool's tip centre, a
//! trochoid, is the radius of that tip. A rotated involute is displaced by its base radius times the angle.

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::path::{Path, PathBuf};

pub const TEETH: usize = 19;
const MODULE: f64 = 2.5;
const ALPHA: f64 = 20.0 * PI / 180.0;
const SHIFT: f64 = 0.2;
const ALLOWANCE: f64 = -0.05;
pub const ECCENTRICITY: f64 = 0.12;
const HIGH_TOOTH: f64 = 6.3;

/// Deviations in µm with a mean of 0: thickness, and pitch of right and left flanks.
fn deviations() -> [Vec<f64>; 3] {
    let wave = |waves: f64, size: f64| {
        let teeth =
            (0..TEETH).map(|i| (size * (TAU * waves * i as f64 / TEETH as f64).sin()).round());
        let list: Vec<f64> = teeth.collect();
        assert_eq!(list.iter().sum::<f64>(), 0.0);
        list
    };
    [wave(2.0, 60.0), wave(3.0, 40.0), wave(4.0, 50.0)]
}

pub fn gear_file(folder: &Path, face: &str) -> PathBuf {
    let [thickness, right, left] = deviations();
    let file = folder.join(format!("{face}.toml"));
    let text = format!(
        r#"
title = "deviated <{face}> & eccentric é"
[gear]
teeth = {TEETH}
module_mm = {MODULE:?}
pressure_angle_deg = 20.0
profile_shift = {SHIFT:?}
reference_face = "{face}"
thickness = {{ allowance_um = {:?}, per_tooth_um = {thickness:?} }}
runout = {{ total_um = {:?}, high_tooth = {HIGH_TOOTH:?} }}
pitch = {{ kind = "cumulative", right_um = {right:?}, left_um = {left:?} }}
"#,
        ALLOWANCE * 1e3,
        2e3 * ECCENTRICITY
    );
    std::fs::write(&file, text).unwrap();
    file
}

pub type Point = [f64; 2];

fn turned([x, y]: Point, angle: f64) -> Point {
    let (sin, cos) = angle.sin_cos();
    [x * cos - y * sin, x * sin + y * cos]
}

fn reference() -> f64 {
    0.5 * MODULE * TEETH as f64
}

fn base() -> f64 {
    reference() * ALPHA.cos()
}

pub fn tip() -> f64 {
    reference() + MODULE * (1.0 + SHIFT)
}

/// x_E, the generating shift.
fn generating() -> f64 {
    SHIFT + ALLOWANCE / (2.0 * MODULE * ALPHA.tan())
}

pub fn root() -> f64 {
    reference() - MODULE * (1.25 - generating())
}

/// The outline's centre: the gear turns about the origin, and teeth count clockwise from +y.
fn centre() -> Point {
    let turn = FRAC_PI_2 - (HIGH_TOOTH - 1.0) * TAU / TEETH as f64;
    turned([ECCENTRICITY, 0.0], turn)
}

/// A point as seen from a tooth (0 …): about the outline's centre, the flank nearer to it mirrored to the counter-clockwise
/// side and turned back by its deviations, the centre line on +x.
pub fn on_flank(point: Point) -> (usize, bool, Point) {
    let [x, y] = centre();
    let point = [point[0] - x, point[1] - y];
    let pitch = TAU / TEETH as f64;
    let clockwise = (FRAC_PI_2 - point[1].atan2(point[0])) / pitch;
    let tooth = clockwise.round().rem_euclid(TEETH as f64) as usize;
    let is_left = clockwise.round() > clockwise;
    let [thickness, right, left] = deviations();
    let thicker = 1e-3 * thickness[tooth] / (2.0 * reference());
    let along = 1e-3 * if is_left { left[tooth] } else { right[tooth] } / reference();
    let [x, y] = turned(point, clockwise.round() * pitch - FRAC_PI_2 + along);
    let mirrored = if is_left { [x, y] } else { [x, -y] };
    (tooth, is_left, turned(mirrored, -thicker))
}

/// How far a point as seen from its tooth lies beside the involute, mm, outside positive.
pub fn beside_involute([x, y]: Point) -> f64 {
    let radius = x.hypot(y);
    let inv = |alpha: f64| alpha.tan() - alpha;
    let thickness = MODULE * (FRAC_PI_2 + 2.0 * SHIFT * ALPHA.tan()) + ALLOWANCE;
    let half =
        thickness / (2.0 * reference()) + inv(ALPHA) - inv((base() / radius).min(1.0).acos());
    base() * (y.atan2(x) - half)
}

/// The same beside the fillet, without sign: the ISO 53 rack's tip of radius 0.38 m, 1.25 m deep.
pub fn beside_fillet([x, y]: Point) -> f64 {
    let depth = MODULE * (1.25 - 0.38 - generating());
    let half_tool = MODULE * (PI / 4.0 - (1.25 - 0.38) * ALPHA.tan() - 0.38 / ALPHA.cos());
    let beside = FRAC_PI_2 * MODULE - half_tool;
    let distance = |t: f64| {
        let [u, v] = turned([reference() - depth, beside + reference() * t], -t);
        (u - x).hypot(v - y)
    };
    // The nearest of a scan, then a ternary search.
    let scan = (-200..=200).map(|i| f64::from(i) * 5e-3);
    let near = scan
        .min_by(|a, b| distance(*a).total_cmp(&distance(*b)))
        .unwrap();
    let (mut low, mut high) = (near - 5e-3, near + 5e-3);
    while high - low > 1e-9 {
        let third = (high - low) / 3.0;
        if distance(low + third) < distance(high - third) {
            high -= third
        } else {
            low += third
        }
    }
    (distance(low) - 0.38 * MODULE).abs()
}

/// Where the involute ends: at the roll tan α − 4 (depth of the tool's straight flank)/(m z sin 2α), ISO 21771.
pub fn form() -> f64 {
    let straight = 1.25 - 0.38 * (1.0 - ALPHA.sin()) - generating();
    let roll = ALPHA.tan() - 4.0 * straight / (TEETH as f64 * (2.0 * ALPHA).sin());
    base() * roll.hypot(1.0)
}

pub fn radius([x, y]: Point) -> f64 {
    x.hypot(y)
}

/// Checks that every vertex of a closed polygon lies on the gear's curves and that the outline goes round all its teeth.
pub fn check_vertices(points: &[Point]) {
    let mut flanks = BTreeSet::new();
    for point in points {
        let (tooth, is_left, seen) = on_flank(*point);
        let at = radius(seen);
        let off = match at {
            at if (at - tip()).abs() < 1e-9 || (at - root()).abs() < 1e-9 => 0.0,
            at if at > form() => {
                flanks.insert((tooth, is_left));
                beside_involute(seen).abs()
            }
            _ => beside_fillet(seen),
        };
        assert!(off < 1e-9, "{off} mm at {point:?}, radius {at}");
    }
    assert_eq!(flanks.len(), 2 * TEETH);
    let next = points.iter().cycle().skip(1);
    let inside = |point: &Point| radius(on_flank(*point).2) < reference();
    let crossings = points
        .iter()
        .zip(next)
        .filter(|(a, b)| inside(a) != inside(b));
    assert_eq!(crossings.count(), 2 * TEETH);
}
