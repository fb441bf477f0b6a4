//! The statements of a pair file about a gear, in words.

use gearlash::gear::MeasuringBody;
use gearlash_input::spec::{
    BandSpec, Either, FlankLeadSpec, FlankProfileSpec, LeadSpec, LengthSpec, PitchSpec,
    ProfileSpec, ReliefShape, RunoutPlaneSpec, RunoutSpec, ThicknessSpec,
};
use gearlash_text::numbers::{rounded, shortest};

/// A single value, or `min … max`.
pub(super) fn single_or_band(stated: &Either<f64, BandSpec>) -> String {
    match stated {
        Either::One(value) => shortest(*value),
        Either::Other(band) => format!("{} … {}", shortest(band.min), shortest(band.max)),
    }
}

/// A value, `min … max`, or the number of readings and their range; a dash where absent.
fn measured(length: &LengthSpec) -> String {
    let shown = |end: Option<f64>| end.map_or("–".to_owned(), shortest);
    match &length.mm {
        Some(Either::One(mm)) => shortest(*mm),
        Some(Either::Other(readings)) => {
            let numbers = || readings.iter().copied();
            let ends = [numbers().reduce(f64::min), numbers().reduce(f64::max)];
            let [least, most] = ends.map(shown);
            format!("{} readings, {least} … {most}", readings.len())
        }
        None => {
            let [least, most] = [length.min_mm, length.max_mm].map(shown);
            format!("{least} … {most}")
        }
    }
}

pub(super) fn thickness(stated: &ThicknessSpec) -> String {
    let statement = &stated.statement;
    let mut parts = Vec::new();
    if let Some(span) = &statement.span {
        let mm = measured(&span.length);
        parts.push(format!("span over {} teeth {mm} mm", span.teeth));
    }
    if let Some(pins) = &statement.over_pins {
        let mm = measured(&pins.length);
        let name = match pins.kind {
            Some(MeasuringBody::Ball) => "balls",
            _ => "pins",
        };
        let diameter = shortest(pins.pin_mm);
        parts.push(format!("over {name} of {diameter} mm {mm} mm"));
    }
    match &statement.allowance_um {
        Some(Either::One(0.0)) => parts.push("nominal".to_owned()),
        Some(um) => parts.push(format!("allowance {} µm", single_or_band(um))),
        None => {}
    }
    if let Some(field) = &statement.designation {
        parts.push(format!("{field} (DIN 3967)"));
    }
    let lengths = [
        ("flanks moved out by", &statement.flank_offset_mm),
        ("base thickness", &statement.base_thickness_mm),
        ("arc thickness", &statement.arc_thickness_mm),
    ];
    for (name, length) in lengths {
        let length = length.as_ref().map(single_or_band);
        parts.extend(length.map(|mm| format!("{name} {mm} mm")));
    }
    if let Some(chord) = &statement.chordal_thickness {
        let length = LengthSpec {
            mm: chord.mm.map(Either::One),
            min_mm: chord.min_mm,
            max_mm: chord.max_mm,
            ..LengthSpec::default()
        };
        parts.push(format!("chordal thickness {} mm", measured(&length)));
    }
    match stated.per_tooth_um.as_deref() {
        None | Some([]) => {}
        Some(values) => parts.push(format!("{} values tooth by tooth", values.len())),
    }
    if stated.cross_check.is_some() {
        // The notes below the table compare it.
        parts.push("cross-check: see below".to_owned());
    }
    parts.join(", ")
}

/// A value that can come from a fit to readings: at most four decimals.
fn fitted_number(number: f64) -> String {
    let full = shortest(number);
    let short = shortest(rounded(number, 4));
    std::cmp::min_by_key(full, short, String::len)
}

/// `F_r`, µm.
pub(super) fn runout(stated: &RunoutSpec) -> String {
    let at = |plane: &RunoutPlaneSpec| {
        let height = fitted_number(plane.from_reference_face_mm);
        format!("{} at {height} mm", fitted_number(plane.total_um))
    };
    let planes = stated
        .planes
        .map(|planes| planes.each_ref().map(at).join(", "));
    planes.unwrap_or_else(|| fitted_number(stated.total()))
}

pub(super) fn high_tooth(stated: &RunoutSpec) -> String {
    let tooth = |plane: RunoutPlaneSpec| fitted_number(plane.high_tooth);
    let planes = stated.planes.map(|planes| planes.map(tooth).join(", "));
    planes.unwrap_or_else(|| stated.high_tooth.map_or("–".to_owned(), fitted_number))
}

