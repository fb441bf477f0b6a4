//! Random poses for both methods, from a seed: the campaign of exact against polygon.
//!
//! Used by `examples/campaign.rs` and `tests/campaign.rs`. A pair is drawn as numbers of a pair file, so
//! that any pose can be printed and run again. What is drawn leans towards the awkward: undercut
//! teeth, alternating pitch deviations (hand-over on tip corners), eccentric axes, tips deep in roots, tips
//! that hardly reach. Centre distances stay below about 300 mm: tips that graze each other magnify
//! the rounding of coordinates a thousandfold, and at a metre that is more than a picometre.

use gearlash::analytic::InvolutePair;
use gearlash::gear::{
    AsBuilt, Blank, Deviations, Face, Gear, Pitch, Rack, Side, Toothing, thickness,
};
use gearlash::mesh::{Certifier, Contact, CutPair, ExactKernel, LostMotion, Status, Touch};
use gearlash::pair::{Assembly, Mating, Member, Pose};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fmt::Write;

/// Largest difference between the two methods that passes, µm.
pub const AGREEMENT_UM: f64 = 1e-6;

/// How far the gears of a pair are apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Depth {
    /// From jammed to tips that hardly reach; mostly in mesh.
    Any,
    /// Tip circles that overlap by 0.2 m down to 1e-4 m, or nearly so: nothing but the tips is left of the mesh.
    /// A grazing contact magnifies rounding: the methods must agree within their own error bounds.
    Grazing,
    /// The other end: tips within 0.1 m to 1e-4 m of a root, on either side of touching it.
    OnRoot,
}

/// A contact this near to the form circle, mm, is the joint of involute and fillet.
const JOINT: f64 = 1e-6;

/// SplitMix64 (Steele, Lea and Flood 2014): a seed gives one sequence, on any machine.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }

    fn log_within(&mut self, low: f64, high: f64) -> f64 {
        self.within(low.ln(), high.ln()).exp()
    }

    fn chance(&mut self, share: f64) -> bool {
        self.within(0.0, 1.0) < share
    }

    fn list(&mut self, count: u32, mut draw: impl FnMut(&mut Random, u32) -> f64) -> Vec<f64> {
        (0..count).map(|k| draw(self, k)).collect()
    }
}

/// The numbers of one gear, as in a pair file.
struct Numbers {
    teeth: u32,
    module_mm: f64,
    pressure_angle_deg: f64,
    profile_shift: f64,
    rack: [f64; 3],
    allowance_um: f64,
    face: Face,
    runout_um: f64,
    high_tooth: f64,
    per_tooth_um: Vec<f64>,
    right_um: Vec<f64>,
    left_um: Vec<f64>,
}

impl Numbers {
    fn build(&self) -> Option<AsBuilt> {
        let mm = |list: &[f64]| list.iter().map(|um| um / 1e3).collect::<Vec<f64>>();
        let blank = Blank {
            toothing: Toothing::new(
                self.teeth,
                self.module_mm,
                self.pressure_angle_deg.to_radians(),
            )
            .ok()?,
            profile_shift: self.profile_shift,
            rack: Rack::new(self.rack[0], self.rack[1], self.rack[2]).ok()?,
            tip_diameter: None,
        };
        let base = thickness::base_from_allowance(
            &blank.toothing,
            blank.nominal_base_thickness(),
            self.allowance_um / 1e3,
        );
        let pitch = !self.right_um.is_empty();
        let deviations = Deviations {
            per_tooth: mm(&self.per_tooth_um),
            pitch: pitch.then(|| Pitch::from_cumulative(&mm(&self.right_um), &mm(&self.left_um))),
            eccentricity: self.runout_um / 1e3 / 2.0,
            high_tooth: self.high_tooth,
        };
        AsBuilt::new(Gear::new(blank, base).ok()?, self.face, &deviations).ok()
    }

    fn write(&self, name: &str, text: &mut String) -> std::fmt::Result {
        let face = match self.face {
            Face::Front => "front",
            Face::Back => "back",
        };
        writeln!(text, "[{name}]\nteeth = {}", self.teeth)?;
        writeln!(text, "module_mm = {:?}", self.module_mm)?;
        writeln!(text, "pressure_angle_deg = {:?}", self.pressure_angle_deg)?;
        writeln!(text, "profile_shift = {:?}", self.profile_shift)?;
        writeln!(text, "reference_face = \"{face}\"")?;
        let [addendum, dedendum, root_radius] = self.rack;
        writeln!(
            text,
            "rack = {{ addendum = {addendum:?}, dedendum = {dedendum:?}, root_radius = {root_radius:?} }}"
        )?;
        writeln!(text, "[{name}.thickness]")?;
        writeln!(text, "allowance_um = {:?}", self.allowance_um)?;
        if !self.per_tooth_um.is_empty() {
            writeln!(text, "per_tooth_um = {:?}", self.per_tooth_um)?;
        }
        if self.runout_um > 0.0 {
            let (total, high) = (self.runout_um, self.high_tooth);
            writeln!(
                text,
                "[{name}.runout]\ntotal_um = {total:?}\nhigh_tooth = {high:?}"
            )?;
        }
        if !self.right_um.is_empty() {
            let (right, left) = (&self.right_um, &self.left_um);
            writeln!(text, "[{name}.pitch]\nkind = \"cumulative\"")?;
            writeln!(text, "right_um = {right:?}\nleft_um = {left:?}")?;
        }
        Ok(())
    }
}

