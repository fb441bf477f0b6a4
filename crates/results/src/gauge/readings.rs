//! The readings of a gear, each as a table with a row a tooth: what every writer and chart takes them from.

use crate::table::{Column, Table, Unit};
use gearlash::contact::Touch;
use gearlash::gauge::{Gauged, OverPins, PitchReadings, ProfileReading, ProfileReadings, RollPose};
use gearlash::gear::Flank;
use serde_json::{Value, json};

/// One gauge's readings; the stem of the gear (`gauge_wheel`, `gauge_wheel_most`) comes before it in the names of files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reading {
    /// Span W_k over each tooth and the next.
    Spans,
    /// Dimension over two pins.
    Pins,
    /// Dimension over three pins; named so that it is not read as one over two.
    ThreePins,
    /// Dimension over two cylindrical pins along the spaces of a helical gear, whose other dimensions are over balls.
    LyingPins,
    /// Ball in each space.
    Runout,
    /// Cumulative pitch about the gear's own centre.
    PitchOwn,
    /// Single pitch there.
    SinglePitchOwn,
    /// Cumulative pitch about the rotation axis.
    PitchDatum,
    /// Single pitch there.
    SinglePitchDatum,
    /// Arc thickness.
    Thickness,
    /// Double-flank roll test.
    Roll,
    /// Profile deviation.
    Profile,
}

