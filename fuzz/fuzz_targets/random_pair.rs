//! A random pair over the whole range that a pair file may state, one pose by exact method, polygon method and certificate.
#![no_main]

use arbitrary::Arbitrary;
use gearlash::analysis::study::Study;
use gearlash::contact::{CutPair, Method, sweep};
use gearlash::pair::{GearPair, Member};
use gearlash_fuzz::folder::Folder;
use gearlash_fuzz::pose::agree;
use libfuzzer_sys::{Corpus, fuzz_target};
use std::f64::consts::PI;
use std::fmt::Write;
use gearlash::error::go_on;

/// A place in a range; 0, which fuzzers are fond of, is its ordinary one.
#[derive(Arbitrary, Clone, Copy, Debug)]
struct Part(i16);

impl Part {
    fn within(self, low: f64, ordinary: f64, high: f64) -> f64 {
        let part = f64::from(self.0) / f64::from(i16::MAX);
        let end = if part < 0.0 { low } else { high };
        (ordinary + part.abs().min(1.0) * (end - ordinary)).clamp(low, high)
    }

    fn either_way(self, most: f64) -> f64 {
        self.within(-most, 0.0, most)
    }
}

#[derive(Arbitrary, Debug)]
struct Gear {
    teeth: Part,
    shift: Part,
    addendum: Part,
    dedendum: Part,
    round: Part,
    tip: Option<Part>,
    allowance: Part,
    back: bool,
    runout: Part,
    high_tooth: Part,
    /// Unit of the lists.
    per_tooth: Part,
    pitch: Part,
    /// Repeated round the gear.
    thicker: [i8; 5],
    right: [i8; 7],
    left: [i8; 7],
    tooth: u16,
    slope: Part,
    crowning: Part,
    /// Slope of the right flanks alone.
    right_slope: Part,
}

#[derive(Arbitrary, Debug)]
enum Distance {
    /// As given by both profile shifts, and half a module either way.
    Play(Part),
    /// About where tips stop reaching each other.
    Tips(Part),
    /// About where a tip of the wheel or of the pinion reaches the other's root.
    Root(bool, Part),
    /// From base circles that touch to tips out of reach.
    Any(Part),
}

#[derive(Arbitrary, Debug)]
struct Random {
    module: Part,
    angle: Part,
    gears: [Gear; 2],
    distance: Distance,
    /// 0: spur gears.
    helix: Part,
    face: Part,
    pinion_locked: bool,
    fraction: i16,
}

impl Gear {
    /// 3 … 300; most are few, where teeth are hard.
    fn teeth(&self) -> u32 {
        self.teeth
            .within(3f64.ln(), 18f64.ln(), 300f64.ln())
            .exp()
            .round() as u32
    }

    /// Addendum, dedendum, root radius, of which only those that fit the angle are any use.
    fn rack(&self, angle: f64) -> [f64; 3] {
        let dedendum = self.dedendum.within(0.05, 1.25, 2.0);
        let flat = PI / 4.0 - dedendum * angle.tan();
        let fits = (flat * angle.cos() / (1.0 - angle.sin())).clamp(0.0, dedendum);
        [
            self.addendum.within(0.02, 1.0, 2.0),
            dedendum,
            self.round.within(0.0, 0.38, 1.0).min(fits),
        ]
    }

