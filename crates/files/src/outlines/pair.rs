//! A pair file with an outline: two gears, their positions, and the study.

use super::gear::{self, DrawingRead, OutlinePart};
use crate::Tree;
use crate::assembly;
use crate::check::Checked;
use crate::gear::{GearPart, materials as of_materials};
use crate::gear_file;
use crate::measured::Measured;
use crate::pair_file::{PosesRead, names, rows_only};
use crate::read::{AnyGears, AnyPair, GearEntry, PairFile};
use crate::spec::{
    AssemblySpec, CenterDistanceSpec, EitherGearSpec, GEAR, PAIR, PairSpec, RequireSpec,
    UncertaintySpec,
};
use gearlash::analysis::study::{Material, Study};
use gearlash::gear::AsBuilt;
use gearlash::outline::{OutlineGear, OutlinePair};
use std::path::Path;

/// Tables that do not apply to an outline, and why.
const LEFT_OUT: [(&str, &str); 3] = [
    (
        "accuracy",
        "cuts no polygons: its curves are searched as drawn",
    ),
    ("compare", "has no formula to compare with"),
    ("tolerance", "does not scatter yet"),
];

/// Limits that do not apply to an outline, and why.
const NOT_REQUIRED: [(&str, &str); 3] = [
    (
        "j_bn_um",
        "lies along a line of action, which an outline has not",
    ),
    (
        "j_t_um",
        "is an arc of the reference circle, which an outline has not",
    ),
    (
        "j_r_um",
        "is worked out of an involute, which an outline has not",
    ),
];

/// One gear, in one or both materials.
struct Part {
    gears: Vec<(Material, OutlineGear)>,
    /// A gear given by its data, the thickest.
    data: Option<AsBuilt>,
    read: Option<DrawingRead>,
    spec: EitherGearSpec,
    warnings: Vec<String>,
    remarks: Vec<String>,
}

/// Reads the pair file of `tree`, which has at least one outline.
pub(crate) fn read(tree: &Tree) -> Option<AnyPair> {
    let file = Checked::new(&PAIR, tree.table());
    let table = file.table();
    let (stem, title) = names(&file, tree.path);
    for (name, why) in LEFT_OUT {
        if table.has(name) {
            table.add(
                name,
                format!("a pair with an outline {why}"),
                "remove the table",
            );
        }
    }
    let [wheel, pinion] = ["wheel", "pinion"].map(|name| part(&file, name));
    let teeth = [&wheel, &pinion].map(|part| part.as_ref().map(|part| part.gears[0].1.teeth()));
    let assembly = assembly::read(&file, !rows_only(&file));
    let poses = PosesRead::new(&file, (teeth[0], teeth[1]));
    let require = required(&file);
    let uncertainty = uncertain(&file, [&wheel, &pinion]);
    let (assembly, require) = (assembly?, require?);
    let locked = assembly.locked;
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
            "an outline is solved in one section: axes are parallel",
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
            "an outline is solved in one section: axes are parallel",
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
        table.add(&format!("assembly.{key}"), *reason, *help);
    }
    let (wheel, pinion) = (wheel?, pinion?);
    tree.reading.is_good().then_some(())?;
    let mut warnings = [&wheel.warnings[..], &pinion.warnings].concat();
    let stated = poses.distances(table, &assembly, None, &mut warnings)?;
    let distances = stated.distances_mm();
    let is_band = wheel.gears.len().max(pinion.gears.len()) > 1;
    poses.check_count(table, Some(&distances), is_band)?;
    let (measured, sweep) = poses.tables()?;
    warnings.extend(measured.as_ref().and_then(Measured::equal_rows));
    for &distance in &distances {
        let pair = OutlinePair::new(
            wheel.gears[0].1.clone(),
            pinion.gears[0].1.clone(),
            distance - assembly.bearing_clearance_mm.sum_mm(),
            locked,
        );
        if let Err(error) = pair {
            return table.refuse(
                "assembly.center_distance_mm",
                error.to_string(),
                gear::help(&error),
            );
        }
    }
    let gears = materials(&wheel, &pinion);
    let uncertainty = uncertainty?;
    let data = [&wheel, &pinion].map(|part| match &part.spec {
        EitherGearSpec::Data(spec) => part.data.as_ref().map(|gear| (&**spec, gear)),
        EitherGearSpec::Outline(_) => None,
    });
    let measured_spec = measured.as_ref().map(Measured::spec);
    let (sweep_spec, plan) = sweep.map(|sweep| (sweep.spec, sweep.plan)).unzip();
    let study = Study {
        bearing_clearance: assembly.bearing_clearance_mm.sum_mm(),
        requirements: require.map_or_else(Vec::new, |require| require.requirements()),
        all_phases: sweep_spec
            .as_ref()
            .is_some_and(|sweep| sweep.extremes.is_some()),
        measured: measured.map_or_else(Vec::new, Measured::into_rows),
        uncertainty: uncertainty.map(|stated| stated.of_pair(&assembly, data)),
        ..Study::of_drawn(&title?, gears, locked, distances, plan)
    };
    Some(PairFile {
        stem,
        drawings: [wheel.read, pinion.read],
        spec: PairSpec {
            title: study.title.clone(),
            wheel: wheel.spec,
            pinion: pinion.spec,
            assembly: AssemblySpec {
                housing_expansion_per_k: None,
                center_distance_mm: stated,
                ..assembly
            },
            measured: measured_spec,
            sweep: sweep_spec,
            accuracy: None,
            compare: None,
            require,
            uncertainty,
            tolerance: None,
        },
        study,
        warnings,
        remarks: [wheel.remarks, pinion.remarks].concat(),
        sources: tree.reading.sources(),
    })
}

