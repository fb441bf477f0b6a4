use super::*;

#[test]
fn two_statements() {
    expect(
        &wheel("thickness = { span = { teeth = 3, mm = 23 }, allowance_um = -20 }"),
        &[problem(
            "wheel.thickness.span",
            "{ mm = 23, teeth = 3 }",
            &["together with allowance_um"],
            "remove one or the other",
        )],
    );
}

#[test]
fn min_and_max() {
    for (keys, key, value, reason, help) in [
        (
            "span = { teeth = 3, min_mm = 22.98 }",
            "span.min_mm",
            "22.98",
            "without max_mm",
            "add `max_mm`",
        ),
        (
            "span = { teeth = 3, max_mm = 22.98 }",
            "span.max_mm",
            "22.98",
            "without min_mm",
            "add `min_mm`",
        ),
        (
            "span = { teeth = 3, mm = 22.9, max_mm = 22.98 }",
            "span.mm",
            "22.9",
            "together with max_mm",
            "remove",
        ),
        (
            "allowance_um = { min = -20, max = -30 }",
            "allowance_um.min",
            "-20",
            "greater than max = -30.0",
            "swap",
        ),
        (
            "allowance_um = { max = -30 }",
            "allowance_um.max",
            "-30",
            "without min",
            "add `min`",
        ),
        (
            "base_thickness_mm = { min = 5.3, max = 5.2 }",
            "base_thickness_mm.min",
            "5.3",
            "up to max",
            "swap",
        ),
        (
            "over_pins = { pin_mm = 5.25, min_mm = 67.3, max_mm = 67.2 }",
            "over_pins.min_mm",
            "67.3",
            "max_mm = 67.2",
            "swap",
        ),
    ] {
        let key = format!("wheel.thickness.{key}");
        expect(
            &wheel(&format!("thickness.{keys}")),
            &[problem(&key, value, &[reason], help)],
        );
    }
}

/// Over 5 teeth the contact is at √(r_b² + (W/2)²) = 69.5334/2 mm, beyond the tip at 66/2.
#[test]
fn span_off_the_involute() {
    expect(
        &wheel("thickness.span = { teeth = 5, mm = 40.6941067325 }"),
        &[problem(
            "wheel.thickness.span.teeth",
            "5",
            &["diameter 69.5334 mm", "… 66.0000 mm"],
            "over 2 … 4 teeth",
        )],
    );
}

#[test]
fn span_that_means_no_tooth_or_too_thick_a_tooth() {
    expect(
        &wheel("thickness.span = { teeth = 4, mm = 22.98 }"),
        &[problem(
            "wheel.thickness.span",
            "mm = 22.98",
            &["base tooth thickness -3.5892 mm", "above 0"],
            "nominal over 4 teeth is 31.8377 mm",
        )],
    );
    expect(
        &wheel("thickness.span = { teeth = 2, mm = 22.98 }"),
        &[problem(
            "wheel.thickness.span",
            "mm = 22.98",
            &[],
            "nominal over 2 teeth is 14.1249 mm",
        )],
    );
    expect(
        &wheel("thickness.span = { teeth = 21, mm = 22.98 }"),
        &[problem(
            "wheel.thickness.span.teeth",
            "21",
            &["1 … 20"],
            "count",
        )],
    );
}

/// z 60: a 3 mm pin touches at 174.5483, below the form diameter 174.7793. z 20: a 5 mm pin
/// touches at 59.7082, above a tip cut down to 59.5.
#[test]
fn pin_off_the_involute() {
    let teeth_60 = wheel("thickness.over_pins = { pin_mm = 3, mm = 178.31304858215103 }")
        .replace("teeth = 20", "teeth = 60")
        .replace("75.2", "135.2");
    expect(
        &teeth_60,
        &[problem(
            "wheel.thickness.over_pins.pin_mm",
            "3",
            &["touches at diameter 174.5483", "off the involute (174.7793"],
            "over pins of about",
        )],
    );
    expect(
        &wheel(
            "tip_diameter_mm = 59.5\nthickness.over_pins = { pin_mm = 5, mm = 66.53522592287428 }",
        ),
        &[problem(
            "wheel.thickness.over_pins.pin_mm",
            "5",
            &["touches at diameter 59.7082", "59.5000 mm"],
            "over pins of about",
        )],
    );
}

/// A 4.5 mm pin touches at 58.7800 and reaches 64.7073, the tip is 66.
#[test]
fn pin_below_the_tip() {
    expect(
        &wheel("thickness.over_pins = { pin_mm = 4.5, mm = 64.70726526176731 }"),
        &[problem(
            "wheel.thickness.over_pins.pin_mm",
            "4.5",
            &["reaches diameter 64.7073 mm", "tip diameter 66.0000 mm"],
            "over pins of about",
        )],
    );
}

/// A 5 mm pin reaches down to 56.5352; a dedendum of 0.3 leaves a root of 60 − 2 · 0.9 = 58.2.
#[test]
fn pin_in_the_root() {
    expect(
        &wheel(
            "rack = { dedendum = 0.3, root_radius = 0 }\n\
             thickness.over_pins = { pin_mm = 5, mm = 66.53522592287428 }",
        ),
        &[problem(
            "wheel.thickness.over_pins.pin_mm",
            "5",
            &["diameter 56.5352 mm", "root circle 58.2000 mm"],
            "over pins of about",
        )],
    );
}

#[test]
fn pins_inside_the_base_circle() {
    expect(
        &wheel("thickness.over_pins = { pin_mm = 5.25, min_mm = 50, max_mm = 67.39 }"),
        &[problem(
            "wheel.thickness.over_pins.min_mm",
            "50",
            &["above the base diameter plus the pin", "56.3816"],
            "nominal over pins of 5.25 mm is 67.3939 mm",
        )],
    );
}
