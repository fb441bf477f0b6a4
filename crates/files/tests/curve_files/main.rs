//! Curve files `.mka` and value files `.mew` of a P40. No real one is public: these are MADE, by the small writer below.

#[path = "../tables/mutant.rs"]
mod mutant;
#[path = "../../../../tests/common/pair_with_table.rs"]
mod pair_with_table;

use gearlash::contact::ExactKernel;
use gearlash::pair::Pose;
use gearlash_files::{PairFile, Problem, read};
use mutant::{Choice, mutant};
use pair_with_table::pair;
use std::f64::consts::TAU;
use std::fs;
use tempfile::TempDir;

/// Points of a trace.
const POINTS: usize = 20;
/// Diameter of the probe, mm.
const PROBE: f64 = 2.0;

/// A deviation of tooth `tooth`, in tenths of a µm.
fn tenths(tooth: u32) -> f64 {
    f64::from((tooth * 7) % 31) / 10.0 - 1.5
}

fn other(tooth: u32) -> f64 {
    tenths(tooth) + f64::from(tooth % 3) / 10.0
}

/// A gear of module 3, 20°.
struct Made {
    teeth: u32,
    base_thickness: f64,
    /// What tooth `i` has more on the base circle, mm.
    each: fn(u32) -> f64,
    /// Whether the positions are the probe's centre.
    centre: bool,
}

impl Made {
    fn base(&self) -> f64 {
        1.5 * f64::from(self.teeth) * 20f64.to_radians().cos()
    }

    /// Nominal less 60 µm. Source: s_b = 2 r_b (π/2z + inv α), ISO 21771.
    fn new(teeth: u32) -> Made {
        let alpha = 20f64.to_radians();
        let half = TAU / 4.0 / f64::from(teeth) + alpha.tan() - alpha;
        let mut made = Made {
            teeth,
            base_thickness: 0.0,
            each: |_| 0.0,
            centre: true,
        };
        made.base_thickness = 2.0 * made.base() * half - 0.06;
        made
    }

    fn ends(&self) -> [f64; 2] {
        [2.05 * self.base(), 3.0 * f64::from(self.teeth) + 5.0]
    }

    /// Rolls of the points.
    fn rolls(&self) -> Vec<f64> {
        let ends = self
            .ends()
            .map(|d| (0.25 * d * d - self.base().powi(2)).sqrt());
        let step = (ends[1] - ends[0]) / (POINTS - 1) as f64;
        (0..POINTS).map(|i| ends[0] + step * i as f64).collect()
    }

    fn deviation(side: &str, index: usize) -> f64 {
        let sign = if side == "links" { 1.0 } else { -0.5 };
        sign * (index * index) as f64 / 100.0
    }

