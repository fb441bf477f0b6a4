//! The verdict on a pair, in at most six lines of at most 80 columns. Pages print every sentence in full.
//!
//! The first line states whether the pair assembles, and with what certainty. Least and greatest backlash follow, one line each,
//! with the teeth in contact (right flanks / left flanks). The other lines have sentences that qualify them, the most important
//! first.

use crate::assembly_state::{Place, distinct, status};
use crate::layout::{Screen, Tone};
use crate::pose::ContactRow;
use gearlash::analysis::compare::ComparedPose;
use gearlash::analysis::diagnosis::{CheckName, CheckVerdict};
use gearlash::analysis::extremes::{
    BearingExtremes, CoveredPhases, RunExtreme, RunExtremes, WIDTH,
};
use gearlash::analysis::study::Material;
use gearlash::analysis::verdict::{RequirementOutcome, Unmet, Verdict};
use gearlash::contact::{Contact, Doubt, Status};
use gearlash::gear::Side;
use gearlash::pair::{Member, arcmin};
use gearlash_text::characters::plain;
use gearlash_text::numbers::{fixed, stated_distance, um, um_within, unit_of};
use std::fmt;

/// The most columns of a line.
pub const MAX_COLUMNS: usize = 80;
/// The columns of lines that nothing limits.
const UNCUT: usize = usize::MAX;
/// The most lines.
pub const MAX_LINES: usize = 6;
/// Decimals of a backlash in µm.
const DECIMALS: usize = 2;

/// The verdict on a pair in lines.
#[derive(Debug, Clone, PartialEq)]
pub struct VerdictLines {
    /// Whether the pair passes.
    pub state: CheckVerdict,
    /// Whether and where the pair assembles.
    pub status: String,
    /// The certainty; empty where nothing is known.
    pub proof: String,
    /// The least and the greatest backlash; one line where they are equal.
    pub extremes: Vec<ExtremeLine>,
    /// Lines that qualify them.
    pub qualifiers: Vec<String>,
    /// Sentences that are cut, or for which there is no room.
    pub left_out: Vec<String>,
    /// The most columns of a line.
    most: usize,
}

/// An extreme of the backlash.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ExtremeLine {
    /// `least`, `greatest` or `constant`.
    pub name: &'static str,
    /// The backlash, such as `12.25 µm` or `12.3 ± 1.2 µm`; `jammed` or `out of mesh` where there is none.
    pub value: String,
    /// Its lost motion in minutes of arc at a gear, where that is limited or requested.
    pub arcmin: Option<(String, Member)>,
    /// The teeth in contact, such as `33·33 / 34·33`; `None` where no teeth are worse than others.
    pub teeth: Option<String>,
    /// The curves in contact; drawn gears only.
    pub curves: Option<String>,
    /// The points in mesh, `high` or `low`, of runouts that are undirected in the file.
    pub direction: Option<&'static str>,
    /// The centre distance, mm, where there are several.
    pub distance: Option<String>,
    /// The material, where there are two.
    pub material: Option<Material>,
    /// The assembly phase, where the teeth do not determine it.
    pub phase: Option<(u32, u32)>,
}

impl ExtremeLine {
    /// The place: teeth, direction, centre distance and material; shorter with more `brevity`, 0 … 3.
    fn place(&self, brevity: usize) -> [String; 2] {
        let teeth = match (&self.teeth, brevity) {
            (None, _) if self.name == CONSTANT => "every pose".to_owned(),
            (None, _) => "any teeth".to_owned(),
            (Some(teeth), 0..3) => format!("teeth {teeth}"),
            (Some(teeth), _) => teeth.clone(),
        };
        let phase = self.phase.filter(|_| brevity < 3);
        let rest = [
            self.curves.clone().filter(|_| brevity == 0),
            self.direction.and_then(|points| match brevity {
                0 => Some(format!("{points} points in mesh")),
                1 => Some(format!("{points} points")),
                _ => None,
            }),
            self.distance.as_ref().map(|a| format!("a {a} mm")),
            self.material.map(|material| material.words().to_owned()),
            phase.map(|(wheel, pinion)| format!("phase {wheel}·{pinion}")),
        ];
        let rest: Vec<String> = rest.into_iter().flatten().collect();
        [teeth, rest.join(", ")]
    }

