//! Remedies, the single changes that make a pair fit: as JSON and in words.

use gearlash::analysis::remedies::{Change, Gears, NoRemedy, Remedies, Remedy};
use gearlash::analysis::verdict::{RequirementOutcome, Verdict};
use gearlash::gear::thickness;
use gearlash::metrology::chord_height;
use gearlash::pair::Member;
use gearlash_input::PairFile;
use gearlash_input::spec::{BandSpec, Either, EitherGearSpec};
use gearlash_text::numbers::{ascii, fixed, rounded, unit_of};
use serde::Serialize;

/// A remedy in the keys and units of a pair file.
#[derive(Debug, Clone, Serialize)]
pub struct RemedyRecord {
    what: &'static str,
    gear: &'static str,
    value: f64,
    bracket: [f64; 2],
    #[serde(skip)]
    sentence: String,
}

impl RemedyRecord {
    fn new(file: &PairFile, remedy: &Remedy) -> RemedyRecord {
        let (what, name, unit, scale, decimals) = match remedy.what {
            Change::CenterDistance => ("center_distance_mm", "centre distance", "mm", 1.0, 3),
            Change::FlankOffset => ("flank_offset_mm", "flank offset", "mm", 1.0, 3),
            Change::ThicknessAllowance => {
                let name = "thickness allowance";
                ("thickness_allowance_um", name, "µm", 1e3, 0)
            }
        };
        // A file states the nominal distance of a band. The middle one of the study can be an end of the band.
        let assembly = &file.spec.assembly;
        let stated = assembly.center_distance_mm.nominal_mm();
        let stated = stated.filter(|_| {
            remedy.what == Change::CenterDistance && assembly.distance_place_mm() == 0.0
        });
        let listed = &file.study.center_distances;
        let shift = match (stated, file.study.distance_band) {
            (Some(nominal), Some(_)) => nominal - listed[listed.len() / 2],
            _ => 0.0,
        };
        let value = rounded((remedy.value + shift) * scale, decimals);
        let present = match stated {
            Some(nominal) => [nominal; 2],
            None => remedy.present.map(|at| at * scale),
        };
        // A change below the last digit is shown by one digit more of what is there.
        let is_fine = |present: &f64| ascii(*present, decimals) == ascii(value, decimals);
        let digits = decimals + usize::from(present.iter().any(is_fine));
        let [first, last] = present.map(|present| ascii(present, digits));
        let (of, present) = match (remedy.what, remedy.gears) {
            (Change::CenterDistance, _) => {
                (String::new(), format!("each of the list {first} … {last}"))
            }
            (_, Gears::Both) => {
                let both = format!("{first} (wheel) and {last} (pinion)");
                (" of both gears".to_owned(), both)
            }
            (_, Gears::One(member)) => {
                let own = [&first, &last][member as usize].clone();
                (format!(" of the {}", member.name()), own)
            }
        };
        let present = if first == last { first } else { present };
        RemedyRecord {
            what,
            gear: remedy.gears.name(),
            value,
            bracket: remedy.bracket.map(|at| (at + shift) * scale),
            sentence: format!(
                "{name}{of}: {} {unit} instead of {present}{}",
                ascii(value, decimals),
                statements(file, remedy)
            ),
        }
    }
}

/// The changed statements of thickness, each on a line; empty where the remedy's own value is the statement.
fn statements(file: &PairFile, remedy: &Remedy) -> String {
    let gears = [&file.spec.wheel, &file.spec.pinion];
    let changed = Member::BOTH.into_iter();
    let changed = changed.filter(|member| remedy.gears.has(*member));
    let lines = changed.filter_map(|member| {
        let change = remedy.value - remedy.present[member as usize];
        let spec = gears[member as usize];
        let stated = match remedy.what {
            Change::CenterDistance => None,
            Change::FlankOffset => offset_band(spec, change),
            Change::ThicknessAllowance => statement(file, member, change),
        };
        Some(format!("\n    {}: {}", member.name(), stated?))
    });
    lines.collect()
}

/// The stated band of flank offsets, moved by `change` mm; `None` for one offset.
fn offset_band(spec: &EitherGearSpec, change: f64) -> Option<String> {
    let stated = match spec {
        EitherGearSpec::Data(spec) => spec.thickness.statement.flank_offset_mm.as_ref()?,
        EitherGearSpec::Outline(spec) => spec.thickness.as_ref()?.flank_offset_mm.as_ref()?,
    };
    let Either::Other(BandSpec { min, max }) = stated else {
        return None;
    };
    let [min, max] = [min, max].map(|mm| ascii(mm + change, 3));
    Some(format!("flank_offset_mm = {{ min = {min}, max = {max} }}"))
}

