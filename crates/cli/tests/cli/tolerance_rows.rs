//! `gearlash tolerance --rows`, `--first` and `--from-rows`: rows computed anywhere give the bytes of one run.

use super::tolerance::{PAIR, pair, tolerance};
use super::*;

/// Names and bytes of all files of a folder.
fn bytes(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let names = files(folder).into_iter();
    let each = names.map(|name| (name.clone(), std::fs::read(folder.join(name)).unwrap()));
    each.collect()
}

fn ok(here: &Path, args: &str) -> String {
    let (code, printed, told) = tolerance(here, args);
    assert_eq!(code, Some(0), "{args}: {told}");
    printed
}

/// Exit code 2, nothing printed; returns what is told, on one line.
fn refused(here: &Path, args: &str) -> String {
    let (code, printed, told) = tolerance(here, args);
    assert_eq!((code, printed.as_str()), (Some(2), ""), "{args}: {told}");
    told.replace('\n', " ")
}

#[test]
fn any_ranges_on_any_threads_give_the_bytes_of_one_run() {
    let folder = empty_folder();
    let here = folder.path();
    pair(here);
    let printed = ok(here, "tolerance pair.toml -o whole");
    let wanted = bytes(&here.join("whole"));
    assert!(wanted.iter().any(|(name, _)| name == "worst_10.toml"));
    let mut all = None;
    for ranges in [1u64, 3, 7] {
        let mut rows = String::new();
        for k in (0..ranges).rev() {
            let (first, end) = (1 + 300 * k / ranges, 1 + 300 * (k + 1) / ranges);
            let mut command = gearlash(here);
            command.env("RAYON_NUM_THREADS", ["1", "2", "7"][(k % 3) as usize]);
            let count = end - first;
            let args = format!(
                "tolerance pair.toml --first {first} --assemblies {count} --rows r{ranges}/{k}.csv"
            );
            command.args(args.split(' ')).assert().success();
            let text = std::fs::read_to_string(here.join(format!("r{ranges}/{k}.csv"))).unwrap();
            let (head, rest) = text.split_once('\n').unwrap();
            assert!(
                head.contains(", seed 7, ")
                    && head.ends_with(&format!("first {first}, count {count}")),
                "{head}"
            );
            let (columns, rest) = rest.split_once('\n').unwrap();
            assert!(columns.starts_with("assembly,outcome,least_um,"));
            rows = rest.to_owned() + &rows;
        }
        assert_eq!(rows.lines().count(), 300);
        assert_eq!(*all.get_or_insert(rows.clone()), rows, "{ranges}");
        let args = format!("tolerance pair.toml --from-rows r{ranges}/*.csv -o o{ranges}");
        let told = ok(here, &args);
        assert_eq!(told.replace(&format!("o{ranges}"), "whole"), printed);
        assert!(
            bytes(&here.join(format!("o{ranges}"))) == wanted,
            "{ranges}"
        );
    }
    // A run that also writes its rows, and several names.
    ok(here, "tolerance pair.toml -o own --rows rows.csv");
    assert!(bytes(&here.join("own")) == wanted);
    let own = std::fs::read_to_string(here.join("rows.csv")).unwrap();
    assert!(own.ends_with(&all.unwrap()));
    ok(
        here,
        "tolerance pair.toml -o again --from-rows r3/0.csv r3/[12].csv",
    );
    assert!(bytes(&here.join("again")) == wanted);
    let printed = ok(
        here,
        "tolerance pair.toml --from-rows rows.csv --format json",
    );
    assert!(printed.as_bytes() == std::fs::read(here.join("whole/result.json")).unwrap());
}

#[test]
fn rows_that_make_no_run_are_named() {
    let folder = empty_folder();
    let here = folder.path();
    pair(here);
    let rows = |args: &str| ok(here, &format!("tolerance {args}"));
    for (first, name) in [(1, "a"), (101, "b"), (201, "c")] {
        rows(&format!(
            "pair.toml --first {first} --assemblies 100 --rows {name}.csv"
        ));
    }
    rows("pair.toml --first 101 --assemblies 100 --seed 8 --rows seed.csv");
    rows("pair.toml --first 301 --assemblies 5 --rows beyond.csv");
    rows("pair.toml --first 191 --assemblies 20 --rows lap.csv");
    std::fs::write(here.join("other.toml"), PAIR.replace("50.1", "50.2")).unwrap();
    rows("other.toml --first 101 --assemblies 100 --rows other.csv");
    let text = std::fs::read_to_string(here.join("b.csv")).unwrap();
    let version = format!("version {}", env!("CARGO_PKG_VERSION"));
    let write = |name: &str, text: &str| std::fs::write(here.join(name), text).unwrap();
    write("old.csv", &text.replace(&version, "version 0.0.1"));
    // Killed while it wrote its last row.
    write("cut.csv", &text[..text.len() - 3]);
    let line = text.lines().nth(7).unwrap();
    write("hole.csv", &text.replace(&format!("{line}\n"), ""));
    write(
        "edited.csv",
        &text.replace(line, "106,clear,much,,true,false,false,"),
    );
    write("table.csv", "tooth,um\n1,2\n");
    std::fs::create_dir(here.join("folder.csv")).unwrap();
    for (second, wanted) in [
        (
            "",
            "pair.toml: rows are missing, of 300 assemblies: assemblies 101 to 200; compute them, the first by gearlash tolerance pair.toml --first 101 --assemblies 100 --rows rows_101.csv",
        ),
        (
            "b.csv b.csv",
            "rows are there twice: assemblies 101 to 200 in b.csv and b.csv",
        ),
        (
            "b.csv lap.csv",
            "assemblies 191 to 200 in lap.csv and b.csv",
        ),
        (
            "b.csv beyond.csv",
            "rows lie beyond the 300 assemblies of the run: assemblies 301 to 305 in beyond.csv",
        ),
        ("seed.csv", "seed.csv: rows of another run: seed 8, not 7"),
        ("other.csv", "other.csv: rows of another run: input_sha256"),
        (
            "old.csv",
            "old.csv: rows of another run: version of gearlash 0.0.1",
        ),
        ("cut.csv", "assembly 200; compute them, the first by"),
        ("hole.csv", "assembly 106; compute them"),
        (
            "edited.csv",
            "edited.csv: line 8 is no row: \"106,clear,much,,",
        ),
        (
            "table.csv",
            "table.csv: is no file of rows: its first lines are no header",
        ),
        ("pair.toml", "pair.toml: is no file of rows"),
        ("none.csv", "--from-rows none.csv: no such file"),
        ("none*.csv", "--from-rows none*.csv: no such file"),
        ("folder.csv", "--from-rows folder.csv: this is no file"),
    ] {
        let args = format!("tolerance pair.toml --from-rows a.csv c.csv {second} -o m");
        let told = refused(here, &args);
        assert!(told.contains(wanted), "{second}: {told}");
        assert!(files(&here.join("m")).is_empty(), "{second}");
    }
    // The command that is told computes what was missing; more assemblies are another run of the same population.
    rows("pair.toml --first 200 --assemblies 1 --rows last.csv");
    rows("pair.toml --from-rows a.csv cut.csv last.csv c.csv -o m");
    rows("pair.toml --from-rows a.csv b.csv c.csv beyond.csv --assemblies 305 -o m");
    rows("pair.toml --assemblies 305 -o n");
    assert!(bytes(&here.join("m")) == bytes(&here.join("n")));
}

