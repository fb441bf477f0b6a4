//! What stands already where `gearlash tolerance`, `merge` and `match` write, and names that are no text: nothing is lost, nothing taken for this
//! run's.

use super::tolerance::{PAIR, pair, tolerance};
use super::*;

fn write(folder: &Path, name: &str, text: &str) {
    std::fs::write(folder.join(name), text).unwrap();
}

fn read(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join(name)).unwrap()
}

/// Runs, with the exit code that is expected, and says what was reported.
fn ends(folder: &Path, args: &str, wanted: i32) -> String {
    let (code, _, told) = tolerance(folder, args);
    assert_eq!(code, Some(wanted), "{args}: {told}");
    told.replace('\n', " ")
}

/// Rows of seed 7 beside results of seed 8 would be taken for theirs: refused until they are replaced. Those of the same run may stay.
#[test]
fn rows_of_an_earlier_run_do_not_stand_beside_other_results() {
    for rows in ["o/rows.csv", "o/rows.parquet"] {
        let folder = empty_folder();
        let here = folder.path();
        pair(here);
        let run = "tolerance pair.toml --assemblies 40 -o o";
        ends(here, &format!("{run} --rows {rows}"), 0);
        ends(here, run, 0);
        let bytes = std::fs::read(here.join(rows)).unwrap();
        let result = read(here, "o/result.json");
        let told = ends(here, &format!("{run} --seed 8"), 2);
        assert!(
            told.contains(rows) && told.contains("these are the rows of an earlier run"),
            "{told}"
        );
        assert_eq!(std::fs::read(here.join(rows)).unwrap(), bytes);
        assert_eq!(read(here, "o/result.json"), result);
        ends(
            here,
            "tolerance pair.toml --assemblies 40 --seed 8 --shard 1/1 -o p",
            0,
        );
        let told = ends(here, "merge p/part_1_of_1.json -o o", 2);
        assert!(
            told.contains("these are the rows of an earlier run"),
            "{told}"
        );
        ends(here, &format!("{run} --seed 8 --rows {rows}"), 0);
        assert_ne!(std::fs::read(here.join(rows)).unwrap(), bytes);
    }
}

/// Two parts write to one folder at once, as `xargs -P` does; of one name for both the second is refused, and done again the first is.
#[test]
fn rows_of_parts_stand_in_one_folder() {
    let folder = empty_folder();
    let here = folder.path();
    pair(here);
    let words = |k: u32, rows: &str| {
        let args = format!("tolerance pair.toml --assemblies 60 --shard {k}/2 -o p --rows {rows}");
        args.split(' ').map(str::to_owned).collect::<Vec<_>>()
    };
    let both: Vec<_> = [1, 2]
        .map(|k| {
            let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_gearlash"));
            command
                .current_dir(here)
                .args(words(k, &format!("p/rows_{k}.csv")));
            command.stdout(std::process::Stdio::null()).spawn().unwrap()
        })
        .into_iter()
        .map(|mut child| child.wait().unwrap().success())
        .collect();
    assert_eq!(both, [true, true]);
    for (k, first) in [(1, "1,"), (2, "31,")] {
        let rows = read(here, &format!("p/rows_{k}.csv"));
        assert!(rows.lines().nth(1).unwrap().starts_with(first), "{rows}");
    }
    for rows in ["p/all.csv", "p/all.parquet"] {
        let one = |k: u32, wanted| ends(here, &words(k, rows).join(" "), wanted);
        one(1, 0);
        let bytes = std::fs::read(here.join(rows)).unwrap();
        let told = one(2, 2);
        assert!(
            told.contains(
                "holds the rows of another part, from assembly 1 on, and this one begins with 31"
            ),
            "{told}"
        );
        one(1, 0);
        assert_eq!(std::fs::read(here.join(rows)).unwrap(), bytes);
    }
    write(here, "mine.csv", "tooth,um\n1,2\n");
    for rows in ["mine.csv", "pair.toml"] {
        ends(here, &words(1, rows).join(" "), 2);
    }
    let told = ends(here, &words(1, "mine.csv").join(" "), 2);
    assert!(
        told.contains("holds no rows of gearlash, and would be lost"),
        "{told}"
    );
    assert_eq!(read(here, "mine.csv"), "tooth,um\n1,2\n");
    let left: Vec<String> = files(here)
        .into_iter()
        .filter(|name| name.starts_with('.'))
        .collect();
    assert!(left.is_empty(), "{left:?}");
}

