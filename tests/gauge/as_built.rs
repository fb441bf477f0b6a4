//! Each reading against the deviations of the model, computed here from the input lists.

use super::*;

#[track_caller]
fn all_near(
    found: impl IntoIterator<Item = f64>,
    expected: impl IntoIterator<Item = f64>,
    within: f64,
) {
    let found: Vec<f64> = found.into_iter().collect();
    let expected: Vec<f64> = expected.into_iter().collect();
    assert_eq!(found.len(), expected.len());
    for (k, (found, expected)) in found.into_iter().zip(expected).enumerate() {
        near(k, found, expected, within);
    }
}

/// Spur and helical, read in the measuring plane: `W = cos β_b ((k − 1) p_bt + s_bt + cos α_t (x_R − x_L))` over the flanks that bound a span, which
/// stand `x` ahead; pitch without its mean; and arcs `2 r (s_bt/(2 r_b) − inv α_t) + x_R − x_L`.
#[test]
fn spans_pitch_and_thickness() {
    let no_hand = Hand::Right;
    let spurs = [
        made(44, 0.0, no_hand, Face::Front, 0.0),
        made(21, 0.0, no_hand, Face::Back, 0.031),
        made(60, 0.0, no_hand, Face::Back, 0.0),
    ];
    for made in spurs.into_iter().chain(in_space()) {
        let all = 1..=made.teeth;
        let found = measure(&made.gear, with_pin(5.5, None));
        let spans = found.spans.unwrap();
        assert!(spans.teeth > 2);
        let base_pitch = made.pitches(1) * made.base;
        let expected = all.clone().map(|first| {
            let last = first + spans.teeth - 1;
            let apart = made.stands(Flank::Right, last) - made.stands(Flank::Left, first);
            let normal = f64::from(spans.teeth - 1) * base_pitch + 2.0 * made.half * made.base;
            made.base_cos() * (normal + made.alpha_t().cos() * apart)
        });
        all_near(spans.readings.iter().map(|s| s.length), expected, PICOMETRE);

        let own = found.pitch_own.unwrap();
        for flank in Flank::BOTH {
            let stands: Vec<f64> = all.clone().map(|tooth| made.stands(flank, tooth)).collect();
            let mean = stands.iter().sum::<f64>() / f64::from(made.teeth);
            let cumulative = stands.iter().map(|stands| stands - mean);
            all_near(own.cumulative.flank(flank).to_vec(), cumulative, PICOMETRE);
            let before = stands.iter().cycle().skip(stands.len() - 1);
            let both = stands.iter().zip(before);
            let single = both.map(|(here, before)| here - before);
            all_near(own.cumulative.single(flank), single, PICOMETRE);
        }

        let mean = 2.0 * made.radius * (made.half - inv(made.alpha_t()));
        let expected = all.map(|tooth| {
            let [right, left] = [Flank::Right, Flank::Left].map(|own| made.stands(own, tooth));
            mean + right - left
        });
        all_near(found.thickness.unwrap().arcs, expected, PICOMETRE);

        let (eccentricity, e) = (found.eccentricity.unwrap(), made.deviations.eccentricity);
        near("eccentricity", eccentricity.amount, e, PICOMETRE);
        if e > 0.0 {
            near("high tooth", eccentricity.high_tooth, 5.25, 1e-8);
        }
    }
}

/// A machine on the datum axis reads own pitch and eccentricity together; taking the eccentricity out again,
/// by the code that reads such sheets, gives both back. The own pitch here has no first harmonic, as that asks.
#[test]
fn datum_axis_pitch_separates_again() {
    let wave = |phase: f64| -> Vec<f64> {
        let at = |i: u32| 0.006 * (4.0 * TAU * f64::from(i) / 44.0 + phase).sin();
        (0..44).map(at).collect()
    };
    let part = spur(44, 3.0).pitch(&wave(0.0), &wave(1.0));
    let part = part.runout(0.04, 17.5).back();
    let found = measure(&part, quick());
    let datum = found.pitch_datum.unwrap();
    // To first order the sine of amplitude e/cos α is in F_p.
    assert!(datum.cumulative.total(Flank::Right) > 2.0 * 0.04 / ALPHA.cos() * 0.9);
    let separated = separate_eccentricity(&datum.cumulative, part.gear()).unwrap();
    near("eccentricity", separated.eccentricity, 0.04, PICOMETRE);
    near("high tooth", separated.high_tooth, 17.5, 1e-6);
    let own = found.pitch_own.unwrap();
    for side in Flank::BOTH {
        let found = separated.pitch.flank(side).to_vec();
        all_near(found, own.cumulative.flank(side).to_vec(), PICOMETRE);
    }
}

/// Spans all round, the pitch that was put in, and runout read by a ball: the flanks and the eccentricity come out as they went in. The
/// thickness of each tooth changes the readings too, but adds no eccentricity.
#[test]
fn spans_pitch_and_runout_readings_give_the_gear_back() {
    let made = made(21, 0.0, Hand::Right, Face::Front, 0.021);
    let settings = Settings {
        span_teeth: Some(3),
        ..with_ball(5.25)
    };
    let found = measure(&made.gear, settings);
    let spans = found.spans.unwrap().readings.into_iter();
    let statement = Measurements {
        thickness: ThicknessStatement::SpanReadings {
            teeth: 3,
            readings: spans.map(|span| (span.first_tooth, span.length)).collect(),
            per_tooth: true,
        },
        pitch: Some(own_pitch(scaled(&made.right, 1e3), scaled(&made.left, 1e3))),
        runout: RunoutStatement::Readings(ProbeReadings {
            um: scaled(&found.runout.unwrap().deviations(), 1e3),
            with: ReadWith::Ball(5.25),
        }),
        ..Measurements::nominal(helical(21, 0.0, Hand::Right, 0.2).design, Face::Front)
    };
    let measured = statement.measure().unwrap();
    let deviations = &measured.deviations;
    near("eccentricity", deviations.eccentricity, 0.021, 1e-7);
    near("high tooth", deviations.high_tooth, 5.25, 1e-4);
    let built = measured.as_built.most();
    let base = built.gear().base_thickness();
    near("base", base, 2.0 * made.half * made.base, 1e-7);
    for (tooth, side) in (1..=21).flat_map(|tooth| Side::BOTH.map(|side| (tooth, side))) {
        let arcs = [built, &made.gear].map(|gear| made.radius * gear.flank_offset(side, tooth));
        near((tooth, side), arcs[0], arcs[1], 1e-7);
    }
}
