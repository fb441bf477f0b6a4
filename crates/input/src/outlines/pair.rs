//! Pair files with an outline: what does not apply to them, and the file that two drawings stand for.

use super::gear::help;
use crate::check::check;
use crate::gear::GearPart;
use crate::is_gear_file;
use crate::pair_slips::excessive;
use crate::spec::{AssemblySpec, CenterDistanceSpec, GEAR, PAIR, UncertaintySpec};
use gearlash::contact::{Contact, LostMotion, OutlineKernel, Status, ToothPlace};
use gearlash::gear::Side;
use gearlash::outline::{OutlineGear, OutlinePair};
use gearlash::pair::Mating;
use gearlash_drawing::{Options, Unit};
use gearlash_text::numbers::{ascii, rounded, shortest};
use gearlash_text::{Files, InputError, Table, source};
use serde::Serialize;
use serde_with::skip_serializing_none;
use std::path::Path;

/// A distance at which no two gears touch, mm.
pub const APART_MM: f64 = 1e6;

/// Tables that do not apply to an outline, and why.
const NO_TABLES: [(&str, &str); 2] = [
    (
        "accuracy",
        "cuts no polygons: its curves are searched as drawn",
    ),
    ("compare", "has no formula to compare with"),
];

/// Keys of `[tolerance]` that do not apply to a pair with an outline, and why; those of a gear first.
const NO_SCATTER: [(&str, &str); 6] = [
    ("pitch", AS_DRAWN),
    ("per_tooth", AS_DRAWN),
    ("gears", AS_DRAWN),
    ("lead", ONE_SECTION),
    ("wobble_um", ONE_SECTION),
    ("misalignment", ONE_SECTION),
];

const AS_DRAWN: &str = "the gears of a pair with an outline scatter by thickness and runout alone";

const ONE_SECTION: &str = "an outline is solved in one section: axes are parallel";

/// Limits that do not apply to an outline, and why.
const NOT_REQUIRED: [(&str, &str); 3] = [
    (
        "require.j_bn_um",
        "lies along a line of action, which an outline has not",
    ),
    (
        "require.j_t_um",
        "is an arc of the reference circle, which an outline has not",
    ),
    (
        "require.j_r_um",
        "is worked out of an involute, which an outline has not",
    ),
];

