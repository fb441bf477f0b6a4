//! Remedies: single changes that make a pair assemble and meet its requirements, all else unchanged.
//!
//! Backlash grows with the centre distance and falls with the thickness of the teeth, so each change has one threshold.
//! `threshold`, which also finds the distance from which a pair assembles, finds it on the worst run. Every run is then
//! checked with the value rounded to a micrometre towards the safe side. Bounds decide: without a bound of an extreme
//! there is no remedy. The thickness of drawn gears is changed by their flank offset alone.

use super::assembles_from::threshold;
use super::cycles::{CyclePlan, DRAWN_SLOPE, ThinnedTeeth, cycle_pair, plans, proven_width};
use super::extremes::RunExtremes;
use super::requirement::{Limits, Quantity};
use super::study::{Material, Study};
use super::verdict::Verdict;
use crate::contact::{Effort, End, Status};
use crate::error::{Error, Tick};
use crate::outline::{AssembledPair, GearChange};
use crate::pair::Member;

/// Step to which a value is rounded, mm.
const STEP: f64 = 1e-3;

/// Distance from a rounded value within which a threshold equals it, mm: twice the width of its bracket.
const NEAR: f64 = 2e-6;

/// Quantities that a remedy changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Change {
    /// The centre distance.
    CenterDistance,
    /// The flank offset: distance by which each flank is moved outwards along its normal.
    FlankOffset,
    /// The thickness allowance `A_sn`, in the normal section at the reference circle.
    ThicknessAllowance,
}

/// The gears that are changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gears {
    /// Wheel and pinion, which get the same value.
    Both,
    /// One of them.
    One(Member),
}

impl Gears {
    /// Each way to choose them.
    const EACH: [Gears; 3] = [
        Gears::Both,
        Gears::One(Member::Wheel),
        Gears::One(Member::Pinion),
    ];

    /// `both`, `wheel` or `pinion`, as results name them.
    pub fn name(self) -> &'static str {
        match self {
            Gears::Both => "both",
            Gears::One(member) => member.name(),
        }
    }

    /// Whether this gear is one of them.
    pub fn has(self, member: Member) -> bool {
        self == Gears::Both || self == Gears::One(member)
    }

    fn members(self) -> impl Iterator<Item = Member> {
        let chosen = move |member: &Member| self.has(*member);
        Member::BOTH.into_iter().filter(chosen)
    }
}

/// A single change that makes the pair fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Remedy {
    /// The quantity that is changed.
    pub what: Change,
    /// The gears on which it is changed.
    pub gears: Gears,
    /// The value with which the pair fits, mm. It is the end with most material of a thickness tolerance, and the
    /// second distance of a band.
    pub value: f64,
    /// The present values, mm: of wheel and pinion, or the least and the greatest centre distance.
    pub present: [f64; 2],
    /// The bracket of the threshold, mm.
    pub bracket: [f64; 2],
}

/// How a file states a gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StatedGear {
    /// The factor of all its lengths.
    pub scale: f64,
    /// Whether a flank offset states its thickness.
    pub by_flank_offset: bool,
}

/// The reason why a change, or every change, is not among the remedies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NoRemedy {
    /// Least and greatest value, `found`, of a quantity differ by more than its limits do.
    Spread {
        /// The limited quantity.
        quantity: Quantity,
        /// The centre distance, mm, where that of the other runs differs.
        distance: Option<f64>,
        /// Its least and greatest value, in its unit.
        found: [f64; 2],
        /// Its limits.
        limits: [f64; 2],
    },
    /// Backlash is too little in one run and too great in another.
    TooLittleAndTooGreat,
    /// The gears are out of mesh.
    OutOfMesh,
    /// The centre distance: the runs are measured rows.
    MeasuredRows,
    /// The thickness: one gear is drawn, the other given by data.
    Drawn,
    /// The centre distance: none was found that suffices.
    NoDistance,
    /// The thickness of these gears: none was found that suffices.
    NoThickness(Gears),
    /// A common thickness of both gears: it would change one of them the wrong way.
    Opposed,
    /// No single change was found that suffices.
    NotEnough,
}

/// The remedies of a study.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Remedies {
    /// Each single change that makes the pair fit.
    pub changes: Vec<Remedy>,
    /// Why others are missing.
    pub missing: Vec<NoRemedy>,
}

