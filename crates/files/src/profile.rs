//! `[profile]`: deviations of the flanks from the involute, for both flanks or each.

mod trace;

use super::sheet::Header;
use super::spec::{Either, FlankProfileSpec, ProfileSpec, ReliefShape, ReliefSpec, TraceSpec};
use super::table::Table;
use gearlash::gear::{BasicGearData, Flank, Modification, Relief, Trace};
use gearlash::metrology::ProfileKey;
use serde::Deserialize;
use std::cell::RefCell;
use trace::FlankTraces;

/// The keys of one flank.
const FLANK_KEYS: [&str; 6] = [
    "slope_um",
    "crowning_um",
    "tip_relief",
    "root_relief",
    "range_mm",
    "trace",
];

/// The profiles of the right and left flanks of one gear, as in the pair file; traces are lists of roll lengths.
#[derive(Debug, Clone, Default)]
pub struct Profiles {
    flanks: [FlankProfileSpec; 2],
    headers: Vec<Header>,
}

impl Profiles {
    /// Reads the profile `spec` of the gear's table `gear`.
    pub fn read(
        gear: &Table,
        spec: ProfileSpec,
        teeth: Option<u32>,
        basic_data: Option<&BasicGearData>,
    ) -> Option<Profiles> {
        let table = gear.below("profile");
        let gear = Measured {
            teeth,
            basic_data,
            headers: RefCell::default(),
        };
        let both = flank(&table, spec.both, None, &gear);
        let mut own = Vec::new();
        for (side, spec) in Flank::BOTH.into_iter().zip([spec.right, spec.left]) {
            let below = table.below(side.name());
            let spec = spec.unwrap_or_default();
            own.push(flank(&below, spec, Some(side), &gear));
        }
        let own: Vec<(FlankProfileSpec, FlankTraces)> = own.into_iter().collect::<Option<_>>()?;
        let (both, traces) = both?;
        let mut flanks = [both.clone(), both];
        for (index, (mut own, own_traces)) in own.into_iter().enumerate() {
            let flank = &mut flanks[index];
            let of = |traces: &FlankTraces| match &traces[index][..] {
                [] => None,
                [one] => Some(Either::One(one.clone())),
                list => Some(Either::Other(list.to_vec())),
            };
            own.trace = of(&own_traces).or_else(|| of(&traces));
            *flank = FlankProfileSpec {
                slope_um: own.slope_um.or(flank.slope_um),
                crowning_um: own.crowning_um.or(flank.crowning_um),
                tip_relief: own.tip_relief.or(flank.tip_relief),
                root_relief: own.root_relief.or(flank.root_relief),
                range_mm: own.range_mm.or_else(|| flank.range_mm.take()),
                trace: own.trace,
            };
        }
        Some(Profiles {
            flanks,
            headers: gear.headers.into_inner(),
        })
    }

    /// Statements about the gear in the files of traces.
    pub fn headers(&self) -> &[Header] {
        &self.headers
    }

    /// The modifications on a gear of `basic_data`.
    pub fn measured(&self, basic_data: &BasicGearData) -> [Modification; 2] {
        let base = basic_data.base_radius();
        self.flanks.each_ref().map(|flank| Modification {
            slope: flank.slope_um.unwrap_or(0.0) / 1000.0,
            crowning: flank.crowning_um.unwrap_or(0.0) / 1000.0,
            tip_relief: flank.tip_relief.map(relief),
            root_relief: flank.root_relief.map(relief),
            traces: flank.traces().iter().map(|t| of_trace(t, base)).collect(),
            range: flank
                .range_mm
                .as_deref()
                .and_then(|range| <[f64; 2]>::try_from(range).ok())
                .map(|range| range.map(|diameter| diameter / 2.0)),
        })
    }

    /// As in the pair file; `None` where it states nothing.
    pub fn spec(&self) -> Option<ProfileSpec> {
        let [right, left] = &self.flanks;
        if self.flanks == <[FlankProfileSpec; 2]>::default() {
            return None;
        }
        Some(if right == left {
            ProfileSpec {
                both: right.clone(),
                ..ProfileSpec::default()
            }
        } else {
            ProfileSpec {
                right: Some(right.clone()),
                left: Some(left.clone()),
                ..ProfileSpec::default()
            }
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
        ProfileKey::All => return "profile".to_owned(),
    };
    let own = format!("profile.{}.{name}", flank.name());
    if gear.has(&own) {
        own
    } else {
        format!("profile.{name}")
    }
}

/// The gear that the traces were measured on, as far as known.
struct Measured<'a> {
    teeth: Option<u32>,
    basic_data: Option<&'a BasicGearData>,
    /// Statements about it in the files that were read.
    headers: RefCell<Vec<Header>>,
}

/// Reports keys that are given for both flanks and again for one, and ranges that descend.
pub fn check(gear: &Table) -> Option<()> {
    let both = gear.below("profile");
    let mut good = Some(());
    let own = Flank::BOTH.map(|side| (side, both.below(side.name())));
    for (side, own) in &own {
        let is_in_both = |key: &&str| both.has(key) && own.has(key);
        for key in FLANK_KEYS.into_iter().filter(is_in_both) {
            let [of_both, of_own] = [&both, own].map(|table| table.path_of(""));
            let reason = format!("given together with {of_both}{key}, allowed is one of them");
            let help = format!(
                "remove one: what stands in [{}] is of both flanks, what stands in [{}] of the {} flanks alone",
                of_both.trim_end_matches('.'),
                of_own.trim_end_matches('.'),
                side.name()
            );
            own.add(key, reason, help);
            good = None;
        }
    }
    for table in own.iter().map(|(_, own)| own).chain([&both]) {
        let range = table.get("range_mm").map(<[f64; 2]>::deserialize);
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

/// The keys of a flank, or of both, without its traces; and the traces of each.
fn flank(
    table: &Table,
    mut spec: FlankProfileSpec,
    own: Option<Flank>,
    gear: &Measured,
) -> Option<(FlankProfileSpec, FlankTraces)> {
    let stated = spec.trace.take();
    let traces = trace::read(table, stated, own, gear);
    Some((spec, traces?))
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