/// Reports tables that do not apply to an outline.
pub(crate) fn refuse_tables(file: &Table) {
    for (name, why) in NO_TABLES.into_iter().filter(|(name, _)| file.has(name)) {
        let reason = format!("a pair with an outline {why}");
        file.add(name, reason, "remove the table");
    }
    let (of_a_gear, others) = NO_SCATTER.split_at(5);
    let tables = [("wheel.", of_a_gear), ("pinion.", of_a_gear), ("", others)];
    let scatters = tables.into_iter().flat_map(|(table, keys)| {
        let key =
            move |(key, why): &(&str, &'static str)| (format!("tolerance.{table}{key}"), *why);
        keys.iter().map(key)
    });
    for (key, why) in scatters.filter(|(key, _)| file.has(key)) {
        let help = "leave it out: thickness, runout, center_distance, bearing_play and phase apply";
        file.add(&key, why, help);
    }
}

/// Reports keys of `[assembly]` that do not apply to an outline.
pub(crate) fn refuse_axes(file: &Table, assembly: &AssemblySpec) {
    let refused = [
        (
            "face_offset_mm",
            assembly.face_offset_mm.is_some(),
            "an outline is of a spur gear: its face makes no difference",
            "leave it out",
        ),
        (
            "misalignment",
            assembly.misalignment.is_some(),
            ONE_SECTION,
            "leave it out",
        ),
        (
            "bearing_clearance_mm.at_mm",
            assembly.bearing_clearance_mm.at_mm.is_some(),
            "an outline is solved in one section: axes stay parallel",
            "give one clearance for each gear",
        ),
        (
            "center_distance_mm",
            matches!(assembly.center_distance_mm, CenterDistanceSpec::Ends(_)),
            ONE_SECTION,
            "give one distance",
        ),
        (
            "temperature_c",
            assembly.temperature_c.is_some(),
            "an outline is taken as it was drawn, at one temperature",
            "scale drawings and centre distance by 1 + expansion × (temperature − 20)",
        ),
    ];
    for (key, _, reason, help) in refused.iter().filter(|(_, stated, ..)| *stated) {
        file.add(&format!("assembly.{key}"), *reason, *help);
    }
}

/// Poses of a pitch that are looked at for slips.
const POSES: u32 = 16;
/// Most of these with tip contact that give no warning: teeth with deviations have some.
const MAX_TIP_POSES: usize = 8;

/// Warnings of centre distances that leave much backlash, or teeth out of contact, between the first teeth of gears by these outlines.
pub(crate) fn slips(
    [wheel, pinion]: [&OutlineGear; 2],
    distances: &[f64],
    assembly: &AssemblySpec,
) -> Vec<String> {
    let check = "the distance, and the units and scale of the drawings";
    let of = |a: Option<f64>, [wheel, pinion]: [OutlineGear; 2]| {
        let pair = OutlinePair::new(wheel, pinion, a?, assembly.locked).ok()?;
        let poses = (0..POSES).map(|k| Mating {
            fraction: f64::from(k) / f64::from(POSES),
            ..Mating::at(1, 1, Side::Right)
        });
        let kernel = OutlineKernel::new(&pair);
        let found = poses.map(|mating| kernel.lost_motion(&mating));
        let found = found.collect::<Result<Vec<_>, _>>().ok()?;
        Some((a?, pair, found))
    };
    // Teeth that are stated thinner are no reason to doubt the distance.
    let is_thin = |gear: &OutlineGear| gear.flank_offset().is_some_and(|offset| offset < 0.0);
    let thick = |gear: &OutlineGear| {
        if is_thin(gear) {
            gear.with_flank_offset(0.0).ok()
        } else {
            Some(gear.clone())
        }
    };
    let [near, far] = [f64::min, f64::max].map(|end| distances.iter().copied().reduce(end));
    let farthest = of(far, [wheel.clone(), pinion.clone()]);
    let is_thinned = is_thin(wheel) || is_thin(pinion);
    let thicker = || of(near, [thick(wheel)?, thick(pinion)?]);
    // Most files state one distance and no offset.
    let thickest = (is_thinned || near != far).then(thicker);
    let nearest = thickest.as_ref().unwrap_or(&farthest).as_ref();
    let backlash = nearest.and_then(|(a, pair, found)| {
        let angles = found.iter().filter_map(|found| found.angle());
        let backlash = angles.reduce(f64::min)? * pair.operating_pitch_radius(pair.free());
        let module = 2.0 * a / f64::from(wheel.teeth() + pinion.teeth());
        excessive(*a, "drawn", backlash, module, check)
    });
    let lost = farthest.and_then(|(a, _, found)| {
        // Teeth that overlap, or have no backlash, touch where they must.
        let is_free = |found: &&LostMotion| matches!(found.status(), Status::Clear | Status::NoContact);
        let is_tip = |of: &Contact| [of.wheel, of.pinion].iter().any(|touch| touch.curve == ToothPlace::Tip);
        let is_off = |found: &&LostMotion| [found.right, found.left].iter().any(|of| of.as_ref().is_none_or(is_tip));
        let off = found.iter().filter(is_free).filter(is_off).count();
        let is_any = found.iter().any(|found| found.angle().is_some());
        (is_any && off > MAX_TIP_POSES).then(|| {
            format!(
                "assembly.center_distance_mm: at {} mm tips touch at {off} of {POSES} poses of a pitch, so flanks may lose contact between two pitches: check {check}",
                ascii(a, 4)
            )
        })
    });
    backlash.into_iter().chain(lost).collect()
}

/// Checks that gears by these outlines make a pair at each of `distances`, mm.
pub(crate) fn check_distances(
    file: &Table,
    [wheel, pinion]: [&OutlineGear; 2],
    distances: &[f64],
    assembly: &AssemblySpec,
) -> Option<()> {
    let clearance = assembly.bearing_clearance_mm.sum_mm();
    let mut pairs = distances.iter().map(|distance| {
        let (wheel, pinion) = (wheel.clone(), pinion.clone());
        OutlinePair::new(wheel, pinion, distance - clearance, assembly.locked)
    });
    match pairs.find_map(Result::err) {
        Some(error) => file.refuse("assembly.center_distance_mm", &error, help(&error)),
        None => Some(()),
    }
}

/// Reports limits of quantities that an outline has not.
pub(crate) fn refuse_limits(file: &Table) {
    for (key, why) in NOT_REQUIRED.into_iter().filter(|(key, _)| file.has(key)) {
        let help = "limit j_wt_um, lost_motion_arcmin or radial_clearance_mm";
        file.add(key, why, help);
    }
}

/// Reports uncertainties of quantities that neither of two drawn gears has.
pub(crate) fn refuse_uncertainties(file: &Table, gears: [&GearPart; 2]) {
    let stated: Option<UncertaintySpec> = file.read("uncertainty").flatten();
    if gears.iter().any(|gear| gear.drawn.is_none()) {
        return;
    }
    for key in stated.iter().flat_map(UncertaintySpec::of_data) {
        file.add(
            &format!("uncertainty.{key}"),
            "an outline has no such reading",
            "leave it out: runout_um and center_distance_um apply",
        );
    }
}

/// Two drawings and their assembly, in place of a pair file.
#[derive(Debug, Clone, Copy)]
pub struct Drawings<'a> {
    /// The wheel's.
    pub wheel: &'a Path,
    /// The pinion's.
    pub pinion: &'a Path,
    /// `a`, mm.
    pub center_distance_mm: f64,
    /// How each is read.
    pub options: [OutlineOptions<'a>; 2],
}

/// How a drawing is read, as the keys of an outline's table state it.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, Default, Serialize)]
pub struct OutlineOptions<'a> {
    /// Its unit, as a pair file names it; used where the drawing states none.
    pub units: Option<&'a str>,
    /// `fit` or `bore`; `None`: at (0, 0).
    #[serde(rename = "center_mm")]
    pub center: Option<&'a str>,
    /// The layer of a DXF.
    pub layer: Option<&'a str>,
    /// The element of an SVG.
    pub id: Option<&'a str>,
    /// Which of several outlines, from 1.
    pub number: Option<u32>,
    /// A point inside the outline, mm.
    pub at_mm: Option<[f64; 2]>,
    /// `front` or `back`; `None`: the front. It is a key of the gear's table.
    #[serde(skip)]
    pub reference_face: Option<&'a str>,
}

