//! Options that several commands have.

use crate::console::{has_colours, print, print_error_line, print_note, print_note_line};
use crate::error::Error;
use crate::output::{OutputFolder, own_folder};
use clap::ValueEnum;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use gearlash::analysis::Analysis;
use gearlash::analysis::study::{Material, Study};
use gearlash::analysis::tally::RunTally;
use gearlash::contact::{METHODS_AGREE_WITHIN, Method, MethodAgreement};
use gearlash::gear::{AsBuilt, Side};
use gearlash::pair::{BacklashUnit, Member};
use gearlash_drawing::Unit;
use gearlash_input::outlines::OutlineOptions;
use gearlash_input::{GearEntry, GearsFile};
use gearlash_results::text::Screen;
use gearlash_text::numbers::{order_um, power};
use gearlash_text::{Sources, has_extension};
use std::path::{Path, PathBuf};

/// Values of `--gear` and `--at`.
pub(super) const GEARS: [(Member, &str, &str); 2] = [
    (Member::Wheel, "wheel", "Gear 1"),
    (Member::Pinion, "pinion", "Gear 2"),
];

/// Values of `--material`.
pub(super) const MATERIALS: [(Material, &str, &str); 2] = [
    (Material::Most, "most", "Teeth at their thickest"),
    (Material::Least, "least", "Teeth at their thinnest"),
];

/// Values of `--flank`.
pub(super) const FLANKS: [(Side, &str, &str); 2] =
    [(Side::Right, "right", ""), (Side::Left, "left", "")];

/// Parses one of `values`, each with its name and help; a name may need none.
pub(super) fn one_of<T: Copy + Send + Sync + 'static, const N: usize>(
    values: [(T, &'static str, &'static str); N],
) -> impl TypedValueParser<Value = T> {
    let named = values.map(|(_, name, help)| {
        let value = PossibleValue::new(name);
        if help.is_empty() {
            value
        } else {
            value.help(help)
        }
    });
    PossibleValuesParser::new(named).try_map(move |name| {
        let found = values.iter().find(|(_, own, _)| *own == name);
        found.map(|(value, ..)| *value).ok_or("unknown name")
    })
}

/// A gear of a file, one of its materials, and the gear in that material.
pub(super) type Chosen<'a, T> = (&'a GearEntry, Material, T);

/// The requested gears and materials, in the order of the file; `materials` are those of a gear.
pub(super) fn choose<'a, T>(
    path: &Path,
    gear: Option<Member>,
    material: Option<Material>,
    file: &'a GearsFile,
    materials: impl Fn(&'a GearEntry) -> Vec<(Material, T)>,
) -> Result<Vec<Chosen<'a, T>>, Error> {
    let name = gear.map(Member::name);
    let mut chosen = Vec::new();
    for gear in &file.gears {
        if name.is_some_and(|name| name != gear.name) {
            continue;
        }
        for (of, found) in materials(gear) {
            // A single thickness is both ends of its tolerance.
            if material.is_none_or(|material| of == material || of == Material::AsMeasured) {
                chosen.push((gear, of, found));
            }
        }
    }
    match (chosen.is_empty(), name) {
        (true, Some(name)) => Err(Error::Usage(format!(
            "--gear {name}: {} has one gear only; leave --gear out",
            path.display()
        ))),
        _ => Ok(chosen),
    }
}

/// The name of an option's `value`.
pub(super) fn name_of(value: &impl ValueEnum) -> String {
    let named = value.to_possible_value();
    named.map_or_else(String::new, |named| named.get_name().to_owned())
}

/// Wheel and pinion tooth, such as `11,11`.
pub(super) fn teeth(text: &str) -> Result<(u32, u32), String> {
    let parsed = text.split_once(',').and_then(|(wheel, pinion)| {
        Some((wheel.trim().parse().ok()?, pinion.trim().parse().ok()?))
    });
    parsed.ok_or_else(|| "two tooth numbers are needed, wheel,pinion, such as 11,11".to_owned())
}

/// The material of `study` that `--material` names.
pub(super) fn material(named: Material, study: &Study) -> Result<Material, Error> {
    match study.material_count() {
        2 => Ok(named),
        _ => Err(Error::usage(
            "--material: this pair file states one thickness a gear; leave the option out",
        )),
    }
}

