//! Preamble `KEY value ! comment`, and numbered header lines ` 22 :Zähnezahl z…: 52`.

use super::super::number::Unmeasured;
use super::super::number::without_zero;
use super::content::{CORRECT, Numbered, P40};
use crate::data_file::DataFile;
use crate::problems::Problems;
use std::collections::HashSet;

/// What angles may be in; `Grad` is German for degrees.
const DEGREES: [&str; 5] = ["deg", "degree", "degrees", "grad", "°"];

/// The numbers of the header lines so far.
#[derive(Debug, Default)]
pub struct Head(HashSet<u32>);

impl Head {
    /// Takes over a line of the header; `Some(false)` where it is none, `None` where it ends the reading.
    pub fn take<'a>(
        &mut self,
        file: &DataFile,
        p40: &mut P40<'a>,
        (line, text): (u64, &'a str),
        problems: &mut Problems,
    ) -> Option<bool> {
        let digits = text.bytes().take_while(u8::is_ascii_digit).count();
        let behind = text[digits..].trim_start();
        if (1..=3).contains(&digits) && behind.starts_with(':') {
            let code = &text[..digits];
            if !code.parse().is_ok_and(|code| self.0.insert(code)) {
                let reason = format!("the number {} stands twice", file.bare(code));
                problems.add(file.problem_at(line, reason, CORRECT));
                return None;
            }
            let (label, fields) = behind[1..].split_once(':').unwrap_or((&behind[1..], ""));
            numbered(
                file,
                p40,
                line,
                [code, label.trim_start(), fields],
                problems,
            );
            return Some(true);
        }
        let body = text.split('!').next().unwrap_or_default().trim();
        let (key, value) = body.split_once(char::is_whitespace).unwrap_or((body, ""));
        let is_key = key.chars().all(|c| c.is_ascii_uppercase()) && !key.is_empty();
        if !p40.numbered.is_empty() || !is_key {
            return Some(false);
        }
        let value = value.trim();
        let words = value.to_lowercase();
        let allowed = match key {
            "UNDEFINED" => match without_zero(value) {
                Some(number) => {
                    p40.unmeasured = Unmeasured::said(number.value);
                    None
                }
                None => Some("a number with a decimal point"),
            },
            "UNITS" if words.contains("inch") => Some("mm and µm"),
            "ANGLE" if !DEGREES.contains(&&words[..]) => Some("degrees"),
            "PROFILE" => {
                p40.profile_by = Some(value);
                None
            }
            _ => None,
        };
        if let Some(allowed) = allowed {
            let reason = format!("{key} is {}, allowed is {allowed}", file.quote(value));
            problems.add(file.problem_at(line, reason, CORRECT));
        }
        Some(true)
    }
}

fn numbered(
    file: &DataFile,
    p40: &mut P40,
    line: u64,
    [code, label, fields]: [&str; 3],
    problems: &mut Problems,
) {
    let mut words = fields
        .split([' ', '\t', ':'])
        .filter(|word| !word.is_empty());
    let numbers = words.clone().filter_map(without_zero);
    let numbers: Vec<f64> = numbers.map(|found| found.value).collect();
    // Of several fields the first number is what the label says.
    let first = words.next().unwrap_or_default();
    let first = match first.strip_prefix('-') {
        Some(rest) if rest.starts_with('.') => format!("-0{rest}"),
        None if first.starts_with('.') => format!("0{first}"),
        _ => first.to_owned(),
    };
    p40.header
        .state(file, line, [code, label, fields], &first, problems);
    p40.numbered.push(Numbered {
        line,
        label: label.to_lowercase(),
        numbers,
    });
}