/// The remedies of `study`, if `verdict` says that it does not assemble or misses a requirement; otherwise none. Thicknesses are of
/// wheel and pinion as `stated`: before their factors, and as flank offsets where these state them.
///
/// A change is no remedy if another requirement is missed after it, or if as much effort as one verdict may take does not suffice.
///
/// # Errors
/// As [`super::extremes::extremes`].
pub fn remedies(
    study: &Study,
    verdict: &Verdict,
    stated: [StatedGear; 2],
    tick: &Tick,
) -> Result<Remedies, Error> {
    let fails_to_assemble = |run: &RunExtremes| run.assembles() == Some(false);
    // A pair that does not assemble misses every limit, and is too tight.
    let misses = |is_max: bool| {
        let mut unmet = verdict.unmet.iter();
        unmet.any(|unmet| unmet.is_max == is_max && unmet.found.is_some())
    };
    let too_tight = verdict.runs.iter().any(fails_to_assemble) || misses(false);
    let too_loose = misses(true);
    let out_of_mesh = |run: &RunExtremes| run.status == Status::NoContact;
    let none = |reason| Remedies {
        changes: Vec::new(),
        missing: vec![reason],
    };
    if verdict.runs.iter().any(out_of_mesh) {
        return Ok(none(NoRemedy::OutOfMesh));
    }
    if too_tight && too_loose {
        let spread = spread(study, verdict.runs);
        return Ok(none(spread.unwrap_or(NoRemedy::TooLittleAndTooGreat)));
    }
    let worst = worst(verdict.runs, too_tight).filter(|_| too_tight || too_loose);
    let Some(worst) = worst else {
        return Ok(Remedies::default());
    };
    let plans = plans(study, tick)?;
    let pair = &plans[worst].run.assembly;
    let effort = || cycle_pair(pair).effort_of_remedy(&plans[worst]);
    let search = Search {
        study,
        plans: &plans,
        worst,
        pair,
        stated,
        sign: if too_tight { 1.0 } else { -1.0 },
    };
    let mut found = Remedies::default();
    if study.sweep.is_some() {
        match search.distance(&effort())? {
            Some(change) => found.changes.push(change),
            None => found.missing.push(NoRemedy::NoDistance),
        }
    } else {
        found.missing.push(NoRemedy::MeasuredRows);
    }
    // The first plan has the most material.
    match cycle_pair(&plans[0].run.assembly).thinned_teeth() {
        Some(teeth) => {
            for gears in Gears::EACH {
                let mut changes = search.thickness(&teeth, gears, &effort())?;
                if changes.is_empty() {
                    found.missing.push(NoRemedy::NoThickness(gears));
                } else if gears == Gears::Both {
                    let change = |remedy: &Remedy| remedy.present.map(|at| at - remedy.value);
                    let is_opposed = |by: f64| search.sign * by < 0.0;
                    changes.retain(|remedy| !change(remedy).into_iter().any(is_opposed));
                    if changes.is_empty() {
                        found.missing.push(NoRemedy::Opposed);
                    }
                }
                found.changes.extend(changes);
            }
        }
        None => found.missing.push(NoRemedy::Drawn),
    }
    if found.changes.is_empty() {
        let is_found =
            |reason: &NoRemedy| !matches!(reason, NoRemedy::NoDistance | NoRemedy::NoThickness(_));
        found.missing.retain(is_found);
        let spread = spread(study, verdict.runs);
        found.missing.push(spread.unwrap_or(NoRemedy::NotEnough));
    }
    // A search that was stopped has less effort.
    Error::if_stopped(tick(0))?;
    Ok(found)
}