    fn text(&self) -> String {
        let z = self.teeth;
        let [start, end] = self.ends();
        let mut text = format!(
            "\u{feff}HEADER KS.MK.FILE\nTYPE STI ! MADE for the tests of gearlash\nUNDEFINED -2147483.648 ! Undefined\nUNITS mm\nPROFILE diameter\nFILTER LEAD:    F:S 2\n\n  7 :ME/Seite/KS....: made : 1\n 21 :Normalmodul........[mm]..: 3.000\n 22 :Zähnezahl z..............: {z}  Außenverzahnung\n 24 :Eingriffswinkel..........: 20.0000\n 27 :Kopfkreisdurchmesser.[mm]..: {:.4}\n 40 :Start Messbereich.....da  [mm]..:  {start:.12}  {start:.12}\n 43 :Ende der Messstrecke..de  [mm]..:  {end:.12}  {end:.12}\n 60 :Tasterdurchmesser....[mm]..: {PROBE:.3}\n\n",
            3 * (z + 2)
        );
        let mut curve = |head: &str, title: &str, value: &dyn Fn(usize) -> String| {
            text += &format!("{title}\nZahn-Nr.: {head}\n");
            for line in 0..POINTS.div_ceil(12) {
                let values = (12 * line..POINTS.min(12 * line + 12)).map(value);
                text += &(values.collect::<Vec<_>>().join(" ") + "\n");
            }
        };
        curve("2 links / 20  Werte  x= 8.742", "Flankenlinie:", &|_| {
            "-.5".to_owned()
        });
        curve(
            "2k /Flankenlinie:1 links / 20  Werte  x= 8.742",
            "Verschränkung:",
            &|_| "1.0".to_owned(),
        );
        for side in ["links", "rechts"] {
            let value = |index| match index {
                0 => "-2147483.648".to_owned(),
                _ => format!("{:.2}", Made::deviation(side, index)).replace("0.", "."),
            };
            curve(
                &format!("2 {side} / 20  Werte  z= 7.500"),
                "Profil:",
                &value,
            );
        }
        text += "\nFußkreisdurchmesser / Höhe :     7.500\n  49.5 49.6\nKopfkreisdurchmesser / Höhe : 7.500\n  54.0 54.1\n";
        for (side, values) in [("linke", tenths as fn(u32) -> f64), ("rechte", other)] {
            text += &format!("\n    {side} Zahnflanke\n    Zahn-Nr.  fp  Fp  Fr\n\n");
            for tooth in 1..=z {
                let before = values(if tooth == 1 { z } else { tooth - 1 });
                let (now, fr) = (values(tooth), tenths(tooth));
                text += &format!("  {tooth}  {:.1}  {now:.1}  {fr:.1}\n", now - before);
            }
        }
        text += "\nTeilung:\nZ-Nr. Seite PHI X Y Z\n";
        let radius = 1.5 * f64::from(z) + 0.3;
        let roll = ((radius / self.base()).powi(2) - 1.0).sqrt();
        let out = if self.centre { PROBE } else { 0.0 };
        for tooth in (1..=z).chain([1]) {
            for (side, sign) in [("R", -1.0), ("L", 1.0)] {
                let phi = 360.0 / f64::from(z) * f64::from(tooth - 1);
                let phi = (phi * 1e4).round() / 1e4;
                let thick = self.base_thickness + (self.each)(tooth) + out;
                let half = thick / (2.0 * self.base()) - (roll - roll.atan());
                let middle = f64::from(tooth - 1) * TAU / f64::from(z) + TAU / 4.0;
                let at = middle + sign * half - phi.to_radians();
                let (x, y) = (radius * at.cos(), radius * at.sin());
                text += &format!("  {tooth}  {side}  {phi:.4}  {x:.4}  {y:.4}  87.2302\n");
            }
        }
        text.replace('\n', "\r\n")
    }
}

fn read_with(table: &[u8], text: &str) -> Result<PairFile, Vec<Problem>> {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("gear.mka"), table).unwrap();
    let path = folder.path().join("pair.toml");
    fs::write(&path, text).unwrap();
    read(&path).map_err(|error| error.problems)
}

fn good(made: &Made, keys: &str) -> PairFile {
    let read = read_with(made.text().as_bytes(), &pair(made.teeth, keys));
    read.unwrap_or_else(|problems| panic!("{problems:#?}"))
}

fn told(table: &str, teeth: u32, keys: &str) -> String {
    let problems = read_with(table.as_bytes(), &pair(teeth, keys)).unwrap_err();
    let told = problems
        .iter()
        .map(|p| p.reason.split("gear.mka: ").last().unwrap_or("").to_owned());
    told.collect::<Vec<_>>().join("\n")
}

/// Lost motion at every mating, rad.
fn lost_motion(study: &PairFile) -> Vec<f64> {
    let runs = study.study.runs().unwrap();
    let of = |run: &gearlash::analysis::study::RunPlan| {
        let kernel = ExactKernel::new(&run.assembly);
        let motion = |mating| {
            kernel
                .lost_motion(&Pose::new(&run.assembly, mating))
                .unwrap()
        };
        run.matings
            .iter()
            .map(|mating| motion(*mating).angle().unwrap())
            .collect::<Vec<_>>()
    };
    runs.iter().flat_map(of).collect()
}

