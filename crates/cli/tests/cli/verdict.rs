//! The verdict of the whole mesh cycle in every command.

use super::*;

/// 51/23, m 2, allowances −90/−60 and −70/−45 µm, runout 30 (tooth 10) and 22 µm (tooth 4), a = 73.877 mm: one wheel revolution is
/// clear by 5.059 µm, the hunting cycle is not.
fn hunting() -> PathBuf {
    fixture("hunting_51x23.toml")
}

fn text(output: &[u8]) -> String {
    String::from_utf8_lossy(output).into_owned()
}

/// The verdict on it. The least and the teeth are issue 14's, found by the report's sweep of the cycle; the proof is the library's.
const VERDICT: &str = "\
Does not assemble at a = 73.877 mm, most material. Proven for 1173 matings.
  least      −2.61 µm   teeth 9·4 / 10·4      most material
  greatest   89.62 µm   teeth 35·15 / 35·16   least material
  Assembles from a = 73.8807 mm";

#[test]
fn every_command_says_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let file = hunting();
    let said = |args: &[&str]| -> String {
        let output = gearlash(folder.path())
            .args(args)
            .arg(&file)
            .output()
            .unwrap();
        text(&output.stdout) + &text(&output.stderr)
    };
    let commands: [&[&str]; 8] = [
        &["simulate"],
        &["check"],
        &["compare"],
        &["chart", "--kind", "revolution"],
        &["snapshot", "--worst"],
        &["check", "--format", "markdown"],
        &["check", "--format", "junit"],
        &["check", "--format", "github"],
    ];
    for args in commands {
        let said = said(args).replace("%0A", "\n");
        assert!(said.contains(VERDICT), "{args:?}: {said}");
    }
    said(&["report"]);
    let page = std::fs::read_to_string(folder.path().join("out/hunting_51x23.html")).unwrap();
    let page = scraper::Html::parse_document(&page);
    let selector = scraper::Selector::parse("#result .verdict").unwrap();
    let words: String = page.select(&selector).next().unwrap().text().collect();
    let facts = [
        "Does not assemble at a = 73.877 mm, most material.",
        "−2.61 µm",
        "teeth 9·4 / 10·4, most material",
        "89.62 µm",
        "Assembles from a = 73.8807 mm",
        "Proven for 1173 matings.",
    ];
    for fact in facts {
        assert!(words.contains(fact), "{fact}: {words}");
    }
}

/// Without high teeth the least is over every direction of both runouts: no more than of the teeth that were stated.
#[test]
fn a_runout_without_direction_is_taken_in_every_one() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pair.toml");
    let pair = std::fs::read_to_string(hunting()).unwrap();
    let lines = pair.lines().filter(|line| !line.starts_with("high_tooth"));
    std::fs::write(&file, lines.collect::<Vec<_>>().join("\n")).unwrap();
    let output = gearlash(folder.path())
        .args(["simulate", "--format", "json", "--verbose"])
        .arg(&file)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let message = text(&output.stderr);
    for gear in ["wheel", "pinion"] {
        assert!(message.contains(&format!("{gear}.runout:")), "{message}");
    }
    let quiet = gearlash(folder.path()).arg("check").arg(&file).output();
    assert_eq!(text(&quiet.unwrap().stderr), "", "notes without --verbose");
    let json: Value = serde_json::from_slice(&output.stdout).unwrap();
    let words = json["verdict"]["text"].as_str().unwrap();
    assert!(
        words.contains("Proven for 1173 matings") && words.contains("high points in mesh"),
        "{words}"
    );
    for run in json["extremes"].as_array().unwrap() {
        for end in ["least", "greatest"] {
            let teeth = &run[end]["high_tooth"];
            let [wheel, pinion] = ["wheel", "pinion"].map(|gear| teeth[gear].as_f64().unwrap());
            assert!((1.0..52.0).contains(&wheel) && (1.0..24.0).contains(&pinion));
        }
    }
    let least = json["extremes"][0]["least"]["j_wt_um"][1].as_f64().unwrap();
    assert!(least < -2.61 && least > -2.7, "{least}");
}