/// The limits that the spread of `runs` exceeds: of all runs of a band, which move together, else of those at one distance.
fn spread(study: &Study, runs: &[RunExtremes]) -> Option<NoRemedy> {
    let value = |quantity: Quantity, run: &RunExtremes, end: End| {
        let (assembly, extreme) = run.with_clearance(end);
        let found = quantity.bracket(assembly, [extreme?.found(); 2], end == End::Greatest)?;
        Some(found[0])
    };
    let is_together = |one: &RunExtremes, other: &RunExtremes| {
        let distance = |run: &RunExtremes| run.assembly.center_distance();
        study.distance_band.is_some() || distance(one) == distance(other)
    };
    let of = |(quantity, limits): &(Quantity, Limits), first: &RunExtremes| {
        let limits = [limits.min?, limits.max?];
        let together = || runs.iter().filter(|run| is_together(first, run));
        let all = |end| together().map(move |run| value(*quantity, run, end));
        let least = all(End::Least).collect::<Option<Vec<f64>>>()?;
        let greatest = all(End::Greatest).collect::<Option<Vec<f64>>>()?;
        let least = least.into_iter().reduce(f64::min)?;
        let greatest = greatest.into_iter().reduce(f64::max)?;
        let here = first.assembly.center_distance();
        (greatest - least > limits[1] - limits[0]).then_some(NoRemedy::Spread {
            quantity: *quantity,
            distance: (!runs.iter().all(|run| is_together(first, run))).then_some(here),
            found: [least, greatest],
            limits,
        })
    };
    let mut each = study.requirements.iter();
    each.find_map(|limits| runs.iter().find_map(|first| of(limits, first)))
}

/// The run with the least backlash; the one with the greatest if the pair is too loose.
fn worst(runs: &[RunExtremes], too_tight: bool) -> Option<usize> {
    let slack = |run: &RunExtremes| {
        let bound = match (run.status, too_tight) {
            (Status::Jammed, true) => None,
            (_, true) => run.least.as_ref().map(|least| least.low),
            (_, false) => run.greatest.as_ref().map(|greatest| -greatest.high),
        };
        bound.unwrap_or(f64::NEG_INFINITY)
    };
    (0..runs.len()).min_by(|one, other| slack(&runs[*one]).total_cmp(&slack(&runs[*other])))
}

/// The search for one study.
struct Search<'a> {
    study: &'a Study,
    /// Every centre distance, material and phase.
    plans: &'a [CyclePlan<'a>],
    /// The index of the worst run, and its pair.
    worst: usize,
    pair: &'a AssembledPair,
    /// Wheel and pinion as stated; a reduction is of the gear before its factor.
    stated: [StatedGear; 2],
    /// 1 if the pair is too tight, −1 if it is too loose.
    sign: f64,
}

impl<'a> Search<'a> {
    /// The remedy by the centre distance.
    fn distance(&self, effort: &Effort) -> Result<Option<Remedy>, Error> {
        let own = self.pair.center_distance();
        // All distances of a band move together; the one distance replaces a list.
        let changed = |planned: &CyclePlan, at: f64| {
            let pair = &planned.run.assembly;
            let from = match self.study.distance_band {
                Some(_) => pair.center_distance(),
                None => own,
            };
            pair.at(from + (at - own)).ok()
        };
        let end = if self.sign > 0.0 {
            self.pair.reach()
        } else {
            0.0
        };
        let slope = |pair: &AssembledPair| {
            let angle = pair.operating_pressure_angle();
            angle.map_or(DRAWN_SLOPE, |angle| 2.0 * angle.tan())
        };
        let listed = &self.study.center_distances;
        let (origin, shown) = match self.study.distance_band {
            Some(_) => (own, listed[listed.len() / 2] - own),
            None => (0.0, 0.0),
        };
        let grids = [(origin, STEP)];
        let Some([fails, fits]) = self.between([own, end], &changed, &slope, &grids, effort)?
        else {
            return Ok(None);
        };
        let Some(found) = self.rounded(origin, fits, STEP, &changed, effort)? else {
            return Ok(None);
        };
        let bracket = [fails.min(fits), fails.max(fits)];
        Ok(Some(Remedy {
            what: Change::CenterDistance,
            gears: Gears::Both,
            value: to_step(found + shown, STEP),
            present: [listed[0], listed[listed.len() - 1]],
            bracket: bracket.map(|at| at + shown),
        }))
    }