/// The file as a whole, beside the same numbers written inline: the lost motion of 44 matings.
#[test]
fn lost_motion_as_with_our_own_tables() {
    let made = Made::new(44);
    let from_file = "pitch = { kind = \"cumulative\", file = \"gear.mka\" }\nrunout = { at = \"space\", file = \"gear.mka\" }\nthickness = { file = \"gear.mka\" }\nprofile = { trace = { file = \"gear.mka\" } }";
    let list = |value: fn(u32) -> f64| {
        let values: Vec<String> = (1..=44)
            .map(|tooth| format!("{:.1}", value(tooth)))
            .collect();
        format!("[{}]", values.join(", "))
    };
    let trace = |side: &str| {
        let values = (1..POINTS).map(|i| format!("{:.2}", Made::deviation(side, i)));
        let (at, um) = (
            made.rolls()[1..].to_vec(),
            values.collect::<Vec<_>>().join(", "),
        );
        format!("trace = {{ tooth = 2, roll_length_mm = {at:?}, deviation_um = [{um}] }}")
    };
    let (total, tooth) = {
        let study = good(&made, "runout = { at = \"space\", file = \"gear.mka\" }");
        (
            study.spec.wheel.runout.total_um,
            study.spec.wheel.runout.high_tooth.unwrap(),
        )
    };
    let inline = format!(
        "pitch = {{ kind = \"cumulative\", left_um = {}, right_um = {} }}\nrunout = {{ total_um = {total:?}, high_tooth = {tooth:?} }}\nthickness = {{ base_thickness_mm = {:?} }}\nprofile = {{ left = {{ {} }}, right = {{ {} }} }}",
        list(tenths),
        list(other),
        made.base_thickness,
        trace("links"),
        trace("rechts")
    );
    let all = |keys: &str| {
        let text = pair(44, keys);
        let matings: Vec<[u32; 2]> = (1..=44).map(|tooth| [tooth, tooth]).collect();
        text.replace("mating = [[1, 1]]", &format!("mating = {matings:?}"))
    };
    let [found, expected] = [from_file, &inline].map(|keys| {
        let read = read_with(made.text().as_bytes(), &all(keys));
        read.unwrap_or_else(|problems| panic!("{problems:#?}"))
    });
    let remarks = found.remarks.join("\n");
    assert!(
        remarks.contains("read as the probe's centre (diameter 2 mm), PHI added"),
        "{remarks}"
    );
    assert!(remarks.contains("1 lead traces"), "{remarks}");
    let [found, expected] = [&found, &expected].map(lost_motion);
    assert_eq!((found.len(), expected.len()), (88, 88));
    let worst = found
        .iter()
        .zip(&expected)
        .map(|(f, e)| (f - e).abs() * 66e3)
        .fold(0.0, f64::max);
    println!("lost motion differs by at most {worst} µm");
    // X and Y are printed to 0.1 µm: a position is off by up to 0.071 µm, the mean of 88 by far less.
    assert!(worst <= 0.071, "{worst} µm");
}

/// Each tooth by its positions, centre or contact: within the digits printed.
#[test]
fn each_tooth_by_its_positions() {
    for centre in [true, false] {
        let made = Made {
            centre,
            each: |tooth| tenths(tooth) / 1000.0,
            ..Made::new(21)
        };
        for keys in [
            "thickness = { file = \"gear.mka\" }",
            "thickness.per_tooth_um = { file = \"gear.mka\" }",
        ] {
            let study = good(&made, keys);
            let found = study.spec.wheel.thickness.per_tooth_um.unwrap();
            let mean: f64 = (1..=21).map(tenths).sum::<f64>() / 21.0;
            for (tooth, um) in (1..).zip(&found) {
                let expected = (tenths(tooth) - mean) / 20f64.to_radians().cos();
                assert!((um - expected).abs() < 0.2, "{tooth}: {um} {expected}");
            }
        }
    }
}

