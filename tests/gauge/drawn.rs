//! Drawn gears: the involute that is fitted to one, and the difference of two, whose deviations have a closed form.

use super::*;

fn gear_of(teeth: u32, module: f64, angle_deg: f64, allowance: f64) -> Gear {
    // A tip round that a rack of 25° has room for.
    let gear = spur_of_angle(teeth, module, angle_deg).rack(1.0, 1.25, 0.3);
    gear.thinner(-allowance).gear()
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
        let gear = gear_of(teeth, module, angle, allowance);
        let drawn = of_gear(&AsBuilt::perfect(gear.clone(), Face::Front), 1e-4 * module);
        let found = read(&drawn, Face::Front, None, 0.0);
        let found = fit_involute(&found).unwrap();
        let (base, within) = (gear.base_radius(), 1e-9 * module);
        near(teeth, found.base_radius, base, within);
        near(teeth, found.residual, 0.0, 1e-9);
        near(teeth, found.base_thickness, gear.base_thickness(), 1e-9);
        let [standard] = found.standard[..] else {
            panic!("{:?}", found.standard);
        };
        let data = (standard.module, standard.pressure_angle);
        assert_eq!(data, (module, angle.to_radians()));
        near(teeth, standard.shift, gear.generating_shift(), 1e-8);
        // An outline from data has curves in place of chords.
        let exact = OutlineGear::from(&AsBuilt::perfect(gear, Face::Front));
        let exact = fit_involute(&exact).unwrap();
        near(teeth, exact.base_radius, found.base_radius, within);
    }
}

/// Every second corner is moved outwards by 1 µm: some 0.4 µm along the normals at the pressure angle, half to either side of the
/// fit. The module is still within the error bound.
#[test]
fn the_residual_is_what_the_points_are_off() {
    let gear = gear_of(20, 2.0, 20.0, 0.0);
    let drawn = of_gear(&AsBuilt::perfect(gear.clone(), Face::Front), 1e-5);
    let corners: Vec<Point2<f64>> = drawn.iter().map(PathSegment::start).collect();
    let moved = corners.iter().enumerate().map(|(k, corner)| {
        let out = if k.is_multiple_of(2) { 0.0 } else { 1e-3 };
        corner + corner.coords.normalize() * out
    });
    let moved: Vec<Point2<f64>> = moved.collect();
    let found = read(&polygon(&moved), Face::Front, None, 0.0);
    let found = fit_involute(&found).unwrap();
    assert!((1e-4..4e-4).contains(&found.residual), "{found:?}");
    let error = found.base_radius_error;
    near("base", found.base_radius, gear.base_radius(), error);
    assert_eq!(found.standard[0].module, 2.0);
}

/// Arcs of half the involute's radius of curvature, straight flanks, and flanks with too few points are no involutes.
#[test]
fn other_flanks_are_no_involutes() {
    let between = |a: Point2<f64>, b: Point2<f64>, bulge: f64| {
        // A flat arc as the cubic curve with its tangents: height `bulge` of its chord.
        let along = b - a;
        let out = Vector2::new(along.y, -along.x) * bulge;
        let [one, other] = [a + along / 3.0, b - along / 3.0].map(|at| at + out * 4.0 / 3.0);
        PathSegment::Cubic([a, one, other, b])
    };
    for bulge in [0.0, 0.1] {
        let at = |radius, pitches| polar(radius, FRAC_PI_2 + pitches * TAU / 20.0);
        let [a, b, c] = [at(17.5, -0.4), at(22.0, -0.1), at(22.0, 0.1)];
        let [d, next] = [at(17.5, 0.4), at(17.5, 0.6)];
        let tooth = [
            between(a, b, bulge),
            PathSegment::Line([b, c]),
            between(c, d, bulge),
            PathSegment::Line([d, next]),
        ];
        let each = (0..20).flat_map(|k| turned(&tooth, TAU * f64::from(k) / 20.0));
        let path: Vec<PathSegment> = each.collect();
        let ends: Vec<Point2<f64>> = path.iter().map(PathSegment::start).collect();
        for path in [path, polygon(&ends)] {
            let read = read(&path, Face::Front, None, 0.0);
            assert_eq!(fit_involute(&read), None, "{bulge}");
        }
    }
}

