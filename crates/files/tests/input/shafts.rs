//! Shafts that are not parallel, as they are read. Expected values are closed forms to first order: `sin α_wt |θ| b` in the plane of the axes,
//! `cos α_wt |θ| b` out of it. `tests/sessions/along_face.txt` holds what is warned of and refused.

use super::leads::{SPUR, j_bt, mating};
use super::*;
use gearlash::gear::{Side, involute::inv};
use gearlash::pair::Pose;

/// The spur pair of 20 mm, face to face over `face`, with these keys of the wheel and of `[assembly]`.
fn spur(face: [f64; 2], wheel: &str, assembly: &str) -> PairFile {
    pair(face, [wheel, ""], assembly)
}

/// The pair with these keys of its gears and of `[assembly]`.
fn pair(face: [f64; 2], [wheel, pinion]: [&str; 2], assembly: &str) -> PairFile {
    let text = SPUR.replace("[-10, 10]", &format!("{face:?}"));
    let text = text.replace("WHEEL", wheel).replace("PINION", pinion);
    study(&text.replace(PARALLEL, assembly))
}

/// Backlash that these keys take from the pair at 60.2 mm, µm on the base circles.
fn loss(face: [f64; 2], wheel: &str, assembly: &str) -> f64 {
    let at = |file: &PairFile| j_bt(file, (1, 1), Side::Right);
    at(&spur(face, "", PARALLEL)) - at(&spur(face, wheel, assembly))
}

fn lean(in_plane: f64, out_of_plane: f64, more: &str) -> String {
    format!(
        "center_distance_mm = 60.2\nmisalignment = {{ in_plane_um = {in_plane}, out_of_plane_um = {out_of_plane}, over_mm = 100{more} }}"
    )
}

/// Sum of the base radii, mm.
fn base() -> f64 {
    60.0 * 20f64.to_radians().cos()
}

/// Loss of axes that are nearer by `um` somewhere along the face, µm on the base circles: `2 r_b inv α_wt`, or `2 sin α_wt` of it to first order.
fn nearer(um: f64) -> f64 {
    let room = |a: f64| 2e3 * base() * inv((base() / a).acos());
    room(60.2) - room(60.2 - um / 1e3)
}

/// Loss of skew axes, `cos α_wt θ b`, of a deviation over the face, µm.
fn skew(um: f64) -> f64 {
    base() / 60.2 * um
}

const CENTRED: [f64; 2] = [-10.0, 10.0];
const PARALLEL: &str = "center_distance_mm = 60.2";

#[test]
fn shafts_cost_what_closed_forms_say() {
    let ends = "center_distance_mm = { ends_mm = [[-50, 60.195], [50, 60.205]] }";
    let far = "center_distance_mm = { ends_mm = [[20, 60.196], [70, 60.191]] }";
    let cases = [
        (CENTRED, lean(10.0, 0.0, ""), nearer(1.0)),
        (CENTRED, lean(-10.0, 0.0, ", at_mm = 0"), nearer(1.0)),
        (CENTRED, lean(0.0, 10.0, ""), skew(2.0)),
        (CENTRED, lean(0.0, -10.0, ""), skew(2.0)),
        // Apart at the far end: nothing is lost of teeth beyond the measuring plane, twice as much of those before it.
        ([0.0, 20.0], lean(10.0, 0.0, ""), 0.0),
        ([0.0, 20.0], lean(-10.0, 0.0, ""), nearer(2.0)),
        // The centre distance holds at one end of the teeth, or beyond it.
        (CENTRED, lean(10.0, 0.0, ", at_mm = -10"), 0.0),
        (CENTRED, lean(10.0, 0.0, ", at_mm = 10"), nearer(2.0)),
        (CENTRED, lean(10.0, 0.0, ", at_mm = 60"), nearer(7.0)),
        // As measured at two places.
        (CENTRED, ends.to_owned(), nearer(1.0)),
        (CENTRED, far.to_owned(), nearer(3.0)),
    ];
    for (face, keys, expected) in &cases {
        let found = loss(*face, "", keys);
        assert!(
            (found - expected).abs() < 2e-4,
            "{keys}: {found}, {expected}"
        );
    }
}

