//! Which key of a gear's table a [`GearError`] comes from, and the way out.

use super::problems::Problems;
use super::slips::{self, Outlier};
use super::stated::Stated;
use super::table::Table;
use super::thickness::Statement;
use crate::error::Problem;
use gearlash::error::GearError;
use gearlash::gear::{AsBuilt, Deviations, Face, Gear, GearDesign, thickness};

/// A gear as drawn, and the table that drew it.
pub struct Drawing<'a> {
    /// `[wheel]` or `[pinion]`.
    pub table: &'a Table<'a>,
    /// What it says of the design, the tip diameter filled in.
    pub design: GearDesign,
    /// What it says of the thickness.
    pub statement: Statement,
    /// The table of that statement, below the gear's.
    pub under: &'static str,
}

impl Drawing<'_> {
    /// The gear in one or both materials, its thickness measurement checked against it.
    ///
    /// `known` is what its readings all round contain beside the mean thickness.
    pub fn gears(&self, known: &Deviations, problems: &mut Problems) -> Option<Stated<Gear>> {
        let design = &self.design;
        let round = design.rack.check_tip_round(&design.basic_data);
        problems.keep(round.map_err(|error| self.fault(error, known)))?;
        let base = self.statement.base_thickness(design, known);
        let base = problems.keep(base.map_err(|error| self.pins_inside_base(error)))?;
        let gears = base.try_map(|&base| Gear::new(*design, base));
        let gears = problems.keep(gears.map_err(|error| self.fault(error, known)))?;
        let checked = gears.try_map(|gear| {
            let check = self.statement.check(gear);
            check.map_err(|error| self.off_involute(error, gear, known))
        });
        problems.keep(checked)?;
        Some(gears)
    }

    /// The gears with `deviations`.
    pub fn as_built(
        &self,
        gears: &Stated<Gear>,
        face: Face,
        deviations: &Deviations,
        slips: &[Outlier],
        problems: &mut Problems,
    ) -> Option<Stated<AsBuilt>> {
        let as_built = gears.try_map(|gear| {
            AsBuilt::new(gear.clone(), face, deviations).map_err(|error| {
                let thickness_alone = Deviations {
                    pitch: None,
                    ..deviations.clone()
                };
                let key = match AsBuilt::new(gear.clone(), face, &thickness_alone) {
                    Err(_) if matches!(self.statement, Statement::Spans { .. }) => "thickness.span",
                    Err(_) => "thickness.per_tooth_um",
                    Ok(_) => "pitch",
                };
                let mut help = "check unit (µm) and sign of the values".to_owned();
                for slip in slips {
                    help += &slip.suspected();
                }
                self.table.problem(key, error.to_string(), help)
            })
        });
        problems.keep(as_built)
    }

    /// The key that makes the tooth what it is: the thickness where a nominal tooth would do.
    fn shape_key(&self, otherwise: &str) -> String {
        match self.statement.key() {
            Some(key) if Gear::nominal(self.design).is_ok() => format!("{}.{key}", self.under),
            _ => otherwise.to_owned(),
        }
    }

    /// A problem of the whole tooth: blame the thickness, or `otherwise` with its way out.
    fn shape(
        &self,
        reason: String,
        otherwise: &'static str,
        help: String,
        known: &Deviations,
    ) -> Problem {
        let key = self.shape_key(otherwise);
        let help = if key == otherwise {
            help
        } else {
            let nominal = self.statement.nominal(&self.design);
            let slip = slips::in_readings(self, known);
            let suspected = slip.map_or(String::new(), |slip| slip.suspected());
            format!("check the measurement: {nominal}{suspected}")
        };
        self.table.problem(&key, reason, help)
    }

    fn fault(&self, error: GearError, known: &Deviations) -> Problem {
        let reason = error.to_string();
        // What moves the tip: the first of these that was given.
        let tip_key = ["tip_diameter_mm", "profile_shift", "rack.addendum"]
            .into_iter()
            .find(|key| self.table.has(key))
            .unwrap_or("profile_shift");
        let tip_given = tip_key == "tip_diameter_mm";
        match error {
            // Rounded down: what is printed fits.
            GearError::TipRoundTooLarge { most, .. } if most >= 0.0 => self.table.problem(
                "rack.root_radius",
                format!("too large for the tool's tip, allowed is up to {most:.6} modules with this dedendum and pressure angle"),
                format!(
                    "reduce it to {:.4} or less, or reduce rack.dedendum",
                    (1e4 * most).floor() / 1e4
                ),
            ),
            GearError::TipRoundTooLarge { .. } => self.table.problem(
                "rack.root_radius",
                "no round is small enough: with this dedendum and pressure angle the tool's tip is pointed",
                "reduce rack.dedendum",
            ),
            GearError::Pointed {
                pointed_diameter_mm,
                ..
            } => {
                let below = format!("below {pointed_diameter_mm:.3} mm");
                let help = if tip_given {
                    format!("give a tip diameter {below}")
                } else {
                    format!("reduce it, or give a tip_diameter_mm {below}")
                };
                self.shape(reason, tip_key, help, known)
            }
            GearError::NoInvolute {
                form_diameter_mm, ..
            } => {
                let help = if tip_given {
                    format!("give a tip diameter above {form_diameter_mm:.3} mm")
                } else {
                    "give a greater profile shift, addendum or number of teeth".to_owned()
                };
                self.shape(reason, tip_key, help, known)
            }
            GearError::NoSpace { .. } => {
                let rack = &self.design.rack;
                let basic_data = &self.design.basic_data;
                let depth = basic_data.module() * (rack.dedendum() - self.design.profile_shift);
                let root = basic_data.reference_radius() - depth;
                if root > 0.0 {
                    let help = "reduce the profile shift".to_owned();
                    self.shape(reason, "profile_shift", help, known)
                } else {
                    self.shape(
                        format!("the root radius would be {root:.4} mm, allowed is above 0"),
                        "rack.dedendum",
                        "reduce the dedendum, or give a greater profile shift".to_owned(),
                        known,
                    )
                }
            }
            GearError::NoNeck { .. } => self.shape(
                reason,
                "profile_shift",
                "give a greater profile shift, more teeth or a rack with less dedendum".to_owned(),
                known,
            ),
            GearError::OutOfRange { value, .. } => self.shape(
                format!("makes the base tooth thickness {value:.4} mm, allowed is above 0"),
                "profile_shift",
                "give a greater profile shift".to_owned(),
                known,
            ),
            _ => self.shape(
                reason,
                "profile_shift",
                "reduce the profile shift, or give the rack more dedendum".to_owned(),
                known,
            ),
        }
    }

    fn pins_inside_base(&self, error: GearError) -> Problem {
        let key = match &self.statement {
            Statement::OverPins { mm, .. } if mm.is_band() => "over_pins.min_mm".to_owned(),
            Statement::Pins { readings, .. } => format!("over_pins.{}", readings.key()),
            _ => "over_pins.mm".to_owned(),
        };
        let base = 2.0 * self.design.basic_data.base_radius();
        let nominal = self.statement.nominal(&self.design);
        self.table.problem(
            &format!("{}.{key}", self.under),
            format!("{error} (the base diameter is {base:.4} mm)"),
            format!("check the measurement: {nominal}"),
        )
    }

    fn off_involute(&self, error: GearError, gear: &Gear, known: &Deviations) -> Problem {
        let reason = error.to_string();
        if let Statement::Span { .. } | Statement::Spans { .. } = self.statement {
            let fits = |teeth: &u32| thickness::check_span(gear, *teeth).is_ok();
            let teeth = gear.basic_data().teeth();
            let help = match ((2..=teeth).find(fits), (2..=teeth).rev().find(fits)) {
                (Some(few), Some(many)) if few < many => {
                    format!("measure over {few} … {many} teeth, and give that span")
                }
                (Some(only), _) => format!("measure over {only} teeth, and give that span"),
                _ => "no span fits this gear: measure over pins".to_owned(),
            };
            if let Some(slip) = slips::in_readings(self, known) {
                let help = format!("check the readings{}", slip.suspected());
                return self
                    .table
                    .problem(&format!("{}.span", self.under), reason, help);
            }
            let key = format!("{}.span.teeth", self.under);
            return self.table.problem(&key, reason, help);
        }
        let (form, tip) = (gear.form_roll(), gear.tip_roll());
        // Halfway up the involute first; a pin that touches higher is larger and stands out further.
        let fitting = [0.5, 0.6, 0.7, 0.8, 0.9]
            .map(|part| {
                let roll = form + part * (tip - form);
                thickness::pin_touching(gear.basic_data(), roll, gear.base_thickness())
            })
            .into_iter()
            .find(|&pin| pin > 0.0 && thickness::check_pins(gear, pin).is_ok());
        let help = match fitting {
            Some(pin) => format!("measure over pins of about {pin:.3} mm, and give that dimension"),
            None => "measure over other pins, or give the span".to_owned(),
        };
        let key = format!("{}.over_pins.pin_mm", self.under);
        self.table.problem(&key, reason, help)
    }
}