    fn write(
        &self,
        name: &str,
        module: f64,
        angle: f64,
        winds: &str,
        text: &mut String,
    ) -> std::fmt::Result {
        let teeth = self.teeth();
        let um = module * 1e3;
        let face = if self.back { "back" } else { "front" };
        writeln!(text, "[{name}]\nteeth = {teeth}\nmodule_mm = {module:?}")?;
        writeln!(text, "pressure_angle_deg = {:?}", angle.to_degrees())?;
        writeln!(text, "profile_shift = {:?}\n{winds}", self.shift())?;
        writeln!(text, "reference_face = \"{face}\"")?;
        let [addendum, dedendum, round] = self.rack(angle);
        if let Some(tip) = self.tip {
            let radius =
                module * (f64::from(teeth) / 2.0 + self.shift() + addendum + tip.either_way(0.5));
            writeln!(text, "tip_diameter_mm = {:?}", 2.0 * radius)?;
        }
        writeln!(text, "[{name}.rack]\naddendum = {addendum:?}")?;
        writeln!(text, "dedendum = {dedendum:?}\nroot_radius = {round:?}")?;
        writeln!(
            text,
            "[{name}.thickness]\nallowance_um = {:?}",
            self.allowance.either_way(0.5) * um
        )?;
        let round_the_gear = |list: &[i8], most: f64| -> Vec<f64> {
            let values = list.iter().cycle().take(teeth as usize);
            values
                .map(|&value| f64::from(value) / 128.0 * most)
                .collect()
        };
        let most = self.per_tooth.either_way(0.5) * um;
        if most != 0.0 {
            writeln!(
                text,
                "per_tooth_um = {:?}",
                round_the_gear(&self.thicker, most)
            )?;
        }
        let total = self.runout.either_way(2.0).abs() * um;
        if total != 0.0 {
            let high = self.high_tooth.within(1.0, 1.0, f64::from(teeth) + 0.999);
            writeln!(
                text,
                "[{name}.runout]\ntotal_um = {total:?}\nhigh_tooth = {high:?}"
            )?;
        }
        let most = self.pitch.either_way(1.5) * um;
        if most != 0.0 {
            writeln!(text, "[{name}.pitch]\nkind = \"cumulative\"")?;
            writeln!(text, "right_um = {:?}", round_the_gear(&self.right, most))?;
            writeln!(text, "left_um = {:?}", round_the_gear(&self.left, most))?;
        }
        let [slope, crowning, right] =
            [self.slope, self.crowning, self.right_slope].map(|part| part.either_way(0.02) * um);
        if [slope, crowning, right] != [0.0; 3] {
            writeln!(text, "[{name}.profile]\ncrowning_um = {crowning:?}")?;
            if right == 0.0 {
                writeln!(text, "slope_um = {slope:?}")?
            } else {
                writeln!(
                    text,
                    "right.slope_um = {right:?}\nleft.slope_um = {slope:?}"
                )?
            }
        }
        Ok(())
    }

    fn shift(&self) -> f64 {
        self.shift.either_way(1.2)
    }

    /// Pitch radius, modules.
    fn radius(&self) -> f64 {
        f64::from(self.teeth()) / 2.0
    }

    /// Tip and root radius before deviations, modules.
    fn tip_and_root(&self, angle: f64) -> [f64; 2] {
        let [addendum, dedendum, _] = self.rack(angle);
        let raised = self.tip.map_or(0.0, |tip| tip.either_way(0.5));
        let x = self.shift();
        let thicker = self.allowance.either_way(0.5) / (2.0 * angle.tan());
        [
            self.radius() + x + addendum + raised,
            self.radius() - dedendum + x + thicker,
        ]
    }
}

impl Random {
    fn helix_deg(&self) -> f64 {
        self.helix.either_way(35.0)
    }

    /// Helix keys of the pair file; empty for spur gears.
    fn winds(&self, name: &str, module: f64) -> String {
        let helix = self.helix_deg();
        let hand = if (helix < 0.0) == (name == "wheel") {
            "left"
        } else {
            "right"
        };
        if helix == 0.0 {
            String::new()
        } else {
            format!(
                "helix_angle_deg = {:?}\nhand = \"{hand}\"\nface_width_mm = {:?}",
                helix.abs(),
                self.face.within(0.5, 8.0, 20.0) * module
            )
        }
    }

