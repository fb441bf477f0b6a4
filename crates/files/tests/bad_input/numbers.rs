use super::*;

#[test]
fn not_finite() {
    expect(
        &wheel("profile_shift = nan\ntip_diameter_mm = inf")
            .replace("teeth = 30", "teeth = nan\nthickness.allowance_um = -inf")
            .replace("75.2", "[75.2, nan]"),
        &[
            problem(
                "wheel.profile_shift",
                "NaN",
                &["not finite"],
                "profile shift",
            ),
            problem(
                "wheel.tip_diameter_mm",
                "inf",
                &["not finite", "above 0"],
                "tip",
            ),
            problem(
                "pinion.teeth",
                "NaN",
                &["not finite", "3 … 10 000"],
                "number of teeth",
            ),
            problem(
                "pinion.thickness.allowance_um",
                "-inf",
                &["not finite"],
                "allowance",
            ),
            problem(
                "assembly.center_distance_mm",
                "NaN",
                &["value 2", "not finite"],
                "centre distance",
            ),
        ],
    );
}

#[test]
fn zero_or_negative_where_it_makes_no_sense() {
    expect(
        &(wheel("tip_diameter_mm = 0\nrack = { addendum = 0, dedendum = -1, root_radius = -0.1 }\nrunout.total_um = -1")
            .replace("[pinion]", "[pinion]\nthickness.over_pins = { pin_mm = 0.0, mm = -3 }")
            .replace("75.2", "-75.2\nbearing_clearance_mm = { wheel = -1, pinion = 0 }")
            + "[accuracy]\nchord_um = 0\n[compare]\ntolerance_um = -0.1"),
        &[
            problem("wheel.tip_diameter_mm", "0", &["above 0"], "tip diameter"),
            problem("wheel.rack.addendum", "0", &["above 0 and up to 10"], "1 by default"),
            problem("wheel.rack.dedendum", "-1", &["above 0 and up to 10"], "1.25"),
            problem("wheel.rack.root_radius", "-0.1", &["0 or more"], "0.38"),
            problem("wheel.runout.total_um", "-1", &["0 or more"], "F_r"),
            problem("pinion.thickness.over_pins.pin_mm", "0.0", &["above 0"], "mm"),
            problem("pinion.thickness.over_pins.mm", "-3", &["above 0"], "mm"),
            problem("assembly.center_distance_mm", "-75.2", &["above 0"], "centre distance"),
            problem("assembly.bearing_clearance_mm.wheel", "-1", &["0 or more"], "wheel"),
            problem("accuracy.chord_um", "0", &["1e-5 … 100"], "0.01"),
            problem("compare.tolerance_um", "-0.1", &["0 or more"], "0.1"),
        ],
    );
}

#[test]
fn teeth_module_and_pressure_angle_out_of_range() {
    for (teeth, module, angle) in [("2", "0.0099", "4.9"), ("10001", "1000.1", "45.1")] {
        let text = put(GOOD, "teeth = 20", &format!("teeth = {teeth}")).replacen(
            "module_mm = 3.0\npressure_angle_deg = 20.0",
            &format!("module_mm = {module}\npressure_angle_deg = {angle}"),
            1,
        );
        expect(
            &text,
            &[
                problem("wheel.teeth", "", &["3 … 10 000"], "number of teeth"),
                problem("wheel.module_mm", "", &["0.01 … 1000"], "mm"),
                problem("wheel.pressure_angle_deg", "", &["5 … 45"], "degrees"),
            ],
        );
    }
}

#[test]
fn chord_and_tolerance_out_of_range() {
    expect(
        &and("[accuracy]\nchord_um = 100.1\n[compare]\ntolerance_um = inf"),
        &[
            problem("accuracy.chord_um", "100.1", &["1e-5 … 100"], "0.01"),
            problem("compare.tolerance_um", "inf", &["not finite"], "0.1"),
        ],
    );
}
