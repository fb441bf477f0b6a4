//! The outlines of a drawing, as text.

use crate::layout::{Column, Screen, Table};
use gearlash_files::characters::plain;
use gearlash_files::outlines::ListedOutlines;

/// The outlines of the drawing called `name`, and the table of the gear `gear` that names one of them.
pub fn text(name: &str, drawing: &ListedOutlines, gear: &str, screen: &Screen) -> String {
    let outlines = &drawing.outlines;
    let mut table = Table::new([
        Column::new("number"),
        Column::new("layer or id").left(),
        Column::new("from, mm").left(),
        Column::new("size, mm").left(),
        Column::new("parts"),
        Column::new("inside"),
        Column::new("at").left().spare(1),
    ]);
    for (index, outline) in outlines.iter().enumerate() {
        table.add(vec![
            (index + 1).to_string(),
            plain(&outline.name).to_string(),
            outline.start.clone(),
            format!("{:.3} x {:.3}", outline.size_mm.x, outline.size_mm.y),
            outline.parts.to_string(),
            outline.inside.to_string(),
            plain(&outline.place).to_string(),
        ]);
    }
    let outline = |count| if count == 1 { "outline" } else { "outlines" };
    let mut text = format!(
        "{}: {} {}, 1 unit is {} mm\n\n{}",
        plain(name),
        outlines.len(),
        outline(outlines.len()),
        drawing.unit_mm,
        table.text(screen)
    );
    for remark in &drawing.remarks {
        text += &format!("\n{}\n", plain(remark));
    }
    text += &format!("\n[{gear}.outline]\nfile = {name:?}\n");
    if outlines.len() > 1 {
        text += &format!("number = 1  # of {}\n", outlines.len());
    }
    text
}
