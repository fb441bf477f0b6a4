//! Statements of the mean tooth thickness, and the base tooth thickness that follows from each.
//!
//! A stated span, a dimension over pins and a pitch belong to the flanks at the points of contact. Profile deviations there are
//! taken out of the reading ([`crate::gear::Excess`]). They depend weakly on the thickness that is sought, so the two are
//! found in turns. All other statements belong to the involute without its deviations.

use crate::error::GearError;
use crate::gear::{
    BasicGearData, Deviations, Excess, FlankShifts, Gear, GearDesign, MeasuringBody, Modification,
    PerTooth, PinReadings, Readings, Spans, ThicknessField, thickness,
};

/// A single value, or its values at least and at most material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Toleranced<T> {
    /// A single value.
    Single(T),
    /// The values of the thinnest and the thickest teeth.
    Band {
        /// At least material.
        least: T,
        /// At most material.
        most: T,
    },
}

impl<T> Toleranced<T> {
    /// The value at most material.
    pub fn most(&self) -> &T {
        match self {
            Toleranced::Single(value) | Toleranced::Band { most: value, .. } => value,
        }
    }

    /// The value at least material.
    pub fn least(&self) -> &T {
        match self {
            Toleranced::Single(value) | Toleranced::Band { least: value, .. } => value,
        }
    }

    /// Whether there are two values.
    pub fn is_band(&self) -> bool {
        matches!(self, Toleranced::Band { .. })
    }

    /// Applies `make` to each value, most material first.
    ///
    /// # Errors
    /// The first error of `make`.
    pub fn try_map<U, E>(
        &self,
        mut make: impl FnMut(&T) -> Result<U, E>,
    ) -> Result<Toleranced<U>, E> {
        Ok(match self {
            Toleranced::Single(value) => Toleranced::Single(make(value)?),
            Toleranced::Band { least, most } => {
                let most = make(most)?;
                Toleranced::Band {
                    least: make(least)?,
                    most,
                }
            }
        })
    }
}

/// Relative change of the thickness that counts as settled: some ulps.
const ROUNDING: f64 = 1e-14;
/// Most rounds of thickness and excess; each leaves about a hundredth of the error.
const MOST_ROUNDS: usize = 30;

/// One statement of the mean tooth thickness.
#[derive(Debug, Clone, PartialEq)]
pub enum ThicknessStatement {
    /// Nominal thickness.
    Nominal,
    /// Allowance `A_sn`, µm, at the reference circle in the normal section, negative when thinner than nominal.
    AllowanceUm(Toleranced<f64>),
    /// Allowances of a tolerance field, such as 25cd.
    Field(ThicknessField),
    /// Offset of both flanks along their normals from nominal, mm, as of a printed gear.
    FlankOffset(Toleranced<f64>),
    /// Base tooth thickness `s_bn`, mm, in the normal section.
    BaseThickness(Toleranced<f64>),
    /// Tooth thickness `s_n`, mm, along the reference circle in the normal section.
    ArcThickness(Toleranced<f64>),
    /// A chord in the normal section.
    Chord {
        /// Depth below the tip, mm; `None`: the chordal addendum of the nominal tooth.
        height_mm: Option<f64>,
        /// The chord, mm.
        mm: Toleranced<f64>,
    },
    /// A span `W_k`.
    Span {
        /// `k`.
        teeth: u32,
        /// `W_k`, mm.
        mm: Toleranced<f64>,
    },
    /// A dimension over pins or balls, `M_dK` or `M_dR`.
    OverPins {
        /// Pins or balls.
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
        /// Whether they also give each tooth's thickness, if they determine it.
        per_tooth: bool,
    },
    /// Dimensions over pins or balls read at several spaces.
    PinReadings {
        /// Pins or balls.
        body: MeasuringBody,
        /// `D_M`, mm.
        pin_mm: f64,
        /// Space (see [`PinReadings`]) and dimension, mm.
        readings: Vec<(u32, f64)>,
    },
}

impl ThicknessStatement {
    /// The readings of several places: place, from 1, and length, mm.
    pub fn readings(&self) -> Option<&[(u32, f64)]> {
        match self {
            ThicknessStatement::SpanReadings { readings, .. }
            | ThicknessStatement::PinReadings { readings, .. } => Some(readings),
            _ => None,
        }
    }

    /// Checks that the least value is at most the greatest.
    fn check_range(&self) -> Result<(), GearError> {
        match self {
            ThicknessStatement::AllowanceUm(value)
            | ThicknessStatement::FlankOffset(value)
            | ThicknessStatement::BaseThickness(value)
            | ThicknessStatement::ArcThickness(value)
            | ThicknessStatement::Chord { mm: value, .. }
            | ThicknessStatement::Span { mm: value, .. }
            | ThicknessStatement::OverPins { mm: value, .. } => GearError::require(
                value.least() <= value.most(),
                "the least value of the tooth thickness",
                *value.least(),
                "a number up to the greatest",
            ),
            _ => Ok(()),
        }
    }