    /// The place in words, including the teeth.
    pub fn place_words(&self) -> String {
        let place = self.place(0).join(", ");
        place.trim_end_matches(", ").to_owned()
    }

    fn cells(&self, brevity: usize) -> [String; 4] {
        let lost_motion = self.arcmin.as_ref().map(|(arcmin, member)| match brevity {
            0 => format!("{arcmin} arcmin at the {}", member.name()),
            _ => format!("{arcmin}′ {}", member.name()),
        });
        let [teeth, rest] = self.place(brevity);
        [
            self.value.clone(),
            lost_motion.unwrap_or_default(),
            teeth,
            rest,
        ]
    }
}

/// The name of the row where least and greatest are equal.
const CONSTANT: &str = "constant";

/// `extremes` on one line, without their places.
pub(crate) fn in_short(extremes: &[ExtremeLine]) -> String {
    let each = extremes.iter();
    let each = each.map(|row| format!("{} {}", row.name, row.value));
    each.collect::<Vec<String>>().join(", ")
}

impl VerdictLines {
    /// The first line.
    pub fn first(&self) -> String {
        let line = format!("{} {}", self.status, self.proof);
        cut(line.trim_end(), self.most)
    }

    /// The lines, without line ends.
    pub fn lines(&self) -> Vec<String> {
        let mut lines = vec![self.first()];
        lines.extend(aligned_lines(&self.extremes, self.most));
        lines.extend(self.qualifiers.iter().map(|line| format!("  {line}")));
        lines
    }
}

/// The title, and below it the verdict; its first line is coloured on a terminal.
pub(crate) fn heading(title: &str, lines: &VerdictLines, screen: &Screen) -> String {
    let tone = match lines.state {
        CheckVerdict::Pass => Tone::Good,
        CheckVerdict::Warn | CheckVerdict::Unproven => Tone::Doubtful,
        CheckVerdict::Fail => Tone::Bad,
    };
    let mut lines = lines.lines();
    lines[0] = screen.toned(tone, &lines[0]);
    format!("{}\n\n{}\n\n", plain(title), lines.join("\n"))
}

impl fmt::Display for VerdictLines {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.lines().join("\n"))
    }
}

fn columns(text: &str) -> usize {
    text.chars().count()
}

/// `text`, cut to `most` columns.
fn cut(text: &str, most: usize) -> String {
    if columns(text) <= most {
        return text.to_owned();
    }
    let kept: String = text.chars().take(most - 1).collect();
    format!("{}…", kept.trim_end())
}

/// The first of `candidates` that fits a line, else the last, cut.
fn first_fitting(candidates: &[String], most: usize) -> String {
    let mut each = candidates.iter();
    let fits = each.find(|candidate| columns(candidate) <= most);
    fits.or(candidates.last())
        .map_or_else(String::new, |text| cut(text, most))
}

/// The `extremes` in columns, in the longest wording that fits.
fn aligned_lines(extremes: &[ExtremeLine], most: usize) -> Vec<String> {
    let worded = |brevity: usize| -> Vec<String> {
        let cells: Vec<[String; 4]> = extremes.iter().map(|line| line.cells(brevity)).collect();
        let widths = [0, 1, 2, 3].map(|column| {
            let each = cells.iter().map(|row: &[String; 4]| columns(&row[column]));
            each.max().unwrap_or(0)
        });
        let gap = if brevity < 3 { "   " } else { "  " };
        let line = |(extreme, cells): (&ExtremeLine, &[String; 4])| {
            let width = widths[0];
            let mut line = format!("  {:<8}{gap}{:>width$}", extreme.name, cells[0]);
            let others = cells.iter().zip(widths).skip(1);
            for (cell, width) in others.filter(|(_, width)| *width > 0) {
                line += &format!("{gap}{cell:<width$}");
            }
            line.trim_end().to_owned()
        };
        extremes.iter().zip(&cells).map(line).collect()
    };
    let fits = |lines: &Vec<String>| lines.iter().all(|line| columns(line) <= most);
    let lines = (0..3).map(worded).find(fits).unwrap_or_else(|| worded(3));
    lines.iter().map(|line| cut(line, most)).collect()
}

