//! Plausible tables of which a careless reader would take the wrong column or the wrong line.

use super::*;

/// What `gearlash import` says of a text with these options: its output, or its errors.
fn import(text: &str, options: &[&str]) -> Result<String, String> {
    let shop = Shop::new("p.csv", text);
    let mut command = gearlash(shop.folder.path());
    let output = command
        .args(["import", "p.csv"])
        .args(options)
        .output()
        .unwrap();
    let said = |bytes| String::from_utf8(bytes).unwrap();
    match output.status.code() {
        Some(0) => Ok(said(output.stdout)),
        Some(2) => Err(said(output.stderr)),
        code => panic!("{code:?}"),
    }
}

fn refused(text: &str, options: &[&str], words: &str) {
    let told = import(text, options).unwrap_err();
    assert!(told.contains(words), "{told}");
}

const SINGLE: &str = "Zahn;fp links;fp rechts\n1;1,0;2,0\n2;-1,0;-2,0\n";

/// Columns that the user names are held against what their headings say.
#[test]
fn a_named_column_is_what_its_heading_says() {
    let twice = ["--only", "pitch", "--left", "B", "--right", "B"];
    refused(SINGLE, &twice, "says something else than right");
    let exchanged = [
        "--only",
        "pitch",
        "--left",
        "fp rechts",
        "--right",
        "fp links",
    ];
    refused(SINGLE, &exchanged, "reference_face");
    let runout = ["--only", "runout", "--column", "fp links"];
    refused(SINGLE, &runout, "says something else than runout");
    let unknown = "Zahn;u;v\n1;1,0;2,0\n2;-1,0;-2,0\n";
    refused(unknown, &twice, "is read as right and as left");
    let tooth = ["--only", "runout", "--tooth-column", "A", "--column", "A"];
    refused(
        "x;y\n1;5,0\n2;6,0\n",
        &tooth,
        "is read as tooth and as runout",
    );
    let named = ["--only", "pitch", "--left", "B", "--right", "C"];
    assert!(import(unknown, &named).is_ok());
}

/// `FR` may be the right flank: no runout.
#[test]
fn capitals_are_no_runout() {
    refused("Zahn;FL;FR\n1;1,0;2,0\n2;-1,0;-2,0\n", &[], "no line names");
    assert!(import("Zahn;Fr\n1;1,0\n2;3,0\n", &[]).is_ok());
}

/// A header of two lines is one of one kind of pitch only.
#[test]
fn two_lines_are_one_header() {
    for (below, kind) in [("Nr.;fp;fp", "single"), ("Nr.;Fp;Fp", "cumulative")] {
        let text = format!("Zahn;Linke Flanke;Rechte Flanke\n{below}\n1;1,0;2,0\n2;-1,0;-2,0\n");
        let found = import(&text, &[]).unwrap();
        assert!(found.contains("header in line 2"), "{found}");
        assert!(found.contains(&format!("kind = \"{kind}\"")), "{found}");
    }
}

/// Two columns of which either may be the runout do not hide the pitch; where they hold the same, it is read.
#[test]
fn what_is_ambiguous_hides_nothing_else() {
    let book = |right: &str| {
        format!(
            "Zahn;Fp links;Fp rechts;Fr links;Fr rechts\n1;0,5;0,2;4,0;{right}\n2;0,0;0,0;6,0;6,0\n"
        )
    };
    let found = import(&book("5,0"), &[]).unwrap();
    assert!(found.contains("Cumulative pitch") && !found.contains("runout_um"));
    assert!(
        found.contains("Not read: line 1: 2 columns may be runout"),
        "{found}"
    );
    let same = import(&book("4,0"), &[]).unwrap();
    assert!(same.contains("runout_um"), "{same}");
    let units = "Zahn;Zahndicke Abweichung (µm);Zahndicke (mm)\n1;1,0;4,630\n2;-1,0;4,628\n";
    let found = import(units, &[]).unwrap();
    assert!(
        found.contains("thickness_um = \"Zahndicke Abweichung (µm)\" (B)"),
        "{found}"
    );
}

/// Footers: dates, words with numbers, and labels of the deviation itself.
#[test]
fn footers_are_no_teeth() {
    for footer in [
        "12.03.2024;;",
        "Toleranz Klasse 6;;",
        "fp max;1,0;2,0",
        "Klasse 6;4,0;4,0",
        "σ (n−1);0,5;0,6",
        "Fp;3,0;4,0",
    ] {
        let found = import(&format!("{SINGLE}{footer}\n"), &[]).unwrap();
        assert!(found.contains("left out: line 4 (\""), "{footer}: {found}");
    }
    // A row that lost its separators, or its tooth, is none.
    refused(&format!("{SINGLE}31,02,0\n"), &[], "line 4");
    refused(
        &format!("{SINGLE};1,0;2,0\n"),
        &[],
        "where its first cell says so",
    );
}

/// Blocks one below the other are not read, and told so.
#[test]
fn stacked_blocks_are_reported() {
    let text = "linke Flanke;\nZahn;fp links\n1;1,0\n2;-1,0\nrechte Flanke;\nZahn;fp rechts\n1;2,0\n2;-2,0\n";
    refused(text, &[], "line 6: names columns again, as line 2 does");
}

/// A table without headings, and one whose headings hold the other separator: letters say what is where.
#[test]
fn letters_are_enough() {
    let rows = "1;-4,4;3,1\n2;4,4;-3,1\n";
    let letters = [
        "--only",
        "pitch",
        "--tooth-column",
        "A",
        "--left",
        "B",
        "--right",
        "C",
    ];
    let with = |row| [&letters[..], &["--header-row", row]].concat();
    let found = import(rows, &with("0")).unwrap();
    assert!(found.contains("right_um = C, left_um = B"), "{found}");
    assert!(
        found.contains("2 rows, no header") && found.contains("1       3.1     -4.4"),
        "{found}"
    );
    let headed = format!("Nr;fp links, µm;fp rechts, µm\n{rows}");
    for options in [&with("1")[..], &["--only", "pitch"]] {
        let found = import(&headed, options).unwrap();
        assert!(found.contains("header in line 1"), "{found}");
    }
}

/// Whole thicknesses in mm where deviations in µm are asked for.
#[test]
fn whole_lengths_are_doubted() {
    let value = |tooth: u32| format!("{tooth},4.71{}\n", tooth % 10);
    let table: String = (1..=TEETH).map(value).collect();
    let shop = Shop::new("p.csv", format!("tooth,thickness (µm)\n{table}"));
    let keys = "thickness.per_tooth_um = { file = \"p.csv\" }";
    let (_, told) = shop.check(keys, "").unwrap();
    assert!(
        told.contains("what the thickness itself is in mm"),
        "{told}"
    );
}
