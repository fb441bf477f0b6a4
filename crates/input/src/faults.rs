//! Finds the key of a gear's table for a [`MeasurementError`], and a remedy.

use super::findings::suspected;
use super::lead;
use super::pitch;
use super::profile;
use super::runout::RunoutSheet;
use super::spec::{PitchSpec, StatementSpec};
use super::statements::Statements;
use gearlash::error::GearError;
use gearlash::gear::{BasicGearData, Gear, GearDesign, MeasuringBody, thickness};
use gearlash::metrology::{
    DeviationCause, Fits, LeadKey, MeasurementError, Outlier, ProfileKey, StatementRole,
    chord_height,
};
use gearlash_text::numbers::ascii;
use gearlash_text::{Problem, Table};

/// Adds each of `errors`, with the key it comes from.
pub fn add_all(of: &Statements, errors: Vec<MeasurementError>) {
    let mut distinct = Vec::new();
    for error in errors {
        let problem = problem(of, error);
        // A statement about both flanks gives one problem.
        if !distinct.contains(&problem) {
            distinct.push(problem.clone());
            of.table.reading().add(problem);
        }
    }
}

/// Checks the `pitch` itself, and its eccentricity beside `runout`.
pub fn check_pitch(
    table: &Table,
    pitch: &PitchSpec,
    runout: &RunoutSheet,
    basic_data: &BasicGearData,
) -> Option<()> {
    let pitch = pitch.for_metrology();
    let curves = pitch.curves(basic_data).err().into_iter().flatten();
    let eccentricity = pitch.check_eccentricity(&runout.for_metrology()).err();
    let errors: Vec<MeasurementError> = curves.chain(eccentricity).collect();
    let good = errors.is_empty();
    for error in errors {
        let problem = of_flanks(table, runout, error);
        table.reading().add(problem);
    }
    good.then_some(())
}

/// The problem of `error`: key, reason and remedy.
fn problem(of: &Statements, error: MeasurementError) -> Problem {
    let fault = |role, suspects| ThicknessFault { of, role, suspects };
    match error {
        MeasurementError::NoGear {
            role,
            error,
            suspects,
        } => fault(role, suspects).of_gear(error),
        MeasurementError::OffInvolute {
            role,
            error,
            fits,
            suspects,
        } => fault(role, suspects).off_involute(error.to_string(), fits),
        MeasurementError::Thickness { role, error } => {
            fault(role, Vec::new()).pins_inside_base(error.to_string())
        }
        error => of_flanks(of.table, &of.runout, error),
    }
}

/// The problem of an error that does not concern the mean thickness.
fn of_flanks(table: &Table, runout: &RunoutSheet, error: MeasurementError) -> Problem {
    let reason = error.to_string();
    let (key, help) = match error {
        MeasurementError::Deviations {
            cause, suspects, ..
        } => {
            let key = match cause {
                DeviationCause::Spans => "thickness.span",
                DeviationCause::PerTooth => "thickness.per_tooth_um",
                DeviationCause::Pitch => "pitch",
                DeviationCause::Profile => "profile",
                DeviationCause::Lead => "lead",
            };
            let suspected: String = suspects.iter().map(suspected).collect();
            let help = format!("check unit (µm) and sign of the values{suspected}");
            return table.problem(key, reason, help);
        }
        MeasurementError::Profile { flank, key, .. } => {
            let help = match key {
                ProfileKey::Range => "give diameters on the flank",
                ProfileKey::TipRelief | ProfileKey::RootRelief => {
                    "check unit (µm) and diameter of the relief"
                }
                _ => "check unit (µm) and sign of the profile deviations",
            };
            return table.problem(&profile::key_of(table, flank, key), reason, help);
        }
        MeasurementError::Lead { flank, key, .. } => {
            let help = match key {
                LeadKey::Range => "give two heights on the teeth",
                LeadKey::EndRelief => "check unit (µm) and length of the relief",
                _ => "check unit (µm) and sign of the lead deviations",
            };
            return table.problem(&lead::key_of(table, flank, key), reason, help);
        }
        MeasurementError::DatumLeads(_) => (
            "lead.axis",
            "give traces of single teeth of both flanks and the runout with its high_tooth; or write axis = \"own\" where the wobble is not in them",
        ),
        MeasurementError::PitchOffHalf { flank, .. } => (
            pitch::key_of(table, flank),
            "check the unit (µm) and whether the values are single or cumulative",
        ),
        MeasurementError::Pitch(_) => ("pitch", "give one value a tooth for both flanks"),
        MeasurementError::EccentricityTwice => {
            return table.problem(
                "pitch.axis",
                "pitch measured about the datum axis already contains the eccentricity; [runout] would count it twice",
                "remove the runout, or say in [pitch] which is used: eccentricity = \"pitch\" or \"runout\"; \
                 write axis = \"own\" if the values are free of eccentricity",
            );
        }
        MeasurementError::NoRunout => (
            "pitch.eccentricity",
            "add [runout] with total_um and high_tooth, or write eccentricity = \"pitch\"",
        ),
        MeasurementError::NoEccentricityInOwnPitch => {
            return table.problem(
                "pitch.eccentricity",
                "goes with axis = \"datum\" only: values about the gear's own axis contain no eccentricity",
                "remove it, or write axis = \"datum\"",
            );
        }
        MeasurementError::DatumPitch(_) => (
            "pitch.axis",
            "check the values, or write axis = \"own\" if they are free of eccentricity",
        ),
        MeasurementError::NotSettled => (
            "pitch.axis",
            "check the pitch values and the readings of the thickness",
        ),
        MeasurementError::Runout(_) => ("runout.file", "check the readings and their unit, µm"),
        MeasurementError::RunoutBeyondDepth { .. } => (runout.key(), "check the unit: µm"),
        MeasurementError::Ball(_) => ("runout.ball_mm", "check it: about 1.7 modules is usual"),
        MeasurementError::NoBall => (
            "runout.file",
            "give total_um and high_tooth in place of the file",
        ),
        MeasurementError::PerTooth(_)
        | MeasurementError::Thickness { .. }
        | MeasurementError::NoGear { .. }
        | MeasurementError::OffInvolute { .. } => ("thickness.span", "check the readings"),
    };
    table.problem(key, reason, help)
}

