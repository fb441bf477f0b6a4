//! Helical gears: what is read, and what is refused.

use super::*;
use gearlash::gear::Hand;

const HELICAL: &str = r#"
[wheel]
teeth = 20
module_mm = 3.0
pressure_angle_deg = 20.0
helix_angle_deg = 15
hand = "left"
face_width_mm = 30
[pinion]
teeth = 30
module_mm = 3.0
pressure_angle_deg = 20.0
helix_angle_deg = 15
hand = "right"
face_mm = [-5, 40]
[assembly]
center_distance_mm = 78
"#;

fn refused(text: &str) -> String {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("pair.toml");
    fs::write(&path, text).unwrap();
    read(&path).unwrap_err().to_string()
}

/// The common face is what both have; radii are of the transverse module `m_n/cos β`.
#[test]
fn hand_and_face_are_read() {
    let file = study(HELICAL);
    assert_eq!(file.study.face, [-5.0, 15.0]);
    let run = &file.study.runs().unwrap()[0];
    assert_eq!(run.assembly.face(), [-5.0, 15.0]);
    let data = run.assembly.gear(Member::Wheel).gear().basic_data();
    assert_eq!(data.hand(), Some(Hand::Left));
    let radius = 30.0 / f64::to_radians(15.0).cos();
    assert!((data.reference_radius() - radius).abs() < 1e-13);
    assert_eq!(file.spec.wheel.face_mm, Some([-15.0, 15.0]));
    let off = HELICAL.replace("= 78\n", "= 78\nface_offset_mm = -20\n");
    assert_eq!(study(&off).study.face, [-15.0, 15.0]);
}

/// Of a spur pair hand, face and a helix angle of 0 change nothing.
#[test]
fn a_helix_angle_of_0_is_a_spur_gear() {
    let spur = HELICAL.replace("helix_angle_deg = 15", "helix_angle_deg = 0");
    let plain = [
        "hand = \"left\"\n",
        "hand = \"right\"\n",
        "face_width_mm = 30\n",
        "face_mm = [-5, 40]\n",
        "helix_angle_deg = 0\n",
    ];
    let plain = plain
        .into_iter()
        .fold(spur.clone(), |text, line| text.replace(line, ""));
    let [one, other] = [spur, plain].map(|text| study(&text).study);
    assert_eq!(one, other);
}

/// A pinion whose measuring plane lies off stands there as its own plane has it: its runout turned against its teeth by `b tan β/r`.
#[test]
fn an_offset_turns_the_runout_against_the_teeth() {
    let text = HELICAL.replace(
        "face_mm = [-5, 40]",
        "face_mm = [-5, 40]\nrunout = { total_um = 20, high_tooth = 3 }",
    );
    let high = |text: &str| {
        let study = study(text).study;
        study.materials[0].2.high_tooth()
    };
    assert_eq!(high(&text), 3.0);
    let moved = high(&text.replace("= 78\n", "= 78\nface_offset_mm = 10\n"));
    let radius = 45.0 / f64::to_radians(15.0).cos();
    let turned = 10.0 * f64::to_radians(15.0).tan() / radius / (std::f64::consts::TAU / 30.0);
    assert!(
        (moved - 3.0).abs() > 0.2 && ((moved - 3.0).abs() - turned).abs() < 1e-12,
        "{moved} {turned}"
    );
}

#[test]
fn what_is_no_helical_pair_is_told() {
    for (from, to, expected) in [
        (
            "hand = \"left\"\n",
            "",
            "wheel.hand: missing, expected \"left\" or \"right\" beside a helix angle above 0",
        ),
        (
            "hand = \"left\"",
            "hand = \"right\"",
            "pinion.hand = \"right\": is \"right\" as the wheel's: teeth of an external pair wind opposite ways",
        ),
        (
            "face_width_mm = 30\n",
            "",
            "wheel.face_width_mm: missing, expected the face width",
        ),
        (
            "face_width_mm = 30",
            "face_width_mm = 30\nface_mm = [0, 1]",
            "given together with face_width_mm",
        ),
        (
            "[-5, 40]",
            "[40, -5]",
            "allowed is [from, to] with from below to",
        ),
        ("[-5, 40]", "[20, 40]", "the gears do not face each other"),
        (
            "helix_angle_deg = 15\nhand = \"right\"",
            "helix_angle_deg = 16\nhand = \"right\"",
            "pinion.helix_angle_deg = 16: differs from wheel.helix_angle_deg = 15.0",
        ),
        (
            "helix_angle_deg = 15\nhand = \"right\"",
            "hand = \"right\"",
            "pinion.helix_angle_deg: differs from wheel.helix_angle_deg = 15.0",
        ),
        (
            "helix_angle_deg = 15\nhand = \"left\"",
            "helix_angle_deg = 61\nhand = \"left\"",
            "allowed is a number of degrees, 0 … 60",
        ),
        (
            "face_width_mm = 30",
            "face_width_mm = 30\nrunout.total_um = 20",
            "wheel.runout.high_tooth: given beside a helix angle",
        ),
        (
            "= 78\n",
            "= 78\n[uncertainty]\nspan_um = 2\n",
            "uncertainty = { span_um = 2 }: given beside a helix angle",
        ),
    ] {
        assert!(HELICAL.contains(from), "{from}");
        let told = refused(&HELICAL.replace(from, to));
        assert!(told.contains(expected), "{told}");
    }
    let warm = HELICAL
        .replace("= 3.0\n", "= 3.0\nexpansion_per_k = 12e-6\n")
        .replace(
            "= 78\n",
            "= 78\ntemperature_c = 60\nhousing_expansion_per_k = 23e-6\n",
        );
    let told = refused(&warm);
    assert!(
        told.contains("assembly.temperature_c = 60: given beside a helix angle"),
        "{told}"
    );
}

/// `b ≥ W_k sin β_b + b_M cos β_b`, as helical.md of shops has it: here with `sin β_b = sin 15° cos 20°`.
#[test]
fn a_face_too_short_for_the_span_is_a_warning() {
    let with = |face: &str| {
        let text = HELICAL.replace(
            "face_width_mm = 30",
            &format!("face_width_mm = {face}\nthickness.span = {{ teeth = 3, mm = 23.0 }}"),
        );
        study(&text).warnings
    };
    let sin = f64::to_radians(15.0).sin() * f64::to_radians(20.0).cos();
    let needed = 23.0 * sin + (1.2 + 0.018 * 23.0) * (1.0 - sin * sin).sqrt();
    assert_eq!(with(&format!("{}", needed + 1e-6)), Vec::<String>::new());
    let warned = with(&format!("{}", needed - 1e-6));
    assert!(
        warned[0].contains("wheel.face_mm: a span over 3 teeth needs a face of 7.1"),
        "{warned:?}"
    );
}
