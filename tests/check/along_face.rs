//! Where pairs with leads bind along the face, and what that costs. Sources: closed forms of flanks on the line of action, with α_wt.

use super::*;
use CheckVerdict::{Pass, Warn};
use gearlash::contact::FacePlace::{self, FarEnd, Inside, NearEnd};

/// Ends of the face, mm.
const FACE: [f64; 2] = [-20.0, 20.0];

/// 44/44, m 3, with leads of the wheel's own right and left flanks, which are right and left in the picture.
fn with_leads(leads: [Lead; 2]) -> GearPair {
    let pair = pair(&spur(44, 3.0).leads(leads), &spur(44, 3.0), 132.15);
    pair.with_face(FACE).unwrap()
}

fn lead(slope: f64, crowning: f64, zero: f64) -> Lead {
    Lead {
        face: FACE,
        range: FACE,
        slope,
        crowning,
        zero,
        ..Lead::default()
    }
}

fn slope(f: f64) -> Lead {
    lead(f, 0.0, 0.0)
}

fn places(pair: &GearPair) -> [FacePlace; 2] {
    let pose = Pose::new(pair, mating(1, 1));
    let found = ExactKernel::new(pair).lost_motion(&pose).unwrap();
    [found.right, found.left].map(|contact| FacePlace::of(pair, &pose, &contact.unwrap()).unwrap())
}

/// A turned helix `f` binds right flanks at the far end and left ones at the near end, and costs `f` along the base tangent. Tapered teeth bind at
/// one end. A crown `C` with a slope `f` binds at its vertex inside, and costs `f²/(16 C)`.
#[test]
fn leads_bind_where_their_closed_form_is_greatest_and_cost_that_much() {
    let (f, c) = (0.010, 0.008);
    let crown = |zero| [lead(0.0, c, zero), lead(0.0, c, zero)];
    let none = Lead::default;
    let vertex = f * f / (16.0 * c);
    for (name, leads, expected, loss) in [
        ("turned", [slope(f), slope(-f)], [FarEnd, NearEnd], f),
        ("tapered", [slope(f), slope(f)], [FarEnd, FarEnd], f),
        ("one flank", [slope(f), none()], [FarEnd, Inside], 0.5 * f),
        ("crowned at the end", crown(20.0), [Inside; 2], 2.0 * c),
        ("crowned", crown(0.0), [Inside; 2], 0.0),
        ("both", [lead(f, c, 0.0), none()], [Inside; 2], vertex),
    ] {
        let pair = with_leads(leads);
        assert_eq!(places(&pair), expected, "{name}");
        let found = extremes_of(&pair).face_loss.unwrap();
        let loss = loss / pair.operating_pressure_angle().cos();
        for own in [found.by(FaceDeviation::Lead), found.all] {
            near(name, own.unwrap(), loss, 1e-9);
        }
        for none in [FaceDeviation::Wobble, FaceDeviation::Shafts] {
            assert_eq!(found.by(none), Some(0.0), "{name}");
        }
    }
}

/// Shafts that lean by `θ` over a face `b` cost `sin α_wt θ b` in the plane of the axes and `cos α_wt θ b` out of it, on the base tangent, to first
/// order. A wobble `θ` turns through both.
#[test]
fn leaning_axes_cost_their_closed_form() {
    let theta = 1e-4;
    let pair = with_leads(Default::default());
    let alpha = pair.operating_pressure_angle();
    let leans = |lean| pair.clone().with_lean(lean).unwrap();
    let wheel = pair.gear(Member::Wheel).with_wobble(theta, 1.0);
    let wobbles = GearPair::new(wheel, pair.gear(Member::Pinion).clone(), 132.15);
    for (pair, kind, loss) in [
        (leans([theta, 0.0]), FaceDeviation::Shafts, alpha.tan()),
        (leans([0.0, theta]), FaceDeviation::Shafts, 1.0),
        (
            wobbles.unwrap().with_face(FACE).unwrap(),
            FaceDeviation::Wobble,
            1.0,
        ),
    ] {
        let found = extremes_of(&pair).face_loss.unwrap();
        let loss = loss * theta * (FACE[1] - FACE[0]);
        near(kind, found.by(kind).unwrap(), loss, 2e-3 * loss);
        assert_eq!(found.by(FaceDeviation::Lead), Some(0.0));
    }
}

/// Sections of leaning spur gears leave nothing out. A lean above 5e-3 rad is beyond what is recommended.
#[test]
fn tilt_is_warned_of() {
    for (lean, verdict) in [(1e-3, Pass), (6e-3, Warn)] {
        let pair = with_leads(Default::default());
        let pair = pair.with_lean([lean, 0.0]).unwrap();
        // The axes are nearer to each other at the near end.
        assert_eq!(places(&pair)[0], NearEnd);
        let found = diagnosed(&at_one_pose(&pair));
        let tilt = check(&found, "tilt", None);
        assert_eq!((tilt.formula, tilt.verdict), (Some(0.0), verdict));
        assert!(tilt.details.contains(&("lean_rad", lean)));
        assert_eq!(check(&found, "edge_contact", None).verdict, Warn);
    }
}

/// A trace from 2 to 35 mm of a face of 40 mm leaves 7 mm of it open, on either face of the gear.
#[test]
fn short_traces_are_warned_of() {
    let short = Lead {
        traces: vec![Trace {
            tooth: None,
            points: vec![(-18.0, 0.001), (0.0, 0.0), (15.0, 0.002)],
        }],
        ..slope(0.0)
    };
    let pair = with_leads([short, Lead::default()]);
    let wheel = pair.gear(Member::Wheel);
    assert_eq!(wheel.traced(), Some([-18.0, 15.0]));
    assert_eq!(wheel.facing(Face::Back).traced(), Some([-15.0, 18.0]));
    let found = diagnosed(&Study::of_pair("short", &pair, 1));
    let covers = check(&found, "lead_covers", Some(Member::Wheel));
    assert_eq!((covers.formula, covers.verdict), (Some(7.0), Warn));
}
