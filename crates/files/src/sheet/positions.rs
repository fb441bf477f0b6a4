//! Tooth thickness from the probe's positions at every flank, `Teilung:` of a curve file `.mka`.
//!
//! A point of an involute at radius `r` stands `inv α_r` behind its foot on the base circle, so that two points of a tooth, an
//! angle `Δ` apart, give `s_b = r_b (Δ + inv α_R + inv α_L)`. The centre of a ball that touches the flank lies on the involute that
//! stands out by half its diameter: of centres, `s_b + d` comes instead.
//!
//! At a helical flank the ball touches off the section its centre lies in, and its centres lie on the involute that stands out by `d/(2 cos β_b)`
//! (see `gearlash::gear::thickness`): of centres, `s_bt + d/cos β_b` comes. A point at the height `Z` is turned back to the plane `Z = 0` by
//! the helix: seen from where `Z` grows towards, right-hand teeth wind counter-clockwise with it, on whichever face the gear lies, since `X`, `Y`, `Z` are
//! right-handed. So both flanks' contacts with a ball whose centre keeps its height, `d sin β_b` apart, give the same tooth as its centres do.
//!
//! `Δ` has a sign. Seen on the reference face teeth are numbered clockwise and the right flank is the right-hand one of a tooth that
//! points up, its clockwise side: in the direction of the numbers, R of a tooth lies ahead of its L, however the gear is turned or
//! looked at. Where R lies behind L, the two are the flanks of a space, R of one tooth and L of the next, or their names are exchanged.
//!
//! Whether the file holds centres or contacts, and whether its `PHI` turns the gear, the probe, or says nothing new, is not documented: that reading
//! counts under which every pitch and every tooth fits the gear. A file that could as well hold spaces under another reading is refused.

use super::header::Header;
use super::p40::{self, P40};
use super::text;
use crate::data_file::DataFile;
use crate::problems::Problems;
use crate::table::Table;
use gearlash::gear::{BasicGearData, Flank};
use std::f64::consts::{PI, TAU};

/// What a pitch may be off, in pitches. Tuned: ten times the worst gear, a fifth of what another reading is off.
const PITCH: f64 = 0.1;
/// What a tooth may be thinner than nominal, in modules. Tuned: the thinnest field of DIN 3967 on a small gear is 0.3 off.
const THINNER: f64 = 0.35;
/// What it may be thicker, in modules. No field of DIN 3967 is above nominal. Tuned: that much is an eccentricity of 0.14 modules, and
/// the space of a standard gear is more than 0.1 modules wider than its tooth from 0.07 modules outside the reference circle on.
const THICKER: f64 = 0.1;
/// Both in probe diameters, so that of centre and contact only one can fit.
const OF_PROBE: f64 = 0.25;

/// The thickness of each tooth.
#[derive(Debug)]
pub struct Positions {
    /// Base tooth thickness of the mean, mm, as a span over it reads: of helical teeth in the normal of the helix, `s_bt cos β_b`.
    pub base_thickness_mm: f64,
    /// What each tooth has more, µm at the reference circle.
    pub per_tooth_um: Vec<f64>,
    /// What the file says of the gear.
    pub header: Header,
}

/// What the positions are held against.
#[derive(Debug, Clone, Copy)]
pub struct Nominal<'a> {
    pub basic_data: &'a BasicGearData,
    /// Nominal base tooth thickness, mm.
    pub base_thickness_mm: f64,
    /// Whether what of the thickness comes back once a turn stays in it; else it is left out, as runout.
    pub once: bool,
}

/// The positions of a tooth, right flank first: `PHI`, degrees, and `X`, `Y`, `Z`, mm.
pub type Flanks = [[f64; 4]; 2];

/// A way to read the positions under which they fit the gear.
struct Reading {
    /// `s_b` of each tooth, mm, in the transverse section.
    thick: Vec<f64>,
    /// Whether each pair is of a tooth, and not of a space.
    of_teeth: bool,
    /// Of which point of the probe, in words.
    of: String,
    /// What `PHI` says, in words.
    phi: &'static str,
}