/// The pinion's far end stands higher: teeth of a wheel that wind to the left follow it, and such that wind to the right lose both.
#[test]
fn a_lead_follows_a_skew_of_its_sense() {
    let turned = |hand| {
        format!(
            "lead = {{ helix_slope_um = \"{} {hand}\", over = \"face\" }}",
            skew(2.0)
        )
    };
    assert!(loss(CENTRED, &turned("l"), &lean(0.0, 10.0, "")).abs() < 2e-4);
    let both = loss(CENTRED, &turned("r"), &lean(0.0, 10.0, ""));
    assert!((both - skew(4.0)).abs() < 2e-4, "{both}");
}

/// The distance of skew axes at a place is that of both components there.
#[test]
fn the_distance_holds_where_it_is_stated() {
    let file = spur(CENTRED, "", &lean(100.0, -1000.0, ", at_mm = 40"));
    let a = file.study.center_distances[0];
    let at: f64 = (a + 40.0 * 1e-3f64).hypot(40.0 * 1e-2);
    assert!((at - 60.2).abs() < 1e-11, "{at}");
    assert_eq!(file.study.lean, [1e-3, -1e-2]);
    let ends = "center_distance_mm = { ends_mm = [[-30, 60.1], [40, 60.2]] }\nmisalignment = { out_of_plane_um = 1000, over_mm = 100 }";
    let file = spur(CENTRED, "", ends);
    let ([x, y], a) = (file.study.lean, file.study.center_distances[0]);
    for (at, mm) in [(-30.0, 60.1), (40.0, 60.2)] {
        assert!(((a + x * at).hypot(y * at) - mm).abs() < 1e-11);
    }
}

/// At other distances, as `--center-distance` asks for, the axes lean as before.
#[test]
fn other_distances_keep_the_lean() {
    let ends = "center_distance_mm = { ends_mm = [[-50, 60.195], [50, 60.205]] }";
    let file = spur(CENTRED, "", ends).at(vec![60.3]).unwrap();
    assert!((file.study.lean[0] - 1e-4).abs() < 1e-12);
    let (echo, kept) = (file.spec.assembly.lean(), file.study.lean);
    assert!((echo[0] - kept[0]).abs() < 1e-15 && file.spec.assembly.holds_at() == 0.0);
}

/// The pair of 36 and 24 teeth over `face` with a runout of the gear called `name`.
fn with_runout(face: [f64; 2], name: &str, runout: &str) -> PairFile {
    let keys = ["wheel", "pinion"].map(|own| if own == name { runout } else { "" });
    pair(face, keys, PARALLEL)
}

/// Two planes at the ends of teeth of 20 mm, centred at the first; the reference face is in front, or at the back.
fn planes(um: f64, tooth: f64) -> String {
    format!(
        "runout.planes = [{{ from_reference_face_mm = 0, total_um = 0, high_tooth = 1 }}, \
         {{ from_reference_face_mm = 20, total_um = {um}, high_tooth = {tooth} }}]"
    )
}

/// A shoulder on a diameter of 50 mm.
fn shoulder(um: f64, tooth: f64, face: &str) -> String {
    format!(
        "runout = {{ total_um = 0, face_runout = {{ um = {um}, diameter_mm = 50, high_tooth = {tooth}, face = \"{face}\" }} }}"
    )
}

