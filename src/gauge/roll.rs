//! Double-flank roll test: the gear rolls without play against a perfect master gear.
//!
//! The centre distance `a''` of each pose is the one at which the exact kernel finds no lost motion, bracketed to 1e-10 mm. Poses an even
//! part of a pitch apart give the curve. More poses are added where extremes are possible (see [`super::roll_extremes`]).

use super::roll_extremes::{DeviationCurve, RollPose, RollRange, RollSample, bracketed};
use super::{Summary, Unmeasured};
use crate::analytic::InvolutePair;
use crate::contact::{Contact, LostMotion, PairAtDistance, PoseClass};
use crate::error::{Error, GearError, Tick};
use crate::gear::{AsBuilt, BasicGearData, BasicRack, Face, Gear, GearDesign, involute};
use crate::numeric::mean;
use crate::pair::{GearPair, Mating, Member, Pose, SweepPlan};
use std::f64::consts::{FRAC_PI_4, TAU};

/// The result of a roll test.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Roll {
    /// The master gear.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub master: Gear,
    /// Poses per pitch.
    pub steps_per_pitch: u32,
    /// Even poses over one revolution of the gear.
    pub poses: Vec<RollPose>,
    /// Additional poses for the extremes, in the order of the revolution.
    pub between: Vec<RollPose>,
    /// `F_i''`: range of `a''` over the revolution.
    pub total: RollRange,
    /// `f_i''`: greatest range of `a''` within one pitch (360°/z).
    pub tooth_to_tooth: RollRange,
}

impl Roll {
    /// `a''` of all poses in short, with the mean of the even ones.
    pub fn distances(&self) -> Summary {
        let poses = self.poses.iter().chain(&self.between);
        Summary {
            mean: mean(self.poses.iter().map(|pose| pose.distance)),
            ..Summary::of(poses.map(|pose| (pose.distance, pose.error)))
        }
    }
}

/// Rolls `gear` through one revolution over its `face`. `tick` is called as each pose begins, `more` with the number of further poses.
pub(super) fn roll(
    gear: &AsBuilt,
    master_teeth: Option<u32>,
    steps_per_pitch: u32,
    face: [f64; 2],
    more: &dyn Fn(usize),
    tick: &Tick,
) -> Result<Result<Roll, Unmeasured>, Error> {
    let master = match master(gear, master_teeth) {
        Ok(master) => master,
        Err(reason) => return Ok(Err(reason)),
    };
    let guess = InvolutePair::new(gear.gear(), &master).center_distance(0.0);
    let Some(guess) = guess else {
        return Ok(Err(Unmeasured(
            "the gear is too thin to mesh with a master gear without play".to_owned(),
        )));
    };
    let towards = match gear.face() {
        Face::Front => Face::Back,
        Face::Back => Face::Front,
    };
    let mate = AsBuilt::perfect(master.clone(), towards);
    let assembly = GearPair::with_locked(gear.clone(), mate, guess, Member::Wheel)?;
    let assembly = assembly.with_face(face)?;
    let matings =
        SweepPlan::wheel_revolution(&assembly, steps_per_pitch, (1, 1)).matings(&assembly);
    let bench = PairAtDistance::new(&assembly);
    let take = |step: usize, beyond: f64| {
        Error::if_stopped(tick(1))?;
        let mating = matings[step].onward(&assembly, beyond / f64::from(steps_per_pitch));
        sample(&bench, guess, &mating)
    };
    let curve = DeviationCurve {
        steps: matings.len(),
        steps_per_pitch: steps_per_pitch as usize,
        step: gear.gear().basic_data().angular_pitch() / f64::from(steps_per_pitch),
    };
    let Some(([poses, between], ranges)) = bracketed(&curve, more, &take)? else {
        return Ok(Err(Unmeasured(
            "no centre distance brings the gear and the master together without play".to_owned(),
        )));
    };
    Ok(Ok(Roll {
        master,
        steps_per_pitch,
        poses,
        between,
        total: ranges.total,
        tooth_to_tooth: ranges.tooth_to_tooth,
    }))
}

/// The pose of `mating` at `guess`, rolled without play.
///
/// The rotation of a mating depends slightly on the centre distance. The pose is turned back by that, so that poses are even in rotation.
fn sample(
    bench: &PairAtDistance,
    guess: f64,
    mating: &Mating,
) -> Result<Option<RollSample>, Error> {
    let assembly = bench.assembly();
    let Some([_, near]) = bench.play_free_distance(guess, mating)? else {
        return Ok(None);
    };
    let gear = assembly.gear(Member::Wheel);
    let rotation = Pose::new(assembly, *mating).locked_rotation();
    let turned = rotation - Pose::new(&assembly.at(near)?, *mating).locked_rotation();
    let onward = -gear.face().ascending() * turned / gear.gear().basic_data().angular_pitch();
    let mating_there = mating.onward(assembly, onward);
    let Some([low, high]) = bench.play_free_distance(near, &mating_there)? else {
        return Ok(None);
    };
    let there = bench.at(high)?;
    let at = there.assembly();
    let left = Pose::new(at, mating_there).locked_rotation() - rotation;
    let found = there.lost_motion(&mating_there)?;
    // Play changes by 2 sin α_wt per distance; the kernel's own error shifts the zero in proportion.
    let slope = 2.0 * at.operating_pressure_angle().sin();
    let play = found.error().unwrap_or(0.0) * at.gear(Member::Pinion).gear().base_radius();
    Ok(Some(RollSample {
        slope: self::slope(&found, high),
        touched: [found.right, found.left].map(|contact| {
            contact.map(|contact| [contact.wheel, contact.pinion].map(|t| (t.tooth, t.curve)))
        }),
        pose: RollPose {
            mating: *mating,
            // The rest of the turn back. The mating there may count from the previous tooth, a revolution off.
            rotation: rotation + left - TAU * (left / TAU).round(),
            distance: 0.5 * (low + high),
            error: 0.5 * (high - low) + play / slope,
            class: PoseClass::of(at, &found),
        },
    }))
}

