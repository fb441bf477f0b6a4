//! The thickness of a tooth in a REXS file.

use super::attributes::{Attributes, MICROMETRE, MILLIMETRE, NUMBER, ROUNDING_UM, differ};
use super::document::shown;
use gearlash::gear::{BasicGearData, MeasuringBody, ThicknessField};
use gearlash_text::numbers::{fixed, rounded, shortest};
use std::fmt;

const SPAN: &str = "span_measurement";
const SPANNED: &str = "number_of_teeth_for_span_measurement";
const PIN: &str = "diameter_of_measuring_ball_or_pin";
/// Names of the dimension over pins or balls. All three are equal for a spur gear.
const SIZES: [(&str, MeasuringBody); 3] = [
    ("size_over_pins", MeasuringBody::Pin),
    ("size_over_balls", MeasuringBody::Ball),
    (DIAMETRAL, MeasuringBody::Pin),
];
/// The dimension over unspecified bodies, balls or pins.
const DIAMETRAL: &str = "diametral_measurement";
/// The series of DIN 3967, as version 1.0 names it and as later ones do.
const SERIES: [&str; 2] = [
    "tooth_thickness_deviation_tolerance_series_din_3967_1978",
    "din_3967_deviation_tolerance_series",
];
/// Limits of the thickness in forms that are not read. A gear with no other statement is not assumed to be nominal.
const OTHER_LIMITS: [&str; 6] = [
    "upper_backlash_allowance_balls_or_pins",
    "lower_backlash_allowance_balls_or_pins",
    "chordal_tooth_thickness_upper_deviation",
    "chordal_tooth_thickness_lower_deviation",
    "chordal_transverse_tooth_thickness_upper_deviation",
    "chordal_transverse_tooth_thickness_lower_deviation",
];

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Thickness {
    /// A series of DIN 3967.
    Series(ThicknessField),
    /// Normal, at the reference cylinder, µm.
    Allowance { upper: f64, lower: f64 },
    /// mm.
    Span { teeth: u32, mm: f64 },
    /// mm.
    OverPins {
        body: MeasuringBody,
        pin: f64,
        mm: f64,
    },
}

/// Generated profile shifts are printed in three decimals.
const ROUNDING_SHIFT: f64 = 0.0005;

impl Thickness {
    /// Upper and lower allowance, µm; `None` for a measured length.
    fn allowances_um(&self, basic_data: &BasicGearData) -> Result<Option<[f64; 2]>, String> {
        match self {
            Thickness::Series(field) => field
                .allowances_um(basic_data)
                .map(Some)
                .map_err(|error| error.to_string()),
            Thickness::Allowance { upper, lower } => Ok(Some([*upper, *lower])),
            Thickness::Span { .. } | Thickness::OverPins { .. } => Ok(None),
        }
    }

    fn words(&self) -> String {
        match self {
            Thickness::Series(field) => field.to_string(),
            Thickness::Allowance { .. } => "the allowance of its span".to_owned(),
            Thickness::Span { .. } => SPAN.to_owned(),
            Thickness::OverPins { .. } => "the size over pins".to_owned(),
        }
    }
}

/// Checks the allowances of a span against the series.
fn agree(field: ThicknessField, span: [f64; 2], basic_data: &BasicGearData) -> Result<(), String> {
    let series = field
        .allowances_um(basic_data)
        .map_err(|error| error.to_string())?;
    if differ(series, span) {
        Err(format!(
            "contradicts itself: {field} is {} / {} µm, the allowances of its span make {} / {} µm",
            fixed(series[0], 1),
            fixed(series[1], 1),
            fixed(span[0], 1),
            fixed(span[1], 1)
        ))
    } else {
        Ok(())
    }
}

