//! What is stated of the mean tooth thickness: the tooth it means, and where it was measured.

use super::toleranced::Toleranced;
use crate::error::GearError;
use crate::gear::{
    BasicGearData, Deviations, Gear, GearDesign, MeasuringBody, Modification, PerTooth,
    PinReadings, Readings, Spans, ThicknessField, thickness,
};

/// One statement of the mean tooth thickness.
#[derive(Debug, Clone, PartialEq)]
pub enum ThicknessStatement {
    /// None: nominal.
    Nominal,
    /// Allowance `A_sn`, µm, at the reference circle in the normal section, negative when thinner than nominal.
    AllowanceUm(Toleranced<f64>),
    /// The allowances of a drawing's tolerance field, such as 25cd.
    Field(ThicknessField),
    /// What both flanks stand out along their normals beyond nominal, mm: printed or cut too thick, or too thin.
    FlankOffset(Toleranced<f64>),
    /// Base tooth thickness `s_bn`, mm, in the normal section.
    BaseThickness(Toleranced<f64>),
    /// A span `W_k`.
    Span {
        /// `k`.
        teeth: u32,
        /// `W_k`, mm.
        mm: Toleranced<f64>,
    },
    /// A dimension over pins or balls, `M_dK` or `M_dR`.
    OverPins {
        /// Which; of a spur gear both are the same.
        body: MeasuringBody,
        /// `D_M`, mm.
        pin_mm: f64,
        /// `M_dK`, mm.
        mm: Toleranced<f64>,
    },
    /// Spans `W_k` read at several teeth.
    SpanReadings {
        /// `k`.
        teeth: u32,
        /// First tooth and span, mm.
        readings: Vec<(u32, f64)>,
        /// Whether they give each tooth's thickness, too, where they determine it.
        per_tooth: bool,
    },
    /// Dimensions over pins or balls read at several spaces.
    PinReadings {
        /// Which.
        body: MeasuringBody,
        /// `D_M`, mm.
        pin_mm: f64,
        /// Space (see [`PinReadings`]) and dimension, mm.
        readings: Vec<(u32, f64)>,
    },
}

impl ThicknessStatement {
    /// Its readings, where it has several: place, from 1, and length, mm.
    pub fn readings(&self) -> Option<&[(u32, f64)]> {
        match self {
            ThicknessStatement::SpanReadings { readings, .. }
            | ThicknessStatement::PinReadings { readings, .. } => Some(readings),
            _ => None,
        }
    }

    /// Checks that its least value is no more than its greatest.
    fn check_range(&self) -> Result<(), GearError> {
        match self {
            ThicknessStatement::AllowanceUm(value)
            | ThicknessStatement::FlankOffset(value)
            | ThicknessStatement::BaseThickness(value)
            | ThicknessStatement::Span { mm: value, .. }
            | ThicknessStatement::OverPins { mm: value, .. }
                if !(value.least() <= value.most()) =>
            {
                Err(GearError::OutOfRange {
                    what: "the least value of the tooth thickness",
                    value: *value.least(),
                    allowed: "a number up to the greatest",
                })
            }
            _ => Ok(()),
        }
    }

