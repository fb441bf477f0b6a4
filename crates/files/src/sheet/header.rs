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
    ProfileShift,
    TipDiameter,
    HelixAngle,
}

/// The labels and the key that states the same. `*` is the umlaut, which the code pages of old machines
/// write as one strange character or as two letters.
const LABELS: [(&str, Fact, &str); 6] = [
    ("Z*hnezahl", Fact::Teeth, "teeth"),
    ("Normalmodul", Fact::Module, "module_mm"),
    ("Eingriffswinkel", Fact::PressureAngle, "pressure_angle_deg"),
    (
        "Profilverschiebungsfaktor",
        Fact::ProfileShift,
        "profile_shift",
    ),
    ("Kopfkreisdurchmesser", Fact::TipDiameter, "tip_diameter_mm"),
    ("Kopfkreis", Fact::TipDiameter, "tip_diameter_mm"),
];
/// Label of the helix angle, whose sign some machines print and some do not.
const HELIX_ANGLE: &str = "Schr*gungswinkel";
/// Words beside the number of teeth that make the gear an internal one.
const INTERNAL: [&str; 2] = ["innen", "internal"];
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
    /// The file, and what of it is read and left unused, in words.
    unused: Option<(DataFile, String)>,
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
pub struct StatedGear<'a> {
    /// The gear, its tip diameter filled in.
    pub design: &'a GearDesign,
    /// `α`, degrees as written.
    pub pressure_angle_deg: f64,
    /// `β`, degrees as written; 0 of a spur gear.
    pub helix_angle_deg: f64,
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
        let code = &rest[..rest.len() - behind_number.len()];
        let behind = behind_number.trim_start_matches([' ', '\t', ':']);
        let length = LABELS
            .iter()
            .find_map(|&(known, ..)| labelled(behind, known))
            .or(labelled(behind, HELIX_ANGLE));
        let (label, rest) = behind.split_at(length.unwrap_or(behind.len()));
        let fields = rest.rsplit_once(':').map_or(rest, |(_, fields)| fields);
        self.state(file, line, [code, label, fields], value_of(rest), problems);
    }

    /// Takes over `value` of a header line with the number `code`, a label and fields, of which the value is one.
    pub fn state(
        &mut self,
        file: &DataFile,
        line: u64,
        [code, label, fields]: [&str; 3],
        value: &str,
        problems: &mut Problems,
    ) {
        let mut wrong =
            |reason: String, help: &str| problems.add(file.problem_at(line, reason, help));
        if let Some(length) = labelled(label, HELIX_ANGLE) {
            let name = &label[..length];
            let words = fields.split([' ', '\t', ':', '°']).chain([value]);
            // A field may hold zeros beside it.
            let numbers: Vec<number::Written> = words.filter_map(number::written).collect();
            let angles = || numbers.iter().filter(|number| number.value != 0.0);
            let angle = angles().next().or(numbers.first());
            let one = |angle: &&number::Written| {
                angles().all(|other| other.value.abs() == angle.value.abs())
            };
            let Some(angle) = angle.filter(one) else {
                let reason = format!(
                    "{name} is {}, allowed is a number of degrees",
                    file.quote(fields.trim_matches([' ', '\t', '.', ':']))
                );
                wrong(reason, "correct the line, or remove it");
                return;
            };
            self.said.push(Said {
                file: file.clone(),
                line,
                label: name.to_owned(),
                fact: Fact::HelixAngle,
                key: "helix_angle_deg",
                value: angle.value.abs(),
                rounding: angle.rounding,
            });
            return;
        }
        let known = LABELS.iter().find_map(|&(known, fact, key)| {
            let length = labelled(label, known)?;
            Some((&label[..length], fact, key))
        });
        let Some((label, fact, key)) = known else {
            let mut numbers = NUMBERS.iter().filter(|(known, _)| *known == code);
            // A number behind it makes it a row of some other list.
            let labelled = label.starts_with(char::is_alphabetic);
            if let Some((_, usual)) = numbers.next().filter(|_| labelled) {
                self.warnings.push(format!(
                    "{}: {}: line {line} has the number of {usual}, but another label: it is not compared with the pair file",
                    file.key(),
                    file.name()
                ));
            }
            return;
        };
        let words = fields.to_lowercase();
        let internal = INTERNAL.iter().any(|word| words.contains(word));
        if fact == Fact::Teeth && (internal || value.starts_with(['-', '\u{2212}'])) {
            let reason = format!(
                "{label} is {}: the gear is internal, gearlash reads external gears",
                file.quote(fields.trim_matches([' ', '\t', '.', ':']))
            );
            wrong(reason, "name the file of an external gear");
            return;
        }
        let point = |number: &number::Written| number.decimal != Some(number::Decimal::Comma);
        let number = number::written(value).filter(point);
        let whole = |number: &number::Written| {
            (1.0..=10_000.0).contains(&number.value) && number.value.fract() == 0.0
        };
        let (number, allowed) = match fact {
            Fact::Teeth => (number.filter(whole), "a whole number from 1 on"),
            _ => (number, "a number with a decimal point"),
        };
        let Some(number) = number else {
            let reason = format!("{label} is {}, allowed is {allowed}", file.quote(value));
            wrong(reason, "correct the line, or remove it");
            return;
        };
        self.said.push(Said {
            file: file.clone(),
            line,
            label: label.to_owned(),
            fact,
            key,
            value: number.value,
            rounding: number.rounding,
        });
    }

    /// Keeps in mind what of `file` is left unused.
    pub fn left_unused(&mut self, file: &DataFile, words: &str) {
        self.unused = Some((file.clone(), words.to_owned()));
    }

    /// The remark of what of the file is left unused.
    pub fn remark(&self) -> Option<String> {
        let (file, words) = self.unused.as_ref()?;
        Some(format!(
            "{}: {}: read and not used here: {words}",
            file.key(),
            file.name()
        ))
    }

    /// What of the file is left unused, in words.
    pub fn unused(&self) -> Option<&str> {
        self.unused.as_ref().map(|(_, words)| &words[..])
    }

    /// The number of teeth that a line states.
    pub fn teeth(&self) -> Option<u32> {
        let said = self.said.iter().find(|said| said.fact == Fact::Teeth)?;
        // Whole and within 1 … 10 000.
        Some(said.value as u32)
    }

    fn value(&self, fact: Fact) -> Option<f64> {
        let mut said = self.said.iter();
        Some(said.find(|said| said.fact == fact)?.value)
    }

    /// Whether a line states a helix angle above 0.
    pub fn is_helical(&self) -> bool {
        self.value(Fact::HelixAngle)
            .is_some_and(|angle| angle > 0.0)
    }

    /// What lines state of the gear's base circle, mm: by teeth, module, pressure angle and helix angle, where the first three are there:
    /// `r_b = m_n z cos α_t/(2 cos β)` with `tan α_t = tan α_n/cos β`.
    pub fn base_radius(&self) -> Option<f64> {
        let normal = self.value(Fact::PressureAngle)?.to_radians();
        let reference = 0.5 * self.value(Fact::Module)? * self.value(Fact::Teeth)?;
        let cos = self
            .value(Fact::HelixAngle)
            .unwrap_or(0.0)
            .to_radians()
            .cos();
        match self.is_helical() {
            false => Some(reference * normal.cos()),
            true => Some(reference / cos * (normal.tan() / cos).atan().cos()),
        }
    }

    /// Header lines that look known and are not.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Reports what contradicts the pair file by more than the rounding of the printed value.
    pub fn check(&self, drawn: &StatedGear, problems: &mut Problems) {
        let design = drawn.design;
        for said in &self.said {
            let stated = match said.fact {
                Fact::Teeth => f64::from(design.basic_data.teeth()),
                Fact::Module => design.basic_data.module(),
                Fact::PressureAngle => drawn.pressure_angle_deg,
                Fact::ProfileShift => design.profile_shift,
                Fact::TipDiameter => 2.0 * design.tip_radius(),
                Fact::HelixAngle => drawn.helix_angle_deg,
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