impl Positions {
    /// Reads the file that `table` names.
    pub fn read(table: &Table, nominal: &Nominal, problems: &mut Problems) -> Option<Positions> {
        let needed = "the name of a curve file, such as \"gear.mka\"";
        let file = DataFile::of(table, needed, problems)?;
        problems.of_list_at(file.key(), |bad| {
            let bytes = bad.keep(file.bytes())?;
            let text = text::decode(&file, &bytes, bad)?;
            if !p40::is_one(&text) {
                let reason = "is no curve file of a P40: its first line is not HEADER KS.MK.FILE";
                let help = "give the thickness by span, over_pins or another statement";
                bad.add(file.problem(reason, help));
                return None;
            }
            Positions::of(table, &file, &text, nominal, bad)
        })
    }

    /// Those in the `text` of `file`, a curve file that `table` names.
    pub fn of(
        table: &Table,
        file: &DataFile,
        text: &str,
        nominal: &Nominal,
        problems: &mut Problems,
    ) -> Option<Positions> {
        let p40 = p40::parse(file, text, problems)?;
        p40.refuse_values(file, problems)?;
        let (read, words) = of(&p40, file, nominal, problems)?;
        table.place().add_remark(Some(format!(
            "{}: {}: thickness from the positions of Teilung:, {words}; read and not used here: {}",
            file.key(),
            file.name(),
            p40.unused(p40::POSITIONS)
        )));
        Some(Positions {
            header: p40.header,
            ..read
        })
    }
}

/// The thickness, and in words how the positions were read.
fn of(
    p40: &P40,
    file: &DataFile,
    nominal: &Nominal,
    problems: &mut Problems,
) -> Option<(Positions, String)> {
    let basic_data = nominal.basic_data;
    let teeth = basic_data.teeth() as usize;
    let places = by_tooth(p40, file, teeth, problems)?;
    let probe = p40.labelled(&["taster", "tastkugel", "messkugel", "meßkugel"]);
    let Some(&probe_mm) = probe
        .and_then(|line| line.numbers.first())
        .filter(|mm| **mm > 0.0)
    else {
        problems.add(file.problem(
            "no header line gives the diameter of the probe (Taster…, Tastkugel…, Messkugel…), without which the positions of Teilung: may be those of its centre or of the contact",
            "add the line, or give the thickness by span or over_pins",
        ));
        return None;
    };
    let fitting = readings(&places, nominal, probe_mm);
    let probe = file.bare(&probe_mm.to_string());
    let fault = match &fitting[..] {
        [reading] if reading.of_teeth => None,
        [] => match behind(&places, basic_data) {
            true => Some(BEHIND.to_owned()),
            false => Some(format!(
                "the positions of Teilung: fit the gear in 0 ways, as the centre of the probe of {probe} mm or as its contact, allowed is one: pitch, and each tooth within {:.3} mm below and {:.3} mm above the base thickness {:.4} mm",
                within(THINNER, basic_data, probe_mm),
                within(THICKER, basic_data, probe_mm),
                nominal.base_thickness_mm
            )),
        },
        [_] => Some(BEHIND.to_owned()),
        several => {
            let words = several
                .iter()
                .map(|Reading { of, phi, .. }| format!("{of}, {phi}"));
            let words: Vec<String> = words.collect();
            Some(format!(
                "the positions of Teilung: fit the gear in {} ways, with a probe of {probe} mm, allowed is one: {}",
                several.len(),
                words.join("; ")
            ))
        }
    };
    if let Some(reason) = fault {
        problems.add(file.problem(reason, "check teeth, module, pressure angle and profile_shift, and what the machine calls R and L; or give the thickness by span or over_pins"));
        return None;
    }
    let reading = fitting.into_iter().next()?;
    let found = &reading.thick;
    let mean = found.iter().sum::<f64>() / teeth as f64;
    // From the base circle to the reference circle, there to the normal section, and to µm.
    let scale =
        1000.0 * basic_data.reference_radius() / basic_data.base_radius() * basic_data.helix_cos();
    let mut per_tooth_um: Vec<f64> = found.iter().map(|s| (s - mean) * scale).collect();
    if !nominal.once {
        without_once_a_turn(&mut per_tooth_um);
    }
    let Reading { of, phi, .. } = &reading;
    let words = format!("read as {of} (diameter {probe_mm} mm), {phi}");
    let words = match nominal.once {
        true => words,
        false => format!("{words}, its part once a turn left to the runout"),
    };
    let positions = Positions {
        base_thickness_mm: mean * basic_data.base_helix_angle().cos(),
        per_tooth_um,
        header: Header::default(),
    };
    Some((positions, words))
}