/// The unit of backlash in tables and charts.
#[derive(clap::Args)]
pub(super) struct UnitArgs {
    /// Unit of backlash [default: um]
    #[arg(long, value_enum)]
    unit: Option<UnitName>,
    /// Gear whose lost motion is shown, for --unit arcmin [default: the gear that turns]
    #[arg(long, value_parser = one_of(GEARS))]
    at: Option<Member>,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum UnitName {
    /// j_wt in µm
    Um,
    /// Lost motion at one gear in arcmin
    Arcmin,
}

impl UnitArgs {
    /// Whether a unit or its gear is given.
    pub(super) fn given(&self) -> bool {
        self.unit.is_some() || self.at.is_some()
    }

    /// The unit for the gears of `study`.
    pub(super) fn unit(&self, study: &Study) -> Result<BacklashUnit, Error> {
        match (self.unit, self.at) {
            (Some(UnitName::Arcmin), at) => Ok(study.arcmin(at.unwrap_or(study.locked.mate()))),
            (Some(UnitName::Um) | None, Some(_)) => Err(Error::usage(
                "--at belongs to --unit arcmin: j_wt is the same at both gears; leave it out",
            )),
            _ => Ok(BacklashUnit::Um),
        }
    }

    /// The unit of a table for the gears of `study`.
    pub(super) fn of_table(&self, study: &Study, is_text: bool) -> Result<BacklashUnit, Error> {
        let unit = self.unit(study)?;
        if self.given() && !is_text {
            return Err(Error::usage(
                "--unit belongs to --format text: JSON and CSV have every unit; leave it out",
            ));
        }
        Ok(unit)
    }
}

#[derive(clap::Args)]
pub(super) struct ResultsArgs {
    /// Output format; json and csv write files only with -o
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(super) format: Format,
    /// Folder for results and pictures [default: out/<file stem>]
    #[arg(short, long, value_name = "DIR")]
    pub(super) output: Option<PathBuf>,
    /// Write no files
    #[arg(long, conflicts_with = "output")]
    no_files: bool,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum Format {
    /// A readable table
    Text,
    /// The whole result
    Json,
    /// One table, one row per pose or tooth
    Csv,
}

impl ResultsArgs {
    /// The folder of the files, tried before the work begins; `None`: nothing is written. `own` are the names of the command's
    /// files, which replace those of an earlier run; never one of `sources`.
    pub(super) fn folder(
        &self,
        stem: &str,
        sources: &Sources,
        own: impl Fn(&str) -> bool + 'static,
    ) -> Result<Option<OutputFolder>, Error> {
        let path = self.path(stem);
        path.map(|path| OutputFolder::prepare(&path, sources, own))
            .transpose()
    }

    /// The path of the folder; `None`: nothing is written.
    pub(super) fn path(&self, stem: impl AsRef<Path>) -> Option<PathBuf> {
        let writes = self.format == Format::Text && !self.no_files;
        let own = || writes.then(|| own_folder(stem));
        self.output.clone().or_else(own)
    }

    /// Prints the result in its format, and writes `files` to the folder, if there is one.
    pub(super) fn finish(
        &self,
        [text, json, csv]: [&str; 3],
        folder: Option<OutputFolder>,
        files: &[(String, String)],
    ) -> Result<(), Error> {
        print(match self.format {
            Format::Text => text,
            Format::Json => json,
            Format::Csv => csv,
        })?;
        folder.map_or(Ok(()), |folder| self.write(folder, files))
    }

