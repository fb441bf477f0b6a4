use super::*;

#[test]
fn not_there() {
    let folder = TempDir::new().unwrap();
    let problems = problems_of(&folder.path().join("pair.toml"));
    check(
        &problems,
        &[problem("", "", &["no such file"], "check name")],
    );
}

#[test]
fn a_folder() {
    let folder = TempDir::new().unwrap();
    let problems = problems_of(folder.path());
    check(
        &problems,
        &[problem("", "", &["is a folder"], "name the file")],
    );
}

#[test]
fn over_16_mebibytes() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("pair.toml");
    let file = fs::File::create(&path).unwrap();
    file.set_len((16 << 20) + 1).unwrap();
    let reason = &["16.0 MiB", "allowed is up to 16 MiB"];
    check(
        &problems_of(&path),
        &[problem("", "", reason, "the file you mean")],
    );
}

#[test]
fn not_utf_8() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("pair.toml");
    fs::write(&path, b"title = \"a\"\ntitle = \"\xe4\"\n").unwrap();
    let expected = problem("", "", &["line 2", "not UTF-8"], "save the file as UTF-8");
    check(&problems_of(&path), &[expected]);
}

#[test]
fn not_toml() {
    expect(
        "[wheel]\nteeth = = 20\n",
        &[problem(
            "",
            "",
            &["not TOML", "line 2 column 9"],
            "fix it there",
        )],
    );
    expect(
        "[wheel]\nteeth = 20\nteeth = 20\n",
        &[problem(
            "",
            "",
            &["not TOML", "duplicate", "line 3"],
            "fix it there",
        )],
    );
}

/// Every line that is no TOML is reported, each once: three decimal commas, of which two stand in one line. By hand.
#[test]
fn each_line_that_is_not_toml() {
    expect(
        "[wheel]\nmodule_mm = 3,5\nteeth = 20\nspan = { min_mm = 7,66, max_mm = 7,67 }\n",
        &[
            problem("", "", &["not TOML", "line 2 column 14"], "fix it there"),
            problem("", "", &["not TOML", "line 4 column"], "fix it there"),
        ],
    );
}

/// Of many the first dozen.
#[test]
fn many_lines_that_are_not_toml() {
    let line = || problem("", "", &["not TOML"], "fix it there");
    let mut expected: Vec<_> = (0..12).map(|_| line()).collect();
    expected.push(problem(
        "",
        "",
        &["8 more problems like the last one"],
        "fix those first",
    ));
    expect(&"x = 1,5\n".repeat(20), &expected);
}

#[test]
fn not_json() {
    expect_as(
        "pair.json",
        "{ \"wheel\": {\n  \"teeth\": 20,, } }",
        &[problem(
            "",
            "",
            &["not JSON", "line 2 column 15"],
            "fix it there",
        )],
    );
    expect_as(
        "pair",
        "{ \"wheel\": 1, \"wheel\": 1 }",
        &[problem(
            "",
            "",
            &["not JSON", "`wheel` is given twice"],
            "fix it there",
        )],
    );
    expect_as(
        "pair.json",
        "[1]",
        &[problem(
            "",
            "",
            &["a list", "allowed is an object"],
            "wheel",
        )],
    );
}