/// `sentences` on at most `lines` lines; and those that are cut, or for which there is no room. The last line ends with the number of the
/// latter.
fn fit_sentences(sentences: Vec<String>, lines: usize) -> (Vec<String>, Vec<String>) {
    let most = MAX_COLUMNS - 2;
    let mut filled: Vec<String> = Vec::new();
    let is_cut = |sentence: &&String| columns(sentence) > most;
    for (index, sentence) in sentences.iter().enumerate() {
        let sentence = cut(sentence, most);
        if let Some(last) = filled.last_mut()
            && columns(last) + 2 + columns(&sentence) <= most
        {
            *last += ". ";
            *last += &sentence;
        } else if filled.len() < lines {
            filled.push(sentence);
        } else if let Some(last) = filled.last_mut() {
            let (shown, rest) = sentences.split_at(index);
            let more = match rest.len() {
                1 => "; 1 more note".to_owned(),
                more => format!("; {more} more notes"),
            };
            // Cut between two parts of the sentence where it has parts.
            let room = most - columns(&more);
            let mut ends = last.rmatch_indices(", ").map(|(end, _)| &last[..end]);
            let whole = ends.find(|whole| columns(whole) <= room);
            let whole = whole.filter(|_| columns(last) > room);
            *last = whole.map_or_else(|| cut(last, room), str::to_owned) + &more;
            let left_out = shown.iter().filter(is_cut).chain(rest);
            return (filled, left_out.cloned().collect());
        }
    }
    let left_out = sentences.iter().filter(is_cut);
    (filled, left_out.cloned().collect())
}

/// The verdict in at most six lines of at most 80 columns.
pub fn lines(verdict: &Verdict) -> VerdictLines {
    lines_of(verdict, MAX_COLUMNS)
}

/// The verdict with every sentence in full.
pub fn uncut(verdict: &Verdict) -> VerdictLines {
    lines_of(verdict, UNCUT)
}

fn lines_of(verdict: &Verdict, most: usize) -> VerdictLines {
    let mut lines = VerdictLines {
        state: CheckVerdict::Unproven,
        status: "Nothing was run.".to_owned(),
        proof: String::new(),
        extremes: Vec::new(),
        qualifiers: Vec::new(),
        left_out: Vec::new(),
        most,
    };
    if verdict.runs.is_empty() {
        return lines;
    }
    lines.state = if verdict.failed_checks.is_empty() {
        verdict.state()
    } else {
        CheckVerdict::Fail
    };
    let places: Vec<Place> = verdict.runs.iter().map(Place::of).collect();
    // The longest status with the longest proof that fits a line, else the shortest of both.
    let proofs = proof(verdict);
    let first_lines = status(&places).into_iter().flat_map(|status| {
        let proofs = proofs.iter();
        proofs.map(move |proof| (status.clone(), proof.clone()))
    });
    for (status, proof) in first_lines {
        let fits = columns(&status) + columns(&proof) < most;
        (lines.status, lines.proof) = (status, proof);
        if fits {
            break;
        }
    }
    lines.extremes = rows(verdict);
    let sentences = sentences(verdict, most);
    (lines.qualifiers, lines.left_out) = match most {
        UNCUT => (sentences, Vec::new()),
        _ => fit_sentences(sentences, MAX_LINES - 1 - lines.extremes.len()),
    };
    lines
}

