//! From a pair file with `[tolerance]` to a population.

use crate::files::PairFile;
use crate::spec::{
    GearSpec, GearToleranceSpec, PhaseName, ScatterName, ScatterSpec, SpreadSpec, ToleranceSpec,
};
use crate::temperature::REFERENCE_C;
use crate::tolerance::gears::{
    MeasuredGear, gears, repeated_thickness, thickness_band, unused_band_warnings,
};
use crate::{common_face, lead, pair, with_file};
use gearlash::analysis::phases::phase;
use gearlash::error::GearError;
use gearlash::gear::{AsBuilt, GradedQuantity, Lead, PitchAxis, Side};
use gearlash::outline::{AssembledPair, GearChange};
use gearlash::pair::{Mating, Member, SweepPlan};
use gearlash::population::{
    AssemblyLimits, GearScatter, LIMIT_SIGMAS, LeadScatter, Population, PopulationError, Scatter,
    ScatterError, Scatters,
};
use gearlash_text::numbers::um_ascii;
use gearlash_text::{InputError, Table};
use std::path::Path;

/// A pair file with `[tolerance]`, understood.
#[derive(Debug, Clone, PartialEq)]
pub struct ToleranceFile {
    /// The pair.
    pub pair: PairFile,
    /// Its table `[tolerance]`, defaults filled in.
    pub tolerance: ToleranceSpec,
    /// The population.
    pub population: Population,
    /// The limits that each assembly must keep.
    pub requirement: AssemblyLimits,
    /// The measured gears to take from, for wheel and pinion.
    pub(super) measured: [Vec<MeasuredGear>; 2],
    /// Warnings about it, in addition to those of the pair.
    pub warnings: Vec<String>,
}

/// Reads the pair file at `path`, which has `[tolerance]`, with the gears that it names.
///
/// # Errors
/// As [`crate::read`].
pub fn read_tolerance(path: &Path) -> Result<ToleranceFile, InputError> {
    with_file(path, |file| tolerance_file(pair(file)?, file))
}

fn tolerance_file(mut pair: PairFile, file: &Table) -> Option<ToleranceFile> {
    let Some(tolerance) = pair.spec.tolerance.clone() else {
        return file.refuse(
            "tolerance",
            "missing: it says how the numbers of the pair scatter",
            "add [tolerance], such as center_distance = { scatter = \"normal\", sigma_um = 5 }",
        );
    };
    // Its problems come first. A drawn gear can give the pair a face.
    let nominal = nominal_distance(&pair, file);
    let band = pair
        .study
        .distance_band
        .zip(pair.spec.assembly.single_distance_mm());
    let band = band.map(|(band, nominal)| band.map(|mm| mm - nominal));
    let place = (file, "tolerance.center_distance");
    let center_distance = scatter(&tolerance.center_distance, band, place);
    let place = (file, "tolerance.bearing_play");
    let bearing_clearance = scatter(&tolerance.bearing_play, None, place);
    let bearing_clearance = bearing_clearance.and_then(|made| not_negative(made, place));
    let mut warnings = unused_band_warnings(&pair, &tolerance);
    let mut gear = |spec, member| gear(spec, member, &pair, (file, &mut warnings));
    let wheel = gear(&tolerance.wheel, Member::Wheel);
    let pinion = gear(&tolerance.pinion, Member::Pinion);
    let lean = lean(&tolerance, &pair, file);
    let ((wheel, wheels), (pinion, pinions)) = (wheel?, pinion?);
    let scatters = Scatters {
        wheel,
        pinion,
        center_distance: center_distance?,
        lean: lean?,
        bearing_clearance: bearing_clearance?,
        phase: tolerance.phase == PhaseName::Any,
        thickness_correlation: tolerance.thickness_correlation,
    };
    let has_profile = |gears: [&GearSpec; 2]| gears.iter().any(|gear| gear.profile.is_some());
    if scatters.lean() && pair.spec.by_data().is_some_and(has_profile) {
        return file.refuse(
            "tolerance",
            "wobble or axes scatter beside profile deviations: sections of such teeth are not worked out",
            "leave out the wobble and the misalignment, or the profile",
        );
    }
    let measured = [&wheels, &pinions].map(|gears| gears.iter().map(|one| &one.gear));
    let why = if scatters.vary_along_face() {
        Some("lead, wobble or axes scatter")
    } else {
        common_face::reason_of_gears(measured.into_iter().flatten())
    };
    file.reading().keep(common_face::add_to(&mut pair, why))?;
    for (member, gears) in [(Member::Wheel, &wheels), (Member::Pinion, &pinions)] {
        let mut gears = gears.iter();
        if let Some(other) = gears.find_map(|one| shape_difference(&one.spec, &pair, member)) {
            let help = "name gears whose teeth wind and end as those of the pair";
            return file.refuse(&format!("tolerance.{}.gears", member.name()), other, help);
        }
    }
    let mean = mean_pair(&pair, nominal?, file)?;
    let first = marked_tooth(&pair, &mean);
    let population = Population::new(mean, scatters).map_err(|error| refused(file, &error));
    let population = file.reading().keep(population)?;
    let clearance = pair.study.bearing_clearance;
    let requirement = AssemblyLimits::of(&pair.study.requirements);
    Some(ToleranceFile {
        tolerance,
        population: population
            .with_bearing_clearance(clearance)
            .with_phase(first),
        requirement,
        measured: [wheels, pinions],
        warnings,
        pair: PairFile {
            sources: file.reading().sources(),
            ..pair
        },
    })
}

