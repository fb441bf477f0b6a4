//! Which eccentricity runout readings hold, once the flanks are known.

use super::eccentricity::apart_um;
use super::error::MeasurementError;
use super::finding::{Finding, FittedReadings, FlankKnowledge, RunoutContradiction};
use super::notes::Eccentricity;
use super::runout::{ProbeReadings, ReadWith};
use crate::error::GearError;
use crate::gear::{Deviations, Gear, Probe, RunoutFit, RunoutReadings, thickness};

/// Standard deviations by which the readings must refuse what the flanks say of them.
const CERTAIN: f64 = 3.0;
/// What may be left of the readings, µm r.m.s., whatever the flanks explain. Tuned: readings and flanks of 1 µm each leave
/// some 2 µm in a ball's place; 5 µm r.m.s. are those of another gear.
const MOST_LEFT_UM: f64 = 3.0;

/// What was made of the readings.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ReadingsFit {
    pub fit: RunoutFit,
    probe: Probe,
    /// As if the flanks stood where they belong.
    plain: RunoutFit,
    /// How far another ball moves the eccentricity at most, µm; `None` where the ball is given or there is none.
    by_ball_um: Option<f64>,
}

impl ReadingsFit {
    /// Fits the eccentricity of `gear`, `known` being its flanks.
    pub(super) fn new(
        readings: &ProbeReadings,
        gear: &Gear,
        known: &Deviations,
    ) -> Result<ReadingsFit, MeasurementError> {
        let probe = match readings.with {
            ReadWith::Fork => Probe::Fork,
            ReadWith::Ball(diameter) => {
                check_ball(gear, diameter).map_err(MeasurementError::Ball)?;
                Probe::Ball(diameter)
            }
            ReadWith::AnyBall => Probe::Ball(usual_ball(gear).ok_or(MeasurementError::NoBall)?),
        };
        let with = |probe, known: &Deviations| {
            let mm = readings.mm();
            let fit = RunoutReadings { probe, mm }.fit(gear, known);
            fit.map_err(MeasurementError::Runout)
        };
        let fit = with(probe, known)?;
        let plain = with(probe, &Deviations::default())?;
        let by_ball_um = (readings.with == ReadWith::AnyBall).then(|| {
            let others = extreme_balls(gear).into_iter().filter_map(|ball| {
                let other = with(Probe::Ball(ball), known).ok()?;
                let (this, other) = (eccentricity(&fit), eccentricity(&other));
                Some(apart_um(this, other, gear.basic_data()))
            });
            others.fold(0.0, f64::max)
        });
        Ok(ReadingsFit {
            fit,
            probe,
            plain,
            by_ball_um,
        })
    }

    /// The readings' own first harmonic, whatever the flanks make of it.
    pub(super) fn first_harmonic(&self) -> Option<Eccentricity> {
        (self.plain.eccentricity > 0.0).then(|| eccentricity(&self.plain))
    }

    /// Findings about them; `all` is the fit with all that is known.
    pub(super) fn findings(&self, knowledge: FlankKnowledge, all: &RunoutFit) -> Vec<Finding> {
        let mut findings = vec![Finding::RunoutReadings(FittedReadings {
            knowledge,
            probe: self.probe,
            by_ball_um: self.by_ball_um,
            eccentricity: eccentricity(&self.fit),
            first_harmonic: eccentricity(&self.plain),
            flanks_taken_out: self.plain != self.fit,
            range_um: 1000.0 * all.range,
            left_um: 1000.0 * greatest(&all.beyond, |r, s| r - s),
        })];
        if knowledge != FlankKnowledge::NoPitch {
            findings.extend(self.contradiction(all));
        }
        findings
    }

    /// Whether what is beyond eccentricity refuses what the flanks say of it.
    ///
    /// Regression of the readings on what the flanks say: the slope is 1 where they agree. Below 1/2 the
    /// readings are the more even without the flanks; besides, most of their energy may be left over.
    fn contradiction(&self, all: &RunoutFit) -> Option<Finding> {
        let sum = |of: fn(f64, f64) -> f64| -> f64 {
            all.beyond.iter().map(|&(read, said)| of(read, said)).sum()
        };
        let (said, shared) = (sum(|_, s| s * s), sum(|r, s| r * s));
        let left = sum(|r, s| (r - s).powi(2));
        let count = all.beyond.len() as f64;
        let refused = said > 0.0 && count > 5.0 && {
            let slope = shared / said;
            let about = all.beyond.iter().map(|(r, s)| (r - slope * s).powi(2));
            // Mean, both parts of the first harmonic and the slope are fitted.
            let deviation = (about.sum::<f64>() / (count - 4.0) / said).sqrt();
            slope + CERTAIN * deviation < 0.5
        };
        let foreign = left > sum(|r, _| r * r).max(said) / 2.0
            && 1000.0 * (left / count).sqrt() > MOST_LEFT_UM;
        if !(refused || foreign) {
            return None;
        }
        let apart = |&(read, said): &(f64, f64)| (read - said).abs();
        let numbered = (1..).zip(&all.beyond);
        let (tooth, worst) = numbered.max_by(|a, b| apart(a.1).total_cmp(&apart(b.1)))?;
        Some(Finding::RunoutContradictsFlanks(RunoutContradiction {
            probe: self.probe,
            read_um: 1000.0 * greatest(&all.beyond, |r, _| r),
            said_um: 1000.0 * greatest(&all.beyond, |_, s| s),
            tooth,
            apart_um: 1000.0 * apart(worst),
            range_um: 1000.0 * all.range,
            known_range_um: 1000.0 * all.known_range,
        }))
    }
}

/// Whether a ball of `diameter` rests on the involutes of `gear`, clear of the root. It need not stand out over the tips.
fn check_ball(gear: &Gear, diameter: f64) -> Result<(), GearError> {
    match thickness::check_pins(gear, diameter) {
        Err(GearError::PinBelowTip { .. }) => Ok(()),
        checked => checked,
    }
}

/// The ball that touches `gear` at the reference circle: its centre has `α_K = α + (p_b − s_b)/d_b − inv α`. Where there is
/// none, the least one that rests on the involutes.
fn usual_ball(gear: &Gear) -> Option<f64> {
    let roll = gear.basic_data().transverse_pressure_angle().tan();
    let ball = thickness::pin_touching(gear.basic_data(), roll, gear.base_thickness());
    let there = ball > 0.0 && ball.is_finite();
    if there {
        Some(ball)
    } else {
        extreme_balls(gear).first().copied()
    }
}

/// The least and the greatest ball that rest on the involutes of `gear`, within a twentieth of their height.
fn extreme_balls(gear: &Gear) -> Vec<f64> {
    let (form, tip) = (gear.form_roll(), gear.tip_roll());
    let fitting: Vec<f64> = (0..=20)
        .map(|part| form + f64::from(part) / 20.0 * (tip - form))
        .map(|roll| thickness::pin_touching(gear.basic_data(), roll, gear.base_thickness()))
        .filter(|&ball| ball > 0.0 && ball.is_finite() && check_ball(gear, ball).is_ok())
        .collect();
    [fitting.first(), fitting.last()]
        .into_iter()
        .flatten()
        .copied()
        .collect()
}

fn eccentricity(fit: &RunoutFit) -> Eccentricity {
    Eccentricity {
        um: 1000.0 * fit.eccentricity,
        high_tooth: fit.high_tooth,
    }
}

fn greatest(pairs: &[(f64, f64)], of: impl Fn(f64, f64) -> f64) -> f64 {
    let amounts = pairs.iter().map(|&(read, said)| of(read, said).abs());
    amounts.fold(0.0, f64::max)
}
