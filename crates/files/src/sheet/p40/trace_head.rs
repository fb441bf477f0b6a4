//! The heads of traces: `Profil:`, and `Zahn-Nr.: 44 links / 480  Werte  z= 7.500`.

use super::super::number;
use super::super::number::without_zero;
use super::content::PROFILES;
use crate::data_file::DataFile;
use gearlash::gear::Flank;

/// How the head of one trace begins.
pub const BEGIN: &str = "Zahn-Nr.:";

/// What the traces below a title are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Title {
    Profile,
    Lead,
    Twist,
}

impl Title {
    /// That which `text` begins with, and what follows it.
    pub fn of(text: &str) -> Option<(Title, &str)> {
        let titles = [
            ("Profil:", Title::Profile),
            ("Flankenlinie:", Title::Lead),
            ("Verschränkung:", Title::Twist),
        ];
        titles
            .into_iter()
            .find_map(|(known, title)| Some((title, text.strip_prefix(known)?.trim_start())))
    }
}

/// What the head of a trace says.
#[derive(Debug)]
pub struct TraceHead {
    pub tooth: u32,
    pub flank: Flank,
    /// How many values follow.
    pub count: usize,
    /// What such a trace is called.
    pub name: &'static str,
}

/// The head `text` of a trace below `title`; with a letter behind the tooth one beside the main one.
pub fn read(file: &DataFile, text: &str, title: Title) -> Result<TraceHead, String> {
    let wrong = || {
        let words = file.quote(text);
        format!("{words}, allowed is such as Zahn-Nr.: 44 links / 480 Werte z= 7.500")
    };
    let behind = text.strip_prefix(BEGIN).ok_or_else(wrong)?;
    let behind = behind.replace('/', " ").replace('=', "= ");
    let mut words: Vec<&str> = behind.split_whitespace().collect();
    // Of a twist trace the one it belongs to.
    if words.get(1).is_some_and(|word| word.contains(':')) {
        words.remove(1);
    }
    let [tooth, flank, count, "Werte", axis, at] = words[..] else {
        return Err(wrong());
    };
    let tag = tooth.trim_start_matches(|c: char| c.is_ascii_digit());
    let number = number::tooth(&tooth[..tooth.len() - tag.len()]);
    let number = number.filter(|number| (1..=10_000).contains(number));
    let flank = match flank {
        "links" => Some(Flank::Left),
        "rechts" => Some(Flank::Right),
        _ => None,
    };
    let count = number::tooth(count).filter(|count| (2..=100_000).contains(count));
    let axes: &[&str] = match title {
        Title::Profile => &["z="],
        Title::Lead | Title::Twist => &["x=", "z=", "d="],
    };
    let is_tag = tag.len() <= 1 && tag.chars().all(|c| c.is_ascii_lowercase());
    let (Some(tooth), Some(flank), Some(count), Some(_), true) = (
        number,
        flank,
        count,
        without_zero(at),
        is_tag && axes.contains(&axis),
    ) else {
        return Err(wrong());
    };
    Ok(TraceHead {
        tooth,
        flank,
        count: count as usize,
        name: match (title, tag) {
            (Title::Lead, _) => "lead traces",
            (Title::Twist, _) => "twist traces",
            (Title::Profile, "") => PROFILES,
            (Title::Profile, _) => "profile traces beside the main ones",
        },
    })
}