const Z: u32 = 12;

/// Corners of straight-sided teeth, tooth 1 up, clockwise; `top(k)` are those of the tip of tooth k + 1: radius, and pitches from its
/// middle.
fn corners(top: impl Fn(u32) -> Vec<[f64; 2]>) -> Vec<Point2<f64>> {
    let tooth = |k: u32| {
        let top = top(k).into_iter();
        let all = [[10.0, -0.3]].into_iter().chain(top).chain([[10.0, 0.3]]);
        all.map(move |[radius, pitches]| {
            polar(
                radius,
                0.25 * TAU - (f64::from(k) + pitches) * TAU / f64::from(Z),
            )
        })
    };
    (0..Z).flat_map(tooth).collect()
}

fn flat(_: u32) -> Vec<[f64; 2]> {
    vec![[13.0, -0.1], [13.0, 0.1]]
}

/// Chords within 1e-6 mm: greatest and least may be off by as much.
fn difference(a: &[Point2<f64>], b: &[Point2<f64>]) -> OutlineDifference {
    let [a, b] = [a, b].map(|corners| read(&polygon(corners), Face::Front, Some(Z), 0.0));
    OutlineDifference::new(&a, &b, 1e-6).unwrap()
}

/// Every side moved out by d: the deviation is d, but at corners, where the nearest place is the corner of the other outline, up to
/// d / cos(half the angle by which it turns there); the other way round the same with the other sign.
#[test]
fn sides_that_are_moved_out() {
    let d = 0.01;
    let inner = corners(flat);
    let count = inner.len();
    let sides: Vec<(Point2<f64>, Vector2<f64>)> = (0..count)
        .map(|k| {
            let along = (inner[(k + 1) % count] - inner[k]).normalize();
            // Clockwise: out of the metal is on the left.
            (inner[k] + d * Vector2::new(-along.y, along.x), along)
        })
        .collect();
    let mut turns = Vec::new();
    let outer: Vec<Point2<f64>> = (0..count)
        .map(|k| {
            let ((a, u), (b, v)) = (sides[(k + count - 1) % count], sides[k]);
            turns.push(u.perp(&v).atan2(u.dot(&v)));
            a + u * ((b - a).perp(&v) / u.perp(&v))
        })
        .collect();
    let most = |sign: f64| {
        let turns = turns.iter().map(|turn| sign * turn);
        d / (0.5 * turns.fold(0.0, f64::max)).cos()
    };
    let out = difference(&inner, &outer);
    near("least", out.least.beyond, d, 1e-12);
    // Counter-clockwise turns of a clockwise path are its roots.
    near("greatest", out.greatest.beyond, most(1.0), 1e-6);
    assert!(out.greatest.point.coords.norm() < 10.1);
    near("mean", out.mean, d, 1e-2 * d);
    assert!(out.mean > d && out.root_mean_square >= out.mean);
    let back = difference(&outer, &inner);
    near("back", back.greatest.beyond, -d, 1e-12);
    near("back", back.least.beyond, -most(-1.0), 1e-6);
    assert!(back.least.point.coords.norm() > 12.9);
    near("rotation", back.rotation, 0.0, 1e-9);
}

