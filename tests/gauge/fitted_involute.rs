//! The involute that is fitted to a drawn gear.

use gearlash::gear::{AsBuilt, BasicGearData, BasicRack, Face, Gear, GearDesign};
use gearlash::outline::{OutlineGear, OutlineReading, PathSegment, of_gear};
use nalgebra::Point2;
use std::f64::consts::{FRAC_PI_2, TAU};

fn read(path: &[PathSegment]) -> OutlineGear {
    let reading = OutlineReading {
        centre: Point2::origin(),
        face: Face::Front,
        teeth: None,
        first_tooth: None,
        bound: 0.0,
    };
    OutlineGear::new(path, &reading).unwrap()
}

fn gear(teeth: u32, module: f64, angle_deg: f64, allowance: f64) -> Gear {
    let data = BasicGearData::new(teeth, module, angle_deg.to_radians()).unwrap();
    // A tip round that a rack of 25° has room for.
    let design = GearDesign {
        rack: BasicRack::new(1.0, 1.25, 0.3).unwrap(),
        ..GearDesign::standard(data)
    };
    let thickness = design.nominal_base_thickness() + allowance;
    Gear::new(design, thickness).unwrap()
}

/// Gears drawn as chords, whose ends lie on the flank, give back their data.
#[test]
fn a_drawn_gear_gives_its_module_back() {
    for (teeth, module, angle, allowance) in [
        (20, 2.0, 20.0, -0.06),
        (10, 1.0, 20.0, 0.0),
        (17, 0.5, 25.0, 0.02),
        (120, 5.0, 14.5, -0.1),
    ] {
        let gear = gear(teeth, module, angle, allowance);
        let drawn = of_gear(&AsBuilt::perfect(gear.clone(), Face::Front), 1e-4 * module);
        let found = read(&drawn).fitted_involute().unwrap();
        let off = (found.base_radius - gear.base_radius()) / module;
        assert!(
            off.abs() < 1e-9 && found.residual < 1e-9,
            "{teeth}: {off} {}",
            found.residual
        );
        assert!((found.base_thickness - gear.base_thickness()).abs() < 1e-9);
        let [standard] = found.standard[..] else {
            panic!("{:?}", found.standard);
        };
        assert_eq!(
            (standard.module, standard.pressure_angle),
            (module, angle.to_radians())
        );
        assert!((standard.shift - gear.generating_shift()).abs() < 1e-8);
        // An outline from data has curves in place of chords.
        let exact = OutlineGear::from(&AsBuilt::perfect(gear, Face::Front));
        let exact = exact.fitted_involute().unwrap();
        assert!((exact.base_radius - found.base_radius).abs() < 1e-9 * module);
    }
}

/// Every second corner is moved outwards by 1 µm: some 0.4 µm along the normals at the pressure angle, half to either side of the
/// fit. The module is still within the error bound.
#[test]
fn the_residual_is_what_the_points_are_off() {
    let gear = gear(20, 2.0, 20.0, 0.0);
    let drawn = of_gear(&AsBuilt::perfect(gear.clone(), Face::Front), 1e-5);
    let corners: Vec<Point2<f64>> = drawn.iter().map(PathSegment::start).collect();
    let moved = corners.iter().enumerate().map(|(k, corner)| {
        let out = if k.is_multiple_of(2) { 0.0 } else { 1e-3 };
        corner + corner.coords.normalize() * out
    });
    let moved: Vec<Point2<f64>> = moved.collect();
    let next = moved.iter().cycle().skip(1);
    let lines = moved
        .iter()
        .zip(next)
        .map(|(a, b)| PathSegment::Line([*a, *b]));
    let found = read(&lines.collect::<Vec<_>>()).fitted_involute().unwrap();
    assert!(
        found.residual > 1e-4 && found.residual < 4e-4,
        "{}",
        found.residual
    );
    assert!((found.base_radius - gear.base_radius()).abs() <= found.base_radius_error);
    assert_eq!(found.standard[0].module, 2.0);
}

/// Arcs of half the involute's radius of curvature, straight flanks, and flanks with too few points are no involutes.
#[test]
fn other_flanks_are_no_involutes() {
    let z = 20;
    let corner = |radius: f64, pitches: f64| {
        let (sin, cos) = (FRAC_PI_2 + pitches * TAU / f64::from(z)).sin_cos();
        Point2::new(radius * cos, radius * sin)
    };
    let between = |a: Point2<f64>, b: Point2<f64>, bulge: f64| {
        // A flat arc as the cubic curve with its tangents: height `bulge` of its chord.
        let along = b - a;
        let out = nalgebra::Vector2::new(along.y, -along.x) * bulge;
        PathSegment::Cubic([
            a,
            a + along / 3.0 + out * 4.0 / 3.0,
            b - along / 3.0 + out * 4.0 / 3.0,
            b,
        ])
    };
    for bulge in [0.0, 0.1] {
        let tooth = |k: u32| {
            let [a, b, c, d] = [(17.5, -0.4), (22.0, -0.1), (22.0, 0.1), (17.5, 0.4)]
                .map(|(radius, pitches)| corner(radius, f64::from(k) + pitches));
            let next = corner(17.5, f64::from(k) + 0.6);
            [
                between(a, b, bulge),
                PathSegment::Line([b, c]),
                between(c, d, bulge),
                PathSegment::Line([d, next]),
            ]
        };
        let path: Vec<PathSegment> = (0..z).flat_map(tooth).collect();
        assert_eq!(read(&path).fitted_involute(), None, "{bulge}");
        let ends = path
            .iter()
            .map(|part| PathSegment::Line([part.start(), part.end()]));
        assert_eq!(read(&ends.collect::<Vec<_>>()).fitted_involute(), None);
    }
}