/// Positions are about the bore: where a runout is stated, what varies once a turn is the eccentricity, and counts once.
#[test]
fn beside_a_runout_nothing_once_a_turn_is_left() {
    let made = Made {
        each: |tooth| 0.002 * (f64::from(tooth) * std::f64::consts::TAU / 21.0).sin(),
        ..Made::new(21)
    };
    let runout = "runout = { total_um = 10, high_tooth = 3 }";
    for keys in [
        "thickness = { file = \"gear.mka\" }",
        "thickness.per_tooth_um = { file = \"gear.mka\" }",
    ] {
        let of = |keys: &str| {
            let thickness = good(&made, keys).spec.wheel.thickness;
            let values = thickness.per_tooth_um.unwrap().into_iter().zip(0..);
            let [mut re, mut im] = [0.0, 0.0];
            for (um, tooth) in values {
                let angle = f64::from(tooth) * std::f64::consts::TAU / 21.0;
                re += um * angle.cos();
                im += um * angle.sin();
            }
            f64::hypot(re, im) / 10.5
        };
        let (alone, beside) = (of(keys), of(&format!("{runout}\n{keys}")));
        assert!(alone > 0.1, "{alone}");
        assert!(beside < 1e-9, "{beside}");
    }
}

#[test]
fn faults_have_their_words() {
    let made = Made::new(17);
    let text = made.text();
    let thickness = "thickness = { file = \"gear.mka\" }";
    let pitch = "pitch = { kind = \"single\", file = \"gear.mka\" }";
    let trace = "profile = { trace = { file = \"gear.mka\" } }";
    for (from, to, keys, expected) in [
        (
            "Tasterdurchmesser",
            "Werkzeug",
            thickness,
            "no header line gives the diameter of the probe",
        ),
        (": 2.000", ": 3.000", thickness, "fit the gear in 0 ways"),
        (
            "Zähnezahl z..............: 17",
            "Zähnezahl z..............: 18",
            thickness,
            "the pair file has teeth = 17",
        ),
        (
            "Zähnezahl z..............: 17",
            "Zähnezahl z..............: 18",
            trace,
            "the pair file has teeth = 17",
        ),
        (
            "Start Messbereich",
            "Start",
            trace,
            "no header line is labelled start messbereich",
        ),
        (
            "\r\nTeilung:",
            "\r\nwhat is this\r\nTeilung:",
            pitch,
            "3 values, the block has 4 columns",
        ),
        (
            "Profil:",
            "Profile:",
            pitch,
            "\"Profile:\" is not understood here",
        ),
        (
            "links / 20  Werte  z",
            "links / 21  Werte  z",
            pitch,
            "allowed is a number of µm: the trace of line",
        ),
        (
            "PROFILE diameter",
            "PROFILE angle",
            trace,
            "PROFILE is \"angle\"",
        ),
        ("UNITS mm", "UNITS inch", pitch, "allowed is mm and µm"),
    ] {
        assert!(text.contains(from), "{from}");
        let told = told(&text.replacen(from, to, 1), 17, keys);
        assert!(told.contains(expected), "{to}: {told}");
    }
}

const MEW: &str = "\u{feff}HEADER KS.MW.FILE\r\nTYPE  STI ! MADE\r\n\r\n  7   :ME....: 1\r\n 22 :Zähnezahl z....: 17\r\n10111 : fHb links 1  :   -2.9\r\n10112 : fHb links 2  : -9999.0\r\n26411 : Fuß 1 : 49.5\r\n26450 : V Fuß : 8999.0\r\n26711 : Kopf 1 : 49.5\r\n";