    /// The remedies by the thickness of `gears`: by the flank offset where it states them, else by the allowance; for both gears by either.
    fn thickness(
        &self,
        teeth: &ThinnedTeeth,
        gears: Gears,
        effort: &Effort,
    ) -> Result<Vec<Remedy>, Error> {
        let own = [0, 1].map(|k| -teeth.material[k] / self.stated[k].scale);
        let changed = |planned: &CyclePlan, at: f64| {
            let change = |member: Member| {
                let reduced = own[member as usize] - at;
                let thicker = teeth.thickness * (self.scale(member) * reduced);
                GearChange {
                    thicker: gears.has(member).then_some(thicker),
                    ..GearChange::default()
                }
            };
            let assembly = &planned.run.assembly;
            let changes = Member::BOTH.map(change);
            assembly.varied(assembly.center_distance(), &changes).ok()
        };
        let of_each = gears
            .members()
            .map(|member| own[member as usize] * self.sign);
        let start = self.sign * of_each.fold(f64::INFINITY, f64::min);
        let scales = || gears.members().map(|member| self.scale(member));
        let most = teeth.most / scales().fold(0.0, f64::max);
        let range = [start, start + self.sign * most];
        let slope = |pair: &AssembledPair| {
            let teeth = cycle_pair(pair).thinned_teeth();
            teeth.map_or(f64::NAN, |teeth| scales().sum::<f64>() * teeth.slope)
        };
        // One flank offset of one gear is an allowance, unless the file states an offset.
        let by_offset = |member: Member| self.stated[member as usize].by_flank_offset;
        let by_offset = gears.members().all(by_offset);
        let has_offset = by_offset || gears == Gears::Both;
        let units = [
            (has_offset, Change::FlankOffset, teeth.per_offset),
            (!by_offset, Change::ThicknessAllowance, 1.0),
        ];
        let units = || units.into_iter().filter(|(is_stated, ..)| *is_stated);
        let grids: Vec<(f64, f64)> = units().map(|(.., unit)| (0.0, STEP * unit)).collect();
        let Some([fails, fits]) = self.between(range, &changed, &slope, &grids, effort)? else {
            return Ok(Vec::new());
        };
        let mut remedies = Vec::new();
        for (_, what, unit) in units() {
            let found = self.rounded(0.0, fits, STEP * unit, &changed, effort)?;
            let bracket = [-fails.max(fits), -fails.min(fits)];
            remedies.extend(found.map(|found| Remedy {
                what,
                gears,
                value: to_step(-found / unit, STEP),
                present: own.map(|own| -own / unit),
                bracket: bracket.map(|at| at / unit),
            }));
        }
        Ok(remedies)
    }

    fn scale(&self, member: Member) -> f64 {
        self.stated[member as usize].scale
    }

    /// A place at which the worst run does not fit and one at which it does, between its present place and the end of `range`. In the end no
    /// step of `grids`, each an origin and a step, lies between them.
    fn between(
        &self,
        [own, end]: [f64; 2],
        changed: &dyn Fn(&CyclePlan, f64) -> Option<AssembledPair>,
        slope: &dyn Fn(&AssembledPair) -> f64,
        grids: &[(f64, f64)],
        effort: &Effort,
    ) -> Result<Option<[f64; 2]>, Error> {
        let worst = &self.plans[self.worst];
        // Places count from the present one, towards the end.
        let place = |by: f64| own + self.sign * by;
        let value = |by: f64| -> Result<Option<(f64, ())>, Error> {
            let Some(pair) = changed(worst, place(by)) else {
                return Ok(None);
            };
            let margin = none_if_impossible(self.margin(worst, &pair, effort))?;
            Ok(margin.map(|margin| (margin, ())))
        };
        let slope = |by: f64| changed(worst, place(by)).map_or(f64::NAN, |pair| slope(&pair));
        let Some((now, ())) = value(0.0)?.filter(|(now, ())| *now < 0.0) else {
            return Ok(None);
        };
        let range = [0.0, (end - own).abs()];
        let is_close = |fails: f64, fits: f64| {
            let steps = |by: f64, &(origin, step): &(f64, f64)| self.steps(origin, place(by), step);
            let mut grids = grids.iter();
            grids.all(|grid| steps(fails, grid) == steps(fits, grid))
        };
        let found = threshold(range, now, slope, value, is_close, effort)?;
        Ok(found.map(|(fails, fits, ())| [place(fails), place(fits)]))
    }

    /// Steps from `origin` to the first one at or past `place`.
    fn steps(&self, origin: f64, place: f64, step: f64) -> f64 {
        ((self.sign * (place - origin) - NEAR) / step).ceil()
    }

