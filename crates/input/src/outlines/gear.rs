//! `[wheel.outline]` and `[pinion.outline]`: from the keys and the drawing to the gear.

use super::paths::{Choice, ChosenOutline, centres_inside, choose, coordinates};
use crate::runout::RunoutSheet;
use crate::spec::{
    CentreName, CentreSpec, Either, OutlineGearSpec, OutlineSpec, OutlineThicknessSpec, PointsKind,
};
use gearlash::gear::Face;
use gearlash::metrology::Toleranced;
use gearlash::outline::{OutlineError, OutlineGear, OutlineReading, PathSegment, fit_centre};
use gearlash_drawing::{Format, Options, Repeat};
use gearlash_tables::DataFile;
use gearlash_text::Table;
use gearlash_text::numbers::{fixed, rounded, shortest, um};
use nalgebra::Point2;

/// Most teeth of a gear.
const MAX_TEETH: u32 = 10_000;

/// The content of a drawing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawingRead {
    /// Length of one of its units before the gear's `scale`, mm.
    pub unit_mm: f64,
    /// The gear's centre in it, mm.
    pub centre: Point2<f64>,
    /// Lines, arcs and cubic curves of the outline.
    pub parts: [usize; 3],
    /// Their greatest distance from the drawing, mm.
    pub bound_mm: f64,
    /// Closed paths within the outline that are not part of it, such as a bore.
    pub inside: usize,
}

pub(crate) struct OutlinePart {
    /// One, or those with least and most material.
    pub gears: Toleranced<OutlineGear>,
    pub read: DrawingRead,
    pub spec: OutlineGearSpec,
    /// The eccentricity that a fitted centre takes out.
    pub warning: Option<String>,
    pub remarks: Vec<String>,
}

/// Reads the table `name` of a gear given by an outline.
pub(crate) fn gear(file: &Table, name: &str) -> Option<OutlinePart> {
    let table = file.below(name);
    let face = table.read::<Face>("reference_face");
    let spec = table.read("outline").flatten();
    let stated_scale = table.read::<f64>("scale").flatten();
    let scale = stated_scale.unwrap_or(1.0);
    let thickness = table.read::<OutlineThicknessSpec>("thickness");
    let drawn = spec.and_then(|spec| drawn(&table, spec, scale));
    let teeth = drawn.as_ref().and_then(|(spec, ..)| spec.teeth);
    let runout = table.read("runout");
    let runout =
        runout.and_then(|spec| RunoutSheet::read(&table, spec.unwrap_or_default(), teeth, None));
    file.is_good(name).then_some(())?;
    let (spec, chosen, data) = drawn?;
    let (face, runout, thickness) = (face?.unwrap_or_default(), runout?, thickness?);
    if runout.range_um().is_some() {
        return table.refuse(
            "runout.file",
            "readings of a runout need a gear by its data",
            "state total_um and high_tooth",
        );
    }
    let runout = runout.spec;
    let mut remarks = Vec::new();
    let centre = centre(&table, &spec, &chosen, scale, &mut remarks)?;
    let reading = OutlineReading {
        centre,
        face,
        teeth: spec.teeth,
        first_tooth: spec.first_tooth_deg.map(f64::to_radians),
        bound: chosen.path.bound_mm,
    };
    let segments = &chosen.path.segments;
    let gear = OutlineGear::new(segments, &reading);
    let gear = gear.map_err(|error| data.problem(data.found(place(&chosen, &error)), help(&error)));
    let gear = data.reading().keep(gear)?;
    if gear.teeth() > MAX_TEETH {
        return data.refuse(
            format!(
                "{} teeth are found, allowed are up to {MAX_TEETH}",
                gear.teeth()
            ),
            "choose the gear's outline with `at_mm`, `number`, `layer` or `id`",
        );
    }
    let high_tooth = runout.high_tooth.unwrap_or(1.0);
    if runout.total() > 0.0 && runout.high_tooth.is_none() {
        return table.refuse(
            "runout.high_tooth",
            "missing, an outline's runout needs its direction",
            "add `high_tooth`, the tooth towards which the teeth are displaced",
        );
    }
    if high_tooth >= f64::from(gear.teeth()) + 1.0 {
        return table.refuse(
            "runout.high_tooth",
            format!(
                "out of range, allowed is 1 up to, but not including, {}",
                gear.teeth() + 1
            ),
            "count from the first tooth of the drawing",
        );
    }
    let displaced = gear.with_runout(scale * runout.total() / 2000.0, high_tooth);
    let gear = table.keep("runout.total_um", displaced, "give the runout in µm")?;
    let offset = thickness.and_then(|thickness| thickness.flank_offset_mm);
    let offset = offset.map_or(Toleranced::Single(0.0), Either::toleranced);
    let gears = offset.try_map(|mm| gear.with_flank_offset(scale * mm));
    let gears =
        gears.map_err(|error| table.problem("thickness.flank_offset_mm", &error, help(&error)));
    let gears = data.reading().keep(gears)?;
    let gear = gears.most();
    let moved = match offset {
        Toleranced::Single(0.0) => String::new(),
        Toleranced::Single(mm) => format!(", moved out by {} mm", shortest(mm)),
        Toleranced::Band { least, most } => {
            format!(", moved out by {} … {} mm", shortest(least), shortest(most))
        }
    };
    let kinks = match spec.kind {
        PointsKind::Smooth if !segments.is_empty() => kinks(segments),
        _ => String::new(),
    };
    remarks.push(format!(
        "{name}: {} teeth between diameters {} and {} mm{moved}{}{kinks}{}",
        gear.teeth(),
        fixed(2.0 * gear.root_radius(), 4),
        fixed(2.0 * gear.tip_radius(), 4),
        match gear.bound() {
            0.0 => ", its curves as drawn".to_owned(),
            bound => format!(", within {} µm of what is drawn", um(bound, 4)),
        },
        match chosen.remarks.len() {
            0 => String::new(),
            _ => format!("; {}", data.found(chosen.remarks.join("; "))),
        }
    ));
    let is_fitted = matches!(spec.center_mm, CentreSpec::Found(CentreName::Fit));
    let warning = taken_out(&chosen, centre, gear).filter(|_| is_fitted);
    let count = |of: fn(&PathSegment) -> bool| segments.iter().filter(|part| of(part)).count();
    Some(OutlinePart {
        gears,
        read: DrawingRead {
            unit_mm: rounded(chosen.unit_mm / scale, 9),
            centre,
            parts: [
                count(|part| matches!(part, PathSegment::Line(_))),
                count(|part| matches!(part, PathSegment::Arc { .. })),
                count(|part| matches!(part, PathSegment::Cubic(_))),
            ],
            bound_mm: chosen.path.bound_mm,
            inside: chosen.inside,
        },
        spec: OutlineGearSpec {
            outline: spec,
            thickness,
            reference_face: face,
            runout,
            scale: stated_scale,
        },
        warning: warning.map(|words| format!("{}: {words}", table.path_of("outline.center_mm"))),
        remarks,
    })
}