/// The certainty of the extremes, in full and shorter; empty where a distance derived from them is not proven.
fn proof(verdict: &Verdict) -> Vec<String> {
    let open = |of: fn(&RunExtremes) -> &Option<RunExtreme>| {
        let mut each = verdict.runs.iter().filter_map(|run| of(run).as_ref());
        each.any(|extreme| extreme_doubt(extreme).is_some())
    };
    let alone = match [open(|run| &run.least), open(|run| &run.greatest)] {
        [true, false] => Some("Least not proven."),
        [false, true] => Some("Greatest not proven."),
        [true, true] => Some("Least and greatest not proven."),
        [false, false] if distances(verdict).iter().any(|(_, is_proven)| !is_proven) => Some(""),
        [false, false] => None,
    };
    if let Some(alone) = alone {
        return vec![alone.to_owned()];
    }
    let matings = verdict.matings();
    let covered = distinct(verdict.runs.iter().filter_map(|run| run.own_phase));
    let phases = CoveredPhases::of(verdict.runs);
    let are_all = phases == CoveredPhases::All;
    let over = if !are_all {
        format!("{matings} matings of {} alone", cycle_words(&phases))
    } else if covered.is_empty() {
        format!("{matings} matings")
    } else {
        format!("{matings} matings × {} phases", covered.len())
    };
    let rotation = if verdict.runs.iter().any(RunExtremes::any_direction) {
        "every rotation and runout direction"
    } else {
        "every rotation"
    };
    // A line that is too short for all of it still names the phases where others are not covered.
    let shorter = if are_all {
        "Proven for every rotation.".to_owned()
    } else {
        format!("Proven for {over}.")
    };
    vec![
        format!("Proven for {over}, {rotation}."),
        format!("Proven for {over}, every rotation."),
        shorter,
        "Proven.".to_owned(),
    ]
}

/// The uncertainty of an extreme due to the drawings, mm; `None` for gears by their data, and where it is only rounding.
fn drawing_bound(extreme: &RunExtreme) -> Option<f64> {
    let bound = extreme.pose.simulated.error_bound?;
    (extreme.assembly.outline_bound() > 0.0 && bound >= 5e-6).then_some(bound)
}

/// The least distance that assembles and the greatest in mesh, if the pair fails to assemble or to mesh somewhere; each with
/// whether it is proven.
fn distances(verdict: &Verdict) -> Vec<(String, bool)> {
    let is_apart = |run: &RunExtremes| run.status == Status::NoContact;
    let is_tight = |run: &RunExtremes| run.assembles() == Some(false) && !is_apart(run);
    let found = |words: &str, distance: f64, doubt: Option<Doubt>| {
        let unless_proven = if doubt.is_some() { " (not proven)" } else { "" };
        let text = format!("{words} a = {} mm{unless_proven}", fixed(distance, 4));
        (text, doubt.is_none())
    };
    let mut distances = Vec::new();
    if verdict.runs.iter().any(is_tight) {
        distances.push(match verdict.assembles_from() {
            Some(from) => found("Assembles from", rounded_up(from.high), from.doubt),
            None => ("Assembles at no centre distance in mesh".to_owned(), true),
        });
    }
    if verdict.runs.iter().any(is_apart) {
        distances.push(match verdict.meshes_to() {
            Some(to) => found("In mesh up to", rounded_down(to.low), to.doubt),
            None => ("In mesh at no centre distance".to_owned(), true),
        });
    }
    distances
}

/// A distance, mm, rounded up to a ten thousandth: at a lower printed one the pair would interfere.
pub fn rounded_up(distance: f64) -> f64 {
    (distance * 1e4).ceil() / 1e4
}

/// A distance, mm, rounded down to a ten thousandth: at a higher printed one tips would pass each other.
pub fn rounded_down(distance: f64) -> f64 {
    (distance * 1e4).floor() / 1e4
}

