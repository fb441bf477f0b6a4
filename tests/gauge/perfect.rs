//! A perfect gear reads what the formulas say.

use super::*;

/// Every reading `(length, bound)` is what the formula says, within 1e-6 µm and within its bound.
fn assert_reads(teeth: u32, readings: impl IntoIterator<Item = (f64, f64)>, formula: f64) {
    for (length, bound) in readings {
        // The greatest gear has a radius of half a metre: 1e-9 mm is 2e-12 of it.
        near(teeth, length, formula, bound.min(PICOMETRE));
    }
}

fn over(list: &[OverPins]) -> impl Iterator<Item = (f64, f64)> + '_ {
    list.iter().map(|over| (over.length, over.error))
}

/// Readings of the outline, and the formulas of ISO 21771, which share nothing with them. By default the contacts are near the middle of the active
/// flank, between form circle and tip. The source of the teeth in a span and of the pins is in the table.
#[test]
fn reads_the_formulas() {
    type Row = (u32, f64, f64, f64, f64, u32, Option<f64>);
    for row in rows::<Row>(include_str!("data/perfect.csv")) {
        let (teeth, module, alpha_deg, shift, thinner, k, pin) = row;
        let make = spur_of_angle(teeth, module, alpha_deg).shift(shift);
        let found = measure(&make.thinner(thinner).front(), quick());
        let formula = found.formula;

        let spans = found.spans.unwrap();
        assert_eq!((spans.teeth, spans.readings.len()), (k, teeth as usize));
        let readings = spans.readings.iter().map(|span| (span.length, span.error));
        assert_reads(teeth, readings, formula.span.unwrap());
        for span in &spans.readings {
            let [left, right] = span.touched;
            assert!(left.curve == ProfilePart::Involute && right.curve == ProfilePart::Involute);
            // The middle of the plateau: both contacts on one circle.
            near(teeth, left.radius, right.radius, 1e-3 * module);
        }

        let pins = found.pins.unwrap();
        let diameter = pins.diameter;
        assert!(pin.is_none_or(|pin| pin == diameter), "{teeth}: {diameter}");
        for seat in &pins.seats {
            let mut touched = seat.touched.iter();
            assert!(touched.all(|touch| touch.curve == ProfilePart::Involute));
        }
        let odd = if teeth % 2 == 1 { teeth } else { 0 };
        assert_eq!(pins.two.len(), teeth as usize);
        assert_eq!(pins.three.len(), odd as usize);
        assert_reads(teeth, over(&pins.two), formula.over_two.unwrap());
        assert_eq!(formula.over_three.is_some(), odd > 0);
        let three = formula.over_three.unwrap_or_default();
        assert_reads(teeth, over(&pins.three), three);

        let runout = found.runout.unwrap();
        assert!(runout.total() <= runout.error().min(PICOMETRE), "{teeth}");
        let centre = (runout.radii().mean, runout.error());
        assert_reads(teeth, [centre], formula.ball_centre.unwrap());
        assert_eq!(found.eccentricity.as_ref().unwrap().amount, 0.0);

        let root = found.root.unwrap();
        let root = (root.radius, root.error);
        assert_reads(teeth, [root], formula.root.unwrap());
        let thickness = found.thickness.unwrap();
        let arcs = thickness.arcs.iter().map(|arc| (*arc, thickness.error));
        assert_reads(teeth, arcs, formula.thickness.unwrap());
        for pitch in [found.pitch_own.unwrap(), found.pitch_datum.unwrap()] {
            for side in Flank::BOTH {
                let pitch = &pitch.cumulative;
                assert!(pitch.total(side) < PICOMETRE && pitch.greatest_single(side) < PICOMETRE);
            }
        }
    }
}

/// Off the involute the gauge says what it touched: the tip corner, the root, the end of the involute.
#[test]
fn names_what_it_touches_off_the_involute() {
    let part = spur(44, 3.0).front();
    let gear = part.gear();
    // On two tip corners: r_K = r_a cos β + √(R² − r_a² sin² β), β half the angle between them.
    let beta = PI / 44.0 - gear.half_angle_at_roll(gear.tip_roll());
    let (r_a, half) = (gear.tip_radius(), gear.tip_radius() * beta.sin());
    let on_corners = r_a * beta.cos() + (36.0 - half * half).sqrt();
    let on_root = gear.root_radius() + 0.5;
    for (ball, place, radius) in [
        (1.0, ToothPlace::Root, Some(on_root)),
        (5.25, ToothPlace::Involute, None),
        (12.0, ToothPlace::Tip, Some(on_corners)),
    ] {
        let found = measure(&part, with_ball(ball)).runout.unwrap();
        assert_eq!(found.readings[0].seat.touched[0].curve, place);
        if let Some(radius) = radius {
            near(ball, found.radii().mean, radius, PICOMETRE);
        }
    }
    let sunk = measure(&part, with_pin(1.0, None)).pins;
    assert!(matches!(sunk, Err(Unmeasured(_))));
}

/// A valid span has both anvils on involutes, at z 44, α 20° for k = 4 … 7: (k − 1) 8.856 + 6.247 = 124.035 ξ with ξ from 0.2206 (d_Ff = 127.018) to
/// 0.4878 (d_a = 138). A gear file states the gear's actual values whatever `k` was requested, and a span over half the teeth is not refused for its number.
#[test]
fn a_span_off_the_involute_is_none() {
    for teeth in [50, 82, 100] {
        let spans = measure(&spur(teeth, 1.0).front(), with_span(teeth / 2)).spans;
        assert!(!spans.is_err_and(|reason| reason.0.contains("allowed is")));
    }
    let part = spur(44, 3.0).thinner(0.03).front();
    for k in 1..=24 {
        let found = measure(&part, with_span(k));
        let reason = found.spans.clone().err().map_or(String::new(), |why| why.0);
        let part_of = match k {
            1..=3 => "44 of 44 readings touch the involute's lower end",
            4..=7 => "",
            8..=22 => "44 of 44 readings touch the tip corner: span fewer teeth",
            _ => "allowed is 1 up to half of them",
        };
        assert!(reason.contains(part_of), "{k}: {reason}");
        assert_eq!(reason.is_empty(), part_of.is_empty(), "{k}: {reason}");
        match found.stated.unwrap() {
            StatedThickness::Spans => assert!(found.spans.is_ok()),
            StatedThickness::Allowance {
                allowance,
                per_tooth,
                ..
            } => {
                assert!(found.spans.is_err());
                // A_s = Δs_b/cos α.
                near(k, allowance, -0.03 / ALPHA.cos(), PICOMETRE);
                assert_eq!(per_tooth, 0.0);
            }
        }
    }
}
