//! Ratios of kernel times, measured in one run. benches/README.md explains them.
//!
//! `cargo bench --bench ratios`. Every time is the least of several rounds, because other work on the machine only adds time.

mod gears;
mod newcomer;

use gearlash::analytic::LineOfAction;
use gearlash::contact::{
    Certifier, ExactKernel, Method, OutlineCertifier, OutlineKernel, Prover, cycle_extremes, sweep,
};
use gearlash::error::go_on;
use gearlash::gear::Face;
use gearlash::outline::{OutlineGear, OutlinePair, OutlineReading, of_gear};
use gearlash::pair::{GearPair, Mating, Member, Pose, SweepPlan};
use gearlash::population::{Draw, SampleKind};
use gears::{
    AlongFace, along_face, cut, drawing, helical, modified, pair, poses, traced, wide_face,
    with_runouts,
};
use nalgebra::Point2;
use newcomer::newcomer;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Rounds of which the fastest counts.
const ROUNDS: usize = 7;

/// Rounds for extremes: one takes a tenth of a millisecond, and the first few have cold caches.
const ROUNDS_OF_EXTREMES: usize = 50;

fn fastest(mut work: impl FnMut()) -> Duration {
    let once = |work: &mut dyn FnMut()| {
        let start = Instant::now();
        work();
        start.elapsed()
    };
    (0..ROUNDS).map(|_| once(&mut work)).min().unwrap()
}

/// Seconds a pose.
fn a_pose(poses: &[Pose], mut work: impl FnMut(&Pose)) -> f64 {
    let all = fastest(|| poses.iter().for_each(|pose| work(black_box(pose))));
    all.as_secs_f64() / poses.len() as f64
}

fn exact(assembly: &GearPair) -> f64 {
    let kernel = ExactKernel::new(assembly);
    a_pose(&poses(assembly), |pose| {
        black_box(kernel.lost_motion(pose).unwrap());
    })
}

/// Seconds a pose of the same gears drawn in chords, and of its certificate, and how many parts a tooth has.
fn outlines(assembly: &GearPair) -> (f64, f64, usize) {
    let mut parts = 0;
    let mut drawn = |member| {
        let built = assembly.gear(member);
        let segments = of_gear(built, 3e-3);
        let teeth = built.gear().basic_data().teeth();
        parts = segments.len() / teeth as usize;
        let reading = OutlineReading {
            centre: Point2::origin(),
            face: built.face(),
            teeth: Some(teeth),
            first_tooth: None,
            bound: 0.0,
        };
        OutlineGear::new(&segments, &reading).unwrap()
    };
    let (wheel, pinion) = (drawn(Member::Wheel), drawn(Member::Pinion));
    let distance = assembly.center_distance();
    let pair = OutlinePair::new(wheel, pinion, distance, assembly.locked()).unwrap();
    let kernel = OutlineKernel::new(&pair);
    let seconds = a_pose(&poses(assembly), |pose| {
        black_box(kernel.lost_motion(pose.mating()).unwrap());
    });
    let certifier = OutlineCertifier::new(&kernel);
    let poses = poses(assembly);
    let found: Vec<_> = poses
        .iter()
        .map(|pose| kernel.lost_motion(pose.mating()).unwrap())
        .collect();
    let all = fastest(|| {
        for (pose, found) in poses.iter().zip(&found) {
            certifier.check(pose.mating(), found).unwrap();
        }
    });
    (seconds, all.as_secs_f64() / poses.len() as f64, parts)
}

fn model_3(assembly: &GearPair) -> f64 {
    a_pose(&poses(assembly), |pose| {
        black_box(LineOfAction::new(assembly, pose));
    })
}

fn certificate(assembly: &GearPair) -> f64 {
    let (cut, kernel) = (cut(assembly), ExactKernel::new(assembly));
    let certifier = Certifier::new(cut.kernel(assembly));
    let poses = poses(assembly);
    let found: Vec<_> = poses
        .iter()
        .map(|pose| kernel.lost_motion(pose).unwrap())
        .collect();
    let all = fastest(|| {
        for (pose, found) in poses.iter().zip(&found) {
            certifier.check(pose, found).unwrap();
        }
    });
    all.as_secs_f64() / poses.len() as f64
}