/// A tip with a bump that no other has: drawn turned by three teeth and a bit it is found there.
#[test]
fn the_tooth_that_lies_on_tooth_1_is_found() {
    let top = |k: u32| match k {
        4 => vec![[13.0, -0.1], [13.1, 0.02], [13.0, 0.1]],
        _ => flat(k),
    };
    let drawn = corners(top);
    let pitch = TAU / f64::from(Z);
    for (teeth, more) in [(3.0, 0.01), (-5.0, -0.02), (6.0, 0.03)] {
        let by = teeth * pitch + more;
        let turned = drawn.iter().map(|corner| Rotation2::new(by) * corner);
        let found = difference(&drawn, &turned.collect::<Vec<_>>());
        near("rotation", (found.rotation + by).sin(), 0.0, 1e-12);
        near("rotation", (found.rotation + by).cos(), 1.0, 1e-12);
        near("rms", found.root_mean_square, 0.0, 1e-12);
        near("greatest", found.greatest.beyond, 0.0, 1e-12);
        assert_eq!(found.alike, 1);
        // Teeth count clockwise: what was turned counter-clockwise by three has the number 1 − 3.
        let expected = (-teeth as i32).rem_euclid(Z as i32) as u32 + 1;
        assert_eq!(found.tooth, expected, "{teeth}");
    }
}

/// A triangle of height h and width w on the tip of tooth 8: below its top the distance from its sides is h cos(slope), which falls
/// evenly to both ends; mean and mean square are its integrals, w/2 and w/3 times, over the length of the outline.
#[test]
fn a_bump_of_known_size() {
    let half = 13.0 * (0.1 * TAU / f64::from(Z)).sin();
    let tip = 13.0 * (0.1 * TAU / f64::from(Z)).cos();
    let (h, w) = (0.05, 2.0 * half);
    let with_bump = |k: u32| match k {
        7 => vec![[13.0, -0.1], [tip + h, 0.0], [13.0, 0.1]],
        _ => flat(k),
    };
    let plain = corners(flat);
    let found = difference(&plain, &corners(with_bump));
    let most = h * (2.0 * h / w).atan().cos();
    near("greatest", found.greatest.beyond, most, 1e-6);
    near("least", found.least.beyond, 0.0, 1e-12);
    assert_eq!(found.greatest.tooth, 8);
    near("radius", found.greatest.point.coords.norm(), tip, 1e-3);
    let length: f64 = polygon(&plain).iter().map(PathSegment::length).sum();
    let mean = 0.5 * most * w / length;
    near("mean", found.mean, mean, 2e-4 * mean);
    let rms = (most * most * w / 3.0 / length).sqrt();
    near("rms", found.root_mean_square, rms, 1e-3 * rms);
    // Every tooth of the plain one could have it: the least turn is taken.
    assert_eq!((found.alike, found.tooth), (Z, 1));
}

/// Flanks that are arcs of radius 9 mm and of 12 mm between the same corners: in their middle they lie apart by the difference of the two
/// heights above the chord, R − √(R² − (chord/2)²).
#[test]
fn arcs_between_the_same_corners() {
    let ends = corners(flat);
    let chord = (ends[1] - ends[0]).norm();
    let height = |radius: f64| radius - (radius * radius - 0.25 * chord * chord).sqrt();
    let drawn = |radius: f64| {
        let sides = polygon(&ends).into_iter().enumerate();
        let path = sides.map(|(k, side)| {
            let [from, to] = [side.start(), side.end()];
            let along = (to - from).normalize();
            // To the left of the path's direction, which is out of the metal.
            let out = Vector2::new(-along.y, along.x) * height(radius);
            match k % 2 {
                0 => arc([from, from + 0.5 * (to - from) + out, to]),
                _ => side,
            }
        });
        read(&path.collect::<Vec<_>>(), Face::Front, Some(Z), 0.0)
    };
    let [flatter, fuller] = [12.0, 9.0].map(drawn);
    let known = height(9.0) - height(12.0);
    for (a, b, sign) in [(&flatter, &fuller, 1.0), (&fuller, &flatter, -1.0)] {
        let found = OutlineDifference::new(a, b, 1e-6).unwrap();
        let [least, most] = kit::ends([0.0, sign * known]);
        near(sign, found.greatest.beyond, most, found.bound);
        near(sign, found.least.beyond, least, found.bound);
        near(sign, found.rotation, 0.0, 1e-9);
    }
}
