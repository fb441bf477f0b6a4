//! Whether the first harmonic of pitch is that of an eccentricity: of both flanks jointly.

use super::eccentricity::apart_um;
use super::finding::{Finding, RunoutSource};
use super::notes::Eccentricity;
use super::pitch_statement::{EccentricitySource, PitchStatement};
use super::settle::Flanks;
use crate::gear::{Flank, Pitch};

/// The part of the stated eccentricity that may be missing for own-axis pitch to look as if it held it. An error of a quarter
/// lies within 25 % of the amount and, by its sine, within 14.5° of the direction. That is what an own harmonic or noise of
/// a quarter of it does; a harmonic of the gear's own, of any direction and up to twice the amount, comes there once in 64 times.
const SAME: f64 = 0.25;
/// The part of the first harmonics' energy that an eccentricity may leave. A wave that moves both flanks of a tooth alike leaves
/// `sin² (α − π/(2z))`, 0.1 at 20°; noise of a tenth of an eccentricity, at 20 teeth, leaves some 0.001.
const NOT_JOINT: f64 = 0.05;
/// Standard deviations by which that harmonic must stand out from what else the pitch holds: of white deviations it does so
/// once in e^(4²/2) = 3000 times.
const STANDS_OUT: f64 = 4.0;

/// What the first harmonic of `pitch`, with its curves as `measured`, says; `by_readings`: so is the runout stated.
pub(super) fn finding(
    pitch: &PitchStatement,
    measured: &Pitch,
    by_readings: bool,
    flanks: &Flanks,
) -> Option<Finding> {
    match pitch.is_datum() {
        true => not_joint(pitch, measured, flanks),
        false => held(measured, by_readings, flanks),
    }
}

/// Where own-axis pitch holds the very eccentricity of the runout, both flanks jointly.
fn held(measured: &Pitch, by_readings: bool, flanks: &Flanks) -> Option<Finding> {
    let gear = flanks.gears.most();
    let in_runout = flanks.in_runout.filter(|stated| stated.um > 0.0)?;
    let found = measured.separate_eccentricity(gear).ok()?;
    let in_pitch = Eccentricity {
        um: 1000.0 * found.eccentricity,
        high_tooth: found.high_tooth,
    };
    // As of the least squares of `datum`: deviations of s leave s cos α/√z in either part of the eccentricity.
    let basic_data = gear.basic_data();
    let rest = Flank::BOTH.map(|side| found.pitch.flank(side).iter().map(|f| f * f).sum::<f64>());
    let z = f64::from(basic_data.teeth());
    let free = (2.0 * z - 4.0).max(1.0);
    let deviation =
        (rest.iter().sum::<f64>() / free / z).sqrt() * basic_data.transverse_pressure_angle().cos();
    let left = found.pitch.first_harmonic_energy();
    let jointly = left <= NOT_JOINT * measured.first_harmonic_energy();
    if !(jointly && found.eccentricity > STANDS_OUT * deviation) {
        return None;
    }
    if apart_um(in_runout, in_pitch, basic_data) > SAME * in_runout.um {
        // As large, but elsewhere: the stated eccentricity, if one of the two directions is wrong.
        let as_large = (in_pitch.um - in_runout.um).abs() <= SAME * in_runout.um;
        return (as_large && !by_readings).then_some(Finding::StatedEccentricityElsewhere {
            in_pitch,
            stated: in_runout,
        });
    }
    Some(Finding::OwnPitchHoldsEccentricity {
        in_pitch,
        in_runout,
        runout: match by_readings {
            false => RunoutSource::Total,
            true => RunoutSource::Readings {
                left: flanks.runout.stated(),
            },
        },
    })
}

/// Where the first harmonic of datum-axis pitch as `measured` is not that of the eccentricity that is taken from it alone.
///
/// Of white deviations `s` the energy that both flanks' joint fit leaves is exponential with the mean `z s²`: it stands out by
/// [`STANDS_OUT`] where it is above `STANDS_OUT²/2` of that, as often as the amount of an eccentricity does.
fn not_joint(pitch: &PitchStatement, measured: &Pitch, flanks: &Flanks) -> Option<Finding> {
    if pitch.eccentricity == Some(EccentricitySource::Runout) {
        // What is left counts as the gear's own.
        return None;
    }
    let (own, note) = (flanks.stated.pitch.as_ref()?, flanks.eccentricity?);
    let (left, all) = (
        own.first_harmonic_energy(),
        measured.first_harmonic_energy(),
    );
    let z = f64::from(flanks.gears.most().basic_data().teeth());
    let squares = |side| own.flank(side).iter().map(|f| f * f).sum::<f64>();
    // Without the harmonic, whose energy is z/2 times its squares; means and harmonics are fitted.
    let rest = (Flank::BOTH.map(squares).iter().sum::<f64>() - 2.0 * left / z).max(0.0);
    let white = z * rest / (2.0 * z - 6.0).max(1.0);
    let stands_out = left > STANDS_OUT.powi(2) / 2.0 * white;
    (stands_out && left > NOT_JOINT * all).then(|| Finding::FirstHarmonicNotEccentricity {
        // Amplitude 2/z of the coefficient's, in the mean of the two flanks' squares.
        left_um: 1000.0 * 2.0 / z * (left / 2.0).sqrt(),
        left_percent: 100.0 * left / all,
        alike: measured.first_harmonic_apart() <= NOT_JOINT * all,
        eccentricity_um: note.in_pitch.um,
    })
}
