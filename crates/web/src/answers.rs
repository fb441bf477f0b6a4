//! Answers of the page as JSON. Every number and sentence comes from the packages that the program uses.

use crate::archive::archive;
use gearlash::analysis::assembles_from::Threshold;
use gearlash::analysis::curves::courses;
use gearlash::analysis::diagnosis::CheckVerdict;
use gearlash::analysis::extremes::{self, RunExtremes};
use gearlash::analysis::requirement::{Limits, Quantity};
use gearlash::analysis::study::{Material, Study};
use gearlash::analysis::verdict::Verdict;
use gearlash::analysis::without_play::{WithoutPlay, tips_on_roots};
use gearlash::analysis::{Analysis, Plan, Progress};
use gearlash::contact::{Doubt, Method, PoseResult, lost_motion_at};
use gearlash::error::Tick;
use gearlash::gear::Side;
use gearlash::outline::AssembledPair;
use gearlash::pair::{BacklashUnit, Mating, Member, SweepPlan};
use gearlash_input::PairFile;
use gearlash_input::outlines::{APART_MM, Drawings, OutlineOptions};
use gearlash_input::{import, read_files, with_distance};
use gearlash_render::chart::{self, Heading};
use gearlash_render::viewer::LivePose;
use gearlash_render::{Report, dark_style, pose_picture};
use gearlash_results::RemedyRecords;
use gearlash_results::gauge::grades;
use gearlash_results::text::check;
use gearlash_results::text::{Screen, imported};
use gearlash_results::verdict::{
    ExtremeLine, VerdictLines, extremes_in_short, lines, rounded_down, rounded_up, uncut,
};
use gearlash_text::numbers::{rounded, trimmed, um, unit_of};
use gearlash_text::{Files, InputError, MAX_BYTES, display_path, has_extension, too_large};
use serde_json::{Value, json};
use std::fmt::Display;
use std::ops::ControlFlow;
use std::path::Path;
use std::rc::Rc;
use std::sync::atomic::{AtomicU64, Ordering};

const METHOD: Method = Method::Exact { certify: true };

/// Most poses that a page holds: 500 MB of memory.
pub const MOST_POSES: u64 = 500_000;

/// Largest pair file, bytes: the editor of a longer text would not follow the keys.
const MOST_TEXT: u64 = 1 << 20;

/// Divisor of a verdict's effort for a live answer (tuned: every example that a verdict proves is proven, and one without a proof takes
/// 10 ms).
const LIVE_PARTS: u64 = 80;

/// A stated distance has six decimals.
const STATED: f64 = 1e-6;

/// Readings of a text whose distance is sought: it is as good as proportional.
const MOST_READINGS: u32 = 5;

/// Receives steps begun, steps in all and the stage; a break ends the work.
pub type OnStep<'a> = dyn Fn(u64, u64, &str) -> ControlFlow<()> + Sync + 'a;

/// The pair of each material at a centre distance.
type Pairs = [(Material, AssembledPair)];

/// The pose that a page shows.
#[derive(Debug, Clone, Copy)]
pub struct LivePlace {
    /// Centre distance, mm.
    pub distance: f64,
    /// Index of the `materials` of [`Page::open`].
    pub material: usize,
    /// Wheel and pinion tooth.
    pub teeth: [u32; 2],
    /// Whether the left flanks mate.
    pub left: bool,
    /// Fraction of a pitch beyond the mating.
    pub fraction: f64,
}

/// The files and the pair of a page.
#[derive(Debug, Default)]
pub struct Page {
    /// The files given.
    pub files: Files,
    pair: Option<PairFile>,
    main: String,
}

impl Page {
    /// Reads the pair file `main` of the files: its title, warnings and what a page lets one choose; or all its problems. `files` are those
    /// that it names, as [`Files::asked`].
    pub fn open(&mut self, main: &str) -> Value {
        let files = Rc::new(self.files.clone());
        let mut found = self.read(Rc::clone(&files), main);
        found["files"] = json!(files.asked());
        found
    }

