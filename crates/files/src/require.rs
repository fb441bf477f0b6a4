//! `[require]`: what the pair must keep.

use super::entry::Limits as Allowed;
use super::limits::{REQUIRED_ARCMIN, REQUIRED_MM, REQUIRED_UM};
use super::problems::Problems;
use super::spec::{AngleLimitsSpec, GearName, LimitsSpec, RequireSpec};
use super::table::Table;
use gearlash::analysis::requirement::{Limits, Quantity, Requirements};
use gearlash::pair::Member;

const KEYS: &[&str] = &[
    "j_wt_um",
    "j_bn_um",
    "j_t_um",
    "j_r_um",
    "lost_motion_arcmin",
    "radial_clearance_mm",
];

const MEMBERS: [(&str, Member); 2] = [("wheel", Member::Wheel), ("pinion", Member::Pinion)];

/// Reads `[require]`; `Some(None)` where the file has none.
pub fn require(file: &Table, problems: &mut Problems) -> Option<Option<RequireSpec>> {
    if !(file.has("require") || file.is_mistyped("require")) {
        return Some(None);
    }
    let table = file.table("require", KEYS, problems)?;
    if !KEYS.iter().any(|key| table.has(key)) {
        problems.add(file.problem(
            "require",
            "requires nothing",
            "state what the pair must keep, such as j_wt_um = { min = 40 }, or leave the table out",
        ));
        return None;
    }
    let mut of = |key, allowed| limits(&table, key, allowed, problems);
    let lengths = ["j_wt_um", "j_bn_um", "j_t_um", "j_r_um"].map(|key| of(key, &REQUIRED_UM));
    let clearance = of("radial_clearance_mm", &REQUIRED_MM);
    let angle = angle(&table, problems);
    let [j_wt_um, j_bn_um, j_t_um, j_r_um] = lengths;
    Some(Some(RequireSpec {
        j_wt_um: j_wt_um?,
        j_bn_um: j_bn_um?,
        j_t_um: j_t_um?,
        j_r_um: j_r_um?,
        lost_motion_arcmin: angle?,
        radial_clearance_mm: clearance?,
    }))
}

/// `{ min, max }` of a key; `Some(None)` where it is not there.
fn limits(
    table: &Table,
    key: &str,
    allowed: &Allowed,
    problems: &mut Problems,
) -> Option<Option<LimitsSpec>> {
    if !table.has(key) {
        return Some(None);
    }
    let own = table.table(key, &["min", "max"], problems)?;
    let (min, max) = ends(&own, key, table, allowed, problems)?;
    Some(Some(LimitsSpec { min, max }))
}

/// `{ min, max, at }` of the lost motion.
fn angle(table: &Table, problems: &mut Problems) -> Option<Option<AngleLimitsSpec>> {
    let key = "lost_motion_arcmin";
    if !table.has(key) {
        return Some(None);
    }
    let own = table.table(key, &["min", "max", "at"], problems)?;
    let ends = ends(&own, key, table, &REQUIRED_ARCMIN, problems);
    let at = own
        .need("at", "the gear whose lost motion it is", problems)
        .and_then(|entry| problems.keep(entry.choice(&MEMBERS)));
    let ((min, max), at) = (ends?, GearName::from(at?));
    Some(Some(AngleLimitsSpec { min, max, at }))
}

/// Both ends, at least one of them there, the first not above the second.
fn ends(
    own: &Table,
    key: &str,
    table: &Table,
    allowed: &Allowed,
    problems: &mut Problems,
) -> Option<(Option<f64>, Option<f64>)> {
    let [min, max] = ["min", "max"].map(|name| match own.has(name) {
        false => Some(None),
        true => own.number(name, allowed, problems).map(Some),
    });
    let (min, max) = (min?, max?);
    if let (None, None) = (min, max) {
        problems.add(table.problem(key, "has neither min nor max", "give one of them, or both"));
        return None;
    }
    if let (Some(low), Some(high)) = (min, max)
        && low > high
    {
        problems.add(table.problem(
            key,
            format!("min {low} is above max {high}"),
            "exchange the two, or leave one out",
        ));
        return None;
    }
    Some((min, max))
}

impl RequireSpec {
    /// As the library takes it: mm and rad.
    pub(crate) fn requirements(&self) -> Requirements {
        let mm = |limits: LimitsSpec, per: f64| Limits {
            min: limits.min.map(|min| min * per),
            max: limits.max.map(|max| max * per),
        };
        let um = 1e-3;
        let arcmin = (1.0f64 / 60.0).to_radians();
        let lengths = [
            (self.j_wt_um, Quantity::OperatingBacklash, um),
            (self.j_bn_um, Quantity::NormalBacklash, um),
            (self.j_t_um, Quantity::ReferenceBacklash, um),
            (self.j_r_um, Quantity::RadialBacklash, um),
            (self.radial_clearance_mm, Quantity::RadialClearance, 1.0),
        ];
        let lengths = lengths
            .into_iter()
            .filter_map(|(limits, quantity, per)| Some((quantity, mm(limits?, per))));
        let angle = self.lost_motion_arcmin.map(|limits| {
            let member = match limits.at {
                GearName::Wheel => Member::Wheel,
                GearName::Pinion => Member::Pinion,
            };
            let ends = LimitsSpec {
                min: limits.min,
                max: limits.max,
            };
            (Quantity::LostMotion(member), mm(ends, arcmin))
        });
        lengths.chain(angle).collect()
    }
}
