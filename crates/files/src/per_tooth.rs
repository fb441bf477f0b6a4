//! Lists of one value a tooth.

use super::limits::PER_TOOTH;
use super::node::Node;
use super::problems::Problems;
use super::sheet::{self, Column, Coverage, Sheet, Wanted};
use super::table::Table;

/// `per_tooth_um` of `[thickness]`, listed or in a file: empty or one value a tooth, µm.
pub fn thickness(table: &Table, teeth: Option<u32>, problems: &mut Problems) -> Option<Vec<f64>> {
    if let Some(Node::Table(_)) = table.get("per_tooth_um").map(|entry| entry.node()) {
        let named = table.table("per_tooth_um", sheet::KEYS, problems)?;
        let wanted = Wanted {
            columns: &[Column::Thickness],
            teeth,
            coverage: Coverage::EveryTooth,
        };
        let sheet = Sheet::read(&named, &wanted, problems)?;
        return Some(sheet.values(0));
    }
    let list = table.numbers("per_tooth_um", &PER_TOOTH, problems)?;
    one_a_tooth(table, "per_tooth_um", list, teeth, problems)
}

/// `list`, if it is empty or has one value a tooth.
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
                format!("length {}, expected {teeth}: one value a tooth", list.len()),
                "give them in ascending tooth number, tooth 1 first",
            ));
            None
        }
        _ => Some(list),
    }
}