/// The drawing that `spec` names, in the gear's table `gear`.
fn drawn(
    gear: &Table,
    spec: OutlineSpec,
    scale: f64,
) -> Option<(OutlineSpec, ChosenOutline, DataFile)> {
    let table = gear.below("outline");
    let data = DataFile::of(&table)?;
    let format = Format::of(data.path());
    for (key, given, of, only) in [
        ("layer", &spec.layer, "dxf", Format::Dxf),
        ("id", &spec.id, "svg", Format::Svg),
    ] {
        if given.is_some() && format != Some(only) {
            return table.refuse(key, format!("belongs to a .{of} file"), "remove it");
        }
    }
    let bytes = data.bytes()?;
    let options = Options {
        unit: spec.units,
        scale,
        select: spec.layer.clone().or_else(|| spec.id.clone()),
        join_mm: spec.join_mm,
        repeat: match (spec.teeth, &spec.center_mm) {
            (Some(teeth), &CentreSpec::At(centre)) => Some(Repeat {
                teeth,
                centre: Point2::from(centre) * scale,
            }),
            _ => None,
        },
        smooth: spec.kind == PointsKind::Smooth,
    };
    let read = gearlash_drawing::read(data.path(), &bytes, &options);
    let read = read.map_err(|error| data.problem(data.found(error.to_string()), error.help));
    let choice = match (spec.number, spec.at_mm, &spec.center_mm) {
        (Some(_), Some(_), _) => {
            return table.refuse("number", "given together with at_mm", "remove one of them");
        }
        (Some(number), None, _) => Choice::Number(number),
        (None, Some(point), _) => Choice::At(Point2::from(point) * scale),
        (None, None, &CentreSpec::At(centre)) => Choice::Centre(Some(Point2::from(centre) * scale)),
        (None, None, CentreSpec::Found(_)) => Choice::Centre(None),
    };
    let chosen = choose(data.reading().keep(read)?, choice);
    let chosen = chosen.map_err(|reason| {
        data.problem(
            data.found(reason),
            "choose one with `at_mm`, `number`, `layer` or `id`, or remove the others from the drawing",
        )
    });
    let mut chosen = data.reading().keep(chosen)?;
    let is_bore = matches!(spec.center_mm, CentreSpec::Found(CentreName::Bore));
    if is_bore && options.select.is_some() && chosen.centres.is_empty() {
        // The bore is on another layer, or in another element.
        let all = Options {
            select: None,
            ..options
        };
        let all = gearlash_drawing::read(data.path(), &bytes, &all).ok();
        chosen.centres = all.map_or(Vec::new(), |all| centres_inside(&chosen.path, &all.loops));
    }
    Some((spec, chosen, data))
}

