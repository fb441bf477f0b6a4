//! `gearlash tolerance --rows`: the same rows in every format and however the run is cut, and never over a result.

use super::tolerance::{pair, tolerance};
use super::*;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::RowAccessor;

/// The rows of a Parquet file as those of a CSV, headings too.
fn parquet_as_csv(path: &Path) -> String {
    let read = SerializedFileReader::new(std::fs::File::open(path).unwrap()).unwrap();
    let schema = read.metadata().file_metadata().schema_descr_ptr();
    let names: Vec<&str> = schema.columns().iter().map(|one| one.name()).collect();
    let mut text = names.join(",") + "\n";
    for row in read.get_row_iter(None).unwrap() {
        let row = row.unwrap();
        let um = |index: usize| {
            row.get_double(index)
                .map_or(String::new(), |um| um.to_string())
        };
        let (number, word) = (row.get_long(0).unwrap(), row.get_string(1).unwrap());
        let proven = row.get_bool(4).unwrap();
        text += &format!("{number},{word},{},{},{proven}\n", um(2), um(3));
    }
    text
}

#[test]
fn rows_are_the_same_in_parquet_and_in_parts() {
    let folder = empty_folder();
    pair(folder.path());
    let run = |args: &str| {
        let (code, _, told) = tolerance(folder.path(), &format!("tolerance pair.toml {args}"));
        assert_eq!(code, Some(0), "{told}");
    };
    run("-o o --rows o/rows.csv");
    run("-o o2 --rows o2/rows.parquet");
    let csv = std::fs::read_to_string(folder.path().join("o/rows.csv")).unwrap();
    assert_eq!(csv.lines().count(), 301);
    let whole = parquet_as_csv(&folder.path().join("o2/rows.parquet"));
    assert_eq!(whole, csv);
    let mut parts = String::new();
    for k in 1..=3 {
        run(&format!("--shard {k}/3 -o parts --rows rows_{k}.parquet"));
        let part = parquet_as_csv(&folder.path().join(format!("rows_{k}.parquet")));
        let (head, rows) = part.split_once('\n').unwrap();
        if k == 1 {
            parts = head.to_owned() + "\n";
        }
        parts += rows;
    }
    assert_eq!(parts, whole);
}

/// Teeth that jam: nothing is proven of what has no values, in either format.
#[test]
fn rows_of_jammed_assemblies_are_not_called_proven() {
    let folder = empty_folder();
    let text = super::tolerance::PAIR.replace(
        "{ scatter = \"uniform\" }",
        "{ scatter = \"table\", values_um = [0, 1500] }",
    );
    let text = text.replace("assemblies = 300", "assemblies = 24");
    let text = text.replace("contribution_rows = 64", "contribution_rows = 0");
    std::fs::write(folder.path().join("pair.toml"), text).unwrap();
    let (code, printed, told) = tolerance(folder.path(), "tolerance pair.toml -o o --rows r.csv");
    assert_eq!(code, Some(0), "{told}");
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
    assert!(jammed.iter().all(|row| row.ends_with(",false")), "{rows}");
}

#[test]
fn rows_never_take_the_name_of_a_result() {
    let folder = empty_folder();
    pair(folder.path());
    for (rows, wanted) in [
        ("o/result.csv", "the results themselves have a file called"),
        (
            "./o/../o/histogram.csv",
            "the results themselves have a file called",
        ),
        ("o/Result.csv", "the results themselves have a file called"),
        ("o/rows.txt", "name a file that ends in .csv or .parquet"),
    ] {
        let args = format!("tolerance pair.toml -o o --rows {rows}");
        let (code, printed, told) = tolerance(folder.path(), &args);
        assert_eq!((code, printed.as_str()), (Some(2), ""), "{rows}: {told}");
        assert!(told.contains(wanted), "{rows}: {told}");
        assert!(files(&folder.path().join("o")).is_empty(), "{rows}");
    }
    // Elsewhere the name is free.
    let args = "tolerance pair.toml -o o --rows rows/result.csv";
    assert_eq!(tolerance(folder.path(), args).0, Some(0));
    let rows = std::fs::read_to_string(folder.path().join("rows/result.csv")).unwrap();
    assert!(rows.starts_with("assembly,outcome"));
    let result = std::fs::read_to_string(folder.path().join("o/result.csv")).unwrap();
    assert!(result.starts_with("what,value"));
}