    fn read(&mut self, files: Rc<Files>, main: &str) -> Value {
        self.main = main.to_owned();
        self.pair = None;
        let pair = match read_files(files, main) {
            Ok(pair) => pair,
            Err(error) => return problems(&error),
        };
        let study = &pair.study;
        let poses = Plan::new(study, METHOD).with_revolution().poses();
        if poses > MOST_POSES {
            return failed(format!(
                "{poses} poses, a page holds up to {MOST_POSES}: take fewer steps_per_pitch or centre distances"
            ));
        }
        let materials = study.material_names();
        let notes: Vec<String> = [&pair.warnings[..], &pair.remarks[..]].concat();
        let found = json!({
            "title": study.title,
            "stem": pair.stem,
            "notes": notes,
            "notes_title": counted(notes.len(), "note on the input", "notes on the input"),
            "teeth": study.teeth(),
            "distances_mm": study.center_distances,
            "materials": materials.map(|material| material.words()).collect::<Vec<_>>(),
            "range_mm": range(study),
            "marks": study.center_distances.iter().map(|a| mark(*a, "file", "pair file, a =", None)).collect::<Vec<_>>(),
        });
        self.pair = Some(pair);
        found
    }

    /// Verdict, checks, remedies and the curve over the teeth.
    pub fn result(&self, report: &OnStep) -> Value {
        let Some(pair) = &self.pair else {
            return nothing_open();
        };
        let plan = Plan::new(&pair.study, METHOD)
            .with_revolution()
            .with_remedies(pair.spec.stated_gears())
            .with_checks();
        let analysis = match analysed(&plan, report) {
            Ok(analysis) => analysis,
            Err(error) => return failed(error),
        };
        let verdict = analysis.verdict();
        let remedies = RemedyRecords::new(pair, &analysis.remedies);
        let checks = if analysis.diagnosis.groups.is_empty() {
            Value::Null
        } else {
            table(&analysis)
        };
        let first = (pair.study.center_distances[0], Mating::FIRST, "");
        let start = verdict.worst().map(|(extremes, assembly, pose)| {
            let mating = *pose.simulated.pose.mating();
            let material = extremes.material.words();
            (assembly.center_distance(), mating, material)
        });
        let (a, mating, material) = start.unwrap_or(first);
        json!({
            "verdict": verdict_json(&verdict),
            "checks": checks,
            "remedies": remedies.text(&verdict),
            "curve": curve(&analysis, &verdict),
            "start": {
                "distance_mm": in_fields(a),
                "wheel": mating.wheel_tooth,
                "pinion": mating.pinion_tooth,
                "left": mating.flank == Side::Left,
                "fraction": mating.fraction,
                "material": material,
            },
        })
    }

    /// The curve of [`Page::result`] at another centre distance: `{curve}`.
    pub fn curve(&self, a: f64, report: &OnStep) -> Value {
        let Some(pair) = &self.pair else {
            return nothing_open();
        };
        let found = movable(&pair.study).at(vec![a]).and_then(|study| {
            let plan = Plan::new(&study, METHOD).with_revolution().with_extremes();
            let analysis = analysed(&plan, report)?;
            Ok(json!({ "curve": curve(&analysis, &analysis.verdict()) }))
        });
        found.unwrap_or_else(failed)
    }

    /// Marks of an end of the slider: the distance from which the pair assembles (0), or up to which it is in mesh (1), which takes seconds.
    /// A pair without a result there has none.
    pub fn marks(&self, end: usize, report: &OnStep) -> Value {
        let Some(pair) = &self.pair else {
            return nothing_open();
        };
        let sought = ["from which it assembles", "up to which it is in mesh"][end];
        let stage = format!("Searching the distance {sought}");
        let tick = |_| report(0, 0, &stage);
        let a = range(&pair.study)[end];
        let found = movable(&pair.study).at(vec![a]).and_then(|study| {
            let found = extremes::extremes(&study, METHOD, &tick)?;
            let verdict = Verdict::of_study(&study, &found.each, Vec::new());
            let from =
                |at: Threshold| mark(rounded_up(at.high), "jams", "assembles from", at.doubt);
            let to = |at: Threshold| mark(rounded_down(at.low), "apart", "in mesh up to", at.doubt);
            Ok(match end {
                0 => verdict.assembles_from().map(from),
                _ => verdict.meshes_to().map(to),
            })
        });
        found.ok().flatten().into_iter().collect()
    }

