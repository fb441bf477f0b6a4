//! Seeded random pairs and poses, leaning towards the awkward: undercut, tips on fillets,
//! alternating pitch errors at hand-over, eccentric axes, interference.

pub use crate::campaign::random::{Random, either};
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Pitch, Side, involute,
};
use gearlash::pair::{GearPair, Mating, Member};

/// The range of a random pair.
#[derive(Clone, Copy)]
pub struct Kind {
    /// Tooth numbers.
    pub teeth: (f64, f64),
    /// Greatest deviation, in the ordinary ones; 0: perfect gears.
    pub deviation: f64,
    /// Radial shift from zero backlash, modules.
    pub shift: (f64, f64),
}

/// Perfect gears.
pub const PERFECT: Kind = Kind {
    teeth: (12.0, 300.0),
    deviation: 0.0,
    shift: (-0.15, 0.3),
};

/// Deviations up to six times ordinary, half of all free gears eccentric.
pub const WILD: Kind = Kind {
    teeth: (7.0, 1000.0),
    deviation: 6.0,
    shift: (-0.3, 0.4),
};

/// A pair of `kind` that can exist.
pub fn pair(random: &mut Random, kind: Kind) -> GearPair {
    std::iter::repeat_with(|| try_pair(random, kind))
        .find_map(|pair| pair)
        .expect("an endless sequence")
}

fn try_pair(random: &mut Random, kind: Kind) -> Option<GearPair> {
    let module = random.decades(0.05, 20.0);
    let alpha = random.within(14.5, 28.0).to_radians();
    let addendum = random.within(0.8, 1.25);
    let dedendum = addendum + random.within(0.1, 0.35);
    let rack = BasicRack::new(addendum, dedendum, random.within(0.0, 0.4)).ok()?;
    let gears: Vec<Gear> = (0..2)
        .map(|_| {
            let teeth = random.decades(kind.teeth.0, kind.teeth.1) as u32;
            let design = GearDesign {
                basic_data: BasicGearData::new(teeth, module, alpha).ok()?,
                profile_shift: random.within(-0.4, 0.8),
                rack,
                tip_diameter: None,
            };
            let allowance = random.within(-0.03, 0.005) * module;
            Gear::new(design, design.nominal_base_thickness() + allowance).ok()
        })
        .collect::<Option<_>>()?;
    let sum: f64 = gears.iter().map(Gear::base_radius).sum();
    let thick: f64 = gears.iter().map(Gear::base_thickness).sum();
    let inv = (thick - gears[0].basic_data().base_pitch()) / (2.0 * sum);
    if inv <= 0.0 {
        return None;
    }
    let tight = involute::radius_at(involute::roll_of_inv(inv), sum);
    let distance = tight + random.within(kind.shift.0, kind.shift.1) * module;
    let locked = either(random, Member::BOTH);
    let style = random.within(0.0, 1.0);
    let built = (gears.into_iter()).map(|gear| as_built(random, gear, kind.deviation, style));
    let [wheel, pinion] = <[_; 2]>::try_from(built.collect::<Option<Vec<AsBuilt>>>()?).ok()?;
    GearPair::with_locked(wheel, pinion, distance, locked).ok()
}

fn as_built(random: &mut Random, gear: Gear, deviation: f64, style: f64) -> Option<AsBuilt> {
    let face = either(random, [Face::Front, Face::Back]);
    let teeth = gear.basic_data().teeth();
    let module = gear.basic_data().module();
    // Ordinary: 10 µm of pitch and thickness, 20 µm of runout at module 3.
    let scale = deviation * random.within(0.0, 1.0) * 0.003 * module;
    let list = |random: &mut Random, alternating: bool| -> Vec<f64> {
        let each = (0..teeth).map(|k| {
            let sign = if alternating && k % 2 == 0 { 2.0 } else { 0.0 };
            scale * (random.within(-1.0, 1.0) + sign)
        });
        each.collect()
    };
    let mut deviations = Deviations::default();
    if deviation > 0.0 {
        if style < 0.8 {
            let alternating = style < 0.35;
            let (right, left) = (list(random, alternating), list(random, alternating));
            deviations.pitch = Some(Pitch::from_cumulative(&right, &left));
        } else {
            deviations.per_tooth = list(random, false);
        }
        if random.chance(0.5) {
            deviations.eccentricity = 0.003 * module * deviation * random.within(0.0, 1.0);
            deviations.high_tooth = random.within(1.0, f64::from(teeth) + 1.0);
        }
    }
    AsBuilt::new(gear, face, &deviations).ok()
}

/// A pose of `assembly` up to a thousand pitches beyond a mating.
pub fn mating(random: &mut Random, assembly: &GearPair) -> Mating {
    let whole = if random.chance(0.2) {
        random.within(-1000.0, 1000.0).round()
    } else {
        0.0
    };
    Mating {
        wheel_tooth: random.one_of(assembly.teeth(Member::Wheel)),
        pinion_tooth: random.one_of(assembly.teeth(Member::Pinion)),
        flank: either(random, Side::BOTH),
        fraction: whole + random.within(0.0, 1.0),
    }
}