/// Seconds a pose: exact and proven by directions, and how often that goes into exact and certified by polygons.
fn proven(assembly: &GearPair) -> (f64, f64) {
    let kernel = ExactKernel::new(assembly);
    let prover = Prover::new(assembly, &kernel);
    let proven = a_pose(&poses(assembly), |pose| {
        let found = kernel.lost_motion(pose).unwrap();
        black_box(prover.check(pose, &found)).unwrap();
    });
    let matings: Vec<Mating> = poses(assembly).iter().map(|pose| *pose.mating()).collect();
    let a_pose = |method| swept(assembly, &matings, method, 1) / matings.len() as f64;
    let certificate = a_pose(Method::Checked) - proven;
    let exact = a_pose(Method::Exact { certify: false });
    (proven, (exact + certificate) / proven)
}

/// Seconds for a whole sweep on `threads` threads.
fn swept(assembly: &GearPair, matings: &[Mating], method: Method, threads: usize) -> f64 {
    let cut = cut(assembly);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    let pool = pool.build().unwrap();
    let time = fastest(|| {
        pool.install(|| black_box(sweep(assembly, &cut, method, matings, 0.0, &go_on)).unwrap());
    });
    time.as_secs_f64()
}

fn row(what: &str, found: f64, unit: &str, wanted: &str) {
    println!("{what:<58} {found:>14.3} {unit:<3} {wanted}");
}

/// Seconds for both extremes of the whole mesh cycle, kernel included. Panics unless both are proven.
fn extremes(assembly: &GearPair) -> f64 {
    let [wheel, pinion] =
        Member::BOTH.map(|member| assembly.gear(member).gear().basic_data().teeth());
    let matings = SweepPlan::hunting_pitches(wheel, pinion);
    let first = Mating::FIRST;
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS_OF_EXTREMES {
        let start = Instant::now();
        let kernel = ExactKernel::new(assembly);
        let found = cycle_extremes(&kernel, assembly, first, matings, 1e-6).unwrap();
        least = least.min(start.elapsed().as_secs_f64());
        let ends = [found.least, found.greatest];
        assert!(ends.iter().flatten().filter(|end| end.is_proven()).count() == 2);
    }
    least
}

/// Seconds an assembly of the drawing pair.
fn assembly() -> f64 {
    let population = drawing();
    let all = fastest(|| {
        for number in 1..=100 {
            let draw = Draw {
                seed: 1,
                sample: SampleKind::Population,
                number,
            };
            black_box(population.assembly(draw).unwrap().outcome().unwrap());
        }
    });
    all.as_secs_f64() / 100.0
}

