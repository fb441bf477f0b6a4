//! `gearlash gauge`: measures a gear on the model as the shop does.

use crate::console::{print, warn};
use crate::error::Error;
use crate::input;
use crate::options::{self, DrawnArgs, Format, GEARS, MATERIALS, ResultsArgs, ScreenArgs};
use crate::options::{is_drawing, one_of};
use crate::output::OutputFolder;
use crate::progress::Progress;
use gearlash::analysis::study::Material;
use gearlash::gauge::{Settings, gauge, gauge_outline, pin_sizes, pose_count};
use gearlash::gear::AsBuilt;
use gearlash::outline::OutlineGear;
use gearlash::pair::Member;
use gearlash_input::spec::GearSpec;
use gearlash_input::{GearEntry, GearsFile};
use gearlash_render::gauge::{charts, page, text};
use gearlash_results::gauge::{GaugedGear, json, possible_files, stem, table_name, teeth_csv};
use std::path::PathBuf;

/// Measure a gear on the model as the shop does: span, pins, runout, pitch, thickness, profile, roll test
///
/// Anvils, pins, balls, measuring circles and a perfect master gear are placed in contact with the outline of the gear
/// as built. Prints least, mean and greatest of each reading; --positions adds a table with one row per tooth.
/// Writes for each gear and material one table of all readings into DIR, gauge_<gear>.csv, a chart of each reading that deviates, and
/// a gear file gauge_<gear>.toml that states them. Files of an earlier run for the same gear and material are replaced or removed;
/// nothing else is touched.
///
/// On a drawing, and where a gear of the file is one, spans and pins are measured when asked for (--span-teeth, --pin-mm),
/// and no files are written: an outline has no involute for the rest.
#[derive(clap::Args)]
pub(super) struct Args {
    /// Pair file, gear file, or drawing (.dxf, .svg, .csv, .txt); - for standard input
    file: PathBuf,
    /// Only this gear of a pair
    #[arg(long, value_parser = one_of(GEARS))]
    gear: Option<Member>,
    /// Only this end of the thickness tolerance
    #[arg(long, value_parser = one_of(MATERIALS))]
    material: Option<Material>,
    /// Teeth spanned [default: as stated, else contact near mid-height]
    #[arg(long, visible_alias = "span", value_name = "K", value_parser = clap::value_parser!(u32).range(1..=10_000))]
    span_teeth: Option<u32>,
    /// Diameter of the pins, mm [default: as stated, else contact at mid-height, rounded up]
    #[arg(long, visible_alias = "pin", value_name = "D", value_parser = diameter, allow_negative_numbers = true)]
    pin_mm: Option<f64>,
    /// Diameter of the runout ball, mm [default: as stated, else the pin's]
    #[arg(long, value_name = "D", value_parser = diameter, allow_negative_numbers = true)]
    ball_mm: Option<f64>,
    /// Teeth of the master gear [default: 30, or as the tips need]
    #[arg(long, value_name = "Z", value_parser = clap::value_parser!(u32).range(3..=10_000))]
    master_teeth: Option<u32>,
    /// Roll test poses per pitch
    #[arg(long, value_name = "N", default_value_t = 16, value_parser = clap::value_parser!(u32).range(1..=1000))]
    steps_per_pitch: u32,
    /// Also print every reading (--format csv always does)
    #[arg(long)]
    positions: bool,
    /// Draw all charts of a gear on one page, gauge_<gear>.html
    #[arg(long, conflicts_with = "no_files")]
    page: bool,
    #[command(flatten)]
    drawn: DrawnArgs,
    #[command(flatten)]
    results: ResultsArgs,
    #[command(flatten)]
    screen: ScreenArgs,
}

/// A diameter in mm.
fn diameter(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(mm) if mm > 0.0 && mm <= 1e6 => Ok(mm),
        _ => Err("a number of mm above 0 and up to 1e6 is needed".to_owned()),
    }
}

pub(super) fn run(args: &Args) -> Result<u8, Error> {
    let file = read(args)?;
    let chosen = options::choose(&args.file, args.gear, args.material, &file, materials)?;
    let mut own = Vec::new();
    for (gear, material, (data, _)) in &chosen {
        own.extend(possible_files(&stem(gear.name, *material)));
        if let Some((as_built, _)) = data {
            check_span(args, gear.name, as_built)?;
        }
    }
    let folder = if file.gears.iter().any(|gear| !gear.drawn.is_empty()) {
        check_drawn(args)?;
        None
    } else {
        let own = move |name: &str| own.iter().any(|own| own == name);
        args.results.folder(&file.stem, &file.sources, own)?
    };

    let given = Settings {
        span_teeth: args.span_teeth,
        pin: args.pin_mm,
        ball: args.ball_mm,
        master_teeth: args.master_teeth,
        steps_per_pitch: args.steps_per_pitch,
        ..Settings::default()
    };
    let by_data = chosen.iter().filter_map(|(_, _, (data, _))| *data);
    let poses = by_data.map(|(gear, spec)| pose_count(gear, &spec.gauge_settings(given)));
    let progress = Progress::of(poses.sum(), "poses");
    let mut gears = Vec::new();
    for (gear, material, (data, outline)) in chosen {
        progress.now(&format!("({} {})", gear.name, material.name()));
        let more = |poses| progress.more(poses);
        let read = |(as_built, spec): (&AsBuilt, &GearSpec)| {
            let settings = spec.gauge_settings(given);
            // Readings of all materials of a gear compare only over the same span and pin.
            let first = gear.materials.first().map_or(as_built, |(_, first)| first);
            let settings = settings.with_usual(first);
            gauge(as_built, &settings, &more, &|steps| progress.tick(steps))
        };
        let drawn = outline.map(|gear| gauge_outline(gear, args.span_teeth, args.pin_mm));
        let teeth = outline.map(OutlineGear::teeth);
        let gauged = data.map(read).transpose()?.or(drawn);
        gears.extend(gauged.map(|gauged| GaugedGear {
            title: &file.title,
            name: gear.name,
            material,
            teeth: data.map(|(_, spec)| spec.teeth).or(teeth).unwrap_or(0),
            data,
            outline_bound: outline.map(OutlineGear::bound),
            gauged,
        }));
    }
    drop(progress);
    finish(args, &file.title, &gears, folder)
}

