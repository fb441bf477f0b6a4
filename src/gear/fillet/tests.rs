use super::*;

/// Source: the greatest polar angle of 20 000 points of each fillet.
#[test]
fn the_neck_is_where_the_fillets_are_nearest() {
    let mut crossing = 0;
    for teeth in [3, 4, 5, 7, 12, 17, 40] {
        for x_e in [-0.6, -0.3, 0.0, 0.4, 0.9] {
            for (dedendum, round) in [(1.25, 0.38), (1.0, 0.0), (1.5, 0.25), (0.9, 0.1)] {
                let basic_data = BasicGearData::new(teeth, 2.0, 20f64.to_radians()).unwrap();
                let rack = BasicRack::new(1.0, dedendum, round).unwrap();
                let Ok(fillet) = Fillet::new(&basic_data, &rack, x_e) else {
                    continue;
                };
                // No gear: the root would lie beyond the centre.
                if fillet.radius <= fillet.depth + fillet.tip_round {
                    continue;
                }
                let angles = (0..=20_000).map(|k| {
                    let point = fillet.point(fillet.end * f64::from(k) / 2e4);
                    point.y.atan2(point.x)
                });
                let greatest = angles.fold(f64::NEG_INFINITY, f64::max);
                let neck = fillet.neck();
                assert!(
                    neck >= greatest - 1e-15 && neck <= greatest + 1e-6,
                    "z {teeth}, x {x_e}: {neck} for {greatest}"
                );
                crossing += u32::from(neck >= 0.0);
            }
        }
    }
    assert!(crossing > 0);
}

/// A trochoid that turns back towards the centre has a cusp, and is refused. Source: the distances of 5000 of its points.
#[test]
fn a_fillet_that_turns_back_is_refused() {
    let alpha = 5f64.to_radians();
    let basic_data = BasicGearData::new(3, 2.0, alpha).unwrap();
    let mut refused = 0;
    for round in [0.3, 0.5, 0.6, 0.7] {
        let rack = BasicRack::new(0.1, 0.8, round).unwrap();
        for k in 0..40 {
            let x_e = 0.8 - round - 0.05 + 0.005 * f64::from(k);
            let trochoid = Fillet {
                radius: basic_data.reference_radius(),
                depth: (0.8 - round - x_e) * 2.0,
                tip_round: 2.0 * round,
                lean: 0.0,
                root_angle: 0.0,
                end: FRAC_PI_2 - alpha,
                form_roll: 0.0,
            };
            let distances = (0..=5000).map(|k| {
                let gamma = trochoid.end * f64::from(k) / 5e3;
                trochoid.point(gamma).coords.norm()
            });
            let distances: Vec<f64> = distances.collect();
            let turns_back = distances.windows(2).any(|pair| pair[1] < pair[0] - 1e-12);
            let found = Fillet::new(&basic_data, &rack, x_e);
            let is_cusp = matches!(found, Err(GearError::FilletCusp { .. }));
            assert_eq!(is_cusp, turns_back, "ρ {round}, x {x_e}");
            refused += u32::from(is_cusp);
        }
    }
    assert!(refused > 5, "{refused}");
}