    fn pair_file(&self) -> String {
        let module = 10f64.powf(self.module.within(-2.0, 0.0, 3.0));
        let angle = self.angle.within(5.0, 20.0, 45.0).to_radians();
        let [wheel, pinion] = &self.gears;
        let mut text = String::new();
        for (gear, name) in [(wheel, "wheel"), (pinion, "pinion")] {
            // Writing to a String cannot fail.
            let _ = gear.write(name, module, angle, &self.winds(name, module), &mut text);
        }
        let [[tip, root], [mates_tip, mates_root]] =
            [wheel, pinion].map(|gear| gear.tip_and_root(angle));
        let reference = wheel.radius() + pinion.radius();
        // Reference circles of helical gears are wider; their tips and roots stand as far beyond.
        let wider = module * reference * (1.0 / self.helix_deg().to_radians().cos() - 1.0);
        let distance = wider
            + module
                * match &self.distance {
                    Distance::Any(part) => {
                        let base = reference * angle.cos();
                        let apart = tip + mates_tip + 0.5;
                        part.within(base, reference, apart.max(reference))
                    }
                    Distance::Tips(part) => tip + mates_tip + part.either_way(0.3),
                    Distance::Root(true, part) => tip + mates_root + part.either_way(0.3),
                    Distance::Root(false, part) => root + mates_tip + part.either_way(0.3),
                    Distance::Play(part) => {
                        reference + wheel.shift() + pinion.shift() + part.either_way(0.5)
                    }
                };
        let locked = if self.pinion_locked {
            "pinion"
        } else {
            "wheel"
        };
        let teeth = [wheel, pinion].map(|gear| 1 + u32::from(gear.tooth) % gear.teeth());
        let fraction = f64::from(self.fraction) / 1024.0;
        let _ = writeln!(
            text,
            "[assembly]\ncenter_distance_mm = {distance:?}\nlocked = \"{locked}\"\n[sweep]\nmating = [{teeth:?}]\nfraction = [{fraction:?}]"
        );
        text
    }
}

/// Both methods and the certificate over the face of a helical pair, at its first pose.
fn over_the_face(study: &Study) -> Result<(), String> {
    let runs = study.runs().unwrap_or_default();
    let Some((plan, pair)) = runs
        .first()
        .and_then(|plan| Some((plan, plan.run.assembly.data()?)))
    else {
        return Ok(());
    };
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|member| pair.gear(member));
    let cut = CutPair::new(wheel, pinion, 1e-4 * wheel.gear().basic_data().module());
    for method in [Method::Both, Method::Exact { certify: true }] {
        let poses = sweep(pair, &cut, method, &plan.matings[..1], 0.0, &go_on);
        let poses = poses.map_err(|error| error.to_string())?;
        for unproven in poses.iter().flat_map(|pose| pose.unproven()) {
            // A contact that was lost, or effort that was spent, says so itself.
            if unproven.reason.contains("differ by") || unproven.reason.contains("touches") {
                return Err(format!("{method:?}: {unproven:?}"));
            }
        }
    }
    Ok(())
}

fn assembly(study: &Study) -> GearPair {
    let (_, wheel, pinion) = &study.materials[0];
    let distance = study.center_distances[0];
    GearPair::with_locked(wheel.clone(), pinion.clone(), distance, study.locked)
        .expect("a good pair file, but no assembly")
}

fuzz_target!(|random: Random| -> Corpus {
    let text = random.pair_file();
    let Some(study) = Folder::new(&text, &[]).read() else {
        return Corpus::Reject;
    };
    if random.helix_deg() != 0.0 {
        if let Err(what) = over_the_face(&study) {
            panic!("{what}\n\n{text}");
        }
        return Corpus::Keep;
    }
    let assembly = assembly(&study);
    let plan = study.sweep.as_ref().expect("[sweep] is stated");
    for mating in plan.matings(&assembly) {
        if let Err(what) = agree(&assembly, mating) {
            panic!("{what}\n{mating:?}\n\n{text}");
        }
    }
    Corpus::Keep
});
