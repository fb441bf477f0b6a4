//! Snapshots of what the exact method finds: interference, a jam, a tip on a fillet, strong deviations.

use crate::closed_form::{j_bn, pair, pose};
use crate::picture::read;
use gearlash::contact::{ExactKernel, LostMotion, Scene, Status};
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Pitch, Side,
};
use gearlash::outline::AssembledPair;
use gearlash::pair::{GearPair, Member, Pose};
use gearlash_render::{Snapshot, snapshot};
use nalgebra::Point2;

/// A pose with what the exact method finds there.
pub struct Solved {
    pub name: &'static str,
    pub assembly: GearPair,
    pub pose: Pose,
    pub lost_motion: LostMotion,
}

impl Solved {
    pub fn new(name: &'static str, assembly: GearPair, pose: Pose) -> Solved {
        let lost_motion = ExactKernel::new(&assembly).lost_motion(&pose).unwrap();
        Solved {
            name,
            assembly,
            pose,
            lost_motion,
        }
    }

    pub fn draw(&self) -> String {
        snapshot(&Snapshot {
            title: self.name,
            assembly: &self.assembled(),
            pose: &self.pose,
            material: gearlash::analysis::study::Material::AsMeasured,
            found: Ok(&self.lost_motion),
            section: None,
        })
    }

    /// The pair as pictures take it.
    pub fn assembled(&self) -> AssembledPair {
        self.assembly.clone().into()
    }
}

/// 12/60 with 200 µm of runout and 40 µm of pitch deviation, in right-hand turn `fraction`.
pub fn deviated(distance: f64, fraction: f64) -> (GearPair, Pose) {
    let wave = |teeth: u32, size: f64, shift: f64| -> Vec<f64> {
        let angle = |i| f64::from(i) / f64::from(teeth) * std::f64::consts::TAU + shift;
        (0..teeth).map(|i| size * (2.0 * angle(i)).sin()).collect()
    };
    let gear = |teeth: u32, face, eccentricity, high_tooth| {
        let gear = Gear::nominal(GearDesign {
            basic_data: BasicGearData::new(teeth, 2.0, 20f64.to_radians()).unwrap(),
            profile_shift: if teeth < 17 { 0.3 } else { 0.0 },
            rack: BasicRack::ISO_53_A,
            tip_diameter: None,
        });
        let pitch = Pitch::from_cumulative(&wave(teeth, 0.04, 0.3), &wave(teeth, 0.03, 1.1));
        let deviations = Deviations {
            per_tooth: wave(teeth, 0.02, 2.0),
            pitch: Some(pitch),
            eccentricity,
            high_tooth,
            ..Deviations::default()
        };
        AsBuilt::new(gear.unwrap(), face, &deviations).unwrap()
    };
    let wheel = gear(12, Face::Front, 0.06, 3.5);
    let pinion = gear(60, Face::Back, 0.1, 17.0);
    let assembly = GearPair::with_locked(wheel, pinion, distance, Member::Wheel).unwrap();
    let at = pose(&assembly, [3, 15], Side::Right, fraction);
    (assembly, at)
}

/// The kinds of picture that only a solver's result shows.
pub fn all() -> Vec<Solved> {
    let mut all = Vec::new();
    let mut add = |name, teeth: [u32; 2], module, distance, mating, (flank, fraction)| {
        let assembly = pair(teeth, module, distance, Member::Wheel);
        let at = pose(&assembly, mating, flank, fraction);
        all.push(Solved::new(name, assembly, at));
    };
    add(
        "solved 12/60",
        [12, 60],
        2.0,
        72.05,
        [3, 15],
        (Side::Right, 0.25),
    );
    add(
        "solved 12/60 tight",
        [12, 60],
        2.0,
        71.9,
        [3, 15],
        (Side::Left, 0.5),
    );
    add(
        "solved 44/44 tight",
        [44, 44],
        3.0,
        131.9,
        [11, 11],
        (Side::Right, 0.0),
    );
    add(
        "solved 86/21 tight",
        [86, 21],
        3.0,
        160.44,
        [1, 1],
        (Side::Right, 0.3),
    );
    add(
        "tip on fillet",
        [86, 21],
        3.0,
        160.2,
        [1, 1],
        (Side::Left, 0.75),
    );
    add(
        "jammed 86/21",
        [86, 21],
        3.0,
        158.0,
        [1, 1],
        (Side::Right, 0.0),
    );
    for (name, distance, fraction) in [
        ("deviated clear", 73.0, 0.25),
        ("deviated tight", 72.5, 0.25),
        ("deviated tighter", 72.3, -0.4),
    ] {
        let (assembly, at) = deviated(distance, fraction);
        all.push(Solved::new(name, assembly, at));
    }
    all
}

fn find(name: &str) -> Solved {
    all()
        .into_iter()
        .find(|solved| solved.name == name)
        .unwrap()
}

/// Whether the closed polygon holds the point: crossings of a ray, an odd number inside.
fn holds(polygon: &[Point2<f64>], at: Point2<f64>) -> bool {
    let next = polygon.iter().cycle().skip(1);
    let crossed = polygon.iter().zip(next).filter(|(p, q)| {
        (p.y > at.y) != (q.y > at.y) && at.x < p.x + (at.y - p.y) / (q.y - p.y) * (q.x - p.x)
    });
    crossed.count() % 2 == 1
}

