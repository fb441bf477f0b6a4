//! Fillet, involute and root land, compared with the rack tool at many positions of its roll: it touches the flank that remains and covers it nowhere.
//! The tool is a trapezium with circular tips in the normal section; lengths of the transverse section along the pitch line are multiplied by `cos β`.

use super::*;

/// The tool and the gear that rolls on it.
struct Cutting {
    /// Reference radius, mm: the gear rolls on this.
    radius: f64,
    teeth: f64,
    cos_beta: f64,
    /// In the normal section.
    alpha: f64,
    /// Centre of the tip round: from the tool tooth's middle, normal section, and below the pitch line, mm.
    centre: [f64; 2],
    round: f64,
}

impl Cutting {
    fn new(design: &GearDesign) -> Cutting {
        let (data, rack) = (&design.basic_data, &design.rack);
        let (module, teeth) = (data.module(), f64::from(data.teeth()));
        let (alpha, cos_beta) = (data.pressure_angle(), data.helix_angle().cos());
        let round = rack.root_radius() * module;
        // The tool's datum line lies the shift outside the pitch line, and there its tooth is half a pitch wide.
        let tip = rack.dedendum() * module - round;
        let width = FRAC_PI_4 * module - tip * alpha.tan() - round / alpha.cos();
        Cutting {
            radius: 0.5 * module * teeth / cos_beta,
            teeth,
            cos_beta,
            alpha,
            centre: [width, tip - design.profile_shift * module],
            round,
        }
    }

    /// Where a point of the gear stands once it has rolled by `phi`: outwards from the gear's centre to the pitch line, and along that
    /// from the pitch point; at 0 the tool's tooth stands there in the middle of its space.
    fn rolled(&self, [x, y]: [f64; 2], phi: f64) -> [f64; 2] {
        let (sin, cos) = (PI / self.teeth + phi).sin_cos();
        [x * cos - y * sin, x * sin + y * cos]
    }

    /// From the centre of the tool's tip round, in the normal section: along the pitch line and below it, mm.
    fn off_centre(&self, point: [f64; 2], phi: f64) -> [f64; 2] {
        let [x, y] = self.rolled(point, phi);
        let along = (y - self.radius * phi) * self.cos_beta;
        [along - self.centre[0], self.radius - x - self.centre[1]]
    }

    /// Distance of a point from the tool, mm in the normal section; below 0 in the tool.
    fn clear(&self, point: [f64; 2], phi: f64) -> f64 {
        let [along, deep] = self.off_centre(point, phi);
        // The tool's tooth is symmetrical.
        let along = (along + self.centre[0]).abs() - self.centre[0];
        let (sin, cos) = self.alpha.sin_cos();
        let core = if along * sin >= deep * cos {
            along * cos + deep * sin
        } else if along <= 0.0 {
            deep
        } else {
            along.hypot(deep)
        };
        core - self.round
    }

    /// Distance of a point from the tool's tip round, mm in the normal section.
    fn clear_of_round(&self, point: [f64; 2], phi: f64) -> f64 {
        let [along, deep] = self.off_centre(point, phi);
        along.hypot(deep) - self.round
    }

    /// The roll at which a distance is least.
    fn nearest(&self, clear: impl Fn(f64) -> f64) -> f64 {
        const STEPS: i32 = 1000;
        let step = (14.0 / self.teeth).min(1.3) / f64::from(STEPS);
        let all = (-STEPS..=STEPS).map(|k| step * f64::from(k));
        let best = all.min_by(|a, b| clear(*a).total_cmp(&clear(*b))).unwrap();
        let (mut low, mut high) = (best - step, best + step);
        for _ in 0..60 {
            let third = (high - low) / 3.0;
            match clear(low + third) <= clear(high - third) {
                true => high -= third,
                false => low += third,
            }
        }
        0.5 * (low + high)
    }

    /// How fast the distance from the tip round's centre changes with the roll, times that distance.
    fn slope(&self, point: [f64; 2], phi: f64) -> f64 {
        let [x, y] = self.rolled(point, phi);
        let [along, deep] = self.off_centre(point, phi);
        along * (x - self.radius) * self.cos_beta + deep * y
    }
}