    /// The first multiple of `step` from `origin` at or past `fits` at which every run fits.
    fn rounded(
        &self,
        origin: f64,
        fits: f64,
        step: f64,
        changed: &dyn Fn(&CyclePlan, f64) -> Option<AssembledPair>,
        effort: &Effort,
    ) -> Result<Option<f64>, Error> {
        let steps = self.steps(origin, fits, step);
        for more in 0..2 {
            let at = origin + self.sign * (steps + f64::from(more)) * step;
            if self.all_fit(at, changed, effort)? {
                return Ok(Some(at));
            }
        }
        Ok(None)
    }

    /// Whether each run fits, with neither too much nor too little backlash.
    fn all_fit(
        &self,
        at: f64,
        changed: &dyn Fn(&CyclePlan, f64) -> Option<AssembledPair>,
        effort: &Effort,
    ) -> Result<bool, Error> {
        for planned in self.plans {
            let Some(pair) = changed(planned, at) else {
                return Ok(false);
            };
            // Thicker teeth contain thinner ones: the thickest have the least backlash, the thinnest the greatest.
            let decides = |sign: &f64| {
                let decisive = if *sign > 0.0 {
                    Material::Most
                } else {
                    Material::Least
                };
                let is_other = |plan: &CyclePlan| plan.run.material != decisive;
                !is_other(planned) || self.plans.iter().all(is_other)
            };
            for sign in [self.sign, -self.sign].into_iter().filter(decides) {
                let search = Search { sign, ..*self };
                if effort.is_nearly_spent() {
                    return Ok(false);
                }
                let margin = none_if_impossible(search.margin(planned, &pair, effort))?;
                if margin.is_none_or(|margin| margin < 0.0) {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// Backlash of `pair` above the required least, mm of `j_wt`; for a pair that is too loose, below the allowed
    /// greatest. −∞ if no bound is known.
    fn margin(
        &self,
        planned: &CyclePlan,
        pair: &AssembledPair,
        effort: &Effort,
    ) -> Result<f64, Error> {
        let is_max = self.sign < 0.0;
        let limits = self.study.requirements.iter();
        let limit = |limits: &Limits| if is_max { limits.max } else { limits.min };
        let limits: Vec<(Quantity, f64)> = limits
            .filter_map(|(quantity, limits)| Some((*quantity, limit(limits)?)))
            .collect();
        let bound = |pair: &AssembledPair| -> Result<f64, Error> {
            let end = if is_max { End::Greatest } else { End::Least };
            let found = cycle_pair(pair).extremes_at(planned, end, effort)?;
            let found = found.at(end);
            Ok(found.map_or(
                f64::NEG_INFINITY,
                |end| if is_max { -end.high } else { end.low },
            ))
        };
        // Without a requirement, zero as in `RunExtremes::assembles`.
        let least = if is_max { f64::INFINITY } else { bound(pair)? };
        let mut margin = least + proven_width(pair);
        if limits.is_empty() || margin == f64::NEG_INFINITY {
            return Ok(margin);
        }
        let play = self.study.bearing_clearance;
        let Ok(moved) = pair.at(pair.center_distance() - self.sign * play) else {
            return Ok(f64::NEG_INFINITY);
        };
        let j_wt = if least.is_finite() && play == 0.0 {
            least
        } else {
            self.sign * bound(&moved)?
        };
        if !j_wt.is_finite() {
            return Ok(f64::NEG_INFINITY);
        }
        for (quantity, limit) in limits {
            let value = |j_wt: f64| {
                let bracket = quantity.bracket(&moved, [j_wt; 2], is_max);
                // A drawn pair without this quantity never meets a limit on it.
                bracket.map_or(-self.sign * f64::INFINITY, |ends| ends[usize::from(is_max)])
            };
            let per_mm = (value(j_wt + STEP) - value(j_wt)) / STEP;
            let per_mm = if per_mm > 0.0 && per_mm.is_finite() {
                per_mm
            } else {
                1.0
            };
            margin = margin.min(self.sign * (value(j_wt) - limit) / per_mm);
        }
        Ok(margin)
    }
}

/// `None` for gears that an eccentricity in the worst direction leaves without a tooth.
fn none_if_impossible(margin: Result<f64, Error>) -> Result<Option<f64>, Error> {
    match margin {
        Err(Error::Gear(_)) => Ok(None),
        margin => margin.map(Some),
    }
}

/// `value` as the nearest multiple of `step`, against rounding.
fn to_step(value: f64, step: f64) -> f64 {
    (value / step).round() * step
}
