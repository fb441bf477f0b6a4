//! Garbled files end in a study or in problems, never in a panic.

use super::*;
use gearlash_files::InputError;
use proptest::prelude::*;

/// Values that programs stumble over, between bars.
const NASTY: &str = "|0|-1|1|2|3|0.0|-0.0|1e-300|1e308|-1e308|1e16|nan|-inf|inf|9223372036854775807|-9223372036854775808|1e999|[]|{}|[[]]|[[1, 1]]|[0]|true|\"\"|\
\"wheel\"|\"single\"|\"datum\"|\"..\"|\"hunting\"|1979-05-27|null|{ teeth = 1 }|{ min = 1, max = 2 }|{ nominal_mm = 75, tolerance_um = 5 }|\
{ nominal_mm = 75, upper_um = -1e308, lower_um = 1 }|\"\u{0}\"|🦷";

#[derive(Debug, Clone)]
enum Outlier {
    /// Deletes a line.
    Delete(prop::sample::Index),
    /// Writes a line twice.
    Double(prop::sample::Index),
    /// Swaps two lines.
    Swap(prop::sample::Index, prop::sample::Index),
    /// Replaces the value of a line.
    Value(prop::sample::Index, &'static str),
    /// Scales the first number of a line's value.
    Scale(prop::sample::Index, f64),
    /// Replaces one character.
    Letter(prop::sample::Index, char),
    /// Cuts the file off.
    Cut(prop::sample::Index),
}

fn slip() -> BoxedStrategy<Outlier> {
    let at = any::<prop::sample::Index>;
    let nasty: Vec<&str> = NASTY.split('|').collect();
    prop_oneof![
        at().prop_map(Outlier::Delete),
        at().prop_map(Outlier::Double),
        (at(), at()).prop_map(|(a, b)| Outlier::Swap(a, b)),
        (at(), prop::sample::select(nasty)).prop_map(|(a, v)| Outlier::Value(a, v)),
        (at(), -3.0..3.0).prop_map(|(a, power)| Outlier::Scale(a, 10f64.powf(power))),
        (at(), any::<char>()).prop_map(|(a, c)| Outlier::Letter(a, c)),
        at().prop_map(Outlier::Cut),
    ]
    .boxed()
}

fn apply(text: &str, slip: &Outlier) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    if lines.is_empty() {
        return String::new();
    }
    let set = |line: &mut String, change: &dyn Fn(&str) -> String| {
        if let Some((key, value)) = line.split_once(['=', ':']) {
            let sign = &line[key.len()..key.len() + 1];
            *line = format!("{key}{sign} {}", change(value));
        }
    };
    match slip {
        Outlier::Delete(at) => {
            lines.remove(at.index(lines.len()));
        }
        Outlier::Double(at) => {
            let at = at.index(lines.len());
            lines.insert(at, lines[at].clone());
        }
        Outlier::Swap(a, b) => {
            let (a, b) = (a.index(lines.len()), b.index(lines.len()));
            lines.swap(a, b);
        }
        Outlier::Value(at, value) => {
            let at = at.index(lines.len());
            set(&mut lines[at], &|old| {
                let comma = if old.trim_end().ends_with(',') {
                    ","
                } else {
                    ""
                };
                format!("{value}{comma}")
            });
        }
        Outlier::Scale(at, factor) => {
            let at = at.index(lines.len());
            set(&mut lines[at], &|old| {
                let number: String = old
                    .chars()
                    .skip_while(|c| !c.is_ascii_digit())
                    .take_while(|c| c.is_ascii_digit() || *c == '.')
                    .collect();
                match number.parse::<f64>() {
                    Ok(value) => old.replacen(&number, &format!("{:?}", value * factor), 1),
                    Err(_) => old.to_owned(),
                }
            });
        }
        Outlier::Letter(at, letter) => {
            let mut letters: Vec<char> = text.chars().collect();
            let at = at.index(letters.len());
            letters[at] = *letter;
            return letters.into_iter().collect();
        }
        Outlier::Cut(at) => {
            return text.chars().take(at.index(text.chars().count())).collect();
        }
    }
    lines.join("\n")
}

/// Good files: both fixtures, a short one, one with every deviation, and two of them as JSON.
fn good(file: usize) -> (&'static str, String) {
    let text = |path: &str| fs::read_to_string(path).unwrap();
    let everything = || text("../../fixtures/reference/lost_motion/everything_1.toml");
    match file {
        0 => ("pair.toml", text("../../fixtures/karba_44x44.toml")),
        1 => ("pair.toml", text("../../fixtures/karba_86x21.toml")),
        2 => ("pair.toml", PAIR.to_owned()),
        3 => ("pair.toml", everything()),
        4 => {
            let value: toml::Table = toml::from_str(&everything()).unwrap();
            ("pair.json", serde_json::to_string(&value).unwrap())
        }
        _ => ("pair.json", format!("{:#}", echo(&study(PAIR)))),
    }
}

/// Reads the files in `folder`; whatever comes out is complete.
fn check(path: &Path) {
    match read(path) {
        Ok(study) => {
            let poses: usize = study
                .study
                .runs()
                .unwrap()
                .iter()
                .map(|run| run.matings.len())
                .sum();
            assert!(poses > 0);
            // The understood content is a good pair file.
            let echo = path.with_file_name("echo.json");
            fs::write(&echo, super::echo(&study).to_string()).unwrap();
            let again = read(&echo).unwrap_or_else(|error| panic!("{error}"));
            assert!(
                again.study.materials == study.study.materials,
                "{:#?}",
                study.spec
            );
            assert_eq!(again.spec, study.spec);
        }
        Err(InputError { problems, .. }) => {
            assert!(!problems.is_empty());
            for problem in problems {
                assert!(
                    !problem.reason.is_empty() && !problem.help.is_empty(),
                    "{problem}"
                );
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_garbled_pair_file(file in 0..6usize, slips in prop::collection::vec(slip(), 1..4)) {
        let (name, text) = good(file);
        let text = slips.iter().fold(text, |text, slip| apply(&text, slip));
        let folder = TempDir::new().unwrap();
        fs::copy("../../fixtures/karba_tables_5_6.csv", folder.path().join("karba_tables_5_6.csv")).unwrap();
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        check(&path);
    }

    #[test]
    fn a_garbled_measured_file(slips in prop::collection::vec(slip(), 1..4)) {
        let text = fs::read_to_string("../../fixtures/karba_tables_5_6.csv").unwrap();
        let text = slips.iter().fold(text, |text, slip| apply(&text, slip));
        let folder = TempDir::new().unwrap();
        fs::write(folder.path().join("karba_tables_5_6.csv"), text).unwrap();
        let path = folder.path().join("pair.toml");
        fs::copy("../../fixtures/karba_44x44.toml", &path).unwrap();
        check(&path);
    }
}