#[test]
fn a_part_given_twice_is_named_by_whatever_name() {
    let folder = empty_folder();
    let here = folder.path();
    pair(here);
    for k in [1, 2] {
        ends(here, &format!("tolerance pair.toml --shard {k}/2 -o p"), 0);
    }
    let merged = |second: &str| {
        ends(
            here,
            &format!("merge p/part_1_of_2.json {second} p/part_2_of_2.json -o m"),
            2,
        )
    };
    assert!(
        merged("p/part_1_of_2.json")
            .contains("p/part_1_of_2.json: is named twice; name each part once")
    );
    assert!(
        merged("./p/../p/part_1_of_2.json")
            .contains("./p/../p/part_1_of_2.json: is part 1, as p/part_1_of_2.json is")
    );
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("p/part_1_of_2.json", here.join("link.json")).unwrap();
        assert!(merged("link.json").contains("link.json: is part 1, as p/part_1_of_2.json is"));
    }
    assert!(files(&here.join("m")).is_empty());
}

/// Numbers of two parts are the same to the last bit, or they are of two runs.
#[test]
fn a_part_that_reckons_a_bit_otherwise_is_of_another_run() {
    let folder = empty_folder();
    let here = folder.path();
    pair(here);
    for k in [1, 2] {
        ends(here, &format!("tolerance pair.toml --shard {k}/2 -o p"), 0);
    }
    let text = read(here, "p/part_2_of_2.json");
    let part: Value = serde_json::from_str(&text).unwrap();
    let mean = part["about"]["limit_cases"][0][0].as_f64().unwrap();
    for (from, to, what) in [
        (
            mean.to_string(),
            f64::from_bits(mean.to_bits() + 1).to_string(),
            "worst case and root sum of squares another, not the same to the last bit",
        ),
        (
            "\"max_ppm\":null".to_owned(),
            "\"max_ppm\":0.0".to_owned(),
            "requirement another",
        ),
    ] {
        assert!(text.contains(&from), "{from}");
        write(here, "p/part_2_of_2.json", &text.replacen(&from, &to, 1));
        let told = ends(here, "merge p/part_1_of_2.json p/part_2_of_2.json -o m", 2);
        assert!(told.contains(what), "{told}");
    }
    write(here, "p/part_2_of_2.json", &text);
    ends(here, "merge p/part_1_of_2.json p/part_2_of_2.json -o m", 0);
}

/// As of `simulate`: JSON and CSV are the result itself, printed, and files where a folder is named.
#[test]
fn json_and_csv_without_a_folder_write_nothing() {
    let folder = empty_folder();
    let here = folder.path();
    pair(here);
    let run = "tolerance pair.toml --assemblies 40";
    ends(here, &format!("{run} -o o"), 0);
    ends(here, &format!("{run} --shard 1/1 -o p"), 0);
    let before = files(here);
    for command in [run, "merge p/part_1_of_1.json"] {
        for (format, file) in [("json", "result.json"), ("csv", "result.csv")] {
            let (code, printed, told) = tolerance(here, &format!("{command} --format {format}"));
            assert_eq!(code, Some(0), "{told}");
            assert_eq!(printed, read(here, &format!("o/{file}")));
        }
    }
    assert_eq!(files(here), before);
    let (_, printed, _) = tolerance(here, &format!("{run} --format csv -o named"));
    assert_eq!(printed, read(here, "named/result.csv"));
}

/// `worst_03.toml` of the user's own, one that was changed, and names that no run writes.
#[test]
fn pair_files_that_no_run_has_written_stay() {
    let folder = empty_folder();
    let here = folder.path();
    pair(here);
    std::fs::create_dir(here.join("o")).unwrap();
    for name in ["worst_.toml", "worst_11.toml", "worst_1999.toml"] {
        write(here, &format!("o/{name}"), "mine\n");
    }
    let run = "tolerance pair.toml -o o";
    ends(here, run, 0);
    // Those of a run are replaced.
    ends(here, &format!("{run} --seed 8"), 0);
    for name in ["worst_.toml", "worst_11.toml", "worst_1999.toml"] {
        assert_eq!(read(here, &format!("o/{name}")), "mine\n");
    }
    let written = read(here, "o/worst_03.toml");
    assert!(written.starts_with("# written by gearlash tolerance; sha256"));
    for text in [PAIR.to_owned(), written.replace("teeth = 20", "teeth = 21")] {
        assert_ne!(text, written);
        write(here, "o/worst_03.toml", &text);
        let before = read(here, "o/result.json");
        let told = ends(here, run, 2);
        assert!(
            told.contains(
                "o/worst_03.toml: would be replaced, and is not as gearlash tolerance wrote it"
            ),
            "{told}"
        );
        assert_eq!(read(here, "o/worst_03.toml"), text);
        assert_eq!(read(here, "o/result.json"), before);
    }
    write(here, "o/worst_03.toml", &written);
    ends(here, run, 0);
}

