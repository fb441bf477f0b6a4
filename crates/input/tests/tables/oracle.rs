//! The tests' own, lenient reading of a table, independent of gearlash.

use std::collections::BTreeMap;

/// Values by tooth; `None` when a line makes no sense or a tooth is not there exactly once.
pub type Rows = BTreeMap<u32, Vec<f64>>;

/// The columns of a delimited text whose headings contain one of each of `words`; the header can be in any line.
pub fn delimited(bytes: &[u8], teeth: u32, words: &[[&str; 2]]) -> Option<Rows> {
    let header = |names: &[String]| {
        let names: Vec<String> = names.iter().map(|name| name.to_lowercase()).collect();
        let place = |words: &[&str]| {
            let has = |name: &String| words.iter().any(|word| name.contains(word));
            names.iter().position(has)
        };
        let tooth = place(&["toothno", "zahn"]).or_else(|| {
            names
                .iter()
                .position(|name| ["tooth", "nr"].contains(&name.trim()))
        })?;
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
            .position(|name| alone(name).to_lowercase() == "zahnnr")?;
        let places = (0..names.len()).filter(|place| alone(&names[*place]) == "Fp");
        let [left, right] = places.collect::<Vec<_>>().try_into().ok()?;
        Some((tooth, vec![right, left]))
    })
}

/// The letters and digits of `name`.
fn alone(name: &str) -> String {
    name.chars().filter(|c| c.is_alphanumeric()).collect()
}

/// The rows below a line of which `header` makes the places of tooth and values, comments and statistics left out. Where several lines are a header, below the
/// first with which all rows make sense.
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
    [';', ',', '\t'].into_iter().find_map(|delimiter| {
        let names = |line: &str| -> Vec<String> { line.split(delimiter).map(alone).collect() };
        (0..lines.len()).find_map(|at| {
            let one = names(lines[at]);
            // Or of two lines, the upper one naming groups.
            let both = || {
                let mut both = names(lines[at.checked_sub(1)?]);
                both.resize(both.len().max(one.len()), String::new());
                let cells = both.iter_mut().zip(&one);
                cells.for_each(|(upper, lower)| upper.push_str(lower));
                Some(both)
            };
            let (tooth, places) = header(&one).or_else(|| header(&both()?))?;
            rows(&lines[at + 1..], delimiter, teeth, tooth, &places)
        })
    })
}

/// The content of `lines`, if all of them make sense.
fn rows(
    lines: &[&str],
    delimiter: char,
    teeth: u32,
    tooth: usize,
    places: &[usize],
) -> Option<Rows> {
    let cells = |line: &&str| -> Vec<String> {
        let cell = |cell: &str| {
            cell.trim_matches([' ', '\t', '\r', '\u{a0}'])
                .replace(',', ".")
        };
        line.split(delimiter).map(cell).collect()
    };
    let mut rows: Vec<Vec<String>> = lines.iter().map(cells).collect();
    rows.retain(|cells| match cells.iter().find(|cell| !cell.is_empty()) {
        Some(first) => {
            let label = alone(&first.replace("(mm)", "")).to_lowercase();
            let is_label = ["max", "min", "mittelwert", "", "µm"].contains(&label.as_str());
            !first.starts_with('#') && !is_label
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
        // Words and dates are no teeth, whatever is beside them.
        let letters = first.chars().filter(|c| c.is_alphabetic()).count();
        let is_word = first.starts_with(char::is_alphabetic) && letters > 1;
        let is_date = first.split('.').map(str::len).eq([2, 2, 4])
            && first.bytes().all(|b| b == b'.' || b.is_ascii_digit());
        let has_digit = first.contains(|c: char| c.is_ascii_digit());
        if !is_word && !is_date && (has_digit || values(last).is_some()) {
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