/// The nominal centre distance of a pair that can scatter, mm.
fn nominal_distance(pair: &PairFile, file: &Table) -> Option<f64> {
    let spec = &pair.spec.assembly;
    if spec.temperature_c.is_some_and(|c| c != REFERENCE_C) {
        return file.refuse(
            "assembly.temperature_c",
            "given together with tolerance, whose numbers are those of 20 °C",
            "remove the temperature",
        );
    }
    let tilts = pair.study.bearing_ends.is_some();
    if pair.study.open_lean != [0.0; 2] || tilts {
        return file.refuse(
            if tilts {
                "assembly.bearing_clearance_mm.at_mm"
            } else {
                "assembly.misalignment"
            },
            "given together with tolerance, which draws no axes that lean",
            "state signed deviations and one clearance for each gear",
        );
    }
    spec.single_distance_mm().or_else(|| {
        file.refuse(
            "assembly.center_distance_mm",
            "several distances, tolerance needs the one about which it scatters",
            "give one, or { nominal_mm = …, tolerance_um = … }",
        )
    })
}

/// The mean pair of the population at a centre distance, mm: the middle of thickness bands.
fn mean_pair(pair: &PairFile, distance: f64, file: &Table) -> Option<AssembledPair> {
    let study = &pair.study;
    let is_lost = |member: &Member| {
        let ends = study.drawn.first().zip(study.drawn.last());
        let differ = ends.is_some_and(|((_, wheel, pinion), (_, other, others))| {
            [wheel != other, pinion != others][*member as usize]
        });
        differ && thickness_band(pair, *member).is_none()
    };
    if let Some(member) = Member::BOTH.into_iter().find(is_lost) {
        return file.refuse(
            &format!("{}.thickness", member.name()),
            "states a band, and beside an outline a gear by its data has one thickness",
            "state one thickness",
        );
    }
    let change = |member: Member| GearChange {
        thicker: thickness_band(pair, member).map(|[thinner, _]| thinner),
        ..GearChange::default()
    };
    let made = study.pairs(distance).and_then(|pairs| {
        let (_, most) = pairs.first().ok_or(GearError::ThicknessField)?;
        most.varied(distance, &Member::BOTH.map(change))
    });
    file.keep("tolerance", made, "correct the gears, or their distance")
}

