//! Readings along the face give back the leads, the wobble and the eccentricity that were put in. Sources: ISO 1328-1, ISO 21771, and closed forms.

use super::*;

/// Heights of the ends of the teeth from the measuring plane, away from the reference face, and the evaluation range.
const ENDS: [f64; 2] = [-15.0, 25.0];
const RANGE: [f64; 2] = [-13.0, 23.0];

fn lead(slope: f64, crowning: f64) -> Lead {
    Lead {
        face: ENDS,
        range: RANGE,
        slope,
        crowning,
        ..Lead::default()
    }
}

fn gear_of(beta_deg: f64) -> Make {
    match beta_deg {
        0.0 => spur(25, 3.0).shift(0.1),
        _ => helical(25, beta_deg, Hand::Left, 0.1),
    }
}

const CASES: [(f64, Face); 4] = [
    (0.0, Face::Front),
    (0.0, Face::Back),
    (21.0, Face::Front),
    (21.0, Face::Back),
];

fn read(gear: &AsBuilt) -> FaceReadings {
    let face = match gear.face() {
        Face::Front => ENDS,
        Face::Back => [-ENDS[1], -ENDS[0]],
    };
    let settings = Settings {
        face,
        lead_range: Some(RANGE.map(|height| height - ENDS[0])),
        ..with_span(3)
    };
    measure(gear, settings).along_face.unwrap()
}

/// Slope and crowning come out as they went in, about both axes, with `f_Hβ` positive where the helix angle is greater. A straight line has
/// no form, and a parabola of `C_β` over the face the form `C_β L²/b²`.
#[test]
fn leads_come_out_as_they_went_in() {
    let (right, left, crown) = (0.010, -0.006, 0.008);
    for (beta_deg, face) in CASES {
        // A spur gear is read as if it were right hand.
        let is_spur = beta_deg == 0.0;
        let hand = if is_spur { Hand::Right } else { Hand::Left };
        let [right_lead, left_lead] = [(right, Flank::Right), (left, Flank::Left)]
            .map(|(slope, flank)| Lead::slope_of_helix(slope, hand, flank));
        let gear = gear_of(beta_deg).leads([lead(right_lead, 0.0), lead(left_lead, crown)]);
        let found = read(&gear.built(face));
        for read in [found.own.unwrap(), found.datum.unwrap()] {
            let bound = 10.0 * read.error + PICOMETRE;
            let flank = read.flank(Flank::Right);
            assert_eq!((flank.shapes.len(), flank.of_tooth.len()), (1, 25));
            let sloped = &flank.shapes[0];
            let crowned = &read.flank(Flank::Left).shapes[0];
            let share = (RANGE[1] - RANGE[0]) / (ENDS[1] - ENDS[0]);
            for (what, found, expected) in [
                ("slope", read.helix_slope(Flank::Right, sloped), right),
                ("total", sloped.total, right),
                ("form", sloped.form, 0.0),
                ("crowning", read.crowning(sloped), 0.0),
                ("left slope", read.helix_slope(Flank::Left, crowned), left),
                ("left crowning", read.crowning(crowned), crown),
                ("left form", crowned.form, crown * share * share),
            ] {
                near((beta_deg, face, what), found, expected, bound);
            }
        }
        assert_eq!(found.face_runout.amount, 0.0);
    }
}

