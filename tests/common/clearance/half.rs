//! An independent half tooth from formulas: half the tooth's thickness as an angle over the radius, and the signed clearance of any point. About the
//! gear's centre, the tooth's centre line lies on +x and the flank at negative angles. Left half teeth are mirrored into this frame.

use crate::kit::halved;
use gearlash::gear::{AsBuilt, DeviationCurve, Gear, Side};
use std::f64::consts::{FRAC_PI_2, PI};

/// Parameters of the fillet that are stored as starts of its inversion.
const TABLE: usize = 64;

/// The data that all teeth of a gear share.
pub struct Half {
    base: f64,
    pub tip: f64,
    pub root: f64,
    reference: f64,
    /// `ψ_b`, half the angle of a tooth on the base circle.
    half_base: f64,
    /// Depth `h` of the centre of the tool's tip radius below the pitch line, and that radius `ρ`, mm.
    depth: f64,
    round: f64,
    /// `ρ/cos β`: in the transverse section of a helical gear the tool's tip is an ellipse with this half width along the pitch line.
    wide: f64,
    /// Angle from the tooth's centre line to the start of the root land.
    pub land: f64,
    /// Fillet: greatest `γ`, and the radius there, where the involute starts.
    gamma: f64,
    pub form: f64,
    /// Radii at `γ` in equal steps.
    table: Vec<f64>,
    /// The profile deviation from the involute, along its normal.
    deviation: Option<DeviationCurve>,
}

/// The two ends of one tooth's half: angles from its centre line.
#[derive(Clone, Copy)]
pub struct Ends {
    /// Past the centre line: the tip corner of the tooth's other flank.
    pub far: f64,
    /// On the flank's side: the middle of the space.
    pub space: f64,
}

impl Ends {
    /// `other` is the half tooth on the tooth's other side.
    pub fn new(other: &Half, gear: &AsBuilt, side: Side, tooth: u32) -> Ends {
        let widening = gear.flank_offset(Side::Left, tooth) - gear.flank_offset(Side::Right, tooth);
        Ends {
            far: other.half_angle(other.tip) + widening,
            space: gear.root_end(side, tooth),
        }
    }
}

/// The clearance of a point from a half tooth.
#[derive(Clone, Copy)]
pub struct Clearance {
    /// Negative in the metal.
    pub mm: f64,
    /// For a point in the metal: whether its nearest bound is the cut at an end of the half tooth instead of a curve.
    pub cut: bool,
    /// Distance from that end.
    pub end: f64,
}

impl Half {
    /// From the drawing's numbers and the mean base thickness alone.
    pub fn new(gear: &Gear) -> Half {
        let design = gear.design();
        let basic_data = &design.basic_data;
        let (teeth, module) = (f64::from(basic_data.teeth()), basic_data.module());
        // Data of the normal section; in the transverse section the tool is wider by 1/cos β, and equally high.
        let (normal, cos) = (basic_data.pressure_angle(), basic_data.helix_angle().cos());
        let alpha = (normal.tan() / cos).atan();
        let reference = 0.5 * module * teeth / cos;
        let base = reference * alpha.cos();
        let half_base = gear.base_thickness() / (2.0 * base);
        // Thickness at the reference circle s = 2 r (ψ_b − inv α) = m (π/2 + 2 x_E tan α)/cos β.
        let fed = cos * reference * (half_base - (alpha.tan() - alpha)) / normal.tan()
            - 0.25 * PI * module / normal.tan();
        let round = design.rack.root_radius() * module;
        let depth = design.rack.dedendum() * module - round - fed;
        // From the middle of the tool's tip to the centre of its radius.
        let flat = 0.25 * PI * module
            - (design.rack.dedendum() * module - round) * normal.tan()
            - round / normal.cos();
        let mut half = Half {
            base,
            tip: gear.tip_radius(),
            root: reference - depth - round,
            reference,
            half_base,
            depth,
            round,
            wide: round / cos,
            land: PI / teeth - flat.max(0.0) / (cos * reference),
            gamma: FRAC_PI_2 - alpha,
            form: 0.0,
            table: Vec::new(),
            deviation: None,
        };
        half.end_fillet();
        let share = |k: usize| half.gamma * k as f64 / TABLE as f64;
        half.table = (0..=TABLE).map(|k| half.fillet(share(k)).0).collect();
        half.form = half.table[TABLE];
        half
    }

