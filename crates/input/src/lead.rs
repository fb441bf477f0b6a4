//! `[lead]`: deviations of the flanks along the face, for both flanks or each.
//!
//! Heights of the file count from the reference face's end of the teeth. A [`Lead`] counts heights from the measuring plane, away from
//! the reference face.

use super::helix::missing_face;
use super::known_gear::KnownGear;
use super::spec::{
    Either, EndReliefSpec, FlankLeadSpec, FlanksSpec, GearSpec, LeadSpec, ReliefEnd, ReliefShape,
    SlopeLength, SpurSlopeSpec, TeethEnd, TraceSpec,
};
use super::traces::{self, Along};
use gearlash::gear::{EndRelief, Flank, Hand, Lead, Trace};
use gearlash::metrology::LeadKey;
use gearlash_text::Table;
use gearlash_text::numbers::shortest;

const NAME: &str = "lead";
/// Share of the face width that the evaluation range leaves out at each end, unless one module is less; ISO 1328-1.
const END_SHARE: f64 = 0.05;

/// Face, evaluation range and zero of leads, and the share of a stated slope that the evaluation range has. Heights count from the reference
/// face's end of the teeth.
fn shape(
    [near, far]: [f64; 2],
    range_mm: [f64; 2],
    zero_mm: f64,
    over: SlopeLength,
) -> (Lead, f64) {
    let at = |height: f64| (near + height).clamp(near, far);
    let range = range_mm.map(at);
    let share = match over {
        SlopeLength::Range => 1.0,
        SlopeLength::Face => (range[1] - range[0]) / (far - near),
    };
    let lead = Lead {
        face: [near, far],
        range,
        zero: at(zero_mm),
        ..Lead::default()
    };
    (lead, share)
}

/// The evaluation range of a gear of this module that states none.
fn default_range(width: f64, module_mm: f64) -> [f64; 2] {
    let margin = (END_SHARE * width).min(module_mm);
    [margin, width - margin]
}

/// The leads of a gear as understood, to which further ones are added, with their [`shape`]; `None` without a face.
pub fn lead_base(gear: &GearSpec) -> Option<(LeadSpec, Lead, f64)> {
    let face = gear.heights()?;
    let mut spec = gear.lead.clone().unwrap_or_default();
    let range = default_range(face[1] - face[0], gear.module_mm);
    let (range, zero) = (
        spec.range_mm.unwrap_or(range),
        spec.zero_mm.unwrap_or(-face[0]),
    );
    (spec.range_mm, spec.zero_mm) = (Some(range), Some(zero));
    let scale = gear.scale();
    let (face, heights) = (face.map(|end| scale * end), range.map(|end| scale * end));
    let (shape, share) = shape(face, heights, scale * zero, spec.over);
    Some((spec, shape, share))
}

/// The leads of `gear` with the slopes and crownings, mm, of `further` ones of right and left flanks, which have its [`shape`].
pub fn with_added_leads(gear: &GearSpec, further: &[Lead; 2]) -> Option<LeadSpec> {
    let (mut spec, _, share) = lead_base(gear)?;
    let mut flanks = spec.flanks.flanks().map(FlankLeadSpec::clone);
    for (flank, further) in flanks.iter_mut().zip(further) {
        let um = 1e3 / gear.scale();
        *flank.slope_um.get_or_insert_default() += um * further.slope / share;
        *flank.crowning_um.get_or_insert_default() += um * further.crowning;
    }
    spec.flanks = FlanksSpec::new(flanks);
    Some(spec)
}