/// The check's zero-backlash distance, found to 1e-10 mm by another search, is where the verdict says that the pair assembles: jammed as
/// it stands, and with runouts of any direction.
#[test]
fn check_and_verdict_have_one_zero_backlash_distance() {
    let hunting = std::fs::read_to_string(hunting()).unwrap();
    let open = hunting
        .lines()
        .filter(|line| !line.starts_with("high_tooth"));
    let open = open.collect::<Vec<_>>().join("\n");
    let jammed = hunting.replace("73.877", "71.6");
    for (pair, status) in [(open, "interference"), (jammed, "jammed")] {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("pair.toml");
        std::fs::write(&file, pair).unwrap();
        let output = gearlash(folder.path())
            .args(["check", "--format", "json"])
            .arg(&file)
            .output()
            .unwrap();
        let json: Value = serde_json::from_slice(&output.stdout).unwrap();
        let json = &json["files"][0];
        let most = &json["extremes"][0];
        assert_eq!(most["status"], status);
        let from = &most["assembles_from_mm"];
        let [low, high] = [0, 1].map(|k| from[k].as_f64().unwrap());
        let checks = json["checks"].as_array().unwrap().iter();
        let mut zero = checks.filter(|check| check["id"] == "zero_backlash_distance");
        let zero = zero.find(|check| check["material"] == "most").unwrap();
        let found = zero["outlines"].as_f64().unwrap();
        assert!(found > low - 1e-6 && found < high + 1e-6, "{found} {from}");
    }
}

/// At a distance at which tips pass, the verdict states up to where the pair is in mesh.
#[test]
fn out_of_mesh_says_up_to_where_it_is_in_mesh() {
    let folder = tempfile::tempdir().unwrap();
    let said = |distance: &str| {
        let file = folder.path().join("pair.toml");
        let pair = std::fs::read_to_string(hunting()).unwrap();
        std::fs::write(&file, pair.replace("73.877", distance)).unwrap();
        let output = gearlash(folder.path()).arg("simulate").arg(&file).output();
        text(&output.unwrap().stdout).replace('\n', " ")
    };
    let message = said("78.5");
    assert!(
        message.contains("Out of mesh at a = 78.500 mm.") && !message.contains("Proven"),
        "{message}"
    );
    let (_, rest) = message.split_once("In mesh up to a = ").unwrap();
    let to: f64 = rest.split_once(" mm").unwrap().0.parse().unwrap();
    // Poses between those that were looked at leave up to 0.5 µm sooner: it is not proven.
    assert!(!said(&(to - 1e-3).to_string()).contains("Out of mesh"));
    // A verdict that says "not proven" of a distance does not say "proven" of the whole.
    assert!(
        rest.starts_with(&format!("{to:.4} mm (not proven)")),
        "{message}"
    );
    let mixed = said("[73.8, 73.9, 78.5]");
    assert!(
        mixed.contains("Does not assemble at 1 of 3 distances (a = 73.800 mm)."),
        "{mixed}"
    );
    for words in ["Assembles from a = 73.8807 mm", "In mesh up to a = "] {
        assert!(mixed.contains(words), "{words}: {mixed}");
    }
    // A bracket is 1e-5 mm, and the last digit is cut off.
    assert!(said(&(to + 1.2e-4).to_string()).contains("Out of mesh"));
}

#[test]
fn junit_has_what_was_noticed_as_output() {
    let folder = tempfile::tempdir().unwrap();
    let assert = gearlash(folder.path())
        .args(["check", "--format", "junit"])
        .arg(fixture("profiled_44x44.toml"))
        .assert();
    let junit = text(&assert.get_output().stdout);
    let document = roxmltree::Document::parse(&junit).unwrap();
    let mut nodes = document.descendants();
    let output = nodes.find(|node| node.has_tag_name("system-out"));
    let message = output.and_then(|output| output.text()).unwrap();
    assert!(
        message.contains("traces of 4 of 44 right flanks"),
        "{message}"
    );
}

/// The corpus holds the verdicts of some sixty pairs: spur, helical, drawn, jammed, out of mesh.
#[test]
fn every_verdict_of_the_corpus_has_six_short_lines_at_most() {
    let expected = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus/expected");
    let mut count = 0;
    for entry in std::fs::read_dir(expected).unwrap() {
        let path = entry.unwrap().path();
        let Ok(stored) = std::fs::read_to_string(&path) else {
            continue;
        };
        for line in stored.lines() {
            let Some((_, verdict)) = line.split_once("verdict.text = ") else {
                continue;
            };
            let verdict: String = serde_json::from_str(verdict).unwrap();
            count += 1;
            assert!(verdict.lines().count() <= 6, "{path:?}: {verdict}");
            for line in verdict.lines() {
                assert!(line.chars().count() <= 80, "{path:?}: {line}");
            }
        }
    }
    assert!(count >= 60, "{count}");
}
