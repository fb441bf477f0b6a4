//! What a protocol says of the gear in its numbered header lines, held against the pair file.

use super::number;
use crate::data_file::DataFile;
use crate::problems::Problems;
use gearlash::gear::GearDesign;

/// A quantity that a header line may state.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Fact {
    Teeth,
    Module,
    PressureAngle,
    HelixAngle,
    ProfileShift,
    TipDiameter,
}

/// The labels and the key that states the same. `*` is the umlaut, which the code pages of old machines
/// write as one strange character or as two letters.
const LABELS: [(&str, Fact, &str); 7] = [
    ("Z*hnezahl", Fact::Teeth, "teeth"),
    ("Normalmodul", Fact::Module, "module_mm"),
    ("Eingriffswinkel", Fact::PressureAngle, "pressure_angle_deg"),
    (
        "Schr*gungswinkel",
        Fact::HelixAngle,
        "helix angle (gearlash knows spur gears only)",
    ),
    (
        "Profilverschiebungsfaktor",
        Fact::ProfileShift,
        "profile_shift",
    ),
    ("Kopfkreisdurchmesser", Fact::TipDiameter, "tip_diameter_mm"),
    ("Kopfkreis", Fact::TipDiameter, "tip_diameter_mm"),
];
/// The numbers under which such protocols state them.
const NUMBERS: [(&str, &str); 5] = [
    ("21", "Normalmodul"),
    ("22", "Zähnezahl"),
    ("24", "Eingriffswinkel"),
    ("25", "Profilverschiebungsfaktor"),
    ("27", "Kopfkreis"),
];
/// Units that may follow a value.
const UNITS: [&str; 4] = ["mm", "Grad", "°", "deg"];

/// The header lines of one protocol; those of a plain table are none.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Header {
    said: Vec<Said>,
    warnings: Vec<String>,
    /// What of the file is read and left unused, in words.
    unused: Option<String>,
}

#[derive(Debug, Clone, PartialEq)]
struct Said {
    file: DataFile,
    line: u64,
    label: String,
    fact: Fact,
    key: &'static str,
    value: f64,
    rounding: f64,
}

/// The same quantities as the pair file states them.
#[derive(Debug, Clone, Copy)]
pub struct Drawn<'a> {
    /// The gear, its tip diameter filled in.
    pub design: &'a GearDesign,
    /// `α`, degrees as written.
    pub pressure_angle_deg: f64,
}

impl Header {
    /// Takes over the line when it is a numbered header line with a known label.
    ///
    /// `  22 :Zähnezahl.............: 44` or `21 Normalmodul 3.000 mm`: a number, a label, dots or a colon or neither, the value.
    pub fn take(&mut self, file: &DataFile, line: u64, text: &str, problems: &mut Problems) {
        let rest = text.trim_start();
        let behind_number = rest.trim_start_matches(|c: char| c.is_ascii_digit());
        if behind_number.len() == rest.len() {
            return;
        }
        let behind = behind_number.trim_start_matches([' ', '\t', ':']);
        let Some((label, said, fact, key)) = LABELS.iter().find_map(|&(known, fact, key)| {
            let length = labelled(behind, known)?;
            Some((&behind[..length], &behind[length..], fact, key))
        }) else {
            let number = &rest[..rest.len() - behind_number.len()];
            let mut numbers = NUMBERS.iter().filter(|(known, _)| *known == number);
            // A number behind it makes it a row of some other list.
            let labelled = behind.starts_with(char::is_alphabetic);
            if let Some((_, usual)) = numbers.next().filter(|_| labelled) {
                self.warnings.push(format!(
                    "{}: {}: line {line} has the number of {usual}, but another label: it is not compared with the pair file",
                    file.key(),
                    file.name()
                ));
            }
            return;
        };
        let value = value_of(said);
        let Some(written) = number::written(value)
            .filter(|written| written.decimal != Some(number::Decimal::Comma))
        else {
            problems.add(file.problem_at(
                line,
                format!(
                    "{label} is {}, allowed is a number with a decimal point",
                    file.quote(value)
                ),
                "correct the line, or remove it",
            ));
            return;
        };
        self.said.push(Said {
            file: file.clone(),
            line,
            label: label.to_owned(),
            fact,
            key,
            value: written.value,
            rounding: written.rounding,
        });
    }

    /// Keeps in mind what of `file` is left unused.
    pub fn left_unused(&mut self, file: &DataFile, words: &str) {
        self.unused = Some(format!(
            "{}: {}: read and not used here: {words}",
            file.key(),
            file.name()
        ));
    }

    /// What of the file is left unused.
    pub fn unused(&self) -> Option<String> {
        self.unused.clone()
    }

    /// What a line states of the gear's base circle, mm: by teeth, module and pressure angle where all three are there.
    pub fn base_radius(&self) -> Option<f64> {
        let value = |fact| {
            let mut said = self.said.iter();
            Some(said.find(|said| said.fact == fact)?.value)
        };
        let angle = value(Fact::PressureAngle)?.to_radians();
        Some(0.5 * value(Fact::Module)? * value(Fact::Teeth)? * angle.cos())
    }

    /// Header lines that look known and are not.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Reports what contradicts the pair file by more than the rounding of the printed value.
    pub fn check(&self, drawn: &Drawn, problems: &mut Problems) {
        let design = drawn.design;
        for said in &self.said {
            let stated = match said.fact {
                Fact::Teeth => f64::from(design.basic_data.teeth()),
                Fact::Module => design.basic_data.module(),
                Fact::PressureAngle => drawn.pressure_angle_deg,
                Fact::HelixAngle => 0.0,
                Fact::ProfileShift => design.profile_shift,
                Fact::TipDiameter => 2.0 * design.tip_radius(),
            };
            // Rounding of the comparison itself: some ulps of the value.
            let allowed = said.rounding + 1e-12 * stated.abs();
            if (said.value - stated).abs() <= allowed {
                continue;
            }
            problems.add(said.file.problem_at(
                said.line,
                format!(
                    "{} is {}, the pair file has {} = {stated}",
                    said.label,
                    said.file.bare(&said.value.to_string()),
                    said.key
                ),
                "check that this is the gear's protocol, and correct the pair file or the line",
            ));
        }
    }
}

/// The bytes of `text` that are the label `known`, which no letter follows.
fn labelled(text: &str, known: &str) -> Option<usize> {
    let (before, after) = known.split_once('*').unwrap_or((known, ""));
    let rest = text.strip_prefix(before)?;
    let rest = match after {
        "" => rest,
        after => {
            let at = rest.find(after)?;
            if rest[..at].chars().count() > 2 {
                return None;
            }
            &rest[at + after.len()..]
        }
    };
    let ends = !rest.starts_with(|c: char| c.is_alphabetic());
    ends.then_some(text.len() - rest.len())
}

/// The value behind a label: after the last colon where there is one, without dots and a bracketed unit before it and
/// a unit after it.
fn value_of(rest: &str) -> &str {
    let value = match rest.rsplit_once(':') {
        Some((_, value)) => value,
        None => {
            let dots = ['.', '…', ' ', '\t'];
            let rest = rest.trim_start_matches(dots);
            let unit = rest.strip_prefix('[').and_then(|unit| unit.split_once(']'));
            unit.map_or(rest, |(_, behind)| behind.trim_start_matches(dots))
        }
    };
    let value = value.trim();
    let unit = UNITS.iter().find_map(|unit| value.strip_suffix(unit));
    unit.unwrap_or(value).trim_end()
}