impl LeadSpec {
    /// The leads of the gear's table `gear` with defaults filled in, their traces as lists from the reference face in the transverse section.
    pub(crate) fn complete(mut self, gear: &Table, known: &KnownGear) -> Option<LeadSpec> {
        let table = gear.below(NAME);
        let helix = known.helix?;
        let Some(face) = known.heights()? else {
            return gear.refuse(
                "face_width_mm",
                missing_face(format!(", beside [{}]", gear.path_of(NAME))),
                "give the length of the teeth along the axis: leads run over all of it",
            );
        };
        let basic_data = known.basic_data?;
        let width = face[1] - face[0];
        let mut warnings = Vec::new();
        complete_hands(&table, &mut self.flanks, helix.teeth_hand(), &mut warnings)?;
        let plane = 0.0 - face[0];
        open_conventions(&table, &self, plane, helix.is_helical(), &mut warnings);
        known.warnings.borrow_mut().extend(warnings);

        let zero_mm = self.zero_mm.unwrap_or(plane);
        if !(0.0..=width).contains(&zero_mm) {
            let missing = if self.zero_mm.is_none() {
                "missing: the measuring plane is at "
            } else {
                ""
            };
            return table.refuse(
                "zero_mm",
                format!("{missing}height {zero_mm} mm, off the teeth: allowed is 0 … {width} mm"),
                "give the height at which pitch and thickness were measured, from the reference face's end of the teeth",
            );
        }
        let range_mm = default_range(width, known.module_mm?);
        let range_mm = self.range_mm.unwrap_or(range_mm);
        if !(0.0 <= range_mm[0] && range_mm[0] < range_mm[1] && range_mm[1] <= width) {
            return table.refuse(
                "range_mm",
                format!(
                    "no evaluation range, allowed are two heights, 0 … {width} mm, the lesser first"
                ),
                "write range_mm = [start, end], from the reference face's end of the teeth",
            );
        }
        let along = Along::Face {
            width,
            helix_cos: basic_data.base_helix_angle().cos(),
        };
        let mut flanks = traces::read_flanks(&table, self.flanks, known, along)?;
        if self.from == TeethEnd::Far {
            for flank in &mut flanks {
                flank.trace = flank.trace.take().map(|traces| match traces {
                    Either::One(one) => Either::One(turned(one, width)),
                    Either::Other(list) => {
                        Either::Other(list.into_iter().map(|one| turned(one, width)).collect())
                    }
                });
            }
        }
        Some(LeadSpec {
            flanks: FlanksSpec::new(flanks),
            zero_mm: Some(zero_mm),
            range_mm: Some(range_mm),
            from: TeethEnd::Reference,
            ..self
        })
    }

    /// The complete leads of right flanks and of left ones.
    pub(crate) fn for_metrology(&self, known: &KnownGear) -> Option<[Lead; 2]> {
        let (shape, share) = shape(known.heights()??, self.range_mm?, self.zero_mm?, self.over);
        let teeth_hand = known.helix?.teeth_hand().unwrap_or(Hand::Right);
        let [near, far] = shape.face;
        let point = |(height, um): (&f64, &f64)| ((near + height).clamp(near, far), um / 1000.0);
        let lead = |(own, flank): (Flank, &FlankLeadSpec)| {
            let turn = helix_slope(flank).map_or(0.0, |(um, hand)| {
                Lead::slope_of_helix(um, hand.unwrap_or(teeth_hand), own)
            });
            let reliefs = flank.end_relief.iter().flat_map(Either::as_list);
            let traces = flank.trace.iter().flat_map(Either::as_list);
            let trace = |trace: &TraceSpec| {
                let heights = trace.from_reference_face_mm.iter().flatten();
                let points = heights.zip(trace.deviation_um.iter().flatten());
                Trace {
                    tooth: trace.tooth,
                    points: points.map(point).collect(),
                }
            };
            Lead {
                slope: share * (flank.slope_um.unwrap_or(0.0) + turn) / 1000.0,
                crowning: flank.crowning_um.unwrap_or(0.0) / 1000.0,
                end_reliefs: reliefs.flat_map(end_reliefs).collect(),
                traces: traces.map(trace).collect(),
                ..shape.clone()
            }
        };
        let [right, left] = self.flanks.flanks();
        Some([(Flank::Right, right), (Flank::Left, left)].map(lead))
    }
}

/// The key, below the gear's table, that states `key` of a flank.
pub fn key_of(gear: &Table, flank: Flank, key: LeadKey) -> String {
    match key {
        LeadKey::EndRelief => traces::key_of(gear, NAME, flank, "end_relief"),
        LeadKey::Trace => traces::key_of(gear, NAME, flank, "trace"),
        LeadKey::Range => format!("{NAME}.range_mm"),
        LeadKey::All => NAME.to_owned(),
    }
}

/// Reports keys that are given for both flanks and again for one.
pub fn check(gear: &Table) -> Option<()> {
    traces::check_flanks(gear, NAME)
}