/// Axial runout of a shoulder: "14 µm at 100 mm, tooth 12".
pub(super) fn face_runout(stated: &RunoutSpec) -> String {
    stated.face_runout.map_or("–".to_owned(), |face| {
        let [um, mm, tooth] = [face.um, face.diameter_mm, face.high_tooth].map(fitted_number);
        format!("{um} µm at a diameter of {mm} mm, tooth {tooth}")
    })
}

/// Kind and number of the pitch deviations. `by_tooth`: the teeth differ in thickness.
pub(super) fn pitch(stated: Option<&PitchSpec>, by_tooth: bool) -> String {
    match stated {
        None if by_tooth => "not given; those shown below follow from the thickness tooth by tooth, half of it to each flank".to_owned(),
        None => "not given".to_owned(),
        Some(pitch) => {
            let values = |flank: &Option<Vec<f64>>| flank.as_ref().map_or(0, Vec::len);
            format!(
                "{}, {} axis, {} + {} values",
                pitch.kind.name(),
                pitch.axis.name(),
                values(&pitch.right_um),
                values(&pitch.left_um)
            )
        }
    }
}

pub(super) fn profile(stated: Option<&ProfileSpec>) -> String {
    stated.map_or("not given".to_owned(), |stated| {
        by_flank(stated.flanks().map(flank_profile))
    })
}

pub(super) fn lead(stated: Option<&LeadSpec>) -> String {
    let Some(stated) = stated else {
        return "not given".to_owned();
    };
    let mut text = by_flank(stated.flanks.flanks().map(flank_lead));
    if let Some(zero) = stated.zero_mm {
        text += &format!("; 0 at {} mm from the reference face", shortest(zero));
    }
    text
}

fn by_flank([right, left]: [String; 2]) -> String {
    if right == left {
        format!("both flanks: {right}")
    } else {
        format!("right flanks: {right}; left flanks: {left}")
    }
}

fn in_um(name: &str, um: Option<f64>) -> Option<String> {
    um.map(|um| format!("{name} {} µm", shortest(um)))
}

fn flank_lead(stated: &FlankLeadSpec) -> String {
    let mut parts = Vec::new();
    parts.extend(in_um("slope", stated.slope_um));
    parts.extend(in_um("crowning over the face width", stated.crowning_um));
    parts.extend(stated.helix_slope_um.as_ref().map(|slope| match slope {
        Either::One(um) => format!("helix slope f_Hβ {} µm", shortest(*um)),
        Either::Other(slope) => format!("helix slope f_Hβ {} µm", slope.text()),
    }));
    for relief in stated.end_relief.iter().flat_map(Either::as_list) {
        let [um, mm] = [relief.um, relief.length_mm].map(shortest);
        parts.push(format!("end relief {um} µm over {mm} mm"));
    }
    let measured = stated.trace.iter().flat_map(Either::as_list);
    parts.extend(traces(measured.map(|trace| trace.tooth)));
    if parts.is_empty() {
        return "straight".to_owned();
    }
    parts.join(", ")
}

/// The teeth of measured traces, in words.
fn traces(teeth: impl Iterator<Item = Option<u32>>) -> Option<String> {
    match &teeth.collect::<Vec<_>>()[..] {
        [] => None,
        [Some(tooth)] => Some(format!("trace of tooth {tooth}")),
        [None] => Some("a trace for all teeth".to_owned()),
        several => Some(format!("traces of {} teeth", several.len())),
    }
}

fn flank_profile(stated: &FlankProfileSpec) -> String {
    let mut parts = Vec::new();
    parts.extend(in_um("slope f_Hα", stated.slope_um));
    parts.extend(in_um(
        "crowning over the evaluation range",
        stated.crowning_um,
    ));
    let reliefs = [
        ("tip relief", stated.tip_relief),
        ("root relief", stated.root_relief),
    ];
    for (name, relief) in reliefs {
        parts.extend(relief.map(|relief| {
            let [um, from] = [relief.um, relief.from_diameter_mm].map(shortest);
            let shape = match relief.shape {
                ReliefShape::Linear => "straight",
                ReliefShape::Parabolic => "parabolic",
            };
            format!("{name} {um} µm from d {from} mm, {shape}")
        }));
    }
    parts.extend(traces(stated.traces().iter().map(|trace| trace.tooth)));
    if parts.is_empty() {
        return "involute".to_owned();
    }
    if let Some([from, to]) = stated.range_mm {
        let [from, to] = [from, to].map(shortest);
        parts.push(format!("evaluated over d {from} … {to} mm"));
    }
    parts.join(", ")
}
