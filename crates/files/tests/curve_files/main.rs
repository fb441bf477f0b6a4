//! Curve files `.mka` and value files `.mew` of a P40. No real one is public: these are MADE, by the small writer of [`made`].

mod made;
mod mutants;

use crate::mutant;
use crate::pair_with_table::pair;
use crate::tables::formats::{others, tenths};
use gearlash::contact::ExactKernel;
use gearlash::pair::Pose;
use gearlash_files::{PairFile, Problem, read};
use made::{Made, POINTS};
use std::fs;
use tempfile::TempDir;

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

/// Lost motion at every mating, rad.
fn lost_motion(study: &PairFile) -> Vec<f64> {
    let runs = study.study.runs().unwrap();
    let of = |run: &gearlash::analysis::study::RunPlan| {
        let pair = run.run.assembly.data().unwrap();
        let kernel = ExactKernel::new(pair);
        let motion = |mating| kernel.lost_motion(&Pose::new(pair, mating)).unwrap();
        let angles = run
            .matings
            .iter()
            .map(|mating| motion(*mating).angle().unwrap());
        angles.collect::<Vec<f64>>()
    };
    runs.iter().flat_map(of).collect()
}

/// The file as a whole, beside the same numbers written inline: the lost motion of 44 matings.
#[test]
fn lost_motion_as_with_our_own_tables() {
    let made = Made::new(44);
    let from_file = "pitch = { kind = \"cumulative\", file = \"gear.mka\" }\nrunout = { at = \"space\", file = \"gear.mka\" }\nthickness.allowance_um = -20.0\nprofile = { trace = { file = \"gear.mka\" } }";
    let list = |value: fn(u32) -> f64| {
        let values = (1..=44).map(|tooth| format!("{:.1}", value(tooth)));
        format!("[{}]", values.collect::<Vec<_>>().join(", "))
    };
    let trace = |side: &str| {
        let values = (1..POINTS).map(|i| format!("{:.2}", Made::deviation(side, i)));
        let (at, um) = (&made.rolls()[1..], values.collect::<Vec<_>>().join(", "));
        format!("trace = {{ tooth = 2, roll_length_mm = {at:?}, deviation_um = [{um}] }}")
    };
    let study = good(&made, from_file);
    let runout = &study.spec.wheel.data().unwrap().runout;
    let (total, tooth) = (runout.total_um.unwrap(), runout.high_tooth.unwrap());
    let inline = format!(
        "pitch = {{ kind = \"cumulative\", left_um = {}, right_um = {} }}\nrunout = {{ total_um = {total:?}, high_tooth = {tooth:?} }}\nthickness.allowance_um = -20.0\nprofile = {{ left = {{ {} }}, right = {{ {} }} }}",
        list(tenths),
        list(others),
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
    assert!(remarks.contains("1 lead traces"), "{remarks}");
    let holes = "of the profiles 2 values were not measured";
    assert!(remarks.contains(holes), "{remarks}");
    let [found, expected] = [&found, &expected].map(lost_motion);
    assert_eq!((found.len(), expected.len()), (88, 88));
    let off = found
        .iter()
        .zip(&expected)
        .map(|(f, e)| (f - e).abs() * 66e3);
    let worst = off.fold(0.0, f64::max);
    println!("lost motion differs by at most {worst} µm");
    // The same numbers as text; the diameters of the traces have twelve decimals.
    assert!(worst <= 1e-6, "{worst} µm");
}

/// The example beside the other sheets is what the writer makes.
#[test]
fn the_fixture() {
    let path = "../../fixtures/sheets/curves.mka";
    assert_eq!(fs::read_to_string(path).unwrap(), Made::new(9).text());
}
