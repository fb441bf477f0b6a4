//! Lists of one value a tooth.

use super::limits::PER_TOOTH;
use super::node::Node;
use super::problems::Problems;
use super::sheet::{self, Column, Content, Coverage, Header, Nominal, Positions, Sheet, Wanted};
use super::table::Table;
use super::thickness::Statement;
use gearlash::gear::BasicGearData;
use gearlash::metrology::Toleranced;

/// `per_tooth_um` of `[thickness]`, listed or in a file: empty or one value a tooth, µm. From positions about the bore the part once a turn is left out where
/// runout or pitch of the `gear` state the eccentricity. With it what the file says of the gear.
pub fn thickness(
    gear: &Table,
    table: &Table,
    teeth: Option<u32>,
    nominal: Option<(&BasicGearData, f64)>,
    problems: &mut Problems,
) -> Option<(Vec<f64>, Header)> {
    if let Some(Node::Table(_)) = table.get("per_tooth_um").map(|entry| entry.node()) {
        let named = table.table("per_tooth_um", sheet::KEYS, problems)?;
        let wanted = Wanted {
            columns: [Column::Thickness],
            teeth,
            coverage: Coverage::EveryTooth,
        };
        let once = !gear.has("runout") && !gear.has("pitch");
        return sheet::read_with(
            &named,
            "pitch.csv",
            problems,
            |content, file, choice, bad| {
                if let Content::P40(text) = content {
                    let nominal = of_nominal(nominal?, once);
                    let read = Positions::of(&named, file, text, &nominal, bad)?;
                    return Some((read.per_tooth_um, read.header));
                }
                let read = Sheet::with_remarks(&named, content, file, choice, &wanted, bad)?;
                Some((read.values(0), Header::default()))
            },
        );
    }
    let list = table.numbers("per_tooth_um", &PER_TOOTH, problems)?;
    let list = one_a_tooth(table, "per_tooth_um", list, teeth, problems)?;
    Some((list, Header::default()))
}

/// The mean and each tooth's thickness from the `file` of `[thickness]`. Where the pitch of both flanks is there, it says that of each tooth; of
/// a gear with runout, the part once a turn is that.
pub fn positions(
    gear: &Table,
    table: &Table,
    nominal: Option<(&BasicGearData, f64)>,
    problems: &mut Problems,
) -> Option<(Statement, (Vec<f64>, Header))> {
    let keys = super::thickness::KEYS.iter().copied();
    let beside: Vec<&str> = keys.filter(|key| *key != "file").collect();
    table.alone("file", &beside, "one of them", problems)?;
    let once = !gear.has("runout");
    let read = Positions::read(table, &of_nominal(nominal?, once), problems)?;
    let each = match gear.has("pitch") {
        true => Vec::new(),
        false => read.per_tooth_um,
    };
    Some((
        Statement::Base(Toleranced::Single(read.base_thickness_mm)),
        (each, read.header),
    ))
}

/// What the positions of a gear of a profile shift are held against.
fn of_nominal((basic_data, shift): (&BasicGearData, f64), once: bool) -> Nominal<'_> {
    let half = basic_data.half_base_angle(shift);
    Nominal {
        basic_data,
        base_thickness_mm: 2.0 * basic_data.base_radius() * half,
        once,
    }
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
                format!("length {}, expected {teeth}: one value a tooth", list.len()),
                "give them in ascending tooth number, tooth 1 first",
            ));
            None
        }
        _ => Some(list),
    }
}
