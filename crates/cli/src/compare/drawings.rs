//! `gearlash compare A.dxf B.svg`: two outlines of one gear.

use super::{Args, Format, of_option};
use crate::console::{check_not_input, print, warn};
use crate::error::{Error, exit_code};
use crate::outlines::is_drawing;
use crate::target::Target;
use gearlash_files::outlines::TwoDrawings;
use gearlash_render::outline_difference;
use gearlash_results::{comparison_json, difference_csv, text};
use std::process::ExitCode;

/// Runs the command for two drawings.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let [a, b] = &args.pairs[..] else {
        return Err(needs_two());
    };
    if !(is_drawing(a) && is_drawing(b)) {
        return Err(needs_two());
    }
    if args.method.given()
        || matches!(
            args.format,
            Format::Junit | Format::Github | Format::Markdown
        )
    {
        return Err(Error::usage(
            "--method, --no-certify and the formats junit, github and markdown are for pair files; leave them out",
        ));
    }
    let compared = gearlash_files::compare_drawings(&TwoDrawings {
        paths: [a, b],
        options: args.drawn.options()?,
    })?;
    check_not_input(&compared.sources)?;
    for (path, remarks) in args.pairs.iter().zip(&compared.remarks) {
        warn(path, &[], remarks);
    }
    let picture = Target::prepare_given(args.svg.as_ref(), &compared.sources);
    let picture = picture.map_err(|error| of_option(error, "--svg"))?;
    print(&match args.format {
        Format::Json => comparison_json(&compared, args.tolerance_um)
            .map_err(Error::unwritable("the outcome"))?,
        Format::Csv => difference_csv(&compared).map_err(Error::unwritable("the outcome"))?,
        _ => text::outline_difference(&compared, args.tolerance_um, &args.screen.screen()),
    })?;
    if let Some(target) = picture {
        let written = target.write_silently(&outline_difference(&compared));
        written.map_err(|error| of_option(error, "--svg"))?;
    }
    Ok(exit_code(compared.passes(args.tolerance_um)))
}

fn needs_two() -> Error {
    Error::usage("give two drawings of one gear, or pair files alone")
}
