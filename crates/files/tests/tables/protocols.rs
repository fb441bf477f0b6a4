//! Protocols with more, fewer and other lines than the good one.

use super::*;

fn good() -> String {
    fs::read_to_string("../../fixtures/sheets/protocol.txt").unwrap()
}

/// The study of a wheel with `keys`, or all problems below the file's name, one a line.
fn read_as(table: &[u8], keys: &str) -> Result<PairFile, String> {
    let message = |problem: &Problem| {
        let message = problem.reason.split("/p.txt: ").last().unwrap();
        format!("{message}; {}", problem.help)
    };
    read_with("p.txt", table, &pair(44, keys))
        .map_err(|problems| problems.iter().map(message).collect::<Vec<_>>().join("\n"))
}

const PITCH: &str = "pitch = { kind = \"single\", file = \"p.txt\" }";
const RUNOUT: &str = "runout = { at = \"space\", file = \"p.txt\" }";

/// The protocol with a row of tooth 45 in its left, its right or both blocks.
fn with_a_row_more(left: bool, right: bool) -> String {
    let text = good();
    let last: Vec<&str> = text
        .lines()
        .filter(|line| line.trim().starts_with("44 "))
        .collect();
    assert_eq!(last.len(), 2);
    let more = "45 0.0 0.0 0.0";
    let mut blocks = text.splitn(3, "Zahnflanke").map(str::to_owned);
    let mut blocks: Vec<String> = (0..3).map(|_| blocks.next().unwrap()).collect();
    for (block, row, wanted) in [(1, last[0], left), (2, last[1], right)] {
        if wanted {
            blocks[block] = blocks[block].replace(row, &format!("{row}\n{more}"));
        }
    }
    blocks.join("Zahnflanke")
}

/// No row is passed over: neither of pitch, in whichever block, nor of runout, whose harmonic is taken over all rows.
#[test]
fn a_row_beyond_the_last_tooth_has_its_line() {
    for (left, right) in [(true, false), (false, true), (true, true)] {
        let text = with_a_row_more(left, right);
        let lines = text.lines().enumerate();
        let lines: Vec<usize> = lines
            .filter(|(_, line)| line.starts_with("45 "))
            .map(|(index, _)| index + 1)
            .collect();
        let message = read_as(text.as_bytes(), PITCH).unwrap_err();
        assert_eq!(message.lines().count(), lines.len(), "{message}");
        for line in lines {
            let expected = format!("line {line}: tooth 45, allowed is 1 … 44; ");
            assert!(message.contains(&expected), "{message}");
        }
    }
    let message = read_as(with_a_row_more(true, true).as_bytes(), RUNOUT).unwrap_err();
    assert!(
        message.contains(": tooth 45, allowed is 1 … 44"),
        "{message}"
    );
}

/// A missing row is named as such, and not as a contradiction of its neighbours.
#[test]
fn a_missing_row_is_named() {
    for tooth in [1, 7, 44] {
        let text = good();
        let begins = format!("{tooth} ");
        let row = text
            .lines()
            .find(|line| {
                line.trim().starts_with(&begins) && line.contains('.') && !line.contains(':')
            })
            .unwrap();
        let table = text.replacen(&format!("{row}\n"), "", 1);
        let message = read_as(table.as_bytes(), PITCH).unwrap_err();
        assert!(
            message.contains(&format!("the table ends here without tooth {tooth};")),
            "{message}"
        );
        assert_eq!(message.lines().count(), 1, "{message}");
    }
    // A head of the next page ends the block.
    let text = good();
    let row = text
        .lines()
        .find(|line| line.trim().starts_with("7 "))
        .unwrap();
    let table = text.replacen(row, &format!("\nSeite 2\n{row}"), 1);
    let message = read_as(table.as_bytes(), PITCH).unwrap_err();
    assert!(message.contains("without teeth 7, 8, 9, "), "{message}");
}