impl<'a> OutlineOptions<'a> {
    /// These options for the drawing at `path`, among `files` if there are any: a unit that it states counts. A warning names one that is
    /// not used.
    pub(crate) fn with_unit_needed(
        self,
        path: &Path,
        files: Option<&Files>,
    ) -> (OutlineOptions<'a>, Option<String>) {
        let named = |given| Unit::NAMED.iter().find(|(name, _)| *name == given);
        let bytes = || files.map_or_else(|| source::bytes(path), |files| files.bytes(path));
        let given = self.units.and_then(named);
        let Some(((name, unit), bytes)) = given.and_then(|given| Some((given, bytes().ok()?)))
        else {
            return (self, None);
        };
        let select = self.layer.or(self.id).map(str::to_owned);
        let options = Options {
            select,
            ..Options::default()
        };
        let warning = match gearlash_drawing::read(path, &bytes, &options) {
            Err(error) if error.lacks_unit => return (self, None),
            Ok(drawing) if (drawing.unit_mm / unit.mm() - 1.0).abs() > 1e-6 => {
                let stated = shortest(rounded(drawing.unit_mm, 9));
                Some(format!(
                    "states that its unit is {stated} mm, which counts; {name} is not used"
                ))
            }
            _ => None,
        };
        let units = None;
        (OutlineOptions { units, ..self }, warning)
    }
}

impl<'a> Drawings<'a> {
    /// These drawings, among `files` if there are any: a given unit counts where a drawing states none. Warnings name units that are not used.
    pub fn with_units_needed(mut self, files: Option<&Files>) -> (Drawings<'a>, Vec<String>) {
        let mut warnings = Vec::new();
        for (options, path) in self.options.iter_mut().zip([self.wheel, self.pinion]) {
            let (needed, warning) = options.with_unit_needed(path, files);
            *options = needed;
            warnings.extend(warning.map(|words| format!("{}: {words}", path.display())));
        }
        (self, warnings)
    }

    /// The names of both files without folder and ending.
    pub(crate) fn stems(&self) -> [String; 2] {
        [self.wheel, self.pinion].map(|path| {
            let stem = path.file_stem().unwrap_or_default();
            stem.to_string_lossy().into_owned()
        })
    }