/// The area of the overlap against grid points counted in both outlines and near the contact.
#[test]
fn an_overlap_has_the_area_that_counting_finds() {
    for name in ["solved 44/44 tight", "tip on fillet", "deviated tight"] {
        let solved = find(name);
        let assembled = solved.assembled();
        let scene = Scene::new(&assembled, &solved.pose, &solved.lost_motion);
        let meeting = scene
            .contacts()
            .iter()
            .find(|meeting| meeting.gap < 0.0)
            .unwrap();
        let overlap = scene.overlap(meeting).unwrap();
        let along = |axis: usize| {
            let values = overlap.outline.iter().map(move |p| p[axis]);
            let low = values.clone().fold(f64::INFINITY, f64::min);
            (low, values.fold(f64::NEG_INFINITY, f64::max))
        };
        let ((left, right), (bottom, top)) = (along(0), along(1));
        let metal = [Member::Wheel, Member::Pinion].map(|member| {
            scene
                .placed(member)
                .outline_near(meeting.on_locked, 8.0, 1e-4)
        });
        let cells = 300;
        let (dx, dy) = ((right - left) / cells as f64, (top - bottom) / cells as f64);
        let mut both = 0;
        for i in 0..cells {
            for j in 0..cells {
                let at = Point2::new(left + (i as f64 + 0.5) * dx, bottom + (j as f64 + 0.5) * dy);
                both += usize::from(metal.iter().all(|polygon| holds(polygon, at)));
            }
        }
        let counted = both as f64 * dx * dy;
        // A strip some 30 cells wide or more: a cell's half at each edge, and it averages out.
        let off = (overlap.area / counted - 1.0).abs();
        assert!(off < 0.01, "{name}: {} {counted}", overlap.area);
    }
}

/// Two flanks with radii of curvature `ρ` that overlap by a much smaller depth `δ` share `4/3 δ √(2 δ/κ)`, `κ = 1/ρ_1 + 1/ρ_2`:
/// the length over which two parabolas overlap, times two thirds of the depth. Involutes have `ρ = √(r² − r_b²)`.
#[test]
fn overlaps_of_a_tenth_of_a_micrometre_and_of_a_tenth_of_a_millimetre_have_their_areas() {
    for (module, below) in [(3.0, 1e-4), (3.0, 1e-3), (20.0, 0.2)] {
        let assembly = pair([44, 44], module, 44.0 * module - below, Member::Wheel);
        let pose = pose(&assembly, [1, 1], Side::Right, 0.1);
        let solved = Solved::new("thin", assembly, pose);
        let assembled = solved.assembled();
        let scene = Scene::new(&assembled, &solved.pose, &solved.lost_motion);
        let mut seen = 0;
        for meeting in scene.contacts().iter().filter(|one| one.gap < 0.0) {
            let depth = -meeting.gap;
            let [wheel, pinion] = [
                (meeting.contact.wheel.radius, Member::Wheel),
                (meeting.contact.pinion.radius, Member::Pinion),
            ]
            .map(|(radius, member)| {
                let base = solved.assembly.gear(member).gear().base_radius();
                (radius * radius - base * base).sqrt()
            });
            let bend = 1.0 / wheel + 1.0 / pinion;
            let area = 4.0 / 3.0 * depth * (2.0 * depth / bend).sqrt();
            let found = scene.overlap(meeting).unwrap().area;
            assert!((found / area - 1.0).abs() < 0.005, "{found} {area}");
            seen += 1;
        }
        assert!(seen > 0);
    }
}

/// Perfect involutes overlap along their normal by exactly `−j_bn` (closed form).
#[test]
fn depth_and_area_are_written_beside_the_overlap() {
    for solved in all() {
        let texts = read(&solved.draw()).texts;
        let has = |start: &str| texts.iter().any(|(text, _)| text.starts_with(start));
        let status = solved.lost_motion.status();
        let overlaps = matches!(status, Status::Interference | Status::Jammed);
        assert_eq!(has("area "), overlaps, "{}", solved.name);
        assert_eq!(
            has("depth "),
            status == Status::Interference,
            "{}",
            solved.name
        );
    }
    let solved = find("solved 44/44 tight");
    let expected = format!("depth {:.2} µm", -j_bn(&solved.assembly) * 1e3);
    let texts = read(&solved.draw()).texts;
    assert!(texts.iter().any(|(text, _)| *text == expected), "{texts:?}");
}

/// Issue 4: worst of 24 phases −238.948 µm at a = 160.2, on the fillet at pinion radius 28.948 mm; the formula
/// has −216.426 µm.
#[test]
fn the_tip_on_the_fillet_is_shown_as_what_it_is() {
    let solved = find("tip on fillet");
    let left = solved.lost_motion.left.unwrap();
    assert!((left.pinion.radius - 28.948).abs() < 5e-4);
    let texts = read(&solved.draw()).texts;
    let has = |wanted: &str| texts.iter().any(|(text, _)| text == wanted);
    assert!(
        texts
            .iter()
            .any(|(text, _)| text.starts_with("jwt= −238.95 µm"))
    );
    for words in [
        "wheel 1 tip on pinion 1 fillet",
        "touching tip",
        "touching fillet",
        "form circle",
        "base tangent point",
    ] {
        assert!(has(words), "{words}");
    }
    assert!(!has("touching involute"));
    let plain = read(&find("solved 44/44 tight").draw()).texts;
    let words: Vec<_> = plain.iter().map(|(text, _)| text.as_str()).collect();
    assert!(words.contains(&"touching involute") && !words.contains(&"form circle"));
}

/// A small perfect pair with play.
pub fn nominal() -> Solved {
    let assembly = pair([17, 12], 2.0, 29.1, Member::Wheel);
    let at = pose(&assembly, [3, 5], Side::Right, 0.0);
    Solved::new("perfect", assembly, at)
}