    /// The pair file `name` with another centre distance: `{text, said}`; `{failed}` where it states no single one.
    pub fn with_distance(&self, name: &str, text: &str, mm: f64) -> Value {
        if !(mm > 0.0 && mm.is_finite()) {
            return failed("This is no distance. The pair file is unchanged.");
        }
        // The text states the distance at 20 °C, and where its axes are measured; the study has it warm, and at the wheel.
        let mut stated = mm;
        for _ in 0..MOST_READINGS {
            let Some((made, before)) = with_distance(Path::new(name), text, stated) else {
                return failed(
                    "The pair file does not state its centre distance in mm as one value. It is unchanged.",
                );
            };
            let found = match self.distances(name, &made)[..] {
                [found] => found,
                _ => mm,
            };
            if (found - mm).abs() <= STATED {
                let before: Vec<&str> = before.split_whitespace().collect();
                let mut said = format!("{} replaces {}", trimmed(stated, 0, 6), before.join(" "));
                if (stated - mm).abs() > STATED {
                    said += &format!(": {} mm in results", trimmed(mm, 0, 6));
                }
                return json!({ "text": made, "said": said + "." });
            }
            stated += mm - found;
        }
        failed("No centre distance of the pair file gives this one. It is unchanged.")
    }

    /// The centre distances of the pair file `name` with this text, mm; none where it has problems.
    fn distances(&self, name: &str, text: &str) -> Vec<f64> {
        let mut files = self.files.clone();
        files.add(name, text.as_bytes().to_vec());
        let read = read_files(Rc::new(files), name);
        read.map_or_else(|_| Vec::new(), |pair| pair.study.center_distances)
    }

    /// The files in a zip archive, as they were given.
    pub fn zip(&self) -> Vec<u8> {
        let names = self.files.names();
        archive(names.map(|name| (name, self.files.get(name).unwrap_or_default())))
    }

    /// The report as a page.
    pub fn report(&self, date: &str, report: &OnStep) -> Value {
        let Some(pair) = &self.pair else {
            return nothing_open();
        };
        let plan = Plan::whole(&pair.study, METHOD);
        let analysis = match analysed(&plan, report) {
            Ok(analysis) => analysis,
            Err(error) => return failed(error),
        };
        // All steps are done.
        let tick = |_| report(1, 1, "(report)");
        let _ = tick(0);
        let page = gearlash_render::report(&Report {
            pair,
            file: &self.main,
            date,
            analysis: &analysis,
            grades: &grades(pair),
            tick: &tick,
        });
        match page {
            Ok(html) => json!({ "html": html }),
            Err(error) => failed(error),
        }
    }

    /// The content of a table among the files, for people, and the lines of a pair file that name it: `{text, toml}`, or `{problems}`.
    pub fn understand(&self, name: &str) -> Value {
        let Some(bytes) = self.files.get(name) else {
            return failed(format!("{name} is not among the files"));
        };
        let options = import::Options {
            gear: "wheel",
            ..import::Options::default()
        };
        match import::tables(Path::new(name), bytes.to_vec(), &options) {
            Ok(found) => json!({
                "title": format!("Understood of {name}"),
                "text": imported(&found, &Screen::default()),
                "toml": found.toml,
            }),
            Err(error) => json!({
                "title": format!("{name} is no table"),
                "text": error.problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"),
            }),
        }
    }

    /// The answer to a problem that the page finds before it calls the program. `what` names the problem. `names` lists the files.
    pub fn said(&self, what: &str, names: &str) -> Value {
        let (reason, help) = match what {
            "not UTF-8" => ("is not UTF-8", "save it as UTF-8"),
            "unreadable" => ("cannot be read", "drop files, not folders"),
            "one drawing" => (
                "is not named in the pair file",
                "drop the drawing of the other gear too, or name this one in the pair file",
            ),
            "drawings" => (
                "are not named in the pair file",
                "keep two drawings: remove the others by ×",
            ),
            "tables" => (
                "are several tables",
                "drop one table alone to see what is understood of it",
            ),
            _ => (
                "The link in the address holds no pair that can be read",
                "copy the whole link again, or open a pair file",
            ),
        };
        let reason = format!("{names} {reason}");
        let problem = json!({ "reason": reason.trim(), "help": help });
        json!({ "title": counted(1, "problem", ""), "problems": [problem] })
    }

