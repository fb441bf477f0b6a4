//! Which gears go together, on a terminal.

use crate::layout::{Column, Screen, Table};
use gearlash_files::characters::plain;
use gearlash_files::matching::MatchResult;
use gearlash_files::numbers::{fixed, um};

/// The sentence, the pairs with the teeth to mark, the gears left over.
pub fn text(result: &MatchResult, screen: &Screen) -> String {
    let mut text = screen.paragraphs(&format!("{}.", result.sentence()));
    text.push('\n');
    if !result.pairs.is_empty() {
        let mut table = Table::new([
            Column::new("wheel").left(),
            Column::new("pinion").left(),
            Column::new("teeth to mark").left(),
            Column::new("least µm"),
            Column::new("greatest µm"),
        ]);
        for pair in &result.pairs {
            table.add(vec![
                plain(&pair.wheel),
                plain(&pair.pinion),
                format!("1 · {}", pair.fit.pinion_tooth),
                um(pair.fit.outcome.least, 2),
                um(pair.fit.outcome.greatest, 2),
            ]);
        }
        text += &table.text(screen);
        text += &screen
            .fold("Teeth to mark: of the wheel and of the pinion, whose right flanks meet.\n");
    }
    for (kind, names) in ["Wheels", "Pinions"].iter().zip(&result.left_over) {
        if !names.is_empty() {
            let names: Vec<String> = names.iter().map(|name| plain(name)).collect();
            text.push('\n');
            text += &screen.fold(&format!("{kind} left over: {}.\n", names.join(", ")));
        }
    }
    text.push('\n');
    text += &screen.fold(&format!(
        "At random, with teeth marked: {} pairs to be expected.\n",
        fixed(result.at_random.best_phase, 1)
    ));
    text
}
