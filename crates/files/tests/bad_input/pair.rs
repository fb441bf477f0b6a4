use super::*;

#[test]
fn unequal_module_and_pressure_angle() {
    expect(
        &GOOD.replacen(
            "3.0\npressure_angle_deg = 20.0\n\n[assembly]",
            "3.1\npressure_angle_deg = 19.0\n\n[assembly]",
            1,
        ),
        &[
            problem(
                "pinion.module_mm",
                "3.1",
                &["wheel.module_mm = 3.0", "must be equal on both gears"],
                "correct one",
            ),
            problem(
                "pinion.pressure_angle_deg",
                "19.0",
                &["wheel.pressure_angle_deg = 20.0"],
                "correct one",
            ),
        ],
    );
}

/// r_b1 + r_b2 = (20 + 30) 3/2 cos 20° = 70.476947 mm.
#[test]
fn base_circles_overlap() {
    expect(
        &put(GOOD, "75.2", "[75.2, 70.4769, 3]"),
        &[
            problem(
                "assembly.center_distance_mm",
                "70.4769",
                &["must exceed 70.476947 mm"],
                "m (z_1 + z_2)/2",
            ),
            problem(
                "assembly.center_distance_mm",
                "3",
                &["must exceed 70.476947 mm"],
                "m (z_1 + z_2)/2",
            ),
        ],
    );
}

#[test]
fn bearing_clearance_down_to_the_base_circles() {
    expect(
        &put(GOOD, "75.2", "[75.2, 75.4]\nbearing_clearance_mm = 2.4"),
        &[problem(
            "assembly.bearing_clearance_mm",
            "2.4",
            &["at 75.2 mm approach to 70.400000 mm", "below 4.723053 mm"],
            "unit",
        )],
    );
    expect(
        &put(
            GOOD,
            "75.2",
            "75.2\nbearing_clearance_mm = { wheel = 0.005 }",
        ),
        &[problem(
            "assembly.bearing_clearance_mm.pinion",
            "",
            &["missing"],
            "add `pinion`",
        )],
    );
}

#[test]
fn list_of_centre_distances() {
    expect(
        &put(GOOD, "75.2", "[]"),
        &[problem(
            "assembly.center_distance_mm",
            "[]",
            &["empty", "at least one"],
            "centre distance",
        )],
    );
    expect(
        &put(GOOD, "75.2", "[75.2, 75, 75.0]"),
        &[problem(
            "assembly.center_distance_mm",
            "75.2",
            &["75.0 is listed twice"],
            "once",
        )],
    );
}

#[test]
fn band_of_centre_distances() {
    const KEY: &str = "assembly.center_distance_mm";
    let band = |keys: &str| put(GOOD, "75.2", &format!("{{ {keys} }}"));
    expect(
        &band("nominal_mm = -75.2, tolerance_um = -5, play_um = 1"),
        &[
            problem(
                "assembly.center_distance_mm.play_um",
                "1",
                &["`nominal_mm`, `tolerance_um`, `upper_um` or `lower_um`"],
                "remove",
            ),
            problem(
                "assembly.center_distance_mm.nominal_mm",
                "-75.2",
                &["above 0"],
                "nominal centre distance",
            ),
            problem(
                "assembly.center_distance_mm.tolerance_um",
                "-5",
                &["µm, 0 … 1e7"],
                "symmetric tolerance",
            ),
        ],
    );
    expect(
        &band("upper_um = nan, lower_um = 1e8"),
        &[
            problem(
                "assembly.center_distance_mm.nominal_mm",
                "",
                &["missing"],
                "[assembly.center_distance_mm]",
            ),
            problem(
                "assembly.center_distance_mm.lower_um",
                "100000000.0",
                &["out of range", "−1e7 … 1e7"],
                "lower deviation",
            ),
            problem(
                "assembly.center_distance_mm.upper_um",
                "NaN",
                &["not finite"],
                "deviation",
            ),
        ],
    );
    for (keys, key, words, help) in [
        (
            "upper_um = 10, lower_um = 20",
            "lower_um",
            "greater than upper_um = 10.0",
            "swap the two",
        ),
        (
            "upper_um = 10",
            "upper_um",
            "given without lower_um",
            "add `lower_um`",
        ),
        (
            "tolerance_um = 10, lower_um = -5",
            "tolerance_um",
            "given together with lower_um",
            "remove one",
        ),
        (
            "",
            "tolerance_um",
            "one of `tolerance_um` or `upper_um` and `lower_um`",
            "add `tolerance_um`",
        ),
    ] {
        let separator = if keys.is_empty() { "" } else { ", " };
        expect(
            &band(&format!("nominal_mm = 75.2{separator}{keys}")),
            &[problem(&format!("{KEY}.{key}"), "", &[words], help)],
        );
    }
    // r_b1 + r_b2 = 70.476947 mm: one of the two ends lies below.
    expect(
        &band("nominal_mm = 75.2, tolerance_um = 5000"),
        &[problem(
            KEY,
            "{ nominal_mm = 75.2, tolerance_um = 5000 }",
            &["at centre distance 70.2 mm", "must exceed 70.476947 mm"],
            "m (z_1 + z_2)/2",
        )],
    );
    // A misspelt key is the one told.
    expect(
        &band("nominal_mm = 75.2, tolerence_um = 5"),
        &[problem(
            "assembly.center_distance_mm.tolerence_um",
            "5",
            &["unknown key"],
            "mean `tolerance_um`",
        )],
    );
}

#[test]
fn both_gears_are_reported_together() {
    expect(
        &(wheel("profile_shift = 1.5")
            .replace(
                "teeth = 30",
                "teeth = 30\nrack.root_radius = 0.48\nthickness.per_tooth_um = [1]",
            )
            .replace("75.2", "60")
            + "[sweep]\nmating = [[21, 1], [1, 31]]"),
        &[
            problem("wheel.profile_shift", "1.5", &["pointed"], "reduce"),
            problem(
                "pinion.thickness.per_tooth_um",
                "[1]",
                &["length 1, expected 30"],
                "",
            ),
            problem("pinion.rack.root_radius", "0.48", &["too large"], "reduce"),
            problem(
                "sweep.mating",
                "[21, 1]",
                &["wheel tooth is 21", "1 … 20"],
                "from 1",
            ),
            problem(
                "sweep.mating",
                "[1, 31]",
                &["pinion tooth is 31", "1 … 30"],
                "from 1",
            ),
            problem("assembly.center_distance_mm", "60", &["base circles"], ""),
        ],
    );
}