/// Displaced by 2 µm at the far end towards the mate, the axes are nearer by it there; away from it, nothing is lost. A shoulder of 50 mm that
/// runs out by 5 µm leans as much.
#[test]
fn wobble_brings_the_far_end_nearer() {
    for (member, teeth, face) in [
        (Member::Wheel, 36.0, [0.0, 20.0]),
        (Member::Pinion, 24.0, [-20.0, 0.0]),
    ] {
        let name = member.name();
        let plain = j_bt(&with_runout(face, name, ""), (1, 1), Side::Right);
        let loss =
            |runout: &str| plain - j_bt(&with_runout(face, name, runout), (1, 1), Side::Right);
        // The locked wheel's tooth 1 points at the pinion but for a fifth of a pitch, and the pinion's as much less.
        let file = with_runout(face, name, "");
        let run = &file.study.runs().unwrap()[0];
        let pair = run.run.assembly.data().unwrap();
        let pose = Pose::new(pair, mating((1, 1), Side::Right));
        let gear = pair.gear(member);
        let ascending = gear.face().ascending() * gear.gear().basic_data().angular_pitch();
        let towards = 1.0 + (-pose.rotation(pair, member) / ascending).rem_euclid(teeth);
        let away = 1.0 + (towards - 1.0 + 0.5 * teeth).rem_euclid(teeth);
        for (towards, away) in [
            (planes(4.0, towards), planes(4.0, away)),
            (
                shoulder(5.0, towards, "reference"),
                shoulder(5.0, away, "reference"),
            ),
            (shoulder(5.0, away, "far"), shoulder(5.0, towards, "far")),
        ] {
            let found = loss(&towards);
            // The free gear takes its wobble with it from its right contact to its left one: cos α_wt of 2 µm by that turn.
            let turn = 1e-3 * (plain - found) / gear.gear().base_radius();
            let turned = f64::from(member == Member::Pinion) * skew(2.0) * turn;
            let off = found - nearer(2.0) - turned;
            assert!(off.abs() < 2e-4, "{towards}: {found}");
            assert!(loss(&away).abs() < 2e-4, "{away}");
        }
    }
}

/// The planes of helical teeth count their own teeth: a straight axis has another high tooth in each.
#[test]
fn an_eccentric_helical_gear_does_not_wobble() {
    let lead_mm = std::f64::consts::PI * 3.0 * 20.0 / 15f64.to_radians().sin();
    let wound = 30.0 / lead_mm * 20.0;
    for (hand, face, sense) in [
        ("right", "front", 1.0),
        ("left", "front", -1.0),
        ("right", "back", 1.0),
    ] {
        let keys = format!(
            "helix_angle_deg = 15\nhand = \"{hand}\"\nface_mm = [-15, 15]\nreference_face = \"{face}\"\n\
             runout.planes = [{{ from_reference_face_mm = 0, total_um = 20, high_tooth = 4 }}, \
             {{ from_reference_face_mm = 30, total_um = 20, high_tooth = {} }}]",
            4.0 - sense * wound
        );
        let mate = if hand == "right" { "left" } else { "right" };
        let pinion =
            format!("teeth = 30\nhelix_angle_deg = 15\nface_width_mm = 30\nhand = \"{mate}\"\n");
        let file = study(
            &PAIR
                .replace("teeth = 20\n", &format!("teeth = 20\n{keys}\n"))
                .replace("teeth = 30\n", &pinion)
                .replace("75.2", "78.0"),
        );
        let wheel = &file.study.materials[0].1;
        assert!(wheel.wobble() < 1e-12, "{hand} {face}: {}", wheel.wobble());
        assert!((wheel.eccentricity() - 0.01).abs() < 1e-12);
        assert!((wheel.high_tooth() - (4.0 - 0.5 * sense * wound)).abs() < 1e-9);
    }
}

/// Sources: the derivatives of the closed forms, at the ends of the face.
#[test]
fn uncertain_leads_and_shafts_widen_the_result() {
    let (tan, cos) = (
        (1.0 - (base() / 60.2).powi(2)).sqrt() / (base() / 60.2),
        base() / 60.2,
    );
    let cases = [
        ("lead_um = 1", "", 2.0 * 2.0 / cos),
        ("misalignment_um = 10", "", 2e-1 * (20.0 * tan).hypot(20.0)),
        (
            "misalignment_um = 10",
            ", at_mm = 30",
            2e-1 * (80.0 * tan).hypot(20.0),
        ),
    ];
    for (uncertain, at, expected) in cases {
        let keys = format!("{}\n[uncertainty]\n{uncertain}", lean(0.0, 0.0, at));
        let file = spur(CENTRED, "", &keys);
        let found = of_study(&file.study);
        let least = found.each[0].least.as_ref().unwrap();
        let stated = file.study.uncertainty.unwrap();
        let um = 1e3 * stated.of(&least.assembly, &least.pose.simulated).unwrap();
        assert!(
            (um - expected).abs() < 1e-9,
            "{uncertain}: {um}, {expected}"
        );
    }
}

