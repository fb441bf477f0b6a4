//! A pair of gears and one of its poses, from a seed and a number. Impossible gears (pointed teeth, closed spaces) are drawn again.

use super::gear::Numbers;
use super::random::{Random, either};
use gearlash::analytic::InvolutePair;
use gearlash::gear::{AsBuilt, Hand, Side};
use gearlash::pair::{GearPair, Mating, Member};
use serde_json::json;
use std::sync::Arc;

/// Poses per pair, each with its own centre distance, locked gear, mating and fraction.
pub const POSES_A_PAIR: u64 = 4;

/// The gears of a campaign.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize)]
pub enum Teeth {
    Spur,
    /// Helix angles of 0.5 to 50°, faces of up to 100 modules that begin before the measuring plane and end behind it.
    Helical,
}

/// Separate from the numbers of the gears: helical pairs are those spur pairs, twisted.
const HELIX: u64 = 0x4845_4c49;

/// The distance of the gears of a pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum, serde::Deserialize)]
pub enum Depth {
    /// From jammed to tips that barely reach; mostly in mesh
    Any,
    /// Tip circles that overlap, or nearly, by 0.2 m down to 1e-4 m: only the tips are left of the mesh
    Grazing,
    /// Tips within 0.1 m to 1e-4 m of a root, on either side of contact
    OnRoot,
}

/// A drawn pair.
pub struct Pair {
    numbers: Arc<[Numbers; 2]>,
    gears: [AsBuilt; 2],
    seed: u64,
    number: u64,
    /// The common face, mm.
    face: [f64; 2],
}

/// A pose of a drawn pair.
pub struct Drawn {
    pub gears: Arc<[Numbers; 2]>,
    pub assembly: GearPair,
    pub mating: Mating,
}

impl Pair {
    /// Spur pair number `number` of `seed`: poses `number * POSES_A_PAIR` and on.
    pub fn new(seed: u64, number: u64) -> Pair {
        Pair::of(Teeth::Spur, seed, number)
    }

    /// [`Pair::new`] for spur or helical gears.
    pub fn of(kind: Teeth, seed: u64, number: u64) -> Pair {
        let mut random = Random::of(seed, number);
        let mut winding = Random::of(seed ^ HELIX, number);
        let angle_deg = winding.within(0.5, 50.0);
        let hand = winding.pick(&[Hand::Right, Hand::Left]);
        let widest = winding.pick(&[10.0, 30.0, 100.0]);
        let width = winding.within(0.01 * widest, widest);
        let from = -width * winding.within(0.0, 1.0);
        loop {
            let undercut = random.chance(0.25);
            let first = random.decades(3.0, if undercut { 16.0 } else { 401.0 }) as u32;
            // The mate of an undercut gear can have any number of teeth.
            let second = random.decades(3.0, 401.0) as u32;
            let module = random.decades(0.05, 20.0);
            let alpha = if random.chance(0.4) {
                random.pick(&[14.5, 20.0, 25.0, 30.0])
            } else {
                random.within(14.5, 30.0)
            };
            let teeth = either(&mut random, [[second, first], [first, second]]);
            let hands = [hand, hand.mate()];
            let [wheel, pinion] = [0, 1].map(|k: usize| {
                let teeth = teeth[k];
                // One gear at a time: a pair with two possible gears would be rare, and unusual ones rarer.
                (0..50).find_map(|_| {
                    let mut numbers = Numbers::draw(&mut random, teeth, module, alpha);
                    if kind == Teeth::Helical {
                        numbers.wind(angle_deg, hands[k]);
                    }
                    numbers.build().map(|gear| (numbers, gear))
                })
            });
            if let (Some(wheel), Some(pinion)) = (wheel, pinion) {
                return Pair {
                    numbers: Arc::new([wheel.0, pinion.0]),
                    gears: [wheel.1, pinion.1],
                    seed,
                    number,
                    face: match kind {
                        Teeth::Spur => [0.0; 2],
                        Teeth::Helical => [from, from + width].map(|end| end * module),
                    },
                };
            }
        }
    }

    pub fn gears(&self) -> &[AsBuilt; 2] {
        &self.gears
    }

