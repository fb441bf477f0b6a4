//! Places of the values of profile and lead traces on the flank.

use super::{FlankTrace, LEADS, P40, PROFILES};
use crate::data_file::DataFile;
use crate::protocol_header::ProtocolHeader;
use crate::rows::Row;
use gearlash_text::numbers::ascii;

/// Labels of the header lines that state where the measurement starts and ends.
const ENDS: [&[&str]; 2] = [
    &["start messbereich", "start meßbereich"],
    &[
        "ende der messstrecke",
        "ende der meßstrecke",
        "ende messbereich",
        "ende meßbereich",
    ],
];

/// Label of the header line of the face width.
pub const FACE_WIDTH: &str = "zahnbreite";

/// The profiles of a curve file: roll lengths, mm, and deviations, µm; and its header. `teeth` and the radius of the `base` circle
/// are those of the pair file.
///
/// The values have equal steps of roll length, from the diameter at the start of the measurement to the one at its end.
pub fn profiles(
    file: &DataFile,
    p40: &P40,
    (teeth, base): (Option<u32>, Option<f64>),
) -> Option<(Vec<Row>, ProtocolHeader)> {
    let help = "give the traces in a table";
    let Some(first) = p40.profiles.first() else {
        return file.refuse("has no profile trace (Profil:)", help);
    };
    let wrong = |line, reason: String, help: &str| file.refuse_at(line, reason, help);
    let by = p40.profile_by.unwrap_or("diameter");
    if by != "diameter" {
        let reason = format!("PROFILE is {}, understood is diameter", file.quote(by));
        return wrong(first.line, reason, help);
    }
    let Some(base) = base.or(p40.header.base_radius()) else {
        let reason = "a trace, but no header line gives module and pressure angle".to_owned();
        return wrong(first.line, reason, "name the file in a pair file");
    };
    let mut ends = [0.0; 2];
    for (end, labels) in ends.iter_mut().zip(ENDS) {
        let mut numbered = p40.numbered.iter();
        let stated = numbered.find(|line| labels.iter().any(|label| line.label.contains(label)));
        let Some(stated) = stated else {
            let reason = format!("a trace, but no header line is labelled {}", labels[0]);
            return wrong(first.line, reason, "add the line with the diameter in mm");
        };
        let Some(diameter) = stated.numbers.first() else {
            return wrong(
                stated.line,
                "no number".to_owned(),
                "give the diameter in mm",
            );
        };
        let radius = 0.5 * diameter;
        let is_one = stated.numbers.iter().all(|number| number == diameter);
        if !is_one || radius < base || radius > 1e9 {
            let reason = format!(
                "where the profiles were measured: {}, allowed is one diameter of both flanks, from the base circle on, {} mm",
                file.bare(&format!("{:?} mm", stated.numbers)),
                ascii(2.0 * base, 4)
            );
            return wrong(
                stated.line,
                reason,
                "correct the line, or give the traces in a table",
            );
        }
        *end = ((radius - base) * (radius + base)).sqrt();
    }
    let rows = rows(file, p40, (&p40.profiles, ends), teeth)?;
    let values = p40.profiles.iter().flat_map(|curve| &curve.values);
    let holes = values.filter(|(_, value)| value.is_none()).count();
    let words = format!(
        "{}; of the profiles {holes} values were not measured; they are read at equal steps of roll length, {} to {} mm, which the file does not say",
        p40.unread(PROFILES),
        ascii(ends[0], 4),
        ascii(ends[1], 4)
    );
    let mut header = p40.header.clone();
    header.set_unread(file, &words);
    Some((rows, header))
}

/// The leads of a curve file: heights, mm, and deviations, µm; and its header with a warning of what the format leaves open. `teeth` are those of
/// the pair file.
pub fn leads(file: &DataFile, p40: &P40, teeth: Option<u32>) -> Option<(Vec<Row>, ProtocolHeader)> {
    let help = "give the traces in a table";
    if p40.leads.is_empty() {
        return file.refuse("has no lead trace (Flankenlinie:)", help);
    }
    let mut numbered = p40.numbered.iter();
    let stated = numbered.find(|line| line.label.contains(FACE_WIDTH));
    let width = stated.and_then(|line| line.numbers.first());
    let Some(&width) = width.filter(|width| (0.0..1e6).contains(*width) && **width > 0.0) else {
        let reason = "has lead traces, but no header line Zahnbreite with the face width in mm";
        return file.refuse(reason, help);
    };
    let rows = rows(file, p40, (&p40.leads, [0.0, width]), teeth)?;
    let mut header = p40.header.clone();
    let words = format!(
        "{}; the leads count from the reference face over the face width, {width} mm, plus as more material, which the file does not say",
        p40.unread(LEADS)
    );
    header.set_unread(file, &words);
    header.warn(
        file,
        "the format leaves open where lead traces begin and end and which sign is more material; compare with the printed chart, and give the traces in a table where they differ",
    );
    Some((rows, header))
}

/// The rows of `curves`, whose values have equal steps between these ends, mm.
fn rows(
    file: &DataFile,
    p40: &P40,
    (curves, ends): (&[FlankTrace], [f64; 2]),
    teeth: Option<u32>,
) -> Option<Vec<Row>> {
    let wrong = |line, reason: String, help: &str| file.refuse_at(line, reason, help);
    let teeth = teeth.or(p40.header.teeth()).unwrap_or(u32::MAX);
    let mut rows = Vec::new();
    for curve in curves {
        if curve.tooth > teeth {
            let reason = file.found(format!("tooth {}, allowed is 1 … {teeth}", curve.tooth));
            return wrong(curve.line, reason, "correct its number or teeth");
        }
        let step = (ends[1] - ends[0]) / (curve.values.len() - 1) as f64;
        let before = rows.len();
        for (index, (line, value)) in curve.values.iter().enumerate() {
            rows.extend(value.map(|deviation_um| Row {
                line: *line,
                tooth: Some(curve.tooth),
                flank: Some(curve.flank),
                values: vec![ends[0] + step * index as f64, deviation_um],
            }));
        }
        if rows.len() < before + 2 {
            let reason = "a trace with fewer than two points that were measured".to_owned();
            return wrong(curve.line, reason, "remove the trace");
        }
    }
    Some(rows)
}