/// Whether all poses of a run have equal backlash.
fn is_constant(run: &RunExtremes) -> bool {
    let both = run.least.as_ref().zip(run.greatest.as_ref());
    both.is_some_and(|(least, greatest)| greatest.found() - least.found() <= WIDTH)
}

fn rows(verdict: &Verdict) -> Vec<ExtremeLine> {
    let least = verdict.least();
    if let [only] = verdict.runs
        && let Some((run, extreme)) = least
        && is_constant(only)
    {
        return vec![row(verdict, run, Ok(extreme), CONSTANT)];
    }
    // A run without backlash is worse than each with one.
    let worst = |status, words, found: Option<(_, _)>, name| {
        let without = verdict.runs.iter().find(|run| run.status == status);
        let found = found.map(|(run, extreme)| (run, Ok(extreme)));
        without
            .map(|run| (run, Err(words)))
            .or(found)
            .map(|(run, value)| row(verdict, run, value, name))
    };
    let greatest = verdict.greatest();
    let is_any = greatest.is_some();
    let least = worst(Status::Jammed, "jammed", least, "least");
    let greatest = worst(Status::NoContact, "out of mesh", greatest, "greatest");
    // The status alone says that a pair jams everywhere, or is out of mesh.
    if is_any || least.is_some() && greatest.is_some() {
        least.into_iter().chain(greatest).collect()
    } else {
        Vec::new()
    }
}

/// The row of an extreme of `run`, or of the words that say why it has none.
fn row(
    verdict: &Verdict,
    run: &RunExtremes,
    extreme: Result<&RunExtreme, &str>,
    name: &'static str,
) -> ExtremeLine {
    let several = |differs: &dyn Fn(&RunExtremes) -> bool| verdict.runs.iter().any(differs);
    let distance = run.assembly.center_distance();
    let is_alike = is_constant(run) || run.has_like_teeth();
    let teeth = match extreme {
        Ok(extreme) => teeth(&extreme.pose),
        Err(_) => jam(run),
    };
    let teeth = teeth.filter(|_| !is_alike);
    let found = extreme.ok();
    ExtremeLine {
        name,
        value: extreme.map_or_else(str::to_owned, |extreme| {
            let off = verdict.expanded(extreme).or(drawing_bound(extreme));
            value(extreme.found(), off)
        }),
        arcmin: found.zip(verdict.lost_motion_of).map(|(extreme, member)| {
            let angle = run.assembly.angle(member, extreme.found());
            (lost_motion(angle), member)
        }),
        curves: found.and_then(touched),
        direction: (found.is_some() && run.any_direction()).then_some(match name {
            "greatest" => "low",
            _ => "high",
        }),
        distance: several(&|other| other.assembly.center_distance() != distance)
            .then(|| stated_distance(distance)),
        material: several(&|other| other.material != run.material).then_some(run.material),
        phase: run.phase.filter(|_| teeth.is_none()),
        teeth,
    }
}

/// The places of contact: `tip on flank`, the wheel's first, for right and left flanks. `None` where checks name the contacts.
fn touched(extreme: &RunExtreme) -> Option<String> {
    let result = &extreme.pose.simulated;
    let found = result.proven()?;
    let places = |side| {
        let contact = found.on(side)?;
        ContactRow::new(&extreme.assembly, side, &result.pose, &contact).unchecked_places()
    };
    let (right, left) = (places(Side::Right)?, places(Side::Left)?);
    Some(distinct([right, left].into_iter()).join(" / "))
}

/// A backlash in µm, with its uncertainty or error bound to two digits.
fn value(j_wt: f64, off: Option<f64>) -> String {
    let off = off.filter(|off| *off > 0.0);
    let number = off.map_or_else(|| um(j_wt, DECIMALS), |off| um_within(j_wt, off));
    format!("{number} µm")
}

