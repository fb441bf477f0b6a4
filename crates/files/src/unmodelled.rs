//! Keys and values that no pair file has, or has any more: the reason, and for those that are gone what to state instead.

use crate::node::Node;

const INTERNAL: &str = "internal gears are not modelled yet: both gears are external";

/// Parts of a key's words, and why there is no such key.
const TAKEN: [(&str, &str); 3] = [
    (
        "lead helix_slope helix_form f_h_beta f_hb crown",
        "deviations and modifications of the lead are not modelled: flanks wind as their helix angle says",
    ),
    (
        "shaft_angle axis_angle axes_angle crossed tilt skew misalign wobble",
        "the axes are parallel: crossed and tilted ones are not modelled",
    ),
    ("internal ring_gear", INTERNAL),
];

/// Keys that are gone: the end of their path, the reason, and the way out.
const GONE: [(&str, &str, &str); 1] = [(
    "thickness.file",
    "the key is gone: thickness is not taken from the probe's positions in a curve file",
    "state the thickness by `span`, `over_pins` or another key of the table",
)];

/// The reason why `teeth` of this number, or a word beside them, is not allowed, if it stands for an internal gear.
pub fn value(path: &str, node: &Node) -> Option<&'static str> {
    value_is_internal(path, node).then_some(INTERNAL)
}

fn value_is_internal(path: &str, node: &Node) -> bool {
    match node {
        Node::Whole(teeth) => *teeth < 0 && path.ends_with("teeth"),
        Node::Text(word) => word.eq_ignore_ascii_case("internal"),
        _ => false,
    }
}

/// Why there is no key `name`, by its dotted `path` and its value, and the way out, if it is one of these.
pub fn why(path: &str, name: &str, node: &Node) -> Option<(&'static str, &'static str)> {
    let gone = GONE.iter().find(|(end, ..)| path.ends_with(end));
    if let Some((_, reason, help)) = gone {
        return Some((reason, help));
    }
    if value_is_internal(path, node) {
        return Some((INTERNAL, "remove it"));
    }
    let name = name.to_lowercase();
    // At the beginning of a word alone: `misleading` is none.
    let starts = |part: &str| {
        name.match_indices(part)
            .any(|(at, _)| at == 0 || name[..at].ends_with('_'))
    };
    let mut taken = TAKEN.iter();
    let (_, why) = taken.find(|(parts, _)| parts.split(' ').any(starts))?;
    Some((why, "remove it"))
}
