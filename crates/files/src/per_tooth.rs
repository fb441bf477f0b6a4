//! Lists of one value a tooth.

use super::faults::Drawing;
use super::limits::PER_TOOTH;
use super::node::Node;
use super::problems::Problems;
use super::sheet::{self, Column, Coverage, Sheet, Wanted};
use super::stated::Stated;
use super::table::Table;
use super::thickness::Statement;

/// `per_tooth_um` of `[thickness]`, listed or in a file: empty or one value a tooth, µm.
pub fn thickness(table: &Table, teeth: Option<u32>, problems: &mut Problems) -> Option<Vec<f64>> {
    if let Some(Node::Table(_)) = table.get("per_tooth_um").map(|entry| entry.node()) {
        let named = table.table("per_tooth_um", sheet::KEYS, problems)?;
        let wanted = Wanted {
            columns: [Column::Thickness],
            teeth,
            coverage: Coverage::EveryTooth,
        };
        return Some(Sheet::read(&named, &wanted, problems)?.values(0));
    }
    let list = table.numbers("per_tooth_um", &PER_TOOTH, problems)?;
    one_a_tooth(table, "per_tooth_um", list, teeth, problems)
}

/// Standard deviations of a list within which its mean must lie. Values about the stated mean thickness have a mean of 0, within
/// their scatter by `√z`; three of them from 0 the whole list lies on one side of it. Tuned: that is how values from the nominal thickness look.
const OFF: f64 = 3.0;

/// The mean of a list, in modules, that no allowance explains: DIN 3967's greatest, a, stays below it from a module of 2 mm on. Tuned.
const MOST_MEAN: f64 = 0.1;

/// A warning where `per_tooth_um` varies about a mean that is large beside its scatter and adds to the one that is stated.
///
/// One value for all teeth is an offset and meant as one; the nominal thickness is what such a list may count from; readings all round
/// hold the list's mean, so it does not add to them.
pub fn off_mean(drawing: &Drawing, per_tooth_um: &[f64]) -> Option<String> {
    let first = *per_tooth_um.first()?;
    let count = per_tooth_um.len() as f64;
    let mean = per_tooth_um.iter().sum::<f64>() / count;
    let module_um = 1000.0 * drawing.design.basic_data.module();
    if mean.abs() > MOST_MEAN * module_um {
        return Some(format!(
            "{}: its mean is {mean:.1} µm, more than a tenth of the module: the values are what each tooth is thicker than the mean in µm; if they are \
             thicknesses, or in another unit, take their mean out or convert them",
            drawing.table.path_of("thickness.per_tooth_um")
        ));
    }
    let key = drawing.statement.key()?;
    match drawing.statement {
        Statement::Spans { .. } | Statement::Pins { .. } => return None,
        Statement::Allowance(Stated::Single(0.0)) => return None,
        _ => {}
    }
    if per_tooth_um.iter().all(|um| *um == first) {
        return None;
    }
    let squares: f64 = per_tooth_um.iter().map(|um| (um - mean).powi(2)).sum();
    let scatter = (squares / (count - 1.0)).sqrt();
    (mean.abs() > OFF * scatter).then(|| {
        format!(
            "{}: its mean, {mean:.1} µm, adds to the stated {key} (its values scatter about it by {scatter:.1} µm r.m.s.): where they were measured \
             from the nominal thickness, and {key} says the same, take their mean out of the list",
            drawing.table.path_of("thickness.per_tooth_um")
        )
    })
}

/// `list`, when it is empty or has one value a tooth.
pub fn one_a_tooth(
    table: &Table,
    name: &str,
    list: Vec<f64>,
    teeth: Option<u32>,
    problems: &mut Problems,
) -> Option<Vec<f64>> {
    match teeth {
        Some(teeth) if !list.is_empty() && list.len() != teeth as usize => {
            problems.add(table.problem(
                name,
                format!(
                    "length {}, needed is {teeth}: one value a tooth",
                    list.len()
                ),
                "give them in ascending tooth number, tooth 1 first",
            ));
            None
        }
        _ => Some(list),
    }
}
