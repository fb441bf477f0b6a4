use gearlash::contact::ExactKernel;
use gearlash::gear::*;
use gearlash::pair::*;
use std::time::Instant;
fn built(teeth: u32, face: Face, n: u32) -> AsBuilt {
    let gear = Gear::nominal(GearDesign {
        basic_data: BasicGearData::new(teeth, 3.0, 20f64.to_radians()).unwrap(),
        profile_shift: 0.0,
        rack: BasicRack::ISO_53_A,
        tip_diameter: None,
    })
    .unwrap();
    let (from, to) = (gear.form_roll(), gear.tip_roll());
    let last = f64::from(n - 1);
    let trace = |tooth: Option<u32>| {
        let seed = tooth.unwrap_or(0) * 131;
        let point = |k: u32| {
            let share = f64::from(k) / last;
            let noise = 0.001 * (f64::from((k + seed) * 7919 % 1000) / 500.0 - 1.0);
            (
                from + (to - from) * share,
                0.003 * (7.0 * share).sin() + noise,
            )
        };
        Trace {
            tooth,
            points: (0..n).map(point).collect(),
        }
    };
    let all = std::env::args().nth(2).is_some();
    let traces = if all {
        (1..=teeth).map(|t| trace(Some(t))).collect()
    } else {
        vec![trace(None)]
    };
    let profile = Modification {
        traces,
        ..Modification::default()
    };
    let list = |start: u32| -> Vec<f64> {
        (0..teeth)
            .map(|k| 0.008 * (f64::from((k * 7919 + start) % 1000) / 500.0 - 1.0))
            .collect()
    };
    let d = Deviations {
        pitch: Some(Pitch::from_cumulative(&list(17), &list(443))),
        eccentricity: 0.010,
        high_tooth: 5.5,
        profiles: [profile.clone(), profile],
        ..Deviations::default()
    };
    AsBuilt::new(gear, face, &d).unwrap()
}
fn main() {
    for n in [50, 100, 200, 480] {
        let pair = GearPair::with_locked(
            built(44, Face::Front, n),
            built(44, Face::Back, n),
            132.1,
            Member::Wheel,
        )
        .unwrap();
        let kernel = ExactKernel::new(&pair);
        let poses: Vec<Pose> = (0..308)
            .map(|k| {
                Pose::new(
                    &pair,
                    Mating {
                        wheel_tooth: 1,
                        pinion_tooth: 1,
                        flank: Side::Right,
                        fraction: f64::from(k * 44) / 308.0,
                    },
                )
            })
            .collect();
        let mut best = f64::INFINITY;
        let mut sum = 0.0;
        for _ in 0..5 {
            let s = Instant::now();
            sum = 0.0;
            for p in &poses {
                sum += kernel.lost_motion(p).unwrap().angle().unwrap();
            }
            best = best.min(s.elapsed().as_secs_f64());
        }
        println!("{n}: {:.2} us a pose, sum {sum:.15}", best / 308.0 * 1e6);
    }
}