/// A pair and a pose of it.
pub struct Drawn {
    gears: [Numbers; 2],
    pub assembly: Assembly,
    pub mating: Mating,
}

/// What both gears of a pair share.
struct Style {
    teeth: (f64, f64),
    shift: (f64, f64),
    /// Deviations, mm: several times the ordinary at most.
    deviation: f64,
    alternating: bool,
}

impl Drawn {
    /// Pose number `index` of the campaign of `seed` at `depth`.
    pub fn new(depth: Depth, seed: u64, index: u64) -> Drawn {
        let mut random = Random(Random(seed.wrapping_add(index)).bits());
        loop {
            // Most draws make gears that can exist; the others (pointed, no space) are drawn again.
            if let Some(drawn) = Drawn::draw(&mut random, depth) {
                return drawn;
            }
        }
    }

    fn draw(random: &mut Random, depth: Depth) -> Option<Drawn> {
        let undercut = random.chance(0.3);
        let mut style = Style {
            teeth: if undercut { (7.0, 15.0) } else { (7.0, 1001.0) },
            shift: if undercut { (-0.4, 0.2) } else { (-0.4, 0.8) },
            deviation: 0.0,
            alternating: random.chance(0.4),
        };
        let first = random.log_within(style.teeth.0, style.teeth.1) as u32;
        // An undercut gear's mate may have any number of teeth.
        style.teeth = (7.0, 1001.0);
        let second = random.log_within(style.teeth.0, style.teeth.1) as u32;
        let most = 600.0 / f64::from(first + second);
        let module = random.log_within(0.05, 20.0f64.min(most));
        let alpha = random.within(14.5, 28.0);
        let addendum = random.within(0.8, 1.25);
        let rack = [
            addendum,
            addendum + random.within(0.1, 0.35),
            random.within(0.0, 0.4),
        ];
        // Ordinary: 10 µm at module 3.
        style.deviation = if random.chance(0.15) {
            0.0
        } else {
            random.within(0.0, 6.0) * 0.003 * module
        };
        let swapped = random.chance(0.5);
        let teeth = if swapped {
            [second, first]
        } else {
            [first, second]
        };
        let gears = teeth.map(|teeth| numbers(random, teeth, module, alpha, rack, &style));
        let [wheel, pinion] = [gears[0].build()?, gears[1].build()?];
        let tight = InvolutePair::new(wheel.gear(), pinion.gear()).center_distance(0.0)?;
        let distance = match depth {
            Depth::Any => {
                let apart = match random.within(0.0, 1.0) {
                    u if u < 0.8 => random.within(-0.3, 0.4),
                    u if u < 0.93 => random.within(0.4, 2.2),
                    _ => random.within(-0.8, -0.1),
                };
                tight + apart * module
            }
            Depth::Grazing => {
                let tips = wheel.gear().tip_radius() + pinion.gear().tip_radius();
                let off = wheel.eccentricity() + pinion.eccentricity();
                tips + random.within(-1.0, 1.0) * off - random.log_within(1e-4, 0.2) * module
            }
            Depth::OnRoot => {
                let bottom = |one: &AsBuilt, other: &AsBuilt| {
                    one.gear().tip_radius() + other.gear().root_radius()
                };
                let touching = bottom(&wheel, &pinion).max(bottom(&pinion, &wheel));
                let off = wheel.eccentricity() + pinion.eccentricity();
                let beyond = random.log_within(1e-4, 0.1) * module;
                let side = if random.chance(0.5) { 1.0 } else { -1.0 };
                touching + random.within(-1.0, 1.0) * off + side * beyond
            }
        };
        let locked = match random.chance(0.5) {
            true => Member::Wheel,
            false => Member::Pinion,
        };
        let assembly = Assembly::new(wheel, pinion, distance, locked).ok()?;
        let whole = match random.chance(0.2) {
            true => random.within(-50.0, 50.0).round(),
            false => 0.0,
        };
        let part = match random.chance(0.1) {
            true => 0.0,
            false => random.within(0.0, 1.0),
        };
        let mut tooth = |teeth: u32| 1 + (random.bits() % u64::from(teeth)) as u32;
        let mating = Mating {
            wheel_tooth: tooth(teeth[0]),
            pinion_tooth: tooth(teeth[1]),
            flank: Side::BOTH[tooth(2) as usize - 1],
            fraction: whole + part,
        };
        Some(Drawn {
            gears,
            assembly,
            mating,
        })
    }