/// The gears of the file or drawing.
fn read(args: &Args) -> Result<GearsFile, Error> {
    let file = if is_drawing(&args.file) {
        let [options] = args.drawn.options()?;
        gearlash_input::read_drawing(&args.file, &options)
    } else if args.drawn.given() {
        return Err(Error::Usage(format!(
            "{} belong to a drawing: files state them",
            DrawnArgs::NAMES
        )));
    } else {
        gearlash_input::read_gears(&args.file)
    }?;
    input::report(&args.file, &file.sources, &file.warnings, &file.remarks)?;
    Ok(file)
}

/// A gear on the gauge: by its data with its table, or by its outline.
type OnGauge<'a> = (Option<(&'a AsBuilt, &'a GearSpec)>, Option<&'a OutlineGear>);

/// A gear in each of its materials.
fn materials(gear: &GearEntry) -> Vec<(Material, OnGauge<'_>)> {
    let (data, drawn) = (gear.materials.iter(), gear.drawn.iter());
    let data =
        data.map(|(material, as_built)| (*material, (Some(as_built).zip(gear.spec.data()), None)));
    let drawn = drawn.map(|(material, outline)| (*material, (None, Some(outline))));
    data.chain(drawn).collect()
}

/// Rejects options that do not apply to an outline.
fn check_drawn(args: &Args) -> Result<(), Error> {
    if args.ball_mm.is_some()
        || args.master_teeth.is_some()
        || args.page
        || args.results.output.is_some()
    {
        return Err(Error::usage(
            "--ball-mm, --master-teeth, --page and -o are for gears by their data: of outlines spans and pins are printed; leave them out",
        ));
    }
    if args.span_teeth.is_none() && args.pin_mm.is_none() {
        return Err(Error::usage(
            "an outline has only spans (--span-teeth K) and dimensions over pins (--pin-mm D); pitch, thickness and the roll test need an involute",
        ));
    }
    Ok(())
}

/// Prints the readings and writes the files.
fn finish(
    args: &Args,
    title: &str,
    gears: &[GaugedGear],
    folder: Option<OutputFolder>,
) -> Result<u8, Error> {
    check_pin(args.pin_mm, gears)?;
    for gauged in gears {
        warn(&args.file, gauged.short_face().as_slice(), &[]);
    }
    print(&match args.results.format {
        Format::Text => text(title, gears, args.positions, &args.screen.screen()),
        Format::Json => json(title, gears),
        Format::Csv => teeth_csv(gears),
    })?;
    if let Format::Csv = args.results.format {
        // Blank columns do not explain themselves; the other formats state the reasons.
        for gauged in gears {
            let mut lines = gauged.unmeasured();
            for line in &mut lines {
                *line = format!("{}: {line}", gauged.words());
            }
            warn(&args.file, &lines, &[]);
        }
    }
    let Some(folder) = folder else {
        return Ok(0);
    };
    let mut files = Vec::new();
    for gauged in gears {
        let table = teeth_csv(std::slice::from_ref(gauged));
        files.push((table_name(&gauged.stem()), table));
        if args.page {
            files.extend(page(gauged)?);
        } else {
            files.extend(charts(gauged)?);
        }
        match gauged.gear_file() {
            Ok(file) => files.extend(file),
            Err(reason) => {
                let lost = format!("no gear file of the {}: {reason}", gauged.name);
                warn(&args.file, &[lost], &[]);
            }
        }
    }
    args.results.write(folder, &files)?;
    Ok(0)
}

/// Checks that a gear could be measured over the requested pins.
fn check_pin(pin: Option<f64>, gears: &[GaugedGear]) -> Result<(), Error> {
    let reason = |gauged: &GaugedGear| Some(gauged.gauged.pins.as_ref().err()?.to_string());
    let reasons: Option<Vec<String>> = gears.iter().map(reason).collect();
    let (Some(pin), Some(reasons)) = (pin, reasons) else {
        return Ok(());
    };
    let each = gears.iter().zip(reasons).map(|(gauged, reason)| {
        let Some((gear, _)) = gauged.data else {
            return format!("{}: {reason}", gauged.words());
        };
        let fit = match pin_sizes(gear) {
            Some([least, greatest]) => {
                format!("pins of {least} … {greatest} mm touch its involutes")
            }
            None => "no pin touches its involutes".to_owned(),
        };
        format!("{}: {reason}; {fit}", gauged.name)
    });
    let each: Vec<String> = each.collect();
    Err(Error::Usage(format!("--pin-mm {pin}: {}", each.join("; "))))
}

/// Checks that the gear has enough teeth for the span.
fn check_span(args: &Args, name: &str, gear: &AsBuilt) -> Result<(), Error> {
    let z = gear.gear().basic_data().teeth();
    match args.span_teeth {
        Some(k) if k > z => Err(Error::Usage(format!(
            "--span-teeth {k}: the {name} has {z} teeth, allowed is 1 … {z}; give fewer, or choose the other gear with --gear"
        ))),
        _ => Ok(()),
    }
}
