//! `gearlash import` by itself.

use super::*;

fn text(shop: &Shop, options: &[&str]) -> String {
    let mut command = gearlash(shop.folder.path());
    command.args(["import", shop.name]).args(options);
    let output = command.assert().success().get_output().stdout.clone();
    // It writes nothing else.
    assert_eq!(fs::read_dir(shop.folder.path()).unwrap().count(), 1);
    String::from_utf8(output).unwrap()
}

fn fixture(name: &'static str) -> Shop {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/sheets/");
    Shop::new(name, fs::read(format!("{path}{name}")).unwrap())
}

#[test]
fn a_table_as_text_fits_eighty_columns() {
    let shop = Shop::new(
        "p.csv",
        "Prüfprotokoll;;;;\nZahn;Fp links;fu links;Fp rechts;Datum\n1;0,5;0,1;0,2;12.03.2026\n2;0,7;0,1;0,4;12.03.2026\nMax;0,7;0,1;0,4;\n",
    );
    let text = text(&shop, &["--gear", "pinion"]);
    insta::assert_snapshot!(text);
    // The lines that a shop fills with names are folded on a terminal; in a pipe they are whole.
    assert!(
        text.lines()
            .filter(|line| !line.starts_with("  "))
            .all(|line| line.chars().count() <= 80)
    );
}

/// A protocol has both kinds of pitch, and runout: all are shown.
#[test]
fn a_protocol_as_it_is() {
    let shop = fixture("protocol.txt");
    let found = shop.import(&[]);
    let kinds: Vec<&Value> = found["tables"]
        .as_array()
        .unwrap()
        .iter()
        .map(|table| &table["kind"])
        .collect();
    assert_eq!(kinds, ["pitch", "pitch", "runout"]);
    insta::assert_snapshot!(found["toml"].as_str().unwrap());
}

/// A curve file: all that it has, and what of it no table uses.
#[test]
fn a_curve_file() {
    let shop = fixture("curves.mka");
    let text = text(&shop, &["--gear", "pinion"]);
    for words in [
        "1 lead traces, 20 positions of the probe, 2 profile traces, 2 root diameters",
        "[pinion.profile.trace]\nfile = \"curves.mka\"\n",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
}

/// Each format that the program reads is understood.
#[test]
fn every_format() {
    for (name, kind, column) in [
        ("pitch.csv", "pitch", "right_um"),
        ("pitch_german.csv", "pitch", "right_um"),
        ("pitch.xlsx", "pitch", "right_um"),
        ("runout.csv", "runout", "runout_um"),
        ("spans.csv", "span", "span_mm"),
        ("thickness.csv", "thickness", "thickness_um"),
    ] {
        let found = fixture(name).import(&[]);
        let tables = found["tables"].as_array().unwrap();
        assert_eq!(tables.len(), 1, "{name}");
        assert_eq!(tables[0]["kind"], kind, "{name}");
        let has = |of: &Value| of["name"] == column && of["values"].as_array().unwrap().len() == 44;
        assert!(
            tables[0]["columns"].as_array().unwrap().iter().any(has),
            "{name}"
        );
    }
    let trace = Shop::new("t.csv", "roll_length_mm,deviation_um\n12,-1.5\n18.25,2\n");
    let found = trace.import(&["--gear", "gear"]);
    assert_eq!(found["tables"][0]["kind"], "trace");
    assert_eq!(found["toml"], "[gear.profile.trace]\nfile = \"t.csv\"\n");
}