/// `[require]`, limited to quantities that an outline has.
fn required(file: &Checked) -> Option<Option<RequireSpec>> {
    let require = file.read("require")?;
    let file = file.table();
    let given = NOT_REQUIRED.map(|(key, why)| (format!("require.{key}"), why));
    let given = given.iter().filter(|(key, _)| file.has(key));
    let refused = given.map(|(key, why)| {
        let help = "limit j_wt_um, lost_motion_arcmin or radial_clearance_mm";
        file.add(key, *why, help);
    });
    match refused.count() {
        0 => Some(require),
        _ => None,
    }
}

/// `[uncertainty]`, limited to quantities that the gears have.
fn uncertain(file: &Checked, gears: [&Option<Part>; 2]) -> Option<Option<UncertaintySpec>> {
    let stated: Option<UncertaintySpec> = file.read("uncertainty")?;
    let has_data = |part: &&Option<Part>| part.as_ref().is_none_or(|part| part.data.is_some());
    if gears.iter().any(has_data) {
        return Some(stated);
    }
    let keys: Vec<&str> = stated.iter().flat_map(UncertaintySpec::of_data).collect();
    for key in &keys {
        file.table().add(
            &format!("uncertainty.{key}"),
            "an outline has no such reading",
            "leave it out: runout_um and center_distance_um apply",
        );
    }
    keys.is_empty().then_some(stated)
}

fn part(file: &Checked, name: &str) -> Option<Part> {
    if file.table().has(&format!("{name}.outline")) {
        let OutlinePart {
            gears,
            read,
            spec,
            remarks,
        } = gear::read(file, name)?;
        return Some(Part {
            gears: of_materials(&gears, OutlineGear::clone),
            data: None,
            read: Some(read),
            spec: EitherGearSpec::Outline(Box::new(spec)),
            warnings: Vec::new(),
            remarks,
        });
    }
    let data = GearPart::read(file, name);
    let built = data.as_built?;
    Some(Part {
        gears: of_materials(&built, |gear| gear.into()),
        data: Some(built.most().clone()),
        read: None,
        spec: EitherGearSpec::Data(Box::new(data.spec?)),
        warnings: data.warnings,
        remarks: data.remarks,
    })
}

