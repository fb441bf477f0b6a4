//! A gear written as an outline and read back.

use gearlash::analysis::study::Material;
use gearlash::contact::{ExactKernel, OutlineKernel};
use gearlash::gear::Side;
use gearlash::outline::OutlinePair;
use gearlash::pair::{GearPair, Mating, Member, Pose};
use gearlash_drawing::{OutlineFile, OutlineFormat};
use gearlash_input::read;
use std::path::Path;

/// The tolerance stated by the files, µm.
const TOLERANCE_UM: f64 = 0.1;

/// The rig's pair as DXF, SVG and CSV at 0.1 µm: at 88 poses, every tooth at both flanks, the lost motion of the curves within the bound
/// that both files state. Source: the exact method.
#[test]
fn the_rig_reads_back_with_its_lost_motion() {
    let fixture = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/karba_44x44.toml");
    let study = read(&fixture).unwrap().study;
    let (_, wheel, pinion) = study.materials[0].clone();
    let pair = GearPair::new(wheel, pinion, 132.21).unwrap();
    for (format, ending) in [
        (OutlineFormat::Dxf, "dxf"),
        (OutlineFormat::Svg, "svg"),
        (OutlineFormat::Csv, "csv"),
    ] {
        let folder = tempfile::tempdir().unwrap();
        for member in [Member::Wheel, Member::Pinion] {
            let file = OutlineFile {
                title: "rig",
                name: member.name(),
                material: Material::Most,
                gear: pair.gear(member),
                section_mm: 0.0,
                tolerance_um: TOLERANCE_UM,
            };
            let path = folder.path().join(format!("{}.{ending}", member.name()));
            std::fs::write(path, file.text(format)).unwrap();
        }
        let text = format!(
            "[wheel.outline]\nfile = \"wheel.{ending}\"\nteeth = 44\n[pinion]\nreference_face = \"back\"\n\
             [pinion.outline]\nfile = \"pinion.{ending}\"\n[assembly]\ncenter_distance_mm = 132.21\n"
        );
        let path = folder.path().join("pair.toml");
        std::fs::write(&path, text).unwrap();
        let file = read(&path).unwrap();
        let (_, wheel, pinion) = file.study.drawn[0].clone();
        let outlines = OutlinePair::new(wheel, pinion, 132.21, Member::Wheel).unwrap();
        let (kernel, exact) = (OutlineKernel::new(&outlines), ExactKernel::new(&pair));
        let radius = outlines.operating_pitch_radius(Member::Pinion);
        let mut worst: f64 = 0.0;
        for tooth in 1..=44 {
            for flank in Side::BOTH {
                let mating = Mating {
                    wheel_tooth: tooth,
                    pinion_tooth: tooth,
                    flank,
                    fraction: 0.0,
                };
                let known = exact.lost_motion(&Pose::new(&pair, mating)).unwrap();
                let found = kernel.lost_motion(&mating).unwrap();
                let off = known.angle().unwrap() - found.angle().unwrap();
                worst = worst.max((off * radius * 1e3).abs());
            }
        }
        // Two flanks of two gears, each within the tolerance: along the normal, 1/cos 20° as an arc.
        assert!(worst <= 0.3 && worst > 0.0, "{ending}: {worst} µm");
    }
}
