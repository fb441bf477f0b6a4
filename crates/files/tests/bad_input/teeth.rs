use super::*;

/// inv α = π/(2z) + 2 x tan α/z + inv 20° at the point: x 1.5 gives 74.217569 mm, the tip is at 75.
#[test]
fn pointed() {
    expect(
        &wheel("profile_shift = 1.5"),
        &[problem(
            "wheel.profile_shift",
            "1.5",
            &[
                "pointed at diameter 74.217569 mm",
                "tip diameter 75.000000 mm",
            ],
            "tip_diameter_mm below 74.218",
        )],
    );
    expect(
        &wheel("tip_diameter_mm = 69.3"),
        &[problem(
            "wheel.tip_diameter_mm",
            "69.3",
            &["pointed at diameter 69.230024 mm"],
            "below 69.230",
        )],
    );
    expect(
        &wheel("rack.addendum = 1.6"),
        &[problem(
            "wheel.rack.addendum",
            "1.6",
            &["pointed at diameter 69.230024 mm"],
            "reduce it",
        )],
    );
    // Nominal teeth would do: the thickness is to blame.
    expect(
        &wheel("thickness.allowance_um = -2600"),
        &[problem(
            "wheel.thickness.allowance_um",
            "-2600",
            &["pointed"],
            "nominal is 0",
        )],
    );
}

#[test]
fn nothing_left_of_the_involute() {
    expect(
        &wheel("tip_diameter_mm = 56"),
        &[problem(
            "wheel.tip_diameter_mm",
            "56",
            &["nothing is left"],
            "above 56.460",
        )],
    );
}

/// c_0 = π/4 − (1.25 − ρ) tan 20° − ρ/cos 20° is zero at ρ = 0.471925….
#[test]
fn tool_tip_round_too_large() {
    expect(
        &wheel("rack.root_radius = 0.48"),
        &[problem(
            "wheel.rack.root_radius",
            "0.48",
            &["up to 0.471911 modules"],
            "0.4719 or less",
        )],
    );
    expect(
        &wheel("rack = { dedendum = 2.5, root_radius = 0.0 }"),
        &[problem(
            "wheel.rack.root_radius",
            "0.0",
            &["no round is small enough"],
            "reduce rack.dedendum",
        )],
    );
    expect(
        &wheel("rack = { dedendum = 0.2, root_radius = 0.3 }"),
        &[problem(
            "wheel.rack.root_radius",
            "0.3",
            &["0 up to the dedendum"],
            "reduce it",
        )],
    );
}

#[test]
fn no_root_left() {
    expect(
        &GOOD
            .replace(
                "teeth = 20",
                "teeth = 3\nrack = { dedendum = 1.6, root_radius = 0.0 }",
            )
            .replace("75.2", "60"),
        &[problem(
            "wheel.rack.dedendum",
            "1.6",
            &["root radius would be -0.3"],
            "reduce the dedendum",
        )],
    );
}

/// Undercut that meets in the middle of the tooth: x = −0.2 at three teeth. Source: the fillets' own points (gear/fillet.rs).
#[test]
fn teeth_cut_off_by_undercut() {
    let few = put(GOOD, "teeth = 20\n", "teeth = 3\nprofile_shift = -0.2\n");
    expect(
        &few,
        &[problem(
            "wheel.profile_shift",
            "-0.2",
            &["undercut from both sides meets"],
            "greater profile shift",
        )],
    );
}
