//! `gearlash import` of files of a P40.

use super::made::{MEW, Made};
use gearlash_files::import::{Imported, Kind, Options, tables};
use std::path::Path;

fn import(text: &str, only: Option<Kind>) -> Result<Imported, String> {
    let options = Options {
        only,
        keys: &[],
        gear: "wheel",
    };
    let found = tables(Path::new("gear.mka"), text.as_bytes().to_vec(), &options);
    found.map_err(|error| {
        let message = error
            .problems
            .iter()
            .map(|problem| format!("{}; {}\n", problem.reason, problem.help));
        message.collect()
    })
}

/// Every table, with the parts it leaves unused.
#[test]
fn all_that_a_curve_file_has() {
    let found = import(&Made::new(17).text(), None).unwrap();
    let kinds: Vec<Kind> = found.tables.iter().map(|table| table.kind).collect();
    assert_eq!(kinds, [Kind::Pitch, Kind::Pitch, Kind::Runout, Kind::Trace]);
    for table in &found.tables {
        let words = table.left_out.as_deref().unwrap();
        for name in [
            "1 lead traces",
            "1 twist traces",
            "2 root diameters",
            "2 tip diameters",
            "36 positions of the probe",
        ] {
            assert!(words.contains(name), "{words}");
        }
    }
    assert!(!found.toml.contains("thickness"), "{}", found.toml);
}

/// A pair file accepts the offered lines as they stand, and with the runout completed.
#[test]
fn the_lines_are_good() {
    let made = Made::new(17);
    let toml = import(&made.text(), None).unwrap().toml;
    let completed = toml
        .replace("# [wheel.runout]\n# file", "[wheel.runout]\nfile")
        .replace("# at = …", "at = \"space\"");
    assert_ne!(completed, toml);
    for keys in [toml, completed] {
        let good = super::read_with(made.text().as_bytes(), &super::pair(17, &keys));
        assert!(good.is_ok(), "{keys}: {:#?}", good.err());
    }
}

/// Thickness is stated, not taken from positions.
#[test]
fn positions_alone() {
    let text = Made::new(17).text();
    let (head, rest) = text.split_once("Flankenlinie:").unwrap();
    let positions = rest.split_once("Teilung:").unwrap().1;
    let alone = format!("{head}Teilung:{positions}");
    let message = import(&alone, None).unwrap_err();
    assert!(message.contains("has no pitch"), "{message}");
    let message = import(&alone, Some(Kind::Thickness)).unwrap_err();
    assert!(
        message.contains("is a curve file: thickness is not taken from the probe's positions"),
        "{message}"
    );
}

#[test]
fn a_value_file() {
    for only in [None, Some(Kind::Pitch), Some(Kind::Trace)] {
        let message = import(MEW, only).unwrap_err();
        assert!(message.contains("is a value file (.mew)"), "{message}");
        assert!(!message.contains("--header-row"), "{message}");
    }
}

/// The header says how many teeth there are: the last one that is missing is reported, as any other.
#[test]
fn a_tooth_that_is_missing() {
    let text = Made::new(17).text();
    for tooth in [7, 17] {
        let begin = format!("  {tooth}  ");
        let is_row = |line: &&str| line.starts_with(&begin) && line.split_whitespace().count() == 4;
        let lines: Vec<&str> = text.lines().filter(|line| !is_row(line)).collect();
        let message = import(&lines.join("\r\n"), None).unwrap_err();
        assert!(
            message.contains(&format!("without tooth {tooth}")),
            "{message}"
        );
        assert!(message.contains("give all 17 teeth"), "{message}");
        // That the neighbours do not fit follows from it.
        assert!(
            !message.contains("differ by more than their rounding"),
            "{message}"
        );
    }
}

#[test]
fn gears_of_other_kinds() {
    let text = Made::new(17).text();
    let message = import(&text.replace("Außenverzahnung", "Innenverzahnung"), None).unwrap_err();
    assert!(message.contains("the gear is internal"), "{message}");
    let helix = " 26 :Schrägungswinkel.......: 15.0\r\n 24 :Eingriffswinkel";
    let helical = text.replace(" 24 :Eingriffswinkel", helix);
    assert!(import(&helical, Some(Kind::Pitch)).is_ok());
    // Its traces are of a spur gear's base circle, and the wound gear's is larger.
    let message = import(&helical, None).unwrap_err();
    assert!(
        message.contains("from the base circle on, 49.4079 mm"),
        "{message}"
    );
}

/// Lead traces: offered with the face width, read as the numbers of a list, with a warning of what the format leaves open. Values without a face width are
/// counted alone, and a second trace of one flank is reported.
#[test]
fn lead_traces() {
    let trace = "Zahn-Nr.: 3 rechts / 5  Werte  x= 8.742\n 0.0 1.0 -2147483.648 3.0 .5\n";
    let text = Made::new(17).text().replace("\r\n", "\n");
    let text = text.replace(
        " 24 :Eingriffswinkel",
        " 26 :Zahnbreite b.......[mm]..: 20.000\n 24 :Eingriffswinkel",
    );
    let text = text.replace("Verschränkung:\n", &format!("{trace}Verschränkung:\n"));
    let found = import(&text, Some(Kind::Lead)).unwrap();
    assert_eq!(found.toml, "[wheel.lead.trace]\nfile = \"gear.mka\"\n");
    assert_eq!(found.tables[0].rows(), 20 + 4);
    let words = found.tables[0].left_out.as_deref().unwrap();
    assert!(words.contains("over the face width, 20 mm"), "{words}");
    let point = |right: &str| {
        let keys = format!(
            "face_width_mm = 20\nlead = {{ axis = \"own\", zero_mm = 10, right = {{ {right} }} }}"
        );
        let pinion = "[pinion]\nface_width_mm = 20";
        super::pair(17, &keys).replace("[pinion]", pinion)
    };
    let alone = text.replace(
        "Zahn-Nr.: 2 links / 20  Werte  x= 8.742",
        "Zahn-Nr.: 3b links / 20  Werte  x= 8.742",
    );
    let both = super::pair(17, "face_width_mm = 20\nlead = { axis = \"own\", zero_mm = 10, trace = { file = \"gear.mka\" } }")
        .replace("[pinion]", "[pinion]\nface_width_mm = 20");
    let read =
        super::read_with(alone.as_bytes(), &both).unwrap_or_else(|error| panic!("{error:#?}"));
    let list = point(
        "trace = { tooth = 3, from_reference_face_mm = [0, 5, 15, 20], deviation_um = [0, 1, 3, 0.5] }",
    );
    let listed = super::read_with(b"", &list).unwrap();
    let [read_lead, listed_lead] = [&read, &listed].map(|file| {
        let wheel = file.spec.wheel.data().unwrap();
        wheel.lead.as_ref().unwrap()
    });
    assert_eq!(read_lead.flanks, listed_lead.flanks);
    let open = "which sign is more material; compare with the printed chart";
    assert!(read.warnings.concat().contains(open), "{:?}", read.warnings);
    assert!(!listed.warnings.concat().contains(open));
    let without = text.replace("Zahnbreite", "Breite");
    assert!(
        import(&without, Some(Kind::Lead))
            .unwrap_err()
            .contains("no header line Zahnbreite")
    );
    let twice = text.replace(trace, &trace.repeat(2));
    let message = import(&twice, None).unwrap_err();
    assert!(
        message.contains("the lead of tooth 3, right flank, stands in line"),
        "{message}"
    );
}