/// What is wrong where the convention is not kept.
const BEHIND: &str = "in the direction of the tooth numbers R lies behind L, as of a space between two teeth, or where R and L are exchanged: seen on the reference face teeth are numbered clockwise, and R is the right-hand flank of a tooth that points up";

/// Both flanks of each of `teeth` teeth.
pub fn by_tooth(
    p40: &P40,
    file: &DataFile,
    teeth: usize,
    problems: &mut Problems,
) -> Option<Vec<Flanks>> {
    let mut places = vec![[None; 2]; teeth];
    for position in &p40.positions {
        let place = places.get_mut(position.tooth as usize - 1);
        let place = place.map(|flanks| &mut flanks[usize::from(position.flank == Flank::Left)]);
        let reason = match place {
            None => format!("tooth {}, allowed is 1 … {teeth}", position.tooth),
            // Tooth 1 is read once more at the end, to see whether the turn closes.
            Some(Some(_)) if position.tooth > 1 => format!(
                "tooth {}, {} flank, stands there twice",
                position.tooth,
                position.flank.name()
            ),
            Some(place) => {
                place.get_or_insert(position.at);
                continue;
            }
        };
        problems.add(file.problem_at(position.line, file.found(reason), "correct the line"));
    }
    let whole: Option<Vec<Flanks>> = places
        .iter()
        .map(|[right, left]| Some([(*right)?, (*left)?]))
        .collect();
    if whole.is_none() {
        let reason = match p40.positions.is_empty() {
            true => "has no block Teilung:, the probe's positions".to_owned(),
            false => format!("Teilung: does not have both flanks of each of {teeth} teeth"),
        };
        problems.add(file.problem(reason, "give the thickness by span or over_pins"));
    }
    whole
}

/// What a tooth may be off by, mm.
fn within(modules: f64, basic_data: &BasicGearData, probe_mm: f64) -> f64 {
    (modules * basic_data.module()).min(OF_PROBE * probe_mm)
}

/// The ways to read `places` under which every pitch and every tooth fits the gear, those that come to the same as one.
fn readings(places: &[Flanks], nominal: &Nominal, probe_mm: f64) -> Vec<Reading> {
    let basic_data = nominal.basic_data;
    let below = within(THINNER, basic_data, probe_mm);
    let above = within(THICKER, basic_data, probe_mm);
    let allowed = nominal.base_thickness_mm - below..=nominal.base_thickness_mm + above;
    let mut fitting: Vec<Reading> = Vec::new();
    for (turn, phi) in TURNS {
        let Some(ahead) = ahead(places, basic_data, turn) else {
            continue;
        };
        let of_teeth = ahead.iter().all(|angle| *angle > 0.0);
        if !of_teeth && ahead.iter().any(|angle| *angle > 0.0) {
            continue;
        }
        // Between the flanks of a space stands what a pitch has beyond the tooth.
        let beyond = match of_teeth {
            true => 0.0,
            false => basic_data.angular_pitch(),
        };
        let thick = places.iter().zip(&ahead).map(|(flanks, angle)| {
            Some(basic_data.base_radius() * (beyond + angle + involutes(flanks, basic_data)?))
        });
        let Some(thick) = thick.collect::<Option<Vec<f64>>>() else {
            continue;
        };
        let centre = probe_mm / basic_data.base_helix_angle().cos();
        for (of, less) in [("contact", 0.0), ("centre", centre)] {
            let thick: Vec<f64> = thick.iter().map(|thick| thick - less).collect();
            let fits = thick.iter().all(|s| allowed.contains(s));
            let is_same = |other: &Reading| {
                let mut pairs = other.thick.iter().zip(&thick);
                // Rounding of the same sums in another order.
                other.of_teeth == of_teeth && pairs.all(|(one, other)| (one - other).abs() < 1e-9)
            };
            if fits && !fitting.iter().any(is_same) {
                let spaces = if of_teeth { "" } else { " at spaces" };
                fitting.push(Reading {
                    thick,
                    of_teeth,
                    of: format!("the probe's {of}{spaces}"),
                    phi,
                });
            }
        }
    }
    fitting
}

