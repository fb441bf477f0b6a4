//! Values of the flanks, for both or for each: `[profile]` and `[lead]`.

use super::spec::{Either, FlankSpec, FlanksSpec, TraceSpec};
use super::table::Table;
use super::traces::{self, Measured};
use gearlash::gear::Flank;

/// The values of the right flanks, and of the left ones, of `table`. Traces of files become lists.
pub fn read<F: FlankSpec>(table: &Table, spec: FlanksSpec<F>, gear: &Measured) -> Option<[F; 2]> {
    let one = |table: &Table, mut spec: F, own| {
        let traces = traces::read(table, spec.trace().take(), own, gear);
        Some((spec, traces?))
    };
    let both = one(table, spec.both, None);
    let own = [(Flank::Right, spec.right), (Flank::Left, spec.left)].map(|(side, spec)| {
        let below = table.below(side.name());
        one(&below, spec.unwrap_or_default(), Some(side))
    });
    let [right, left] = own;
    let ((right, right_traces), (left, left_traces)) = (right?, left?);
    let (both, [of_right, of_left]) = both?;
    let [both_right, both_left] = [(both.clone(), of_right), (both, of_left)];
    let [own_right, _] = right_traces;
    let [_, own_left] = left_traces;
    Some([
        joined((right, own_right), both_right),
        joined((left, own_left), both_left),
    ])
}

/// The own values of a flank, with those of both flanks in place of absent ones.
fn joined<F: FlankSpec>(own: (F, Vec<TraceSpec>), both: (F, Vec<TraceSpec>)) -> F {
    let [own, both] = [own, both].map(|(mut flank, mut traces)| {
        *flank.trace() = match traces.len() {
            0 => None,
            1 => traces.pop().map(Either::One),
            _ => Some(Either::Other(traces)),
        };
        flank
    });
    own.or(both)
}

/// Reports keys that are given for both flanks and again for one, in the table `name` of a gear.
pub fn check(gear: &Table, name: &str) -> Option<()> {
    let both = gear.below(name);
    let mut good = Some(());
    for side in Flank::BOTH {
        let own = both.below(side.name());
        let keys = own.entries().iter().map(|(key, _)| key);
        for key in keys.filter(|key| both.has(key)) {
            let [of_both, of_own] = [&both, &own].map(|table| table.path_of(""));
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
    good
}

/// The key, below the gear's table, that states `key` of a flank in the table `name`.
pub fn key_of(gear: &Table, name: &str, flank: Flank, key: &str) -> String {
    let own = format!("{name}.{}.{key}", flank.name());
    if gear.has(&own) {
        own
    } else {
        format!("{name}.{key}")
    }
}
