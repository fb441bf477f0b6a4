//! The counts of a campaign, by class.

use super::draw::{Depth, Drawn, Teeth};
use super::outcome::{Outcome, Verdict, combination};
use gearlash::contact::{LostMotion, Status};
use std::collections::BTreeMap;

/// Curves that can meet, the locked gear's first, the rare ones last; `joint`: where involute and fillet meet. A fillet is hollow: it meets
/// another only at an end of the other.
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

/// Classes of contacts.
const SIDES: [&str; 2] = [
    "right contact, locked on free",
    "left contact, locked on free",
];

/// Number of poses from which a campaign must include the rare classes.
const RARE: u64 = 20_000;

/// Counts and findings.
#[derive(Default)]
pub struct Tally {
    pub poses: u64,
    /// Poses by class of classes and class.
    pub classes: BTreeMap<(&'static str, String), u64>,
    pub faults: Vec<(u64, String)>,
    pub unproven: Vec<(u64, String)>,
    pub border: Vec<(u64, String)>,
    /// Poses that the prover leaves to the polygons.
    pub left: Vec<u64>,
    /// Poses left to the polygons with seven teeth or more on both gears, and no jam.
    pub ordinary_left: Vec<u64>,
    /// The greatest effort of the exact method, and its limit.
    pub effort: [u64; 2],
}

impl Tally {
    pub fn add(&mut self, index: u64, drawn: &Drawn, outcome: Outcome) {
        self.poses += 1;
        let mut count = |class, name: &str| {
            *self.classes.entry((class, name.to_owned())).or_default() += 1;
        };
        let exact = outcome.exact.as_ref();
        let status = exact.map(LostMotion::status);
        count("status", status.map_or("without result", Status::name));
        let contacts = exact.map_or([None; 2], |exact| [exact.right, exact.left]);
        for (class, contact) in SIDES.into_iter().zip(contacts) {
            let name = contact.map(|contact| combination(&drawn.assembly, &contact));
            count(class, &name.unwrap_or_else(|| "none".to_owned()));
        }
        if let Some(reason) = outcome.left_to_polygons {
            count("left to the polygons", reason);
            self.left.push(index);
            let has_few = drawn.gears.iter().any(|gear| gear.teeth < 7);
            let is_ordinary = !has_few && status != Some(Status::Jammed);
            self.ordinary_left.extend(is_ordinary.then_some(index));
        }
        self.effort = self.effort.max(outcome.effort);
        match outcome.verdict {
            Verdict::Confirmed(border) => {
                let border = border.map(|what| (index, what.to_owned()));
                self.border.extend(border);
            }
            Verdict::Unproven(why) => self.unproven.push((index, why)),
            Verdict::Fault(what) => self.faults.push((index, what)),
        }
    }

    /// Both tallies together, with the other's poses after this one's.
    pub fn and(mut self, other: Tally) -> Tally {
        self.poses += other.poses;
        for (class, count) in other.classes {
            *self.classes.entry(class).or_default() += count;
        }
        self.effort = self.effort.max(other.effort);
        self.faults.extend(other.faults);
        self.unproven.extend(other.unproven);
        self.border.extend(other.border);
        self.left.extend(other.left);
        self.ordinary_left.extend(other.ordinary_left);
        self
    }

    pub fn count(&self, class: &'static str, name: &str) -> u64 {
        let key = (class, name.to_owned());
        self.classes.get(&key).copied().unwrap_or(0)
    }

    /// Statuses and contacts that a campaign must include and does not.
    pub fn empty(&self, kind: Teeth, depth: Option<Depth>) -> Vec<String> {
        if depth.is_some_and(|depth| depth != Depth::Any) {
            return Vec::new();
        }
        let contacts = match (self.poses >= RARE, kind) {
            (true, _) => &CONTACTS[..],
            (false, Teeth::Spur) => &CONTACTS[..6],
            (false, Teeth::Helical) => &CONTACTS[..3],
        };
        let statuses = ["clear", "interference", "jammed", "no_contact"];
        let sides = SIDES.iter().map(|side| (*side, contacts));
        let expected = sides.chain([("status", &statuses[..])]);
        let each = expected.flat_map(|(class, names)| names.iter().map(move |name| (class, name)));
        let missing = each.filter(|(class, name)| self.count(class, name) == 0);
        let named = missing.map(|(class, name)| format!("{class}: {name}"));
        named.collect()
    }

    /// The counts as text.
    pub fn report(&self) -> String {
        let mut lines = vec![format!("{} poses", self.poses)];
        for ((class, name), count) in &self.classes {
            let percent = 100.0 * *count as f64 / self.poses as f64;
            lines.push(format!("  {count:8}  {percent:6.2} %  {class}: {name}"));
        }
        let [used, most] = self.effort;
        let (unproven, faults) = (self.unproven.len(), self.faults.len());
        let border = self.border.len();
        lines.push(format!(
            "effort {used} of {most} units, {unproven} unproven, {border} on a border of statuses, {faults} faults"
        ));
        lines.join("\n")
    }
}
