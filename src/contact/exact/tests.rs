//! Hard pairs: poses and extremes end within their counted effort, and say so.

use super::{Doubt, ExactKernel};
use crate::contact::effort::Effort;
use crate::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Hand, Pitch, Side,
};
use crate::pair::{GearPair, Mating, Member};

/// A multiplicative pseudo-random sequence, equal on every machine.
pub(super) struct Draws(pub u64);

impl Draws {
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        let next = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = next.wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// The data of a helical pair of module 2.
struct Wild {
    teeth: [u32; 2],
    beta_deg: f64,
    face: f64,
    runout: f64,
    pitch: f64,
    /// Centre distance beyond the sum of the reference radii.
    extra_distance: f64,
}

impl Wild {
    fn pair(&self, draws: &mut Draws) -> Option<GearPair> {
        let mut gear = |teeth: u32, hand, face| {
            let basic_data = BasicGearData::new(teeth, 2.0, 20f64.to_radians()).ok()?;
            let design = GearDesign {
                basic_data: basic_data
                    .with_helix(self.beta_deg.to_radians(), hand)
                    .ok()?,
                profile_shift: 0.3,
                rack: BasicRack::ISO_53_A,
                tip_diameter: None,
            };
            let mut curve = || -> Vec<f64> {
                let each = 0..teeth;
                each.map(|_| draws.within(-self.pitch, self.pitch))
                    .collect()
            };
            let deviations = Deviations {
                pitch: Some(Pitch::from_cumulative(&curve(), &curve())),
                eccentricity: 0.5 * self.runout,
                high_tooth: 2.0,
                ..Deviations::default()
            };
            AsBuilt::new(Gear::nominal(design).ok()?, face, &deviations).ok()
        };
        let wheel = gear(self.teeth[0], Hand::Right, Face::Front)?;
        let pinion = gear(self.teeth[1], Hand::Left, Face::Back)?;
        let gears = [&wheel, &pinion].map(|gear| gear.gear().basic_data().reference_radius());
        let distance = gears[0] + gears[1] + self.extra_distance;
        let pair = GearPair::with_locked(wheel, pinion, distance, Member::Wheel).ok()?;
        pair.with_face([0.0, self.face]).ok()
    }
}

pub(super) fn mating(wheel_tooth: u32, pinion_tooth: u32, fraction: f64) -> Mating {
    Mating {
        wheel_tooth,
        pinion_tooth,
        flank: Side::Right,
        fraction,
    }
}

/// Pairs of 7/31 and 40/61 teeth, β 45°, whose poses and extremes had no end (killed after 40 s and 280 s). The bracket
/// states what is known when the effort ends.
#[test]
fn extremes_of_wild_helical_pairs_end_by_their_effort() {
    let cases = [
        ([7, 31], 200.0, 0.06, 0.015, 0.2),
        ([7, 31], 20.0, 1.5, 0.3, 0.2),
        ([40, 61], 200.0, 1.5, 0.3, 3.4),
    ];
    for (teeth, face, runout, pitch, extra_distance) in cases {
        let wild = Wild {
            teeth,
            beta_deg: 45.0,
            face,
            runout,
            pitch,
            extra_distance,
        };
        let pair = wild.pair(&mut Draws(7)).unwrap();
        let kernel = ExactKernel::new(&pair);
        let matings = u64::from(teeth[0] * teeth[1]);
        let effort = Effort::of_extremes(&pair);
        let over = (mating(1, 1, 0.0), matings);
        let found = kernel.extremes_within(&pair, over, 1e-6, &effort).unwrap();
        assert!(
            2 * effort.left() >= effort.used(),
            "{teeth:?}: {}",
            effort.used()
        );
        for extreme in [found.least, found.greatest].into_iter().flatten() {
            assert!(extreme.doubt != Some(Doubt::Unbounded) || extreme.low <= extreme.high);
            assert!(extreme.low <= extreme.high, "{teeth:?}: {extreme:?}");
        }
        // An interrupted search is also reproducible.
        let again = kernel.extremes(&pair, over.0, matings, 1e-6).unwrap();
        assert_eq!(found, again);
    }
}

/// A pair far outside any practice: 3 to 400 teeth, β to 50°, face width to 200 mm, runout of 0.75 modules, pitch
/// deviations of 0.3 modules.
pub(super) fn wild(draws: &mut Draws) -> Option<GearPair> {
    let few = draws.within(0.0, 1.0) < 0.5;
    let mut teeth = || {
        if few {
            draws.within(3.0, 20.0) as u32
        } else {
            draws.within(3.0, 400.0) as u32
        }
    };
    let wild = Wild {
        teeth: [teeth(), teeth()],
        beta_deg: draws.within(1.0, 50.0),
        face: draws.within(5.0, 200.0),
        runout: draws.within(0.0, 1.5),
        pitch: draws.within(0.0, 0.6),
        extra_distance: draws.within(-0.5, 2.5),
    };
    wild.pair(draws)
}

/// No pose exceeds its effort, and none is lost before one side of a section has used its share. Few are given up: 5 of
/// 438, whose flanks overlap before a tip jams. It was 29 of 102 when the section of every tooth on the line of centres
/// was examined, and the whole face of jammed poses.
#[test]
fn wild_helical_poses_are_found_within_their_effort() {
    let mut draws = Draws(11);
    let (mut poses, mut lost, mut most) = (0, 0, 0);
    for pair in (0..250)
        .filter_map(|_| wild(&mut draws))
        .collect::<Vec<_>>()
    {
        let kernel = ExactKernel::new(&pair);
        for tooth in 1..=2 {
            let at = mating(tooth, 1, draws.within(0.0, 1.0));
            let (found, used) = kernel.lost_motion_counted(&pair, at);
            let found = found.unwrap();
            let allowed = Effort::of_pose().left();
            assert!(used <= allowed && (found.is_some() || 2 * used >= allowed));
            lost += u32::from(found.is_none());
            poses += 1;
            most = most.max(used);
        }
    }
    println!("{poses} poses, {lost} lost, most {most} units");
    assert!(poses > 400 && 50 * lost < poses, "{lost} of {poses}");
}