/// A wobble `t` alone: traces about the axis of the teeth are straight. About the rotation axis a trace is `n·t b + s τ' r_b t·q` to first order, with
/// `n` and the point `q` on the reference circle. Turned over the readings are the same. Source: the section of a leaning gear, by hand.
#[test]
fn wobble_is_in_leads_about_the_rotation_axis() {
    let wobble = 2e-4;
    for beta_deg in [0.0, 21.0] {
        let gear = gear_of(beta_deg).wobble(wobble, 3.5).front();
        let found = read(&gear);
        let (own, datum) = (found.own.unwrap(), found.datum.unwrap());
        assert_eq!([own.axis, datum.axis], [PitchAxis::Own, PitchAxis::Datum]);
        let turned_over = read(&gear.facing(Face::Back)).datum.unwrap();
        let data = *gear.gear().basic_data();
        let alpha = data.transverse_pressure_angle();
        let half = gear.gear().half_base_angle() - inv(alpha);
        let (radius, base) = (data.reference_radius(), gear.gear().base_radius());
        let lean = gear.tooth_angle(3.5);
        let along = |angle: f64| wobble * (angle - lean).cos();
        for flank in Flank::BOTH {
            assert!(own.flank(flank).shapes[0].total < 10.0 * own.error);
            let s = if flank == Flank::Right { -1.0 } else { 1.0 };
            for tooth in [1, 9, 20] {
                let expected = |b: f64| {
                    let angle = gear.tooth_angle(f64::from(tooth)) + s * half + data.twist() * b;
                    // n = s (−sin(ψ − s α), cos(ψ − s α)) is the direction ψ − s α + 90°.
                    let normal = s * along(angle - s * alpha + TAU / 4.0);
                    normal * b + s * data.twist() * base * radius * along(angle)
                };
                let reading = datum.flank(flank).tooth(tooth);
                let start = expected(0.0);
                for (height, deviation) in &reading.points {
                    let expected = expected(height + ENDS[0]) - start;
                    near((beta_deg, flank, tooth), *deviation, expected, 1e-5);
                }
                let other = turned_over.flank(flank).tooth(tooth);
                near((beta_deg, flank), reading.slope, other.slope, 1e-9);
            }
        }
    }
}

/// Runout at a height is twice `|e_0 + t h|`, and the reference face runs out by `|t| d` where the far end leans to (closed form).
#[test]
fn runout_at_heights_and_of_the_face_is_what_was_put_in() {
    let towards = |tooth: f64| {
        let angle = TAU * tooth / 25.0;
        [angle.cos(), angle.sin()]
    };
    for (beta_deg, face) in CASES {
        let gear = gear_of(beta_deg).runout(0.008, 7.25).wobble(3e-4, 16.5);
        let gear = gear.built(face);
        let found = read(&gear);
        for section in &found.sections {
            let height = section.height + ENDS[0];
            let [e, t] = [(0.008, 7.25), (3e-4 * height, 16.5)]
                .map(|(amount, tooth)| towards(tooth).map(|part| amount * part));
            let expected = (e[0] + t[0]).hypot(e[1] + t[1]);
            let read = &section.eccentricity;
            near(height, read.amount, expected, 10.0 * read.error);
            // A ball in each of 25 spaces misses the high place by at most half a pitch.
            let total = section.runout.as_ref().unwrap().total();
            let allowed = 1.9 * expected..=2.0 * expected + 1e-5;
            assert!(allowed.contains(&total), "{total}");
        }
        let (runout, data) = (found.face_runout, gear.gear().basic_data());
        near(
            "face",
            runout.amount,
            6e-4 * data.reference_radius(),
            10.0 * runout.error,
        );
        let tooth = 16.5 + data.twist() * ENDS[0] / data.angular_pitch();
        near("high tooth", runout.high_tooth, tooth, 1e-5);
    }
}

/// A span at a height: `W_k + cos β_b (δ_R(b_R) + δ_L(b_L))`, `b_R − b_L = ± W_k sin β_b` (closed form).
#[test]
fn spans_at_heights_contain_the_leads_of_both_flanks() {
    for (beta_deg, face) in CASES {
        let plain = gear_of(beta_deg);
        let gear = plain.clone().leads([lead(0.012, 0.0), lead(0.005, 0.0)]);
        let (gear, plain) = (gear.built(face), plain.built(face));
        let nominal = measure(&plain, with_span(3)).spans.unwrap().summary().mean;
        let angle = gear.gear().basic_data().base_helix_angle();
        let inwards = if face == Face::Front { 1.0 } else { -1.0 };
        for section in read(&gear).sections {
            let place = inwards * (section.height + ENDS[0]);
            for span in section.spans.unwrap().readings {
                let [left, right] = span.sections;
                near("apart", (right - left).abs(), nominal * angle.sin(), 0.01);
                let sides = [(Flank::Left, left), (Flank::Right, right)];
                let leads = sides.map(|(flank, beside)| {
                    let side: Side = face.seen_from_front(flank);
                    gear.lead(side, 1, place + beside)
                });
                let expected = nominal + angle.cos() * (leads[0] + leads[1]);
                near((beta_deg, face), span.length, expected, 1e-7);
            }
        }
    }
}
