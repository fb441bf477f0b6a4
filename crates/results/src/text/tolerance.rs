//! A population on a terminal.

use crate::layout::{Column, Screen, Table};
use gearlash::population::QUANTILES;
use gearlash_files::characters::plain;
use gearlash_files::numbers::{fixed, rounded, um};
use gearlash_files::tolerance::{
    ToleranceResult, phases_of_limits, sentence, without_backlash, without_worst_case,
};

/// The sentence, the spread beside worst case and root sum of squares, the contributions, the worst assemblies.
pub fn text(result: &ToleranceResult, screen: &Screen) -> String {
    let about = &result.about;
    let mut text = screen.paragraphs(&format!("{}.", sentence(result)));
    text.push('\n');
    text += &screen.paragraphs(&format!(
        "{}: {} assemblies of seed {}, each over its whole mesh cycle.",
        plain(&about.title),
        result.assemblies,
        result.seed
    ));
    text.push('\n');
    text += &spread(result).text(screen);
    let statistics = &result.statistics;
    let capability = [("Cp", statistics.cp), ("Cpk", statistics.cpk)];
    let capability: Vec<String> = capability
        .into_iter()
        .filter_map(|(name, value)| Some(format!("{name} {}", fixed(value?, 2))))
        .collect();
    if !capability.is_empty() {
        text += &screen.fold(&format!("{}, if normal.\n", capability.join(", ")));
    }
    if let Some(without) = without_backlash(result) {
        text += &screen.fold(&format!("{without}\n"));
    }
    if let Some(phases) = phases_of_limits(about) {
        text += &screen.fold(&format!("{phases}\n"));
    }
    if about.limit_cases.is_some() && !about.without_end.is_empty() {
        text += &screen.fold(&format!(
            "Worst case: at its limits (3 standard deviations, or as stated) {}.\n",
            about.without_end.join(", ")
        ));
    }
    if let Some(why) = without_worst_case(about) {
        text += &screen.fold(&format!("{why}\n"));
    }
    if let Some(contributions) = contributions(result) {
        text.push('\n');
        text += &contributions.text(screen);
    }
    text.push('\n');
    text += &worst(result).text(screen);
    text
}

fn spread(result: &ToleranceResult) -> Table {
    let statistics = &result.statistics;
    let mut table = Table::new([
        Column::new("j_wt µm").left(),
        Column::new("least"),
        Column::new("greatest"),
    ]);
    let mut row = |name: String, each: [Option<f64>; 2]| {
        let [least, greatest] = each.map(|mm| um(mm, 2));
        table.add(vec![name, least, greatest]);
    };
    let both = [&statistics.least, &statistics.greatest];
    row("mean".to_owned(), both.map(|one| one.mean));
    row("standard deviation".to_owned(), both.map(|one| one.sigma));
    for (index, p) in QUANTILES.iter().enumerate() {
        let name = format!("{} % below", rounded(100.0 * p, 3));
        row(name, both.map(|one| one.quantiles[index]));
    }
    row(
        "least drawn".to_owned(),
        both.map(|one| one.least.map(|end| end.0)),
    );
    row(
        "greatest drawn".to_owned(),
        both.map(|one| one.greatest.map(|end| end.0)),
    );
    if let Some([mean, worst, roots]) = result.about.limit_cases {
        row("at the mean".to_owned(), mean);
        row("root sum of squares".to_owned(), roots);
        row("worst case".to_owned(), worst);
    }
    table
}

fn contributions(result: &ToleranceResult) -> Option<Table> {
    let [least, greatest] = &result.contributions;
    if least.each.is_empty() {
        return None;
    }
    let mut table = Table::new([
        Column::new("share of the variance, %").left(),
        Column::new("of the least"),
        Column::new("by itself").spare(1),
        Column::new("of the greatest"),
        Column::new("by itself").spare(1),
    ]);
    let percent = |index: gearlash::population::Estimate| {
        format!(
            "{} ± {}",
            fixed(100.0 * index.value, 1),
            fixed(100.0 * index.error, 1)
        )
    };
    for (index, one) in least.each.iter().enumerate() {
        let other = greatest.each.get(index);
        table.add(vec![
            one.factor.name().to_owned(),
            percent(one.total),
            percent(one.first),
            other.map_or(String::new(), |other| percent(other.total)),
            other.map_or(String::new(), |other| percent(other.first)),
        ]);
    }
    Some(table)
}

fn worst(result: &ToleranceResult) -> Table {
    let mut table = Table::new([
        Column::new("worst assemblies").left(),
        Column::new("least µm"),
        Column::new("greatest µm"),
    ]);
    for worst in &result.worst {
        let cells = [worst.least_mm, worst.greatest_mm].map(|mm| um(mm, 2));
        let [least, greatest] = cells;
        table.add(vec![worst.number.to_string(), least, greatest]);
    }
    table
}