/// A lost motion, rad, in minutes of arc.
fn lost_motion(angle: f64) -> String {
    fixed(arcmin(angle), 3)
}

/// `10·4 / 11·4`: the teeth in contact at right and at left flanks.
fn teeth(pose: &ComparedPose) -> Option<String> {
    let found = pose.simulated.proven()?;
    let teeth = |contact: &Contact| format!("{}·{}", contact.wheel.tooth, contact.pinion.tooth);
    let (right, left) = (found.right.as_ref()?, found.left.as_ref()?);
    Some(format!("{} / {}", teeth(right), teeth(left)))
}

/// The lines of `verdict` as the message of a failure. The limits that a pair misses which assembles come before them.
pub(crate) fn message(verdict: &Verdict) -> String {
    let mut others = verdict.clone();
    let mut text = String::new();
    if verdict.assembles() == Some(true) {
        for unmet in std::mem::take(&mut others.unmet) {
            text += &(limit(&unmet, UNCUT) + "\n");
        }
    }
    text + &lines(&others).to_string()
}

/// The sentences that qualify the extremes, the most important first.
fn sentences(verdict: &Verdict, most: usize) -> Vec<String> {
    let mut sentences: Vec<String> = Vec::new();
    sentences.extend(distances(verdict).into_iter().map(|(text, _)| text));
    sentences.extend(verdict.unmet.iter().map(|unmet| limit(unmet, most)));
    sentences.extend(checks(verdict, most));
    sentences.extend(doubt_sentences(verdict, most));
    sentences.extend(bearings(verdict));
    let runs = verdict.runs.iter();
    let mut extremes = runs.flat_map(|run| run.least.iter().chain(&run.greatest));
    if extremes.any(|extreme| drawing_bound(extreme).is_some()) {
        sentences.push("± is what the drawings leave open".to_owned());
    }
    if let Some(stated) = verdict.uncertainty {
        let k = stated.coverage;
        sentences.push(format!("± is the expanded uncertainty, k = {k}"));
    }
    if verdict.requirement == RequirementOutcome::Met {
        let is_within = verdict.is_kept_within_uncertainty;
        let rest = if is_within { "" } else { ", but not within ±" };
        sentences.push(format!("Requirement met{rest}"));
    }
    sentences
}

/// The teeth that jam, such as `7·8`; `None` where all do.
fn jam(run: &RunExtremes) -> Option<String> {
    run.greatest.as_ref()?;
    let mating = run.lost.as_ref()?.pose.simulated.pose.mating();
    Some(format!("{}·{}", mating.wheel_tooth, mating.pinion_tooth))
}

/// A violated limit, and the value that violates it.
fn limit(unmet: &Unmet, most: usize) -> String {
    let (name, unit, per, decimals) = unit_of(unmet.quantity);
    let sign = if unmet.is_max { '≤' } else { '≥' };
    let limit = fixed(unmet.limit * per, decimals);
    let shown = |value: f64| {
        if value.is_finite() {
            fixed(value * per, decimals)
        } else {
            "∞".to_owned()
        }
    };
    let found = match unmet.found {
        None => "no value".to_owned(),
        // The end of the bracket that violates it least.
        Some([low, high]) if unmet.is_missed => shown(if unmet.is_max { low } else { high }),
        Some(bracket) => bracket_words(bracket.map(shown)),
    };
    let whether = if unmet.is_missed { "met" } else { "proven" };
    let text = format!("Requirement not {whether}: {name} {sign} {limit} {unit}, found {found}");
    if unmet.with_clearance {
        first_fitting(&[format!("{text} with bearing clearance"), text], most - 2)
    } else {
        text
    }
}

/// `low … high`, or one value where both print equal texts.
fn bracket_words(ends: [String; 2]) -> String {
    distinct(ends.into_iter()).join(" … ")
}

/// Ids of the checks that fail whenever the pair does not assemble.
const OF_ASSEMBLY: [&str; 2] = ["zero_backlash_distance", "backlash_condition"];

