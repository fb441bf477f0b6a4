//! Workbooks as a shop writes them, each with one mistake: titles, groups, units, dates, statistics, texts for numbers.

use super::*;
use formats::{flanks, others, pitch_lists, tenths};
use mutant::{Choice, count};
use mutations::{Garbled, OF_THE_WORKBOOK};
use oracle::shop;
use written_book::Cell::{Flag, Nothing, Number, Text};
use written_book::{Cell, Cells, texts, written};

fn good(teeth: u32) -> Cells {
    let mut cells = vec![
        texts(&["Prüfprotokoll 4711"]),
        Vec::new(),
        texts(&["", "Linke Flanke", "", "", "Rechte Flanke"]),
        texts(&["Zahn-Nr.", "fp", "Fp", "fu", "fp", "Fp", "fu", "Datum"]),
        texts(&["-", "µm", "µm", "µm", "µm", "µm", "µm"]),
    ];
    for tooth in 1..=teeth {
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

/// The cells as lines of a text.
fn text(cells: &Cells) -> String {
    let cell = |cell: &Cell| match cell {
        Nothing => String::new(),
        Number(number) => number.to_string(),
        Text(text) => text.clone(),
        Flag(flag) => flag.to_string(),
    };
    let line = |line: &Vec<Cell>| line.iter().map(cell).collect::<Vec<_>>().join(";") + "\n";
    cells.iter().map(line).collect()
}

fn mistake(cells: &mut Cells, choice: &mut Choice) {
    let mut wrong = vec![Nothing, Flag(true)];
    wrong.extend([0.0, 7.0, 1.5, -3.0, 2e7, 1e300].map(Number));
    let texts = "0,5|1.5|1,234|7|x|nan| |left|Fp|fp|mm|Linke Flanke|Max|# 3";
    wrong.extend(texts.split('|').map(|text| Text(text.to_owned())));
    let (a, b) = (choice.below(cells.len()), choice.below(cells.len()));
    let content = wrong[choice.below(wrong.len())].clone();
    let at = choice.below(cells[a].len());
    match choice.below(10) {
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
        7 => cells.insert(a, Vec::new()),
        _ if !cells[a].is_empty() => cells[a][at] = content,
        _ => cells[a].push(content),
    }
}

/// Garbled workbooks have 17 teeth, or 2000 rows.
#[test]
fn garbled_shop_books() {
    for (teeth, count) in [(17, count()), (2000, 10)] {
        let good = good(teeth);
        let mut choice = Choice(u64::from(teeth));
        let garbled = Garbled {
            name: "p.xlsx",
            keys: "pitch = { kind = \"cumulative\", file = \"p.xlsx\" }",
            teeth,
            count,
            of_the_file: OF_THE_WORKBOOK,
        };
        let file = |number| {
            let mut cells = good.clone();
            if number > 0 {
                mistake(&mut cells, &mut choice);
            }
            let expected = shop(text(&cells).as_bytes(), teeth).map(flanks);
            let is_right = expected.is_some();
            (written(&cells), expected, is_right)
        };
        let (errors, right) = garbled.run(file, |study, right| pitch_lists(study) == *right);
        let is_mixed = 4 * errors > count && 10 * right > count;
        assert!(is_mixed, "{errors} errors, {right} right");
    }
}