    /// The text of the pair file for both drawings.
    pub fn pair_file(&self) -> String {
        format!(
            "{}{}{}[assembly]\ncenter_distance_mm = {:?}\n",
            key("title", Some(&self.stems().join(" and "))),
            outline_table("wheel", self.wheel, &self.options[0]),
            outline_table("pinion", self.pinion, &self.options[1]),
            self.center_distance_mm
        )
    }
}

/// A line of a pair file; empty without a value.
fn key(name: &str, value: Option<&str>) -> String {
    let text = |value: &str| toml::Value::String(value.to_owned());
    value.map_or(String::new(), |value| format!("{name} = {}\n", text(value)))
}

/// The table of the gear `name` given by a drawing.
pub(crate) fn outline_table(name: &str, path: &Path, options: &OutlineOptions) -> String {
    let face = key("reference_face", options.reference_face);
    let file = key("file", Some(&path.display().to_string()));
    // Texts and numbers: nothing that TOML cannot hold.
    let others = toml::to_string(options).unwrap_or_default();
    format!("[{name}]\n{face}[{name}.outline]\n{file}{others}\n")
}

/// Words of pair files about a drawing, and those of the command line.
const FLAGS: [(&str, &str); 12] = [
    (
        "center_mm = [x, y], \"bore\" or \"fit\"",
        "--center bore or fit",
    ),
    (
        "as [x, y] in mm, or \"fit\"",
        "by --center fit, or as center_mm in a pair file",
    ),
    ("as [x, y] in mm", "as center_mm in a pair file"),
    ("one point: join_mm", "one point, in a pair file: join_mm"),
    ("smaller join_mm", "smaller join_mm in a pair file"),
    ("with join_mm", "with join_mm in a pair file"),
    ("units = ", "--units "),
    ("`at_mm`", "--at-mm"),
    ("with at_mm", "with --at-mm"),
    ("`number`", "--number"),
    ("`layer`", "--layer"),
    ("`id`", "--id"),
];

/// The key of an outline's table, or of its pair, as an option of the command line; `None` where there is none.
fn flag(key: &str) -> Option<&'static str> {
    Some(match key.rsplit('.').next()? {
        "layer" => "--layer",
        "id" => "--id",
        "number" => "--number",
        "at_mm" => "--at-mm",
        "center_mm" => "--center",
        "units" => "--units",
        "reference_face" => "--reference-face",
        "center_distance_mm" => "--center-distance",
        _ => return None,
    })
}

/// The error of drawings on a command line: with its options in place of keys, without the generated text.
pub(crate) fn by_flags(mut error: InputError) -> InputError {
    let own = format!("{}: ", error.file.display());
    for problem in &mut error.problems {
        if let Some(flag) = flag(&problem.key) {
            flag.clone_into(&mut problem.key);
        } else if problem.key.ends_with("outline.file") {
            // The reason names the file.
            (problem.key, problem.value) = (String::new(), None);
        }
        let reason = problem.reason.strip_prefix(&own);
        problem.reason = reason.unwrap_or(&problem.reason).to_owned();
        for (key, flag) in FLAGS {
            problem.help = problem.help.replace(key, flag);
            problem.reason = problem.reason.replace(key, flag);
        }
    }
    error.text.clear();
    error
}

/// The keys of gears given by an outline.
fn outlines(file: &Table) -> impl Iterator<Item = &'static str> {
    let keys = ["wheel.outline", "pinion.outline", "gear.outline"].into_iter();
    keys.filter(|key| file.has(key))
}

/// Whether a gear of a pair or gear file is given by an outline.
pub(crate) fn has_outline(file: &Table) -> bool {
    outlines(file).next().is_some()
}

/// Rejects a pair or gear file with an outline where gears given by data are needed.
pub(crate) fn refuse(file: &Table) -> Option<()> {
    if !has_outline(file) {
        return Some(());
    }
    check(if is_gear_file(file) { &GEAR } else { &PAIR }, file);
    for key in outlines(file) {
        file.add(
            key,
            "an outline has no module, no base circle and no line of action, which this command needs",
            format!(
                "use `gearlash check`, `simulate`, `snapshot`, `chart`, `report`, `tolerance` or `gauge` with {}, or give the gear by its data",
                file.reading().name().display()
            ),
        );
    }
    None
}