/// Header lines with and without colon, dots and unit, in the code pages of old machines.
#[test]
fn a_header_that_contradicts_the_pair_file() {
    let teeth = "  22 :Zähnezahl...........................: 44";
    let text = good();
    assert!(text.contains(teeth));
    for line in [
        "22 Zähnezahl 45",
        "22 Zaehnezahl........... 45",
        "  22 :Zaehnezahl: 45",
        "21 Normalmodul 2.5",
        "21 Normalmodul [mm] 2.5",
        "21 :Normalmodul.......: 2.5 mm",
        "24 Eingriffswinkel....: 17.5 Grad",
        "27 Kopfkreisdurchmesser 137.0 mm",
    ] {
        let message = read_as(text.replace(teeth, line).as_bytes(), PITCH).unwrap_err();
        assert!(
            message.contains(", the pair file has "),
            "{line}: {message}"
        );
    }
    for (line, expected) in [
        (
            "23 Schraegungswinkel 15.0",
            "Schraegungswinkel is 15, the pair file has helix_angle_deg = 0",
        ),
        (
            "  23 :Schrägungswinkel....[Grad]: -15.0",
            "Schrägungswinkel is 15, the pair file has helix_angle_deg = 0",
        ),
        ("  22 :Zähnezahl: -44", "the gear is internal"),
        (
            "  22 :Zähnezahl: 44 Innenverzahnung",
            "the gear is internal",
        ),
    ] {
        let message = read_as(text.replace(teeth, line).as_bytes(), PITCH).unwrap_err();
        assert!(message.contains(expected), "{line}: {message}");
    }
    // ä is 0x84 in code page 850 and 0x8A in Mac Roman.
    for strange in [0x84, 0x8a] {
        for (label, value, expected) in [
            ("Zähnezahl", "45", ", the pair file has "),
            (
                "Schrägungswinkel",
                "15.0",
                ", the pair file has helix_angle_deg = 0",
            ),
        ] {
            let line = format!("22 :{label}....: {value}");
            let bytes: Vec<u8> = text
                .replace(teeth, &line)
                .chars()
                .map(|letter| {
                    if letter == 'ä' {
                        strange
                    } else {
                        letter as u8
                    }
                })
                .collect();
            let message = read_as(&bytes, PITCH).unwrap_err();
            assert!(message.contains(expected), "{label}: {message}");
        }
    }
    for line in [
        "22 Zähnezahl 44",
        "21 Normalmodul [mm] 3.000",
        "27 Kopfkreis 138.00 mm",
        "23 :Schrägungswinkel (R/L)....: 0.0000 Grad",
        "22 :Zähnezahl (bei Innenverzahnung negativ)....: 44",
    ] {
        read_as(text.replace(teeth, line).as_bytes(), PITCH).unwrap();
    }
}

/// A line with the number of a known one is not passed over in silence.
#[test]
fn a_header_line_that_is_not_understood() {
    let text = good().replace("22 :Zähnezahl", "22 :Number of teeth");
    let study = read_as(text.as_bytes(), PITCH).unwrap();
    assert!(
        study.warnings.iter().any(|warning| {
            warning.starts_with("wheel.pitch.file: p.txt: line 4 has the number of Zähnezahl")
        }),
        "{:#?}",
        study.warnings
    );
    // Rows of another list are none.
    let header = format!("  22  0.4  1.5\n{}", good());
    let study = read_as(header.as_bytes(), PITCH).unwrap();
    assert_eq!(study.warnings, Vec::<String>::new());
}

/// `fu` is contained in the others; a unit may stand behind a name.
#[test]
fn columns_that_are_not_needed() {
    let expected = read_as(good().as_bytes(), PITCH).unwrap();
    let row = |line: &str| {
        let line = line.replace("fp      Fp      Fr", "fp[µm]  Fp[µm]  Fr  fu");
        let number = line.trim().starts_with(|c: char| c.is_ascii_digit());
        if number && !line.contains(':') {
            format!("{line} 0.0\n")
        } else {
            format!("{line}\n")
        }
    };
    let text: String = good().lines().map(row).collect();
    let found = read_as(text.as_bytes(), PITCH).unwrap();
    assert_eq!(
        echoed(&found, "pitch", "left_um"),
        echoed(&expected, "pitch", "left_um")
    );
}