/// Undercut and not, the centre of the round below the pitch line and above it (shift 1.2), sharp tools and full rounds, spur and up to 45° of helix.
fn gears() -> Vec<Gear> {
    let mut gears = Vec::new();
    // No flat at the tool's tip is left: π/4 = (h_f − ρ) tan α + ρ/cos α.
    let alpha = 20f64.to_radians();
    let full = (FRAC_PI_4 - 1.25 * alpha.tan()) / (1.0 / alpha.cos() - alpha.tan());
    for helix in [0.0, 10.0, 25.0, 45.0] {
        for (teeth, shift, rack, alpha) in [
            (9, -0.1, [1.0, 0.38], 20.0),
            (12, 0.3, [1.0, 0.38], 20.0),
            (27, 0.265, [1.0, 0.25], 20.0),
            (44, 0.0, [1.0, 0.38], 14.5),
            (60, 1.2, [0.6, 0.38], 20.0),
            (200, -0.4, [1.0, 0.0], 25.0),
            (31, 0.1, [1.0, full], 20.0),
        ] {
            let gear = spur_of_angle(teeth, 2.0, alpha).rack(rack[0], 1.25, rack[1]);
            gears.push(gear.shift(shift).helix(helix, Hand::Left).gear());
        }
    }
    gears
}

/// Source: the tool itself at 2000 places of its roll, and thirds about the nearest. To 1e-13 of the reference radius and 1e-9 rad.
#[test]
fn the_tool_touches_what_it_leaves_and_covers_none_of_it() {
    let mut undercut = 0;
    for gear in gears() {
        let cutting = Cutting::new(gear.design());
        let profile = Profile::new(&gear);
        let what = format!("{:?}", gear.design());
        undercut += u32::from(gear.is_undercut());
        let fillet = gear.fillet();
        near(&what, fillet.depth(), cutting.centre[1], 1e-12);
        near(&what, fillet.tip_round(), cutting.round, 1e-12);
        assert_eq!(fillet.is_elliptic(), cutting.cos_beta < 1.0, "{what}");
        for part in [
            ProfilePart::Involute,
            ProfilePart::Fillet,
            ProfilePart::Root,
        ] {
            let (curve, (low, high)) = (&profile.part(part).curve, profile.part(part).range());
            for k in 0..=24 {
                let t = low + (high - low) * f64::from(k) / 24.0;
                let (point, normal) = (curve.point(t), curve.normal(t));
                let at = [point.x, point.y];
                let clear = cutting.clear(at, cutting.nearest(|phi| cutting.clear(at, phi)));
                near((&what, part, t), clear, 0.0, 1e-13 * cutting.radius);
                if part != ProfilePart::Fillet || cutting.round == 0.0 {
                    continue;
                }
                // Where it touches the round, the normal there is the parameter's and the fillet's.
                let phi = cutting.nearest(|phi| cutting.clear_of_round(at, phi));
                let clear = cutting.clear_of_round(at, phi);
                near((&what, part, t), clear, 0.0, 1e-13 * cutting.radius);
                let (low, high) = (phi - 1e-4, phi + 1e-4);
                assert!(cutting.slope(at, low) < 0.0 && cutting.slope(at, high) > 0.0);
                let [phi, _] = halved(low, high, 60, |phi| cutting.slope(at, phi) < 0.0);
                let [along, deep] = cutting.off_centre(at, phi);
                let gamma = (along * cutting.cos_beta).atan2(deep);
                near(&what, gamma, t, 1e-9);
                let [out, beside] = cutting.rolled([normal.x, normal.y], phi);
                let off = (out - gamma.cos()).hypot(beside + gamma.sin());
                near((&what, t), off, 0.0, 1e-9);
            }
        }
        // Fillet and involute meet where each ends, and the fillet begins on the root land.
        let end = |part, k: usize| profile.part(part).curve.point(profile.part(part).ends[k]);
        for [one, other] in [
            [(ProfilePart::Involute, 1), (ProfilePart::Fillet, 0)],
            [(ProfilePart::Fillet, 1), (ProfilePart::Root, 0)],
        ] {
            let apart = (end(one.0, one.1) - end(other.0, other.1)).norm();
            near(&what, apart, 0.0, 1e-12 * cutting.radius);
        }
    }
    assert_eq!(undercut, 3);
}
