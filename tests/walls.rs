//! The walls inside the packages that Cargo cannot hold (ARCHITECTURE.md): what a room may not name, and no import circle.

#[path = "common/skip.rs"]
mod skip;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Rooms of `src/`, and the rooms that none of their files names. `population` and `matching` are above all of the others.
const WALLS: [(&str, &str); 9] = [
    (
        "gear",
        "pair outline metrology contact analytic analysis gauge",
    ),
    ("metrology", "pair outline contact analytic analysis gauge"),
    ("pair", "metrology contact analytic analysis gauge"),
    ("outline", "metrology contact analytic analysis gauge"),
    ("analytic", "contact analysis gauge"),
    ("contact", "metrology analytic analysis gauge"),
    ("analysis", ""),
    ("gauge", ""),
    ("population", "metrology gauge"),
];

/// Packages that read files, each above those before it, and the packages of this workspace that it imports.
const READERS: [(&str, &[&str]); 5] = [
    ("text", &["gearlash"]),
    ("tables", &["gearlash", "gearlash-text"]),
    ("drawing", &["gearlash", "gearlash-text"]),
    (
        "input",
        &[
            "gearlash",
            "gearlash-drawing",
            "gearlash-tables",
            "gearlash-text",
        ],
    ),
    ("rexs", &["gearlash", "gearlash-input", "gearlash-text"]),
];

/// Sources of the packages, below the root.
const PACKAGES: [&str; 10] = [
    "src",
    "crates/text/src",
    "crates/tables/src",
    "crates/drawing/src",
    "crates/input/src",
    "crates/rexs/src",
    "crates/results/src",
    "crates/render/src",
    "crates/cli/src",
    "crates/python/src",
];

/// The sources below `folder` of the repository.
fn sources(folder: &str) -> Vec<PathBuf> {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)];
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path);
            }
        }
    }
    assert!(!found.is_empty());
    found.sort();
    found
}

/// The code of each file below `folder`, comments and tests apart, by its path from there.
fn codes(folder: &str) -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let code = |path: &PathBuf| {
        let text = fs::read_to_string(path).unwrap();
        let code = text.split("#[cfg(test)]\nmod tests").next().unwrap();
        let is_code = |line: &&str| !line.trim_start().starts_with("//");
        let lines: Vec<&str> = code.lines().filter(is_code).collect();
        let path = path.strip_prefix(&root).unwrap().display().to_string();
        (path, lines.join("\n"))
    };
    sources(folder).iter().map(code).collect()
}

/// The files below src/`room` that name `name`.
fn that_name(room: &str, name: &str) -> Vec<String> {
    let names_it = |(path, code): (String, String)| code.contains(name).then_some(path);
    let codes = codes(&format!("src/{room}"));
    codes.into_iter().filter_map(names_it).collect()
}

#[test]
fn rooms_name_none_beyond_their_walls() {
    for (room, forbidden) in WALLS {
        let above = match room {
            "population" => "",
            _ => "population matching",
        };
        for name in forbidden.split_whitespace().chain(above.split_whitespace()) {
            let files = that_name(room, &format!("crate::{name}"));
            assert_eq!(files, [""; 0], "src/{room} names crate::{name}");
        }
    }
    // That this can fail.
    assert!(!that_name("contact", "crate::pair").is_empty());
}

#[test]
fn one_file_names_parry() {
    assert_eq!(that_name("", "parry2d"), ["contact/parry.rs"]);
}

/// A file as a module; paths are from the root of its package.
#[derive(Default)]
struct Module {
    /// Its imports from other modules.
    imports: Vec<String>,
    /// Where the names stand that it imports or hands on: below it they are its own.
    names: BTreeMap<String, String>,
}

/// The paths of a tree of imports: `a::{b, c::d}` is `a::b` and `a::c::d`.
fn paths(tree: &str) -> Vec<String> {
    let Some((stem, rest)) = tree.split_once('{') else {
        return vec![tree.split(" as ").next().unwrap().trim().to_owned()];
    };
    let mut depth = 0;
    let inner = rest.rsplit_once('}').map_or(rest, |(inner, _)| inner);
    let branches = inner.split(|letter| {
        depth += i32::from(letter == '{') - i32::from(letter == '}');
        letter == ',' && depth == 0
    });
    // A comma may end the list.
    let branches = branches.filter(|branch| !branch.trim().is_empty());
    let paths = branches.flat_map(paths);
    paths.map(|path| format!("{}{path}", stem.trim())).collect()
}

/// `path`, as the module `name` writes it, from the root.
fn absolute(name: &str, path: &str) -> String {
    if let Some(path) = path.strip_prefix("crate::") {
        return path.to_owned();
    }
    let mut from: Vec<&str> = name.split("::").collect();
    let mut rest = path.trim_start_matches("self::");
    while let Some(path) = rest.strip_prefix("super::") {
        from.pop();
        rest = path;
    }
    from.push(rest);
    from.join("::").trim_start_matches("::").to_owned()
}

