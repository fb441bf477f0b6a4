//! `[profile]`: deviations of the flanks from the involute, for both flanks or each.

use super::known_gear::KnownGear;
use super::spec::{FlankProfileSpec, FlanksSpec, ProfileSpec, ReliefShape, ReliefSpec, TraceSpec};
use super::traces::{self, Along};
use gearlash::gear::{BasicGearData, Flank, Modification, Relief, Trace};
use gearlash::metrology::ProfileKey;
use gearlash_text::{Node, Table};

const NAME: &str = "profile";

impl ProfileSpec {
    /// The profiles of the gear's table `gear` with their traces as lists of roll lengths; `None` where nothing is stated.
    pub(crate) fn complete(self, gear: &Table, known: &KnownGear) -> Option<Option<ProfileSpec>> {
        let flanks = traces::read_flanks(&gear.below(NAME), self, known, Along::Profile)?;
        let is_stated = flanks != <[FlankProfileSpec; 2]>::default();
        Some(is_stated.then(|| FlanksSpec::new(flanks)))
    }

    /// The profiles of right and left flanks.
    pub(crate) fn for_metrology(&self, basic_data: &BasicGearData) -> [Modification; 2] {
        let base = basic_data.base_radius();
        self.flanks().map(|flank| Modification {
            slope: flank.slope_um.unwrap_or(0.0) / 1000.0,
            crowning: flank.crowning_um.unwrap_or(0.0) / 1000.0,
            tip_relief: flank.tip_relief.map(relief),
            root_relief: flank.root_relief.map(relief),
            traces: flank.traces().iter().map(|t| of_trace(t, base)).collect(),
            range: flank
                .range_mm
                .map(|range| range.map(|diameter| diameter / 2.0)),
        })
    }
}

/// The key, below the gear's table, that states `key` of a flank.
pub fn key_of(gear: &Table, flank: Flank, key: ProfileKey) -> String {
    let name = match key {
        ProfileKey::Slope => "slope_um",
        ProfileKey::Crowning => "crowning_um",
        ProfileKey::TipRelief => "tip_relief",
        ProfileKey::RootRelief => "root_relief",
        ProfileKey::Range => "range_mm",
        ProfileKey::Trace => "trace",
        ProfileKey::All => return NAME.to_owned(),
    };
    traces::key_of(gear, NAME, flank, name)
}

/// Reports keys that are given for both flanks and again for one, and ranges that descend.
pub fn check(gear: &Table) -> Option<()> {
    let mut good = traces::check_flanks(gear, NAME);
    for name in ["profile.right", "profile.left", NAME] {
        let table = gear.below(name);
        let range = table.get("range_mm").map(Node::to::<[f64; 2]>);
        if let Some(Ok([start, end])) = range
            && start >= end
        {
            table.add(
                "range_mm",
                "no evaluation range, allowed are two diameters in mm, the lesser first",
                "write range_mm = [start, end]",
            );
            good = None;
        }
    }
    good
}

fn relief(spec: ReliefSpec) -> Relief {
    Relief {
        amount: spec.um / 1000.0,
        from: spec.from_diameter_mm / 2.0,
        parabolic: spec.shape == ReliefShape::Parabolic,
    }
}

fn of_trace(spec: &TraceSpec, base: f64) -> Trace {
    let rolls = spec.roll_length_mm.iter().flatten();
    let deviations = spec.deviation_um.iter().flatten();
    Trace {
        tooth: spec.tooth,
        points: rolls
            .zip(deviations)
            .map(|(length, um)| (length / base, um / 1000.0))
            .collect(),
    }
}
