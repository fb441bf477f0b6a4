//! Pictures as SVG.

use crate::call::{analysed, work};
use crate::error::Outcome;
use crate::gear::Gear;
use crate::pair::{Pair, mating};
use gearlash::analysis::curves::{self, Followed};
use gearlash::analysis::extremes::extremes;
use gearlash::analysis::outcome::by_distance;
use gearlash::analysis::study::{Material, Study};
use gearlash::analysis::verdict::Verdict;
use gearlash::analysis::{Analysis, Plan};
use gearlash::contact::{Method, lost_motion_at};
use gearlash::gear::Inspection;
use gearlash::pair::BacklashUnit;
use gearlash_render::chart::{self, Heading};
use gearlash_render::pose_picture;
use gearlash_results::gauge::stated_leads;
use gearlash_results::verdict::extremes_in_short;
use pyo3::prelude::*;

const METHOD: Method = Method::Exact { certify: true };

/// The contact at one pose; for helical gears in the section where the pose's flank touches.
#[pyfunction]
pub fn snapshot(
    py: Python<'_>,
    pair: &Pair,
    teeth: [i64; 2],
    left: bool,
    fraction: f64,
    distance: Option<f64>,
    material: Option<&str>,
) -> Outcome<String> {
    let (material, assembly) = pair.assembly(distance, material)?;
    let mating = mating(&assembly, teeth, left, fraction)?;
    let drawn = py.detach(|| {
        let found = lost_motion_at(&assembly, mating)?;
        pose_picture(&pair.study().title, &assembly, material, &found)
    });
    Ok(drawn?)
}

/// The study of one material and centre distance, where they are stated.
fn narrowed(mut study: Study, material: Option<Material>, at: Option<f64>) -> Outcome<Study> {
    if let Some(material) = material {
        study.keep(material);
    }
    match at {
        None => Ok(study),
        Some(at) => {
            Ok((study.at(vec![at])).map_err(|reason| format!("center_distance_mm: {reason}"))?)
        }
    }
}

/// Backlash, or its difference from the formula, over the wheel's teeth at one centre distance.
#[pyfunction]
pub fn over_teeth(
    py: Python<'_>,
    pair: &Pair,
    difference: bool,
    distance: Option<f64>,
    material: Option<&str>,
) -> Outcome<String> {
    let (named, assembly) = pair.assembly(distance, material)?;
    let study = curves::with_sweep(pair.study().clone());
    let at = Some(assembly.center_distance());
    let study = narrowed(study, material.map(|_| named), at)?;
    let plan = Plan::new(&study, METHOD).with_revolution().with_extremes();
    let analysis = analysed(py, None, &plan)?;
    let course = curves::courses(&analysis.curves).into_iter().next();
    let course = course.ok_or("the pair asks for no poses")?;
    let course = course.with_cycle(&analysis.extremes.each, &study.requirements);
    let cycle = extremes_in_short(&analysis.verdict());
    let heading = Heading::alone(&study.title, &cycle);
    let drawn = if difference {
        chart::difference(&heading, &course, study.tolerance_um)?
    } else {
        chart::revolution(BacklashUnit::Um, &heading, &course)
    };
    Ok(drawn.svg)
}

/// One mating's backlash over the centre distance; without teeth, of the binding mating.
#[pyfunction]
pub fn over_distance(py: Python<'_>, pair: &Pair, teeth: Option<[i64; 2]>) -> Outcome<String> {
    let study = pair.study();
    let searched = match teeth {
        Some(_) => None,
        None => {
            // These poses only select and bound the curve; the drawn curve itself is certified.
            let method = Method::Exact { certify: false };
            let plan = Plan::new(study, method).with_revolution().with_extremes();
            Some(analysed(py, None, &plan)?)
        }
    };
    let all: Vec<_> = searched.iter().flat_map(Analysis::all).collect();
    let followed = match teeth {
        None => curves::binding(study, all.iter().copied()),
        Some(teeth) => {
            let (_, assembly) = pair.assembly(None, None)?;
            let mating = mating(&assembly, teeth, false, 0.0)?;
            Followed::Teeth(mating.wheel_tooth, mating.pinion_tooth)
        }
    };
    let cycle = searched.as_ref().map_or(&[][..], |all| &all.extremes.each);
    let curve = work(py, None, |tick| {
        curves::over_distance(study, followed, cycle, METHOD, tick)
    })?;
    let in_short = |analysis: &Analysis| extremes_in_short(&analysis.verdict());
    let cycle = searched.as_ref().map(in_short).unwrap_or_default();
    let outcomes = by_distance(&all, &[]);
    let heading = Heading::alone(&study.title, &cycle);
    Ok(chart::distance(BacklashUnit::Um, &heading, &curve, &outcomes)?.svg)
}

/// The field of action at the least backlash.
#[pyfunction]
pub fn field(
    py: Python<'_>,
    pair: &Pair,
    distance: Option<f64>,
    material: Option<&str>,
) -> Outcome<String> {
    let (named, assembly) = pair.assembly(distance, material)?;
    let study = pair.study().clone();
    if !study.varies_along_face() {
        return Err("kind = \"field\": along the face of this pair nothing changes".into());
    }
    let at = distance.map(|_| assembly.center_distance());
    let study = narrowed(study, material.map(|_| named), at)?;
    let found = work(py, None, |tick| extremes(&study, METHOD, tick))?;
    let verdict = Verdict::of_study(&study, &found.each, Vec::new());
    let none = "kind = \"field\": no pose is in mesh";
    let (run, assembly, pose) = verdict.worst().ok_or(none)?;
    let drawn = chart::field_at_least(&study.title, run.material, assembly, &pose.simulated);
    let none = "kind = \"field\": the worst pose is jammed or unproven; there are no contact lines";
    Ok(drawn.ok_or(none)?.svg)
}

/// A gear's deviations, tooth by tooth, and its leads.
#[pyfunction]
pub fn inspection(gear: &Gear, material: Option<&str>) -> Outcome<String> {
    let (_, as_built) = gear.as_built(material)?;
    let inspection = Inspection::of(as_built);
    let heading = Heading::alone(&gear.title, "");
    let lead = stated_leads(as_built, &gear.spec);
    Ok(chart::inspection_and_leads(&heading, gear.entry.name, &inspection, lead.as_ref())?.svg)
}
