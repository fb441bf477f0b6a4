//! The effect of the face width on backlash.

use super::helical_pairs::pair_of_the_prototype;
use gearlash::analysis::extremes::{WIDTH, extremes};
use gearlash::analysis::face_width::{AtWidth, FaceExtreme, over_widths};
use gearlash::analysis::study::Study;
use gearlash::contact::Method;
use gearlash::gear::Hand;
use gearlash::pair::GearPair;
use std::ops::ControlFlow;

/// A face that holds another has no more play, as far as the brackets tell; eccentricities alone cost nothing. A face is cut about its middle.
#[test]
fn a_wider_face_costs() {
    for (pitch, costs) in [([0.0; 2], false), ([4.0, 5.0], true)] {
        let pair = pair_of_the_prototype([30.0, 40.0], pitch, Hand::Right, 7);
        let widths = widths(&pair.with_face([-20.0, 40.0]).unwrap());
        let faces: Vec<[f64; 2]> = widths.iter().map(|at| at.face).collect();
        let held = [[10.0, 10.0], [2.5, 17.5], [-5.0, 25.0], [-12.5, 32.5]];
        assert_eq!(faces[..4], held);
        assert_eq!(faces[4..], [[-20.0, 40.0]]);
        for pair in widths.windows(2) {
            for [here, before] in both(&pair[1], &pair[0]) {
                assert!(here.low <= before.high, "{here:?} {before:?}");
                assert!(here.against(&before).unwrap()[0] <= 0.0);
            }
        }
        let ends = both(&widths[4], &widths[0]);
        let [least, greatest] = ends.map(|[all, one]| all.against(&one).unwrap());
        if costs {
            assert!(greatest[1] < -1e-3, "{least:?} {greatest:?}")
        } else {
            assert!(least[0] > -3e-6 && greatest[0] > -3e-6)
        }
    }
}

/// The extremes over parts of the face of a pair.
fn widths(pair: &GearPair) -> Vec<AtWidth> {
    let on = || ControlFlow::Continue(());
    let method = Method::Exact { certify: true };
    let study = Study::of_pair("pair", pair, 4);
    let full = extremes(&study, method, &on).unwrap().each;
    over_widths(&study, &full, method, &on).unwrap()
}

/// Least and greatest of two widths.
fn both<'a>(one: &'a AtWidth, other: &'a AtWidth) -> [[FaceExtreme<'a>; 2]; 2] {
    [
        [one.least().unwrap(), other.least().unwrap()],
        [one.greatest().unwrap(), other.greatest().unwrap()],
    ]
}

/// Width 0 is one section: a spur pair of its own, whose extremes the search for spur pairs finds.
#[test]
fn width_nought_is_a_section() {
    let pair = pair_of_the_prototype([30.0, 40.0], [4.0, 5.0], Hand::Right, 7);
    let pair = pair.with_face([-20.0, 40.0]).unwrap();
    let widths = widths(&pair);
    let on = || ControlFlow::Continue(());
    let study = Study::of_pair("section", &pair.section(10.0), 4);
    let alone = extremes(&study, Method::Exact { certify: true }, &on).unwrap();
    let alone = &alone.each[0];
    for (width, section) in [
        (widths[0].least().unwrap(), alone.least.as_ref().unwrap()),
        (
            widths[0].greatest().unwrap(),
            alone.greatest.as_ref().unwrap(),
        ),
    ] {
        assert!(width.low <= section.high && section.low <= width.high);
        assert!((width.found - section.found()).abs() <= WIDTH);
        assert!(width.doubtful.is_none() && section.is_proven());
    }
}