    /// The span readings, where these are stated.
    ///
    /// # Errors
    /// Readings that a gear of `basic_data` cannot have.
    pub fn spans(&self, basic_data: &BasicGearData) -> Result<Option<Spans>, GearError> {
        match self {
            ThicknessStatement::SpanReadings {
                teeth, readings, ..
            } => {
                let readings = Readings::new(basic_data, readings.clone())?;
                Spans::new(basic_data, *teeth, readings).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// The readings over pins, where these are stated.
    pub(super) fn pins(
        &self,
        basic_data: &BasicGearData,
    ) -> Result<Option<PinReadings>, GearError> {
        match self {
            ThicknessStatement::PinReadings {
                body,
                pin_mm,
                readings,
            } => {
                let readings = Readings::new(basic_data, readings.clone())?;
                Ok(Some(PinReadings::new(basic_data, *body, *pin_mm, readings)))
            }
            _ => Ok(None),
        }
    }

    /// What each of its readings is beyond their mean, and what the deviations `of` say it is, mm; empty without readings.
    ///
    /// # Errors
    /// Readings that go with no tooth thickness; [`GearError::WrongLength`] for lists of another gear.
    pub fn beside(
        &self,
        basic_data: &BasicGearData,
        of: &Deviations,
    ) -> Result<Vec<(f64, f64)>, GearError> {
        if let Some(spans) = self.spans(basic_data)? {
            return spans.beside(of);
        }
        match self.pins(basic_data)? {
            Some(pins) => pins.beside(of),
            None => Ok(Vec::new()),
        }
    }

    /// Each tooth's thickness beyond the mean of `gear` and `known`, where spans all round are to give and do determine it.
    ///
    /// # Errors
    /// [`GearError::WrongLength`] for lists of another gear; profiles that no gear has.
    pub fn per_tooth(
        &self,
        gear: &Gear,
        known: &Deviations,
    ) -> Result<Option<PerTooth>, GearError> {
        let ThicknessStatement::SpanReadings {
            per_tooth: true, ..
        } = self
        else {
            return Ok(None);
        };
        match self.spans(gear.basic_data())? {
            Some(spans) => self.thickness_beside_profiles(spans, gear, known),
            None => Ok(None),
        }
    }

    /// Mean base tooth thickness `s_b`, mm, of a gear with the deviations `known`: that of the involutes, whose profiles may deviate.
    /// Span and pins are those of the flanks where they touch; allowance, base thickness and nominal thickness those of the involutes.
    ///
    /// # Errors
    /// A range upside down, a tolerance field of a larger gear than its table has, a span of no number of teeth, a dimension over pins whose pins would sit inside the base circle, readings that a
    /// gear of `design` cannot have.
    pub fn base_thickness(
        &self,
        design: &GearDesign,
        known: &Deviations,
    ) -> Result<Toleranced<f64>, GearError> {
        self.check_range()?;
        let basic_data = &design.basic_data;
        let nominal = design.nominal_base_thickness();
        let modified = !known.profiles.iter().all(Modification::is_none);
        match self {
            ThicknessStatement::Nominal => Ok(Toleranced::Single(nominal)),
            ThicknessStatement::AllowanceUm(um) => um.try_map(|&um| {
                let mm = um / 1000.0;
                Ok(thickness::base_from_allowance(basic_data, nominal, mm))
            }),
            ThicknessStatement::Field(field) => {
                let [most, least] = field.allowances_um(basic_data)?;
                ThicknessStatement::AllowanceUm(Toleranced::Band { least, most })
                    .base_thickness(design, known)
            }
            // An involute moved along its normals is the same, turned by the distance on the base circle.
            ThicknessStatement::FlankOffset(mm) => {
                mm.try_map(|mm| Ok(nominal + thickness::base_from_span(basic_data, 1, 2.0 * mm)))
            }
            // In the normal section, as a span over one tooth.
            ThicknessStatement::BaseThickness(mm) => {
                mm.try_map(|mm| Ok(thickness::base_from_span(basic_data, 1, *mm)))
            }
            ThicknessStatement::Span { teeth, mm } => {
                if !(1..=basic_data.teeth()).contains(teeth) {
                    return Err(GearError::OutOfRange {
                        what: "number of teeth spanned",
                        value: f64::from(*teeth),
                        allowed: "1 … number of teeth",
                    });
                }
                if modified {
                    return self.base_of_modified(design, known);
                }
                mm.try_map(|&mm| Ok(thickness::base_from_span(basic_data, *teeth, mm)))
            }
            _ if modified => self.base_of_modified(design, known),
            ThicknessStatement::OverPins { body, pin_mm, mm } => {
                mm.try_map(|&mm| thickness::base_from_over(basic_data, *body, *pin_mm, mm))
            }
            ThicknessStatement::SpanReadings { .. } | ThicknessStatement::PinReadings { .. } => {
                let spans = self.spans(basic_data)?;
                let base = match (spans, self.pins(basic_data)?) {
                    (Some(spans), _) => spans.base_thickness(known)?,
                    (None, Some(pins)) => pins.base_thickness(known)?,
                    (None, None) => nominal,
                };
                Ok(Toleranced::Single(base))
            }
        }
    }

    /// Whether the measurement touches `gear` where it measures its thickness.
    ///
    /// # Errors
    /// A span or a pin that does not touch the involute, a pin below the tip or in the root.
    pub fn check(&self, gear: &Gear) -> Result<(), GearError> {
        match *self {
            ThicknessStatement::Span { teeth, .. }
            | ThicknessStatement::SpanReadings { teeth, .. } => thickness::check_span(gear, teeth),
            ThicknessStatement::OverPins { pin_mm, .. }
            | ThicknessStatement::PinReadings { pin_mm, .. } => thickness::check_pins(gear, pin_mm),
            _ => Ok(()),
        }
    }
}
