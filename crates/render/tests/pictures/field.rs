//! The field of action: shades and crosses. `docs/gallery` has its lines and gaps.

use super::drawn::{HALF, Picture, place};
use super::{METHOD, heading, on};
use gearlash::analysis::curves::Field;
use gearlash::contact::{ContactKind, CutPair, sweep};
use gearlash::gear::Side;
use gearlash::pair::{GearPair, Mating};
use gearlash_render::chart::{self, Chart};

/// 27/51 with measured pitch, 0.3 of a pitch beyond a mating.
fn field() -> Field {
    let study = super::study("../docs/files/helical_measured.toml");
    let (_, wheel, pinion) = &study.materials[0];
    let pair: GearPair = study.pair(wheel, pinion, 190.0).unwrap();
    let mating = Mating {
        wheel_tooth: 4,
        pinion_tooth: 16,
        flank: Side::Right,
        fraction: 0.3,
    };
    let cut = CutPair::for_certificates(wheel, pinion);
    let poses = sweep(&pair, &cut, METHOD, &[mating], 0.0, &on).unwrap();
    Field::of(&pair, &poses[0]).unwrap()
}

fn drawn(field: &Field) -> Chart {
    chart::field(&heading("field", "Field"), field)
}

/// A stretch in which fillets are touched is shaded in both panels of its side, and named; without one there is none.
#[test]
fn fillets_are_shaded() {
    let mut field = field();
    const GREEN: &str = "#009e73";
    let shades = |field: &Field| drawn(field).svg.matches(GREEN).count();
    assert_eq!(shades(&field), 0);
    let stretch = [-12.5, 3.25];
    field.sides[0].fillets = vec![stretch];
    // Its sample in the legend, and one a panel.
    assert_eq!(shades(&field), 3);
    let chart = drawn(&field);
    let picture = Picture::of(&chart.svg);
    assert!(picture.says(|text| text.contains("fillet, root or undercut edge touched first")));
    assert!(picture.says(|text| text.contains("shaded: z = −12.5 … 3.25 mm")));
    let plot = &chart.panels[0];
    let mut shades = picture.areas.iter().filter(|area| area.fill == GREEN);
    let shade = shades.find(|area| (area.room[1] - plot.frame.top).abs() < HALF);
    let [left, _, right, _] = shade.unwrap().room;
    for (at, z) in [left, right].into_iter().zip(stretch) {
        assert!((at - place(plot, [z, 0.0])[0]).abs() < HALF, "{z}: {at}");
    }
}

/// A cross where a point binds, none where a whole line does.
#[test]
fn a_line_binds_without_a_point() {
    let mut field = field();
    for (kind, words, point) in [
        (ContactKind::TipInvolute, "mm, tip-involute", true),
        (ContactKind::Involute, "binds along its line, z = ", false),
    ] {
        for side in &mut field.sides {
            side.lines[0].binds = true;
            side.binding.kind = kind;
        }
        let svg = drawn(&field).svg;
        assert_eq!(svg.matches(words).count(), 2, "{words}");
        assert_eq!(svg.contains("where it binds"), point);
    }
}

/// A line is paler where a gap is left, and opaque where none is.
#[test]
fn a_line_is_paler_where_a_gap_is_left() {
    let mut field = field();
    let line = &mut field.sides[0].lines[0];
    let [[z, place], [to, beyond]] = line.ends;
    let parts = (0..=8).map(|k| f64::from(k) / 8.0);
    let at = |part: f64| [z + (to - z) * part, place + (beyond - place) * part];
    let points = parts.map(|part| [at(part)[0], at(part)[1], 0.02 * part]);
    line.points = points.collect();
    let svg = drawn(&field).svg;
    let opacities = svg.split("opacity=\"").skip(1);
    let opacities = opacities.map(|it| it.split('"').next().unwrap());
    let least = opacities.map(|it| it.parse().unwrap()).fold(1.0, f64::min);
    // Seven of eight shades from 1 to 0.12.
    assert!((least - 0.23).abs() < 1e-9, "{least}");
}
