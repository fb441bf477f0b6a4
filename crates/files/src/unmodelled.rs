//! Keys that shops would look for and that no pair file has: why, in place of the list of known keys.

/// Parts of a key's words, and what is taken in place of what it states.
const TAKEN: [(&[&str], &str); 3] = [
    (
        &[
            "lead",
            "helix_slope",
            "helix_form",
            "f_h_beta",
            "f_hb",
            "crown",
        ],
        "deviations and modifications of the lead are not modelled: flanks wind as their helix angle says",
    ),
    (
        &[
            "shaft_angle",
            "axis_angle",
            "axes_angle",
            "crossed",
            "tilt",
            "skew",
            "misalign",
            "wobble",
        ],
        "the axes are parallel: crossed and tilted ones are not modelled",
    ),
    (
        &["internal", "ring_gear"],
        "both gears are external: internal ones are not modelled",
    ),
];

/// Why there is no key `name`, if it is one of these.
pub fn why(name: &str) -> Option<&'static str> {
    let name = name.to_lowercase();
    // At the beginning of a word alone: `misleading` is none.
    let starts = |part: &str| {
        name.match_indices(part)
            .any(|(at, _)| at == 0 || name[..at].ends_with('_'))
    };
    TAKEN
        .iter()
        .find(|(parts, _)| parts.iter().any(|part| starts(part)))
        .map(|(_, why)| *why)
}

#[cfg(test)]
mod tests {
    use super::why;

    #[test]
    fn words_of_leads_and_axes_are_known_and_others_are_not() {
        for name in [
            "lead_um",
            "f_H_beta_um",
            "crowning_um",
            "helix_slope_deviation",
        ] {
            assert!(why(name).is_some_and(|why| why.contains("lead")), "{name}");
        }
        for name in ["shaft_angle_deg", "tilt_um", "axis_misalignment_um"] {
            assert!(
                why(name).is_some_and(|why| why.contains("parallel")),
                "{name}"
            );
        }
        for name in ["teeth", "misleading", "helix_angle", "module"] {
            assert_eq!(why(name), None, "{name}");
        }
    }
}
