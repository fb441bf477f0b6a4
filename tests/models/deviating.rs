//! The formulas, and closed forms, of flanks whose profiles deviate.

use super::*;

/// 44/44 with a runout, the profile of either gear on both flanks.
fn profiled(profile: Modification) -> Make {
    let gear = spur(44, 3.0).runout(0.010, 5.5);
    gear.profiles([profile.clone(), profile])
}

fn poses(pair: &GearPair, count: u32) -> impl Iterator<Item = Pose> {
    let step = 44.0 / f64::from(count);
    (0..count).map(move |k| Pose::new(pair, at(1, 1, step * f64::from(k))))
}

/// The formula has the flanks' own deviation at its contact point, and lies above by the square of their slope there.
#[test]
fn the_formula_takes_the_deviation_where_it_touches() {
    let crowned = |um: f64| Modification {
        crowning: 1e-3 * um,
        slope: -0.5e-3 * um,
        ..Modification::default()
    };
    let mut compared = 0;
    for um in [1.0, 4.0] {
        let pair = pair(&profiled(crowned(um)), &profiled(crowned(0.7 * um)), 132.1);
        for pose in poses(&pair, 200) {
            let found = ExactKernel::new(&pair).lost_motion(&pose).unwrap();
            let contacts = [found.right.unwrap(), found.left.unwrap()];
            let curves = contacts.map(|c| [c.wheel.curve, c.pinion.curve]);
            let mut touched = curves.into_iter().flatten();
            if touched.any(|curve| curve != ProfilePart::Involute) {
                continue;
            }
            let formula = LineOfAction::new(&pair, &pose).angle().unwrap();
            let off = (formula - found.angle().unwrap()) * 66.0;
            // Slopes of both flanks up to (4 C + f)/L over a flank of some 6 mm tilt by up to 4.5e-4 a µm each; curvatures add up to 1/12 a mm
            // and more: 2 sides, (Σ tilt)²/(2 κ).
            let tilt = 4.5e-4 * um * 1.7;
            let allowed = -1e-12..2.0 * tilt * tilt * 6.0;
            assert!(allowed.contains(&off), "{um} µm: {off} mm");
            compared += 1;
        }
    }
    assert!(compared > 300, "{compared}");
}

/// A deep parabolic relief of a short tip reaches the tip circle where its flank first does, not where its parabola comes back beyond the fold. Source:
/// `r_b ξ + δ(ξ) = r_b ξ_a` solved as the quadratic it is.
#[test]
fn a_deep_short_relief_ends_at_the_nearest_roll() {
    let plain = spur(44, 3.0).gear();
    let (amount, share) = (0.07026427144793204, 0.9493132429231694);
    let from = plain.form_radius() + share * (plain.tip_radius() - plain.form_radius());
    let relief = Relief {
        amount,
        from,
        parabolic: true,
    };
    let relieved = Modification {
        tip_relief: Some(relief),
        ..Modification::default()
    };
    let (base, tip) = (plain.base_radius(), plain.tip_roll());
    let length = tip - involute::roll_at(from, base);
    let wheel = profiled(relieved).front();
    // With h = ξ − ξ_1: r_b h − C h²/l² = r_b l.
    let curved = amount / (length * length);
    let h = (base - (base * base - 4.0 * curved * base * length).sqrt()) / (2.0 * curved);
    let ends = tip + h - length;
    let (end, _) = wheel.profile(Side::Right, 1).range(ProfilePart::Involute);
    near("roll", end, ends, 1e-14);
}

/// A tooth of 20 that has lost, or a space that has lost, 3 mm of its width on the reference circle: `s_a = 2 r_a (s/2r + inv α − inv α_a)`,
/// and what is left of it; the form circle's space likewise.
#[test]
fn a_tooth_without_tip_and_a_closed_space_are_reported_with_their_width() {
    let make = spur(20, 2.0);
    let (base, reference) = (20.0 * 20f64.to_radians().cos(), 20.0);
    let inv_at = |radius: f64| inv(f64::acos(base / radius));
    // Half a tooth, as an angle.
    let half = |radius: f64| PI / 40.0 + inv_at(reference) - inv_at(radius);
    // Cumulative deviations count from their mean.
    let lost = 3.0 * (1.0 - 1.0 / 20.0) / reference;
    let width = |sign: f64| {
        let mut right = vec![0.0; 20];
        right[7] = sign * 3.0;
        let deviations = make.clone().pitch(&right, &[0.0; 20]).deviations;
        match AsBuilt::new(make.gear(), Face::Front, &deviations) {
            Err(GearError::OutOfRange { what, value, .. }) => (what, value),
            other => panic!("{other:?}"),
        }
    };
    let form = make.gear().form_radius();
    let tip = 22.0 * (2.0 * half(22.0) - lost);
    let space = form * (TAU / 20.0 - 2.0 * half(form) - lost);
    for (what, expected) in [
        ("tip thickness of the thinnest tooth (mm)", tip),
        ("space width at the form circle (mm)", space),
    ] {
        let found = [width(1.0), width(-1.0)];
        let (_, value) = found.into_iter().find(|found| found.0 == what).expect(what);
        near(what, value, expected, 1e-12);
    }
}
