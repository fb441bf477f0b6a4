//! `[wheel.profile]`: keys, numbers, and profiles that no flank has. The wheel's flank runs from 56.6 to 66 mm.

use super::*;

#[test]
fn keys_and_numbers_all_at_once() {
    expect(
        &wheel(
            "profile.slope_mu = 3\nprofile.crowning_um = \"3\"\nprofile.range_mm = [64, 58]\n\
             profile.tip_relief = { um = -4, from_diameter_mm = 64, shape = \"parabola\" }\nprofile.root_relief = { um = 3 }",
        ),
        &[
            problem(
                "wheel.profile.slope_mu",
                "3",
                &["unknown key"],
                "mean `slope_um`",
            ),
            problem(
                "wheel.profile.crowning_um",
                "3",
                &["a string", "µm"],
                "crowning",
            ),
            problem(
                "wheel.profile.tip_relief.um",
                "-4",
                &["out of range", "0 …"],
                "taken off",
            ),
            problem(
                "wheel.profile.tip_relief.shape",
                "parabola",
                &["unknown", "linear"],
                "mean \"parabolic\"",
            ),
            problem(
                "wheel.profile.root_relief.from_diameter_mm",
                "",
                &["missing"],
                "add",
            ),
            problem(
                "wheel.profile.range_mm",
                "[64, 58]",
                &["the lesser first"],
                "[start, end]",
            ),
        ],
    );
}

#[test]
fn a_key_of_both_flanks_and_of_one() {
    expect(
        &wheel(
            "profile.slope_um = 3\nprofile.crowning_um = 1\nprofile.right = { slope_um = 4 }\nprofile.left = { slop_um = 4 }",
        ),
        &[
            problem(
                "wheel.profile.right.slope_um",
                "4",
                &["together with wheel.profile.slope_um"],
                "[wheel.profile] is of both flanks",
            ),
            problem(
                "wheel.profile.left.slop_um",
                "4",
                &["unknown key"],
                "mean `slope_um`",
            ),
        ],
    );
}

#[test]
fn lists_of_a_trace() {
    let of = |trace: &str| wheel(&format!("profile.trace = {trace}"));
    expect(
        &of("{ roll_length_mm = [8, 12, 11], deviation_um = [0, 1, 2] }"),
        &[problem(
            "wheel.profile.trace.roll_length_mm",
            "[8, 12, 11]",
            &["value 3", "descends"],
            "root to tip",
        )],
    );
    expect(
        &of("{ diameter_mm = [50, 58], deviation_um = [0, 1] }"),
        &[problem(
            "wheel.profile.trace.diameter_mm",
            "[50, 58]",
            &["value 1", "56.3816"],
            "below the base circle",
        )],
    );
    expect(
        &of("{ roll_length_mm = [8, 12], deviation_um = [0] }"),
        &[problem(
            "wheel.profile.trace.deviation_um",
            "[0]",
            &["length 1, expected at least 2"],
            "deviation at each",
        )],
    );
    expect(
        &of("{ roll_length_mm = [8, 12, 13], deviation_um = [0, 1] }"),
        &[problem(
            "wheel.profile.trace.deviation_um",
            "[0, 1]",
            &["2 values beside 3"],
            "at each point",
        )],
    );
    expect(
        &of("[{ tooth = 21, roll_length_mm = [8, 12], deviation_um = [0, 1] }]"),
        &[problem(
            "wheel.profile.trace[1].tooth",
            "21",
            &["1 … 20"],
            "number of the tooth",
        )],
    );
    expect(
        &of("[{ roll_length_mm = [8, 12], deviation_um = [0, 1] }, 3]"),
        &[problem(
            "wheel.profile.trace[2]",
            "3",
            &["a number"],
            "measured profiles",
        )],
    );
}

/// What only the gear's geometry refuses, of both flanks once.
#[test]
fn profiles_that_no_flank_has() {
    expect(
        &wheel(
            "profile.tip_relief = { um = 12, from_diameter_mm = 67 }\n\
             profile.right = { range_mm = [50, 65] }\nprofile.left = { range_mm = [58, 70], slope_um = 5 }",
        ),
        &[
            problem(
                "wheel.profile.right.range_mm",
                "[50, 65]",
                &["root form diameter"],
                "on the flank",
            ),
            problem(
                "wheel.profile.left.range_mm",
                "[58, 70]",
                &["tip diameter"],
                "on the flank",
            ),
        ],
    );
    expect(
        &wheel("profile.tip_relief = { um = 12, from_diameter_mm = 67 }\nprofile.slope_um = 60000"),
        &[
            problem("wheel.profile.slope_um", "60000", &["flank"], "unit (µm)"),
            problem(
                "wheel.profile.tip_relief",
                "12",
                &["between the root form circle and the tip circle"],
                "diameter of the relief",
            ),
        ],
    );
}