    /// The problem of the file `name` with this number of `bytes`; null where it is not too large.
    pub fn too_large(&self, name: &str, bytes: u64) -> Value {
        let name = Path::new(name);
        let is_text = has_extension(name, &["toml", "json"]);
        let most = if is_text { MOST_TEXT } else { MAX_BYTES };
        if bytes <= most {
            return Value::Null;
        }
        problems(&InputError::of(name, vec![too_large(bytes, most)]))
    }

    /// A pair file for two of the drawings at a centre distance, mm, or without play where that is not positive: `{text}`, or all problems of
    /// the drawings. `unit` is that of drawings without one, or empty.
    pub fn drawings(
        &self,
        drawings: [&str; 2],
        distance: f64,
        unit: &str,
        report: &OnStep,
    ) -> Value {
        const NAME: &str = "pair.toml";
        let [wheel, pinion] = drawings.map(Path::new);
        let options = OutlineOptions {
            units: Some(unit).filter(|unit| !unit.is_empty()),
            ..OutlineOptions::default()
        };
        let drawings = Drawings {
            wheel,
            pinion,
            center_distance_mm: APART_MM,
            options: [options; 2],
        };
        let (drawings, _) = drawings.with_units_needed(Some(&self.files));
        let found = || -> Result<Value, Value> {
            let mut files = self.files.clone();
            files.add(NAME, drawings.pair_file().into_bytes());
            let apart = read_files(Rc::new(files), NAME).map_err(|error| problems(&error))?;
            let center_distance_mm = if distance > 0.0 {
                distance
            } else {
                let nearest = tips_on_roots(&apart.study).map_err(failed)?;
                let nearest = nearest.ok_or_else(|| failed("these files are no drawings"))?;
                let tight = apart.at(vec![nearest]).map_err(failed)?;
                let plan = Plan::new(&tight.study, METHOD).with_extremes();
                let analysis = analysed(&plan, report).map_err(failed)?;
                let found = WithoutPlay::of(&analysis.verdict(), nearest);
                found.map_or(nearest, |found| found.distance)
            };
            let drawings = Drawings {
                center_distance_mm,
                ..drawings
            };
            Ok(json!({ "text": drawings.pair_file() }))
        };
        found().unwrap_or_else(|failed| failed)
    }

    /// One pose at another centre distance: status and backlash in words, a text for the picture, and the columns that move the mesh.
    pub fn live(&self, at: &LivePlace) -> Value {
        let answer = |study: &Study, pairs: &Pairs, pose: PoseResult| {
            let (status, j_wt) = (pose.status(), pose.backlash);
            let name = status.name().replace('_', " ");
            let state = match j_wt {
                None => name,
                Some(j_wt) => format!("{name}, {} µm", um(j_wt, 2)),
            };
            // The number alone says that a pose is clear.
            let words = state.strip_prefix("clear, ").unwrap_or(&state).to_owned();
            let touch = Side::BOTH.map(|side| {
                let found = pose.proven().filter(|_| j_wt.is_some());
                let contact = found.and_then(|found| found.on(side));
                let teeth = contact.map_or("no teeth".to_owned(), |contact| {
                    let [wheel, pinion] = [contact.wheel.tooth, contact.pinion.tooth];
                    format!("wheel {wheel} and pinion {pinion}")
                });
                format!("{teeth} on the {}", side.name())
            });
            let picture = format!("Mesh: {state}. Touching: {}.", touch.join(", "));
            let live = LivePose::new(study, pairs, at.material, pose)?;
            Some(live.columns().map_or_else(failed, |mesh| {
                json!({
                    "j_wt_um": j_wt.map(|mm| mm * 1e3),
                    "words": words,
                    "picture": picture,
                    "spoken": format!("At {} mm, this mating: {words}. ", trimmed(at.distance, 0, 6)),
                    "mesh": mesh,
                })
            }))
        };
        self.posed(at, answer)
    }