/// Jammed teeth: nothing is proven of an assembly without values.
#[test]
fn rows_of_jammed_assemblies_are_not_called_proven() {
    let folder = empty_folder();
    let text = PAIR.replace(
        "{ scatter = \"uniform\" }",
        "{ scatter = \"table\", values_um = [0, 1500] }",
    );
    let text = text.replace("assemblies = 300", "assemblies = 24");
    let text = text.replace("contribution_rows = 64", "contribution_rows = 0");
    std::fs::write(folder.path().join("pair.toml"), text).unwrap();
    let printed = ok(folder.path(), "tolerance pair.toml -o o --rows r.csv");
    assert!(
        printed.contains("Mean, standard deviation, Cp and Cpk are without the"),
        "{printed}"
    );
    let rows = std::fs::read_to_string(folder.path().join("r.csv")).unwrap();
    let jammed: Vec<&str> = rows
        .lines()
        .filter(|row| row.contains(",jammed,,,"))
        .collect();
    assert!(jammed.len() > 5, "{rows}");
    assert!(
        jammed.iter().all(|row| row.ends_with(",false,true,false,")),
        "{rows}"
    );
    let again = ok(folder.path(), "tolerance pair.toml -o o --from-rows r.csv");
    assert_eq!(again, printed);
}

#[test]
fn rows_never_replace_a_file() {
    let folder = empty_folder();
    let here = folder.path();
    pair(here);
    let text = "tooth,um\n1,2\n";
    std::fs::write(here.join("mine.csv"), text).unwrap();
    for (rows, wanted) in [
        ("mine.csv", "rows never replace one"),
        ("pair.toml", "rows never replace one"),
        (".", "this is a folder"),
        ("rows.parquet", "Parquet is gone: rows are CSV"),
        ("o/result.csv", "the results themselves have a file called"),
        (
            "./o/../o/histogram.csv",
            "the results themselves have a file called",
        ),
        ("o/Result.csv", "the results themselves have a file called"),
    ] {
        let told = refused(here, &format!("tolerance pair.toml -o o --rows {rows}"));
        assert!(told.contains(wanted), "{rows}: {told}");
        assert!(files(&here.join("o")).is_empty(), "{rows}");
    }
    assert_eq!(
        std::fs::read_to_string(here.join("mine.csv")).unwrap(),
        text
    );
    assert_eq!(
        std::fs::read_to_string(here.join("pair.toml")).unwrap(),
        PAIR
    );
    // Elsewhere the name is free, and a folder is made.
    ok(here, "tolerance pair.toml -o o --rows rows/result.csv");
    let told = refused(here, "tolerance pair.toml --first 301 --rows more.csv");
    assert!(told.contains("the pair file has 300 assemblies"), "{told}");
    for args in [
        "--first 2",
        "--first 2 --rows r.csv -o o",
        "--from-rows a --rows b",
    ] {
        refused(here, &format!("tolerance pair.toml {args}"));
    }
    assert!(!here.join("more.csv").exists() && !here.join("r.csv").exists());
}

/// Draws of no gear end a run, and leave no rows.
#[test]
fn a_run_that_fails_leaves_no_rows() {
    let folder = empty_folder();
    let scatter = "thickness = { scatter = \"table\", values_um = [0, 0, 0, 3000] }";
    let text = PAIR.replace("thickness = { scatter = \"uniform\" }", scatter);
    std::fs::write(folder.path().join("pair.toml"), text).unwrap();
    let told = refused(folder.path(), "tolerance pair.toml -o o --rows r.csv");
    assert!(told.contains("draws are of no gear"), "{told}");
    assert!(!folder.path().join("r.csv").exists());
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_names_the_file_of_rows() {
    let folder = empty_folder();
    pair(folder.path());
    for args in ["-o o", "--first 1 --assemblies 10"] {
        let args = format!("tolerance pair.toml {args} --rows /dev/full");
        let told = refused(folder.path(), &args);
        assert!(
            told.contains("--rows /dev/full: cannot be written: No space left on device"),
            "{told}"
        );
    }
}
