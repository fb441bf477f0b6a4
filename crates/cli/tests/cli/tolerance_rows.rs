//! `gearlash tolerance --rows`, `--first` and `--from-rows`: rows of any ranges give the bytes of one run.

use super::tolerance::{pair, tolerance};
use super::*;

/// Names and bytes of all files of a folder.
fn bytes(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let names = files(folder).into_iter();
    let each = names.map(|name| (name.clone(), std::fs::read(folder.join(name)).unwrap()));
    each.collect()
}

fn ok(here: &Path, args: &str) -> String {
    let (code, printed, message) = tolerance(here, args);
    assert_eq!(code, Some(0), "{args}: {message}");
    printed
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
        let message = ok(here, &args);
        assert_eq!(message.replace(&format!("o{ranges}"), "whole"), printed);
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
