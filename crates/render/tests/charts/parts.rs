//! Parts of a run of `gearlash tolerance` whose numbers someone has edited: a named error, or a result.

use gearlash_files::tolerance::{Part, ToleranceResult, histogram_csv, read_tolerance, worst_file};
use gearlash_render::{ToleranceReport, tolerance_pictures, tolerance_report};
use gearlash_results::text;
use gearlash_results::text::Screen;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use serde_json::Value;
use std::ops::ControlFlow;

/// 20/17 with two quantities, of which some assemblies jam and some are of no gear.
const PAIR: &str = r#"
title = "edited"
[wheel]
teeth = 20
module_mm = 2.0
pressure_angle_deg = 20.0
[pinion]
teeth = 17
module_mm = 2.0
pressure_angle_deg = 20.0
reference_face = "back"
[assembly]
center_distance_mm = 37.1
[require]
j_wt_um = { min = 40, max = 120 }
[tolerance]
assemblies = 150
max_impossible = 0.5
contribution_rows = 48
center_distance = { scatter = "normal", sigma_um = 30 }
[tolerance.wheel]
thickness = { scatter = "table", values_um = [0, -20, 10, 0, -5, 3000, 400] }
"#;

fn parts() -> [String; 2] {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pair.toml");
    std::fs::write(&path, PAIR).unwrap();
    let file = read_tolerance(&path).unwrap();
    [1, 2].map(|shard| {
        let mut part = file.part(150, 3, [shard, 2]).unwrap();
        let go_on = || ControlFlow::Continue(());
        while file.go_on(&mut part, None, &go_on).unwrap() {}
        part.to_json()
    })
}

/// Numbers of a part, and sums that stand as text.
fn numbers<'a>(value: &'a mut Value, found: &mut Vec<&'a mut Value>) {
    match value {
        Value::Array(each) => each.iter_mut().for_each(|one| numbers(one, found)),
        Value::Object(each) => each.values_mut().for_each(|one| numbers(one, found)),
        Value::String(text) if text.parse::<i128>().is_ok() => found.push(value),
        Value::Number(_) => found.push(value),
        _ => (),
    }
}

/// The number `from` as someone may have changed it, of the way `how`.
fn changed(from: &Value, how: u8, by: i64) -> Value {
    let whole = |from: i128| -> i128 {
        match how {
            0 => from + 1,
            1 => from - 1,
            2 => 0,
            3 => -from,
            4 => from.saturating_mul(i128::from(by)),
            5 => i128::from(i64::MAX),
            6 => i128::from(i64::MIN),
            7 => i128::from(u64::MAX),
            8 => i128::MAX,
            9 => i128::MIN,
            _ => i128::from(by),
        }
    };
    let narrow = |wide: i128| match (i64::try_from(wide), u64::try_from(wide)) {
        (Ok(narrow), _) => Value::from(narrow),
        (_, Ok(narrow)) => Value::from(narrow),
        _ => Value::from(wide as f64),
    };
    match from {
        Value::String(text) => whole(text.parse().unwrap()).to_string().into(),
        Value::Number(number) => match number.as_i64() {
            Some(from) => narrow(whole(from.into())),
            None => Value::from([0.0, -1.0, 1e300, -1e300, 1e-300, 0.5][how as usize % 6]),
        },
        other => other.clone(),
    }
}

/// All that a merge tells and writes of `parts`; the error of what is none.
fn told(parts: [&str; 2]) -> Result<String, String> {
    let read = |(name, text): (&str, &str)| {
        let part = Part::from_json(name, text).map_err(|error| error.to_string())?;
        Ok((name.to_owned(), part))
    };
    let each = ["one.json", "two.json"].into_iter().zip(parts).map(read);
    let each = each.collect::<Result<Vec<_>, String>>()?;
    let whole = Part::merged(each).map_err(|error| error.to_string())?;
    if let Some(reason) = whole.too_many_impossible() {
        return Err(reason.to_string());
    }
    let result = ToleranceResult::of(whole);
    let mut all = result.to_json() + &result.to_csv().unwrap() + &histogram_csv(&result.part);
    all += &text::tolerance(&result, &Screen::default());
    for (index, worst) in result.part.worst.iter().enumerate() {
        all += &worst_file(index, worst).1.unwrap_or_default();
    }
    let pictures = tolerance_pictures(&result).map_err(|error| error.to_string())?;
    Ok(all
        + &tolerance_report(&ToleranceReport {
            result: &result,
            pictures: &pictures,
            date: "2026-01-01",
        }))
}

