//! Random pairs with deviations, for property tests.

use gearlash::analytic::{Analytic, InvolutePair, evaluate};
use gearlash::error::GearError;
use gearlash::gear::{
    AsBuilt, BasicGearData, Deviations, Face, Gear, GearDesign, Pitch, Side, thickness,
};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use proptest::prelude::*;
use proptest::sample::Index;
use std::ops::Range;

/// Rounding of a length that comes from angles of up to a few turns (1e-15 rad each, a few of them
/// added) on radii of up to 200 mm, mm.
pub const ROUNDING: f64 = 2e-12;

/// One random gear, everything in modules or micrometres so that it can be scaled and renumbered.
#[derive(Debug, Clone)]
pub struct Recipe {
    pub teeth: u32,
    pub shift: f64,
    pub allowance_um: f64,
    pub runout_um: f64,
    pub high_tooth: f64,
    pub face: Face,
    /// Per-tooth thickness, own right pitch, own left pitch, µm.
    pub per_tooth_um: Vec<[f64; 3]>,
}

impl Recipe {
    /// Built `scale` times as large, module 2 times that.
    pub fn build(&self, scale: f64) -> Result<AsBuilt, GearError> {
        let um = scale * 1e-3;
        let data = BasicGearData::new(self.teeth, 2.0 * scale, 20f64.to_radians()).unwrap();
        let design = GearDesign {
            profile_shift: self.shift,
            ..GearDesign::standard(data)
        };
        let nominal = design.nominal_base_thickness();
        let base = thickness::base_from_allowance(&data, nominal, self.allowance_um * um);
        let column =
            |n: usize| -> Vec<f64> { self.per_tooth_um.iter().map(|row| row[n] * um).collect() };
        let deviations = Deviations {
            per_tooth: column(0),
            pitch: Some(Pitch::from_cumulative(&column(1), &column(2))),
            eccentricity: self.runout_um * um / 2.0,
            high_tooth: self.high_tooth,
            ..Deviations::default()
        };
        AsBuilt::new(Gear::new(design, base)?, self.face, &deviations)
    }

    pub fn mirrored(&self) -> Recipe {
        Recipe {
            face: match self.face {
                Face::Front => Face::Back,
                Face::Back => Face::Front,
            },
            ..self.clone()
        }
    }

    /// Tooth `t` renumbered `t + by`.
    pub fn renumbered(&self, by: u32) -> Recipe {
        let teeth = f64::from(self.teeth);
        let mut per_tooth_um = self.per_tooth_um.clone();
        per_tooth_um.rotate_right(by as usize);
        Recipe {
            high_tooth: 1.0 + (self.high_tooth - 1.0 + f64::from(by)).rem_euclid(teeth),
            per_tooth_um,
            ..self.clone()
        }
    }

    pub fn renumber(&self, tooth: u32, by: u32) -> u32 {
        (tooth - 1 + by) % self.teeth + 1
    }
}

#[derive(Debug, Clone)]
pub struct Case {
    pub wheel: Recipe,
    pub pinion: Recipe,
    /// Distance above the zero-backlash distance of the mean teeth, modules.
    pub radial_play: f64,
    pub locked: Member,
    pub mating: Mating,
}

impl Case {
    pub fn assemble(&self, scale: f64) -> GearPair {
        self.try_assemble(scale).unwrap()
    }

    /// The gears warmer or colder than each other, at a distance of a housing that is neither: lengths times 1 + `expansion`.
    pub fn warmed(&self, expansion: [f64; 2]) -> Result<GearPair, GearError> {
        let pair = self.try_assemble(1.0)?;
        GearPair::with_locked(
            pair.gear(Member::Wheel).expanded(1.0 + expansion[0])?,
            pair.gear(Member::Pinion).expanded(1.0 + expansion[1])?,
            pair.center_distance(),
            self.locked,
        )
    }

    pub fn try_assemble(&self, scale: f64) -> Result<GearPair, GearError> {
        let (wheel, pinion) = (self.wheel.build(scale)?, self.pinion.build(scale)?);
        let zero = InvolutePair::new(wheel.gear(), pinion.gear()).center_distance(0.0);
        let distance = zero.unwrap() + 2.0 * scale * self.radial_play;
        GearPair::with_locked(wheel, pinion, distance, self.locked)
    }