/// The scatter of the lean of the pinion's axis in and out of the plane of the axes, mm per mm.
fn lean(tolerance: &ToleranceSpec, pair: &PairFile, file: &Table) -> Option<[Option<Scatter>; 2]> {
    const KEY: &str = "tolerance.misalignment";
    let Some(stated) = tolerance.misalignment else {
        return Some([None, None]);
    };
    let assembly = &pair.spec.assembly;
    let Some(over_mm) = assembly.over_mm() else {
        return file.refuse(
            KEY,
            "given without assembly.misalignment, to whose length it refers",
            "add misalignment = { over_mm = … } to [assembly], or remove it",
        );
    };
    if stated.in_plane_um.is_some() && assembly.distance_place_mm() != 0.0 {
        return file.refuse(
            &format!("{KEY}.in_plane_um"),
            "given beside a centre distance that holds off the wheel's measuring plane",
            "state the centre distance in that plane, at_mm = 0",
        );
    }
    let one = |spec: Option<SpreadSpec>, name: &str| {
        spread(spec, 1e3 * over_mm, false, (file, &format!("{KEY}.{name}")))
    };
    Some([
        one(stated.in_plane_um, "in_plane_um")?,
        one(stated.out_of_plane_um, "out_of_plane_um")?,
    ])
}

fn gear(
    spec: &Option<GearToleranceSpec>,
    member: Member,
    pair: &PairFile,
    (file, warnings): (&Table, &mut Vec<String>),
) -> Option<(GearScatter, Vec<MeasuredGear>)> {
    let Some(spec) = spec else {
        return Some((GearScatter::default(), Vec::new()));
    };
    let key = |name: &str| format!("tolerance.{}.{name}", member.name());
    let one =
        |spec: &Option<ScatterSpec>, name: &str, band| scatter(spec, band, (file, &key(name)));
    let thickness = one(&spec.thickness, "thickness", thickness_band(pair, member));
    let repeated = thickness.as_ref().and_then(Option::as_ref);
    warnings.extend(repeated.and_then(|drawn| repeated_thickness(pair, member, drawn)));
    let runout = one(&spec.runout, "runout", None);
    let runout = runout.and_then(|made| not_negative(made, (file, &key("runout"))));
    let Some((_, wheel, pinion)) = pair.study.materials.first() else {
        // Other keys are refused with a pair that has an outline.
        let scatters = GearScatter {
            thickness: thickness?,
            runout: runout?,
            ..GearScatter::default()
        };
        return Some((scatters, Vec::new()));
    };
    let per_tooth = one(&spec.per_tooth, "per_tooth", None);
    let gear = [wheel, pinion][member as usize];
    let pitch = match spec.pitch.map(|pitch| (pitch.sigma_um, pitch.grade)) {
        Some((Some(sigma), _)) => Some(Some(1e-3 * sigma)),
        Some((None, Some(grade))) => {
            let found = GradedQuantity::SinglePitch.tolerance(gear.gear().basic_data(), grade);
            let found = file.keep(&key("pitch"), found, "give sigma_um in place of the grade");
            found.map(|tolerance| Some(tolerance / 3.0))
        }
        _ => Some(None),
    };
    let own = pair.spec.data(member)?;
    let of_datum = own
        .lead
        .as_ref()
        .is_some_and(|lead| lead.axis == PitchAxis::Datum);
    if spec.runout.is_some() && of_datum && own.is_helical() {
        return file.refuse(
            &key("runout"),
            "given beside helical leads about the datum axis, which contain the runout that was measured",
            "state the leads about the axis of the teeth, axis = \"own\"",
        );
    }
    // A pair without a face is refused below.
    let none = Lead {
        face: [0.0, 1.0],
        ..Lead::default()
    };
    let shape = lead::lead_base(own).map(|(_, shape, share)| (shape, share));
    let (shape, share) = shape.unwrap_or((none, 1.0));
    let width_mm = shape.face[1] - shape.face[0];
    let one_spread = |spec: Option<SpreadSpec>, name: &str, um, is_vector| {
        spread(spec, um, is_vector, (file, &key(name)))
    };
    let wobble = one_spread(spec.wobble_um, "wobble_um", 1e3 * width_mm, true);
    let leads = spec.lead.unwrap_or_default();
    let slope = one_spread(leads.slope_um, "lead.slope_um", 1e3 / share, false);
    let crowning = one_spread(leads.crowning_um, "lead.crowning_um", 1e3, false);
    let lead = LeadScatter {
        shape,
        slope: slope?,
        crowning: crowning?,
    };
    let has_lead = lead.slope.is_some() || lead.crowning.is_some();
    let measured = match &spec.gears {
        None => Some(Vec::new()),
        Some(names) => {
            let key = key("gears");
            let found = file
                .reading()
                .list(&key, || gears(names, member, (file, &key)));
            found.map(|(gears, further)| {
                warnings.extend(further);
                gears
            })
        }
    }?;
    let turned = |one: &MeasuredGear| placed(one.gear.facing(gear.face()), pair, member);
    let whole = (!measured.is_empty()).then(|| measured.iter().map(turned).collect());
    Some((
        GearScatter {
            thickness: thickness?,
            runout: runout?,
            pitch: pitch?,
            per_tooth: per_tooth?,
            lead: has_lead.then_some(lead),
            wobble: wobble?,
            gears: whole,
        },
        measured,
    ))
}

