//! Ten thousand workbooks as a shop writes them, each with one mistake: titles, groups, units, dates, statistics, texts for numbers.

use super::*;
use formats::{others, pitch_lists, tenths};
use mutant::{Choice, count};
use mutations::{OF_THE_WORKBOOK, check};
use written_book::Cell::{Nothing, Number, Text};
use written_book::{Cell, Cells, written};

const TEETH: u32 = 17;
const KEYS: &str = "pitch = { kind = \"cumulative\", file = \"p.xlsx\" }";

fn texts(words: &[&str]) -> Vec<Cell> {
    let cell = |word: &&str| match *word {
        "" => Nothing,
        word => Text(word.to_owned()),
    };
    words.iter().map(cell).collect()
}

fn good() -> Cells {
    let mut cells = vec![
        texts(&["Prüfprotokoll 4711"]),
        Vec::new(),
        texts(&["", "Linke Flanke", "", "", "Rechte Flanke"]),
        texts(&["Zahn-Nr.", "fp", "Fp", "fu", "fp", "Fp", "fu", "Datum"]),
        texts(&["-", "µm", "µm", "µm", "µm", "µm", "µm"]),
    ];
    for tooth in 1..=TEETH {
        let text = format!("{:.1}", tenths(tooth)).replace('.', ",");
        let mut row = vec![Number(f64::from(tooth)), Number(0.1), Text(text)];
        row.extend([0.2, 0.3, others(tooth), 0.4].map(Number));
        row.push(Text("12.03.2026".to_owned()));
        cells.push(row);
    }
    cells.push(Vec::new());
    for label in ["Max", "Min", "Mittelwert"] {
        let numbers = [0.1, 1.5, 0.2, 0.3, 1.7, 0.4].map(Number);
        cells.push([&texts(&[label])[..], &numbers].concat());
    }
    cells
}

/// Right and left `Fp` by the test's own reading: those of the left flank stand first.
fn right(cells: &Cells) -> Option<Vec<Vec<f64>>> {
    let is = |cell: &Cell, word: &str| *cell == Text(word.to_owned());
    // A copy of the header among titles or signatures is no matter.
    let is_head = |at: &usize| cells[*at].iter().any(|cell| is(cell, "Zahn-Nr."));
    let mut heads = (0..cells.len()).filter(is_head);
    heads.find_map(|head| below(cells, head))
}

/// The values in the rows below the line `head`.
fn below(cells: &Cells, head: usize) -> Option<Vec<Vec<f64>>> {
    let is = |cell: &Cell, word: &str| *cell == Text(word.to_owned());
    let tooth = cells[head].iter().position(|cell| is(cell, "Zahn-Nr."))?;
    let places = (0..cells[head].len()).filter(|place| is(&cells[head][*place], "Fp"));
    let [left, right]: [usize; 2] = places.collect::<Vec<_>>().try_into().ok()?;
    let number = |row: &[Cell], place: usize| match row.get(place) {
        Some(Number(number)) => Some(*number),
        Some(Text(text)) => text
            .replace(',', ".")
            .parse()
            .ok()
            .filter(|number: &f64| number.is_finite()),
        _ => None,
    };
    let left_out = |row: &Vec<Cell>| match row.iter().find(|cell| **cell != Nothing) {
        None => true,
        Some(Text(text)) => {
            text.starts_with('#')
                || ["Max", "Min", "Mittelwert", "-", "µm", "fp", "Fp"].contains(&text.as_str())
        }
        Some(_) => false,
    };
    let mut rows: Vec<&Vec<Cell>> = cells[head + 1..]
        .iter()
        .filter(|row| !left_out(row))
        .collect();
    // Words follow the last row.
    let is_words = |row: &Vec<Cell>| match row.get(tooth).unwrap_or(&Nothing) {
        Nothing => [right, left]
            .iter()
            .all(|place| row.get(*place).unwrap_or(&Nothing) == &Nothing),
        Text(text) => {
            // Two letters are no tooth, whatever is beside them.
            text.chars().take(2).filter(|c| c.is_alphabetic()).count() == 2
                || !text.contains(|c: char| c.is_ascii_digit())
                    && [right, left]
                        .iter()
                        .any(|place| number(row, *place).is_none())
        }
        Number(_) | Cell::Flag(_) => false,
    };
    while rows.last().is_some_and(|row| is_words(row)) {
        rows.pop();
    }
    let mut found = vec![None; TEETH as usize];
    for row in rows {
        let values = [number(row, right), number(row, left)];
        let [Some(right), Some(left)] = values else {
            return None;
        };
        let at = number(row, tooth)?;
        let index = (1..=TEETH).position(|known| f64::from(known) == at)?;
        if found[index].replace([right, left]).is_some() {
            return None;
        }
    }
    let found: Vec<[f64; 2]> = found.into_iter().collect::<Option<_>>()?;
    let flank = |flank: usize| found.iter().map(|values| values[flank]).collect();
    Some([0, 1].map(flank).to_vec())
}

fn mistake(cells: &mut Cells, choice: &mut Choice) {
    let mut wrong = vec![Nothing];
    wrong.extend([0.0, 7.0, 1.5, 2e7].map(Number));
    let texts = "0,5|1.5|1,234|7|x|Fp|fp|mm|Linke Flanke|Max|# 3";
    wrong.extend(texts.split('|').map(|text| Text(text.to_owned())));
    let (a, b) = (choice.below(cells.len()), choice.below(cells.len()));
    let content = wrong[choice.below(wrong.len())].clone();
    let at = choice.below(cells[a].len());
    match choice.below(9) {
        0 => {
            cells.remove(a);
        }
        1 => cells.insert(b, cells[a].clone()),
        2 => cells.swap(a, b),
        3 => cells.truncate(a + 1),
        4 => cells[a].insert(at, content),
        5 if !cells[a].is_empty() => {
            cells[a].remove(at);
        }
        6 if at + 1 < cells[a].len() => cells[a].swap(at, at + 1),
        _ if !cells[a].is_empty() => cells[a][at] = content,
        _ => cells[a].push(content),
    }
}

#[test]
fn ten_thousand_shop_books() {
    let good = good();
    let expected = [others, tenths].map(|flank| (1..=TEETH).map(flank).collect::<Vec<f64>>());
    let near = |one: &[Vec<f64>], other: &[Vec<f64>]| {
        let one = one.iter().flatten();
        one.zip(other.iter().flatten())
            .all(|(one, other)| (one - other).abs() < 1e-9)
    };
    assert!(near(&right(&good).unwrap(), &expected));
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("pair.toml");
    fs::write(&path, pair(TEETH, KEYS)).unwrap();
    let mut choice = Choice(17);
    let (mut errors, mut same) = (0, 0);
    for number in 0..=count() {
        let mut cells = good.clone();
        if number > 0 {
            mistake(&mut cells, &mut choice);
        }
        let expected = right(&cells);
        fs::write(folder.path().join("p.xlsx"), written(&cells)).unwrap();
        match read_pair(&path) {
            Ok(study) => {
                assert_eq!(Some(pitch_lists(&study)), expected, "{number}: {cells:?}");
                same += 1;
            }
            Err(problems) => {
                assert!(number > 0, "{problems:#?}");
                for problem in problems {
                    check("p.xlsx", OF_THE_WORKBOOK, &problem, expected.is_some());
                }
                errors += 1;
            }
        }
    }
    assert!(
        4 * errors > count() && 7 * same > count(),
        "{errors} errors, {same} right"
    );
}