    /// The pose as a pair file, its flank in the title (a pair file runs both).
    pub fn pair_file(&self) -> String {
        let mating = &self.mating;
        let mut text = format!("title = \"pose at the {} flank\"\n", mating.flank.name());
        for (numbers, name) in self.gears.iter().zip(["wheel", "pinion"]) {
            // Writing to a String cannot fail.
            let _ = numbers.write(name, &mut text);
        }
        let _ = writeln!(
            text,
            "[assembly]\ncenter_distance_mm = {:?}\nlocked = \"{}\"\n[sweep]\nmating = [[{}, {}]]\nfraction = [{:?}]",
            self.assembly.center_distance(),
            self.assembly.locked().name(),
            mating.wheel_tooth,
            mating.pinion_tooth,
            mating.fraction,
        );
        text
    }

    fn free_is_eccentric(&self) -> bool {
        self.assembly.gear(self.assembly.free()).eccentricity() > 0.0
    }

    fn is_undercut(&self) -> bool {
        [Member::Wheel, Member::Pinion].iter().any(|&member| {
            let gear = self.assembly.gear(member).gear();
            gear.fillet().end() < TAU / 4.0 - gear.toothing().pressure_angle()
        })
    }
}

fn numbers(
    random: &mut Random,
    teeth: u32,
    module_mm: f64,
    pressure_angle_deg: f64,
    rack: [f64; 3],
    style: &Style,
) -> Numbers {
    let um = style.deviation * 1e3;
    let off = |random: &mut Random| {
        random.list(teeth, |random, k| {
            let high = style.alternating && k % 2 == 0;
            um * (random.within(-1.0, 1.0) + if high { 2.0 } else { 0.0 })
        })
    };
    let by_pitch = random.chance(0.7);
    let [per_tooth_um, right_um, left_um] = match (um > 0.0, by_pitch) {
        (false, _) => [vec![], vec![], vec![]],
        (true, true) => [vec![], off(random), off(random)],
        (true, false) => [off(random), vec![], vec![]],
    };
    // Now and then a third of the tooth depth.
    let greatest = if random.chance(0.1) { 1.4 } else { 0.036 };
    let eccentric = um > 0.0 && random.chance(0.6);
    Numbers {
        teeth,
        module_mm,
        pressure_angle_deg,
        profile_shift: random.within(style.shift.0, style.shift.1),
        rack,
        allowance_um: random.within(-30.0, 5.0) * module_mm,
        face: match random.chance(0.5) {
            true => Face::Front,
            false => Face::Back,
        },
        runout_um: match eccentric {
            true => random.within(0.0, greatest) * module_mm * 1e3,
            false => 0.0,
        },
        high_tooth: random.within(1.0, f64::from(teeth) + 1.0),
        per_tooth_um,
        right_um,
        left_um,
    }
}

/// What both methods and the certificate say about one pose.
struct Outcome {
    status: Status,
    curves: Vec<String>,
    off_involute: bool,
    eccentric: bool,
    undercut: bool,
    difference_um: f64,
    /// What the error bounds of both methods together allow.
    bound_um: f64,
    fault: Option<String>,
}

impl Outcome {
    fn new(drawn: &Drawn, depth: Depth) -> Result<Outcome, String> {
        let assembly = &drawn.assembly;
        let pose = Pose::new(assembly, drawn.mating);
        let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|m| assembly.gear(m));
        let cut = CutPair::new(wheel, pinion, 1e-4 * wheel.gear().toothing().module());
        let exact = ExactKernel::new(assembly).lost_motion(&pose);
        let polygon = cut.refined_kernel(assembly).lost_motion(&pose);
        let exact = exact.map_err(|error| format!("exact: {error}"))?;
        let polygon = polygon.map_err(|error| format!("polygon: {error}"))?;
        let certificate = Certifier::new(cut.kernel(assembly)).check(&pose, &exact);
        let difference_um = difference_um(assembly, &exact, &polygon);
        let bound_um = bound_um(assembly, &exact) + bound_um(assembly, &polygon);
        let allowed = match depth {
            Depth::Any => AGREEMENT_UM,
            Depth::Grazing | Depth::OnRoot => bound_um,
        };
        let fault = if exact.status() != polygon.status() {
            Some("the statuses differ".to_owned())
        } else if difference_um > allowed {
            Some(format!("{difference_um:.2e} µm apart"))
        } else {
            certificate.err().map(|error| error.to_string())
        };
        let counts = matches!(exact.status(), Status::Clear | Status::Interference);
        let contacts = [exact.right, exact.left].into_iter().flatten();
        let curves: Vec<String> = contacts
            .filter(|_| counts)
            .map(|contact| combination(assembly, &contact))
            .collect();
        Ok(Outcome {
            status: exact.status(),
            off_involute: curves.iter().any(|curves| curves != "involute–involute"),
            curves,
            eccentric: drawn.free_is_eccentric(),
            undercut: drawn.is_undercut(),
            difference_um,
            bound_um,
            fault: fault.map(|fault| format!("{fault}\nexact   {exact:?}\npolygon {polygon:?}")),
        })
    }
}