    /// The mesh of one pose, to be moved by the columns of [`Page::live`]: `{html}`.
    pub fn mesh(&self, at: &LivePlace) -> Value {
        self.posed(at, |study, pairs, pose| {
            let live = LivePose::new(study, pairs, at.material, pose)?;
            Some(json!({ "html": live.html() }))
        })
    }

    /// One pose as a sheet: `{svg}`.
    pub fn picture(&self, at: &LivePlace) -> Value {
        self.posed(at, |study, pairs, pose| {
            let (material, assembly) = pairs.get(at.material)?;
            let picture = pose_picture(&study.title, assembly, *material, &pose);
            Some(picture.map_or_else(failed, |svg| json!({ "svg": svg })))
        })
    }

    /// The answer from the pose at a place of the pair that is open.
    fn posed(
        &self,
        at: &LivePlace,
        answer: impl FnOnce(&Study, &Pairs, PoseResult) -> Option<Value>,
    ) -> Value {
        let Some(pair) = &self.pair else {
            return nothing_open();
        };
        let pairs = match pair.study.pairs(at.distance) {
            Ok(pairs) => pairs,
            Err(error) => return failed(error),
        };
        let Some((_, assembly)) = pairs.get(at.material) else {
            return nothing_open();
        };
        for (member, tooth) in Member::BOTH.into_iter().zip(at.teeth) {
            let of = assembly.teeth(member);
            if !(1..=of).contains(&tooth) {
                let name = member.name();
                return failed(format!("the {name} has teeth 1 … {of}, not {tooth}"));
            }
        }
        let mating = Mating {
            wheel_tooth: at.teeth[0],
            pinion_tooth: at.teeth[1],
            flank: if at.left { Side::Left } else { Side::Right },
            fraction: at.fraction,
        };
        match lost_motion_at(assembly, mating) {
            Ok(pose) => answer(&pair.study, &pairs, pose).unwrap_or_else(nothing_open),
            Err(error) => failed(error),
        }
    }

    /// Least and greatest backlash of the whole mesh cycle at another centre distance, in the lines of the verdict. It takes a part of the
    /// effort of a verdict, or all of it; `is_proven` says whether more effort finds nothing else.
    pub fn live_band(&self, a: f64, is_whole: bool, tick: &Tick) -> Value {
        let parts = if is_whole { 1 } else { LIVE_PARTS };
        let Some(pair) = &self.pair else {
            return nothing_open();
        };
        let found = movable(&pair.study).at(vec![a]).and_then(|study| {
            let found = extremes::extremes_alone(&study, METHOD, parts, tick)?;
            let verdict = Verdict::of_study(&study, &found.each, Vec::new());
            let value = |extreme: Option<f64>| json!(extreme.map(|mm| mm * 1e3));
            // Without the sentences on distances that follow from the extremes: those are not searched.
            let words = band_words(&uncut(&verdict));
            Ok(json!({
                "spoken": format!("Whole cycle: {words}"),
                "words": words,
                "is_proven": found.each.iter().all(RunExtremes::is_proven),
                "limits": limits(&study),
                "least_um": value(verdict.least().map(|(_, least)| least.low)),
                "greatest_um": value(verdict.greatest().map(|(_, greatest)| greatest.high)),
            }))
        });
        found.unwrap_or_else(failed)
    }
}

/// Centre distances to choose from, mm: from below the least of the pair to where the tips pass each other.
fn range(study: &Study) -> [f64; 2] {
    let distances = || study.center_distances.iter().copied();
    let (least, most) = (
        distances().fold(f64::INFINITY, f64::min),
        distances().fold(0.0, f64::max),
    );
    let pairs = study.pairs(least).into_iter().flatten();
    let reach = pairs.map(|(_, pair)| pair.reach()).reduce(f64::max);
    let reach = reach.unwrap_or(most);
    // Gears that are apart at every distance begin where theirs would be: two modules of depth nearer.
    let teeth = f64::from(study.teeth().iter().sum::<u32>());
    let near = if least < reach {
        least
    } else {
        reach * teeth / (teeth + 4.0)
    };
    // As far below as a fourth of the way up: backlash falls by more than two thirds of a module there.
    // Whole micrometres, which the slider counts from its end.
    [near - 0.25 * (reach - near), reach.max(most)].map(|mm| (mm * 1e3).round() / 1e3)
}

