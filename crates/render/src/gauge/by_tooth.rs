//! Every reading that stands at a tooth, as columns.

use gearlash::gauge::{Gauged, PitchReadings};
use gearlash::gear::Side;

/// One column: its name with unit, its heading in a narrow table, decimals there, and a value a tooth
/// (none where it was not measured).
pub(super) struct Column {
    pub name: &'static str,
    pub heading: &'static str,
    pub decimals: usize,
    pub values: Vec<f64>,
}

/// The columns, in the order shown.
pub(super) fn columns(read: &Gauged) -> Vec<Column> {
    let column = |name, heading, decimals, values| Column {
        name,
        heading,
        decimals,
        values,
    };
    let spans = read.spans.as_ref();
    let pins = read.pins.as_ref();
    let lengths = |over: &[gearlash::gauge::OverPins]| over.iter().map(|o| o.length).collect();
    let pitch = |read: &Result<PitchReadings, _>, values: fn(&PitchReadings, Side) -> Vec<f64>| {
        [Side::Left, Side::Right].map(|side| {
            read.as_ref()
                .map_or(Vec::new(), |pitch| micrometres(&values(pitch, side)))
        })
    };
    let cumulative = |pitch: &PitchReadings, side| pitch.cumulative.flank(side).to_vec();
    let [f_own_left, f_own_right] = pitch(&read.pitch_own, PitchReadings::single);
    let [own_left, own_right] = pitch(&read.pitch_own, cumulative);
    let [f_datum_left, f_datum_right] = pitch(&read.pitch_datum, PitchReadings::single);
    let [datum_left, datum_right] = pitch(&read.pitch_datum, cumulative);
    vec![
        column(
            "span_mm",
            "W_k mm",
            6,
            spans.map_or(Vec::new(), |spans| {
                spans.readings.iter().map(|span| span.length).collect()
            }),
        ),
        column(
            "over_two_pins_mm",
            "two pins mm",
            6,
            pins.map_or(Vec::new(), |pins| lengths(&pins.two)),
        ),
        column(
            "over_three_pins_mm",
            "three pins mm",
            6,
            pins.map_or(Vec::new(), |pins| lengths(&pins.three)),
        ),
        column(
            "runout_um",
            "ball",
            3,
            read.runout
                .as_ref()
                .map_or(Vec::new(), |runout| micrometres(&runout.deviations())),
        ),
        column("single_pitch_own_left_um", "f own left", 3, f_own_left),
        column("single_pitch_own_right_um", "f own right", 3, f_own_right),
        column("pitch_own_left_um", "F own left", 3, own_left),
        column("pitch_own_right_um", "F own right", 3, own_right),
        column(
            "single_pitch_datum_left_um",
            "f datum left",
            3,
            f_datum_left,
        ),
        column(
            "single_pitch_datum_right_um",
            "f datum right",
            3,
            f_datum_right,
        ),
        column("pitch_datum_left_um", "F datum left", 3, datum_left),
        column("pitch_datum_right_um", "F datum right", 3, datum_right),
        column(
            "thickness_um",
            "s − mean",
            3,
            read.thickness
                .as_ref()
                .map_or(Vec::new(), |thickness| micrometres(&thickness.deviations())),
        ),
    ]
}

/// mm to µm.
pub(super) fn micrometres(lengths: &[f64]) -> Vec<f64> {
    lengths.iter().map(|mm| mm * 1e3).collect()
}