/// An error of one statement of the thickness.
struct ThicknessFault<'a> {
    of: &'a Statements<'a>,
    role: StatementRole,
    suspects: Vec<Outlier>,
}

impl ThicknessFault<'_> {
    fn suspected(&self) -> String {
        self.suspects.iter().map(suspected).collect()
    }

    /// A problem of a key below the statement's table.
    fn at(&self, key: &str, reason: String, help: String) -> Problem {
        let (_, under) = self.of.of_thickness(self.role);
        let key = format!("{under}.{key}");
        self.of.table.problem(&key, reason, help)
    }

    /// A problem of the whole tooth. It blames the thickness where a nominal tooth would work.
    fn of_gear(&self, error: GearError) -> Problem {
        let (table, design) = (self.of.table, &self.of.design);
        let reason = error.to_string();
        // The first of these keys that is given moves the tip.
        let mut tip_keys = ["tip_diameter_mm", "profile_shift", "rack.addendum"].into_iter();
        let tip_key = tip_keys.find(|key| table.has(key));
        let tip_key = tip_key.unwrap_or("profile_shift");
        let tip_given = tip_key == "tip_diameter_mm";
        let (reason, key, help) = match error {
            // Rounded down, so that the printed value fits.
            GearError::TipRoundTooLarge { most, .. } if most >= 0.0 => {
                let is_stated = table.has("rack.root_radius");
                let (which, verb) = if is_stated {
                    ("", "reduce it to")
                } else {
                    ("the default is ", "state rack.root_radius =")
                };
                return table.problem(
                    "rack.root_radius",
                    format!(
                        "{which}too large for the tool's tip, allowed is up to {} modules with this dedendum and pressure angle",
                        ascii(most, 6)
                    ),
                    format!(
                        "{verb} {} or less, or reduce rack.dedendum",
                        ascii((1e4 * most).floor() / 1e4, 4)
                    ),
                );
            }
            GearError::TipRoundTooLarge { .. } => return table.problem(
                "rack.root_radius",
                "no round is small enough: with this dedendum and pressure angle the tool's tip is pointed",
                "reduce rack.dedendum",
            ),
            GearError::Pointed {
                pointed_diameter_mm,
                ..
            } => {
                let below = format!("below {} mm", ascii(pointed_diameter_mm, 3));
                let help = if tip_given {
                    format!("give a tip diameter {below}")
                } else {
                    format!("reduce it, or give a tip_diameter_mm {below}")
                };
                (reason, tip_key, help)
            }
            GearError::NoInvolute {
                form_diameter_mm, ..
            } => {
                let help = if tip_given {
                    format!("give a tip diameter above {} mm", ascii(form_diameter_mm, 3))
                } else {
                    "give a greater profile shift, addendum or number of teeth".to_owned()
                };
                (reason, tip_key, help)
            }
            GearError::NoSpace { .. } => {
                let depth =
                    design.basic_data.module() * (design.rack.dedendum() - design.profile_shift);
                let root = design.basic_data.reference_radius() - depth;
                if root > 0.0 {
                    (reason, "profile_shift", "reduce the profile shift".to_owned())
                } else {
                    let root = ascii(root, 4);
                    let reason = format!("the root radius would be {root} mm, allowed is above 0");
                    let help = "reduce the dedendum, or give a greater profile shift".to_owned();
                    (reason, "rack.dedendum", help)
                }
            }
            GearError::NoNeck { .. } => {
                let help = "give a greater profile shift, more teeth or a rack with less dedendum";
                (reason, "profile_shift", help.to_owned())
            }
            GearError::OutOfRange { value, .. } => {
                let value = ascii(value, 4);
                let reason =
                    format!("makes the base tooth thickness {value} mm, allowed is above 0");
                (reason, "profile_shift", "give a greater profile shift".to_owned())
            }
            _ => {
                let help = "reduce the profile shift, or give the rack more dedendum";
                (reason, "profile_shift", help.to_owned())
            }
        };
        let (statement, _) = self.of.of_thickness(self.role);
        match statement.key() {
            Some(key) if Gear::nominal(*design).is_ok() => {
                let (nominal, suspected) = (nominal(statement, design), self.suspected());
                let help = format!("check the measurement: {nominal}{suspected}");
                self.at(key, reason, help)
            }
            _ => table.problem(key, reason, help),
        }
    }

    fn pins_inside_base(&self, reason: String) -> Problem {
        let (statement, under) = self.of.of_thickness(self.role);
        let help = format!(
            "check the measurement: {}",
            nominal(statement, &self.of.design)
        );
        if statement.chordal_thickness.is_some() {
            return self.at("chordal_thickness", reason, help);
        }
        if statement.designation.is_some() {
            let help = "give allowance_um = { upper = …, lower = … }".to_owned();
            return self.at("designation", reason, help);
        }
        let mut keys = ["min_mm", "file"].into_iter();
        let given = keys.find(|key| self.of.table.has(&format!("{under}.over_pins.{key}")));
        let base = ascii(2.0 * self.of.design.basic_data.base_radius(), 4);
        let reason = format!("{reason} (the base diameter is {base} mm)");
        self.at(
            &format!("over_pins.{}", given.unwrap_or("mm")),
            reason,
            help,
        )
    }

    fn off_involute(&self, reason: String, fits: Fits) -> Problem {
        let suspected = self.suspected();
        let (key, help) = match fits {
            Fits::Spans(_) if !suspected.is_empty() => {
                ("span", format!("check the readings{suspected}"))
            }
            Fits::Spans(Some((few, many))) if few < many => (
                "span.teeth",
                format!("measure over {few} … {many} teeth, and give that span"),
            ),
            Fits::Spans(Some((only, _))) => (
                "span.teeth",
                format!("measure over {only} teeth, and give that span"),
            ),
            Fits::Spans(None) => (
                "span.teeth",
                "no span fits this gear: measure over pins".to_owned(),
            ),
            Fits::Pin(Some(pin)) => (
                "over_pins.pin_mm",
                format!(
                    "measure over pins of about {} mm, and give that dimension",
                    ascii(pin, 3)
                ),
            ),
            Fits::Chord => (
                "chordal_thickness",
                "check height_mm; without it the chordal addendum is taken".to_owned(),
            ),
            Fits::Pin(None) => (
                "over_pins.pin_mm",
                "measure over other pins, or give the span".to_owned(),
            ),
        };
        self.at(key, reason, help)
    }
}

