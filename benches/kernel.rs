//! One lost motion of the exact method, one core. The names are stable: other benches compare with them.
//!
//! Every measurement cycles through a revolution at 7 poses a pitch, so that no pose is warm.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use gearlash::contact::ExactKernel;
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Pitch, Side,
};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use std::hint::black_box;

fn gear(teeth: u32, module: f64) -> Gear {
    Gear::nominal(GearDesign {
        basic_data: BasicGearData::new(teeth, module, 20f64.to_radians()).unwrap(),
        profile_shift: 0.0,
        rack: BasicRack::ISO_53_A,
        tip_diameter: None,
    })
    .unwrap()
}

/// Pitch deviation of ±8 µm without pattern and a runout of 20 µm: ordinary quality 7 at module 3.
fn deviated(teeth: u32, module: f64, face: Face) -> AsBuilt {
    let list = |start: u32| -> Vec<f64> {
        (0..teeth)
            .map(|k| 0.008 * (f64::from((k * 7919 + start) % 1000) / 500.0 - 1.0))
            .collect()
    };
    let deviations = Deviations {
        pitch: Some(Pitch::from_cumulative(&list(17), &list(443))),
        eccentricity: 0.010,
        high_tooth: 12.5,
        ..Deviations::default()
    };
    AsBuilt::new(gear(teeth, module), face, &deviations).unwrap()
}

fn perfect(teeth: u32, distance: f64) -> GearPair {
    let [wheel, pinion] =
        [Face::Front, Face::Back].map(|face| AsBuilt::perfect(gear(teeth, 3.0), face));
    GearPair::with_locked(wheel, pinion, distance, Member::Wheel).unwrap()
}

fn wild(teeth: u32, distance: f64) -> GearPair {
    let [wheel, pinion] = [Face::Front, Face::Back].map(|face| deviated(teeth, 3.0, face));
    GearPair::with_locked(wheel, pinion, distance, Member::Wheel).unwrap()
}

fn poses(assembly: &GearPair) -> Vec<Pose> {
    let teeth = assembly.gear(Member::Wheel).gear().basic_data().teeth();
    (0..teeth * 7)
        .map(|k| {
            let mating = Mating {
                wheel_tooth: 1,
                pinion_tooth: 1,
                flank: Side::Right,
                fraction: f64::from(k) / 7.0,
            };
            Pose::new(assembly, mating)
        })
        .collect()
}

fn measure(criterion: &mut Criterion, name: &str, teeth: u32, assembly: &GearPair) {
    let kernel = ExactKernel::new(assembly);
    let poses = poses(assembly);
    let mut next = 0;
    criterion.bench_with_input(BenchmarkId::new(name, teeth), &kernel, |bencher, kernel| {
        bencher.iter(|| {
            next = (next + 1) % poses.len();
            kernel.lost_motion(black_box(&poses[next]))
        });
    });
}

fn lost_motion(criterion: &mut Criterion) {
    for teeth in [20, 44, 100, 300, 1000] {
        let reference = 3.0 * f64::from(teeth);
        measure(
            criterion,
            "exact/perfect",
            teeth,
            &perfect(teeth, reference + 0.1),
        );
        measure(
            criterion,
            "exact/deviated",
            teeth,
            &wild(teeth, reference + 0.1),
        );
    }
}

fn search(criterion: &mut Criterion) {
    let assembly = wild(44, 132.1);
    let kernel = ExactKernel::new(&assembly);
    let poses = poses(&assembly);
    let mut next = 0;
    criterion.bench_function("exact/search/44", |bencher| {
        bencher.iter(|| {
            next = (next + 1) % poses.len();
            kernel.lost_motion_by_search(black_box(&poses[next]))
        });
    });
    criterion.bench_function("exact/new/44", |bencher| {
        bencher.iter(|| ExactKernel::new(black_box(&assembly)));
    });
}

criterion_group!(benches, lost_motion, search);
criterion_main!(benches);
