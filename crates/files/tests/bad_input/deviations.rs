use super::*;

#[test]
fn per_tooth_lists_of_the_wrong_length() {
    let text = wheel(&format!(
        "thickness.per_tooth_um = {}\npitch = {{ kind = \"single\", right_um = {}, left_um = {} }}",
        list(19, "1"),
        list(20, "0"),
        list(21, "0.0"),
    ));
    expect(
        &text,
        &[
            problem(
                "wheel.thickness.per_tooth_um",
                "",
                &["length 19, expected 20"],
                "ascending",
            ),
            problem(
                "wheel.pitch.left_um",
                "",
                &["length 21, expected 20"],
                "ascending",
            ),
        ],
    );
}

#[test]
fn pitch_of_one_flank_only() {
    for absent in ["left_um = []\n", ""] {
        expect(
            &(and("[wheel.pitch]\nkind = \"single\"\n") + absent + "right_um = " + &list(20, "0")),
            &[problem(
                "wheel.pitch.left_um",
                "",
                &["no values", "has 20"],
                "give left_um too",
            )],
        );
    }
}

#[test]
fn pitch_of_no_stated_kind() {
    expect(
        &and(&format!(
            "[wheel.pitch]\nright_um = {0}\nleft_um = {0}",
            list(20, "0")
        )),
        &[problem(
            "wheel.pitch.kind",
            "",
            &["missing", "\"single\""],
            "add `kind`",
        )],
    );
}

#[test]
fn of_many_bad_values_the_first_dozen_is_reported() {
    let key = "wheel.thickness.per_tooth_um";
    let mut expected: Vec<Expected> = (0..12)
        .map(|_| problem(key, "NaN", &["not finite"], "tooth"))
        .collect();
    expected.push(problem(key, "", &["8 more"], "first"));
    expect(
        &and(&format!(
            "[wheel.thickness]\nper_tooth_um = {}",
            list(20, "nan")
        )),
        &expected,
    );
}

/// Half a pitch is π 3/2 mm = 4712.4 µm. One flank of 20 at 5000: 4750 about the mean.
#[test]
fn pitch_deviation_of_half_a_pitch() {
    let values = list(20, "0").replacen("0", "5000", 1);
    expect(
        &and(&format!(
            "[wheel.pitch]\nkind = \"cumulative\"\nright_um = {values}\nleft_um = {}",
            list(20, "0")
        )),
        &[problem(
            "wheel.pitch.right_um",
            "[5000",
            &[
                "the right flank of tooth 1 stands 4750.0 µm",
                "less than half a pitch, 4712.4 µm",
            ],
            "single or cumulative",
        )],
    );
}

/// The tooth depth is (1.0 + 1.25) 3 mm = 6750 µm.
#[test]
fn runout_of_the_tooth_depth() {
    expect(
        &wheel("runout = { total_um = 6750, high_tooth = 1 }"),
        &[problem(
            "wheel.runout.total_um",
            "6750",
            &["tooth depth, 6750.0 µm"],
            "unit",
        )],
    );
}

#[test]
fn high_tooth() {
    for (value, reason, help) in [
        ("0.9", "1 or more", "stands farthest out"),
        ("21", "1 up to, but not including, 21", "highest reading"),
    ] {
        expect(
            &wheel(&format!(
                "runout = {{ total_um = 6.6, high_tooth = {value} }}"
            )),
            &[problem("wheel.runout.high_tooth", value, &[reason], help)],
        );
    }
    expect(
        &wheel("runout = { high_tooth = 3 }"),
        &[problem(
            "wheel.runout.total_um",
            "",
            &["missing"],
            "add `total_um`",
        )],
    );
}

#[test]
fn deviations_that_leave_no_tip_or_no_space() {
    let thin = list(20, "0").replacen("0", "-2500", 1);
    expect(
        &and(&format!("[wheel.thickness]\nper_tooth_um = {thin}")),
        &[problem(
            "wheel.thickness.per_tooth_um",
            "[-2500",
            &["tip thickness", "above 0"],
            "unit",
        )],
    );
    let apart = list(20, "0").replacen("0", "4200", 1);
    expect(
        &and(&format!(
            "[wheel.pitch]\nkind = \"cumulative\"\nright_um = {apart}\nleft_um = {}",
            list(20, "0")
        )),
        &[problem(
            "wheel.pitch",
            "kind = \"cumulative\"",
            &["above 0"],
            "unit",
        )],
    );
}

#[test]
fn datum_axis_and_runout() {
    let pitch = format!(
        "pitch = {{ kind = \"single\", axis = \"datum\", right_um = {0}, left_um = {0} }}\nrunout = {{ total_um = 5, high_tooth = 1 }}",
        list(20, "0")
    );
    expect(
        &wheel(&pitch),
        &[problem(
            "wheel.pitch.axis",
            "\"datum\"",
            &["count it twice"],
            "remove the runout",
        )],
    );
}