/// The statements of the thickness: series, allowances, and without either, measured lengths.
///
/// `shift` is the profile shift coefficient that the thickness without allowance has. Where nothing else states the thickness, the
/// generated profile shift does; beside series or allowances it must lie within them.
/// Errors: a statement is incomplete, is not read, or contradicts another.
pub fn stated(
    gear: &Attributes,
    basic_data: &BasicGearData,
    shift: f64,
    generated: &Generated,
    remarks: &mut Vec<String>,
) -> Result<Vec<Thickness>, String> {
    let place = gear.component().place();
    let mut stated = limits(gear, basic_data)?;
    if stated.is_empty() {
        stated = lengths(gear, basic_data)?;
    }
    match generated {
        Generated::None => {}
        Generated::Several(values) if stated.is_empty() => {
            return Err(gear.left_out(format!(
                "states its thickness by {values} alone, which differ: add its DIN 3967 series or the allowances of its span"
            )));
        }
        Generated::Several(values) => {
            remarks.push(format!("{place}: {values} differ and are not used"));
        }
        Generated::One(one) => {
            let made = one.allowances_um(shift, basic_data);
            let words = format!(
                "{one} makes {} / {} µm",
                fixed(made[0], 1),
                fixed(made[1], 1)
            );
            match stated.first() {
                None if one.is(shift) => {}
                None => {
                    let [upper, lower] = made;
                    stated.push(Thickness::Allowance { upper, lower });
                    remarks.push(format!("{place} has no other thickness: {words}"));
                }
                // Programs write the profile shift itself where no generated one was entered.
                Some(first) if one.is(shift) => {
                    remarks.push(format!("{place}: {words}, {} counts", first.words()));
                }
                Some(first) => match first
                    .allowances_um(basic_data)
                    .map_err(|why| gear.left_out(why))?
                {
                    None => remarks.push(format!(
                        "{place}: {words}, which is not compared: {} counts",
                        first.words()
                    )),
                    Some(band) => {
                        let slack = ROUNDING_UM + um_of_shift(basic_data) * ROUNDING_SHIFT;
                        if made[0] > band[0] + slack || made[1] < band[1] - slack {
                            return Err(gear.left_out(format!(
                                "contradicts itself: {} is {} / {} µm, {words}",
                                first.words(),
                                fixed(band[0], 1),
                                fixed(band[1], 1)
                            )));
                        }
                    }
                },
            }
        }
    }
    Ok(stated)
}

fn limits(gear: &Attributes, basic_data: &BasicGearData) -> Result<Vec<Thickness>, String> {
    let mut stated = Vec::new();
    if let Some(series) = SERIES.iter().find_map(|id| gear.text(id)) {
        let field = series.parse().map_err(|error| {
            let place = gear.component().place();
            format!("{place}: {}: {error}", shown(series))
        })?;
        stated.push(Thickness::Series(field));
    }
    let span = ["upper", "lower"].map(|end| format!("{end}_backlash_allowance_referenced_to_span"));
    let upper = gear.number(&span[0], MICROMETRE)?;
    let lower = gear.number(&span[1], MICROMETRE)?;
    match (upper, lower) {
        (Some(upper), Some(lower)) => {
            // W_k changes by A_sn cos α_n.
            let [upper, lower] =
                [upper, lower].map(|um| rounded(um / basic_data.pressure_angle().cos(), 6));
            match stated[..] {
                [Thickness::Series(field)] => {
                    agree(field, [upper, lower], basic_data).map_err(|why| gear.left_out(why))?;
                }
                _ => stated.push(Thickness::Allowance { upper, lower }),
            }
        }
        (None, None) => {}
        _ => {
            return Err(gear.left_out(format!(
                "has one of {} and {} without the other",
                span[0], span[1]
            )));
        }
    }
    Ok(stated)
}

fn lengths(gear: &Attributes, basic_data: &BasicGearData) -> Result<Vec<Thickness>, String> {
    let mut stated = Vec::new();
    if let Some(other) = OTHER_LIMITS
        .into_iter()
        .find(|id| gear.component().attribute(id).is_some())
    {
        return Err(gear.left_out(format!(
            "limits its thickness by {other} alone, which is not read: add its DIN 3967 series or the allowances of its span"
        )));
    }
    if let Some(mm) = gear.number(SPAN, MILLIMETRE)?
        && let Some(teeth) = gear.count(SPANNED)?
    {
        stated.push(Thickness::Span { teeth, mm });
    }
    if let Some(pin) = gear.number(PIN, MILLIMETRE)? {
        for (size, body) in SIZES {
            if size == DIAMETRAL && basic_data.hand().is_some() {
                continue;
            }
            if let Some(mm) = gear.number(size, MILLIMETRE)? {
                stated.push(Thickness::OverPins { body, pin, mm });
                break;
            }
        }
    }
    let unsaid = basic_data.hand().is_some() && gear.component().attribute(DIAMETRAL).is_some();
    if unsaid && stated.is_empty() {
        return Err(gear.left_out(format!(
            "has {DIAMETRAL} alone, which on a helical gear is over balls or over pins: add size_over_balls or size_over_pins"
        )));
    }
    let mut lengths = [SPAN].into_iter().chain(SIZES.map(|(size, _)| size));
    let length = lengths.find(|id| gear.component().attribute(id).is_some());
    match length.filter(|_| stated.is_empty()) {
        Some(length) => Err(gear.left_out(format!("has {length} without {SPANNED} or {PIN}"))),
        None => Ok(stated),
    }
}

