//! A workbook of 10 000 rows with one mistake in its cells or in its bytes.

use super::*;
use formats::{others, pitch_lists, tenths};
use mutant::{Choice, mutant};
use mutations::{OF_THE_WORKBOOK, check};
use written_book::Cell::{Flag, Nothing, Number, Text};
use written_book::{Cell, Cells, written};

const TEETH: u32 = 10_000;
const KEYS: &str = "pitch = { kind = \"cumulative\", file = \"p.xlsx\" }";

fn good() -> Cells {
    let header = ["tooth", "left (µm)", "right (µm)"].map(|name| Text(name.to_owned()));
    let row = |tooth: u32| vec![f64::from(tooth), tenths(tooth), others(tooth)];
    let rows = (1..=TEETH).map(|tooth| row(tooth).into_iter().map(Number).collect());
    [header.to_vec()].into_iter().chain(rows).collect()
}

/// Right and left of every tooth; `None` unless each tooth has one row of numbers below the header.
fn right(cells: &Cells) -> Option<Vec<Vec<f64>>> {
    let place = |name| {
        let is = |cell: &Cell| matches!(cell, Text(text) if text.starts_with(name));
        cells.first()?.iter().position(is)
    };
    let places = [place("tooth")?, place("right")?, place("left")?];
    let mut found = vec![None; TEETH as usize];
    for row in cells.iter().skip(1) {
        if row.iter().all(|cell| matches!(cell, Nothing)) {
            continue;
        }
        let numbers = places.map(|place| match row.get(place) {
            Some(Number(number)) => Some(*number),
            // A text that is typed by mistake.
            Some(Text(text)) if text == "0,5" => Some(0.5),
            Some(Text(text)) if text == "7" => Some(7.0),
            _ => None,
        });
        let [Some(tooth), Some(right), Some(left)] = numbers else {
            return None;
        };
        let index = (1..=TEETH).position(|known| f64::from(known) == tooth)?;
        if row.len() > 3 || found[index].replace([right, left]).is_some() {
            return None;
        }
    }
    let found: Vec<[f64; 2]> = found.into_iter().collect::<Option<_>>()?;
    Some(
        [0, 1]
            .map(|flank| found.iter().map(|values| values[flank]).collect())
            .to_vec(),
    )
}

/// One mistake in a cell, a row or the header.
fn mistake(cells: &mut Cells, choice: &mut Choice) {
    let (a, b) = (choice.below(cells.len()), choice.below(cells.len()));
    let column = choice.below(3);
    let mut wrong = vec![Nothing];
    wrong.extend([0.0, 7.0, 1.5, -3.0, 2e7, 1e300].map(Number));
    wrong.extend(["0,5", "7", "nan", " ", "left"].map(|text| Text(text.to_owned())));
    wrong.push(Flag(true));
    let content = wrong[choice.below(wrong.len())].clone();
    match choice.below(9) {
        0 => {
            cells.remove(a);
        }
        1 => cells.insert(b, cells[a].clone()),
        2 => cells.swap(a, b),
        3 => cells.insert(a, Vec::new()),
        4 => cells[a].insert(column, content),
        5 => cells[a].swap(column, (column + 1) % 3),
        6 => cells[0][column] = content,
        7 => cells.truncate(a + 1),
        _ => cells[a][column] = content,
    }
}

fn read_workbook(bytes: &[u8]) -> Result<PairFile, Vec<Problem>> {
    read_with("p.xlsx", bytes, &pair(TEETH, KEYS))
}

#[test]
fn garbled_cells_among_ten_thousand_rows() {
    let good = good();
    let study = read_workbook(&written(&good)).unwrap();
    assert_eq!(Some(pitch_lists(&study)), right(&good));
    let mut choice = Choice(10);
    let (mut errors, mut same) = (0, 0);
    for number in 0..24 {
        let mut cells = good.clone();
        mistake(&mut cells, &mut choice);
        let expected = right(&cells);
        match read_workbook(&written(&cells)) {
            Ok(study) => {
                assert_eq!(Some(pitch_lists(&study)), expected, "{number}");
                same += 1;
            }
            Err(problems) => {
                for problem in problems {
                    check("p.xlsx", OF_THE_WORKBOOK, &problem, expected.is_some());
                }
                errors += 1;
            }
        }
    }
    assert!(errors > 8 && same > 1, "{errors} errors, {same} right");
}

/// A zip archive checks itself: garbled bytes are an error, or the data are as before.
#[test]
fn garbled_bytes_of_ten_thousand_rows() {
    let cells = good();
    let good = written(&cells);
    let mut choice = Choice(11);
    let mut errors = 0;
    for number in 0..100 {
        match read_workbook(&mutant(&good, &mut choice)) {
            Ok(study) => assert_eq!(Some(pitch_lists(&study)), right(&cells), "{number}"),
            Err(problems) => {
                for problem in problems {
                    check("p.xlsx", OF_THE_WORKBOOK, &problem, false);
                }
                errors += 1;
            }
        }
    }
    assert!(errors > 50, "{errors}");
}
