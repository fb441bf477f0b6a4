//! The walls inside the library that Cargo cannot hold (ARCHITECTURE.md).

use std::fs;
use std::path::{Path, PathBuf};

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// The files below src/`room` whose code, comments and tests apart, names one of `names`.
fn that_name(room: &str, names: &[&str]) -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    sources(&root.join(room), &mut files);
    assert!(!files.is_empty(), "no file in src/{room}");
    let names_one = |path: &PathBuf| {
        let text = fs::read_to_string(path).unwrap();
        let code = text.split("#[cfg(test)]\nmod tests").next().unwrap();
        let lines = code
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"));
        lines
            .flat_map(|line| names.iter().map(move |name| line.contains(name)))
            .any(|names| names)
    };
    let named = files.iter().filter(|path| names_one(path));
    let relative = |path: &PathBuf| path.strip_prefix(&root).unwrap().display().to_string();
    named.map(relative).collect()
}

#[test]
fn the_analytic_models_see_no_contact() {
    let names = ["crate::contact", "crate::analysis", "crate::gauge"];
    assert_eq!(that_name("analytic", &names), [""; 0]);
}

#[test]
fn a_gear_knows_no_pair() {
    let names = [
        "crate::metrology",
        "crate::pair",
        "crate::contact",
        "crate::analytic",
        "crate::analysis",
        "crate::gauge",
    ];
    assert_eq!(that_name("gear", &names), [""; 0]);
}

#[test]
fn an_outline_knows_no_contact_and_no_model() {
    let names = [
        "crate::metrology",
        "crate::contact",
        "crate::analytic",
        "crate::analysis",
        "crate::gauge",
    ];
    assert_eq!(that_name("outline", &names), [""; 0]);
}

#[test]
fn a_pair_knows_no_contact() {
    let names = [
        "crate::metrology",
        "crate::contact",
        "crate::analytic",
        "crate::analysis",
        "crate::gauge",
    ];
    assert_eq!(that_name("pair", &names), [""; 0]);
}

#[test]
fn one_file_names_parry() {
    assert_eq!(that_name("", &["parry2d"]), ["contact/parry.rs"]);
}

#[test]
fn contact_knows_no_model_and_no_analysis() {
    let names = [
        "crate::analytic",
        "crate::analysis",
        "crate::gauge",
        "crate::metrology",
    ];
    assert_eq!(that_name("contact", &names), [""; 0]);
}

#[test]
fn measurements_know_one_gear_alone() {
    let names = [
        "crate::pair",
        "crate::contact",
        "crate::analytic",
        "crate::analysis",
        "crate::gauge",
    ];
    assert_eq!(that_name("metrology", &names), [""; 0]);
}

#[test]
fn nothing_knows_a_population() {
    let rooms = [
        "gear",
        "pair",
        "metrology",
        "outline",
        "contact",
        "analytic",
        "analysis",
        "gauge",
    ];
    for room in rooms {
        assert_eq!(that_name(room, &["crate::population"]), [""; 0], "{room}");
    }
}

#[test]
fn a_population_knows_no_gauge_and_no_measurements() {
    let names = ["crate::gauge", "crate::metrology", "crate::outline"];
    assert_eq!(that_name("population", &names), [""; 0]);
}

/// That the test above can fail.
#[test]
fn an_import_is_found() {
    assert!(!that_name("contact", &["crate::pair"]).is_empty());
}