    /// The half tooth with a profile deviation, its fillet turned to meet the end of the flank.
    pub fn deviating(self, deviation: &DeviationCurve) -> Half {
        let nominal = self.involute(self.form);
        let mut half = Half {
            deviation: Some(deviation.clone()),
            ..self
        };
        half.land += half.involute(half.form) - nominal;
        half
    }

    /// Undercut: the fillet ends where it crosses the involute, outside the start of the tool's flank.
    fn end_fillet(&mut self) {
        let alpha = FRAC_PI_2 - self.gamma;
        let touching = self.reference * alpha.sin() - self.rolled_to(self.gamma)[0] / alpha.sin();
        if touching >= 0.0 {
            return;
        }
        // Metal is outside both the tip radius and the flank; past the crossing the tip radius removes less.
        let is_inner = |gamma: f64| {
            let (radius, angle) = self.fillet(gamma);
            radius < self.base || -angle < self.involute(radius)
        };
        [_, self.gamma] = halved(0.0, self.gamma, 200, is_inner);
    }

    /// Polar coordinates of the fillet at `γ`, where the contact normal through the pitch point has that angle from the depth: (depth) × tan γ beside it.
    fn fillet(&self, gamma: f64) -> (f64, f64) {
        let [deep, rolled] = self.rolled_to(gamma);
        let (out, aside) = (self.reference - deep, deep * gamma.tan());
        (out.hypot(aside), aside.atan2(out) - rolled - self.land)
    }

    /// The point on the tool's tip whose normal makes `γ` with the depth: its depth below the pitch line, mm, and the roll, rad, until that normal
    /// passes the pitch point. The ellipse has the half axes `ρ/cos β` along the pitch line and `ρ`.
    fn rolled_to(&self, gamma: f64) -> [f64; 2] {
        let (sin, cos) = gamma.sin_cos();
        let size = (self.wide * sin).hypot(self.round * cos);
        let from_centre = match size > 0.0 {
            true => [self.wide * self.wide * sin, self.round * self.round * cos].map(|v| v / size),
            false => [0.0; 2],
        };
        let deep = self.depth + from_centre[1];
        [deep, (deep * gamma.tan() - from_centre[0]) / self.reference]
    }

    /// `γ` of the fillet at `radius`: bracketed by the table, then the secant rule within its bracket (Illinois).
    fn gamma_at(&self, radius: f64) -> f64 {
        let k = self.table.partition_point(|&r| r <= radius).clamp(1, TABLE);
        let at = |k: usize| self.gamma * k as f64 / TABLE as f64;
        let (mut a, mut b) = (at(k - 1), at(k));
        let (mut fa, mut fb) = (self.table[k - 1] - radius, self.table[k] - radius);
        if fa >= 0.0 {
            return a;
        }
        if fb <= 0.0 {
            return b;
        }
        for _ in 0..100 {
            let secant = (a * fb - b * fa) / (fb - fa);
            let is_inside = secant > a && secant < b;
            let c = if is_inside { secant } else { 0.5 * (a + b) };
            if b - a <= 1e-16 * self.gamma || !(c > a && c < b) {
                break;
            }
            let fc = self.fillet(c).0 - radius;
            match fc < 0.0 {
                true => (a, fa, fb) = (c, fc, 0.5 * fb),
                false => (b, fb, fa) = (c, fc, 0.5 * fa),
            }
        }
        0.5 * (a + b)
    }

    fn involute(&self, radius: f64) -> f64 {
        let tangent = f64::sqrt(((radius - self.base) * (radius + self.base)).max(0.0));
        let tangent = tangent / self.base;
        self.half_base - (self.rolled(tangent) - tangent.atan())
    }

