//! Runout: an amount with a high tooth, or readings of a ball or a fork and the eccentricity fitted to them.

use super::error::MeasurementError;
use super::finding::{
    Eccentricity, EccentricityNote, Finding, FittedReadings, FlankKnowledge, RunoutContradiction,
};
use super::thickness_statement::Toleranced;
use crate::error::GearError;
use crate::gear::{BasicGearData, Deviations, Gear, Probe, RunoutFit, RunoutReadings, thickness};
use crate::numeric::range;

/// A statement of the radial runout.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum RunoutStatement {
    /// No runout.
    #[default]
    None,
    /// Radial runout, twice the eccentricity.
    Total(Runout),
    /// Readings all round.
    Readings(ProbeReadings),
}

/// Runout readings from any common zero.
#[derive(Debug, Clone, PartialEq)]
pub struct ProbeReadings {
    /// One reading per tooth, tooth 1 first, µm, + = outwards.
    pub um: Vec<f64>,
    /// The probe.
    pub with: ReadWith,
}

/// A probe that touches the flanks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ReadWith {
    /// A fork astride each tooth.
    Fork,
    /// A ball of this diameter, mm, in the space after each tooth, towards the next number.
    Ball(f64),
    /// A ball of unknown diameter in that space: one that touches at the reference circle is assumed.
    AnyBall,
}

impl ProbeReadings {
    /// The readings in mm.
    pub(super) fn mm(&self) -> Vec<f64> {
        self.um.iter().map(|um| um / 1000.0).collect()
    }

    /// Greatest minus least reading, µm.
    pub fn range_um(&self) -> f64 {
        1000.0 * range(self.mm())
    }
}

impl RunoutStatement {
    /// The readings, if stated.
    pub fn readings(&self) -> Option<&ProbeReadings> {
        match self {
            RunoutStatement::Readings(readings) => Some(readings),
            _ => None,
        }
    }

    /// The runout as stated; for readings their range, before the fit.
    pub(super) fn runout(&self) -> Runout {
        match self {
            RunoutStatement::None => Runout::default(),
            RunoutStatement::Total(runout) => *runout,
            RunoutStatement::Readings(readings) => Runout::new(readings.range_um(), 1.0),
        }
    }

    /// Checks the numbers for a gear of `basic_data`.
    pub(super) fn check(&self, basic_data: &BasicGearData) -> Result<(), MeasurementError> {
        let require = |holds, what, value, allowed| {
            let checked = GearError::require(holds, what, value, allowed);
            checked.map_err(MeasurementError::Runout)
        };
        match self {
            RunoutStatement::None => Ok(()),
            RunoutStatement::Total(Runout {
                total_um,
                high_tooth,
            }) => {
                require(*total_um >= 0.0, "runout (µm)", *total_um, "0 or more")?;
                let (tooth, teeth) = (high_tooth.unwrap_or(1.0), f64::from(basic_data.teeth()));
                let allowed = "1 up to, but not including, the number of teeth + 1";
                require(
                    (1.0..teeth + 1.0).contains(&tooth),
                    "high tooth",
                    tooth,
                    allowed,
                )
            }
            RunoutStatement::Readings(readings) => readings.um.iter().try_for_each(|&um| {
                require(um.is_finite(), "a runout reading (µm)", um, "a number")
            }),
        }
    }
}

/// Runout `F_r`, µm, and the direction of the displacement.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Runout {
    /// `F_r = 2 e`, µm.
    pub total_um: f64,
    /// The tooth (fractional, `1 ≤ … < z + 1`) with the highest reading; `None` if unknown.
    pub high_tooth: Option<f64>,
}

impl Runout {
    /// The runout `F_r`, µm, towards a tooth, if it is above 0.
    pub(super) fn new(total_um: f64, high_tooth: f64) -> Runout {
        Runout {
            total_um,
            high_tooth: (total_um > 0.0).then_some(high_tooth),
        }
    }

    /// Eccentricity `e = F_r/2`, mm.
    pub fn eccentricity(&self) -> f64 {
        self.total_um / 2000.0
    }

    /// The eccentricity, if the high tooth is known.
    pub fn stated(&self) -> Option<Eccentricity> {
        self.high_tooth.map(|high_tooth| Eccentricity {
            um: self.total_um / 2.0,
            high_tooth,
        })
    }

    /// Checks that the runout is below the tooth depth of each of `gears`.
    pub(super) fn check(&self, gears: &Toleranced<Gear>) -> Result<(), MeasurementError> {
        let depth_of = |gear: &Gear| gear.tip_radius() - gear.root_radius();
        // Both gears have one tip circle; the thicker tooth has the higher root.
        let depth_mm = depth_of(gears.most()).min(depth_of(gears.least()));
        if self.total_um / 1000.0 < depth_mm {
            return Ok(());
        }
        Err(MeasurementError::RunoutBeyondDepth {
            depth_um: 1000.0 * depth_mm,
        })
    }
}

