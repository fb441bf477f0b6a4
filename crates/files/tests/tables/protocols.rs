//! Protocols in other code pages and with other columns than the good one.

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

/// Header lines in the code pages of old machines. `tests/sessions/table_faults.txt` holds the others.
#[test]
fn a_header_that_contradicts_the_pair_file() {
    let teeth = "  22 :Zähnezahl...........................: 44";
    let text = good();
    assert!(text.contains(teeth));
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
