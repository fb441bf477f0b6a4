use super::*;

/// `rows` as the measured file of the good pair.
fn expect_rows(rows: &str, expected: &[Expected]) {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("rig.csv"), rows).unwrap();
    let path = folder.path().join("pair.toml");
    let text = put(GOOD, "center_distance_mm = 75.2\n", "") + "[measured]\nfile = \"rig.csv\"";
    fs::write(&path, text).unwrap();
    check(&problems_of(&path), expected);
}

#[test]
fn the_rows_they_are_made_of_are_good() {
    expect_rows(ROWS, &[]);
}

#[test]
fn file_not_there() {
    expect(
        &and("[measured]\nfile = \"rig.csv\""),
        &[problem(
            "measured.file",
            "\"rig.csv\"",
            &["/rig.csv: there is no such file"],
            "check name",
        )],
    );
}

#[test]
fn columns() {
    let twice = put(ROWS, ",source", ",measured_left_um");
    expect_rows(
        &put(&twice, "wheel_tooth,", "weel_tooth,"),
        &[
            problem(
                "measured.file",
                "rig.csv",
                &[
                    "line 1: column wheel_tooth is missing; the columns are ",
                    "\"weel_tooth\" (B)",
                ],
                "name it there",
            ),
            problem(
                "measured.file",
                "rig.csv",
                &[
                    "line 1: 2 columns may be measured_left_um: \"measured_left_um\" (E) and \"measured_left_um\" (H)",
                ],
                "keep one of them",
            ),
        ],
    );
    expect_rows(
        &put(ROWS, "center_distance_mm", "center_distance_um"),
        &[problem(
            "measured.file",
            "rig.csv",
            &["line 1: column \"center_distance_um\" (A) is in µm, allowed is mm"],
            "convert its values to mm",
        )],
    );
}

/// Sources may be left out; a German Excel writes semicolons and commas.
#[test]
fn other_ways_of_writing() {
    let without: Vec<&str> = ROWS
        .lines()
        .map(|row| row.rsplit_once(',').unwrap().0)
        .collect();
    expect_rows(&without.join("\n"), &[]);
    expect_rows(&ROWS.replace(',', ";").replace('.', ","), &[]);
}

#[test]
fn rows() {
    expect_rows(
        &(ROWS.to_owned()
            + "75.2,21,0,150,155,140,160,x\n75.2,1,1,15O,nan,160,140,x\n\n-1,1,1,1,1,1,1,x\n75,2,1,1,150,155,140,160,x\n75.2,1,1,1,1,2,1,x\n"),
        &[
            problem(
                "measured.file",
                "rig.csv",
                &["rig.csv: line 3: wheel_tooth is \"21\"", "1 … 20"],
                "correct",
            ),
            problem(
                "measured.file",
                "rig.csv",
                &["line 3: pinion_tooth is \"0\"", "1 … 30"],
                "correct",
            ),
            problem(
                "measured.file",
                "rig.csv",
                &["line 4: measured_right_um is \"15O\"", "a number of µm"],
                "correct",
            ),
            problem(
                "measured.file",
                "rig.csv",
                &["line 4: measured_left_um is \"nan\"", "a number of µm"],
                "correct",
            ),
            problem(
                "measured.file",
                "rig.csv",
                &["line 6: center_distance_mm is \"-1\"", "above 0"],
                "correct",
            ),
            problem(
                "measured.file",
                "rig.csv",
                &["line 7: 9 values, the header names 8 columns"],
                "commas",
            ),
            problem(
                "measured.file",
                "rig.csv",
                &[
                    "line 8: predicted_max_um is \"1\"",
                    "predicted_min_um or above",
                ],
                "correct",
            ),
        ],
    );
    expect_rows(
        ROWS.lines().next().unwrap(),
        &[problem("measured.file", "rig.csv", &["no rows"], "add")],
    );
    expect_rows(
        &put(ROWS, "75.2,", "70.1,"),
        &[problem(
            "measured.file",
            "rig.csv",
            &["line 2", "base circles overlap", "70.476947"],
            "correct",
        )],
    );
}
