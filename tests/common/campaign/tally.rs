//! The counts of a campaign, by class.

use super::draw::{Depth, Drawn};
use super::gear::{Numbers, RackKind, Tip};
use super::outcome::{METHODS, Outcome, Verdict, combination, reaches_the_centre};
use gearlash::contact::{LostMotion, Status};
use gearlash::gear::Face;
use gearlash::pair::Member;
use std::collections::BTreeMap;
use std::time::Duration;

/// Curves that can meet, the locked gear's first; `joint`: where involute and fillet meet. A fillet is hollow, so it
/// meets another only at an end of the other (never at a convex place, because fillets have none).
const CONTACTS: [&str; 9] = [
    "involute on involute",
    "tip on involute",
    "involute on tip",
    "tip on tip",
    "tip on fillet",
    "fillet on tip",
    "tip on root",
    "root on tip",
    "involute on fillet",
];

/// Helix angles, degrees, with the name of the range that starts there.
const HELICES: [(f64, &str); 3] = [
    (0.0, "below 10°"),
    (10.0, "10° to 30°"),
    (30.0, "above 30°"),
];

/// Widths of the common face, modules, likewise.
const FACES: [(f64, &str); 3] = [
    (0.0, "below 10 modules"),
    (10.0, "10 to 30 modules"),
    (30.0, "above 30 modules"),
];

/// Classes of contacts.
const SIDES: [&str; 2] = [
    "right contact, locked on free",
    "left contact, locked on free",
];

/// Number of poses from which a campaign must include the rare classes.
const RARE: u64 = 20_000;

/// Number of faults and unproven poses that are kept with their reasons.
const KEPT: usize = 200;