/// `|da''/dφ|`, mm/rad, while the contacts stay the same.
///
/// The gear turns by `dφ`, the master by `dθ`, and its axis moves by `da`. A contact at `p` with the normal `n` stays closed if `(q × n) dθ
/// + n_x da = (p × n) dφ`, with `q` from the master's axis. Right and left contact give two such equations for `dθ` and `da`.
fn slope(found: &LostMotion, distance: f64) -> f64 {
    let (Some(right), Some(left)) = (&found.right, &found.left) else {
        return f64::INFINITY;
    };
    let arms = |contact: &Contact| {
        let mut from_master = contact.point.coords;
        from_master.x -= distance;
        (
            contact.point.coords.perp(&contact.normal),
            from_master.perp(&contact.normal),
            contact.normal.x,
        )
    };
    let ((p_r, q_r, x_r), (p_l, q_l, x_l)) = (arms(right), arms(left));
    let slope = ((q_r * p_l - q_l * p_r) / (q_r * x_l - q_l * x_r)).abs();
    if slope.is_finite() {
        slope
    } else {
        f64::INFINITY
    }
}

/// Least number of teeth of a default master. From here up, the first one is taken whose involute reaches as deep as
/// the gear's tips (a usual size of master gears; smaller ones are nearly undercut).
const FEWEST: u32 = 30;
/// Greatest number of teeth of a default master: a larger one hardly reaches deeper.
const MOST: u32 = 200;
/// Distance of tips from the ends of involutes, in modules, in addition to the eccentricity.
const MARGIN: f64 = 0.05;
/// Greatest dedendum, in parts of that of a pointed tool.
const POINTED: f64 = 0.95;

/// A master for `gear` with its module and pressure angle, `x = 0` and nominal thickness.
///
/// At tight mesh its tips reach exactly to the gear's active flank, at most one module outside its reference circle.
/// The tool that cuts it has no tip radius and is deep enough for the gear's tips.
fn master(gear: &AsBuilt, teeth: Option<u32>) -> Result<Gear, Unmeasured> {
    let failed = |error: GearError| Unmeasured(format!("no master gear: {error}"));
    if let Some(teeth) = teeth {
        return Ok(with_teeth(gear, teeth).map_err(failed)?.0);
    }
    let mut last = with_teeth(gear, MOST).map_err(failed)?.0;
    for teeth in FEWEST..MOST {
        if let Ok((master, true)) = with_teeth(gear, teeth) {
            last = master;
            break;
        }
    }
    Ok(last)
}

/// The master with this many teeth, and whether the gear's tips stay on its involute.
fn with_teeth(as_built: &AsBuilt, teeth: u32) -> Result<(Gear, bool), GearError> {
    let gear = as_built.gear();
    let of = gear.basic_data();
    let module = of.module();
    let basic_data = BasicGearData::new(teeth, module, of.pressure_angle())?;
    let basic_data = match of.hand() {
        Some(hand) => basic_data.with_helix(of.helix_angle(), hand.mate())?,
        None => basic_data,
    };
    let dedendum =
        (gear.design().rack.addendum() + 0.25).min(POINTED * FRAC_PI_4 / of.pressure_angle().tan());
    let design = |addendum: f64| -> Result<GearDesign, GearError> {
        Ok(GearDesign {
            basic_data,
            profile_shift: 0.0,
            rack: BasicRack::new(addendum, dedendum, 0.0)?,
            tip_diameter: None,
        })
    };
    let trial = Gear::nominal(design(0.25)?)?;
    let base = trial.base_radius();
    let bases = gear.base_radius() + base;
    let distance = InvolutePair::new(gear, &trial).center_distance(0.0);
    let no_mesh = GearError::OutOfRange {
        what: "base tooth thickness (mm)",
        value: gear.base_thickness(),
        allowed: "thick enough to mesh with a master gear without play",
    };
    // The line of action between both base circles; each tip circle cuts it from its own end.
    let line = bases * involute::roll_at(distance.ok_or(no_mesh)?, bases);
    let margin = MARGIN * module + 2.0 * as_built.eccentricity();
    let reach = line - gear.base_radius() * gear.form_roll() - margin;
    let deepest = (base.hypot(reach.max(0.0)) - basic_data.reference_radius()) / module;
    let master = Gear::nominal(design(deepest.min(1.0))?)?;
    let left = line - gear.base_radius() * gear.tip_roll() - margin;
    let on_involute = left >= base * master.form_roll();
    Ok((master, on_involute))
}
