//! Checks of a pair: classes of contact, what they cost, limits by formula and as measured.

mod common;

use assert_cmd::Command;
use common::{ReferenceContact, reference_pair};
use gearlash::analytic::{LineOfAction, SideContact, limits};
use gearlash::compare::compare;
use gearlash::diagnosis::{
    Check, Diagnosis, Verdict, diagnose, non_involute_onset, radial_clearance, zero_distance,
};
use gearlash::gear::{AsBuilt, Blank, Deviations, Face, Gear, Rack, Side, Toothing};
use gearlash::input;
use gearlash::mesh::{ContactClass, ContactKind, ExactKernel, Method, Moment, PoseClass};
use gearlash::pair::{Assembly, Mating, Member, Pose, SweepPlan};
use gearlash::simulate::simulate;
use gearlash::study::Study;
use serde_json::Value;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("fixtures")
        .join(name)
}

fn pair_86_21(distance: f64) -> String {
    format!(
        "[wheel]\nteeth = 86\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n\
         [pinion]\nteeth = 21\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n\
         [assembly]\ncenter_distance_mm = {distance}\n\
         [sweep]\nmating = [[1, 1]]\nfraction = [{}]\n",
        (0..24)
            .map(|phase| (f64::from(phase) / 24.0).to_string())
            .collect::<Vec<_>>()
            .join(", ")
    )
}

fn written(text: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pair.toml");
    std::fs::write(&file, text).unwrap();
    (folder, file)
}

fn diagnosed(study: &Study) -> Diagnosis {
    let runs = simulate(study, Method::Exact { certify: true }, &|| {
        ControlFlow::Continue(())
    });
    let runs = compare(runs.unwrap(), study.tolerance_um);
    diagnose(study, &runs, &mut |_| Ok(())).unwrap()
}

fn check<'a>(diagnosis: &'a Diagnosis, id: &str, gear: Option<Member>) -> &'a Check {
    let mut all = diagnosis.groups.iter().flat_map(|group| &group.checks);
    all.find(|check| check.id == id && check.gear == gear)
        .unwrap()
}

/// Two gears, m 3, 20°, 44 and `pinion` teeth, each with an eccentricity.
fn eccentric(distance: f64, high: [(f64, f64); 2], pinion: u32) -> Assembly {
    let gear = |teeth, face, (eccentricity, high_tooth)| {
        let blank = Blank {
            toothing: Toothing::new(teeth, 3.0, 20f64.to_radians()).unwrap(),
            profile_shift: 0.0,
            rack: Rack::ISO_53_A,
            tip_diameter: None,
        };
        let deviations = Deviations {
            eccentricity,
            high_tooth,
            ..Deviations::default()
        };
        AsBuilt::new(Gear::nominal(blank).unwrap(), face, &deviations).unwrap()
    };
    Assembly::new(
        gear(44, Face::Front, high[0]),
        gear(pinion, Face::Back, high[1]),
        distance,
        Member::Wheel,
    )
    .unwrap()
}

fn mating(wheel_tooth: u32, pinion_tooth: u32) -> Mating {
    Mating {
        wheel_tooth,
        pinion_tooth,
        flank: Side::Right,
        fraction: 0.0,
    }
}

