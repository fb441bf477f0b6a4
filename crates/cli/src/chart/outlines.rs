//! `gearlash chart` of a pair with an outline: backlash over the mesh cycle, and over the centre distance, too.

use super::drawn::{MAP, distance, first_map, heading, suffix};
use super::{Args, Kind};
use crate::console::tell_verdict;
use crate::error::{Error, exit_code};
use crate::maps;
use crate::method::all_proven;
use crate::outlines::runs;
use crate::target::Target;
use gearlash::analysis::outlines::unproven;
use gearlash_files::OutlinePairFile;
use gearlash_render::chart;
use gearlash_results::outlines::lines;
use std::process::ExitCode;

/// Runs the command.
pub(super) fn run(args: &Args, mut file: OutlinePairFile) -> Result<ExitCode, Error> {
    if !matches!(args.kind, Kind::Revolution | Kind::Map) {
        return Err(Error::Usage(
            "an outline has no module, no involute and no formula: of pairs with an outline draw --kind revolution or map".to_owned(),
        ));
    }
    if args.material.is_some() {
        return Err(Error::Usage(
            "--material is for gears by their data: every material has its line; leave it out"
                .to_owned(),
        ));
    }
    let unit = args.unit.of_outlines(&file.study, true)?;
    let distance = distance(args, &file.study.center_distances)?;
    file = file.at(distance);
    let output = match &args.output {
        Some(output) => Target::prepare_beside(output.clone(), &file.sources)?,
        None => {
            let name = match args.kind {
                Kind::Map => MAP.to_owned(),
                _ => format!(
                    "chart_revolution_a{}{}.svg",
                    file.study.center_distances[0],
                    suffix(unit)
                ),
            };
            Target::prepare_own(&file.stem, name, &file.sources)?
        }
    };
    let runs = runs(&file, &args.method)?;
    tell_verdict(&lines(&file.study, &runs));
    let heading = heading(&file.study.title, "");
    output.write(&match args.kind {
        Kind::Map => first_map(maps::of_outlines(&file, &runs)?)?,
        _ => chart::outlines(unit, &heading, &runs)?.svg,
    })?;
    Ok(exit_code(all_proven(unproven(&runs))))
}