fn main() {
    println!("{:<58} {:>14}     wanted", "what", "found");
    let (perfect, wild) = (pair([44, 44], true), pair([44, 44], false));
    let (exact_perfect, exact_wild) = (exact(&perfect), exact(&wild));
    row("exact, 44/44 perfect", exact_perfect * 1e6, "µs", "≤ 0.6");
    row(
        "exact, 44/44 deviated, eccentric",
        exact_wild * 1e6,
        "µs",
        "≤ 1.2",
    );
    let over_face = exact(&helical()) / exact_wild;
    let what = "helical 44/44, overlap ratio 1.3, over the spur pose";
    row(what, over_face, "", "≤ 2.5");
    for (what, helical, lean, wanted) in [
        ("spur", false, 0.0, "≤ 1.5"),
        ("helical", true, 0.0, "≤ 10"),
        ("leaning spur", false, 3e-4, "≤ 12"),
        ("leaning helical", true, 3e-4, "≤ 12"),
    ] {
        for (beside, trace, wanted) in [("", false, wanted), (" and trace", true, "")] {
            let pair = along_face(AlongFace {
                helical,
                leads: true,
                trace,
                lean,
            });
            let what = format!("{what} 44/44 with slopes, crowns{beside}, over the spur pose");
            row(&what, exact(&pair) / exact_wild, "", wanted);
        }
    }
    let (wheel, pinion) = (modified(44, Face::Front), modified(44, Face::Back));
    let profiled = GearPair::with_locked(wheel, pinion, 132.1, Member::Wheel).unwrap();
    let what = "exact, 44/44 deviated, eccentric, modified profiles";
    row(what, exact(&profiled) * 1e6, "µs", "≤ 4");
    for points in [100, 480] {
        let (wheel, pinion) = (
            traced(44, Face::Front, points),
            traced(44, Face::Back, points),
        );
        let noisy = GearPair::with_locked(wheel, pinion, 132.1, Member::Wheel).unwrap();
        let what = format!("exact, 44/44 deviated, eccentric, trace of {points} points");
        row(&what, exact(&noisy) * 1e6, "µs", "");
    }
    let (seconds, certificate_of_outlines, parts) = outlines(&wild);
    let what = format!("outlines, 44/44 deviated, {parts} parts a tooth");
    row(&what, seconds * 1e6, "µs", "≤ 20");
    let micro = certificate_of_outlines * 1e6;
    row("certificate of such outlines", micro, "µs", "≤ 50");
    for (what, assembly, exact) in [
        ("perfect", &perfect, exact_perfect),
        ("deviated, eccentric", &wild, exact_wild),
    ] {
        let ratio = exact / model_3(assembly);
        row(&format!("exact over model 3, {what}"), ratio, "", "≤ 10");
        let micro = certificate(assembly) * 1e6;
        row(&format!("certificate, {what}"), micro, "µs", "≤ 20");
    }

    let ten = pair([10, 10], false);
    for (what, assembly, wanted) in [
        ("44/44 perfect", &perfect, "≥ 4"),
        ("44/44 deviated, eccentric", &wild, "≥ 3.5"),
        ("10/10 undercut, deviated, eccentric", &ten, "≥ 2"),
        ("helical 44/44, overlap ratio 1.3", &helical(), "≥ 2"),
    ] {
        let (seconds, ratio) = proven(assembly);
        row(&format!("proven pose, {what}"), seconds * 1e6, "µs", "");
        row(
            &format!("exact and certificate over it, {what}"),
            ratio,
            "",
            wanted,
        );
    }

    for (what, assembly, per, unit, wanted) in [
        ("44/44", &wild, 1e6, "µs", "≤ 150"),
        ("86/21", &pair([86, 21], false), 1e3, "ms", "≤ 2"),
        ("199/200", &pair([199, 200], false), 1e3, "ms", "≤ 30"),
        (
            "20/31, runouts of 30 µm",
            &with_runouts([20, 31], 0.030),
            1e3,
            "ms",
            "≤ 1",
        ),
        ("helical 27/51 over 50 mm", &wide_face(), 1e3, "ms", "≤ 3"),
    ] {
        let what = format!("extremes {what}, kernel included");
        row(&what, extremes(assembly) * per, unit, wanted);
    }
    row(
        "assembly 20/40, runouts in any direction",
        assembly() * 1e6,
        "µs",
        "",
    );

    let revolution = SweepPlan::wheel_revolution(&wild, 16, (1, 1)).matings(&wild);
    let method = Method::Exact { certify: true };
    let one = swept(&wild, &revolution, method, 1);
    let what = "revolution 44/44, 16 a pitch, proven, 1 core";
    row(what, one * 1e3, "ms", "≤ 4.4");
    let checked = swept(&wild, &revolution, Method::Checked, 1);
    row(
        "that revolution, polygons at every pose, over it",
        checked / one,
        "",
        "",
    );
    let two = swept(&wild, &revolution, method, 2);
    row(
        "one thread over two, that revolution",
        one / two,
        "",
        "≥ 1.8",
    );
    let hunting = pair([86, 21], false);
    let cycle = SweepPlan::hunting_cycle(&hunting, 16, (1, 1)).matings(&hunting);
    let method = Method::Exact { certify: false };
    let one = swept(&hunting, &cycle, method, 1);
    let two = swept(&hunting, &cycle, method, 2);
    row(
        "hunting cycle 86/21, 16 a pitch, uncertified, 2 cores",
        two * 1e3,
        "ms",
        "≤ 50",
    );
    row("one thread over two, that cycle", one / two, "", "≥ 1.8");

    for (kind, is_perfect, wanted) in [
        ("perfect", true, "≤ 3"),
        ("deviated, eccentric", false, "≤ 5"),
    ] {
        // Ten teeth are undercut and searched: a row of their own, and no base to compare with.
        let ten = exact(&pair([10, 10], is_perfect)) * 1e6;
        row(
            &format!("exact, 10/10, undercut, {kind}"),
            ten,
            "µs",
            wanted,
        );
        let least = exact(&pair([30, 30], is_perfect));
        for teeth in [100, 300, 1000] {
            let growth = exact(&pair([teeth; 2], is_perfect)) / least;
            let root = (f64::from(teeth) / 30.0).sqrt();
            let what = format!("z = {teeth} over z = 30, over √z, {kind}");
            row(&what, growth / root, "", "≤ 1");
        }
    }

    let pose = poses(&perfect)[0];
    let (angle, seconds) = newcomer(&perfect, &pose);
    let found = ExactKernel::new(&perfect).lost_motion(&pose).unwrap();
    let off = (angle - found.angle().unwrap()).abs() * 66.0;
    row(
        "newcomer's bisection, 44/44 perfect, 1e-6 mm chords",
        seconds,
        "s",
        "",
    );
    row("the same, off by", off * 1e3, "µm", "");
    row(
        "newcomer over exact",
        seconds / exact_perfect,
        "",
        "≥ 1000000",
    );
}