/// The case that issue 4 states, digits and all.
#[test]
fn the_fillet_of_86_21_costs_what_no_formula_sees() {
    let (_folder, file) = written(&pair_86_21(160.2));
    let found = diagnosed(&input::read(&file).unwrap());
    let worst = &found.contact.loss.as_ref().unwrap().worst;
    let close = |found: f64, stated: f64| {
        assert!((found - stated).abs() <= 5e-4, "{found} {stated}");
    };
    close((worst.backlash + worst.loss) * 1e3, -216.426);
    close(worst.backlash * 1e3, -238.948);
    close(worst.loss * 1e3, 22.522);
    assert_eq!(worst.class, PoseClass::Contact(ContactKind::TipFillet));
    let class = ContactClass::of(&worst.assembly, worst.side, &worst.contact);
    assert_eq!(class.tip, Some(Member::Wheel));
    close(worst.contact.pinion.radius, 28.948);
    close(
        check(&found, "non_involute_form", Some(Member::Pinion))
            .limit
            .unwrap(),
        29.668,
    );

    // Clearance is exactly the lower limit, K (8) is content, and yet.
    for member in [Member::Wheel, Member::Pinion] {
        let clearance = check(&found, "radial_clearance", Some(member));
        assert_eq!(clearance.verdict, Verdict::Warn);
        assert!(clearance.margin.unwrap().abs() <= 1e-9);
        let k_8 = check(&found, "non_involute_k8", Some(member));
        assert_eq!(k_8.verdict, Verdict::Pass);
    }
    let form = |member| check(&found, "non_involute_form", Some(member)).verdict;
    assert_eq!(form(Member::Wheel), Verdict::Pass);
    assert_eq!(form(Member::Pinion), Verdict::Fail);
    assert_eq!(
        check(&found, "off_line_contact", None).verdict,
        Verdict::Fail
    );
    let onset = found.groups[0].onset.unwrap();
    assert!(
        onset.distance > 160.2 && onset.distance < 160.3,
        "{onset:?}"
    );

    let (_folder, file) = written(&pair_86_21(160.3));
    let farther = diagnosed(&input::read(&file).unwrap());
    let loss = farther.contact.loss.as_ref().unwrap();
    assert!(loss.worst.loss.abs() <= 1e-9, "{}", loss.worst.loss);
    assert_eq!(
        check(&farther, "non_involute_onset", None).verdict,
        Verdict::Pass
    );
    // The onset does not depend on where the search began.
    let again = farther.groups[0].onset.unwrap().distance;
    assert!((again - onset.distance).abs() <= 2e-5, "{again} {onset:?}");
}

/// The onset against poses it never saw: 960 phases of a pitch.
#[test]
fn below_the_onset_something_is_touched_above_it_nothing() {
    let (_folder, file) = written(&pair_86_21(160.2));
    let study = input::read(&file).unwrap();
    let run = &study.runs().unwrap()[0];
    let onset = non_involute_onset(&run.assembly, &run.matings)
        .unwrap()
        .unwrap();
    assert!(onset.bracket[1] - onset.bracket[0] <= 1e-6);
    let touched = |distance: f64| {
        let assembly = run.assembly.at(distance).unwrap();
        let kernel = ExactKernel::new(&assembly);
        (0..960)
            .filter(|phase| {
                let mating = mating(1, 1).onward(&assembly, f64::from(*phase) / 960.0);
                let found = kernel.lost_motion(&Pose::new(&assembly, mating)).unwrap();
                PoseClass::of(&assembly, &found).is_non_involute()
            })
            .count()
    };
    // 960 phases miss the first one by up to half a step, which turns a tip's path by micrometres at most.
    assert!(touched(onset.distance - 1e-3) > 0);
    assert_eq!(touched(onset.bracket[1] + 1e-6), 0);
}

fn kind_of(contact: &ReferenceContact) -> ContactKind {
    let curves = [contact.wheel_curve.as_str(), contact.pinion_curve.as_str()];
    let has = |curve| curves.contains(&curve);
    match (has("root"), has("fillet"), has("tip")) {
        (true, _, _) => ContactKind::Root,
        (_, true, true) => ContactKind::TipFillet,
        (_, true, false) => ContactKind::Fillet,
        (_, false, true) if curves == ["tip", "tip"] => ContactKind::TipTip,
        (_, false, true) => ContactKind::TipInvolute,
        (_, false, false) => ContactKind::Involute,
    }
}