/// The study for other centre distances: without bearing clearance, so that a stated distance is the distance of the axes, and with
/// the matings of measured rows at each.
fn movable(study: &Study) -> Study {
    let measured = || SweepPlan::Matings {
        matings: study
            .measured
            .iter()
            .map(|row| (row.wheel_tooth, row.pinion_tooth))
            .collect(),
        fractions: vec![0.0],
    };
    Study {
        sweep: study.sweep.clone().or_else(|| Some(measured())),
        bearing_clearance: 0.0,
        ..study.clone()
    }
}

/// A distance as fields show it: that of a warm pair has any number of decimals.
fn in_fields(mm: f64) -> f64 {
    rounded(mm, 6)
}

/// A distance to mark on the slider.
fn mark(mm: f64, kind: &str, words: &str, doubt: Option<Doubt>) -> Value {
    let unless_proven = if doubt.is_some() { " (not proven)" } else { "" };
    let words = format!("{words} {} mm{unless_proven}", trimmed(mm, 0, 4));
    json!({ "mm": in_fields(mm), "kind": kind, "words": words })
}

/// The limits of the quantities in proportion to the operating backlash, as its values at the one centre distance of `study`.
fn limits(study: &Study) -> Value {
    let pairs = study.center_distances.first().map(|a| study.pairs(*a));
    let Some((_, pair)) = pairs.and_then(|pairs| pairs.ok()?.into_iter().next()) else {
        return json!([]);
    };
    let limits = study.requirements.iter().filter_map(|(quantity, limits)| {
        let per_backlash = match quantity {
            Quantity::RadialBacklash | Quantity::RadialClearance => return None,
            _ => quantity.bracket(&pair, [1.0; 2], false)?[0],
        };
        let (name, unit, per, decimals) = unit_of(*quantity);
        let of = match quantity {
            Quantity::OperatingBacklash => String::new(),
            _ => format!(", {name}"),
        };
        let Limits { min, max } = *limits;
        let ends = [("min", min), ("max", max)].into_iter();
        let shown = ends.filter_map(move |(end, limit)| {
            let words = format!("{end} {} {unit}{of}", trimmed(limit? * per, 0, decimals));
            Some(json!({ "um": limit? / per_backlash * 1e3, "words": words }))
        });
        Some(shown)
    });
    limits.flatten().collect()
}

/// The work of `plan`; its steps go to `report`.
fn analysed<'a>(plan: &Plan<'a>, report: &OnStep) -> Result<Analysis<'a>, gearlash::error::Error> {
    let of = plan.steps()?;
    let (done, stage) = (AtomicU64::new(0), std::sync::Mutex::new(String::new()));
    let tick = |steps| {
        let done = done.fetch_add(steps, Ordering::Relaxed);
        let stage = stage.lock().map(|stage| stage.clone()).unwrap_or_default();
        report(done, of, &stage)
    };
    let mut begun = |name: &str| {
        if let Ok(mut stage) = stage.lock() {
            name.clone_into(&mut stage);
        }
        let _ = report(done.load(Ordering::Relaxed), of, name);
    };
    Analysis::run(
        plan,
        &mut Progress {
            stage: &mut begun,
            tick: &tick,
        },
    )
}