    /// Writes `files`, in addition to those already begun. After a table it also prints where they are.
    pub(super) fn write(
        &self,
        folder: OutputFolder,
        files: &[(String, String)],
    ) -> Result<(), Error> {
        let written = folder.write(files)?;
        match self.format {
            Format::Text => print_note(&format!("\n{written}\n")),
            Format::Json | Format::Csv => Ok(()),
        }
    }
}

/// Options of the commands that print tables.
#[derive(clap::Args, Default)]
pub(super) struct ScreenArgs {
    /// Print tables in full on a narrow terminal
    #[arg(long)]
    wide: bool,
}

impl ScreenArgs {
    /// The screen of standard output.
    pub(super) fn screen(&self) -> Screen {
        // There is no size without a terminal, or on one that does not know its own.
        let size = ::console::Term::stdout().size_checked();
        Screen {
            width: size
                .map(|(_, columns)| columns.into())
                .filter(|_| !self.wide),
            colour: has_colours(&std::io::stdout()),
        }
    }
}

/// Options for reading drawings.
#[derive(clap::Args)]
pub(super) struct DrawnArgs {
    /// Unit of drawings that state none; of two drawings A,B
    #[arg(long, value_name = "UNIT", value_delimiter = ',', value_parser = Unit::NAMED.map(|(name, _)| name))]
    units: Vec<String>,
    /// Axes of drawings: of the circle through the tips, or of the one inside; of two drawings A,B [default: origin]
    #[arg(long, value_name = "HOW", value_delimiter = ',', value_parser = ["fit", "bore", "origin"])]
    center: Vec<String>,
    /// DXF layer to read; of two drawings A,B
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    layer: Vec<String>,
    /// SVG element to read; of two drawings A,B
    #[arg(long, value_name = "ID", value_delimiter = ',')]
    id: Vec<String>,
    /// Outline to read, from 1 in the order of the file; of two drawings A,B
    #[arg(long, value_name = "N", value_delimiter = ',', value_parser = clap::value_parser!(u32).range(1..=10_000))]
    number: Vec<u32>,
    /// A point inside the outline to read, mm; of two drawings twice
    #[arg(long, value_name = "X,Y", value_parser = point, allow_hyphen_values = true)]
    at_mm: Vec<[f64; 2]>,
    /// Face that the drawing shows; of two drawings A,B [default: front]
    #[arg(long, value_name = "FACE", value_delimiter = ',', value_parser = ["front", "back"])]
    reference_face: Vec<String>,
}

impl DrawnArgs {
    /// The options that belong to drawings.
    pub(super) const NAMES: &'static str =
        "--units, --center, --layer, --id, --number, --at-mm and --reference-face";

    /// Whether any of them is given.
    pub(super) fn given(&self) -> bool {
        self.counts().iter().any(|(_, count)| *count > 0)
    }

    /// Each option with the number of its values.
    fn counts(&self) -> [(&'static str, usize); 7] {
        [
            ("--units", self.units.len()),
            ("--center", self.center.len()),
            ("--layer", self.layer.len()),
            ("--id", self.id.len()),
            ("--number", self.number.len()),
            ("--at-mm", self.at_mm.len()),
            ("--reference-face", self.reference_face.len()),
        ]
    }

    /// The options of `N` drawings. One value applies to all of them.
    pub(super) fn options<const N: usize>(&self) -> Result<[OutlineOptions<'_>; N], Error> {
        let mut counts = self.counts().into_iter();
        if let Some((name, count)) = counts.find(|(_, count)| *count > N) {
            return Err(Error::Usage(format!(
                "{name} has {count} values for {N} {}; give one for each",
                if N == 1 { "drawing" } else { "drawings" }
            )));
        }
        let options = std::array::from_fn(|k| OutlineOptions {
            units: value_of(&self.units, k).map(String::as_str),
            center: value_of(&self.center, k)
                .map(String::as_str)
                .filter(|how| *how != "origin"),
            layer: value_of(&self.layer, k).map(String::as_str),
            id: value_of(&self.id, k).map(String::as_str),
            number: value_of(&self.number, k).copied(),
            at_mm: value_of(&self.at_mm, k).copied(),
            reference_face: value_of(&self.reference_face, k).map(String::as_str),
        });
        Ok(options)
    }
}

/// The value for the drawing `k`: its own, or the only one.
fn value_of<T>(values: &[T], k: usize) -> Option<&T> {
    match values {
        [one] => Some(one),
        several => several.get(k),
    }
}

/// A point from `x,y`.
fn point(text: &str) -> Result<[f64; 2], String> {
    let numbers = text.split_once(',').and_then(|(x, y)| {
        let [x, y] = [x, y].map(|number| number.trim().parse::<f64>().ok());
        Some([x?, y?])
    });
    let finite = numbers.filter(|numbers| numbers.iter().all(|number| number.is_finite()));
    finite.ok_or_else(|| "expected x,y in mm, such as 12.5,-3".to_owned())
}

/// Whether a file is a drawing, by its extension.
pub(super) fn is_drawing(path: &Path) -> bool {
    gearlash_drawing::Format::of(path).is_some()
}

/// Usage error of `paths` that are neither `two` drawings nor pair files alone.
pub(super) fn not_two_drawings(paths: &[PathBuf], two: &str) -> Error {
    let is_table = |path: &&PathBuf| has_extension(path, &["csv", "txt"]);
    let table = paths.iter().find(is_table);
    let table = table.map_or(String::new(), |file| {
        let file = file.display();
        format!("; {file} counts as one by its name: gearlash import shows how to use a table")
    });
    Error::Usage(format!("give {two}, or pair files alone{table}"))
}

/// `--method` and `--no-certify`.
#[derive(clap::Args, Default)]
pub(super) struct MethodArgs {
    /// How lost motion is found [default: exact]
    #[arg(long, value_enum)]
    method: Option<MethodName>,
    /// Skip the proof of each exact result
    #[arg(long)]
    no_certify: bool,
}

/// Wheel and pinion by their data; a usage error with `reason` where a gear is drawn.
pub fn by_data<'a>(study: &'a Study, reason: &'static str) -> Result<[&'a AsBuilt; 2], Error> {
    let gears = study.materials.first();
    let gears = gears.map(|(_, wheel, pinion)| [wheel, pinion]);
    gears.ok_or_else(|| Error::usage(reason))
}

#[derive(Clone, Copy, ValueEnum)]
enum MethodName {
    /// On the exact tooth curves, each result proven; polygons check every 64th
    Exact,
    /// On polygons refined around each contact: an independent method, slower
    Polygon,
    /// Both: prints the largest difference; exit 1 where a pose has one above 1e-6 µm and both error bounds
    Both,
}

impl MethodArgs {
    /// Whether one of the options is given.
    pub fn given(&self) -> bool {
        self.method.is_some() || self.no_certify
    }