/// Both contacts of the 18 poses fillet_* and the 36 handover_*: the reference's curves.
#[test]
fn classes_of_the_reference_poses() {
    let (mut poses, mut corners, mut fillets) = (0, 0, 0);
    for name in ["fillet", "handover"]
        .iter()
        .flat_map(|kind| (1..=3).map(move |n| format!("{kind}_{n}")))
    {
        let pair = reference_pair(&name);
        let assembly = &pair.assembly;
        let kernel = ExactKernel::new(assembly);
        for reference in &pair.poses {
            let pose = Pose::new(assembly, reference.mating());
            let found = kernel.lost_motion(&pose).unwrap();
            let mut gravest = ContactKind::Involute;
            for (side, contact) in [(Side::Right, found.right), (Side::Left, found.left)] {
                let expected = reference.contact(side);
                let class = ContactClass::of(assembly, side, &contact.unwrap());
                assert_eq!(class.kind, kind_of(expected), "{name} {pose:?}");
                let tip = match (&*expected.wheel_curve, &*expected.pinion_curve) {
                    ("tip", "tip") => None,
                    ("tip", _) => Some(Member::Wheel),
                    (_, "tip") => Some(Member::Pinion),
                    _ => None,
                };
                assert_eq!(class.tip, tip, "{name}");
                gravest = gravest.max(class.kind);
                corners += usize::from(class.kind == ContactKind::TipInvolute);
                fillets += usize::from(class.kind == ContactKind::TipFillet);
            }
            let class = PoseClass::of(assembly, &found);
            assert_eq!(class, PoseClass::Contact(gravest));
            poses += 1;
        }
    }
    assert_eq!(poses, 18 + 36);
    println!("{corners} corner and {fillets} fillet contacts");
    assert!(corners > 0 && fillets > 0);
}

/// A premature corner's teeth touch on the line of action a little later, a late one's did a little before:
/// model 3 knows, which shares nothing with the classes.
#[test]
fn a_corner_is_premature_before_its_teeth_reach_the_line_of_action() {
    let (mut premature, mut late) = (0, 0);
    for name in ["handover_1", "handover_2", "handover_3"] {
        let pair = reference_pair(name);
        let assembly = &pair.assembly;
        let kernel = ExactKernel::new(assembly);
        for reference in &pair.poses {
            let mating = reference.mating();
            let found = kernel.lost_motion(&Pose::new(assembly, mating)).unwrap();
            for (side, contact) in [(Side::Right, found.right), (Side::Left, found.left)] {
                let contact = contact.unwrap();
                let class = ContactClass::of(assembly, side, &contact);
                if class.kind != ContactKind::TipInvolute {
                    continue;
                }
                let on_line = |pitches: f64| {
                    let pose = Pose::new(assembly, mating.onward(assembly, pitches));
                    SideContact::all(assembly, &pose, side).any(|c| {
                        c.locked_tooth == contact.wheel.tooth
                            && c.free_tooth == contact.pinion.tooth
                    })
                };
                let (before, after) = (on_line(-0.2), on_line(0.2));
                match class.moment.unwrap() {
                    Moment::Premature => {
                        assert!(after && !before, "{name} {mating:?} {side:?}");
                        premature += 1;
                    }
                    Moment::Late => {
                        assert!(before && !after, "{name} {mating:?} {side:?}");
                        late += 1;
                    }
                }
            }
        }
    }
    println!("{premature} premature, {late} late");
    assert!(premature > 0 && late > 0);
}

/// K (17) is exact for perfect gears.
#[test]
fn zero_backlash_distance_of_perfect_gears_is_k_17() {
    let mut assemblies: Vec<Assembly> = ["clear_1", "clear_2", "clear_3"]
        .iter()
        .map(|name| reference_pair(name).assembly)
        .collect();
    assemblies.push(eccentric(132.3, [(0.0, 1.0), (0.0, 1.0)], 44));
    for assembly in assemblies {
        let plan = SweepPlan::Revolution {
            pitches: 5,
            steps_per_pitch: 16,
            start: (1, 1),
        };
        let found = zero_distance(&assembly, &plan.matings(&assembly)).unwrap();
        let found = found.unwrap();
        let expected = limits::zero_backlash_distance(&assembly).unwrap();
        let off = (found.distance - expected).abs();
        assert!(off <= 1e-9, "{off:e} at {expected}");
        assert!(found.bracket[0] <= found.bracket[1]);
    }
}

