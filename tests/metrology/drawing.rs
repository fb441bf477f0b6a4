//! Statements of a drawing: tolerance fields, offsets and temperatures, compared with published tables and closed forms.

use super::*;

/// Copied from two public programs with equal values.
const DIN_3967: &str = include_str!("../../fixtures/reference/din_3967.csv");

fn allowances(field: &str, diameter: f64) -> Result<[f64; 2], GearError> {
    // The module is limited to 1000 mm, so use more teeth.
    let teeth = if diameter > 1000.0 { 1024 } else { 32 };
    let field: ThicknessField = field.parse().unwrap();
    field.allowances_um(&spur(teeth, diameter / f64::from(teeth)).design.basic_data)
}

#[test]
fn every_thickness_field_is_that_of_the_published_table() {
    let mut lines = DIN_3967.lines().filter(|line| !line.starts_with('#'));
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let (series, tolerances) = (&header[1..12], &header[12..]);
    let (mut above, mut compared) = (1.0, 0);
    for line in lines {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        // A row is for "previous bound < d ≤ bound": both ends of it.
        for diameter in [1.001 * above, cells[0]] {
            for (a, series) in series.iter().enumerate() {
                for (t, tolerance) in tolerances.iter().enumerate() {
                    let field = format!("{tolerance}{series}");
                    let upper = cells[1 + a];
                    let expected = [upper, upper - cells[12 + t]];
                    let found = allowances(&field, diameter);
                    assert_eq!(found, Ok(expected), "{field} at {diameter} mm");
                    compared += 1;
                }
            }
        }
        above = cells[0];
    }
    assert_eq!(compared, 11 * 2 * 11 * 10);
}

#[test]
fn what_is_no_field_is_refused() {
    // Blanks are no matter.
    assert_eq!("30 js 7 ".parse::<DesignatedDistance>(), "30js7".parse());
    for text in [" cd 25 ", "DIN 3967 cd25"] {
        assert_eq!(text.parse::<ThicknessField>(), "25cd".parse());
    }
    for text in "|cd|25|20cd|31cd|25i|25CD|2c5d|25cd x|c25d|25-cd|２５cd".split('|') {
        let field = text.parse::<ThicknessField>();
        assert_eq!(field, Err(GearError::ThicknessField), "{text}");
    }
    let distances = "|30|js7|30 js4|30 js11|30 k7|30 H11|30 ±|±0.02|30 ±-0.02|30 jS7|30 0.03/0|30/0|30 +0.03/|30 +x/0|\
                     -30 js7|1e2 js7|3mm5 H7|30 js+7|30 js7 x|3.0.0 js7|inf js7|30 j s7";
    for text in distances.split('|') {
        let distance = text.parse::<DesignatedDistance>();
        assert_eq!(distance, Err(GearError::DistanceField), "{text}");
    }
    assert!(allowances("25cd", 10_001.0).is_err());
    for beyond in ["3 js7", "500.1 js7"] {
        let distance: DesignatedDistance = beyond.parse().unwrap();
        assert!(distance.deviations_um().is_err(), "{beyond}");
    }
}

/// Source: the standard tolerance factor of ISO 286, `i = 0.45 ∛D + 0.001 D` µm with `D` the geometric mean of a range (mm), and its multiples 7 …
/// 64; the table is rounded from them.
#[test]
fn js_is_half_the_grade_of_the_tolerance_factor() {
    let bounds = "3 6 10 18 30 50 80 120 180 250 315 400 500";
    let bounds = bounds.split(' ').map(|bound| bound.parse().unwrap());
    let bounds: Vec<f64> = bounds.collect();
    for ends in bounds.windows(2) {
        let mean = f64::sqrt(ends[0] * ends[1]);
        let factor = 0.45 * mean.cbrt() + 0.001 * mean;
        for nominal in [ends[0] + 0.001, ends[1]] {
            for (grade, multiple) in (5..=10).zip([7.0, 10.0, 16.0, 25.0, 40.0, 64.0]) {
                let distance: DesignatedDistance = format!("{nominal} js{grade}").parse().unwrap();
                let [lower, upper] = distance.deviations_um().unwrap();
                let found = upper - lower;
                near(distance, found, multiple * factor, 0.6 + 0.03 * found);
            }
        }
    }
}

/// Source: ISO 286-1 as widely printed: IT7 of 30 mm is 21 µm, IT6 13 µm; a hole `H` lies above, a shaft `h` below the nominal size.
/// `F` and `f` lie 20 µm off it.
#[test]
fn distances_are_read_as_drawings_write_them() {
    for (text, shown, deviations) in [
        ("30 js7", "30 js7", [-10.5, 10.5]),
        ("30,0 JS7", "30 js7", [-10.5, 10.5]),
        ("30 H7", "30 H7", [0.0, 21.0]),
        ("30 h6", "30 h6", [-13.0, 0.0]),
        ("30±0.02", "30 ±0.02", [-20.0, 20.0]),
        ("30,5 ± 0,02", "30.5 ±0.02", [-20.0, 20.0]),
        ("30 mm +/-0.02 mm", "30 ±0.02", [-20.0, 20.0]),
        ("30 +0.03 -0.01", "30 +0.03/-0.01", [-10.0, 30.0]),
        ("30 F7", "30 F7", [20.0, 41.0]),
        ("30f6", "30 f6", [-33.0, -20.0]),
        ("30 +0.03/0", "30 +0.03/0", [0.0, 30.0]),
        ("30,0 0 / −0,02", "30 0/-0.02", [-20.0, 0.0]),
        ("30-0.25/+0.5", "30 +0.5/-0.25", [-250.0, 500.0]),
    ] {
        let distance: DesignatedDistance = text.parse().unwrap();
        assert_eq!(distance.to_string(), shown);
        assert_eq!(distance.deviations_um(), Ok(deviations), "{text}");
        assert_eq!(shown.parse(), Ok(distance));
    }
}

fn measured(thickness: ThicknessStatement) -> Toleranced<Gear> {
    let statement = Measurements {
        thickness,
        ..Measurements::nominal(spur(24, 2.0).design, Face::Front)
    };
    let gears = statement.measure().unwrap().as_built;
    let of = gears.try_map(|built| Ok::<_, GearError>(built.gear().clone()));
    of.unwrap()
}

/// Source: normals of both flanks at the contact lie on the line of action: four flanks moved in by δ each leave 2 δ a side of normal backlash more.
#[test]
fn flanks_moved_in_leave_that_much_normal_backlash() {
    let offset = |mm| ThicknessStatement::FlankOffset(Toleranced::Single(mm));
    let [nominal, thin] = [0.0, -0.05].map(|mm| measured(offset(mm)));
    let backlash = |gear: &Gear| InvolutePair::new(gear, gear).base_backlash(48.3).unwrap();
    let more = backlash(thin.most()) - backlash(nominal.most());
    near("more", more, 4.0 * 0.05, 1e-13);
}

/// A field is the band of its two allowances.
#[test]
fn a_field_makes_the_gears_of_its_allowances() {
    let field = measured(ThicknessStatement::Field("25cd".parse().unwrap()));
    let band = Toleranced::Band {
        least: -84.0,
        most: -54.0,
    };
    assert_eq!(field, measured(ThicknessStatement::AllowanceUm(band)));
}