/// The difference of the helix or face of `gear` from the pair's `member`; `None` where they agree, or where nothing varies along the face.
pub(crate) fn shape_difference(gear: &GearSpec, pair: &PairFile, member: Member) -> Option<String> {
    let (own, name) = (pair.spec.data(member)?, member.name());
    if pair.study.face == [0.0; 2] {
        return None;
    }
    let ends = |gear: &GearSpec| Some(gear.heights()?.map(|end| gear.scale() * end));
    let other = if gear.hand != own.hand {
        "hand"
    } else if ends(gear) != ends(own) {
        "face_mm"
    } else {
        return None;
    };
    Some(format!(
        "{other} is another than {name}.{other} of the pair file"
    ))
}

/// A gear placed as the pair's `member`. The teeth of a pinion that varies along its face are counted in the wheel's measuring plane.
pub(crate) fn placed(gear: AsBuilt, pair: &PairFile, member: Member) -> AsBuilt {
    match pair.spec.assembly.face_offset_mm {
        Some(offset)
            if member == Member::Pinion
                && (pair.study.is_helical() || gear.has_leads() || gear.wobble() > 0.0) =>
        {
            gear.section_at(-offset)
        }
        _ => gear,
    }
}

/// The problem of an impossible population, at its key.
fn refused(file: &Table, error: &PopulationError) -> gearlash_text::Problem {
    let (key, help) = match error {
        PopulationError::Correlation(_) | PopulationError::NothingToCorrelate => (
            "tolerance.thickness_correlation",
            "remove it, or give both gears a thickness",
        ),
        PopulationError::Drawn => (
            "tolerance",
            "leave out the thickness of the gear by its data",
        ),
        PopulationError::OtherGear { .. } => (
            "tolerance",
            "name gears with the teeth, module and pressure angle of the pair's",
        ),
        PopulationError::Nothing => (
            "tolerance",
            "give at least one distribution, such as center_distance = { scatter = \"normal\", sigma_um = 5 }",
        ),
        PopulationError::Negative { .. }
        | PopulationError::Pitch(_)
        | PopulationError::WholeGears
        | PopulationError::NoFace => ("tolerance", "correct it"),
    };
    file.problem(key, error.to_string(), help)
}

/// The pinion tooth that meets wheel tooth 1, for gears that are always assembled as at the start of the sweep.
fn marked_tooth(pair: &PairFile, own: &AssembledPair) -> u32 {
    let Some(SweepPlan::Revolution { start, .. }) = pair.study.sweep else {
        return 1;
    };
    let mating = Mating {
        wheel_tooth: start.0,
        pinion_tooth: start.1,
        flank: Side::Right,
        fraction: 0.0,
    };
    phase(own, &mating)
}

const MM_PER_UM: f64 = 1e-3;

