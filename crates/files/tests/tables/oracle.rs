//! The tests' own, lenient reading of a table: what its rows say, whatever gearlash makes of it.

use std::collections::BTreeMap;

/// Values by tooth; `None` when a line makes no sense or a tooth is not there exactly once.
pub type Rows = BTreeMap<u32, Vec<f64>>;

/// The columns of a delimited text whose headings contain one of each of `words`.
pub fn delimited(bytes: &[u8], teeth: u32, words: &[[&str; 2]]) -> Option<Rows> {
    let text = String::from_utf8_lossy(bytes).replace(['"', '\u{feff}'], "");
    let mut lines = text.lines().filter(|line| !line.trim().is_empty());
    let header = lines
        .next()?
        .to_lowercase()
        .replace([' ', '-', '_', '.'], "");
    let delimiter = [';', ',', '\t']
        .into_iter()
        .find(|sign| header.contains(*sign))?;
    let names: Vec<&str> = header.split(delimiter).collect();
    let place = |words: &[&str]| {
        names
            .iter()
            .position(|name| words.iter().any(|word| name.contains(word)))
    };
    let tooth = place(&["toothno", "zahn"])
        .or_else(|| names.iter().position(|name| name.trim() == "tooth"))?;
    let places: Vec<usize> = words
        .iter()
        .map(|words| place(words))
        .collect::<Option<_>>()?;
    let mut rows = Rows::new();
    for line in lines {
        let cells: Vec<String> = line
            .split(delimiter)
            .map(|cell| {
                cell.trim_matches([' ', '\t', '\r', '\u{a0}'])
                    .replace(',', ".")
            })
            .collect();
        if cells.iter().all(String::is_empty) {
            continue;
        }
        let values = places.iter().map(|place| number(cells.get(*place)?));
        let values: Vec<f64> = values.collect::<Option<_>>()?;
        add(&mut rows, cells.get(tooth)?.parse().ok()?, values)?;
    }
    complete(rows, teeth)
}

/// Left and right values of one column (1: fp, 2: Fp, 3: Fr) of a protocol's blocks.
pub fn protocol(bytes: &[u8], teeth: u32, column: usize) -> Option<[Rows; 2]> {
    let text = String::from_utf8_lossy(bytes);
    let lower = text.to_lowercase();
    let (left, right) = (
        lower.find("linke zahnflanke")?,
        lower.find("rechte zahnflanke")?,
    );
    let end = |start: usize| {
        [left, right]
            .into_iter()
            .find(|other| *other > start)
            .unwrap_or(lower.len())
    };
    let block = |start: usize| {
        let mut rows = Rows::new();
        for line in lower[start..end(start)].lines().skip(1) {
            let words: Vec<&str> = line.split_whitespace().collect();
            if words.is_empty() || words[0].starts_with("zahn") {
                continue;
            }
            add(
                &mut rows,
                words[0].parse().ok()?,
                vec![number(words.get(column)?)?],
            )?;
        }
        complete(rows, teeth)
    };
    Some([block(left)?, block(right)?])
}

/// `05` may have been `0.5`.
fn number(text: &str) -> Option<f64> {
    let digits = text.trim_start_matches(['+', '-']).as_bytes();
    let lost = matches!(digits, [b'0', b'0'..=b'9', ..]);
    text.parse().ok().filter(|_| !lost)
}

fn add(rows: &mut Rows, tooth: u32, values: Vec<f64>) -> Option<()> {
    rows.insert(tooth, values).is_none().then_some(())
}

fn complete(rows: Rows, teeth: u32) -> Option<Rows> {
    rows.keys().copied().eq(1..=teeth).then_some(rows)
}

/// One value of every tooth.
pub fn column(rows: &Rows, place: usize) -> Vec<f64> {
    rows.values().map(|values| values[place]).collect()
}
