//! What a protocol says of the gear in its numbered header lines, held against the pair file.

use super::number;
use crate::gear::Blank;
use crate::input::data_file::DataFile;
use crate::input::problems::Problems;

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

/// The labels, as a protocol prints them before their dots, and the key that states the same.
const LABELS: [(&str, Fact, &str); 7] = [
    ("Zähnezahl", Fact::Teeth, "teeth"),
    ("Normalmodul", Fact::Module, "module_mm"),
    ("Eingriffswinkel", Fact::PressureAngle, "pressure_angle_deg"),
    (
        "Schrägungswinkel",
        Fact::HelixAngle,
        "helix angle (gearlash knows spur gears only)",
    ),
    (
        "Profilverschiebungsfaktor",
        Fact::ProfileShift,
        "profile_shift",
    ),
    ("Kopfkreis", Fact::TipDiameter, "tip_diameter_mm"),
    ("Kopfkreisdurchmesser", Fact::TipDiameter, "tip_diameter_mm"),
];

/// The header lines of one protocol; those of a plain table are none.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Header {
    said: Vec<Said>,
}

#[derive(Debug, Clone, PartialEq)]
struct Said {
    file: DataFile,
    line: u64,
    label: &'static str,
    fact: Fact,
    key: &'static str,
    value: f64,
    rounding: f64,
}

/// The same quantities as the pair file states them.
#[derive(Debug, Clone, Copy)]
pub struct Drawn<'a> {
    /// The gear, its tip diameter filled in.
    pub blank: &'a Blank,
    /// `α`, degrees as written.
    pub pressure_angle_deg: f64,
}

impl Header {
    /// Takes over the line when it is a numbered header line with a known label.
    ///
    /// `  22 :Zähnezahl.............: 44`: a number, a label with its dots, the value after the last colon.
    pub fn take(&mut self, file: &DataFile, line: u64, text: &str, problems: &mut Problems) {
        let rest = text.trim_start();
        let behind = rest.trim_start_matches(|c: char| c.is_ascii_digit());
        if behind.len() == rest.len() {
            return;
        }
        let Some((label, value)) = behind.trim_start_matches([' ', '\t', ':']).rsplit_once(':')
        else {
            return;
        };
        let label = label
            .split(['.', '[', '(', ':', '…'])
            .next()
            .unwrap_or_default()
            .trim();
        let Some(&(label, fact, key)) = LABELS.iter().find(|(known, ..)| *known == label) else {
            return;
        };
        let value = value.trim();
        let Some(written) = number::written(value)
            .filter(|written| written.decimal != Some(number::Decimal::Comma))
        else {
            problems.add(file.problem_at(
                line,
                format!("{label} is {value:?}, allowed is a number with a decimal point"),
                "correct the line, or remove it",
            ));
            return;
        };
        self.said.push(Said {
            file: file.clone(),
            line,
            label,
            fact,
            key,
            value: written.value,
            rounding: written.rounding,
        });
    }

    /// Reports what contradicts the pair file by more than the rounding of the printed value.
    pub fn check(&self, drawn: &Drawn, problems: &mut Problems) {
        let blank = drawn.blank;
        for said in &self.said {
            let stated = match said.fact {
                Fact::Teeth => f64::from(blank.toothing.teeth()),
                Fact::Module => blank.toothing.module(),
                Fact::PressureAngle => drawn.pressure_angle_deg,
                Fact::HelixAngle => 0.0,
                Fact::ProfileShift => blank.profile_shift,
                Fact::TipDiameter => 2.0 * blank.tip_radius(),
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
                    said.label, said.value, said.key
                ),
                "check that this is the gear's protocol, and correct the pair file or the line",
            ));
        }
    }
}