/// The number of failing checks, with as many titles as fit a line; `None` where the first line implies all of them.
fn checks(verdict: &Verdict, most: usize) -> Option<String> {
    let is_implied = |id: &str| verdict.assembles() == Some(false) && OF_ASSEMBLY.contains(&id);
    let failed = verdict.failed_checks.iter();
    let (implied, others): (Vec<&CheckName>, Vec<&CheckName>) =
        failed.partition(|check| is_implied(check.id));
    if others.is_empty() {
        return None;
    }
    let each = others.into_iter().chain(implied);
    let titles: Vec<&str> = each.map(|check| short_title(check.title)).collect();
    let count = match titles.len() {
        1 => "1 check fails".to_owned(),
        several => format!("{several} checks fail"),
    };
    let with = |named: usize| {
        let more = match titles.len() - named {
            0 => String::new(),
            more => format!(", and {more} more, see checks"),
        };
        format!("{count}: {}{more}", titles[..named].join(", "))
    };
    let candidates: Vec<String> = (1..=titles.len()).rev().map(with).collect();
    Some(first_fitting(&candidates, most - 2))
}

/// A check's title up to its first comma, semicolon or bracket.
pub fn short_title(title: &str) -> &str {
    let end = title.find([',', ';', '(']).unwrap_or(title.len());
    title[..end].trim_end()
}

/// The reasons why extremes are not proven, and their brackets; equal reasons share a sentence.
fn doubt_sentences(verdict: &Verdict, most: usize) -> Vec<String> {
    let mut about: Vec<(Vec<[String; 2]>, String)> = Vec::new();
    for (name, is_least) in [("least", true), ("greatest", false)] {
        let ends = verdict.runs.iter().map(|run| [&run.greatest, &run.least]);
        let extremes: Vec<&RunExtreme> = ends
            .filter_map(|ends| ends[usize::from(is_least)].as_ref())
            .collect();
        let reasons =
            distinct(extremes.iter().filter_map(|extreme| extreme_doubt(extreme))).join(", ");
        if reasons.is_empty() {
            continue;
        }
        // The verdict names a run that is jammed or out of mesh.
        let elsewhere = if extremes.len() < verdict.runs.len() {
            " elsewhere"
        } else {
            ""
        };
        let name = format!("{name}{elsewhere}");
        let names = match bracket(is_least, &extremes) {
            Some(words) => [format!("{name} ({words})"), format!("{name} {words}")],
            None => [name.clone(), name],
        };
        match about.iter_mut().find(|(_, known)| *known == reasons) {
            Some((known, _)) => known.push(names),
            None => about.push((vec![names], reasons)),
        }
    }
    let sentence = |(names, reasons): &(Vec<[String; 2]>, String)| {
        let [in_full, short] =
            [(0, " and ", " not proven"), (1, ", ", "")].map(|(form, and, end)| {
                let names: Vec<&str> = names.iter().map(|names| names[form].as_str()).collect();
                let names = names.join(and);
                let (first, rest) = names.split_at(1);
                format!("{}{rest}{end}: {reasons}", first.to_uppercase())
            });
        if columns(&in_full) <= most - 2 {
            in_full
        } else {
            short
        }
    };
    about.iter().map(sentence).collect()
}

/// The bracket of an extreme, where it is wide.
fn bracket(is_least: bool, extremes: &[&RunExtreme]) -> Option<String> {
    let of_all = |end: fn(&RunExtreme) -> f64| {
        let ends = extremes.iter().map(|extreme| end(extreme));
        ends.reduce(if is_least { f64::min } else { f64::max })
    };
    let [low, high] = [of_all(|of| of.low)?, of_all(|of| of.high)?];
    let holds = extremes.iter().all(|extreme| extreme.holds());
    let words = bracket_words([low, high].map(|end| um(end, DECIMALS)));
    (holds && high - low > WIDTH).then(|| format!("{words} µm"))
}