/// The rig pair at most material. At the distance found, model 3 has no backlash at the pose found, the
/// worst of the sweep's poses is the one model 3 has for worst, and no rotation of the phase has less.
#[test]
fn zero_backlash_distance_of_the_rig_agrees_with_model_3() {
    let study = input::read(&fixture("karba_44x44.toml")).unwrap();
    let found = diagnosed(&study);
    let group = &found.groups[0];
    assert_eq!(group.material.name(), "most");
    let zero = group.zero.unwrap();
    let model_3 = |distance: f64, mating: Mating| {
        let assembly = group.assembly.at(distance).unwrap();
        let pose = Pose::new(&assembly, mating);
        LineOfAction::new(&assembly, &pose)
            .backlash(&assembly)
            .unwrap()
    };
    println!("{zero:?}");
    let at = model_3(zero.distance, zero.mating);
    assert!(at.abs() <= 1e-6, "{at:e}");
    for step in 0..44 * 40 {
        let turned = zero.mating.onward(&group.assembly, f64::from(step) / 40.0);
        let play = model_3(zero.distance, turned);
        assert!(play >= -1e-6, "{play:e} at {turned:?}");
    }
    let runs = study.runs().unwrap();
    let most = runs.iter().filter(|run| run.material == group.material);
    let plays = most
        .flat_map(|run| run.matings.iter().copied())
        .map(|mating| model_3(zero.of_poses, mating));
    let least = plays.fold(f64::INFINITY, f64::min);
    assert!(least.abs() <= 1e-6, "{least:e}");
    assert!(zero.of_poses <= zero.distance + 1e-9);
    assert!(zero.teeth.iter().all(|teeth| teeth.0 > 0 && teeth.1 > 0));
}

/// Wheel tooth 5 and the pinion's space 9|10 both on the line of centres, both gears displaced towards it.
#[test]
fn radial_clearance_of_eccentric_gears_where_the_phases_allow_it() {
    for (pinion, distance) in [(44, 132.4), (31, 113.0)] {
        let assembly = eccentric(distance, [(0.04, 5.0), (0.03, 9.5)], pinion);
        // Tooth 5 reaches the line of centres three quarters of a pitch beyond mating 4,9: half a tooth short of 5,10.
        let found = radial_clearance(&assembly, Member::Wheel, &[mating(4, 9)]).unwrap();
        let expected = limits::radial_clearance(&assembly, Member::Wheel) - 0.04 - 0.03;
        let off = (found.distance - expected).abs();
        assert!(off <= 1e-6, "{off:e}: {found:?}");
        assert_eq!((found.tip_tooth, found.root_tooth), (5, 9));
        // Phases that do not allow it leave more, but never less than with the high teeth apart.
        let other = radial_clearance(&assembly, Member::Wheel, &[mating(1, 20)]).unwrap();
        if pinion == 44 {
            assert!(other.distance > expected + 1e-3, "{other:?}");
        }
        assert!(other.distance >= expected - 1e-9);
    }
    // And the pinion's tooth in the wheel's space.
    let assembly = eccentric(132.4, [(0.04, 5.5), (0.03, 9.0)], 44);
    let found = radial_clearance(&assembly, Member::Pinion, &[mating(5, 9)]).unwrap();
    let expected = limits::radial_clearance(&assembly, Member::Pinion) - 0.07;
    assert!((found.distance - expected).abs() <= 1e-6, "{found:?}");
    // Perfect gears: the formula.
    let perfect = eccentric(132.4, [(0.0, 1.0), (0.0, 1.0)], 44);
    let found = radial_clearance(&perfect, Member::Wheel, &[mating(1, 1)]).unwrap();
    assert!((found.distance - limits::radial_clearance(&perfect, Member::Wheel)).abs() <= 1e-12);
}

fn gearlash(folder: &Path) -> Command {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    command.current_dir(folder);
    command
}

