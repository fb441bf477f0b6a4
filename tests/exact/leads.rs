//! Lead deviations against an independent 3-D program, dense sections and closed forms.

use crate::along_face::{dense, drawn, witness};
use gearlash::analytic::LineOfAction;
use gearlash::contact::{ExactKernel, FacePlace, PROVEN_WIDTH};
use gearlash::gear::{
    AsBuilt, BasicGearData, Deviations, Face, Flank, Gear, GearDesign, Hand, Lead, Pitch, Side,
    Trace, thickness,
};
use gearlash::pair::{GearPair, Mating, Member, Pose, SweepPlan};
use serde_json::Value;

/// Poses and extremes of rigid bodies found without sections; right to 1e-6 µm for parallel axes.
const REFERENCE: &str = include_str!("../../fixtures/reference/lead.json");

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or(0.0)
}

/// The lead of one flank, stated in the picture, in the frame of a gear that is turned over where `turn` is −1.
fn lead(stated: &Value, face: [f64; 2], turn: f64, teeth: u32) -> Lead {
    let Some(by_tooth) = stated.as_object() else {
        return Lead::default();
    };
    let own_face = face.map(|end| turn * end);
    let own_face = [own_face[0].min(own_face[1]), own_face[0].max(own_face[1])];
    let half = 0.5 * (face[1] - face[0]);
    let any = by_tooth.values().next().unwrap();
    // Straight lines between the points of the trace, plus the slope.
    let trace = |tooth: Option<u32>, own: &Value| {
        let measured: Option<Vec<[f64; 2]>> =
            serde_json::from_value(own["trace_b_mm_um"].clone()).ok();
        let points = measured.unwrap_or_else(|| face.map(|end| [end, 0.0]).to_vec());
        let slope = number(own, "slope_um_per_mm");
        let [first, last] = [points[0], points[points.len() - 1]];
        let mut points = points;
        // The slope goes on beyond the trace, which stays as it is at its ends.
        if face[0] < first[0] {
            points.push([face[0], first[1]]);
        }
        if face[1] > last[0] {
            points.push([face[1], last[1]]);
        }
        let mut points: Vec<(f64, f64)> = points
            .iter()
            .map(|[b, um]| (turn * b, 1e-3 * (um + slope * b)))
            .collect();
        points.sort_by(|one, other| one.0.total_cmp(&other.0));
        Trace { tooth, points }
    };
    let others = by_tooth
        .get("all_others")
        .cloned()
        .unwrap_or(serde_json::json!({}));
    let traces = match by_tooth.get("all") {
        Some(all) => vec![trace(None, all)],
        None => {
            let own = |tooth: u32| by_tooth.get(&tooth.to_string()).unwrap_or(&others);
            (1..=teeth)
                .map(|tooth| trace(Some(tooth), own(tooth)))
                .collect()
        }
    };
    let crown = &any["crowning"];
    assert_eq!(number(crown, "center_b_mm"), 0.0);
    assert!(crown.is_null() || face[0] == -face[1]);
    Lead {
        face: own_face,
        range: own_face,
        crowning: -1e-3 * number(crown, "um_per_mm2") * half * half,
        traces,
        zero: turn * number(any, "zero_at_b_mm"),
        ..Lead::default()
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().into_iter().flatten();
    list.map(|um| um.as_f64().unwrap() / 1000.0).collect()
}

fn gear(stated: &Value) -> AsBuilt {
    let teeth = number(stated, "teeth") as u32;
    let angle = number(stated, "pressure_angle_deg").to_radians();
    let data = BasicGearData::new(teeth, number(stated, "module_mm"), angle).unwrap();
    let hand = match stated["teeth_wind"].as_str() {
        Some("right") => Some(Hand::Right),
        Some("left") => Some(Hand::Left),
        _ => None,
    };
    let data = match hand {
        Some(hand) => {
            let helix = number(stated, "helix_angle_deg").to_radians();
            data.with_helix(helix, hand).unwrap()
        }
        None => data,
    };
    let design = GearDesign {
        profile_shift: number(stated, "profile_shift"),
        ..GearDesign::standard(data)
    };
    let allowance = number(stated, "allowance_um") / 1000.0;
    let base = thickness::base_from_allowance(&data, design.nominal_base_thickness(), allowance);
    let face = match stated["reference_face"].as_str() {
        Some("back") => Face::Back,
        _ => Face::Front,
    };
    let ends: [f64; 2] = serde_json::from_value(stated["face_mm"].clone()).unwrap();
    let turn = if face == Face::Front { 1.0 } else { -1.0 };
    let own = |flank: Flank| {
        let side = match face.seen_from_front(flank) {
            Side::Right => "front_right",
            Side::Left => "front_left",
        };
        lead(&stated["lead"][side], ends, turn, teeth)
    };
    // A vector in the picture at rotation 0, when tooth 1 points at the mate, and the tooth that it points to.
    let towards = |vector: &[f64], sign: f64| match vector {
        &[x, y] if x != 0.0 || y != 0.0 => {
            let pitch = std::f64::consts::TAU / f64::from(teeth);
            let mate = match face {
                Face::Front => 0.0,
                Face::Back => std::f64::consts::PI,
            };
            let steps = face.ascending() * ((sign * y).atan2(sign * x) - mate) / pitch;
            (x.hypot(y), 1.0 + steps.rem_euclid(f64::from(teeth)))
        }
        _ => (0.0, 1.0),
    };
    let axis = &stated["axis"];
    let (eccentricity, high_tooth) = towards(&numbers(&axis["center_at_measuring_plane_um"]), 1.0);
    let (wobble, wobble_tooth) = towards(&numbers(&axis["tilt_um_per_mm"]), turn);
    let pitch = &stated["pitch"];
    let deviations = Deviations {
        pitch: pitch.is_object().then(|| {
            let [right, left] = ["right_um", "left_um"].map(|side| numbers(&pitch[side]));
            Pitch::from_cumulative(&right, &left)
        }),
        eccentricity,
        high_tooth,
        wobble,
        wobble_tooth,
        leads: [own(Flank::Right), own(Flank::Left)],
        ..Deviations::default()
    };
    AsBuilt::new(Gear::new(design, base).unwrap(), face, &deviations).unwrap()
}

fn pair(case: &Value) -> GearPair {
    let [wheel, pinion] = ["wheel", "pinion"].map(|member| &case[member]);
    let faces: [[f64; 2]; 2] =
        [wheel, pinion].map(|gear| serde_json::from_value(gear["face_mm"].clone()).unwrap());
    let distance = number(&case["assembly"], "center_distance_mm");
    let locked = match case["assembly"]["locked"].as_str() {
        Some("pinion") => Member::Pinion,
        _ => Member::Wheel,
    };
    let pair = GearPair::with_locked(gear(wheel), gear(pinion), distance, locked).unwrap();
    let lean = ["pinion_axis_x_per_mm", "pinion_axis_y_per_mm"];
    let lean = lean.map(|key| number(&case["assembly"], key));
    pair.with_faces(faces).unwrap().with_lean(lean).unwrap()
}

fn leans(case: &Value) -> bool {
    let assembly = &case["assembly"];
    let skew = ["pinion_axis_x_per_mm", "pinion_axis_y_per_mm"];
    let tilted = |member: &str| {
        let tilt = numbers(&case[member]["axis"]["tilt_um_per_mm"]);
        tilt.iter().any(|tilt| *tilt != 0.0)
    };
    skew.iter().any(|key| number(assembly, key) != 0.0)
        || ["wheel", "pinion"].into_iter().any(tilted)
}

fn mating(stated: &Value) -> Mating {
    let side = match stated["flank"].as_str() {
        Some("left") => Side::Left,
        _ => Side::Right,
    };
    let tooth = |key: &str| number(stated, key) as u32;
    Mating {
        fraction: number(stated, "fraction"),
        ..Mating::at(tooth("wheel_tooth"), tooth("pinion_tooth"), side)
    }
}

/// Source: fixtures/reference/lead.json, rigid bodies without sections, right to 1e-6 µm.
#[test]
fn reference_poses_of_parallel_axes() {
    let reference: Value = serde_json::from_str(REFERENCE).unwrap();
    let mut compared = 0;
    for case in reference["poses"].as_array().unwrap() {
        let name = case["name"].as_str().unwrap();
        let has_bias = case["wheel"]["lead"].to_string().contains("bias");
        if leans(case) || has_bias {
            continue;
        }
        let pair = pair(case);
        let pose = Pose::new(&pair, mating(&case["mating"]));
        let found = ExactKernel::new(&pair).lost_motion(&pose).unwrap();
        let j_wt = found.angle().unwrap() * pair.operating_pitch_radius(pair.free()) * 1000.0;
        let expected = number(&case["expected"], "j_wt_um");
        assert!((j_wt - expected).abs() < 1e-6, "{name}: {j_wt} {expected}");
        compared += 1;
    }
    assert_eq!(compared, 15);
}

/// Source: fixtures/reference/lead.json, right to 5e-6 µm where axes lean; sections leave out what the bound of the result contains.
#[test]
fn reference_poses_of_leaning_axes() {
    let reference: Value = serde_json::from_str(REFERENCE).unwrap();
    let mut compared = 0;
    for case in reference["poses"].as_array().unwrap() {
        if !leans(case) {
            continue;
        }
        let name = case["name"].as_str().unwrap();
        let pair = pair(case);
        let pose = Pose::new(&pair, mating(&case["mating"]));
        let found = ExactKernel::new(&pair).lost_motion(&pose).unwrap();
        let radius = pair.operating_pitch_radius(pair.free()) * 1000.0;
        let j_wt = found.angle().unwrap() * radius;
        let bound = found.error().unwrap() * radius;
        let expected = number(&case["expected"], "j_wt_um");
        let off = (j_wt - expected).abs();
        assert!(off <= bound + 0.003, "{name}: {j_wt} {expected} {bound}");
        compared += 1;
    }
    assert_eq!(compared, 20);
}

/// No section of a pose is tighter than what was found over the whole face. Source: 400 sections, each a pair of spur gears.
#[test]
fn no_section_is_tighter() {
    let reference: Value = serde_json::from_str(REFERENCE).unwrap();
    for case in reference["poses"].as_array().unwrap() {
        if leans(case) {
            continue;
        }
        let pair = pair(case);
        let kernel = ExactKernel::new(&pair);
        for fraction in [0.0, 0.17, 0.41, 0.63, 0.88] {
            let pose = Pose::new(&pair, mating(&case["mating"]).onward(&pair, fraction));
            let found = kernel.lost_motion(&pose).unwrap();
            let [right, left] = dense(&pair, &pose, 400);
            let beyond = found.right.unwrap().rotation - pose.free_rotation();
            let own = [beyond, beyond + found.angle().unwrap()];
            let name = &case["name"];
            assert!(
                right <= own[0] + 1e-12,
                "{name} {fraction}: {right} {own:?}"
            );
            assert!(left >= own[1] - 1e-12, "{name} {fraction}: {left} {own:?}");
        }
    }
}

/// Random pairs are as tight as their sections. Source: 200 sections with zoom at the tightest, each a pair of spur gears.
/// `campaign --along-face` has more of both. Pose 743 is tight at both ends of a pair's line: leaning axes bend its gap up at one of them.
/// A tip touches a fillet inside the face in pose 258. The line of a pair ends by the heights of leaning axes in poses 812 and 403. Pose 762 is
/// tightest at an end of its own face. In pose 58 of seed 7 the pair nearest to the line of centres changes beside the tightest place.
#[test]
fn random_pairs_against_dense_sections() {
    let mut compared = 0;
    let poses = (0..40).map(|index| (1, index));
    for (seed, index) in poses.chain([(7, 743), (1, 258), (1, 812), (1, 403), (1, 762), (7, 58)]) {
        let (pair, pose) = drawn(seed, index);
        let Some(witnessed) = witness(&pair, &pose, 200) else {
            continue;
        };
        assert!(
            witnessed.looser <= 0.0 && witnessed.tighter <= 0.0,
            "{seed} {index}: {witnessed:?}"
        );
        compared += 1;
    }
    assert!(compared > 30, "{compared}");
}

/// Source: fixtures/reference/lead.json, the least and greatest of many poses of a period, none of which leaves the bracket. Brackets are at
/// most 0.01 µm wide.
#[test]
fn reference_extremes() {
    let reference: Value = serde_json::from_str(REFERENCE).unwrap();
    let mut compared = 0;
    for case in reference["extremes"].as_array().unwrap() {
        let name = case["name"].as_str().unwrap();
        let pair = pair(case);
        let [wheel, pinion] = Member::BOTH.map(|member| pair.teeth(member));
        let pitches = SweepPlan::hunting_pitches(wheel, pinion);
        let found = ExactKernel::new(&pair)
            .extremes(&pair, Mating::FIRST, pitches, PROVEN_WIDTH)
            .unwrap();
        // The reference's poses are right to 1e-6 µm, to 5e-6 µm where axes lean, and no denser than its sampling.
        let off = if leans(case) { 5e-6 } else { 1e-6 };
        let expected = |end: &str| number(&case["extremes"][end], "j_wt_um");
        for (extreme, end) in [(found.least, "least"), (found.greatest, "greatest")] {
            let extreme = extreme.unwrap();
            let [low, high] = [extreme.low, extreme.high].map(|mm| mm * 1000.0);
            let value = expected(end);
            assert!(
                low <= value + off && value <= high + off,
                "{name} {end}: {low} {value} {high}"
            );
            assert!(high - low <= 0.01, "{name} {end}: {low} {high}");
        }
        compared += 1;
    }
    assert_eq!(compared, 7);
}

/// No pose of leaning axes leaves the bracket. Source: poses of the whole cycle; their contacts are those of dense sections.
#[test]
fn poses_of_leaning_axes_are_inside_their_brackets() {
    let reference: Value = serde_json::from_str(REFERENCE).unwrap();
    for case in reference["poses"].as_array().unwrap() {
        let name = case["name"].as_str().unwrap();
        // Pairs with traces on all flanks take seconds.
        if !leans(case) || name.contains("everything") {
            continue;
        }
        let pair = pair(case);
        let kernel = ExactKernel::new(&pair);
        let pitches =
            SweepPlan::hunting_pitches(pair.teeth(Member::Wheel), pair.teeth(Member::Pinion));
        let found = kernel
            .extremes(&pair, Mating::FIRST, pitches, 1e-6)
            .unwrap();
        let (least, greatest) = (found.least.unwrap(), found.greatest.unwrap());
        let radius = pair.operating_pitch_radius(pair.free());
        for k in 0..200 {
            let at = (f64::from(k) + 0.37) / 200.0 * pitches as f64;
            let pose = Pose::new(&pair, Mating::FIRST.onward(&pair, at));
            let lost = kernel.lost_motion(&pose).unwrap();
            let (angle, error) = (lost.angle().unwrap(), lost.error().unwrap());
            assert!(
                (angle + error) * radius >= least.low,
                "{name} {at}: {angle} {least:?}"
            );
            assert!(
                (angle - error) * radius <= greatest.high,
                "{name} {at}: {angle} {greatest:?}"
            );
        }
        let width = (least.high - least.low).max(greatest.high - greatest.low);
        assert!(width < 1.3e-5, "{name}: {width}");
    }
}

/// Model 3 has the same lost motion where all contacts are on the line of action. Source: the model, which shares nothing with the simulation.
#[test]
fn model_3_agrees_where_leads_bind_on_the_line() {
    let reference: Value = serde_json::from_str(REFERENCE).unwrap();
    let (mut on_line, mut all) = (0, 0);
    for case in reference["poses"].as_array().unwrap() {
        if leans(case) || case["wheel"]["lead"].to_string().contains("bias") {
            continue;
        }
        let pair = pair(case);
        let kernel = ExactKernel::new(&pair);
        for k in 0..24 {
            let pose = Pose::new(
                &pair,
                mating(&case["mating"]).onward(&pair, f64::from(k) * 0.37),
            );
            let found = kernel.lost_motion(&pose).unwrap();
            let model = LineOfAction::new(&pair, &pose).angle().unwrap();
            let angle = found.angle().unwrap();
            let name = &case["name"];
            // A corner beyond the line can only be tighter.
            assert!(angle <= model + 1e-12, "{name}: {angle} {model}");
            all += 1;
            on_line += u32::from((angle - model).abs() < 1e-12);
        }
    }
    assert!(on_line > all * 3 / 4, "{on_line} of {all}");
}

/// Model 3 covers leaning axes but for `½ g² ρ` a side, by which contacts move along the flank. Source: fixtures/reference/lead.json, rigid
/// bodies. Corners beyond the line make the reference tighter.
#[test]
fn model_3_covers_leaning_axes() {
    let reference: Value = serde_json::from_str(REFERENCE).unwrap();
    let (mut on_line, mut all) = (0, 0);
    for case in reference["poses"].as_array().unwrap() {
        if !leans(case) {
            continue;
        }
        let name = case["name"].as_str().unwrap();
        let pair = pair(case);
        let pose = Pose::new(&pair, mating(&case["mating"]));
        let um = 1000.0 * pair.operating_pitch_radius(pair.free());
        let model = LineOfAction::new(&pair, &pose).angle().unwrap() * um;
        let expected = number(&case["expected"], "j_wt_um");
        let base = pair.gear(pair.free()).gear().base_radius();
        let left_out = 2.0 * pair.left_out() / base * um;
        assert!(model - expected > -1e-4, "{name}: {model} {expected}");
        all += 1;
        on_line += u32::from(model - expected < left_out + 1e-4);
    }
    assert_eq!(all, 20);
    assert!(on_line >= 15, "{on_line} of {all}");
}

/// A contact at an end of the face or on a tip edge is there in the reference too, and the other way round. Source: fixtures/reference/lead.json,
/// `binds`. Where teeth touch along a line, the reference names another of its places.
#[test]
fn reference_contacts_along_the_face() {
    let reference: Value = serde_json::from_str(REFERENCE).unwrap();
    let mut counts = [0; FacePlace::ALL.len()];
    for case in reference["poses"].as_array().unwrap() {
        if case["wheel"]["lead"].to_string().contains("bias") {
            continue;
        }
        let pair = pair(case);
        let pose = Pose::new(&pair, mating(&case["mating"]));
        let found = ExactKernel::new(&pair).lost_motion(&pose).unwrap();
        for (side, contact) in [("right", found.right), ("left", found.left)] {
            let contact = contact.unwrap();
            let Some(at) = FacePlace::of(&pair, &pose, &contact) else {
                continue;
            };
            let binds = &case["binds"][side];
            let name = format!("{} {side}: {binds} {contact:?}", case["name"]);
            let places = ["wheel", "pinion"].map(|gear| {
                let ends: [f64; 2] = serde_json::from_value(case[gear]["face_mm"].clone()).unwrap();
                let height = number(binds, &format!("b_{gear}_mm"));
                (height, ends.map(|end| (end - height).abs() < 1e-3))
            });
            let is_at = |end: usize| places.iter().any(|place| place.1[end]);
            // Axes lean by up to 1.1e-3, which moves the section by up to 0.15 mm.
            let is_same = (contact.section - places[0].0).abs() < 0.2;
            let tips =
                [("wheel", Member::Wheel), ("pinion", Member::Pinion)].map(|(gear, member)| {
                    let tip = pair.gear(member).gear().tip_radius();
                    (number(binds, &format!("{gear}_radius_mm")) - tip).abs() < 1e-4
                });
            let expected = match [is_at(0), is_at(1)] {
                [true, _] => FacePlace::NearEnd,
                [_, true] => FacePlace::FarEnd,
                _ if tips.contains(&true) => FacePlace::TipEdge,
                _ => FacePlace::Inside,
            };
            assert!(is_same || at == FacePlace::Inside, "{name}");
            if is_same {
                assert_eq!(at, expected, "{name}");
                counts[at as usize] += 1;
            }
        }
    }
    assert!(counts.iter().all(|count| *count >= 4), "{counts:?}");
}