    /// Pose `k` of the pair, at `depth` or at any depth.
    pub fn pose(&self, k: u64, depth: Option<Depth>) -> Drawn {
        use Depth::{Any, Grazing, OnRoot};
        let mut random = Random::of(!self.seed, self.number * POSES_A_PAIR + k);
        let drawn = random.pick(&[Any, Any, Any, Grazing, OnRoot]);
        let depth = depth.unwrap_or(drawn);
        let locked = random.pick(&[Member::Wheel, Member::Pinion]);
        let [wheel, pinion] = &self.gears;
        // A pose that cannot be assembled (overlapping base circles) is drawn again. Gears that can never be so near
        // get a greater distance.
        let depths = std::iter::repeat_n(depth, 20).chain(std::iter::repeat(Any));
        let assembly = depths
            .map(|depth| self.distance(&mut random, depth))
            .find_map(|a| GearPair::with_locked(wheel.clone(), pinion.clone(), a, locked).ok())
            .expect("a distance between jam and out of mesh");
        let assembly = assembly.with_face(self.face).expect("ends in order");
        let mut fraction = 0.0;
        if random.chance(0.2) {
            fraction += random.within(-50.0, 50.0).round();
        }
        if !random.chance(0.1) {
            fraction += random.within(0.0, 1.0);
        }
        let mating = Mating {
            wheel_tooth: random.one_of(self.numbers[0].teeth),
            pinion_tooth: random.one_of(self.numbers[1].teeth),
            flank: random.pick(&Side::BOTH),
            fraction,
        };
        Drawn {
            gears: Arc::clone(&self.numbers),
            assembly,
            mating,
        }
    }

    fn distance(&self, random: &mut Random, depth: Depth) -> f64 {
        let [wheel, pinion] = [&self.gears[0], &self.gears[1]];
        let module = self.numbers[0].module_mm;
        let off = wheel.eccentricity() + pinion.eccentricity();
        let base = wheel.gear().base_radius() + pinion.gear().base_radius();
        let tips = wheel.gear().tip_radius() + pinion.gear().tip_radius();
        let bottom =
            |one: &AsBuilt, other: &AsBuilt| one.gear().tip_radius() + other.gear().root_radius();
        let touching = bottom(wheel, pinion).max(bottom(pinion, wheel));
        let least = base + 1e-3 * module;
        match depth {
            Depth::Any if random.chance(0.5) => {
                let pair = InvolutePair::new(wheel.gear(), pinion.gear());
                let tight = pair.center_distance(0.0).unwrap_or(touching);
                (tight + random.within(-0.3, 0.4) * module).max(least)
            }
            Depth::Any => {
                let jammed = (touching - 0.5 * module).max(least);
                random.within(jammed, jammed.max(tips + 0.5 * off))
            }
            Depth::Grazing => {
                let aside = random.within(-1.0, 1.0) * off;
                (tips + aside - random.decades(1e-4, 0.2) * module).max(least)
            }
            Depth::OnRoot => {
                let beyond = random.decades(1e-4, 0.1) * module;
                let side = random.pick(&[1.0, -1.0]);
                (touching + random.within(-1.0, 1.0) * off + side * beyond).max(least)
            }
        }
    }
}

impl Drawn {
    /// Pose number `index` of the campaign of `seed` for spur gears, at `depth` or at any depth.
    pub fn new(depth: Option<Depth>, seed: u64, index: u64) -> Drawn {
        Drawn::of(Teeth::Spur, depth, seed, index)
    }

    /// [`Drawn::new`] for spur or helical gears.
    pub fn of(kind: Teeth, depth: Option<Depth>, seed: u64, index: u64) -> Drawn {
        Pair::of(kind, seed, index / POSES_A_PAIR).pose(index % POSES_A_PAIR, depth)
    }

    /// The pose as a pair file in JSON that reproduces it to the last bit, its flank in the title (a pair file runs both).
    pub fn pair_file(&self) -> String {
        let (assembly, mating) = (&self.assembly, &self.mating);
        let gears = self.gears.each_ref();
        let [wheel, pinion] = gears.map(|gear| gear.table(assembly.face()));
        let file = json!({
            "title": format!("pose at the {} flank", mating.flank.name()),
            "wheel": wheel,
            "pinion": pinion,
            "assembly": {
                "center_distance_mm": assembly.center_distance(),
                "locked": assembly.locked().name(),
            },
            "sweep": {
                "mating": [[mating.wheel_tooth, mating.pinion_tooth]],
                "fraction": [mating.fraction],
            },
        });
        format!("{file:#}")
    }
}
