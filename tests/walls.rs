//! The walls inside the library that Cargo cannot hold (ARCHITECTURE.md).

#[path = "common/skip.rs"]
mod skip;

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

/// Crates below the library, itself among them, with these options; `None` where cargo cannot tell without a network.
fn crates(options: &[&str]) -> Option<Vec<String>> {
    let mut cargo = std::process::Command::new(env!("CARGO"));
    cargo.current_dir(env!("CARGO_MANIFEST_DIR"));
    cargo.args([
        "tree",
        "--locked",
        "--offline",
        "-p",
        "gearlash",
        "-e",
        "normal",
    ]);
    let output = cargo
        .args(["--prefix", "none"])
        .args(options)
        .output()
        .unwrap();
    if !output.status.success() {
        skip::skip(&String::from_utf8_lossy(&output.stderr));
        return None;
    }
    let text = String::from_utf8(output.stdout).unwrap();
    let names = text.lines().filter(|line| !line.ends_with(" (*)"));
    let mut names: Vec<String> = names.map(str::to_owned).collect();
    names.sort();
    names.dedup();
    Some(names)
}

/// README states both numbers.
#[test]
fn the_library_stands_on_few_crates() {
    let (Some(all), Some(least)) = (crates(&[]), crates(&["--no-default-features"])) else {
        return;
    };
    assert!(all.len() < 50, "{}: {all:?}", all.len());
    let named = |name: &str| least.iter().any(|one| one.split(' ').next() == Some(name));
    assert!(
        named("nalgebra") && !named("rayon") && !named("serde"),
        "{least:?}"
    );
    let readme = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    let stated = format!("{} crates, or {} without", all.len(), least.len());
    let readme = fs::read_to_string(readme).unwrap().replace('\n', " ");
    assert!(readme.contains(&stated), "{stated}");
}