    /// The span readings, if stated.
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

    /// The readings over pins, if stated.
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

    /// Each reading minus the mean, and its value expected from the deviations `of`, mm; empty without readings.
    ///
    /// # Errors
    /// Readings without a possible tooth thickness; [`GearError::WrongLength`] for lists of another gear.
    pub fn compare(
        &self,
        basic_data: &BasicGearData,
        of: &Deviations,
    ) -> Result<Vec<(f64, f64)>, GearError> {
        if let Some(spans) = self.spans(basic_data)? {
            return spans.compare(of);
        }
        match self.pins(basic_data)? {
            Some(pins) => pins.compare(of),
            None => Ok(Vec::new()),
        }
    }

    /// Each tooth's thickness beyond the mean of `gear` and `known`, if requested and determined by spans all round.
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
            Some(spans) => self.thickness_beside_excess(spans, gear, known),
            None => Ok(None),
        }
    }

    /// Mean base tooth thickness `s_b` of the involutes, mm, of a gear with the deviations `known`.
    ///
    /// # Errors
    /// A reversed range, a tolerance field beyond its table, an impossible number of teeth spanned, pins inside the base circle,
    /// readings that a gear of `design` cannot have.
    pub fn base_thickness(
        &self,
        design: &GearDesign,
        known: &Deviations,
    ) -> Result<Toleranced<f64>, GearError> {
        self.check_range()?;
        let basic_data = &design.basic_data;
        let nominal = design.nominal_base_thickness();
        let modified = !known.profiles.iter().all(Modification::is_none)
            || (self.span().is_some() && known.leads_change_spans(basic_data));
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
            // An involute moved along its normals is an involute turned by the distance on the base circle.
            ThicknessStatement::FlankOffset(mm) => {
                mm.try_map(|mm| Ok(nominal + thickness::base_from_span(basic_data, 1, 2.0 * mm)))
            }
            // In the normal section, as a span over one tooth.
            ThicknessStatement::BaseThickness(mm) => {
                mm.try_map(|mm| Ok(thickness::base_from_span(basic_data, 1, *mm)))
            }
            ThicknessStatement::ArcThickness(mm) => mm.try_map(|mm| {
                let allowance = mm - design.nominal_thickness();
                Ok(thickness::base_from_allowance(
                    basic_data, nominal, allowance,
                ))
            }),
            ThicknessStatement::Chord { height_mm, mm } => {
                let height = chord_height(design, *height_mm);
                let tip = design.tip_radius();
                mm.try_map(|&mm| thickness::base_from_chord(basic_data, tip, height, mm))
            }
            ThicknessStatement::Span { teeth, mm } => {
                GearError::require(
                    (1..=basic_data.teeth()).contains(teeth),
                    "number of teeth spanned",
                    f64::from(*teeth),
                    "1 … number of teeth",
                )?;
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
                let base = self.base_touching(basic_data, known, &FlankShifts::default());
                base.map(Toleranced::Single)
            }
        }
    }

    /// Checks that the measurement touches the involutes of `gear`.
    ///
    /// # Errors
    /// A span or a pin that does not touch the involute, a pin below the tip or in the root.
    pub fn check(&self, gear: &Gear) -> Result<(), GearError> {
        match *self {
            ThicknessStatement::Span { teeth, .. }
            | ThicknessStatement::SpanReadings { teeth, .. } => thickness::check_span(gear, teeth),
            ThicknessStatement::OverPins { pin_mm, .. }
            | ThicknessStatement::PinReadings { pin_mm, .. } => thickness::check_pins(gear, pin_mm),
            ThicknessStatement::Chord { height_mm, .. } => {
                thickness::check_chord(gear, chord_height(gear.design(), height_mm))
            }
            _ => Ok(()),
        }
    }

    /// `s_b`, mm, of a gear with the deviations `known`, without the excess of its profiles and leads at the contacts.
    ///
    /// A single reading counts as the mean of all places on a gear without other deviations.
    pub(super) fn base_of_modified(
        &self,
        design: &GearDesign,
        known: &Deviations,
    ) -> Result<Toleranced<f64>, GearError> {
        let teeth = design.basic_data.teeth();
        let alone = Deviations {
            profiles: known.profiles.clone(),
            leads: known.leads.clone(),
            ..Deviations::default()
        };
        let all = |mm: f64| (1..=teeth).map(|place| (place, mm)).collect();
        match self {
            ThicknessStatement::Span { teeth, mm } => mm.try_map(|&mm| {
                let alike = ThicknessStatement::SpanReadings {
                    teeth: *teeth,
                    readings: all(mm),
                    per_tooth: false,
                };
                alike.base_of_readings(design, &alone)
            }),
            ThicknessStatement::OverPins { body, pin_mm, mm } => mm.try_map(|&mm| {
                let alike = ThicknessStatement::PinReadings {
                    body: *body,
                    pin_mm: *pin_mm,
                    readings: all(mm),
                };
                alike.base_of_readings(design, &alone)
            }),
            _ => self.base_of_readings(design, known).map(Toleranced::Single),
        }
    }

    /// `s_b`, mm, from readings of flanks with profile deviations.
    fn base_of_readings(&self, design: &GearDesign, known: &Deviations) -> Result<f64, GearError> {
        let basic_data = &design.basic_data;
        let rounding = 4.0 * f64::EPSILON * basic_data.reference_radius();
        let mut touched = FlankShifts::default();
        let mut base = self.base_touching(basic_data, known, &touched)?;
        let mut last = f64::INFINITY;
        for _ in 0..MOST_ROUNDS {
            // An impossible gear is an error of the thickness.
            let Ok(gear) = Gear::new(*design, base) else {
                return Ok(base);
            };
            touched = self.touched(&gear, known, &touched)?;
            let next = self.base_touching(basic_data, known, &touched)?;
            let change = (next - base).abs();
            base = next;
            // Settled to rounding, or no longer shrinking.
            if change <= rounding || (change >= last && last <= 1e3 * rounding) {
                return Ok(base);
            }
            last = change;
        }
        Err(GearError::Readings(
            "no mean thickness gives these readings with these profiles and leads",
        ))
    }

    /// Excess of the flanks of `gear`, by profiles and leads, where this measurement touches them.
    ///
    /// The excess by leads where balls and pins touch is neglected: some 0.2 µm a flank at a slope of 10 µm over 24 mm.
    pub(super) fn touched(
        &self,
        gear: &Gear,
        known: &Deviations,
        before: &FlankShifts,
    ) -> Result<FlankShifts, GearError> {
        let shifts = match Excess::new(gear, &known.profiles)? {
            None => FlankShifts::default(),
            Some(excess) => match self {
                ThicknessStatement::Span { teeth, .. }
                | ThicknessStatement::SpanReadings { teeth, .. } => {
                    excess.by_span(*teeth, known)?
                }
                ThicknessStatement::OverPins { pin_mm, .. }
                | ThicknessStatement::PinReadings { pin_mm, .. } => {
                    excess.by_pins(*pin_mm, known, before)?
                }
                _ => FlankShifts::default(),
            },
        };
        match self.span() {
            Some(k) => Ok(shifts.plus(&FlankShifts::of_leads(gear, &known.leads, k)?)),
            None => Ok(shifts),
        }
    }

    /// `k` of a span.
    fn span(&self) -> Option<u32> {
        match self {
            ThicknessStatement::Span { teeth, .. }
            | ThicknessStatement::SpanReadings { teeth, .. } => Some(*teeth),
            _ => None,
        }
    }

    /// The thickness of each tooth by `spans` of this statement.
    ///
    /// The thickness moves the contacts and so changes the excess: both are found in turns. The effect on the mean thickness, the
    /// square of a rotation, is neglected: below 0.1 nm.
    pub(super) fn thickness_beside_excess(
        &self,
        spans: Spans,
        gear: &Gear,
        known: &Deviations,
    ) -> Result<Option<PerTooth>, GearError> {
        let mut touched = self.touched(gear, known, &FlankShifts::default())?;
        for _ in 0..MOST_ROUNDS {
            let Some(found) = spans.clone().touching(touched.clone()).per_tooth(known)? else {
                return Ok(None);
            };
            let mut standing = known.clone();
            standing.thicken(&found.thickness);
            let next = self.touched(gear, &standing, &touched)?;
            if next.is_near(&touched, ROUNDING * gear.tip_radius()) {
                return Ok(Some(found));
            }
            touched = next;
        }
        Err(GearError::Readings(
            "no thickness of the teeth gives these readings with these profiles and leads",
        ))
    }

    /// `s_b`, mm, from readings of flanks with the excess `touched` at the contacts.
    fn base_touching(
        &self,
        basic_data: &BasicGearData,
        known: &Deviations,
        touched: &FlankShifts,
    ) -> Result<f64, GearError> {
        let spans = self.spans(basic_data)?;
        match (spans, self.pins(basic_data)?) {
            (Some(spans), _) => spans.touching(touched.clone()).base_thickness(known),
            (None, Some(pins)) => pins.touching(touched.clone()).base_thickness(known),
            (None, None) => Err(GearError::Readings("there is no reading")),
        }
    }
}

/// Depth of a chord below the tip, mm: as stated, or the chordal addendum of the nominal tooth.
pub fn chord_height(design: &GearDesign, stated: Option<f64>) -> f64 {
    let nominal = design.nominal_base_thickness();
    let tip = design.tip_radius();
    stated.unwrap_or_else(|| thickness::chordal_addendum(&design.basic_data, tip, nominal))
}
