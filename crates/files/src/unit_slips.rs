//! Numbers of one gear that look as if another unit or sign were meant: warnings, never changes.

use super::faults::Drawing;
use super::pitch::PitchSheet;
use super::runout::Runout;
use super::thickness::Statement;
use gearlash::gear::Side;

/// Below this a value in µm looks like one in mm: no shop measures teeth so finely, and 0.5 mm is more than any deviation of a gear that
/// is worth measuring.
const LEAST_UM: f64 = 0.5;
/// Below this it is 0 but for rounding: as mm it would be 0.1 µm, less than the last digit that machines print.
const ROUNDING_UM: f64 = 1e-4;

/// Everything of the gear that looks so.
pub fn told(
    drawing: &Drawing,
    runout: &Runout,
    per_tooth_um: &[f64],
    pitch: Option<&PitchSheet>,
) -> Vec<String> {
    let key = |name: &str| drawing.table.path_of(name);
    let mut told = Vec::new();
    if let Statement::Allowance(um) = &drawing.statement {
        let key = key("thickness.allowance_um");
        told.extend(as_mm(&key, [*um.least(), *um.most()]));
        if *um.most() > 0.0 {
            told.push(format!(
                "{key}: {} µm makes the teeth thicker than nominal, and an allowance for backlash makes them thinner: check its sign; if {} µm was \
                 meant, write that",
                um.most(),
                -um.most()
            ));
        }
    }
    let runout_key = match &runout.sheet {
        Some(_) => "runout.file",
        None => "runout.total_um",
    };
    told.extend(as_mm(&key(runout_key), [runout.total_um]));
    told.extend(as_mm(
        &key("thickness.per_tooth_um"),
        per_tooth_um.iter().copied(),
    ));
    if let Some(sheet) = pitch {
        let both = Side::BOTH.map(|side| sheet.values(side).iter().copied());
        told.extend(as_mm(&key("pitch"), both.into_iter().flatten()));
    }
    told
}

/// A warning where the greatest of `values` is no size of a deviation in µm, but one in mm.
fn as_mm(key: &str, values: impl IntoIterator<Item = f64>) -> Option<String> {
    let greatest = values
        .into_iter()
        .max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
    (ROUNDING_UM..LEAST_UM).contains(&greatest.abs()).then(|| {
        format!(
            "{key}: {greatest} µm is the greatest value, finer than teeth are measured: if mm were meant, multiply by 1000 ({greatest} mm are {:.4} µm)",
            1000.0 * greatest
        )
    })
}