/// The measurement of a nominal tooth: "nominal is 50.6 mm".
fn nominal(statement: &StatementSpec, design: &GearDesign) -> String {
    let basic_data = &design.basic_data;
    let base = design.nominal_base_thickness();
    if let Some(span) = &statement.span {
        let (k, mm) = (
            span.teeth,
            thickness::span_from_base(basic_data, span.teeth, base),
        );
        return format!("nominal over {k} teeth is {} mm", ascii(mm, 4));
    }
    if let Some(pins) = &statement.over_pins {
        let (body, pin_mm) = (pins.kind.unwrap_or_default(), pins.pin_mm);
        let over = thickness::over_from_base(basic_data, body, pin_mm, base);
        let name = match (body, basic_data.hand()) {
            (MeasuringBody::Ball, Some(_)) => "balls",
            _ => "pins",
        };
        return format!(
            "nominal over {name} of {pin_mm} mm is {} mm",
            ascii(over, 4)
        );
    }
    if let Some(chord) = &statement.chordal_thickness {
        let height = chord_height(design, chord.height_mm);
        let mm = thickness::chord_from_base(basic_data, design.tip_radius(), height, base);
        return format!(
            "nominal is {} mm, {} mm below the tip",
            ascii(mm, 4),
            ascii(height, 4)
        );
    }
    match statement.key() {
        Some("flank_offset_mm") => "nominal is 0 mm".to_owned(),
        Some("allowance_um" | "designation") => "nominal is 0 µm".to_owned(),
        Some("arc_thickness_mm") => {
            format!("nominal is {} mm", ascii(design.nominal_thickness(), 4))
        }
        _ => format!("nominal is {} mm", ascii(base, 4)),
    }
}
