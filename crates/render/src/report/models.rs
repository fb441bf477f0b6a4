//! The three formulas compared with the simulation.

use super::figures::difference;
use super::page::Page;
use super::phrases::symbol;
use super::table::{Table, cells, columns};
use crate::chart::PictureError;
use gearlash::analysis::outcome::{MODELS, deviation};
use gearlash::pair::GearPair;
use gearlash_files::numbers::difference_um;
use maud::{Markup, html};

/// The inputs of each formula, in the order of [`MODELS`].
const NAMES: [(&str, &str); 3] = [
    (
        "1 Michalec, K (1)–(7)",
        "mean thickness, eccentricity; linear in the centre distance",
    ),
    (
        "2 involute, K (11)–(17)",
        "mean thickness, eccentricity at the pose",
    ),
    (
        "3 line of action",
        "every flank’s thickness and pitch, eccentricity; exact while involutes touch",
    ),
];

pub(super) fn section(page: &Page) -> Result<Markup, PictureError> {
    let of = &page.agreement;
    let counts = [
        (of.agree, "agree with model 3"),
        (
            of.off_line,
            "lie below model 3, the teeth touching off the line of action",
        ),
        (of.below, "lie below model 3 where involutes touch"),
        (of.above, "lie above model 3"),
        (
            of.simulated_alone,
            "have no value of model 3, no two involutes reaching each other",
        ),
        (of.jammed, "are jammed where model 3 has a value"),
        (of.apart, "are out of mesh where model 3 has a value"),
        (of.neither, "are jammed or out of mesh: neither has a value"),
        (of.unproven, "are unproven: not compared"),
    ];
    let counts = counts.iter().filter(|(poses, _)| *poses > 0);
    let counts: Vec<String> = counts
        .map(|(poses, words)| format!("{poses} {words}"))
        .collect();
    let columns = columns("model:w | what it includes | poses:n | mean:n | largest:n");
    let rows = NAMES.into_iter().zip(MODELS).map(|((name, knows), model)| {
        let found = deviation(&page.all, model);
        let [mean, largest] =
            [found.map(|of| of.mean), found.map(|of| of.largest)].map(difference_um);
        cells![name, knows, found.map_or(0, |of| of.poses), mean, largest]
    });
    Ok(html! {
        section id="models" {
            h2 { "Formulas beside the simulation" }
            p {
                "Of " (of.poses) " poses " (counts.join("; "))
                " (tolerance " (gearlash_files::numbers::shortest(page.report.pair.study.tolerance_um)) " µm and the error bound)."
            }
            @if page.report.pair.study.is_helical() {
                p {
                    "All three count in the transverse section: reference circles of " (symbol("m", "t")) " = " (symbol("m", "n")) "/cos " i { "β" } ", operating pressure angle "
                    (symbol("α", "wt")) " from cos " (symbol("α", "wt")) " = (" (symbol("r", "b1")) " + " (symbol("r", "b2")) ")/" i { "a" } ", base circles of "
                    (symbol("α", "t")) "; thickness allowances of the normal section are divided by cos " i { "β" } ". Models 1 and 2 know no face; model 3 takes every pair "
                    "of teeth that can touch within the common one."
                }
            }
            @if page.all.iter().any(|run| run.run.assembly.data().is_some_and(GearPair::is_modified)) {
                p {
                    "Models 1 and 2 know no profile deviation. Model 3 takes it at its own contact point; where a flank is tilted there the real "
                    "contact lies beside it, which the model cannot follow: it lies above by the square of the tilt."
                }
            }
            (Table::new("Formulas beside the simulation", html! { "Simulated minus formula, µm" }, columns, rows))
            (difference(page)?)
        }
    })
}