/// The centre in the drawing, mm.
fn centre(
    gear: &Table,
    spec: &OutlineSpec,
    chosen: &ChosenOutline,
    scale: f64,
    remarks: &mut Vec<String>,
) -> Option<Point2<f64>> {
    match spec.center_mm {
        CentreSpec::At([x, y]) => Some(Point2::new(x, y) * scale),
        CentreSpec::Found(CentreName::Bore) => match &chosen.centres[..] {
            [bore] => Some(*bore),
            others => gear.refuse(
                "outline.center_mm",
                format!(
                    "needs circles about one centre inside the outline, {} are drawn in {}{}",
                    others.len(),
                    spec.file,
                    centres(others)
                ),
                "state the centre as [x, y] in mm, or \"fit\"",
            ),
        },
        CentreSpec::Found(CentreName::Fit) => {
            let fitted = fit_centre(&chosen.path.segments);
            let help = "state the centre as [x, y] in mm";
            let fitted = gear.keep("outline.center_mm", fitted, help)?;
            remarks.push(format!(
                "centre fitted to the tips: ({}, {}) mm, no tip off their circle by more than {} µm",
                fixed(fitted.centre.x, 6),
                fixed(fitted.centre.y, 6),
                um(fitted.residual, 3)
            ));
            Some(fitted.centre)
        }
    }
}

/// The eccentricity of a `gear` with a fitted `centre` about the one circle inside, or the drawing's origin; `None` where neither is near.
fn taken_out(chosen: &ChosenOutline, centre: Point2<f64>, gear: &OutlineGear) -> Option<String> {
    let (axis, name) = match &chosen.centres[..] {
        [bore] => (*bore, "circle inside"),
        _ => (Point2::origin(), "drawing's origin"),
    };
    let off = (centre - axis).norm();
    (1e-4..gear.tip_radius() - gear.root_radius()).contains(&off).then(|| {
        format!(
            "\"fit\" takes an eccentricity of {} µm out of the drawing: the circle through the tips is that far from the {name}. If it belongs \
             to the gear, give another centre, or state [runout]",
            um(off, 3)
        )
    })
}

/// Centres of circles, a few of them.
fn centres(circles: &[Point2<f64>]) -> String {
    const FEW: usize = 4;
    let named = circles.iter().take(FEW).map(coordinates);
    let named: Vec<String> = named.collect();
    match circles.len() {
        0 => String::new(),
        count if count > FEW => format!(", about {} and others", named.join(", ")),
        _ => format!(", about {}", named.join(" and ")),
    }
}

/// The kinks that a smooth curve through points rounds off: points at which its chords turn by more than those of a regular
/// polygon of twelve corners.
fn kinks(segments: &[PathSegment]) -> String {
    const SHARP_DEG: f64 = 30.0;
    let from = |index: usize| segments[index % segments.len()].at(0.0);
    let turns = (0..segments.len()).map(|index| {
        let (before, here, next) = (from(index), from(index + 1), from(index + 2));
        let turn = (here - before).angle(&(next - here)).to_degrees();
        (turn, here)
    });
    let sharp: Vec<(f64, Point2<f64>)> = turns.filter(|(turn, _)| *turn > SHARP_DEG).collect();
    let sharpest = sharp.iter().max_by(|a, b| a.0.total_cmp(&b.0));
    match sharpest {
        None => ", a smooth curve through its points, none a kink".to_owned(),
        Some((turn, at)) => format!(
            ", a smooth curve through its points. It rounds, and may overshoot, {} kinks of more than {SHARP_DEG}°, the sharpest {}° at {}",
            sharp.len(),
            fixed(*turn, 1),
            coordinates(at)
        ),
    }
}

fn place(chosen: &ChosenOutline, error: &OutlineError) -> String {
    format!("the path from {}: {error}", chosen.path.place)
}

pub(crate) fn help(error: &OutlineError) -> &'static str {
    match error {
        OutlineError::NotFinite { .. } | OutlineError::SelfCrossing { .. } => {
            "mend the drawing there"
        }
        OutlineError::Open { .. } => "close the path, or allow larger gaps with join_mm",
        OutlineError::CentreOutside { .. } => {
            "state the gear's centre with center_mm = [x, y], \"bore\" or \"fit\""
        }
        OutlineError::TooFewTeeth { .. } => {
            "choose the gear's outline with `at_mm`, `number`, `layer` or `id`, and check its centre and unit"
        }
        OutlineError::OtherTeeth { .. } => "correct `teeth`, or the drawing",
        OutlineError::Uneven { .. } => "mend the drawing there, and check the centre",
        OutlineError::Eccentric { .. } => "give the runout in µm",
        OutlineError::TooNear { .. } => "give a greater centre distance",
        OutlineError::Offset { .. } => {
            "give a smaller offset, or a drawing with stronger teeth or wider spaces"
        }
        OutlineError::OtherGear { .. } => "give two drawings of the same gear",
    }
}
