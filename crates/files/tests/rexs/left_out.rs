//! What becomes no pair, and what is wrong with a file.

use super::*;

#[test]
fn only_external_spur_stages_are_read() {
    let file = read(&fixture("gearbox.rexs")).unwrap();
    let told: Vec<(i32, String)> = file
        .stages
        .iter()
        .filter_map(|stage| Some((stage.id, stage.pair.as_ref().err()?.clone())))
        .collect();
    let expected = [
        (
            30,
            "the flanks of cylindrical_gear 31 have no normal_pressure_angle",
        ),
        (40, "a planetary stage: its play is not that of one pair"),
        (41, "part of planetary_stage 40"),
        (42, "part of planetary_stage 40"),
        (44, "ring_gear 43 is internal"),
        (50, "not a stage of cylindrical gears"),
    ];
    assert_eq!(told, expected.map(|(id, why)| (id, why.to_owned())));
    let left_out = file
        .left_out
        .iter()
        .map(|(kind, count)| format!("{count} {kind}"));
    let left_out: Vec<String> = left_out.collect();
    for kind in [
        "3 shaft",
        "1 ring_gear",
        "2 cylindrical_gear",
        "1 load_spectrum",
    ] {
        assert!(
            left_out.iter().any(|one| one == kind),
            "{kind}: {left_out:?}"
        );
    }
}

#[test]
fn a_stage_that_lacks_or_contradicts_something_is_left_out_with_the_reason() {
    let good = fixture("gearbox.rexs");
    for (from, to, stage, told) in [
        (
            "<attribute id=\"helix_angle_reference_diameter\" unit=\"deg\">-0.0</attribute>",
            "",
            10,
            "only 0 makes it spur",
        ),
        (
            "<attribute id=\"center_distance\" unit=\"mm\">78.0</attribute>",
            "",
            10,
            "cylindrical_stage 10 has no center_distance",
        ),
        (
            "\">17</attribute>",
            "\">-17</attribute>",
            10,
            "is internal: number_of_teeth is negative",
        ),
        (
            "c25</attribute>",
            "k25</attribute>",
            10,
            "cylindrical_gear 11: k25: ",
        ),
        (
            "din_3964_1980\" unit=\"none\">7",
            "din_3964_1980\" unit=\"none\">11",
            10,
            "js11",
        ),
        (
            "<ref id=\"12\" role=\"gear_2\"/>",
            "<ref id=\"11\" role=\"gear_2\"/>",
            10,
            "both its gears are cylindrical_gear 11",
        ),
        (
            "lower_center_distance_allowance",
            "other",
            20,
            "one centre distance allowance without the other",
        ),
        (
            "lower_backlash_allowance_referenced_to_span",
            "other",
            20,
            "without the other",
        ),
        (
            "type=\"flank\"",
            "type=\"side\"",
            10,
            "no normal_pressure_angle",
        ),
        (
            "tooth_thickness_deviation_tolerance_series_din_3967_1978",
            "chordal_tooth_thickness_upper_deviation",
            10,
            "which is not read",
        ),
        (
            "normal_module\" unit=\"mm\">4.0",
            "normal_module\" unit=\"mm\">4.5",
            10,
            "makes no pair: pinion.module_mm",
        ),
    ] {
        let text = good.replacen(from, to, 1);
        assert_ne!(text, good, "{from}");
        let found = why(&read(&text).unwrap(), stage);
        assert!(found.contains(told), "{told}: {found}");
    }
}