/// What the lines of a file say of pitch and of the profiles, read leniently.
fn said(bytes: &[u8]) -> Option<Vec<Vec<f64>>> {
    let text = String::from_utf8_lossy(bytes);
    let mut lists = vec![Vec::new(), Vec::new(), Vec::new(), Vec::new()];
    let mut list = None;
    for line in text.lines().map(str::trim) {
        let number = |word: &str| word.parse::<f64>().ok();
        if line.starts_with("Profil:") || line.ends_with(':') && line != "Teilung:" {
            list = line.starts_with("Profil:").then_some(9);
        }
        let line = line.trim_start_matches("Profil:").trim();
        if line.starts_with("Zahn-Nr.:") && list.is_some_and(|list| list >= 2) {
            list = Some(if line.contains("links") { 3 } else { 2 });
        } else if line.to_lowercase().ends_with("e zahnflanke") {
            list = Some(usize::from(line.to_lowercase().starts_with("linke")));
        } else if line.starts_with(char::is_alphabetic) && !line.starts_with("Zahn-Nr.") {
            list = None;
        } else if let (Some(place @ 0..2), Some(_)) =
            (list, line.split_whitespace().next().and_then(number))
        {
            let words: Vec<f64> = line.split_whitespace().map(number).collect::<Option<_>>()?;
            lists[place].push((words[0] as u32, *words.get(1)?));
        } else if let Some(place @ 2..4) = list {
            for word in line.split_whitespace() {
                let value = number(word)?;
                lists[place].extend((value > -2147483.0).then_some((0, value)));
            }
        }
    }
    for list in &mut lists[..2] {
        list.sort_by_key(|row| row.0);
    }
    Some(
        lists
            .into_iter()
            .map(|list| list.into_iter().map(|row| row.1).collect())
            .collect(),
    )
}

/// An error that says where, or exactly what the file says.
#[test]
fn ten_thousand_mutants_of_each() {
    let keys = "pitch = { kind = \"single\", file = \"gear.mka\" }\nprofile = { trace = { file = \"gear.mka\" } }";
    let of_the_file = [
        "is empty",
        "is a protocol of pitch",
        "has no block ",
        "has no profile trace",
        "is a value file (.mew)",
        "no rows below the header",
        // With another first line it is a table of cells.
        "no line names the columns",
    ];
    for (name, good) in [("mka", Made::new(17).text()), ("mew", MEW.to_owned())] {
        let folder = TempDir::new().unwrap();
        let path = folder.path().join("pair.toml");
        fs::write(&path, pair(17, keys)).unwrap();
        let mut choice = Choice(17);
        let (mut errors, mut right) = (0, 0);
        for number in 0..=10_000 {
            let bytes = match number {
                0 => good.clone().into_bytes(),
                _ => mutant(good.as_bytes(), &mut choice),
            };
            fs::write(folder.path().join("gear.mka"), &bytes).unwrap();
            match read(&path) {
                Ok(study) => {
                    let wheel = study.spec.wheel;
                    let (pitch, profile) = (wheel.pitch.unwrap(), wheel.profile.unwrap());
                    let trace = |flank: Option<gearlash_files::spec::FlankProfileSpec>| {
                        let flank = flank.unwrap_or_else(|| profile.both.clone());
                        let first = flank.traces().first().cloned();
                        first
                            .and_then(|trace| trace.deviation_um)
                            .unwrap_or_default()
                    };
                    let found = vec![
                        pitch.right_um.unwrap(),
                        pitch.left_um.unwrap(),
                        trace(profile.right.clone()),
                        trace(profile.left.clone()),
                    ];
                    assert_eq!(
                        Some(found),
                        said(&bytes),
                        "{name} {number}: {}",
                        String::from_utf8_lossy(&bytes)
                    );
                    right += 1;
                }
                Err(error) => {
                    assert!(number > 0 || name == "mew", "{:#?}", error.problems);
                    for problem in error.problems {
                        let Some((_, told)) = problem.reason.split_once("gear.mka: ") else {
                            continue;
                        };
                        let has_line = told
                            .strip_prefix("line ")
                            .is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
                        assert!(
                            has_line || of_the_file.iter().any(|words| told.starts_with(words)),
                            "{name} {number}: {problem}"
                        );
                    }
                    errors += 1;
                }
            }
        }
        println!("{name}: {errors} errors, {right} right");
        assert!(
            name == "mew" && right == 0 || errors > 3000 && right > 250,
            "{name}: {errors} errors, {right} right"
        );
    }
}