/// The least and the greatest `j_wt` of the whole cycle, within the bearings where they have clearance, as µm on the base circles: attained, and their
/// bounds.
fn of_cycle(file: &PairFile) -> [(f64, [f64; 2]); 2] {
    let found = of_study(&file.study);
    let run = &found.each[0];
    let ends = match &run.bearings {
        Some(play) => [&play.pressed.extreme, &play.apart.extreme],
        None => [&run.least, &run.greatest],
    };
    ends.map(|extreme| {
        let extreme = extreme.as_ref().unwrap();
        let per_base = 1e3 * base() / extreme.assembly.center_distance();
        (
            extreme.found() * per_base,
            [extreme.low, extreme.high].map(|mm| mm * per_base),
        )
    })
}

/// The worst direction counts: nearer at one end, or askew. The greatest is that of parallel axes, which the measuring plane bounds.
#[test]
fn a_misalignment_of_unknown_sense_takes_the_worst() {
    let plain = of_cycle(&spur(CENTRED, "", PARALLEL));
    let cases = [
        ("in_plane_um = { max = 10 }", nearer(1.0)),
        ("out_of_plane_um = { max = 10 }", skew(2.0)),
        (
            "in_plane_um = { max = 10 }, out_of_plane_um = { max = 10 }",
            skew(2.0),
        ),
        // A stated component and an unknown one.
        (
            "in_plane_um = 10, out_of_plane_um = { max = 1 }",
            nearer(1.0),
        ),
    ];
    for (keys, expected) in cases {
        let keys = format!(
            "center_distance_mm = 60.2\nmisalignment = {{ {keys}, over_mm = 100, at_mm = 0 }}"
        );
        let [(least, [low, high]), (greatest, [from, to])] = of_cycle(&spur(CENTRED, "", &keys));
        assert!(
            (plain[0].0 - least - expected).abs() < 2e-3,
            "{keys}: {least}"
        );
        assert!(low <= least + 1e-9 && least <= high + 1e-9, "{keys}");
        if !keys.contains("= 10, out") {
            assert!((greatest - plain[1].0).abs() < 1e-3, "{keys}: {greatest}");
        }
        assert!(
            from <= greatest + 1e-9 && greatest <= to + 1e-9 && to < plain[1].0 + 1e-3,
            "{keys}: {from} {to}"
        );
    }
}

/// Narrow helical teeth gain by a lean: contacts stand at other heights right and left, and the twist turns the flanks away from
/// each other. Source: the extremes of stated leans.
#[test]
fn a_lean_that_narrow_helical_teeth_gain_by_is_in_the_bracket() {
    let at = |assembly: &str| {
        let helical = "face_width_mm = 0.2\nhelix_angle_deg = 30\nthickness.allowance_um = -60";
        let gear = |name: &str, teeth: u32, hand: &str| {
            format!(
                "[{name}]\nteeth = {teeth}\nmodule_mm = 2.5\npressure_angle_deg = 20\nhand = \"{hand}\"\n{helical}\n"
            )
        };
        let gears = gear("wheel", 51, "right") + &gear("pinion", 27, "left");
        let misalignment = format!("misalignment = {{ {assembly}, over_mm = 80, at_mm = 0 }}");
        of_cycle(&study(&format!(
            "title = \"narrow\"\n{gears}\n[assembly]\ncenter_distance_mm = 112.8\n{misalignment}\n[sweep]\nmating = [[1, 1]]\n"
        )))
    };
    let [(_, [low, _]), (_, [from, to])] =
        at("in_plane_um = { max = 24 }, out_of_plane_um = { max = 24 }");
    let mut gain = f64::NEG_INFINITY;
    let parallel = at("in_plane_um = 0, out_of_plane_um = 0")[1].0;
    for (x, y) in [(-24, -24), (-24, 24), (0, 24), (13, -9)] {
        let [(least, _), (greatest, _)] = at(&format!("in_plane_um = {x}, out_of_plane_um = {y}"));
        assert!(
            low <= least && greatest <= to,
            "{x} {y}: {least} {greatest}, {low} {to}"
        );
        gain = gain.max(greatest - parallel);
    }
    assert!(gain > 0.3 && from <= to, "{gain} {from} {to}");
}

