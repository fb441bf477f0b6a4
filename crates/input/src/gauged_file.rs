//! A gear file that states the gauges' readings.
//!
//! The pitch of both flanks already contains the variation of thickness from tooth to tooth. Only the mean thickness is stated
//! beside it: per-tooth values would count twice. All teeth differ equally from the mean thickness that cut
//! the root; this is stated per tooth (see [`StatedThickness`]). Flanks that vary opposite to each other come from
//! thickness alone and look like a reversed left flank. The spans show that the sign is right, so they become a cross-check where
//! they are not the statement.

use crate::spec::{
    CrossCheckSpec, Either, GearFileSpec, GearSpec, LeadSpec, LengthSpec, PitchSpec,
    RunoutPlaneSpec, RunoutSpec, SpanSpec, StatementSpec, ThicknessSpec,
};
use gearlash::gauge::{Gauged, SectionReadings, Spans, StatedThickness, Unmeasured};
use gearlash::gear::Flank;
use gearlash_text::characters::plain;

/// Reasons for no gear file.
#[derive(Debug, thiserror::Error)]
pub enum NoGearFile {
    /// The readings are incomplete. A file without some of them would describe another gear.
    #[error(transparent)]
    Unmeasured(#[from] Unmeasured),
    /// The gear's table cannot be scaled.
    #[error(transparent)]
    Unscaled(#[from] serde_json::Error),
    /// It cannot be written as TOML.
    #[error(transparent)]
    Unwritable(#[from] toml::ser::Error),
}

/// The gear file, as TOML, of a gear that was understood as `spec`; `name` describes it in a few words.
///
/// # Errors
/// [`NoGearFile`].
pub fn gauged_file(
    title: &str,
    name: &str,
    spec: &GearSpec,
    readings: &Gauged,
) -> Result<String, NoGearFile> {
    let spec = &spec.scaled()?;
    let mut comments = vec![
        format!("What gearlash's gauges read on this gear ({name})."),
        "The thickness is the mean: the pitch carries how it varies. The runout is twice the eccentricity, which the tip circle shows.".to_owned(),
    ];
    let thickness = thickness(spec.teeth, readings, &mut comments)?;
    let eccentricity = readings.eccentricity.as_ref().map_err(Clone::clone)?;
    let pitch = readings.pitch_own.as_ref().map_err(Clone::clone)?;
    let pitch = |flank| Some(um(pitch.cumulative.flank(flank)));
    let file = GearFileSpec {
        title: format!("{}, as gauged", plain(title)),
        gear: GearSpec {
            thickness,
            runout: planes(readings).unwrap_or(RunoutSpec {
                total_um: Some(2e3 * eccentricity.amount),
                high_tooth: Some(eccentricity.high_tooth),
                ..RunoutSpec::default()
            }),
            pitch: Some(PitchSpec {
                right_um: pitch(Flank::Right),
                left_um: pitch(Flank::Left),
                ..PitchSpec::default()
            }),
            // Thickness and pitch were read in the measuring plane.
            lead: spec.lead.clone().map(|lead| LeadSpec {
                zero_mm: spec.heights().map(|[from, _]| 0.0 - from),
                ..lead
            }),
            ..spec.clone()
        },
    };
    let comments: String = comments.iter().map(|line| format!("# {line}\n")).collect();
    Ok(comments + &toml::to_string(&file)?)
}

/// The runout in the first and the last plane of a gear that wobbles.
fn planes(readings: &Gauged) -> Option<RunoutSpec> {
    let along_face = readings.along_face.as_ref();
    let sections = &along_face
        .filter(|face| face.face_runout.amount > 0.0)?
        .sections;
    let plane = |section: &SectionReadings| RunoutPlaneSpec {
        from_reference_face_mm: section.height,
        total_um: 2e3 * section.eccentricity.amount,
        high_tooth: section.eccentricity.high_tooth,
    };
    let order =
        |one: &&SectionReadings, other: &&SectionReadings| one.height.total_cmp(&other.height);
    let ends = [
        sections.iter().min_by(order)?,
        sections.iter().max_by(order)?,
    ];
    Some(RunoutSpec {
        total_um: None,
        planes: Some(ends.map(plane)),
        ..RunoutSpec::default()
    })
}

fn thickness(
    teeth: u32,
    readings: &Gauged,
    comments: &mut Vec<String>,
) -> Result<ThicknessSpec, Unmeasured> {
    let stated = readings.stated.clone()?;
    if let Err(reason) = &readings.root {
        comments.push(format!(
            "{reason}: that this mean thickness cut the root is taken for granted."
        ));
    }
    let span = |spans: &Spans, per_tooth: Option<bool>| {
        let lengths = spans.readings.iter().map(|span| span.length).collect();
        let first = spans.readings.iter().map(|span| span.first_tooth).collect();
        StatementSpec {
            span: Some(SpanSpec {
                teeth: spans.teeth,
                length: LengthSpec {
                    mm: Some(Either::Other(lengths)),
                    ..LengthSpec::default()
                },
                first_tooth: Some(first),
                per_tooth,
                table: None,
            }),
            ..StatementSpec::default()
        }
    };
    let mut thickness = ThicknessSpec::default();
    match (stated, &readings.spans) {
        (StatedThickness::Spans, spans) => {
            let spans = spans.as_ref().map_err(Clone::clone)?;
            thickness.statement = span(spans, Some(false));
        }
        (
            StatedThickness::Allowance {
                allowance,
                per_tooth,
                cross_check,
            },
            spans,
        ) => {
            thickness.statement.allowance_um = Some(Either::One(1e3 * allowance));
            if per_tooth != 0.0 {
                comments.push("The root circle was cut for the allowance; every flank pair stands off it by per_tooth_um.".to_owned());
                thickness.per_tooth_um = Some(vec![1e3 * per_tooth; teeth as usize]);
            }
            if cross_check && let Ok(spans) = spans {
                comments.push("The cross-check confirms the sign of the flanks.".to_owned());
                thickness.cross_check = Some(CrossCheckSpec {
                    statement: span(spans, None),
                    tolerance_um: None,
                });
            }
        }
    }
    Ok(thickness)
}

/// mm to µm.
fn um(lengths: &[f64]) -> Vec<f64> {
    lengths.iter().map(|mm| mm * 1e3).collect()
}