#[test]
fn what_is_wrong_is_reported_with_its_place() {
    let good = fixture("gearbox.rexs");
    for (from, to, told) in [
        (
            ">17<",
            ">1x7<",
            "cylindrical_gear 11, number_of_teeth = 1x7: not a number",
        ),
        (
            ">17<",
            ">17.5<",
            "cylindrical_gear 11, number_of_teeth = 17.5: not a whole number above 0",
        ),
        (
            ">78.0<",
            ">78,0<",
            "cylindrical_stage 10, center_distance = 78,0: not a number",
        ),
        (
            ">78.0<",
            ">inf<",
            "cylindrical_stage 10, center_distance = inf: not a number",
        ),
        (
            "\"mm\">78.0",
            "\"mum\">78.0",
            "cylindrical_stage 10, center_distance = 78.0: in the unit mum, the format has mm",
        ),
        (
            "component id=\"12\"",
            "component id=\"11\"",
            "cylindrical_gear 11: stands twice",
        ),
        (
            "id=\"face_width\"",
            "id=\"normal_module\"",
            "cylindrical_gear 11, normal_module: stands twice",
        ),
        (
            "ref id=\"12\"",
            "ref id=\"99\"",
            "names component 99, which the file does not have",
        ),
        (
            "role=\"gear_2\"",
            "role=\"gear_1\"",
            "has more than one component as gear_1",
        ),
        (
            "version=\"2.0.0\"",
            "version=\"3.0\"",
            "model version = 3.0: unknown, known are 1.0 to 1.7 and 2.0",
        ),
        (
            "<component id=\"1\"",
            "<component id=\"one\"",
            "component: id one is not a whole number",
        ),
        (
            "<component id=\"1\"",
            "<part id=\"1\"",
            "part: expected component",
        ),
        ("</components>", "</component>", "not XML"),
        (
            "<model",
            "<!DOCTYPE model [<!ENTITY e \"x\">]><model",
            "not XML",
        ),
    ] {
        let text = good.replacen(from, to, 1);
        assert_ne!(text, good, "{from}");
        let error = match read(&text) {
            Ok(file) => why(&file, 10),
            Err(error) => error.to_string(),
        };
        assert!(error.contains(told), "{told}: {error}");
    }
}

#[test]
fn what_is_wrong_with_json_is_reported_with_its_place() {
    let good = fixture("gearbox.rexsj");
    let line = |what: &str| 1 + good[..good.find(what).unwrap()].matches('\n').count();
    for (from, to, told) in [
        (
            "\"integer\": 17",
            "\"integer\": \"17\"",
            "not REXS: invalid type: string".to_owned(),
        ),
        (
            "\"floating_point\": 78.0",
            "\"floating_point\": 78.0, \"integer\": 78",
            "component 10, center_distance: has several values".to_owned(),
        ),
        (
            "\"floating_point\": 78.0",
            "\"floating_point\": 78.0, \"unit\": \"mm\"",
            format!("line {} column", line("\"floating_point\": 78.0")),
        ),
        (
            "\"role\": \"assembly\"",
            "\"role\": 3",
            format!("line {} column", line("\"role\": \"assembly\"")),
        ),
        (
            "\"integer\": 17",
            "\"integer\": 17.5",
            "cylindrical_gear 11, number_of_teeth = 17.5: not a whole number".to_owned(),
        ),
    ] {
        let text = good.replacen(from, to, 1);
        assert_ne!(text, good, "{from}");
        let error = match read(&text) {
            Ok(file) => why(&file, 10),
            Err(error) => error.to_string(),
        };
        assert!(error.contains(&told), "{told}: {error}");
    }
    let error = read("tooth;fp\n1;2\n").unwrap_err().to_string();
    assert!(error.contains("neither XML nor JSON"), "{error}");
}

#[test]
fn a_gear_does_not_mate_with_itself() {
    let same = "<ref id=\"21\" role=\"gear_2\"/>";
    let text = fixture("gearbox.rexs").replacen("<ref id=\"22\" role=\"gear_2\"/>", same, 1);
    let file = read(&text).unwrap();
    assert_eq!(why(&file, 20), "both its gears are cylindrical_gear 21");
    pair(&file, 10);
}

#[test]
fn a_flaw_of_one_stage_leaves_the_others() {
    let good = fixture("gearbox.rexs");
    let whole = read(&good).unwrap();
    for (from, to, stage, told) in [
        (
            "<ref id=\"31\" role=\"gear_1\"/>",
            "<ref id=\"931\" role=\"gear_1\"/>",
            30,
            "relation 7: names component 931, which the file does not have",
        ),
        (
            "unit=\"deg\">15.0<",
            "unit=\"rad\">0.26<",
            30,
            "cylindrical_gear 31, helix_angle_reference_diameter = 0.26: in the unit rad",
        ),
        (
            "din_3964_1980\" unit=\"none\">7<",
            "din_3964_1980\" unit=\"none\">js7<",
            10,
            "din_3964_1980 = js7: not a number",
        ),
        (
            "<ref id=\"14\" role=\"right\"/>",
            "",
            10,
            "relation 12: has no component as right",
        ),
    ] {
        let text = good.replacen(from, to, 1);
        assert_ne!(text, good, "{from}");
        let file = read(&text).unwrap();
        assert!(why(&file, stage).contains(told), "{}", why(&file, stage));
        for other in [10, 20].into_iter().filter(|other| *other != stage) {
            assert_eq!(pair(&file, other), pair(&whole, other));
        }
    }
}