/// Bearings at both ends of the teeth with 3 µm together: right flanks take all of it at one end, left ones at the other. Pulled apart, the axes are
/// 3 µm further apart.
#[test]
fn axes_tilt_in_their_bearings() {
    let at = |keys: &str| {
        let keys = format!("{PARALLEL}\nbearing_clearance_mm = {keys}");
        of_cycle(&spur(CENTRED, "", &keys))
    };
    let plain = of_cycle(&spur(CENTRED, "", PARALLEL));
    let [(least, [low, high]), (greatest, [from, to])] =
        at("{ wheel = 0.002, pinion = 0.001, at_mm = [-10, 10] }");
    assert!((plain[0].0 - least - 6.0).abs() < 5e-3, "{least}");
    let holds = |low: f64, found: f64, high: f64| low <= found + 1e-9 && found <= high + 1e-9;
    assert!(holds(low, least, high) && low.is_finite(), "{low}");
    let off = plain[1].0 - greatest - nearer(-3.0);
    assert!(off.abs() < 2e-3, "{greatest}");
    assert!(holds(from, greatest, to) && to < greatest + 1e-2, "{to}");
    // Other clearances at the far bearing: 2 µm and 6 µm are 4 µm in the middle.
    let [(least, _), (greatest, _)] =
        at("{ wheel = [0.001, 0.005], pinion = 0.001, at_mm = [-10, 10] }");
    assert!((plain[0].0 - least - 8.0).abs() < 1e-2, "{least}");
    let found = greatest - plain[1].0;
    assert!((found + nearer(-2.0)).abs() < 5e-3, "{found}");
}

/// Leads about the bore of a wheel that wobbles are slopes that run as a sine about the gear: `n·t` a mm. The wobble is found in them, and the teeth are
/// straight about their own axis. Where it is stated too, it counts once.
#[test]
fn leads_about_the_bore_contain_the_wobble() {
    let pitch = std::f64::consts::TAU / 36.0;
    let slope = |tooth: f64, sense: f64| {
        let place = -(tooth - 1.0) * pitch + sense * (0.25 * pitch - 20f64.to_radians());
        let lean = -(8.0 - 1.0) * pitch;
        2.0 * sense * (lean - place).sin()
    };
    let traces = |sense: f64| {
        let each = [1, 10, 19, 28].map(|tooth| {
            format!(
                "{{ tooth = {tooth}, from_reference_face_mm = [0, 20], deviation_um = [0, {}] }}",
                slope(f64::from(tooth), sense)
            )
        });
        each.join(", ")
    };
    let leads = |axis: &str| {
        format!(
            "lead = {{ axis = \"{axis}\", from = \"reference\", zero_mm = 0, right.trace = [{}], left.trace = [{}] }}",
            traces(-1.0),
            traces(1.0)
        )
    };
    let face = [0.0, 20.0];
    let file = with_runout(face, "wheel", &leads("datum"));
    let wheel = &file.study.materials[0].1;
    let (wobble, tooth) = (wheel.wobble(), wheel.wobble_tooth());
    assert!((wobble - 1e-4).abs() < 1e-8, "{wobble}");
    assert!((tooth - 8.0).abs() < 1e-2, "{tooth}");
    let remarks = file.remarks.join("\n");
    let words = "wobble of 2.00 µm over the teeth, towards tooth 8.00";
    assert!(remarks.contains(words), "{remarks}");
    let stated = planes(4.0, 8.0);
    let j = |keys: &str| j_bt(&with_runout(face, "wheel", keys), (8, 8), Side::Right);
    let expected = j(&stated);
    assert!((j(&leads("datum")) - expected).abs() < 1e-4);
    assert!((j(&format!("{}\n{stated}", leads("datum"))) - expected).abs() < 1e-4);
    // About the axis of the teeth they would be leads of four teeth alone.
    assert!(j(&leads("own")) - expected > 1.0);
    let both = format!("{}\n{}", leads("datum"), planes(12.0, 8.0));
    let warnings = with_runout(face, "wheel", &both).warnings.join("\n");
    let words = "the stated wobble counts, 4.00 µm off it";
    assert!(warnings.contains(words), "{warnings}");
}