/// The stated thickness of a gear by its data, whose allowance changes by `change` mm; `None` for one allowance.
fn statement(file: &PairFile, member: Member, change: f64) -> Option<String> {
    let spec = file.spec.data(member)?;
    let (scale, stated) = (spec.scale(), &spec.thickness.statement);
    let gears = file.study.materials.iter();
    let mut gears = gears.map(|(_, wheel, pinion)| [wheel, pinion][member as usize].gear());
    let most = gears.next()?;
    let least = gears.next_back().unwrap_or(most);
    let data = most.basic_data();
    let per_arc = thickness::per_normal_thickness(data);
    // `length` gives the stated length at a base thickness, mm.
    let by = |name: &str, length: &dyn Fn(f64) -> f64| {
        let base = most.base_thickness();
        let changed = base + change * scale * per_arc;
        let by = (length(changed) - length(base)) / scale;
        let word = if by < 0.0 { "smaller" } else { "larger" };
        Some(format!("{name} {} mm {word}", ascii(by.abs(), 4)))
    };
    let span = |teeth: u32| move |base: f64| thickness::span_from_base(data, teeth, base);
    if let Some(of) = &stated.span {
        return by(&format!("span W_{}", of.teeth), &span(of.teeth));
    }
    if let Some(pins) = &stated.over_pins {
        let (body, pin) = (pins.kind.unwrap_or_default(), pins.pin_mm * scale);
        return by("dimension over pins", &|base| {
            thickness::over_from_base(data, body, pin, base)
        });
    }
    if let Some(chord) = &stated.chordal_thickness {
        let height = chord.height_mm.map(|mm| mm * scale);
        let height = chord_height(most.design(), height);
        return by("chordal thickness", &|base| {
            thickness::chord_from_base(data, most.tip_radius(), height, base)
        });
    }
    if stated.base_thickness_mm.is_some() {
        return by("base thickness", &span(1));
    }
    if stated.arc_thickness_mm.is_some() {
        return by("arc thickness", &|base| base / per_arc);
    }
    let is_band = most.base_thickness() != least.base_thickness();
    let [min, max] =
        [least, most].map(|gear| rounded((thickness::allowance(gear) / scale + change) * 1e3, 1));
    is_band.then(|| format!("allowance_um = {{ min = {min}, max = {max} }}"))
}

/// The remedies of a pair file.
#[derive(Debug, Clone, Default)]
pub struct RemedyRecords {
    /// Each single change that makes the pair fit.
    pub changes: Vec<RemedyRecord>,
    /// The reasons for missing changes, one sentence each.
    pub missing: Vec<String>,
}

impl RemedyRecords {
    /// The records of `remedies`, found for the study of `file`; none for a file with a temperature, which states its lengths at
    /// 20 °C.
    pub fn new(file: &PairFile, remedies: &Remedies) -> RemedyRecords {
        let Remedies { changes, missing } = remedies;
        let is_any = !(changes.is_empty() && missing.is_empty());
        if is_any && file.spec.assembly.temperature_c.is_some() {
            return RemedyRecords {
                changes: Vec::new(),
                missing: vec![
                    "No single change is given at another temperature than 20 °C, at which a file states its lengths.".to_owned(),
                ],
            };
        }
        RemedyRecords {
            changes: changes
                .iter()
                .map(|remedy| RemedyRecord::new(file, remedy))
                .collect(),
            missing: missing.iter().map(|reason| sentence(*reason)).collect(),
        }
    }

    /// The remedies below a table of checks; empty for a pair that fits.
    pub fn text(&self, verdict: &Verdict) -> String {
        let what = match (verdict.assembles(), verdict.requirement) {
            (Some(true), _) => "meet [require]",
            (_, RequirementOutcome::None) => "assemble",
            (_, _) => "assemble and meet [require]",
        };
        let mut text = String::new();
        if !self.changes.is_empty() {
            text += &format!(
                "\nEach of these changes alone makes the pair {what}; other checks may still fail:\n"
            );
            for change in &self.changes {
                text += &format!("  {}\n", change.sentence);
            }
        } else if !self.missing.is_empty() {
            text.push('\n');
        }
        for reason in &self.missing {
            text += &format!("{reason}\n");
        }
        text
    }
}

/// The reason why a change is missing, as a sentence.
fn sentence(reason: NoRemedy) -> String {
    let words = match reason {
        NoRemedy::Spread {
            quantity,
            distance,
            found,
            limits,
        } => {
            let (name, unit, per, decimals) = unit_of(quantity);
            let [found, limits] = [found, limits].map(|[least, greatest]| {
                let shown =
                    [greatest - least, least, greatest].map(|value| fixed(value * per, decimals));
                format!("{} {unit} ({} … {})", shown[0], shown[1], shown[2])
            });
            let at = distance.map_or(String::new(), |mm| format!(" at a = {} mm", fixed(mm, 3)));
            return format!(
                "No single change is enough: {name}{at} spreads over {found}, its limits over {limits}."
            );
        }
        NoRemedy::TooLittleAndTooGreat => {
            "No single change is enough: some limits ask for more backlash, others for less."
        }
        NoRemedy::OutOfMesh => "No single change is sought for gears that are out of mesh.",
        NoRemedy::MeasuredRows => {
            "The centre distance is not changed: measured rows state their own."
        }
        NoRemedy::Drawn => {
            "The thickness is not changed: one gear is drawn and the other given by its data."
        }
        NoRemedy::NoDistance => "No centre distance was found that is enough.",
        NoRemedy::NoThickness(gears) => {
            let of = match gears {
                Gears::Both => "both gears".to_owned(),
                Gears::One(member) => format!("the {} alone", member.name()),
            };
            return format!("No thickness of {of} was found that is enough.");
        }
        NoRemedy::Opposed => {
            "A common thickness of both gears is left out: it would change one of them the wrong way."
        }
        NoRemedy::NotEnough => "No single change is enough.",
    };
    words.to_owned()
}