/// The reason why an extreme is not proven; `None` where it is.
pub fn extreme_doubt(extreme: &RunExtreme) -> Option<String> {
    match &extreme.pose.simulated.found {
        Err(unproven) => Some(plain(&unproven.reason)),
        Ok(_) if extreme.is_proven() => None,
        Ok(_) => extreme.doubt.map(|doubt| doubt_words(doubt).to_owned()),
    }
}

/// A reason for doubt in words.
pub(crate) fn doubt_words(doubt: Doubt) -> &'static str {
    match doubt {
        Doubt::OffInvolute => "bounded by poses alone, as fillets or roots may touch",
        Doubt::Effort => "search budget used up",
        Doubt::Unbounded => "no bound for parts of the cycle",
        Doubt::SecondOrder => "runout of unknown direction bounded widely",
        Doubt::Profile => "deviations bounded for each flank as a whole",
        Doubt::ContactLost => "contact lost at a pose",
        Doubt::Drawing => "the drawings leave more open",
        Doubt::Sections => "bounds over the face leave more open",
        Doubt::Axes => "axes bounded together",
    }
}

/// Least and greatest with the axes pressed together and pulled apart in their bearings, and the reasons why they are not proven.
fn bearings(verdict: &Verdict) -> Vec<String> {
    let with_bearings = || verdict.runs.iter().filter_map(|run| run.bearings.as_ref());
    let Some(first) = with_bearings().next() else {
        return Vec::new();
    };
    let clearance = stated_distance(first.clearance);
    let unit = verdict.lost_motion_of.map_or("µm".to_owned(), |member| {
        format!("arcmin at the {}", member.name())
    });
    let shown = |found: Option<(_, &RunExtreme)>| match (found, verdict.lost_motion_of) {
        (Some((_, extreme)), Some(member)) => {
            lost_motion(extreme.assembly.angle(member, extreme.found()))
        }
        (found, _) => um(found.map(|(_, extreme)| extreme.found()), DECIMALS),
    };
    let jammed = |play: &BearingExtremes| play.pressed.status == Status::Jammed;
    let least = match verdict.least_pressed() {
        _ if with_bearings().any(jammed) => "jammed".to_owned(),
        least => shown(least),
    };
    let apart = |play: &BearingExtremes| play.pulled_apart.status == Status::NoContact;
    let greatest = match verdict.greatest_apart() {
        _ if with_bearings().any(apart) => "out of mesh".to_owned(),
        greatest => format!("{} {unit}", shown(greatest)),
    };
    let ends = with_bearings().flat_map(|play| [&play.pressed.extreme, &play.pulled_apart.extreme]);
    let reasons = distinct(ends.filter_map(|end| extreme_doubt(end.as_ref()?))).join(", ");
    let range = format!("a ± {clearance} mm (bearing clearance): {least} … {greatest}");
    if reasons.is_empty() {
        return vec![range];
    }
    vec![
        format!("{range}, not proven"),
        format!("With bearing clearance: {reasons}"),
    ]
}

/// Least and greatest of the cycle in one line, for a picture of fewer poses; empty without them.
pub fn extremes_in_short(verdict: &Verdict) -> String {
    match &in_short(&rows(verdict))[..] {
        "" => String::new(),
        extremes => format!(
            "{} ({} matings): {extremes}",
            cycle_words(&CoveredPhases::of(verdict.runs)),
            verdict.matings()
        ),
    }
}

/// The cycle over these phases: "whole mesh cycle", "phase 1·1" or "2 phases".
pub fn cycle_words(phases: &CoveredPhases) -> String {
    match phases {
        CoveredPhases::All => "whole mesh cycle".to_owned(),
        CoveredPhases::Some(phases) => match phases[..] {
            [(wheel, pinion)] => format!("phase {wheel}·{pinion}"),
            _ => format!("{} phases", phases.len()),
        },
    }
}
