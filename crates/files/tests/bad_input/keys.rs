use super::*;

#[test]
fn unknown_with_the_nearest_known_one() {
    expect(
        &(wheel("modul_mm = 3.0\nrunuot = { total_um = 3.0, high_toth = 1 }")
            + "center_distnace_mm = 75.0\n[aseembly]\nx = 1"),
        &[
            problem(
                "aseembly",
                "{ x = 1 }",
                &["unknown key", "`assembly`"],
                "mean `assembly`",
            ),
            problem(
                "wheel.modul_mm",
                "3.0",
                &["unknown key"],
                "mean `module_mm`",
            ),
            problem("wheel.runuot", "", &["unknown key"], "mean `runout`"),
            problem(
                "assembly.center_distnace_mm",
                "75.0",
                &[
                    "unknown key",
                    "`center_distance_mm`, `locked`, `bearing_clearance_mm`, `face_offset_mm`, `temperature_c`, `housing_expansion_per_k` or `centre_distance_mm`",
                ],
                "mean `center_distance_mm`",
            ),
        ],
    );
}

/// `foo` is near nothing: it got "the nearest known is `hand`". What a formula calls a key is that key.
#[test]
fn a_key_that_is_near_none_gets_no_suggestion_and_a_symbol_gets_its_key() {
    let unknown = |key, help| problem(key, "", &["unknown key"], help);
    expect(
        &put(
            &wheel("foo = 1\nx = 0.2\nalpha = 20"),
            "teeth = 20",
            "z = 20",
        ),
        &[
            unknown("wheel.alpha", "mean `pressure_angle_deg`"),
            unknown("wheel.foo", "remove it"),
            unknown("wheel.x", "mean `profile_shift`"),
            unknown("wheel.z", "mean `teeth`"),
        ],
    );
}

#[test]
fn a_mistyped_key_is_not_missing_too() {
    expect(
        &put(GOOD, "teeth = 20", "theet = 20").replace("[assembly]", "[asembly]"),
        &[
            problem("asembly", "", &["unknown key"], "mean `assembly`"),
            problem("wheel.theet", "20", &["unknown key"], "mean `teeth`"),
        ],
    );
}

/// What is mistyped is not taken to be absent: no default, and no problem that follows from it.
#[test]
fn a_mistyped_key_has_no_consequences() {
    let mean = |key: &str| format!("mean `{key}`");
    for (text, key, meant) in [
        (
            wheel("profile_shift = 1.5\ntip_diametre_mm = 72"),
            "wheel.tip_diametre_mm",
            "tip_diameter_mm",
        ),
        (
            wheel("profile_shift = 2.4\nthicknes.allowance_um = -2500"),
            "wheel.thicknes",
            "thickness",
        ),
        (
            wheel("thickness.spann = { teeth = 3, mm = 22 }"),
            "wheel.thickness.spann",
            "span",
        ),
        (
            wheel("runout = { total_um = 5, high_toth = 3 }"),
            "wheel.runout.high_toth",
            "high_tooth",
        ),
        (
            wheel(&format!(
                "pitch = {{ knd = \"single\", right_um = {0}, left_um = {0} }}",
                list(20, "0")
            )),
            "wheel.pitch.knd",
            "kind",
        ),
        (
            put(GOOD, "center_distance_mm = 75.2\n", "") + "[mesured]\nfile = \"rows.csv\"",
            "mesured",
            "measured",
        ),
        (and("[sweeep]\nmating = [[1, 1]]"), "sweeep", "sweep"),
        (
            and("[sweep]\nmatting = [[1, 1]]"),
            "sweep.matting",
            "mating",
        ),
        (
            and("[sweep]\nmatting = [[1, 1]]\nfraction = [0.5]"),
            "sweep.matting",
            "mating",
        ),
        (
            put(GOOD, "75.2", "75.2\nlockd = \"pinion\""),
            "assembly.lockd",
            "locked",
        ),
    ] {
        expect(&text, &[problem(key, "", &["unknown key"], &mean(meant))]);
    }
}

#[test]
fn phases_stand_alone() {
    expect(
        &and("[sweep]\nmating = [[1, 1]]\nphases = \"all\""),
        &[problem(
            "sweep.mating",
            "[[1, 1]]",
            &["given together with phases"],
            "remove one or the other",
        )],
    );
    expect(
        &and("[sweep]\nphases = \"some\""),
        &[problem("sweep.phases", "\"some\"", &["\"all\""], "")],
    );
}

#[test]
fn missing() {
    expect(
        "",
        &[
            problem("wheel", "", &["missing"], "add `wheel`"),
            problem("pinion", "", &["missing"], "add `pinion`"),
            problem(
                "assembly.center_distance_mm",
                "",
                &["missing", "mm"],
                "[assembly]",
            ),
        ],
    );
    expect(
        "[wheel]\n[pinion]\n[assembly]\ncenter_distance_mm = 1",
        &[
            problem("wheel.teeth", "", &["missing", "3 … 10 000"], "[wheel]"),
            problem(
                "wheel.module_mm",
                "",
                &["missing", "0.01 … 1000"],
                "[wheel]",
            ),
            problem(
                "wheel.pressure_angle_deg",
                "",
                &["missing", "5 … 45"],
                "[wheel]",
            ),
            problem("pinion.teeth", "", &["missing"], "[pinion]"),
            problem("pinion.module_mm", "", &["missing"], "[pinion]"),
            problem("pinion.pressure_angle_deg", "", &["missing"], "[pinion]"),
        ],
    );
    expect(
        &and("[measured]"),
        &[problem("measured.file", "", &["missing"], "[measured]")],
    );
    expect(
        &and("[sweep]"),
        &[problem(
            "sweep.mating",
            "",
            &["missing", "`revolutions`"],
            "[sweep]",
        )],
    );
    expect(
        &wheel("thickness = { span = { mm = 23.0 }, per_tooth_um = [] }"),
        &[problem(
            "wheel.thickness.span.teeth",
            "",
            &["missing"],
            "wheel.thickness.span",
        )],
    );
    expect(
        &wheel("thickness.over_pins = { pin_mm = 5.25 }"),
        &[problem(
            "wheel.thickness.over_pins.mm",
            "",
            &["missing", "one of `mm`, `min_mm` and `max_mm` or `file`"],
            "add `mm`",
        )],
    );
}