/// The extremes in a line. Numbers alone do not say that the pair fails, or why a least or a greatest is missing: the status does.
fn band_words(lines: &VerdictLines) -> String {
    let rows = lines.extremes.iter();
    let rows: Vec<String> = rows
        .map(|row| format!("{} {}", row.name, row.value))
        .collect();
    let is_enough =
        rows.len() > 1 && matches!(lines.state, CheckVerdict::Pass | CheckVerdict::Warn);
    let mut words = match &rows[..] {
        [] => lines.status.clone(),
        _ if is_enough => format!("{}. {}", rows.join(", "), lines.proof),
        _ => format!("{} {}. {}", lines.status, rows.join(", "), lines.proof),
    };
    let unmet = lines
        .qualifiers
        .iter()
        .filter(|line| line.starts_with("Requirement not"));
    for line in unmet {
        words += &format!(" {line}.");
    }
    words
}

/// The verdict in a word, which says the same as its colour.
fn word(state: CheckVerdict, verdict: &Verdict) -> &'static str {
    let mut runs = verdict.runs.iter();
    match state {
        CheckVerdict::Pass => "Assembles",
        CheckVerdict::Warn => "Assembles, with warnings",
        CheckVerdict::Unproven => "Unproven",
        CheckVerdict::Fail if runs.all(|run| run.assembles() == Some(true)) => {
            "Assembles, but checks fail"
        }
        CheckVerdict::Fail => "Does not assemble",
    }
}

/// The verdict in lines, as the program prints it: their `text`, the numbers in it, and the sentences for which it has no room.
fn verdict_json(verdict: &Verdict) -> Value {
    let shown = lines(verdict);
    let row = |row: &ExtremeLine| json!([format!("{} backlash", row.name), row.value]);
    json!({
        "state": shown.state.name(),
        "word": word(shown.state, verdict),
        "rows": shown.extremes.iter().map(row).collect::<Vec<_>>(),
        "text": shown.to_string(),
        "left_out": shown.left_out,
    })
}

/// The checks as a table for people.
fn table(analysis: &Analysis) -> Value {
    let columns = check::table(&analysis.diagnosis);
    let rows = columns.first().map_or(0, |column| column.cells.len());
    let row = |number: usize| -> Vec<&str> {
        let cells = columns.iter().map(|column| column.cells[number].as_str());
        cells.collect()
    };
    json!({
        "headings": columns.iter().map(|column| column.heading.heading()).collect::<Vec<_>>(),
        "left": columns.iter().map(|column| column.heading.is_left()).collect::<Vec<_>>(),
        "rows": (0..rows).map(row).collect::<Vec<_>>(),
    })
}

/// The backlash over the teeth at the first centre distance as SVG, for a wide and for a narrow screen; empty where there is no
/// curve.
fn curve(analysis: &Analysis, verdict: &Verdict) -> Vec<String> {
    let study = analysis.study;
    let course = courses(&analysis.curves).into_iter().next();
    let Some(course) = course else {
        return Vec::new();
    };
    let course = course.with_cycle(&analysis.extremes.each, &study.requirements);
    let cycle = extremes_in_short(verdict);
    let heading = Heading {
        prefix: "curve",
        title: &study.title,
        subtitle: &cycle,
    };
    let chart = chart::revolution(BacklashUnit::Um, &heading, &course);
    let narrow = chart.narrow().svg;
    vec![dark_style(&chart.svg) + &chart.svg, narrow]
}

/// The problems of a file, with their places in its text.
fn problems(error: &InputError) -> Value {
    let spans = error.spans();
    let each = error.problems.iter().zip(spans).map(|(problem, span)| {
        let line = span
            .as_ref()
            .map(|span| 1 + error.text[..span.start].matches('\n').count());
        // A page counts as JavaScript does.
        let units = |end: usize| error.text[..end].encode_utf16().count();
        json!({
            "file": display_path(&error.file).display().to_string(),
            "key": problem.key,
            "value": problem.value,
            "reason": problem.reason,
            "help": problem.help,
            "line": line,
            "from": span.as_ref().map(|span| units(span.start)),
            "to": span.as_ref().map(|span| units(span.end)),
        })
    });
    let each: Vec<Value> = each.collect();
    json!({ "title": counted(each.len(), "problem", "problems"), "problems": each })
}

fn counted(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

fn failed(error: impl Display) -> Value {
    json!({ "failed": error.to_string() })
}

fn nothing_open() -> Value {
    failed("no pair is open")
}
