//! What a statement of the thickness says of the gear: the tooth it means, and where it was measured.

use super::readings::LengthReadings;
use super::stated::Stated;
use super::thickness::Statement;
use gearlash::error::GearError;
use gearlash::gear::{
    BasicGearData, Deviations, Gear, GearDesign, PerTooth, PinReadings, Spans, thickness,
};

impl Statement {
    /// Spans all round, where these are stated.
    ///
    /// # Errors
    /// None for a statement that was read for this basic_data.
    pub fn spans(&self, basic_data: &BasicGearData) -> Result<Option<Spans>, GearError> {
        match self {
            Statement::Spans {
                teeth, readings, ..
            } => Spans::new(basic_data, *teeth, readings.on(basic_data)?).map(Some),
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
        match self {
            Statement::Spans { .. } => match self.spans(basic_data)? {
                Some(spans) => spans.beside(of),
                None => Ok(Vec::new()),
            },
            Statement::Pins { pin_mm, readings } => {
                PinReadings::new(basic_data, *pin_mm, readings.on(basic_data)?).beside(of)
            }
            _ => Ok(Vec::new()),
        }
    }

    /// Its readings, where it has them all round.
    pub fn readings(&self) -> Option<&LengthReadings> {
        match self {
            Statement::Spans { readings, .. } | Statement::Pins { readings, .. } => Some(readings),
            _ => None,
        }
    }

    /// Each tooth's thickness beyond the mean and `known`, where spans all round are to give and do determine it.
    ///
    /// # Errors
    /// [`GearError::WrongLength`] for lists of another gear.
    pub fn per_tooth(
        &self,
        basic_data: &BasicGearData,
        known: &Deviations,
    ) -> Result<Option<PerTooth>, GearError> {
        match self {
            Statement::Spans {
                per_tooth: true, ..
            } => match self.spans(basic_data)? {
                Some(spans) => spans.per_tooth(known),
                None => Ok(None),
            },
            _ => Ok(None),
        }
    }

    /// Mean base tooth thickness `s_b`, mm, of a gear with the deviations `known`.
    ///
    /// # Errors
    /// A dimension over pins whose pins would sit inside the base circle.
    pub fn base_thickness(
        &self,
        design: &GearDesign,
        known: &Deviations,
    ) -> Result<Stated<f64>, GearError> {
        let basic_data = &design.basic_data;
        let nominal = design.nominal_base_thickness();
        match self {
            Statement::Nominal => Ok(Stated::Single(nominal)),
            Statement::Span { teeth, mm } => {
                mm.try_map(|&mm| Ok(thickness::base_from_span(basic_data, *teeth, mm)))
            }
            Statement::OverPins { pin_mm, mm } => {
                mm.try_map(|&mm| thickness::base_from_pins(basic_data, *pin_mm, mm))
            }
            Statement::Spans {
                teeth, readings, ..
            } => Spans::new(basic_data, *teeth, readings.on(basic_data)?)?
                .base_thickness(known)
                .map(Stated::Single),
            Statement::Pins { pin_mm, readings } => {
                let pins = PinReadings::new(basic_data, *pin_mm, readings.on(basic_data)?);
                pins.base_thickness(known).map(Stated::Single)
            }
            Statement::Allowance(um) => um.try_map(|&um| {
                Ok(thickness::base_from_allowance(
                    basic_data,
                    nominal,
                    um / 1000.0,
                ))
            }),
            Statement::Base(mm) => Ok(*mm),
        }
    }

    /// Whether the measurement touches `gear` where it measures its thickness.
    ///
    /// # Errors
    /// A span or a pin that does not touch the involute, a pin below the tip or in the root.
    pub fn check(&self, gear: &Gear) -> Result<(), GearError> {
        match *self {
            Statement::Span { teeth, .. } | Statement::Spans { teeth, .. } => {
                thickness::check_span(gear, teeth)
            }
            Statement::OverPins { pin_mm, .. } | Statement::Pins { pin_mm, .. } => {
                thickness::check_pins(gear, pin_mm)
            }
            _ => Ok(()),
        }
    }

    /// What the nominal tooth would measure: "nominal is 50.6 mm".
    pub fn nominal(&self, design: &GearDesign) -> String {
        let basic_data = &design.basic_data;
        let base = design.nominal_base_thickness();
        match *self {
            Statement::Nominal | Statement::Base(_) => format!("nominal is {base:.4} mm"),
            Statement::Span { teeth, .. } | Statement::Spans { teeth, .. } => {
                let span = thickness::span_from_base(basic_data, teeth, base);
                format!("nominal over {teeth} teeth is {span:.4} mm")
            }
            Statement::OverPins { pin_mm, .. } | Statement::Pins { pin_mm, .. } => {
                let over = thickness::pins_from_base(basic_data, pin_mm, base);
                format!("nominal over pins of {pin_mm} mm is {over:.4} mm")
            }
            Statement::Allowance(_) => "nominal is 0 µm".to_owned(),
        }
    }
}