/// Greatest difference of right rotation, left rotation and lost motion, µm of `j_wt`; of a jammed pose none.
fn difference_um(assembly: &Assembly, exact: &LostMotion, polygon: &LostMotion) -> f64 {
    let um = assembly.operating_pitch_radius(assembly.free()) * 1e3;
    if exact.status() == Status::Jammed {
        return 0.0;
    }
    let turn = |angle: f64| (angle - TAU * (angle / TAU).round()).abs() * um;
    let side = |one: Option<Contact>, other: Option<Contact>| match (one, other) {
        (Some(one), Some(other)) => turn(one.rotation - other.rotation),
        (None, None) => 0.0,
        _ => f64::INFINITY,
    };
    let lost_motion = match (exact.angle(), polygon.angle()) {
        (Some(exact), Some(polygon)) => (exact - polygon).abs() * um,
        (None, None) => 0.0,
        _ => f64::INFINITY,
    };
    side(exact.right, polygon.right)
        .max(side(exact.left, polygon.left))
        .max(lost_motion)
}

/// The error bounds of both sides, µm of `j_wt`.
fn bound_um(assembly: &Assembly, found: &LostMotion) -> f64 {
    let sides = [found.right, found.left].into_iter().flatten();
    let error: f64 = sides.map(|contact| contact.error).sum();
    error * assembly.operating_pitch_radius(assembly.free()) * 1e3
}

/// The two curves of a contact, in alphabetical order.
fn combination(assembly: &Assembly, contact: &Contact) -> String {
    let name = |member: Member, touch: &Touch| {
        let form = assembly.gear(member).gear().form_radius();
        match (touch.radius - form).abs() <= JOINT {
            true => "joint",
            false => touch.curve.name(),
        }
    };
    let mut names = [
        name(Member::Wheel, &contact.wheel),
        name(Member::Pinion, &contact.pinion),
    ];
    names.sort_unstable();
    names.join("–")
}

/// What a campaign met.
#[derive(Default)]
pub struct Tally {
    pub poses: u64,
    /// With a contact that is not involute on involute.
    pub off_involute: u64,
    pub free_eccentric: u64,
    pub undercut: u64,
    pub statuses: BTreeMap<&'static str, u64>,
    /// Contacts of clear and interfering poses.
    pub curves: BTreeMap<String, u64>,
    pub greatest_um: f64,
    /// Greatest sum of both methods' error bounds.
    pub greatest_bound_um: f64,
    /// Poses without a result by one method at least.
    pub without_result: u64,
    /// What differs or has no result: number of the pose and what was found.
    pub faults: Vec<(u64, String)>,
}

impl Tally {
    fn add(&mut self, index: u64, outcome: Result<Outcome, String>) {
        self.poses += 1;
        let outcome = match outcome {
            Ok(outcome) => outcome,
            Err(lost) => {
                self.without_result += 1;
                self.faults.push((index, lost));
                return;
            }
        };
        self.off_involute += u64::from(outcome.off_involute);
        self.free_eccentric += u64::from(outcome.eccentric);
        self.undercut += u64::from(outcome.undercut);
        *self.statuses.entry(outcome.status.name()).or_default() += 1;
        for curves in outcome.curves {
            *self.curves.entry(curves).or_default() += 1;
        }
        self.greatest_bound_um = self.greatest_bound_um.max(outcome.bound_um);
        match outcome.fault {
            Some(fault) => self.faults.push((index, fault)),
            None => self.greatest_um = self.greatest_um.max(outcome.difference_um),
        }
    }
}

/// `poses` poses of `seed` at `depth` by both methods, on all threads.
pub fn run(depth: Depth, poses: u64, seed: u64) -> Tally {
    let outcomes: Vec<_> = (0..poses)
        .into_par_iter()
        .map(|index| Outcome::new(&Drawn::new(depth, seed, index), depth))
        .collect();
    let mut tally = Tally::default();
    for (index, outcome) in (0..).zip(outcomes) {
        tally.add(index, outcome);
    }
    tally
}