    /// Wheel and pinion exchanged, the locked gear with them: the picture turned by half a turn.
    pub fn swapped(&self) -> Case {
        Case {
            wheel: self.pinion.clone(),
            pinion: self.wheel.clone(),
            locked: self.locked.mate(),
            mating: Mating {
                wheel_tooth: self.mating.pinion_tooth,
                pinion_tooth: self.mating.wheel_tooth,
                ..self.mating
            },
            ..self.clone()
        }
    }

    /// Teeth renumbered by these amounts, taken around.
    pub fn renumbered(&self, wheel_by: u32, pinion_by: u32) -> Case {
        let by = (wheel_by % self.wheel.teeth, pinion_by % self.pinion.teeth);
        Case {
            wheel: self.wheel.renumbered(by.0),
            pinion: self.pinion.renumbered(by.1),
            mating: Mating {
                wheel_tooth: self.wheel.renumber(self.mating.wheel_tooth, by.0),
                pinion_tooth: self.pinion.renumber(self.mating.pinion_tooth, by.1),
                ..self.mating
            },
            ..self.clone()
        }
    }

    /// Seen from behind: faces and flanks swap.
    pub fn mirrored(&self) -> Case {
        Case {
            wheel: self.wheel.mirrored(),
            pinion: self.pinion.mirrored(),
            mating: Mating {
                flank: self.mating.flank.other(),
                ..self.mating
            },
            ..self.clone()
        }
    }

    pub fn evaluate(&self, scale: f64) -> (GearPair, Analytic) {
        let assembly = self.assemble(scale);
        let analytic = evaluate(&assembly, &Pose::new(&assembly, self.mating));
        (assembly, analytic)
    }

    /// `j_wt` of all three models in units of `scale` mm.
    pub fn backlash(&self, scale: f64) -> [Option<f64>; 3] {
        let (assembly, found) = self.evaluate(scale);
        [
            found.michalec,
            found.involute,
            found.line_of_action.backlash(&assembly),
        ]
        .map(|j_wt| j_wt.map(|mm| mm / scale))
    }
}

fn face() -> BoxedStrategy<Face> {
    prop_oneof![Just(Face::Front), Just(Face::Back)].boxed()
}

/// Ordinary deviations times `rough`; at 30 a runout of two thirds of the tooth depth and pitches off by a tenth.
fn recipe(teeth: Range<u32>, rough: f64) -> BoxedStrategy<Recipe> {
    teeth
        .prop_flat_map(move |teeth| {
            let up_to = |um: f64| -um * rough..um * rough;
            (
                Just(teeth),
                -0.1..0.5,
                -120.0..0.0,
                0.0..100.0 * rough,
                1.0..f64::from(teeth + 1),
                face(),
                prop::collection::vec([up_to(5.0), up_to(20.0), up_to(20.0)], teeth as usize),
            )
        })
        .prop_map(
            |(teeth, shift, allowance_um, runout_um, high_tooth, face, per_tooth_um)| Recipe {
                teeth,
                shift,
                allowance_um,
                runout_um,
                high_tooth,
                face,
                per_tooth_um,
            },
        )
        .boxed()
}

/// Play of −0.05 to +0.1 modules: from interference to ordinary backlash, with contact on the line of action.
pub fn case() -> BoxedStrategy<Case> {
    any_case(17..90, 1.0, -0.05..0.1)
}

/// Undercut teeth, runout of the order of the tooth depth, half out of mesh or jammed.
pub fn rough_case() -> BoxedStrategy<Case> {
    any_case(6..60, 30.0, -0.3..1.0)
}

/// Boxed: each binary would else build the runner of property tests for every shape of strategy.
fn any_case(teeth: Range<u32>, rough: f64, radial_play: Range<f64>) -> BoxedStrategy<Case> {
    let locked = prop_oneof![Just(Member::Wheel), Just(Member::Pinion)];
    let flank = prop_oneof![Just(Side::Right), Just(Side::Left)];
    let fraction = prop_oneof![Just(0.0), -1.0..1.0, -3.0..3.0];
    (
        recipe(teeth.clone(), rough),
        recipe(teeth, rough),
        radial_play,
        locked,
        flank,
        fraction,
        any::<(Index, Index)>(),
    )
        .prop_map(
            |(wheel, pinion, radial_play, locked, flank, fraction, teeth)| {
                let mating = Mating {
                    wheel_tooth: teeth.0.index(wheel.teeth as usize) as u32 + 1,
                    pinion_tooth: teeth.1.index(pinion.teeth as usize) as u32 + 1,
                    flank,
                    fraction,
                };
                Case {
                    wheel,
                    pinion,
                    radial_play,
                    locked,
                    mating,
                }
            },
        )
        .boxed()
}