/// What `PHI` may be to the angle of `X` and `Y`.
const TURNS: [(f64, &str); 3] = [
    (0.0, "PHI not counted"),
    (1.0, "PHI added"),
    (-1.0, "PHI taken off"),
];

/// Whether, wherever the pitch fits, R lies behind L at every tooth.
fn behind(places: &[Flanks], basic_data: &BasicGearData) -> bool {
    let mut of_pitch = TURNS
        .iter()
        .filter_map(|(turn, _)| ahead(places, basic_data, *turn))
        .peekable();
    of_pitch.peek().is_some() && of_pitch.flatten().all(|angle| angle <= 0.0)
}

/// By what R lies ahead of L at each tooth, in the direction of the numbers, rad; `None` where a pitch does not fit.
fn ahead(places: &[Flanks], basic_data: &BasicGearData, turn: f64) -> Option<Vec<f64>> {
    let pitch = basic_data.angular_pitch();
    // The other way round than along the face from the viewer.
    let angle =
        |[phi, x, y, z]: [f64; 4]| y.atan2(x) + turn * phi.to_radians() + basic_data.twist() * z;
    let wrapped = |angle: f64| (angle + PI).rem_euclid(TAU) - PI;
    // Counter-clockwise or clockwise in the plane of X and Y.
    let mut way = 0.0;
    for flank in 0..2 {
        for (index, place) in places.iter().enumerate() {
            let next = &places[(index + 1) % places.len()];
            let step = wrapped(angle(next[flank]) - angle(place[flank]));
            if (step.abs() - pitch).abs() > PITCH * pitch || step * way < 0.0 {
                return None;
            }
            way = step.signum();
        }
    }
    let ahead = |[right, left]: &Flanks| way * wrapped(angle(*right) - angle(*left));
    Some(places.iter().map(ahead).collect())
}

/// `inv α_R + inv α_L`; `None` below the base circle.
fn involutes(flanks: &Flanks, basic_data: &BasicGearData) -> Option<f64> {
    let involute = |[_, x, y, _]: [f64; 4]| {
        let ratio = f64::hypot(x, y) / basic_data.base_radius();
        (ratio >= 1.0).then(|| (ratio * ratio - 1.0).sqrt() - (1.0 / ratio).acos())
    };
    Some(involute(flanks[0])? + involute(flanks[1])?)
}

/// Takes the first harmonic off a list of one value a tooth.
fn without_once_a_turn(list: &mut [f64]) {
    let step = TAU / list.len() as f64;
    let part = |wave: fn(f64) -> f64| -> f64 {
        let products = list
            .iter()
            .enumerate()
            .map(|(i, value)| value * wave(i as f64 * step));
        2.0 * products.sum::<f64>() / list.len() as f64
    };
    let (cosine, sine) = (part(f64::cos), part(f64::sin));
    for (i, value) in list.iter_mut().enumerate() {
        let at = i as f64 * step;
        *value -= cosine * at.cos() + sine * at.sin();
    }
}
