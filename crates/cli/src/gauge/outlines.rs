//! `gearlash gauge` on outlines: the spans and pins that were asked for.

use super::{Args, unwritable};
use crate::console::{print, warn};
use crate::error::Error;
use crate::gears::{GearName, MaterialName, one_only};
use crate::results::Format;
use gearlash::analysis::study::Material;
use gearlash::gauge::gauge_outline;
use gearlash_files::outlines::{OutlineGearEntry, OutlineGearsFile};
use gearlash_render::gauge::outlines as text;
use gearlash_results::gauge::teeth_csv;
use gearlash_results::gauge::{GaugedOutline, gauged_json};
use std::process::ExitCode;

/// Runs the command.
pub(super) fn run(args: &Args, file: &OutlineGearsFile) -> Result<ExitCode, Error> {
    if args.ball_mm.is_some()
        || args.master_teeth.is_some()
        || args.page
        || args.results.names_folder()
    {
        return Err(Error::Usage(
            "--ball-mm, --master-teeth, --page and -o are for gears by their data: of outlines spans and pins are printed; leave them out"
                .to_owned(),
        ));
    }
    if args.span_teeth.is_none() && args.pin_mm.is_none() {
        return Err(Error::Usage(
            "an outline can be asked for spans (--span-teeth K) and for pins (--pin-mm D); pitch, thickness and the roll test need an involute, which it has not"
                .to_owned(),
        ));
    }
    let name = args.gear.map(GearName::name);
    let material = args.material.map(MaterialName::material);
    let chosen = |entry: &&OutlineGearEntry| {
        name.is_none_or(|name| name == entry.name)
            && material.is_none_or(|of| [of, Material::AsMeasured].contains(&entry.material))
    };
    let measured = |entry| GaugedOutline {
        entry,
        gauged: gauge_outline(&entry.gear, args.span_teeth, args.pin_mm),
    };
    let gears: Vec<GaugedOutline> = file.gears.iter().filter(chosen).map(measured).collect();
    if let (true, Some(name)) = (gears.is_empty(), name) {
        return Err(one_only(name, &args.file));
    }
    let reason = |gauged: &GaugedOutline| match &gauged.gauged.pins {
        Some(Err(reason)) => Some(format!("{}: {reason}", gauged.words())),
        _ => None,
    };
    let reasons: Option<Vec<String>> = gears.iter().map(reason).collect();
    if let (Some(pin), Some(reasons)) = (args.pin_mm, reasons) {
        let reasons = reasons.join("; ");
        return Err(Error::Usage(format!("--pin-mm {pin}: {reasons}")));
    }
    print(&match args.results.format {
        Format::Text => text(&file.title, &gears, args.positions, &args.screen.screen()),
        Format::Json => gauged_json(&file.title, &gears).map_err(unwritable)?,
        Format::Csv => teeth_csv(gears.iter().map(GaugedOutline::by_tooth)).map_err(unwritable)?,
    })?;
    if let Format::Csv = args.results.format {
        // Blank columns say nothing; the other formats tell.
        for gauged in &gears {
            let line = |line| format!("{}: {line}", gauged.words());
            let lines: Vec<String> = gauged.unmeasured().into_iter().map(line).collect();
            warn(&args.file, &lines, &[]);
        }
    }
    Ok(ExitCode::SUCCESS)
}
