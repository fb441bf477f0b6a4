//! The tests' own, lenient reading of a table: what its rows say, whatever gearlash makes of it.

use std::collections::BTreeMap;

/// Values by tooth; `None` when a line makes no sense or a tooth is not there exactly once.
pub type Rows = BTreeMap<u32, Vec<f64>>;

/// The columns of a delimited text whose headings contain one of each of `words`; the header may stand in any line.
pub fn delimited(bytes: &[u8], teeth: u32, words: &[[&str; 2]]) -> Option<Rows> {
    let header = |names: &[String]| {
        let names: Vec<String> = names.iter().map(|name| name.to_lowercase()).collect();
        let place = |words: &[&str]| {
            let has = |name: &String| words.iter().any(|word| name.contains(word));
            names.iter().position(has)
        };
        let tooth = place(&["toothno", "zahn"])
            .or_else(|| names.iter().position(|name| name.trim() == "tooth"))?;
        let places: Option<Vec<usize>> = words.iter().map(|words| place(words)).collect();
        Some((tooth, places?))
    };
    below(bytes, teeth, header)
}

/// Right and left `Fp` of a shop's sheet: those of the left flank stand before those of the right one.
pub fn shop(bytes: &[u8], teeth: u32) -> Option<Rows> {
    below(bytes, teeth, |names| {
        let tooth = names
            .iter()
            .position(|name| name.to_lowercase() == "zahnnr")?;
        let places = (0..names.len()).filter(|place| names[*place] == "Fp");
        let [left, right] = places.collect::<Vec<_>>().try_into().ok()?;
        Some((tooth, vec![right, left]))
    })
}

/// The rows below the line of which `header` makes the places of tooth and values, comments and statistics left out.
fn below(
    bytes: &[u8],
    teeth: u32,
    header: impl Fn(&[String]) -> Option<(usize, Vec<usize>)>,
) -> Option<Rows> {
    let text = String::from_utf8_lossy(bytes).replace(['"', '\u{feff}'], "");
    let lines: Vec<&str> = text
        .lines()
        .filter(|line| !line.trim().is_empty())
        .collect();
    let found = [';', ',', '\t'].into_iter().find_map(|delimiter| {
        let names = |line: &str| -> Vec<String> {
            let bare =
                |name: &str| name.replace(|c: char| c.is_whitespace() || "-_.".contains(c), "");
            line.split(delimiter).map(bare).collect()
        };
        let mut lines = lines.iter().enumerate();
        let (at, places) = lines.find_map(|(at, line)| Some((at, header(&names(line))?)))?;
        // A header that is there twice is one.
        let again = |line: &&&str| header(&names(line)).is_some();
        Some((
            delimiter,
            at + lines.map(|(_, line)| line).take_while(again).count(),
            places,
        ))
    });
    let (delimiter, at, (tooth, places)) = found?;
    let cells = |line: &&str| -> Vec<String> {
        let cell = |cell: &str| {
            cell.trim_matches([' ', '\t', '\r', '\u{a0}'])
                .replace(',', ".")
        };
        line.split(delimiter).map(cell).collect()
    };
    let mut rows: Vec<Vec<String>> = lines[at + 1..].iter().map(cells).collect();
    rows.retain(|cells| match cells.iter().find(|cell| !cell.is_empty()) {
        Some(first) => {
            !first.starts_with('#') && !["Max", "Min", "Mittelwert", "-"].contains(&first.as_str())
        }
        None => false,
    });
    let values = |cells: &[String]| -> Option<Vec<f64>> {
        places
            .iter()
            .map(|place| number(cells.get(*place)?))
            .collect()
    };
    while let Some(last) = rows.last() {
        let first = last.get(tooth).map_or("", String::as_str);
        if first.contains(|c: char| c.is_ascii_digit()) || values(last).is_some() {
            break;
        }
        rows.pop();
    }
    let mut found = Rows::new();
    for cells in rows {
        add(&mut found, cells.get(tooth)?.parse().ok()?, values(&cells)?)?;
    }
    complete(found, teeth)
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