/// The normal distribution about 0, or that of the amount of a vector, at `key` of the pair file, in units of `um` µm; `Some(None)` where
/// none is stated.
fn spread(
    spec: Option<SpreadSpec>,
    um: f64,
    is_vector: bool,
    (file, key): (&Table, &str),
) -> Option<Option<Scatter>> {
    let Some(spec) = spec else {
        return Some(None);
    };
    let made = match (spec.sigma, spec.max.unwrap_or_default()) {
        (Some(sigma), _) if is_vector => Scatter::rayleigh(sigma / um),
        (None, max) if is_vector => Scatter::rayleigh_below(max / um),
        (Some(sigma), _) => Scatter::normal(0.0, sigma / um),
        (None, max) => Scatter::normal(0.0, max / LIMIT_SIGMAS / um),
    };
    file.keep(key, made, "correct the number").map(Some)
}

/// `made`, if no value is below 0.
fn not_negative(made: Option<Scatter>, (file, key): (&Table, &str)) -> Option<Option<Scatter>> {
    let Some(negative) = made.as_ref().filter(|made| made.least() < 0.0) else {
        return Some(made);
    };
    let reason = if negative.is_bounded() {
        let least = um_ascii(negative.least(), 1);
        format!("reaches {least} µm, it cannot be below 0")
    } else {
        "it cannot be below 0, and a normal distribution is not cut at its limits".to_owned()
    };
    file.refuse(
        key,
        reason,
        "take a rayleigh distribution, or one that ends at 0 or above",
    )
}

/// The distribution at `key` of the pair file, mm; `Some(None)` where none is stated. Absent limits are those of the `band`, mm.
fn scatter(
    spec: &Option<ScatterSpec>,
    band: Option<[f64; 2]>,
    (file, key): (&Table, &str),
) -> Option<Option<Scatter>> {
    let Some(spec) = spec else {
        return Some(None);
    };
    let limits = match (spec.lower_um, spec.upper_um) {
        (Some(low), Some(high)) => Some([low * MM_PER_UM, high * MM_PER_UM]),
        _ => band,
    };
    let middle = |limits: [f64; 2]| 0.5 * (limits[0] + limits[1]);
    let um = |value: Option<f64>| value.map(|um| um * MM_PER_UM);
    let within = |of: &dyn Fn([f64; 2]) -> Result<Scatter, ScatterError>| limits.map(of);
    let made = match spec.scatter {
        ScatterName::Fixed => um(spec.value_um).map(Scatter::fixed),
        ScatterName::Uniform => within(&|[low, high]| Scatter::uniform(low, high)),
        ScatterName::Triangular => within(&|[low, high]| {
            let mode = um(spec.mode_um).unwrap_or(middle([low, high]));
            Scatter::triangular(low, mode, high)
        }),
        ScatterName::Normal => match um(spec.sigma_um) {
            Some(sigma) => Some(Scatter::normal(um(spec.mean_um).unwrap_or(0.0), sigma)),
            None => within(&|[low, high]| {
                let mean = um(spec.mean_um).unwrap_or(middle([low, high]));
                Scatter::normal_within(low, high, mean, spec.cpk.unwrap_or(1.0))
            }),
        },
        ScatterName::Rayleigh => match (um(spec.scale_um), um(spec.upper_um)) {
            (Some(scale), _) => Some(Scatter::rayleigh(scale)),
            (None, Some(high)) => Some(Scatter::rayleigh_below(high)),
            (None, None) => None,
        },
        ScatterName::Table => spec.values_um.as_ref().map(|values| {
            let values: Vec<f64> = values.iter().map(|um| um * MM_PER_UM).collect();
            Scatter::table(&values)
        }),
    };
    let Some(made) = made else {
        let reason = "has no limits, and the pair file states no band that they could be";
        return file.refuse(key, reason, "give lower_um and upper_um");
    };
    // The library's message has numbers in mm, another unit than the file.
    let made = made.map_err(|error| match error {
        ScatterError::Limits { .. } => "the lower limit lies above the upper one".to_owned(),
        ScatterError::Outside { what, .. } if spec.lower_um.and(spec.upper_um).is_none() => {
            format!(
                "{what} lies outside the limits, which count from the middle of the stated band"
            )
        }
        ScatterError::Outside { what, .. } => format!("{what} lies outside the limits"),
        ScatterError::NotPositive { what, .. } => format!("{what} is not above 0"),
        other => other.to_string(),
    });
    let help = "correct the numbers of this distribution";
    file.keep(key, made, help).map(Some)
}