/// Gives each helix slope of a spur gear its hand, the right one where it is positive. `helix` is the hand of helical teeth.
fn complete_hands(
    table: &Table,
    flanks: &mut FlanksSpec<FlankLeadSpec>,
    helix: Option<Hand>,
    warnings: &mut Vec<String>,
) -> Option<()> {
    const KEY: &str = "helix_slope_um";
    let tables = [
        (table.clone(), Some(&mut flanks.both)),
        (table.below(Flank::Right.name()), flanks.right.as_mut()),
        (table.below(Flank::Left.name()), flanks.left.as_mut()),
    ];
    let mut read_as = None;
    for (table, flank) in tables {
        let Some(slope) = flank.and_then(|flank| flank.helix_slope_um.as_mut()) else {
            continue;
        };
        match (&*slope, helix) {
            (Either::Other(_), Some(hand)) => {
                return table.refuse(
                    KEY,
                    format!(
                        "the gear is {}-hand, allowed is a number of µm, + = greater helix angle",
                        hand.name()
                    ),
                    "write a number",
                );
            }
            (Either::One(um), None) => {
                let hand = if *um < 0.0 { Hand::Left } else { Hand::Right };
                let stated = SpurSlopeSpec::new(um.abs(), hand);
                read_as.get_or_insert((table.path_of(KEY), *um, hand));
                *slope = Either::Other(stated);
            }
            _ => {}
        }
    }
    warnings.extend(read_as.map(|(key, um, hand)| {
        format!(
            "{key}: {um} µm of a spur gear without a hand counts as {}-hand; write \"{size} r\" or \"{size} l\"",
            hand.name(),
            size = um.abs()
        )
    }));
    Some(())
}

/// Warnings of conventions that values depend on and that `spec` does not state. `plane` is the height of the measuring plane, mm.
fn open_conventions(
    table: &Table,
    spec: &LeadSpec,
    plane: f64,
    is_helical: bool,
    warnings: &mut Vec<String>,
) {
    let FlanksSpec { both, right, left } = &spec.flanks;
    let flanks = || {
        [Some(both), right.as_ref(), left.as_ref()]
            .into_iter()
            .flatten()
    };
    let has = |is_stated: fn(&FlankLeadSpec) -> bool| flanks().any(is_stated);
    let has_slopes = has(|flank| flank.slope_um.is_some() || flank.helix_slope_um.is_some());
    let has_traces = has(|flank| flank.trace.is_some());
    let has_ends = has(|flank| flank.crowning_um.is_some() || flank.end_relief.is_some());
    let traces = || flanks().flat_map(|flank| flank.trace.iter().flat_map(Either::as_list));
    let has_teeth = traces().any(|trace| trace.tooth.is_some() || trace.table.is_some());
    let lacks_direction = traces().any(|trace| trace.direction.is_none());
    let conventions = [
        (
            "over",
            has_slopes,
            "slopes refer to the evaluation range; write over = \"range\", or \"face\" where they are over the whole width".to_owned(),
        ),
        (
            "from",
            has_traces,
            "heights of traces count from the reference face; write from = \"reference\", or \"far\" where they begin at the other end".to_owned(),
        ),
        (
            "axis",
            has_teeth,
            "traces count as measured about the axis of the teeth; write axis = \"own\", or \"datum\" where it was the bore".to_owned(),
        ),
        (
            "zero_mm",
            has_slopes || has_ends || has_traces,
            format!(
                "pitch and thickness count as measured in the measuring plane, at height {height} mm; write zero_mm = {height}, or the height where they were",
                height = shortest(plane)
            ),
        ),
        (
            "trace.direction",
            is_helical && lacks_direction,
            "deviations of traces count in the transverse section; write direction = \"transverse\", or \"normal\" where they are square to the teeth".to_owned(),
        ),
    ];
    for (key, is_needed, words) in conventions {
        if is_needed && !table.has(key) {
            warnings.push(format!("{}: not stated, {words}", table.path_of(key)));
        }
    }
}

/// The helix slope of a flank, µm, and its hand where it states one.
fn helix_slope(flank: &FlankLeadSpec) -> Option<(f64, Option<Hand>)> {
    match flank.helix_slope_um.as_ref()? {
        Either::One(um) => Some((*um, None)),
        Either::Other(stated) => stated.parsed().map(|(um, hand)| (um, Some(hand))),
    }
}

fn end_reliefs(spec: &EndReliefSpec) -> Vec<EndRelief> {
    let ends: &[bool] = match spec.end {
        ReliefEnd::Reference => &[false],
        ReliefEnd::Far => &[true],
        ReliefEnd::Both => &[false, true],
    };
    let relief = |at_far_end: &bool| EndRelief {
        amount: spec.um / 1000.0,
        length: spec.length_mm,
        at_far_end: *at_far_end,
        parabolic: spec.shape == ReliefShape::Parabolic,
    };
    ends.iter().map(relief).collect()
}

/// A trace whose heights count from the other end of teeth of this `width`.
fn turned(mut trace: TraceSpec, width: f64) -> TraceSpec {
    if let Some(heights) = &mut trace.from_reference_face_mm {
        for height in heights.iter_mut() {
            *height = width - *height;
        }
        heights.reverse();
    }
    if let Some(deviations) = &mut trace.deviation_um {
        deviations.reverse();
    }
    trace
}