/// Standard deviations by which the readings must contradict the flanks.
const CERTAIN: f64 = 3.0;
/// Unexplained rest, µm r.m.s., that is no contradiction: readings rounded to 1 µm and flanks rounded so leave 0.6.
const LEAST_LEFT_UM: f64 = 1.0;
/// Greatest unexplained rest of the readings, µm r.m.s. Tuned: readings and flanks of 1 µm each leave some 2 µm at a ball; 5 µm
/// r.m.s. belong to another gear.
const MOST_LEFT_UM: f64 = 3.0;

/// The eccentricity fitted to the readings.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ReadingsFit {
    pub fit: RunoutFit,
    probe: Probe,
    /// The fit without flank deviations.
    plain: RunoutFit,
    /// Greatest change of the eccentricity by another ball, µm; `None` with a stated ball or a fork.
    by_ball_um: Option<f64>,
}

impl ReadingsFit {
    /// Fits the eccentricity of `gear` with the flank deviations `known`.
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
                Some(this.distance_um(&other, gear.basic_data()))
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

    /// The readings' first harmonic without any effect of the flanks.
    pub(super) fn first_harmonic(&self) -> Option<Eccentricity> {
        (self.plain.eccentricity > 0.0).then(|| eccentricity(&self.plain))
    }

    /// Findings about the readings; `all` is the fit with all known deviations, `note` on the eccentricity in datum-axis pitch.
    pub(super) fn findings(
        &self,
        knowledge: FlankKnowledge,
        all: &RunoutFit,
        note: Option<&EccentricityNote>,
    ) -> Vec<Finding> {
        let in_pitch = note.filter(|note| !note.stated_counts);
        let mut findings = vec![Finding::RunoutReadings(FittedReadings {
            knowledge,
            probe: self.probe,
            by_ball_um: self.by_ball_um,
            eccentricity: eccentricity(&self.fit),
            in_pitch: in_pitch.and_then(|note| Some((note.in_pitch, note.difference_um?))),
            first_harmonic: eccentricity(&self.plain),
            flanks_taken_out: self.plain != self.fit,
            range_um: 1000.0 * all.range,
            left_um: 1000.0 * greatest(&all.rest, |r, s| r - s),
        })];
        if knowledge != FlankKnowledge::NoPitch {
            findings.extend(self.contradiction(all));
        }
        findings
    }

    /// Contradiction between the readings without eccentricity and the flanks.
    ///
    /// The readings are regressed on the values expected from the flanks. The slope is 1 if they agree. They contradict each other
    /// with a slope below 1/2, or if most of the energy is left over.
    fn contradiction(&self, all: &RunoutFit) -> Option<Finding> {
        let sum = |of: fn(f64, f64) -> f64| -> f64 {
            all.rest.iter().map(|&(read, said)| of(read, said)).sum()
        };
        let (said, shared) = (sum(|_, s| s * s), sum(|r, s| r * s));
        let left = sum(|r, s| (r - s).powi(2));
        let count = all.rest.len() as f64;
        let left_um = 1000.0 * (left / count).sqrt();
        let refused = left_um > LEAST_LEFT_UM && said > 0.0 && count > 5.0 && {
            let slope = shared / said;
            let about = all.rest.iter().map(|(r, s)| (r - slope * s).powi(2));
            // Four fitted values: mean, both components of the first harmonic, slope.
            let deviation = (about.sum::<f64>() / (count - 4.0) / said).sqrt();
            slope + CERTAIN * deviation < 0.5
        };
        let foreign = left > sum(|r, _| r * r).max(said) / 2.0 && left_um > MOST_LEFT_UM;
        if !(refused || foreign) {
            return None;
        }
        let apart = |&(read, said): &(f64, f64)| (read - said).abs();
        let numbered = (1..).zip(&all.rest);
        let (tooth, worst) = numbered.max_by(|a, b| apart(a.1).total_cmp(&apart(b.1)))?;
        Some(Finding::RunoutContradictsFlanks(RunoutContradiction {
            probe: self.probe,
            read_um: 1000.0 * greatest(&all.rest, |r, _| r),
            said_um: 1000.0 * greatest(&all.rest, |_, s| s),
            tooth,
            apart_um: 1000.0 * apart(worst),
            range_um: 1000.0 * all.range,
            known_range_um: 1000.0 * all.known_range,
        }))
    }
}

/// Checks that a ball of `diameter` rests on the involutes of `gear`, clear of the root. It may lie below the tips.
fn check_ball(gear: &Gear, diameter: f64) -> Result<(), GearError> {
    match thickness::check_pins(gear, diameter) {
        Err(GearError::PinBelowTip { .. }) => Ok(()),
        checked => checked,
    }
}

/// Diameter of the ball that touches `gear` at the reference circle: `α_K = α + (p_b − s_b)/d_b − inv α` at its centre.
///
/// If there is none, the least ball that rests on the involutes.
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
    let ends = [fitting.first(), fitting.last()];
    ends.into_iter().flatten().copied().collect()
}

fn eccentricity(fit: &RunoutFit) -> Eccentricity {
    Eccentricity::new(fit.eccentricity, fit.high_tooth)
}

fn greatest(pairs: &[(f64, f64)], of: impl Fn(f64, f64) -> f64) -> f64 {
    let amounts = pairs.iter().map(|&(read, said)| of(read, said).abs());
    amounts.fold(0.0, f64::max)
}