/// One to three numbers of a part changed, 4000 times: nothing panics, and every error names the file or what is wrong.
#[test]
fn an_edited_part_is_a_named_error_or_a_merge() {
    let [first, second] = parts();
    assert!(told([&first, &second]).is_ok());
    let whole: Value = serde_json::from_str(&first).unwrap();
    let places = {
        let mut copy = whole.clone();
        let mut all = Vec::new();
        numbers(&mut copy, &mut all);
        all.len()
    };
    let merged = std::cell::Cell::new(0);
    let edits = prop::collection::vec((0..places, 0u8..11, any::<i64>()), 1..=3);
    let mut runner = TestRunner::new(Config {
        cases: 4000,
        failure_persistence: None,
        ..Config::default()
    });
    let outcome = runner.run(&edits, |edits| {
        let mut part = whole.clone();
        let mut each = Vec::new();
        numbers(&mut part, &mut each);
        for (place, how, by) in edits {
            *each[place] = changed(each[place], how, by);
        }
        match told([&part.to_string(), &second]) {
            Ok(_) => merged.set(merged.get() + 1),
            Err(error) => prop_assert!(
                error.contains("one.json") || error.contains("two.json"),
                "{error}"
            ),
        }
        Ok(())
    });
    outcome.unwrap();
    // Limits and pair files may be others, but hardly any sum.
    assert!(merged.get() < 3600, "{}", merged.get());
}

/// What each inconsistency is called.
#[test]
fn each_inconsistent_number_is_named() {
    let [first, second] = parts();
    let whole: Value = serde_json::from_str(&first).unwrap();
    for (place, value, wanted) in [
        ("/tally/below", 76, "what is outside is not what is below"),
        ("/tally/doubtful", 76, "more outside or in doubt"),
        ("/tally/outside_by_stretch/63", 1, "do not add up"),
        ("/done/rows", 23, "do not add up to the rows"),
        ("/done/assemblies", 76, "more is done than it is to do"),
        (
            "/contributions/least/3/rows",
            7,
            "do not add up to the rows",
        ),
        ("/tally/least/count", 3, "a histogram does not hold as many"),
        ("/tally/least/least/1", 99, "is none of its histogram"),
        (
            "/tally/first_impossible",
            150,
            "first impossible assembly is none",
        ),
        ("/tally/worst/0/1", 150, "worst assemblies are none of it"),
        ("/worst/0/number", 3, "worst assemblies are not theirs"),
        ("/shard/1", 100_001, "number is none of its run's parts"),
        ("/assemblies", 0, "more than any run has, or nothing"),
        ("/about/max_impossible", 2, "no pair file has"),
    ] {
        let mut part = whole.clone();
        *part.pointer_mut(place).expect(place) = Value::from(value);
        let error = told([&part.to_string(), &second]).unwrap_err();
        assert!(error.contains(wanted), "{place}: {error}");
        assert!(error.starts_with("one.json: "), "{place}: {error}");
    }
    for (place, value) in [
        ("/tally/greatest/sums/0", "9000000000000"),
        ("/tally/greatest/sums/1", "-1"),
        ("/contributions/least/0/samples/2", "-1"),
    ] {
        let mut part = whole.clone();
        *part.pointer_mut(place).expect(place) = Value::from(value);
        let error = told([&part.to_string(), &second]).unwrap_err();
        assert!(error.contains("none of"), "{place}: {error}");
    }
}
