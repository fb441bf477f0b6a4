//! A file with one mistake in it.

/// Numbers for choosing: Knuth's MMIX linear congruential generator, upper bits.
pub struct Choice(pub u64);

impl Choice {
    /// From 0 up to `end`, which is not reached.
    pub fn below(&mut self, end: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % end.max(1)
    }
}

/// Mutants that a test draws: `GEARLASH_MUTANTS`, or 800.
pub fn count() -> usize {
    let wanted = std::env::var("GEARLASH_MUTANTS").ok();
    wanted.map_or(800, |number| {
        number.parse().expect("GEARLASH_MUTANTS is a number")
    })
}

/// Typing mistakes and losses between bars, including a line end of old Macs, NUL, half of a UTF-8 character and a byte order mark.
const GARBAGE: &[u8] =
    b"0|7|-|+|.|,|;|\t| |\"|\n|\r|\0|e|x|nan|inf|1e9|#|\xc3|\xff|\xef\xbb\xbf|(mm)|1,234|1.234.5|\n\n|0x1|1_0";

/// `table` with one mistake in it.
pub fn mutant(table: &[u8], choice: &mut Choice) -> Vec<u8> {
    let mut lines: Vec<&[u8]> = table.split_inclusive(|&byte| byte == b'\n').collect();
    let (a, b) = (choice.below(lines.len()), choice.below(lines.len()));
    let at = choice.below(table.len());
    let garbage: Vec<&[u8]> = GARBAGE.split(|&byte| byte == b'|').collect();
    let garbage = garbage[choice.below(garbage.len())];
    match choice.below(11) {
        0 => {
            lines.remove(a);
        }
        1 => lines.insert(b, lines[a]),
        2 => lines.swap(a, b),
        3 => return table[..at].to_vec(),
        4 => return [&table[..at], garbage, &table[at..]].concat(),
        5 => return [&table[..at], garbage, &table[at + 1..]].concat(),
        6 => return [&table[..at], &table[at + 1..]].concat(),
        7 => {
            let delimiters: Vec<usize> = (0..table.len())
                .filter(|&at| b",;\t".contains(&table[at]))
                .collect();
            let at = *delimiters
                .get(choice.below(delimiters.len()))
                .unwrap_or(&at);
            return [&table[..at], garbage, &table[at + 1..]].concat();
        }
        8 => lines.insert(a, garbage),
        9 => {
            // A tooth more than there are.
            let more = next_tooth(&lines);
            return [&lines.concat()[..], &more[..]].concat();
        }
        _ => {
            let end = lines.len().min(a + 3);
            lines.drain(a.min(end)..end);
        }
    }
    lines.concat()
}

/// The last line that has a number by itself, with the next number.
fn next_tooth(lines: &[&[u8]]) -> Vec<u8> {
    let rows = lines
        .iter()
        .rev()
        .filter_map(|line| std::str::from_utf8(line).ok());
    let next = |row: &str| {
        let whole = |cell: &&str| cell.trim().parse::<u32>().is_ok();
        let tooth = row.split([';', ',', '\t', ' ']).find(whole)?.trim();
        let next = (tooth.parse::<u32>().ok()? + 1).to_string();
        Some(row.replacen(tooth, &next, 1).into_bytes())
    };
    rows.map(next).find_map(|row| row).unwrap_or_default()
}
