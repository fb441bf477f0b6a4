//! Tooth thickness from the probe's positions at every flank, `Teilung:` of a curve file `.mka`.
//!
//! A point of an involute at radius `r` stands `inv α_r` behind its foot on the base circle, so that two points of a tooth, an
//! angle `Δ` apart, give `s_b = r_b (Δ + inv α_R + inv α_L)`. The centre of a ball that touches the flank lies on the involute that
//! stands out by half its diameter: of centres, `s_b + d` comes instead. Which of the two the file holds, and whether its `PHI` turns the
//! gear, the probe, or says nothing new, is not documented: that reading counts under which every pitch and every tooth fits the gear.

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
/// What a tooth may be off nominal, in modules. Tuned: the thinnest field of DIN 3967 on a small gear is 0.3 off.
const TOOTH: f64 = 0.35;
/// The same in probe diameters, so that of centre and contact only one can fit.
const OF_PROBE: f64 = 0.25;

/// The thickness of each tooth.
#[derive(Debug)]
pub struct Positions {
    /// Base tooth thickness of the mean, mm.
    pub base_thickness_mm: f64,
    /// What each tooth has more, µm at the reference circle.
    pub per_tooth_um: Vec<f64>,
    /// What the file says of the gear.
    pub header: Header,
}

impl Positions {
    /// Reads the file that `table` names; of a gear of `basic_data` and a nominal base thickness. Without `once`, what of the
    /// thickness comes back once a turn is left out, as runout.
    pub fn read(
        table: &Table,
        (basic_data, nominal): (&BasicGearData, f64),
        once: bool,
        problems: &mut Problems,
    ) -> Option<Positions> {
        let needed = "the name of a curve file, such as \"gear.mka\"";
        let file = DataFile::of(table, needed, problems)?;
        let mut bad = Problems::of_list();
        let bytes = bad.keep(file.bytes());
        let text = bytes
            .as_ref()
            .and_then(|bytes| text::decode(&file, bytes, &mut bad));
        let read = text.and_then(|text| {
            if !p40::is_one(&text) {
                let reason = "is no curve file of a P40: its first line is not HEADER KS.MK.FILE";
                let help = "give the thickness by span, over_pins or another statement";
                bad.add(file.problem(reason, help));
                return None;
            }
            let p40 = p40::parse(&file, &text, &mut bad)?;
            p40.refuse_values(&file, &mut bad)?;
            let read = of(&p40, &file, basic_data, nominal, once, &mut bad)?;
            table.place().tell(Some(format!(
                "{}: {}: thickness from the positions of Teilung:, {}; read and not used here: {}",
                file.key(),
                file.name(),
                read.1,
                p40.unused("positions of the probe")
            )));
            Some(Positions {
                header: p40.header,
                ..read.0
            })
        });
        let good = bad.is_empty();
        problems.add_list(file.key(), bad);
        read.filter(|_| good)
    }

    /// Whether `table` names a file of this kind.
    pub fn is_named(table: &Table) -> bool {
        let mut unheard = Problems::of_list();
        let bytes = DataFile::of(table, "a file", &mut unheard).and_then(|file| file.bytes().ok());
        bytes.is_some_and(|bytes| {
            p40::is_one(&String::from_utf8_lossy(&bytes).replace('\u{feff}', ""))
        })
    }
}

