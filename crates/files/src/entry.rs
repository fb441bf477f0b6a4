//! One value of a pair file, read as the type and range its key asks for.

use super::nearest::{is_slip, nearest};
use super::node::Node;
use super::problems::Problems;
use crate::error::Problem;
use std::ops::{Bound, RangeBounds, RangeInclusive};

/// What a number must be.
pub struct Limits {
    /// The allowed range, in words: "a number of mm, 0.01 … 1000".
    pub allowed: &'static str,
    /// The same for the machine.
    pub range: (Bound<f64>, Bound<f64>),
    /// What to do when the number is outside.
    pub help: &'static str,
}

/// A value and the key it stands under.
#[derive(Debug, Clone)]
pub struct Entry<'a> {
    key: String,
    node: &'a Node,
    /// Its place in a list, from 1.
    place: Option<usize>,
}

impl<'a> Entry<'a> {
    /// The value `node` under the dotted path `key`.
    pub fn new(key: String, node: &'a Node) -> Entry<'a> {
        Entry {
            key,
            node,
            place: None,
        }
    }

    /// The value as it stands in the file.
    pub fn node(&self) -> &'a Node {
        self.node
    }

    /// A problem with this value.
    pub fn problem(&self, reason: impl Into<String>, help: impl Into<String>) -> Problem {
        let reason = match self.place {
            Some(place) => format!("value {place} of the list: {}", reason.into()),
            None => reason.into(),
        };
        Problem {
            key: self.key.clone(),
            value: Some(self.node.shown()),
            reason,
            help: help.into(),
        }
    }

    /// The problem of a value of the wrong type.
    pub fn wrong_type(&self, allowed: &str, help: impl Into<String>) -> Problem {
        self.problem(format!("{}, allowed is {allowed}", self.node.kind()), help)
    }

    /// A number within `limits`; TOML and JSON integers are numbers too.
    pub fn number(&self, limits: &Limits) -> Result<f64, Problem> {
        let number = match *self.node {
            Node::Number(number) => number,
            Node::Whole(whole) => whole as f64,
            _ => return Err(self.wrong_type(limits.allowed, limits.help)),
        };
        let wrong = if !number.is_finite() {
            "not finite"
        } else if !limits.range.contains(&number) {
            "out of range"
        } else {
            return Ok(number);
        };
        Err(self.problem(
            format!("{wrong}, allowed is {}", limits.allowed),
            limits.help,
        ))
    }

    /// A whole number in `range`.
    pub fn whole(&self, range: RangeInclusive<u32>, help: &str) -> Result<u32, Problem> {
        let allowed = whole_in(&range);
        let whole = match *self.node {
            Node::Whole(whole) => whole,
            // A number without a fraction, as JSON writers like to print it; the cast saturates.
            Node::Number(number) if number.fract() == 0.0 => number as i64,
            Node::Number(number) => {
                let wrong = if number.is_finite() {
                    "not whole"
                } else {
                    "not finite"
                };
                return Err(self.problem(format!("{wrong}, allowed is {allowed}"), help));
            }
            _ => return Err(self.wrong_type(&allowed, help)),
        };
        let whole = u32::try_from(whole)
            .ok()
            .filter(|whole| range.contains(whole));
        whole.ok_or_else(|| self.problem(format!("out of range, allowed is {allowed}"), help))
    }

    /// A string.
    pub fn text(&self, help: &str) -> Result<&'a str, Problem> {
        match self.node {
            Node::Text(text) => Ok(text),
            _ => Err(self.wrong_type("a string", help)),
        }
    }

    /// `true` or `false`.
    pub fn flag(&self) -> Result<bool, Problem> {
        match self.node {
            &Node::Flag(flag) => Ok(flag),
            _ => Err(self.wrong_type("true or false", "write it without quotes")),
        }
    }

    /// One of `names`.
    pub fn choice<T: Copy>(&self, names: &[(&'static str, T)]) -> Result<T, Problem> {
        let words: Vec<&'static str> = names.iter().map(|&(name, _)| name).collect();
        let allowed = quoted(&words, "\"");
        let Node::Text(text) = self.node else {
            return Err(self.wrong_type(&allowed, "write one of these, in quotes"));
        };
        if let Some(&(_, choice)) = names.iter().find(|(name, _)| name == text) {
            return Ok(choice);
        }
        let help = match nearest(text, &words) {
            Some((word, distance)) if is_slip(text, distance) => {
                format!("did you mean \"{word}\"?")
            }
            _ => "write one of these".to_owned(),
        };
        Err(self.problem(format!("unknown, allowed is {allowed}"), help))
    }

    /// The elements of a list.
    pub fn list(&self, allowed: &str, help: &str) -> Result<Vec<Entry<'a>>, Problem> {
        let Node::List(list) = self.node else {
            return Err(self.wrong_type(allowed, help));
        };
        let element = |(index, node)| Entry {
            key: self.key.clone(),
            node,
            place: Some(index + 1),
        };
        Ok(list.iter().enumerate().map(element).collect())
    }

    /// A list of numbers, each within `limits`.
    pub fn numbers(&self, limits: &Limits, problems: &mut Problems) -> Option<Vec<f64>> {
        let list = problems.keep(self.list("a list of numbers", limits.help))?;
        self.each(&list, problems, |element, _| element.number(limits))
    }

    /// `read` of every element of `list`; `None` when one fails.
    pub fn each<T>(
        &self,
        list: &[Entry<'a>],
        problems: &mut Problems,
        read: impl Fn(&Entry<'a>, usize) -> Result<T, Problem>,
    ) -> Option<Vec<T>> {
        let mut bad = Problems::of_list();
        let values: Vec<Option<T>> = list
            .iter()
            .enumerate()
            .map(|(index, element)| bad.keep(read(element, index)))
            .collect();
        problems.add_list(&self.key, bad);
        values.into_iter().collect()
    }
}

/// "a whole number, 3 … 10 000".
pub fn whole_in(range: &RangeInclusive<u32>) -> String {
    let (low, high) = (range.start(), range.end());
    if *high < 10_000 {
        format!("a whole number, {low} … {high}")
    } else {
        format!("a whole number, {low} … {} {:03}", high / 1000, high % 1000)
    }
}

/// "`a`, `b` or `c`", each between `mark`s.
pub fn quoted(words: &[&str], mark: &str) -> String {
    let marked: Vec<String> = words.iter().map(|w| format!("{mark}{w}{mark}")).collect();
    match marked.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        _ => marked.concat(),
    }
}
