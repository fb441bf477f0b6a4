//! A drawing: the first byte says which format, the rest is the file. Problems that say so, or loops that close; with a gear in it, a pair of two of
//! it whose first pose has an answer.
#![no_main]

use gearlash_drawing::{Options, Unit, read};
use gearlash::outline::AssembledPair;
use gearlash::pair::Mating;
use gearlash_input::outlines::{Drawings, OutlineOptions};
use libfuzzer_sys::{Corpus, fuzz_target};
use std::path::Path;
use tempfile::TempDir;

/// Ends of a loop's segments meet to this, mm.
const MEET: f64 = 1e-8;
/// Segments of a drawing that is read as a gear, too: more are slow.
const MOST: usize = 2000;

fuzz_target!(|bytes: &[u8]| -> Corpus {
    let Some((&choice, file)) = bytes.split_first() else {
        return Corpus::Reject;
    };
    let (name, smooth) = match choice {
        b'd' => ("gear.dxf", false),
        b's' => ("gear.svg", false),
        b'c' => ("gear.csv", false),
        b'C' => ("gear.csv", true),
        _ => return Corpus::Reject,
    };
    let options = |unit| Options { unit, smooth, ..Options::default() };
    let drawing = match read(Path::new(name), file, &options(None)) {
        Ok(drawing) => Ok((drawing, None)),
        Err(_) => read(Path::new(name), file, &options(Some(Unit::Mm))).map(|drawing| (drawing, Some("mm"))),
    };
    let (drawing, units) = match drawing {
        Ok(read) => read,
        Err(error) => {
            assert!(!error.to_string().is_empty() && !error.help.is_empty());
            return Corpus::Keep;
        }
    };
    assert!(!drawing.loops.is_empty());
    for path in &drawing.loops {
        let next = path.segments.iter().cycle().skip(1);
        for (one, next) in path.segments.iter().zip(next) {
            let size = one.end().coords.norm().max(1.0);
            assert!((one.end() - next.start()).norm() <= MEET * size, "{one:?} {next:?}");
        }
    }
    let segments: usize = drawing.loops.iter().map(|path| path.segments.len()).sum();
    if segments <= MOST && !smooth {
        gear(name, file, units);
    }
    Corpus::Keep
});

/// Two of the gear that `file` draws, far enough apart: problems, or a lost motion or a reason.
fn gear(name: &str, file: &[u8], units: Option<&str>) {
    let folder = TempDir::new_in("/dev/shm").or_else(|_| TempDir::new()).unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, file).unwrap();
    let options = OutlineOptions { units, ..OutlineOptions::default() };
    let drawings = |center_distance_mm| Drawings {
        wheel: &path,
        pinion: &path,
        center_distance_mm,
        options: [options; 2],
    };
    let pair = gearlash_input::read_drawings(&drawings(1e6));
    let Ok(pair) = pair else { return };
    let (_, wheel, pinion) = &pair.study.drawn[0];
    let a = wheel.tip_radius() + pinion.root_radius();
    let Ok(pair_at) = gearlash::outline::OutlinePair::new(wheel.clone(), pinion.clone(), 1.01 * a, pair.study.locked) else {
        return;
    };
    let pose = gearlash::contact::lost_motion_at(&AssembledPair::Drawn(pair_at), Mating::FIRST);
    let pose = pose.expect("a pose is a result");
    if let Some((j_wt, error)) = pose.backlash.zip(pose.error_bound) {
        assert!(j_wt.is_finite() && error >= 0.0, "{pose:?}");
    }
}