    /// The roll of the point whose tangent to the base circle is `tangent` base radii long, less the deviation.
    fn rolled(&self, tangent: f64) -> f64 {
        let Some(deviation) = &self.deviation else {
            return tangent;
        };
        let mut roll = tangent;
        // A contraction: the slope of a deviation is a small part of the base radius.
        for _ in 0..200 {
            let next = tangent - deviation.at(roll) / self.base;
            if (next - roll).abs() <= 1e-16 {
                break;
            }
            roll = next;
        }
        roll
    }

    /// Half the tooth's angle at `radius`, from the root circle up; outside the tip circle that of the extended involute.
    pub fn half_angle(&self, radius: f64) -> f64 {
        self.edge(radius).0
    }

    /// Half the tooth's angle, and the component of the flank's normal along the circle.
    fn edge(&self, radius: f64) -> (f64, f64) {
        if radius >= self.form {
            return (self.involute(radius), (self.base / radius).min(1.0));
        }
        let gamma = self.gamma_at(radius);
        let (_, angle) = self.fillet(gamma);
        // The normal is `γ` off the radius through the pitch point.
        let pitch_point = -self.rolled_to(gamma)[1] - self.land;
        (-angle, (pitch_point - gamma - angle).sin().abs())
    }

    /// Signed clearance of the point (x, y): its distance to first order near the half tooth's curves, negative in the metal. Metal past the far corner
    /// or the middle of the space belongs to other half teeth, so it is cut off along the radius there.
    pub fn clearance(&self, x: f64, y: f64, ends: Ends) -> Clearance {
        let (radius, angle) = (x.hypot(y), y.atan2(x));
        let beyond = (angle - ends.far) * radius;
        let before = (-ends.space - angle) * radius;
        let over_root = radius - self.root;
        let to_corner = (radius - self.tip).hypot(beyond);
        let to_space = over_root.hypot(before);
        if over_root <= 0.0 {
            let (cut, end) = match before > beyond {
                true => (before, to_space),
                false => (beyond, to_corner),
            };
            return Clearance {
                mm: if cut > 0.0 { end } else { over_root.max(cut) },
                cut: cut > over_root,
                end,
            };
        }
        let (half, across) = self.edge(radius);
        let beside = (-half - angle) * radius * across;
        // Past the end of the space the whole half tooth is on the other side of the radius there.
        let from_flank = beside.max(radius - self.tip).max(before);
        let from_tooth = match from_flank < 0.0 && beyond > 0.0 {
            true => to_corner,
            false => from_flank.max(beyond),
        };
        let over_land = if before > 0.0 { to_space } else { over_root };
        Clearance {
            mm: from_tooth.min(over_land),
            cut: beyond > from_flank,
            end: to_corner,
        }
    }

    /// The whole half tooth from 0, the far corner, to 4, the middle of the space: one unit per curve.
    pub fn along(&self, t: f64, ends: Ends) -> [f64; 2] {
        let curve = (t as usize).min(3);
        self.point(curve, t - curve as f64, ends)
    }

    /// The curves, each from 0 to 1: tip land from the far corner, involute, fillet, root land.
    fn point(&self, curve: usize, t: f64, ends: Ends) -> [f64; 2] {
        let (radius, angle) = match curve {
            0 => {
                let corner = -self.involute(self.tip);
                (self.tip, ends.far + (corner - ends.far) * t)
            }
            1 => {
                let roll = |radius: f64| ((radius / self.base).powi(2) - 1.0).max(0.0).sqrt();
                let (tip, form) = (roll(self.tip), roll(self.form));
                let tangent = tip + (form - tip) * t;
                let angle = self.rolled(tangent) - tangent.atan() - self.half_base;
                (self.base * tangent.hypot(1.0), angle)
            }
            2 => self.fillet(self.gamma * (1.0 - t)),
            _ => (self.root, -self.land + (self.land - ends.space) * t),
        };
        [radius * angle.cos(), radius * angle.sin()]
    }
}
