//! The numbered header lines of a protocol. Their statements about the gear are compared with the pair file.

use crate::data_file::DataFile;
use gearlash::gear::GearDesign;
use gearlash_text::file_numbers::{self, Decimal, FileNumber};

/// Labels, the equivalent key, and the usual number of the line. `*` is the umlaut, which the code pages of old machines write as
/// one strange character or as two letters.
const LABELS: [(&str, &str, &str); 7] = [
    ("Z*hnezahl", "teeth", "22"),
    ("Normalmodul", "module_mm", "21"),
    ("Eingriffswinkel", "pressure_angle_deg", "24"),
    ("Profilverschiebungsfaktor", "profile_shift", "25"),
    ("Kopfkreisdurchmesser", "tip_diameter_mm", ""),
    ("Kopfkreis", "tip_diameter_mm", "27"),
    ("Schr*gungswinkel", "helix_angle_deg", ""),
];
/// Words beside the number of teeth that indicate an internal gear.
const INTERNAL: [&str; 2] = ["innen", "internal"];
const UNITS: [&str; 4] = ["mm", "Grad", "°", "deg"];

/// The header lines of one protocol; a plain table has none.
#[derive(Debug, Clone, Default)]
pub struct ProtocolHeader {
    stated: Vec<Stated>,
    warnings: Vec<String>,
    /// The file, and its parts that are read but not used, in words.
    unread: Option<(DataFile, String)>,
}

#[derive(Debug, Clone)]
struct Stated {
    file: DataFile,
    line: u64,
    label: String,
    key: &'static str,
    value: f64,
    rounding: f64,
}

/// The quantities that header lines can state, as expected by the pair file.
#[derive(Debug, Clone, Copy)]
pub struct ExpectedGear<'a> {
    /// The gear, its tip diameter filled in.
    pub design: &'a GearDesign,
    /// `α`, degrees as written.
    pub pressure_angle_deg: f64,
    /// `β`, degrees as written; 0 of a spur gear.
    pub helix_angle_deg: f64,
}

impl ProtocolHeader {
    /// Reads a line of a protocol. Lines other than numbered header lines are skipped.
    ///
    /// `  22 :Zähnezahl.............: 44` or `21 Normalmodul 3.000 mm`: a number, a label, dots or a colon or neither, the value.
    pub fn take(&mut self, file: &DataFile, line: u64, text: &str) {
        let rest = text.trim_start();
        let behind_number = rest.trim_start_matches(|c: char| c.is_ascii_digit());
        let code = &rest[..rest.len() - behind_number.len()];
        if code.is_empty() {
            return;
        }
        let behind = behind_number.trim_start_matches([' ', '\t', ':']);
        let length = LABELS
            .iter()
            .find_map(|(known, ..)| labelled(behind, known));
        let (label, rest) = behind.split_at(length.unwrap_or(behind.len()));
        let fields = rest.rsplit_once(':').map_or(rest, |(_, fields)| fields);
        self.state(file, line, [code, label, fields], value_of(rest));
    }

    /// Reads a header line with the number `code`, a label and fields, one of which is `value`.
    pub fn state(
        &mut self,
        file: &DataFile,
        line: u64,
        [code, label, fields]: [&str; 3],
        value: &str,
    ) {
        let wrong = |reason: String, help: &str| file.add_at(line, reason, help);
        let known = LABELS
            .iter()
            .find_map(|(known, key, _)| Some((&label[..labelled(label, known)?], *key)));
        let Some((label, key)) = known else {
            let usual = LABELS
                .iter()
                .find(|(.., number)| *number == code && !code.is_empty());
            // A number behind the number makes it a row of another list.
            if let Some((usual, ..)) = usual.filter(|_| label.starts_with(char::is_alphabetic)) {
                let usual = usual.replace('*', "ä");
                self.warn(file, &format!(
                    "line {line} has the number of {usual}, but another label: it is not compared with the pair file"
                ));
            }
            return;
        };
        let shown_fields = || file.quote(fields.trim_matches([' ', '\t', '.', ':']));
        let words = fields.to_lowercase();
        let is_internal = INTERNAL.iter().any(|word| words.contains(word))
            || value.starts_with(['-', '\u{2212}']);
        if key == "teeth" && is_internal {
            let reason = format!(
                "{label} is {}: the gear is internal, gearlash reads external gears",
                shown_fields()
            );
            wrong(reason, "name the file of an external gear");
            return;
        }
        let number =
            file_numbers::number(value).filter(|number| number.decimal != Some(Decimal::Comma));
        let is_count = |number: &FileNumber| {
            (1.0..=10_000.0).contains(&number.value) && number.value.fract() == 0.0
        };
        let (number, found, allowed) = match key {
            "helix_angle_deg" => (
                helix_angle(fields, value),
                shown_fields(),
                "a number of degrees",
            ),
            "teeth" => (
                number.filter(is_count),
                file.quote(value),
                "a whole number from 1 on",
            ),
            _ => (number, file.quote(value), "a number with a decimal point"),
        };
        let Some(FileNumber {
            value, rounding, ..
        }) = number
        else {
            let reason = format!("{label} is {found}, allowed is {allowed}");
            wrong(reason, "correct the line, or remove it");
            return;
        };
        let (file, label) = (file.clone(), label.to_owned());
        self.stated.push(Stated {
            file,
            line,
            label,
            key,
            value,
            rounding,
        });
    }

