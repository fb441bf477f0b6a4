//! Pair files that name the table under test, chosen by the input's first byte.

use crate::folder::Folder;

/// Reads `table` as the file that the pair named by `choice` asks for; `None` where `choice` names none.
///
/// `0` … `9` are readings of a gear of 44 teeth, `a` … `j` the same of 9 teeth, for which a small table is whole.
pub fn read(choice: u8, table: &[u8]) -> Option<()> {
    let (teeth, reading) = match choice {
        b'0'..=b'9' => (44, choice - b'0'),
        b'a'..=b'j' => (9, choice - b'a'),
        _ => return None,
    };
    let spanned = if teeth == 44 { 6 } else { 2 };
    let keys = match reading {
        0 => "pitch = { kind = \"cumulative\", file = \"table\" }".to_owned(),
        1 => "pitch = { kind = \"single\", file = \"table\" }".to_owned(),
        2 => "thickness.per_tooth_um = { file = \"table\" }".to_owned(),
        3 => "runout = { file = \"table\", at = \"tooth\" }".to_owned(),
        4 => "runout = { file = \"table\", at = \"space\", ball_mm = 5.25 }".to_owned(),
        5 => format!("thickness.span = {{ teeth = {spanned}, file = \"table\" }}"),
        6 => {
            "thickness.over_pins = { pin_mm = 5.25, file = \"table\", decimal = \",\" }".to_owned()
        }
        8 => "thickness = { file = \"table\" }".to_owned(),
        9 => "profile = { trace = { file = \"table\" } }".to_owned(),
        _ => String::new(),
    };
    let gear = format!("teeth = {teeth}\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n");
    let distance = 3.0 * f64::from(teeth) + 0.2;
    let poses = match reading {
        7 => "[assembly]\n[measured]\nfile = \"table\"\n".to_owned(),
        _ => format!("[assembly]\ncenter_distance_mm = {distance:?}\n[sweep]\nmating = [[1, 1]]\n"),
    };
    let pair = format!("[wheel]\n{gear}{keys}\n[pinion]\n{gear}{poses}");
    Folder::new(&pair, &[("table", table)]).read_twice();
    Some(())
}
