//! Where on the flank the values of a profile trace stand.

use super::super::header::Header;
use super::super::wanted::TraceRow;
use super::content::{P40, PROFILES};
use crate::data_file::DataFile;
use crate::numbers::ascii;
use crate::problems::Problems;

/// The profiles of a curve file. Their values stand at equal steps of the roll length, from the diameter at which the measurement starts
/// to that at which it ends.
pub fn read(
    file: &DataFile,
    p40: &P40,
    (teeth, base): (Option<u32>, Option<f64>),
    problems: &mut Problems,
) -> Option<(Vec<TraceRow>, Header)> {
    p40.refuse_values(file, problems)?;
    let help = "give the traces in a table";
    let Some(first) = p40.profiles.first() else {
        problems.add(file.problem("has no profile trace (Profil:)", help));
        return None;
    };
    let mut wrong = |line, reason: String, help: &str| {
        problems.add(file.problem_at(line, reason, help));
        None
    };
    let by = p40.profile_by.unwrap_or("diameter");
    if by != "diameter" {
        let reason = format!("PROFILE is {}, understood is diameter", file.quote(by));
        return wrong(first.line, reason, help);
    }
    let Some(base) = base.or(p40.header.base_radius()) else {
        let reason = "a trace, but no header line gives module and pressure angle";
        return wrong(
            first.line,
            reason.to_owned(),
            "name the file in a pair file",
        );
    };
    let mut ends = [0.0; 2];
    let labels: [&[&str]; 2] = [
        &["start messbereich", "start meßbereich"],
        &[
            "ende der messstrecke",
            "ende der meßstrecke",
            "ende messbereich",
            "ende meßbereich",
        ],
    ];
    for (end, labels) in ends.iter_mut().zip(labels) {
        let Some(said) = p40.labelled(labels) else {
            let reason = format!("a trace, but no header line is labelled {}", labels[0]);
            return wrong(first.line, reason, "add the line with the diameter in mm");
        };
        let (Some(&mm), same) = (
            said.numbers.first(),
            said.numbers.windows(2).all(|pair| pair[0] == pair[1]),
        ) else {
            return wrong(said.line, "no number".to_owned(), "give the diameter in mm");
        };
        let radius = 0.5 * mm;
        if !same || radius < base || radius > 1e9 {
            let reason = format!(
                "where the profiles were measured: {}, allowed is one diameter of both flanks, from the base circle on, {} mm",
                file.bare(&format!("{:?} mm", said.numbers)),
                ascii(2.0 * base, 4)
            );
            return wrong(
                said.line,
                reason,
                "correct the line, or give the traces in a table",
            );
        }
        *end = ((radius - base) * (radius + base)).sqrt();
    }
    let teeth = teeth.or(p40.header.teeth());
    let mut rows = Vec::new();
    for curve in &p40.profiles {
        if teeth.is_some_and(|teeth| curve.tooth > teeth) {
            let reason = format!(
                "tooth {}, allowed is 1 … {}",
                curve.tooth,
                teeth.unwrap_or(0)
            );
            return wrong(
                curve.line,
                file.found(reason),
                "correct its number or teeth",
            );
        }
        let step = (ends[1] - ends[0]) / (curve.values.len() - 1) as f64;
        let before = rows.len();
        for (index, (line, value)) in curve.values.iter().enumerate() {
            rows.extend(value.map(|deviation_um| TraceRow {
                line: *line,
                tooth: Some(curve.tooth),
                flank: Some(curve.flank),
                at_mm: ends[0] + step * index as f64,
                deviation_um,
            }));
        }
        if rows.len() < before + 2 {
            let reason = "a trace with fewer than two points that were measured";
            return wrong(curve.line, reason.to_owned(), "remove the trace");
        }
    }
    let values = p40.profiles.iter().flat_map(|curve| &curve.values);
    let holes = values.filter(|(_, value)| value.is_none()).count();
    let mut header = p40.header.clone();
    let words = format!(
        "{}; of the profiles {holes} values were not measured; they are read at equal steps of roll length, {} to {} mm, which the file does not say",
        p40.unused(PROFILES),
        ascii(ends[0], 4),
        ascii(ends[1], 4)
    );
    header.left_unused(file, &words);
    Some((rows, header))
}
