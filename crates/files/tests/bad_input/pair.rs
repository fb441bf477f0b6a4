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
            "list",
        )],
    );
    expect(
        &put(GOOD, "75.2", "[75.2, 75, 75.0]"),
        &[problem(
            "assembly.center_distance_mm",
            "75.2",
            &["75.0 stands there twice"],
            "once",
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
                &["length 1, needed is 30"],
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
