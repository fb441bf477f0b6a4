//! The understood content of a REXS file, as text.

use crate::layout::{Column, Screen, Table};
use gearlash_files::characters::plain;
use gearlash_files::rexs::{RexsFile, RexsPair};

/// The stages of the file called `name` with their results, and the parts that were left out.
pub fn text(name: &str, file: &RexsFile, screen: &Screen) -> String {
    let mut stages = Table::new([
        Column::new("stage"),
        Column::new("kind").left().spare(1),
        Column::new("name").left().spare(2),
        Column::new("").left(),
        Column::new("became").left().below(),
    ]);
    for stage in &file.stages {
        let (became, what) = match &stage.pair {
            Ok(pair) => ("pair file", &pair.summary),
            Err(why) => ("left out", why),
        };
        let name = plain(&stage.name);
        let row = [&stage.id.to_string(), &stage.kind, &name, became, what];
        stages.add(row.map(str::to_owned).to_vec());
    }
    let pairs = file.stages.iter().filter(|stage| stage.pair.is_ok());
    let pairs = pairs.count();
    let mut text = format!(
        "{}: REXS {} of {}, {pairs} of {} stages can be read\n\n",
        plain(name),
        plain(&file.version),
        plain(&file.application),
        file.stages.len()
    );
    if !file.stages.is_empty() {
        text += &stages.text(screen);
    }
    if !file.left_out.is_empty() {
        let each = file.left_out.iter();
        let each = each.map(|(kind, count)| format!("{count} {}", plain(kind)));
        text += &format!("\nLeft out: {}\n", each.collect::<Vec<_>>().join(", "));
    }
    screen.fold(&text)
}

/// The used and unused data of a stage.
pub fn pair(pair: &RexsPair, screen: &Screen) -> String {
    let mut text = String::new();
    for (component, ids) in &pair.unused {
        text += &format!("Not used of {component}: {}\n", ids.join(", "));
    }
    for remark in &pair.remarks {
        text += &format!("Note: {remark}\n");
    }
    screen.fold(&text)
}
