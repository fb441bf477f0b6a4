//! `gearlash outline`: the outline of a gear for other programs.

use crate::error::Error;
use crate::input;
use crate::options::{GEARS, MATERIALS, choose, one_of};
use crate::output::Target;
use gearlash::analysis::study::Material;
use gearlash::gear::{AsBuilt, HalfTooth, Side};
use gearlash::pair::Member;
use gearlash_drawing::{OutlineFile, OutlineFormat};
use gearlash_input::GearEntry;
use gearlash_input::spec::GearSpec;
use gearlash_text::has_extension;
use std::path::PathBuf;

/// Write the outline of a gear as measured as DXF, SVG or CSV
///
/// The closed outline in mm, with every tooth where it was measured, as the reference face shows it: the rotation axis at 0,0 (a
/// gear with runout is beside it), tooth 1 up, numbers clockwise. Flanks are chords within the tolerance of their curves; tip and
/// root lands are arcs in DXF (bulges) and SVG, chords in CSV. The file's header states the bound. A gear that varies along
/// the face gives a transverse section, turned with the helix.
#[derive(clap::Args)]
pub(super) struct Args {
    /// Pair file or gear file, - for standard input
    file: PathBuf,
    /// Gear of a pair
    #[arg(long, value_parser = one_of(GEARS))]
    gear: Option<Member>,
    /// End of the thickness tolerance
    #[arg(long, value_parser = one_of(MATERIALS), default_value = "most")]
    material: Material,
    /// File format
    #[arg(long, value_parser = one_of(FORMATS))]
    format: Format,
    /// Greatest distance of a chord from its curve, µm
    #[arg(long, value_name = "T", default_value_t = 1.0, value_parser = tolerance, allow_negative_numbers = true)]
    tolerance_um: f64,
    /// Transverse section, mm from the measuring plane [default: 0, or the nearest end of the teeth]
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    section: Option<f64>,
    /// File, - for standard output [default: in out/<file stem>]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// A format of outlines, and the ending of its files.
type Format = (OutlineFormat, &'static str);

/// Values of `--format`.
const FORMATS: [(Format, &str, &str); 3] = [
    ((OutlineFormat::Dxf, "dxf"), "dxf", ""),
    ((OutlineFormat::Svg, "svg"), "svg", ""),
    ((OutlineFormat::Csv, "csv"), "csv", ""),
];

/// A tolerance in µm.
fn tolerance(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(um) if (0.001..=1000.0).contains(&um) => Ok(um),
        _ => Err("a number of µm from 0.001 to 1000 is needed".to_owned()),
    }
}

/// Most points of an outline: some 100 MB as text.
const MAX_POINTS: usize = 2_000_000;

/// Checks that the outline fits into memory several times over.
fn check_size(tolerance_um: f64, gear: &AsBuilt) -> Result<(), Error> {
    let profile = gear.profile(Side::Right, 1);
    let half = HalfTooth::new(&profile, Side::Right, tolerance_um * 1e-3);
    let points = 2 * half.segments().len() * gear.gear().basic_data().teeth() as usize;
    if points > MAX_POINTS {
        Err(Error::Usage(format!(
            "--tolerance-um {tolerance_um}: the outline would have {points} points, allowed are {MAX_POINTS}; give a greater tolerance"
        )))
    } else {
        Ok(())
    }
}

/// The requested section, mm; the gear must have it.
fn section(requested: Option<f64>, entry: &GearEntry, gear: &AsBuilt) -> Result<f64, Error> {
    let spec = entry.spec.data().filter(|_| gear.varies_along_face());
    let face = spec.and_then(GearSpec::face);
    let Some(mm) = requested else {
        return Ok(face.map_or(0.0, |[from, to]| 0f64.clamp(from, to)));
    };
    let refused = match face {
        None => "has one outline all along: leave --section out".to_owned(),
        Some([from, to]) if from <= mm && mm <= to => return Ok(mm),
        Some([from, to]) => format!("has teeth from {from} to {to} mm: choose a section there"),
    };
    Err(Error::Usage(format!(
        "--section {mm}: the {} {refused}",
        entry.name
    )))
}

pub(super) fn run(args: &Args) -> Result<u8, Error> {
    let study = gearlash_input::read_gears_by_data(&args.file)?;
    input::report(&args.file, &study.sources, &study.warnings, &study.remarks)?;
    let chosen = choose(&args.file, args.gear, Some(args.material), &study, |gear| {
        let materials = gear.materials.iter();
        materials.map(|(of, built)| (*of, built)).collect()
    })?;
    let [(entry, material, gear)] = chosen[..] else {
        return Err(Error::Usage(format!(
            "which gear? {} has a wheel and a pinion; give --gear wheel or --gear pinion",
            args.file.display()
        )));
    };
    let section_mm = section(args.section, entry, gear)?;
    check_size(args.tolerance_um, gear)?;
    let (format, ending) = args.format;
    let target = match &args.output {
        // A CSV file is allowed here: it is the table itself.
        Some(file) if ending == "csv" && has_extension(file, &["csv"]) => {
            Target::prepare(file.clone(), &study.sources)?
        }
        Some(file) => Target::prepare_beside(file.clone(), &study.sources)?,
        None => {
            let name = match material {
                Material::AsMeasured => format!("outline_{}.{ending}", entry.name),
                _ => format!("outline_{}_{}.{ending}", entry.name, material.name()),
            };
            Target::given_or_own(None, &study.stem, &name, &study.sources)?
        }
    };
    let outline = OutlineFile {
        title: &study.title,
        name: entry.name,
        material,
        gear,
        section_mm,
        tolerance_um: args.tolerance_um,
    };
    target.write(&outline.text(format))?;
    Ok(0)
}