/// The thickness, and in words how the positions were read.
fn of(
    p40: &P40,
    file: &DataFile,
    basic_data: &BasicGearData,
    nominal: f64,
    once: bool,
    problems: &mut Problems,
) -> Option<(Positions, String)> {
    let teeth = basic_data.teeth() as usize;
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
    let whole: Option<Vec<[[f64; 3]; 2]>> = places
        .iter()
        .map(|[right, left]| Some([(*right)?, (*left)?]))
        .collect();
    let Some(places) = whole else {
        let reason = match p40.positions.is_empty() {
            true => "has no block Teilung:, the probe's positions".to_owned(),
            false => format!("Teilung: does not have both flanks of each of {teeth} teeth"),
        };
        problems.add(file.problem(reason, "give the thickness by span or over_pins"));
        return None;
    };
    let probe = p40.labelled(&["taster", "tastkugel", "messkugel", "meßkugel"]);
    let Some(probe_mm) = probe
        .and_then(|line| line.numbers.first())
        .filter(|mm| **mm > 0.0)
    else {
        problems.add(file.problem(
            "no header line gives the diameter of the probe (Taster…, Tastkugel…, Messkugel…), without which the positions of Teilung: may be those of its centre or of the contact",
            "add the line, or give the thickness by span or over_pins",
        ));
        return None;
    };
    let within = (TOOTH * basic_data.module()).min(OF_PROBE * probe_mm);
    let mut fitting: Vec<(Vec<f64>, String)> = Vec::new();
    for (turn, words) in [
        (0.0, "PHI not counted"),
        (1.0, "PHI added"),
        (-1.0, "PHI taken off"),
    ] {
        let Some(thick) = thick(&places, basic_data, turn) else {
            continue;
        };
        for (of, less) in [("contact", 0.0), ("centre", *probe_mm)] {
            let found: Vec<f64> = thick.iter().map(|thick| thick - less).collect();
            let fits = found.iter().all(|s| (s - nominal).abs() <= within);
            let near = |(other, _): &(Vec<f64>, _)| {
                other
                    .iter()
                    .zip(&found)
                    .all(|(one, other)| (one - other).abs() < 1e-9)
            };
            if fits && !fitting.iter().any(near) {
                fitting.push((
                    found,
                    format!("read as the probe's {of} (diameter {probe_mm} mm), {words}"),
                ));
            }
        }
    }
    let fit_count = fitting.len();
    let Some((found, words)) = fitting.pop().filter(|_| fit_count == 1) else {
        let reason = format!(
            "the positions of Teilung: fit the gear in {fit_count} ways, as the centre of the probe of {} mm or as its contact, allowed is one: pitch, and each tooth within {within:.3} mm of the base thickness {nominal:.4} mm",
            file.bare(&probe_mm.to_string())
        );
        problems.add(file.problem(reason, "check teeth, module, pressure angle and profile_shift, or give the thickness by span or over_pins"));
        return None;
    };
    let mean = found.iter().sum::<f64>() / teeth as f64;
    // From the base circle to the reference circle, and to µm.
    let scale = 1000.0 * basic_data.reference_radius() / basic_data.base_radius();
    let mut per_tooth_um: Vec<f64> = found.iter().map(|s| (s - mean) * scale).collect();
    if !once {
        without_once_a_turn(&mut per_tooth_um);
    }
    let words = match once {
        true => words,
        false => format!("{words}, its part once a turn left to the runout"),
    };
    let positions = Positions {
        base_thickness_mm: mean,
        per_tooth_um,
        header: Header::default(),
    };
    Some((positions, words))
}

/// `s_b` of each tooth as if of contacts, mm; `None` where a pitch does not fit, or a radius is below the base circle.
fn thick(places: &[[[f64; 3]; 2]], basic_data: &BasicGearData, turn: f64) -> Option<Vec<f64>> {
    let pitch = basic_data.angular_pitch();
    let base = basic_data.base_radius();
    let angle = |[phi, x, y]: [f64; 3]| y.atan2(x) + turn * phi.to_radians();
    let wrapped = |angle: f64| (angle + PI).rem_euclid(TAU) - PI;
    let mut way = 0.0;
    for flank in 0..2 {
        for (index, place) in places.iter().enumerate() {
            let next = &places[(index + 1) % places.len()];
            let step = wrapped(angle(next[flank]) - angle(place[flank]));
            if (step.abs() - pitch).abs() > PITCH * pitch || step * way < 0.0 {
                return None;
            }
            way = step;
        }
    }
    let involute = |[_, x, y]: [f64; 3]| {
        let ratio = f64::hypot(x, y) / base;
        (ratio >= 1.0).then(|| (ratio * ratio - 1.0).sqrt() - (1.0 / ratio).acos())
    };
    let tooth = |[right, left]: &[[f64; 3]; 2]| {
        let apart = wrapped(angle(*left) - angle(*right)).abs();
        Some(base * (apart + involute(*right)? + involute(*left)?))
    };
    places.iter().map(tooth).collect()
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