/// How a reading's column is called beside those of other gauges: its name with the unit, and a narrow heading.
type Wide = (&'static str, &'static str, &'static str);

impl Reading {
    /// Every reading, in the order of files.
    pub const ALL: [Reading; 12] = [
        Reading::Spans,
        Reading::Pins,
        Reading::ThreePins,
        Reading::LyingPins,
        Reading::Runout,
        Reading::PitchOwn,
        Reading::SinglePitchOwn,
        Reading::PitchDatum,
        Reading::SinglePitchDatum,
        Reading::Thickness,
        Reading::Roll,
        Reading::Profile,
    ];

    /// As files call it.
    pub fn name(self) -> &'static str {
        match self {
            Reading::Spans => "spans",
            Reading::Pins => "pins",
            Reading::ThreePins => "three_pins",
            Reading::LyingPins => "lying_pins",
            Reading::Runout => "runout",
            Reading::PitchOwn => "pitch_own",
            Reading::SinglePitchOwn => "single_pitch_own",
            Reading::PitchDatum => "pitch_datum",
            Reading::SinglePitchDatum => "single_pitch_datum",
            Reading::Thickness => "thickness",
            Reading::Roll => "roll",
            Reading::Profile => "profile",
        }
    }

    /// Name of its file of the gear of `stem`, without an ending.
    pub fn file_stem(self, stem: &str) -> String {
        format!("{stem}_{}", self.name())
    }

    /// Name of its chart.
    pub fn svg(self, stem: &str) -> String {
        format!("{}.svg", self.file_stem(stem))
    }

    /// The readings, a row a tooth; `None` where it was not measured.
    pub fn table(self, read: &Gauged) -> Option<Table> {
        let columns = match self {
            Reading::Spans => {
                let list = &read.spans.as_ref().ok()?.readings;
                vec![
                    Column::new("tooth", Unit::None, list.iter().map(|one| one.first_tooth)),
                    Column::new("span", Unit::Mm, list.iter().map(|one| one.length)),
                    error(list.iter().map(|one| one.error)),
                    touched(list.iter().map(|one| one.touched.as_slice())),
                ]
            }
            Reading::Pins => over("pins", &read.pins.as_ref().ok()?.two),
            Reading::ThreePins => {
                let list = &read.pins.as_ref().ok()?.three;
                (!list.is_empty()).then(|| over("three_pins", list))?
            }
            Reading::LyingPins => {
                let list = &read.pins.as_ref().ok()?.lying;
                (!list.is_empty()).then(|| over("lying_pins", list))?
            }
            Reading::Runout => {
                let runout = read.runout.as_ref().ok()?;
                let list = &runout.readings;
                vec![
                    Column::new("tooth", Unit::None, list.iter().map(|one| one.seat.tooth)),
                    Column::new("runout", Unit::Um, um(&runout.deviations())),
                    Column::new("radius", Unit::Mm, list.iter().map(|one| one.radius)),
                    error(list.iter().map(|one| one.seat.error)),
                    touched(list.iter().map(|one| one.seat.touched.as_slice())),
                ]
            }
            Reading::PitchOwn => flanks(read.pitch_own.as_ref().ok()?, cumulative),
            Reading::SinglePitchOwn => flanks(read.pitch_own.as_ref().ok()?, PitchReadings::single),
            Reading::PitchDatum => flanks(read.pitch_datum.as_ref().ok()?, cumulative),
            Reading::SinglePitchDatum => {
                flanks(read.pitch_datum.as_ref().ok()?, PitchReadings::single)
            }
            Reading::Thickness => {
                let thickness = read.thickness.as_ref().ok()?;
                vec![
                    teeth(thickness.arcs.len()),
                    Column::new("thickness", Unit::Um, um(&thickness.deviations())),
                    Column::new("arc", Unit::Mm, thickness.arcs.iter().copied()),
                ]
            }
            Reading::Roll => roll(&read.roll.as_ref().ok()?.poses),
            Reading::Profile => {
                let found = read.profile.as_ref().ok()?;
                found.deviates().then(|| profiles(found))?
            }
        };
        Some(Table {
            name: self.name(),
            columns,
        })
    }

    /// Its columns beside those of other gauges: which, and how they are called there.
    fn wide(self) -> &'static [Wide] {
        match self {
            Reading::Spans => &[("span", "span_mm", "W_k mm")],
            Reading::Pins => &[("pins", "over_two_pins_mm", "two pins mm")],
            Reading::ThreePins => &[("three_pins", "over_three_pins_mm", "three pins mm")],
            Reading::LyingPins => &[("lying_pins", "over_lying_pins_mm", "lying pins mm")],
            Reading::Runout => &[("runout", "runout_um", "ball")],
            Reading::SinglePitchOwn => &[
                ("left", "single_pitch_own_left_um", "f own left"),
                ("right", "single_pitch_own_right_um", "f own right"),
            ],
            Reading::PitchOwn => &[
                ("left", "pitch_own_left_um", "F own left"),
                ("right", "pitch_own_right_um", "F own right"),
            ],
            Reading::SinglePitchDatum => &[
                ("left", "single_pitch_datum_left_um", "f datum left"),
                ("right", "single_pitch_datum_right_um", "f datum right"),
            ],
            Reading::PitchDatum => &[
                ("left", "pitch_datum_left_um", "F datum left"),
                ("right", "pitch_datum_right_um", "F datum right"),
            ],
            Reading::Thickness => &[("thickness", "thickness_um", "s − mean")],
            Reading::Roll => &[],
            Reading::Profile => &[
                ("slope_left", "profile_slope_left_um", "f_Hα left"),
                ("slope_right", "profile_slope_right_um", "f_Hα right"),
                ("form_left", "profile_form_left_um", "f_fα left"),
                ("form_right", "profile_form_right_um", "f_fα right"),
                ("total_left", "profile_total_left_um", "F_α left"),
                ("total_right", "profile_total_right_um", "F_α right"),
            ],
        }
    }
}

/// The readings that stand beside each other, in the order shown: the single pitch before the cumulative.
const SIDE_BY_SIDE: [Reading; 11] = [
    Reading::Spans,
    Reading::Pins,
    Reading::ThreePins,
    Reading::LyingPins,
    Reading::Runout,
    Reading::SinglePitchOwn,
    Reading::PitchOwn,
    Reading::SinglePitchDatum,
    Reading::PitchDatum,
    Reading::Thickness,
    Reading::Profile,
];

/// Every reading that stands at a tooth: each with its heading in a narrow table. What was not measured has no cells.
pub fn by_tooth(read: &Gauged) -> Vec<(&'static str, Column)> {
    // Spur gears have no column that only helical ones fill.
    let readings = SIDE_BY_SIDE.into_iter();
    let shown = readings.filter(|&one| one != Reading::LyingPins || one.table(read).is_some());
    let columns = shown.flat_map(|reading| {
        let table = reading.table(read);
        reading.wide().iter().map(move |(own, name, heading)| {
            let column = table.as_ref().and_then(|table| table.column(own));
            let unit = match name.ends_with("_mm") {
                true => Unit::Mm,
                false => Unit::Um,
            };
            let cells = column.map_or(Vec::new(), |column| column.cells.clone());
            (*heading, Column { name, unit, cells })
        })
    });
    columns.collect()
}

