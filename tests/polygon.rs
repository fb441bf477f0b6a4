//! The polygon method against `fixtures/reference/lost_motion`.

mod common;
use gearlash::mesh::{CutGear, PolygonKernel};
use gearlash::pair::{Member, Pose};

#[test]
fn probe() {
    for name in common::REFERENCES {
        let assembly = common::reference_pair(name);
        for chord_um in [0.01] {
            let w = CutGear::new(assembly.gear(Member::Wheel), chord_um * 1e-3);
            let p = CutGear::new(assembly.gear(Member::Pinion), chord_um * 1e-3);
            let kernel = PolygonKernel::new(&assembly, &w, &p);
            for r in common::reference_poses(name) {
                let pose = Pose::new(&assembly, r.mating);
                assert!(
                    (pose.locked_rotation() - r.wheel_rotation).abs() < 1e-12,
                    "{name} {} {}",
                    pose.locked_rotation(),
                    r.wheel_rotation
                );
                let t = std::time::Instant::now();
                let l = kernel.lost_motion(&pose).unwrap();
                let t = t.elapsed();
                let um = assembly.operating_pitch_radius(assembly.free()) * 1e3;
                let (j, e) = (l.angle().unwrap() * um, l.error().unwrap() * um);
                let names = |c: &gearlash::mesh::Contact| {
                    format!(
                        "{} {} {} {} {:.4} {:.4}",
                        c.wheel.tooth,
                        c.pinion.tooth,
                        c.wheel.curve.name(),
                        c.pinion.curve.name(),
                        c.wheel.radius,
                        c.pinion.radius
                    )
                };
                println!(
                    "{name} {j:.4} diff {:+.5} bound {e:.5} {} | {} {} {} | {t:?}",
                    j - r.j_wt_um,
                    names(&l.right.unwrap()),
                    names(&l.left.unwrap()),
                    r.json["right"],
                    r.json["left"]
                );
            }
        }
    }
}
