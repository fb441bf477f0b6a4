//! Seeded random pairs and poses, leaning towards the awkward: undercut, tips on fillets,
//! alternating pitch errors at hand-over, eccentric axes, interference.

use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Pitch, Side, involute,
};
use gearlash::pair::{GearPair, Mating, Member};

/// SplitMix64 (Steele, Lea and Flood 2014): a seed gives one sequence, on any machine.
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub fn chance(&mut self, share: f64) -> bool {
        self.unit() < share
    }

    /// Log-uniform.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        (self.within(low.ln(), high.ln())).exp()
    }

    pub fn tooth(&mut self, teeth: u32) -> u32 {
        1 + (self.bits() % u64::from(teeth)) as u32
    }
}

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

/// Deviations up to six times ordinary, half of all free gears eccentric.
pub const WILD: Kind = Kind {
    teeth: (7.0, 1000.0),
    deviation: 6.0,
    shift: (-0.3, 0.4),
};

/// A pair of `kind` that can exist.
pub fn pair(random: &mut Random, kind: Kind) -> GearPair {
    loop {
        if let Some(assembly) = try_pair(random, kind) {
            return assembly;
        }
    }
}

fn try_pair(random: &mut Random, kind: Kind) -> Option<GearPair> {
    let module = random.decades(0.05, 20.0);
    let alpha = random.within(14.5, 28.0).to_radians();
    let addendum = random.within(0.8, 1.25);
    let rack = BasicRack::new(
        addendum,
        addendum + random.within(0.1, 0.35),
        random.within(0.0, 0.4),
    )
    .ok()?;
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
    let locked = if random.chance(0.5) {
        Member::Wheel
    } else {
        Member::Pinion
    };
    let style = random.unit();
    let built: Vec<AsBuilt> = gears
        .into_iter()
        .map(|gear| as_built(random, gear, kind.deviation, style))
        .collect::<Option<_>>()?;
    let [wheel, pinion] = <[AsBuilt; 2]>::try_from(built).ok()?;
    GearPair::with_locked(wheel, pinion, distance, locked).ok()
}

fn as_built(random: &mut Random, gear: Gear, deviation: f64, style: f64) -> Option<AsBuilt> {
    let face = if random.chance(0.5) {
        Face::Front
    } else {
        Face::Back
    };
    let teeth = gear.basic_data().teeth();
    let module = gear.basic_data().module();
    // Ordinary: 10 µm of pitch and thickness, 20 µm of runout at module 3.
    let scale = deviation * random.unit() * 0.003 * module;
    let list = |random: &mut Random, alternating: bool| -> Vec<f64> {
        (0..teeth)
            .map(|k| {
                let sign = if alternating && k % 2 == 0 { 2.0 } else { 0.0 };
                scale * (random.within(-1.0, 1.0) + sign)
            })
            .collect()
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
            deviations.eccentricity = 0.003 * module * deviation * random.unit();
            deviations.high_tooth = random.within(1.0, f64::from(teeth) + 1.0);
        }
    }
    AsBuilt::new(gear, face, &deviations).ok()
}

/// A pose of `assembly` up to a thousand pitches beyond a mating.
pub fn mating(random: &mut Random, assembly: &GearPair) -> Mating {
    let teeth = |member| assembly.gear(member).gear().basic_data().teeth();
    let whole = if random.chance(0.2) {
        random.within(-1000.0, 1000.0).round()
    } else {
        0.0
    };
    Mating {
        wheel_tooth: random.tooth(teeth(Member::Wheel)),
        pinion_tooth: random.tooth(teeth(Member::Pinion)),
        flank: if random.chance(0.5) {
            Side::Right
        } else {
            Side::Left
        },
        fraction: whole + random.unit(),
    }
}
