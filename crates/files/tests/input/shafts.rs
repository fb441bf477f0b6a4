//! Shafts that are not parallel, as they are read. Expected values are lead.md's closed forms to first order.

use super::leads::{SPUR, j_bt};
use super::*;
use gearlash::gear::{Side, involute::inv};

/// The spur pair of 20 mm, face to face over `face`, with these keys of the wheel and of `[assembly]`.
fn spur(face: [f64; 2], wheel: &str, assembly: &str) -> PairFile {
    let text = SPUR.replace("[-10, 10]", &format!("{face:?}"));
    let text = text.replace("WHEEL", wheel).replace("PINION", "");
    study(&text.replace("center_distance_mm = 60.2", assembly))
}

/// Backlash that these keys take from the pair at 60.2 mm, µm on the base circles.
fn loss(face: [f64; 2], wheel: &str, assembly: &str) -> f64 {
    let at = |file: &PairFile| j_bt(file, (1, 1), Side::Right);
    at(&spur(face, "", "center_distance_mm = 60.2")) - at(&spur(face, wheel, assembly))
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

#[test]
fn a_great_lean_and_an_open_place_are_warnings() {
    let warnings = |keys: &str| spur(CENTRED, "", keys).warnings.join("\n");
    let found = warnings(&lean(10.0, 0.0, ""));
    assert!(
        found.contains("assembly.misalignment.at_mm: not stated"),
        "{found}"
    );
    assert!(found.contains("changes by 1.00 µm every 10 mm"), "{found}");
    assert_eq!(warnings(&lean(10.0, 0.0, ", at_mm = 0")), "");
    assert_eq!(warnings(&lean(0.0, 10.0, "")), "");
    let found = warnings(&lean(0.0, 600.0, ""));
    assert!(found.contains("lean by 0.0060 mm per mm"), "{found}");
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
