use super::*;

#[test]
fn wrong_type() {
    expect(
        r#"
title = 3
sweep = 1
[wheel]
teeth = "20"
module_mm = [3.0]
pressure_angle_deg = true
profile_shift = {}
reference_face = 1
tip_diameter_mm = "66"
rack = 1
thickness = 2
runout = 6.6
pitch = []
[pinion]
teeth = 20.5
module_mm = 1979-05-27
pressure_angle_deg = "20"
thickness = { span = 3.0, per_tooth_um = 1.0 }
runout = { total_um = "6", high_tooth = "1" }
pitch = { kind = 1, axis = 2, sense = 3, right_um = ["a"], left_um = {} }
[assembly]
center_distance_mm = "75"
locked = true
bearing_clearance_mm = "0"
[accuracy]
chord_um = "fine"
[compare]
tolerance_um = "0.1"
allow_off_line_contact = "no"
"#,
        &[
            problem(
                "title",
                "3",
                &["a number, allowed is a string"],
                "in quotes",
            ),
            problem(
                "wheel.teeth",
                "\"20\"",
                &["a string", "3 … 10 000"],
                "teeth",
            ),
            problem(
                "wheel.module_mm",
                "[3.0]",
                &["a list", "0.01 … 1000"],
                "module",
            ),
            problem("wheel.pressure_angle_deg", "true", &["5 … 45"], "degrees"),
            problem(
                "wheel.profile_shift",
                "{ }",
                &["a table", "−100 … 100"],
                "profile shift",
            ),
            problem(
                "wheel.reference_face",
                "1",
                &["\"front\" or \"back\""],
                "one of these",
            ),
            problem(
                "wheel.tip_diameter_mm",
                "\"66\"",
                &["above 0"],
                "tip diameter",
            ),
            problem("wheel.rack", "1", &["`addendum`"], "[wheel.rack]"),
            problem("wheel.thickness", "2", &["`span`"], "[wheel.thickness]"),
            problem("wheel.runout", "6.6", &["`total_um`"], "[wheel.runout]"),
            problem("wheel.pitch", "[]", &["`right_um`"], "[wheel.pitch]"),
            problem(
                "pinion.teeth",
                "20.5",
                &["not whole", "3 … 10 000"],
                "number of teeth",
            ),
            problem(
                "pinion.module_mm",
                "1979-05-27",
                &["a date or time"],
                "module",
            ),
            problem(
                "pinion.pressure_angle_deg",
                "\"20\"",
                &["5 … 45"],
                "degrees",
            ),
            problem(
                "pinion.thickness.span",
                "3.0",
                &["`min_mm`"],
                "[pinion.thickness.span]",
            ),
            problem(
                "pinion.thickness.per_tooth_um",
                "1.0",
                &["a list of numbers"],
                "tooth",
            ),
            problem("pinion.runout.total_um", "\"6\"", &["0 or more"], "F_r"),
            problem("pinion.runout.high_tooth", "\"1\"", &["1 or more"], "tooth"),
            problem(
                "pinion.pitch.axis",
                "2",
                &["\"own\" or \"datum\""],
                "one of these",
            ),
            problem(
                "pinion.pitch.sense",
                "3",
                &["\"numbers\" or \"material\""],
                "one of these",
            ),
            problem(
                "pinion.pitch.right_um",
                "\"a\"",
                &["value 1", "−1e7 … 1e7"],
                "tooth",
            ),
            problem(
                "pinion.pitch.left_um",
                "{ }",
                &["a list of numbers"],
                "tooth",
            ),
            problem(
                "pinion.pitch.kind",
                "1",
                &["\"cumulative\" or \"single\""],
                "one of these",
            ),
            problem(
                "assembly.center_distance_mm",
                "\"75\"",
                &["js5 … js10"],
                "numbers",
            ),
            problem(
                "assembly.locked",
                "true",
                &["\"wheel\" or \"pinion\""],
                "one of these",
            ),
            problem(
                "assembly.bearing_clearance_mm",
                "\"0\"",
                &["0 or more", "wheel = …"],
                "play",
            ),
            problem("sweep", "1", &["`mating`"], "[sweep]"),
            problem("accuracy.chord_um", "\"fine\"", &["1e-5 … 100"], "0.01"),
            problem("compare.tolerance_um", "\"0.1\"", &["0 or more"], "0.1"),
            problem(
                "compare.allow_off_line_contact",
                "\"no\"",
                &["true or false"],
                "quotes",
            ),
        ],
    );
}

#[test]
fn unknown_word() {
    expect(
        &wheel("reference_face = \"frnt\"").replace("[assembly]", "[assembly]\nlocked = \"none\""),
        &[
            problem(
                "wheel.reference_face",
                "\"frnt\"",
                &["\"back\""],
                "mean \"front\"",
            ),
            problem(
                "assembly.locked",
                "\"none\"",
                &["\"pinion\""],
                "one of these",
            ),
        ],
    );
}

#[test]
fn null() {
    expect_as(
        "pair.json",
        r#"{ "title": null,
            "wheel": { "teeth": 20, "module_mm": 3, "pressure_angle_deg": 20 },
            "pinion": { "teeth": 30, "module_mm": 3, "pressure_angle_deg": 20 },
            "assembly": { "center_distance_mm": [75.2, null] } }"#,
        &[
            problem("title", "null", &["allowed is a string"], "in quotes"),
            problem(
                "assembly.center_distance_mm",
                "null",
                &["value 2"],
                "centre distance",
            ),
        ],
    );
}