#[test]
fn exit_codes_and_json_of_the_command() {
    let (folder, file) = written(&pair_86_21(160.2));
    let assert = gearlash(folder.path())
        .args(["check", "--format", "json"])
        .arg(&file)
        .assert()
        .code(1);
    let json: Value = serde_json::from_slice(&assert.get_output().stdout).unwrap();
    let checks = json["checks"].as_array().unwrap();
    for (id, gears) in [
        ("radial_clearance", 2),
        ("non_involute_k8", 2),
        ("non_involute_form", 2),
        ("zero_backlash_distance", 1),
        ("backlash_condition", 1),
        ("undercut", 2),
        ("contact_ratio", 1),
        ("tip_thickness", 2),
        ("off_line_contact", 1),
    ] {
        let of_id: Vec<&Value> = checks.iter().filter(|check| check["id"] == id).collect();
        assert_eq!(of_id.len(), gears, "{id}");
        for check in of_id {
            for key in ["analytic", "measured", "limit", "margin"] {
                assert!(check[key].is_number(), "{id} {key}: {check}");
            }
            assert_eq!(check["gear"].is_string(), gears == 2);
            assert!(["pass", "warn", "fail"].contains(&check["verdict"].as_str().unwrap()));
        }
    }
    let contact = &json["contact"];
    let classes = contact["classes"].as_object().unwrap();
    let poses: u64 = classes.values().map(|n| n.as_u64().unwrap()).sum();
    assert_eq!(poses, 48);
    assert!(classes["tip-fillet"].as_u64().unwrap() > 0);
    assert!((contact["worst_loss_um"].as_f64().unwrap() - 22.522).abs() <= 5e-4);
    assert_eq!(contact["worst"]["contact"]["pinion_curve"], "fillet");

    gearlash(folder.path())
        .arg("check")
        .arg(fixture("karba_44x44.toml"))
        .assert()
        .code(0);
    gearlash(folder.path())
        .args(["check", "missing.toml"])
        .assert()
        .code(2);
    assert!(!folder.path().join("out").exists());
}

/// A simulation's summary counts the same classes.
#[test]
fn a_simulation_counts_classes_too() {
    let (folder, file) = written(&pair_86_21(160.2));
    let assert = gearlash(folder.path())
        .args(["simulate", "--format", "json"])
        .arg(&file)
        .assert()
        .success();
    let json: Value = serde_json::from_slice(&assert.get_output().stdout).unwrap();
    let run = &json["runs"][0];
    let poses = run["poses"].as_array().unwrap();
    let counted = run["summary"]["contact"]["classes"].as_object().unwrap();
    for (class, count) in counted {
        let of_class = poses.iter().filter(|pose| pose["class"] == class.as_str());
        assert_eq!(of_class.count() as u64, count.as_u64().unwrap(), "{class}");
    }
    let worst = &run["summary"]["contact"]["worst"];
    assert_eq!(worst["contact"]["tip_gear"], "wheel");
    assert!(worst["contact"]["wheel_tooth"].is_u64());
}

#[test]
fn the_map_is_a_picture_and_a_table() {
    let (folder, file) = written(&pair_86_21(160.2));
    gearlash(folder.path())
        .args(["check", "--map", "-o", "map"])
        .arg(&file)
        .assert()
        .code(1);
    let read = |name: &str| std::fs::read_to_string(folder.path().join("map").join(name)).unwrap();
    let svg = read("map_as-measured.svg");
    let picture = roxmltree::Document::parse(&svg).unwrap();
    let texts: Vec<&str> = picture
        .descendants()
        .filter(|node| node.has_tag_name("text"))
        .filter_map(|node| node.text())
        .collect();
    for limit in [
        "K (17)",
        "K (8)",
        "form circle",
        "0.15 m",
        "0.25 m",
        "a of the pair",
    ] {
        assert!(
            texts.iter().any(|text| text.contains(limit)),
            "{limit}: {texts:?}"
        );
    }
    let csv = read("map_as-measured.csv");
    let mut rows = csv.lines();
    assert_eq!(
        rows.next(),
        Some("center_distance_mm,fraction,class,j_wt_um")
    );
    let rows: Vec<Vec<&str>> = rows.map(|row| row.split(',').collect()).collect();
    assert_eq!(rows.len(), 60 * 60);
    // Far apart involutes touch, K (17) says with play; near enough all is jammed.
    assert!(
        rows.iter()
            .any(|row| row[2] == "jammed" && row[3].is_empty())
    );
    for row in rows {
        let distance: f64 = row[0].parse().unwrap();
        if distance > 160.5 {
            assert_eq!(row[2], "involute-involute");
            assert!(row[3].parse::<f64>().unwrap() > 0.0);
        }
    }
}