/// The columns of a roll test, each pose a row.
pub const ROLL: [&str; 6] = [
    "tooth",
    "fraction",
    "rotation_rad",
    "a_mm",
    "error_bound_um",
    "class",
];

/// The columns of the profiles, each tooth a row.
const PROFILE: [&str; 7] = [
    "tooth",
    "slope_left",
    "slope_right",
    "form_left",
    "form_right",
    "total_left",
    "total_right",
];

/// `f_Hα`, `f_fα` and `F_α` of both flanks.
fn profiles(read: &ProfileReadings) -> Vec<Column> {
    let of: [fn(&ProfileReading) -> f64; 3] = [|one| one.slope, |one| one.form, |one| one.total];
    let values = of
        .iter()
        .flat_map(|of| [Flank::Left, Flank::Right].map(|side| um(&read.flank(side).by_tooth(of))));
    let count = read.flank(Flank::Left).of_tooth.len();
    let names = PROFILE.into_iter().skip(1);
    let columns = names.zip(values);
    std::iter::once(teeth(count))
        .chain(columns.map(|(name, values)| Column::new(name, Unit::Um, values)))
        .collect()
}

/// Poses of a roll test.
pub fn roll(poses: &[RollPose]) -> Vec<Column> {
    let [tooth, fraction, rotation, a, bound, class] = ROLL;
    let mating = || poses.iter().map(|pose| pose.mating);
    vec![
        Column::new(tooth, Unit::None, mating().map(|mating| mating.wheel_tooth)),
        Column::new(fraction, Unit::None, mating().map(|mating| mating.fraction)),
        Column::new(rotation, Unit::Rad, poses.iter().map(|pose| pose.rotation)),
        Column::new(a, Unit::Mm, poses.iter().map(|pose| pose.distance)),
        Column::new(bound, Unit::Um, poses.iter().map(|pose| pose.error * 1e3)),
        Column::new(class, Unit::None, poses.iter().map(|p| p.class.name())),
    ]
}

fn teeth(count: usize) -> Column {
    Column::new("tooth", Unit::None, (1u32..).take(count))
}

fn error(bounds: impl Iterator<Item = f64>) -> Column {
    Column::new("error_bound", Unit::Um, bounds.map(|mm| mm * 1e3))
}

fn touched<'a>(touches: impl Iterator<Item = &'a [Touch]>) -> Column {
    let one = |touch: &Touch| json!({ "tooth": touch.tooth, "curve": touch.curve.name(), "radius_mm": touch.radius });
    let list = |touches: &[Touch]| touches.iter().map(one).collect::<Value>();
    Column::new("touched", Unit::None, touches.map(list))
}

fn over(name: &'static str, list: &[OverPins]) -> Vec<Column> {
    vec![
        Column::new("tooth", Unit::None, list.iter().map(|one| one.tooth)),
        Column::new("opposite", Unit::None, list.iter().map(|one| one.opposite)),
        Column::new(name, Unit::Mm, list.iter().map(|one| one.length)),
        error(list.iter().map(|one| one.error)),
    ]
}

fn cumulative(pitch: &PitchReadings, side: Flank) -> Vec<f64> {
    pitch.cumulative.flank(side).to_vec()
}

fn flanks(pitch: &PitchReadings, values: fn(&PitchReadings, Flank) -> Vec<f64>) -> Vec<Column> {
    let [left, right] = [Flank::Left, Flank::Right].map(|side| um(&values(pitch, side)));
    vec![
        teeth(left.len()),
        Column::new("left", Unit::Um, left),
        Column::new("right", Unit::Um, right),
    ]
}

/// mm to µm.
fn um(lengths: &[f64]) -> Vec<f64> {
    lengths.iter().map(|mm| mm * 1e3).collect()
}
