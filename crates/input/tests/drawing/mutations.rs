//! Ten thousand mutants of each format: an error with its place, or loops; and where no geometry is touched, the loops as they were.

use super::*;
use mutant::{Choice, count, mutant};
use std::ops::Range;
use std::time::Instant;

/// Whether an error says where: a line, a point, or that it is of the whole file.
fn has_place(error: &DrawingError) -> bool {
    let mut of_file = "line |the unit is not stated|the file states|no closed loop".split('|');
    of_file.any(|words| error.reason.starts_with(words))
}

/// `good` with one mistake: a flipped bit, or one of those of the tables.
fn mistaken(good: &[u8], choice: &mut Choice) -> Vec<u8> {
    if choice.below(4) > 0 {
        return mutant(good, choice);
    }
    let mut bytes = good.to_vec();
    bytes[choice.below(good.len())] ^= 1 << choice.below(8);
    bytes
}

/// Reads the mutants of `text`; `geometry` are the bytes that say what is drawn.
fn run(ending: &str, text: &str, geometry: &[Range<usize>], options: &Options) {
    let good = drawn(ending, text, options).unwrap();
    let name = format!("gear.{ending}");
    let (mut errors, mut same, mut other, mut untouched) = (0, 0, 0, 0);
    let mut choice = Choice(text.len() as u64);
    for number in 0..count() {
        let bytes = mistaken(text.as_bytes(), &mut choice);
        let start = Instant::now();
        let read = read(Path::new(&name), &bytes, options);
        let took = start.elapsed();
        assert!(took.as_secs_f64() < 1.0, "{number}: {took:?}");
        let pairs = || bytes.iter().zip(text.as_bytes());
        let before = pairs().take_while(|(a, b)| a == b).count();
        let rest = bytes.len().min(text.len()) - before;
        let behind = bytes.iter().rev().zip(text.as_bytes().iter().rev());
        let behind = behind.take(rest).take_while(|(a, b)| a == b).count();
        // Also what only touches it, so that an inserted byte is not taken for one outside.
        let touched = before..text.len() - behind;
        // A shape put in where none was is geometry as well.
        let shape = bytes[before..bytes.len() - behind].contains(&b'<');
        let beside = !shape
            && !geometry
                .iter()
                .any(|range| touched.start <= range.end && range.start <= touched.end);
        match read {
            Ok(drawing) => {
                check_sound(&drawing);
                let mut pairs = drawing.loops.iter().zip(&good.loops);
                let agrees = drawing.loops.len() == good.loops.len()
                    && pairs.all(|(a, b)| a.segments == b.segments && a.bound_mm == b.bound_mm);
                let shown = String::from_utf8_lossy(&bytes);
                assert!(agrees || !beside, "{number}: {shown}");
                *(if agrees { &mut same } else { &mut other }) += 1;
                untouched += usize::from(beside);
            }
            Err(error) => {
                let is_whole = has_place(&error) && !error.help.is_empty();
                assert!(is_whole, "{number}: {error}");
                errors += 1;
            }
        }
    }
    println!(
        "{ending}: {errors} errors, {same} the same ({untouched} of them untouched), {other} other loops"
    );
    let is_mixed = 6 * errors > count() && 150 * untouched > count();
    assert!(is_mixed, "{errors} errors, {untouched} untouched");
}

/// Where `text` has `from` up to `to`.
fn between(text: &str, from: &str, to: &str) -> Range<usize> {
    let start = text.find(from).unwrap();
    start..start + text[start..].find(to).unwrap()
}

#[test]
fn garbled_dxf() {
    let text = made::mixed_dxf();
    let section = |name: &str| format!("  0\nSECTION\n  2\n{name}");
    let geometry = [
        between(&text, "  9\n$INSUNITS", "  9\n$EXTMIN"),
        between(&text, &section("ENTITIES"), &section("OBJECTS")),
    ];
    run("dxf", &text, &geometry, &Options::default());
}

#[test]
fn garbled_svg() {
    let text = made::mixed_svg();
    let geometry = [
        between(&text, "<svg", "<title>"),
        between(&text, "<g transform", "<!--"),
    ];
    run("svg", &text, &geometry, &Options::default());
}

#[test]
fn garbled_lists() {
    let text = made::list();
    let rows = text.find("x,y").unwrap()..text.len();
    let geometry = [between(&text, "# unit", "# teeth"), rows];
    for smooth in [false, true] {
        let options = Options {
            smooth,
            ..Options::default()
        };
        run("csv", &text, &geometry, &options);
    }
}