/// Counts and findings.
#[derive(Default)]
pub struct Tally {
    pub poses: u64,
    pub redrawn: u64,
    /// Poses by class of classes and class (contacts: sides).
    pub classes: BTreeMap<(&'static str, String), u64>,
    /// Greatest difference of two rotations within their bounds, and greatest bounds, µm of `j_wt`.
    pub greatest_um: f64,
    pub greatest_bound_um: f64,
    pub faults: Vec<(u64, String)>,
    pub unproven: Vec<(u64, String)>,
    pub border: Vec<(u64, &'static str)>,
    /// Poses that the prover leaves to the polygons.
    pub left: Vec<u64>,
    /// Poses left to the polygons with seven teeth or more on both gears, and no jam.
    pub ordinary_left: Vec<u64>,
    /// For each method: total time, slowest pose, and its index.
    pub times: [(Duration, Duration, u64); 4],
    /// Effort of the exact method: the greatest of a pose, its limit, and the pose's index.
    pub effort: ([u64; 2], u64),
    /// Poses for which one method took longer than 0.1 s.
    pub slow: u64,
}

impl Tally {
    pub fn add(&mut self, index: u64, drawn: &Drawn, outcome: Outcome) {
        self.poses += 1;
        for (class, name) in classes(drawn, &outcome) {
            *self.classes.entry((class, name)).or_default() += 1;
        }
        for (took, (sum, most, slowest)) in outcome.times.into_iter().zip(&mut self.times) {
            *sum += took;
            if took > *most {
                (*most, *slowest) = (took, index);
            }
        }
        if let Some(reason) = outcome.left_to_polygons {
            let class = ("left to the polygons", reason.to_owned());
            *self.classes.entry(class).or_default() += 1;
            self.left.push(index);
            let is_jammed = |found: &LostMotion| found.status() == Status::Jammed;
            let is_ordinary = drawn.gears.iter().all(|gear| gear.teeth >= 7)
                && !outcome.exact.as_ref().is_some_and(is_jammed);
            self.ordinary_left.extend(is_ordinary.then_some(index));
        }
        if outcome.effort[0] > self.effort.0[0] {
            self.effort = (outcome.effort, index);
        }
        let limit = Duration::from_millis(100);
        self.slow += u64::from(outcome.times.iter().any(|&took| took > limit));
        match outcome.verdict {
            Verdict::Confirmed(agreement) => {
                self.greatest_um = self.greatest_um.max(agreement.difference_um);
                self.greatest_bound_um = self.greatest_bound_um.max(agreement.bound_um);
                self.border
                    .extend(agreement.border.map(|what| (index, what)));
            }
            Verdict::Unproven(why) => self.unproven.push((index, why)),
            Verdict::Fault(what) => self.faults.push((index, what)),
        }
    }

    /// Both tallies together, with the other's poses after this one's.
    pub fn and(mut self, other: Tally) -> Tally {
        self.poses += other.poses;
        self.redrawn += other.redrawn;
        self.slow += other.slow;
        for (class, count) in other.classes {
            *self.classes.entry(class).or_default() += count;
        }
        if other.effort.0[0] > self.effort.0[0] {
            self.effort = other.effort;
        }
        self.greatest_um = self.greatest_um.max(other.greatest_um);
        self.greatest_bound_um = self.greatest_bound_um.max(other.greatest_bound_um);
        self.faults.extend(other.faults);
        self.unproven.extend(other.unproven);
        self.border.extend(other.border);
        self.left.extend(other.left);
        self.ordinary_left.extend(other.ordinary_left);
        for (ours, theirs) in self.times.iter_mut().zip(other.times) {
            ours.0 += theirs.0;
            if theirs.1 > ours.1 {
                (ours.1, ours.2) = (theirs.1, theirs.2);
            }
        }
        self
    }

    pub fn count(&self, class: &'static str, name: &str) -> u64 {
        let key = (class, name.to_owned());
        self.classes.get(&key).copied().unwrap_or(0)
    }

    /// Classes that a campaign of `depth` must include and does not.
    pub fn empty(&self, depth: Option<Depth>) -> Vec<String> {
        let helical = self.count("teeth", "helical") > 0;
        let mut missing = expected(helical, depth, self.poses >= RARE);
        missing.retain(|(class, name)| self.count(class, name) == 0);
        let named = missing.iter();
        named
            .map(|(class, name)| format!("{class}: {name}"))
            .collect()
    }

    /// The counts and times as text.
    pub fn report(&self) -> String {
        let mut lines = vec![format!(
            "{} poses, {} gears that cannot exist drawn again",
            self.poses, self.redrawn
        )];
        let mut last = "";
        for ((class, name), count) in &self.classes {
            if *class != last {
                lines.push((*class).to_owned());
                last = class;
            }
            let percent = 100.0 * *count as f64 / self.poses as f64;
            lines.push(format!("  {count:8}  {percent:6.2} %  {name}"));
        }
        lines.push(format!(
            "largest difference {:.2e} µm, largest bounds {:.2e} µm",
            self.greatest_um, self.greatest_bound_um
        ));
        for (name, (sum, most, index)) in METHODS.iter().zip(&self.times) {
            let each = sum.as_secs_f64() * 1e3 / self.poses.max(1) as f64;
            let most = most.as_secs_f64() * 1e3;
            lines.push(format!(
                "{name}: {each:.4} ms a pose, slowest {most:.2} ms (pose {index})"
            ));
        }
        let ([used, most], index) = self.effort;
        lines.push(format!(
            "exact: greatest effort {used} of {most} units (pose {index})"
        ));
        lines.push(format!(
            "{} poses of more than 0.1 s, {} unproven, {} on a border of statuses, {} faults",
            self.slow,
            self.unproven.len(),
            self.border.len(),
            self.faults.len()
        ));
        lines.join("\n")
    }

    /// Keeps a limited number of reasons; counts stay complete.
    pub fn shorten(&mut self) {
        for list in [&mut self.faults, &mut self.unproven] {
            for (_, reason) in list.iter_mut().skip(KEPT) {
                reason.truncate(reason.find('\n').unwrap_or(reason.len()));
            }
        }
    }
}

/// The classes of `drawn` and its outcome.
fn classes(drawn: &Drawn, outcome: &Outcome) -> Vec<(&'static str, String)> {
    let assembly = &drawn.assembly;
    let gears = [assembly.locked(), assembly.free()].map(|member| assembly.gear(member));
    let teeth = if assembly.is_helical() {
        "helical"
    } else {
        "spur"
    };
    let faces = Member::BOTH.map(|member| assembly.gear(member).face());
    let mut classes = vec![
        ("depth", format!("{:?}", drawn.depth)),
        ("locked gear", assembly.locked().name().to_owned()),
        ("teeth", teeth.to_owned()),
        ("faces", format!("{faces:?}")),
    ];
    for numbers in drawn.gears.iter() {
        classes.push(("rack (gears)", format!("{:?}", numbers.kind)));
        classes.push(("tip (gears)", format!("{:?}", numbers.tip)));
    }
    let some = |is: fn(&Numbers) -> bool| drawn.gears.iter().any(is);
    for (what, is) in [
        ("locked gear eccentric", gears[0].eccentricity() > 0.0),
        ("free gear eccentric", gears[1].eccentricity() > 0.0),
        (
            "undercut",
            gears.iter().any(|gear| gear.gear().is_undercut()),
        ),
        (
            "deviations by tooth",
            some(|gear| !(gear.right_um.is_empty() && gear.per_tooth_um.is_empty())),
        ),
        ("9 teeth or fewer", some(|gear| gear.teeth <= 9)),
        ("more than 200 teeth", some(|gear| gear.teeth > 200)),
        (
            "a tip reaches the mate's centre",
            reaches_the_centre(assembly),
        ),
    ] {
        classes.extend(is.then(|| ("what else", what.to_owned())));
    }
    if let Some((angle_deg, _)) = drawn.gears[0].helix {
        let [from, to] = assembly.face();
        let wide = (to - from) / drawn.gears[0].module_mm;
        for (class, ranges, value) in [("helix angle", HELICES, angle_deg), ("face", FACES, wide)] {
            let range = ranges.iter().rev().find(|(least, _)| value >= *least);
            classes.extend(range.map(|(_, name)| (class, (*name).to_owned())));
        }
    }
    let Some(exact) = &outcome.exact else {
        classes.push(("status", "without result".to_owned()));
        return classes;
    };
    classes.push(("status", exact.status().name().to_owned()));
    for (class, contact) in SIDES.into_iter().zip([exact.right, exact.left]) {
        let name = contact.map(|contact| combination(assembly, &contact));
        classes.push((class, name.unwrap_or_else(|| "none".to_owned())));
    }
    classes
}

fn expected(helical: bool, depth: Option<Depth>, long: bool) -> Vec<(&'static str, String)> {
    let mut expected: Vec<(&'static str, String)> = Vec::new();
    let mut expect = |class: &'static str, names: &[&str]| {
        expected.extend(names.iter().map(|name| (class, (*name).to_owned())));
    };
    expect("locked gear", &["wheel", "pinion"]);
    let others = [
        "locked gear eccentric",
        "free gear eccentric",
        "undercut",
        "deviations by tooth",
        "9 teeth or fewer",
        "more than 200 teeth",
    ];
    expect("what else", &others);
    if helical {
        expect("helix angle", &HELICES.map(|(_, name)| name));
        expect("face", &FACES.map(|(_, name)| name));
    }
    if depth.is_none_or(|depth| depth == Depth::Any) {
        expect("status", &["clear", "interference", "jammed", "no_contact"]);
        let contacts = match (long, helical) {
            (true, _) => &CONTACTS[..],
            (false, false) => &CONTACTS[..6],
            (false, true) => &CONTACTS[..3],
        };
        for class in SIDES {
            expect(class, contacts);
        }
    }
    let depths = Depth::ALL.into_iter();
    let depths = depths.filter(|one| depth.is_none_or(|depth| depth == *one));
    expected.extend(depths.map(|depth| ("depth", format!("{depth:?}"))));
    for wheel in [Face::Front, Face::Back] {
        let faces = [Face::Front, Face::Back].map(|pinion| [wheel, pinion]);
        expected.extend(faces.map(|faces| ("faces", format!("{faces:?}"))));
    }
    expected.extend(RackKind::ALL.map(|kind| ("rack (gears)", format!("{kind:?}"))));
    expected.extend(Tip::ALL.map(|tip| ("tip (gears)", format!("{tip:?}"))));
    expected
}