/// Folders and files whose names are no UTF-8: everything is found, written and told apart.
#[cfg(target_os = "linux")]
#[test]
fn names_that_are_no_text_are_taken_as_they_are() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    let top = empty_folder();
    let here = top.path().join(OsStr::from_bytes(b"Zahnr\xe4der"));
    std::fs::create_dir_all(here.join("w")).unwrap();
    std::fs::create_dir_all(here.join("p")).unwrap();
    let gear = |teeth: u32| {
        format!(
            "[gear]\nteeth = {teeth}\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nthickness.allowance_um = -40\n"
        )
    };
    for (name, teeth) in [
        (&b"w/1.toml"[..], 20),
        (b"w/\xe4.toml", 20),
        (b"w/\xf6.toml", 20),
        (b"p/\xfc.toml", 30),
        (b"p/2.toml", 30),
    ] {
        std::fs::write(here.join(OsStr::from_bytes(name)), gear(teeth)).unwrap();
    }
    let own = PAIR.split("[tolerance.wheel]").next().unwrap();
    std::fs::write(
        here.join("pair.toml"),
        format!("{own}[tolerance.wheel]\ngears = \"w/*.toml\"\n"),
    )
    .unwrap();
    let wide = own.replace("max = 150", "max = 400");
    std::fs::write(here.join("wide.toml"), wide).unwrap();
    // From within, from above, by its absolute name.
    for (working, start) in [
        (here.as_path(), Path::new("")),
        (top.path(), Path::new(here.file_name().unwrap())),
        (top.path(), &here),
    ] {
        let run = |arguments: &[&OsStr], wanted: i32| {
            let output = gearlash(working).args(arguments).output().unwrap();
            let told = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(wanted), "{told}");
            String::from_utf8(output.stdout).unwrap()
        };
        let at = |name: &str| start.join(name).into_os_string();
        let word = |text: &'static str| OsStr::new(text);
        let rows = start.join(OsStr::from_bytes(b"r\xe4.csv"));
        run(
            &[
                word("tolerance"),
                &at("pair.toml"),
                word("--assemblies"),
                word("30"),
                word("-o"),
                &at("o"),
                word("--rows"),
                rows.as_os_str(),
            ],
            0,
        );
        assert_eq!(
            std::fs::read_to_string(here.join(OsStr::from_bytes(b"r\xe4.csv")))
                .unwrap()
                .lines()
                .count(),
            31
        );
        // All three wheels are drawn.
        let result = std::fs::read_to_string(here.join("o/result.json")).unwrap();
        assert!(result.contains("which wheel"), "{result}");
        let rows = start.join(OsStr::from_bytes(b"o/r\xe4.csv"));
        let words = [
            word("tolerance"),
            &at("pair.toml"),
            word("-o"),
            &at("o"),
            word("--rows"),
            rows.as_os_str(),
        ];
        let output = gearlash(working).args(words).output().unwrap();
        let told = String::from_utf8(output.stderr).unwrap();
        assert!(
            output.status.code() == Some(2)
                && told.contains("in the folder of the results a name is UTF-8"),
            "{told}"
        );
        run(
            &[
                word("tolerance"),
                &at("pair.toml"),
                word("--shard"),
                word("1/1"),
                word("-o"),
                &at("parts"),
            ],
            0,
        );
        run(
            &[
                word("merge"),
                &at("parts/part_1_of_1.json"),
                word("-o"),
                &at("m"),
            ],
            0,
        );
        let printed = run(
            &[
                word("match"),
                &at("wide.toml"),
                word("--wheels"),
                &at("w"),
                word("--pinions"),
                &at("p"),
                word("-o"),
                &at("matched"),
            ],
            0,
        );
        assert!(printed.starts_with("2 of 2 pairs"), "{printed}");
        let matrix = std::fs::read_to_string(here.join("matched/matrix.csv")).unwrap();
        for name in ["\n\\xe4,\\xfc,", "\n\\xf6,2,", "\n1,2,"] {
            assert!(matrix.contains(name), "{name}: {matrix}");
        }
    }
}