fn module(name: &str, code: &str) -> Module {
    let mut module = Module::default();
    let words = code.split_whitespace();
    let text: String = words.flat_map(|word| [word, " "]).collect();
    for (at, _) in text.match_indices("use ") {
        let is_handed_on = text[..at].ends_with("pub ") || text[..at].ends_with(") ");
        let tree = text[at + 4..].split(';').next().unwrap();
        for path in paths(tree).iter().map(|path| absolute(name, path)) {
            let last = path.rsplit("::").next().unwrap().to_owned();
            module.names.insert(last, path.clone());
            module.imports.extend((!is_handed_on).then_some(path));
        }
    }
    let is_part = |letter: char| letter.is_alphanumeric() || letter == '_' || letter == ':';
    let words = text.split(|letter| !is_part(letter));
    let is_path = |word: &&str| {
        let is_inside = word.starts_with("crate::") || word.starts_with("super::");
        is_inside && !word.ends_with("::")
    };
    let paths = words.filter(is_path).map(|word| absolute(name, word));
    module.imports.extend(paths);
    module
}

/// The module that defines the item at `path`: the deepest one on the path, or the one that re-exports its names.
fn definer(modules: &BTreeMap<String, Module>, path: &str, steps: u32) -> String {
    let ends = path.match_indices("::").map(|(at, _)| at);
    let mut ends: Vec<usize> = ends.chain([path.len()]).collect();
    ends.reverse();
    let mut ends = ends.into_iter();
    let Some(end) = ends.find(|end| modules.contains_key(&path[..*end])) else {
        return String::new();
    };
    let below = path[end..].trim_start_matches("::");
    let name = below.split("::").next().unwrap();
    match modules[&path[..end]].names.get(name) {
        Some(from) if steps > 0 => definer(modules, from, steps - 1),
        _ => path[..end].to_owned(),
    }
}

/// A module and those above it use each other freely; no others do, in whatever number of steps.
#[test]
fn no_files_import_each_other() {
    for package in PACKAGES {
        let codes = codes(package);
        let modules = codes.iter().map(|(path, code)| {
            let name = path.trim_end_matches(".rs").replace('/', "::");
            let name = name.trim_end_matches("::mod").to_owned();
            (name.clone(), module(&name, code))
        });
        let modules: BTreeMap<String, Module> = modules.collect();
        let imported = |name: &str| {
            let imports = modules[name].imports.iter();
            let from = imports.map(|path| definer(&modules, path, 8));
            let is_beside = |other: &String| {
                let below =
                    |one: &str, other: &str| format!("{one}::").starts_with(&format!("{other}::"));
                !other.is_empty() && !below(name, other) && !below(other, name)
            };
            from.filter(is_beside).collect::<BTreeSet<String>>()
        };
        let edges = modules.keys().map(|name| (&name[..], imported(name)));
        let edges: BTreeMap<&str, BTreeSet<String>> = edges.collect();
        assert!(edges.values().any(|others| !others.is_empty()), "{package}");
        let comes_back = |start: &&str| {
            let mut reached = BTreeSet::new();
            let mut next: Vec<&str> = vec![start];
            while let Some(name) = next.pop() {
                let others = edges[name].iter().map(|other| &other[..]);
                next.extend(others.filter(|other| reached.insert(*other)));
            }
            reached.contains(*start)
        };
        let circle: Vec<&str> = edges.keys().copied().filter(comes_back).collect();
        assert_eq!(circle, [""; 0], "{package}: each comes back to itself");
    }
}

/// Crates below the library, itself among them, with these options; `None` where cargo cannot tell without a network.
fn crates(options: &[&str]) -> Option<Vec<String>> {
    let asked = "tree --locked --offline -p gearlash -e normal --prefix none";
    let mut cargo = std::process::Command::new(env!("CARGO"));
    cargo.current_dir(env!("CARGO_MANIFEST_DIR"));
    cargo.args(asked.split(' ')).args(options);
    let output = cargo.output().unwrap();
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

/// ARCHITECTURE.md states both numbers.
#[test]
fn the_library_stands_on_few_crates() {
    let (Some(all), Some(least)) = (crates(&[]), crates(&["--no-default-features"])) else {
        return;
    };
    assert!(all.len() < 50, "{}: {all:?}", all.len());
    let named = |name: &str| least.iter().any(|one| one.split(' ').next() == Some(name));
    let named = ["nalgebra", "rayon", "serde"].map(named);
    assert_eq!(named, [true, false, false], "{least:?}");
    let architecture = Path::new(env!("CARGO_MANIFEST_DIR")).join("ARCHITECTURE.md");
    let stated = format!("{} crates, or {} without", all.len(), least.len());
    let architecture = fs::read_to_string(architecture).unwrap();
    assert!(architecture.contains(&stated), "{stated}");
}

/// Tables and drawings know no pair file; `input` alone knows both.
#[test]
fn readers_of_files_stand_on_few_packages() {
    for (name, expected) in READERS {
        let manifest = format!("crates/{name}/Cargo.toml");
        let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join(manifest);
        let manifest = fs::read_to_string(manifest).unwrap();
        let name_of = |line: &str| line.split(['.', ' ']).next().unwrap().to_owned();
        let ours = manifest.lines().filter(|line| line.starts_with("gearlash"));
        let ours: Vec<String> = ours.map(name_of).collect();
        assert_eq!(ours, expected, "crates/{name}");
    }
}

/// The schema of a key is its field: its type, its doc comment, its limits. Cargo builds none of these libraries for tests
/// (`test = false`): one beside the code would never run.
#[test]
fn readers_of_files_have_no_schema_by_hand_and_no_test_beside_their_code() {
    let folders = READERS.map(|(name, _)| format!("crates/{name}/src"));
    for path in folders.iter().flat_map(|folder| sources(folder)) {
        let text = fs::read_to_string(&path).unwrap();
        for unwanted in ["json_schema!", "#[test]"] {
            assert!(!text.contains(unwanted), "{}: {unwanted}", path.display());
        }
    }
}
