//! Helical stages.

use super::oracle::Model;
use super::*;

/// Stage 10 of the fixture wound by 15°, its centre distance 39 · 4/(2 cos 15°) and a little.
fn model(angles: [&str; 2]) -> String {
    let text = fixture("gearbox.rexs");
    let text = text.replacen(
        "unit=\"deg\">-0.0<",
        &format!("unit=\"deg\">{}<", angles[0]),
        1,
    );
    let text = text.replacen(
        "unit=\"deg\">0.0<",
        &format!("unit=\"deg\">{}<", angles[1]),
        1,
    );
    text.replacen(">78.0<", ">80.8<", 1)
}

#[test]
fn angle_hand_and_face_width_become_those_of_the_pair() {
    for (angles, hands) in [
        (["15.0", "-15.0"], ["right", "left"]),
        (["-15.0", "15.0"], ["left", "right"]),
    ] {
        let text = model(angles);
        let file = read(&text).unwrap();
        let made = pair(&file, 10);
        for (name, hand) in ["wheel", "pinion"].into_iter().zip(hands) {
            let gear = &made[name];
            assert_eq!(gear["helix_angle_deg"].as_float(), Some(15.0));
            assert_eq!(gear["hand"].as_str(), Some(hand));
            assert_eq!(gear["face_width_mm"].as_float(), Some(20.0));
        }
        Model::of_xml(&text).check(10, &made);
        let stage = file.stage(10).unwrap().pair.as_ref().unwrap();
        let words = format!("z 17/22, m 4, β 15° {}/{}, a 80.8 js7", hands[0], hands[1]);
        assert!(stage.summary.starts_with(&words), "{}", stage.summary);
        let message = stage.remarks.join("; ");
        assert!(
            message.contains("their faces are taken as centred on each other"),
            "{message}"
        );
    }
}

#[test]
fn what_is_no_helical_pair_is_left_out_with_the_reason() {
    let width = "<attribute id=\"face_width\" unit=\"mm\">20.0</attribute>";
    for (text, expected) in [
        (
            model(["15.0", "15.0"]),
            "teeth of an external pair wind opposite ways",
        ),
        (
            model(["15.0", "-16.0"]),
            "pinion.helix_angle_deg = 16.0: differs from wheel.helix_angle_deg = 15.0",
        ),
        (model(["15.0", "0.0"]), "pinion.helix_angle_deg: differs"),
        (model(["75.0", "-75.0"]), "cylindrical_gear 11: helix angle"),
        (
            model(["15.0", "-15.0"]).replacen(width, "", 1),
            "cylindrical_gear 11 has no face_width",
        ),
    ] {
        let file = read(&text).unwrap();
        let message = why(&file, 10);
        assert!(message.contains(expected), "{message}");
    }
}

/// Over balls and over pins are not the same on a helical gear; the third name does not say which.
#[test]
fn a_size_is_over_balls_or_over_pins() {
    let series = "<attribute id=\"tooth_thickness_deviation_tolerance_series_din_3967_1978\" unit=\"none\">c25</attribute>";
    let generated = "generated_addendum_modification_coefficient";
    let stated = |size: &str| {
        let stated = format!(
            "<attribute id=\"{size}\" unit=\"mm\">81.5</attribute><attribute id=\"diameter_of_measuring_ball_or_pin\" unit=\"mm\">7.0</attribute>"
        );
        let text = model(["15.0", "-15.0"]).replace(generated, "other");
        read(&text.replacen(series, &stated, 1)).unwrap()
    };
    for (size, kind) in [("size_over_balls", "ball"), ("size_over_pins", "pin")] {
        let made = pair(&stated(size), 10);
        let over = &made["wheel"]["thickness"]["over_pins"];
        assert_eq!(over["kind"].as_str(), Some(kind));
        assert_eq!(over["mm"].as_float(), Some(81.5));
    }
    let message = why(&stated("diametral_measurement"), 10);
    assert!(
        message.contains("add size_over_balls or size_over_pins"),
        "{message}"
    );
}