/// The pairs of each material. A gear with one material appears in both.
fn materials(wheel: &Part, pinion: &Part) -> Vec<(Material, OutlineGear, OutlineGear)> {
    let several = [wheel, pinion]
        .into_iter()
        .max_by_key(|part| part.gears.len());
    let names = several.map_or(&[][..], |part| &part.gears);
    let of = |part: &Part, index: usize| {
        let gears = part.gears.get(index).or(part.gears.first());
        gears.map(|(_, gear)| gear.clone())
    };
    let each = names.iter().enumerate();
    each.filter_map(|(index, (material, _))| {
        Some((*material, of(wheel, index)?, of(pinion, index)?))
    })
    .collect()
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
#[derive(Debug, Clone, Copy, Default)]
pub struct OutlineOptions<'a> {
    /// Its unit, as a pair file names it, where it states none.
    pub units: Option<&'a str>,
    /// `fit` or `bore`; `None`: at (0, 0).
    pub center: Option<&'a str>,
    /// The layer of a DXF.
    pub layer: Option<&'a str>,
    /// The element of an SVG.
    pub id: Option<&'a str>,
    /// Which of several outlines, from 1.
    pub number: Option<u32>,
    /// A point inside the outline, mm.
    pub at_mm: Option<[f64; 2]>,
}

impl Drawings<'_> {
    /// The text of the pair file for both drawings.
    pub fn pair_file(&self) -> String {
        let name = |path: &Path| {
            path.file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned()
        };
        let title = format!("{} and {}", name(self.wheel), name(self.pinion));
        format!(
            "{}{}{}[assembly]\ncenter_distance_mm = {:?}\n",
            key("title", Some(&title)),
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
pub(super) fn outline_table(name: &str, path: &Path, options: &OutlineOptions) -> String {
    let mut table = format!("[{name}.outline]\n");
    let file = path.display().to_string();
    for (name, value) in [
        ("file", Some(&file[..])),
        ("units", options.units),
        ("center_mm", options.center),
        ("layer", options.layer),
        ("id", options.id),
    ] {
        table += &key(name, value);
    }
    if let Some(number) = options.number {
        table += &format!("number = {number}\n");
    }
    if let Some(point) = options.at_mm {
        table += &format!("at_mm = {point:?}\n");
    }
    table + "\n"
}

/// Reads a gear file with an outline.
pub(crate) fn read_gear(tree: &Tree) -> Option<AnyGears> {
    let file = Checked::new(&GEAR, tree.table());
    let (stem, title) = names(&file, tree.path);
    let OutlinePart {
        gears,
        spec,
        remarks,
        ..
    } = gear::read(&file, "gear")?;
    Some(AnyGears {
        title: title?,
        stem,
        gears: vec![GearEntry {
            name: "gear",
            materials: Vec::new(),
            drawn: of_materials(&gears, OutlineGear::clone),
            spec: EitherGearSpec::Outline(Box::new(spec)),
        }],
        temperature_c: None,
        warnings: Vec::new(),
        remarks,
        sources: tree.reading.sources(),
    })
}

/// The text of the gear file for a drawing alone.
pub(crate) fn of_drawing(path: &Path, options: &OutlineOptions) -> String {
    outline_table("gear", path, options)
}

/// The keys of gears given by an outline.
fn outlines(file: &Tree) -> impl Iterator<Item = String> {
    let keys = ["wheel", "pinion", "gear"].map(|name| format!("{name}.outline"));
    let table = file.table();
    keys.into_iter().filter(move |key| table.has(key))
}

/// Whether a gear of a pair or gear file is given by an outline.
pub(crate) fn has_outline(file: &Tree) -> bool {
    outlines(file).next().is_some()
}

/// Rejects a pair or gear file with an outline where gears given by data are needed.
pub(crate) fn refuse(file: &Tree) -> Option<()> {
    if !has_outline(file) {
        return Some(());
    }
    let is_gear = gear_file::is_one(file);
    let schema = if is_gear { &GEAR } else { &PAIR };
    let checked = Checked::new(schema, file.table());
    for key in outlines(file) {
        checked.table().add(
            &key,
            "an outline has no module, no base circle and no line of action, which this command needs",
            format!(
                "use `gearlash check`, `simulate`, `snapshot`, `chart`, `report` or `gauge` with {}, or give the gear by its data",
                file.path.display()
            ),
        );
    }
    None
}