const SHIFT: &str = "generated_addendum_modification_coefficient";

/// The generated profile shift that the settings of a gear, its flanks, or the gear itself state.
pub enum Generated {
    None,
    One(GeneratedShift),
    /// Different ones, in words: the last manufacturing step is unknown.
    Several(String),
}

/// A generated profile shift coefficient `x_E`, in modules.
pub struct GeneratedShift {
    shift: f64,
    /// Upper and lower.
    deviations: [f64; 2],
    place: String,
}

impl Generated {
    /// The shift that all `sources` state.
    /// Errors: no number, or one deviation without the other.
    pub fn read<'a, 'b: 'a>(
        sources: impl Iterator<Item = &'a Attributes<'b>>,
    ) -> Result<Generated, String> {
        let mut all: Vec<GeneratedShift> = Vec::new();
        for source in sources {
            let Some(shift) = source.number(SHIFT, NUMBER)? else {
                continue;
            };
            let end = |end: &str| source.number(&format!("{SHIFT}_{end}_deviation"), NUMBER);
            let deviations = match (end("upper")?, end("lower")?) {
                (Some(upper), Some(lower)) => [upper, lower],
                (None, None) => [0.0; 2],
                _ => {
                    return Err(
                        source.left_out(format!("has one deviation of {SHIFT} without the other"))
                    );
                }
            };
            let place = source.component().place();
            let same =
                |other: &GeneratedShift| other.shift == shift && other.deviations == deviations;
            if !all.iter().any(same) {
                all.push(GeneratedShift {
                    shift,
                    deviations,
                    place,
                });
            }
        }
        let stated: Vec<String> = all.iter().map(ToString::to_string).collect();
        Ok(match (all.pop(), all.is_empty()) {
            (None, _) => Generated::None,
            (Some(one), true) => Generated::One(one),
            (Some(_), false) => Generated::Several(stated.join(" and ")),
        })
    }
}

impl GeneratedShift {
    /// Whether it equals the profile shift `x` and has no deviations. It then states no allowance.
    pub fn is(&self, x: f64) -> bool {
        self.shift == x && self.deviations == [0.0; 2]
    }

    /// Upper and lower allowance of the thickness at the reference cylinder against a gear of profile shift `x`, µm.
    ///
    /// A rack shifted by `x` modules generates the thickness `s_n = m_n (π/2 + 2 x tan α_n)` (ISO 21771, as
    /// `BasicGearData::half_base_angle`). The gear generated at `x_E` thus has `A_sn = s(x_E) − s(x) = 2 m_n tan α_n (x_E − x)`.
    pub fn allowances_um(&self, x: f64, basic_data: &BasicGearData) -> [f64; 2] {
        let of_shift = um_of_shift(basic_data);
        self.deviations
            .map(|deviation| rounded(of_shift * (self.shift + deviation - x), 6))
    }
}

/// Thickness per module of profile shift, µm.
pub fn um_of_shift(basic_data: &BasicGearData) -> f64 {
    2e3 * basic_data.module() * basic_data.pressure_angle().tan()
}

impl fmt::Display for GeneratedShift {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{SHIFT} {} of {}", shortest(self.shift), self.place)?;
        match self.deviations {
            [0.0, 0.0] => Ok(()),
            [upper, lower] => write!(f, " ({}…{})", shortest(lower), shortest(upper)),
        }
    }
}