    /// The requested method, for the pair of `study`.
    pub fn of(&self, study: &Study) -> Result<Method, Error> {
        if self.method.is_some() {
            by_data(
                study,
                "--method is for gears by their data: drawn curves are searched as drawn, and polygons check every pose; leave it out",
            )?;
        }
        Ok(self.method())
    }

    /// The requested method.
    pub fn method(&self) -> Method {
        match self.method.unwrap_or(MethodName::Exact) {
            MethodName::Exact => Method::Exact {
                certify: !self.no_certify,
            },
            MethodName::Polygon => Method::Polygon,
            MethodName::Both => Method::Both,
        }
    }
}

/// Prints on standard error the difference of both methods, where both were requested, and the number of unproven poses. Returns
/// whether both pass.
pub(super) fn agreement<'a>(runs: impl IntoIterator<Item = &'a RunTally> + Clone) -> bool {
    let each = runs.clone().into_iter().map(|run| run.agreement);
    let agree = agreement_of(each.fold(MethodAgreement::default(), MethodAgreement::and));
    agree & all_proven(runs.into_iter().map(|run| run.unproven).sum())
}

/// [`agreement`] over everything that was analysed.
pub(super) fn agreed(analysis: &Analysis) -> bool {
    agreement_of(analysis.agreement()) & all_proven(analysis.unproven())
}

/// Prints on standard error the number of unproven poses, if any. Returns whether all are proven.
pub(super) fn all_proven(unproven: usize) -> bool {
    if unproven > 0 {
        let are = if unproven == 1 {
            "pose is"
        } else {
            "poses are"
        };
        print_error_line(&format!(
            "warning: {unproven} {are} UNPROVEN; the result tells which and why"
        ));
    }
    unproven == 0
}

/// Prints on standard error the difference of both methods. Returns whether it passes. Prints nothing for a single method.
pub(super) fn agreement_of(found: MethodAgreement) -> bool {
    if found.is_empty() {
        return found.agrees();
    }
    let verdict = if found.agrees() { "agree" } else { "DISAGREE" };
    let counts = [
        (found.one_alone, "only one method has a contact"),
        (found.beyond, "they differ by more than is allowed"),
    ];
    let counts = counts.into_iter().filter(|(count, _)| *count > 0);
    let counts = counts.map(|(count, what)| {
        let poses = if count == 1 { "pose" } else { "poses" };
        format!("at {count} {poses} {what}")
    });
    let mut parts: Vec<String> = counts.collect();
    if found.compared > 0 {
        parts.push(format!(
            "largest difference {} µm of j_wt (allowed at a pose: {} or the sum of both error bounds)",
            power(found.largest * 1e3, 2),
            order_um(METHODS_AGREE_WITHIN)
        ));
    }
    print_note_line(&format!(
        "exact and polygon method {verdict}: {}",
        parts.join("; ")
    ));
    found.agrees()
}