    /// Records which parts of `file` are not used.
    pub fn set_unread(&mut self, file: &DataFile, words: &str) {
        self.unread = Some((file.clone(), words.to_owned()));
    }

    /// Adds a warning about `file`.
    pub fn warn(&mut self, file: &DataFile, words: &str) {
        let (key, name) = (file.key(), file.name());
        self.warnings.push(format!("{key}: {name}: {words}"));
    }

    /// A remark on the parts of the file that are not used.
    pub fn remark(&self) -> Option<String> {
        let (file, words) = self.unread.as_ref()?;
        Some(format!(
            "{}: {}: read and not used here: {words}",
            file.key(),
            file.name()
        ))
    }

    /// The parts of the file that are not used, in words.
    pub fn unread(&self) -> Option<&str> {
        self.unread.as_ref().map(|(_, words)| &words[..])
    }

    /// The number of teeth that a line states.
    pub fn teeth(&self) -> Option<u32> {
        // Whole and within 1 … 10 000.
        self.value("teeth").map(|teeth| teeth as u32)
    }

    fn value(&self, key: &str) -> Option<f64> {
        let mut stated = self.stated.iter();
        stated
            .find(|stated| stated.key == key)
            .map(|stated| stated.value)
    }

    /// Whether a line states a helix angle above 0.
    pub fn is_helical(&self) -> bool {
        self.value("helix_angle_deg")
            .is_some_and(|angle| angle > 0.0)
    }

    /// Radius of the base circle, mm, where lines state teeth, module and pressure angle:
    /// `r_b = m_n z cos α_t/(2 cos β)` with `tan α_t = tan α_n/cos β`.
    pub fn base_radius(&self) -> Option<f64> {
        let normal = self.value("pressure_angle_deg")?.to_radians();
        let reference = 0.5 * self.value("module_mm")? * self.value("teeth")?;
        if !self.is_helical() {
            return Some(reference * normal.cos());
        }
        let cos = self.value("helix_angle_deg")?.to_radians().cos();
        Some(reference / cos * (normal.tan() / cos).atan().cos())
    }

    /// Warnings of header lines that have a known number and an unknown label, and of what a format leaves open.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Reports contradictions to the pair file beyond the rounding of the printed value.
    pub fn check(&self, expected: &ExpectedGear) {
        let design = expected.design;
        for statement in &self.stated {
            let stated = match statement.key {
                "teeth" => f64::from(design.basic_data.teeth()),
                "module_mm" => design.basic_data.module(),
                "pressure_angle_deg" => expected.pressure_angle_deg,
                "profile_shift" => design.profile_shift,
                "tip_diameter_mm" => 2.0 * design.tip_radius(),
                _ => expected.helix_angle_deg,
            };
            // Rounding of the comparison itself: some ulps of the value.
            let allowed = statement.rounding + 1e-12 * stated.abs();
            if (statement.value - stated).abs() > allowed {
                let (label, key) = (&statement.label, statement.key);
                let value = statement.file.bare(&statement.value.to_string());
                statement.file.add_at(
                    statement.line,
                    format!("{label} is {value}, the pair file has {key} = {stated}"),
                    "check that this is the gear's protocol, and correct the pair file or the line",
                );
            }
        }
    }
}

/// The helix angle in `fields`, without its sign, which some machines do not print. Zeros can be beside it.
fn helix_angle<'a>(fields: &'a str, value: &'a str) -> Option<FileNumber<'a>> {
    let words = fields.split([' ', '\t', ':', '°']).chain([value]);
    let numbers: Vec<FileNumber> = words.filter_map(file_numbers::number).collect();
    let mut angles = numbers.iter().filter(|number| number.value != 0.0);
    let angle = angles.next().or(numbers.first())?;
    let is_one = angles.all(|other| other.value.abs() == angle.value.abs());
    is_one.then_some(FileNumber {
        value: angle.value.abs(),
        ..*angle
    })
}

/// The byte length of the label `known` at the start of `text`, if no letter follows it.
fn labelled(text: &str, known: &str) -> Option<usize> {
    let (before, after) = known.split_once('*').unwrap_or((known, ""));
    let rest = text.strip_prefix(before)?;
    let at = rest.find(after)?;
    if rest[..at].chars().count() > 2 {
        return None;
    }
    let rest = &rest[at + after.len()..];
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
