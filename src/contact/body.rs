//! Teeth in the solid body of the mate: a pose that no rotation of the free gear can free.
//!
//! Below its root circle a gear is solid, and its axis is a shaft. Either of two conditions suffices for an overlap, without any contact:
//!
//! 1. A tip land of the locked gear is nearer to the free axis than `r_f − e`, with the free gear's eccentricity `e`. There
//!    is metal at every rotation.
//! 2. Seen from the centre of the free outline, on one circle of that outline, the locked gear's root circle is wider than
//!    the free gear's widest space. A free tooth is in it at every rotation.
//!
//! Root circles that overlap jam the pair as well, even where a space faces a space ([`beside_root_circles`]).
//!
//! A tip circle can also reach over the mate's axis, with three or four long teeth and a very small root circle. Then
//! no pose of the pair can be assembled ([`reaches_over_an_axis`]).
//!
//! For condition 2, the circle of radius `ρ` about a centre `d` away is inside the disc of radius `r_f` over `2 acos((d² + ρ² − r_f²)/(2 d
//! ρ))`. This is greatest at `ρ² = d² − r_f²`. Between form and tip circle a tooth is at least as wide, in angle, as its tip land.
//!
//! Without these conditions a pose can still be jammed; its contacts show that ([`super::LostMotion::status`]).

use super::lost_motion::{LostMotion, Status, contact_lost};
use crate::error::Error;
use crate::gear::{AsBuilt, Placed, Side};
use crate::pair::{GearPair, Member, Pose};
use std::f64::consts::PI;

/// Whether teeth of one gear reach the centre of the mate's outline, where its shaft is. Then all poses are jammed: a
/// turning gear would meet teeth from all sides, and no pair of them would be first.
pub(super) fn reaches_over_an_axis(assembly: &GearPair) -> bool {
    Member::BOTH.into_iter().any(|member| {
        let (gear, mate) = (assembly.gear(member), assembly.gear(member.mate()));
        gear.reach() + mate.eccentricity() >= assembly.center_distance()
    })
}

/// Where a free half tooth can touch the far flank of the locked tooth that it faces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FarFlanks {
    /// Nowhere.
    Clear,
    /// Only beside the tip, on locked teeth that point sideways.
    BesideTips,
    /// Anywhere.
    Open,
}

impl FarFlanks {
    /// The far flanks of `assembly` that may be met. A free gear's far flank is never met first, because a force on it turns the gear the other way.
    ///
    /// The normal at a contact then passes the free axis on its far side. So the locked far involute has a point whose normal passes through
    /// the axis: `√(B² − r_bL²) − r_bL ξ` away from it, if `B` is the distance of the outlines' centres. The free gear must reach that far.
    ///
    /// Two flanks touch only in gears of three or four teeth. Both base circles then lie on one side of the normal, which is their outer
    /// tangent. The lengths of the flanks along it, `T = r_b ξ`, have the sum `√(B² − (r_bL − r_bF)²)`. A flank is longest at its tip.
    pub fn of(assembly: &GearPair) -> FarFlanks {
        let [locked, free] =
            [assembly.locked(), assembly.free()].map(|member| assembly.gear(member));
        let off = locked.eccentricity() + free.eccentricity() + assembly.shift_bound();
        let nearest = assembly.center_distance() - off;
        let [bases, tips] = [
            [locked, free].map(|gear| gear.gear().base_radius()),
            [locked, free].map(|gear| gear.gear().base_radius() * gear.gear().tip_roll()),
        ];
        let between = bases[0] - bases[1];
        if (tips[0] + tips[1]).powi(2) >= nearest * nearest - between * between {
            FarFlanks::Open
        } else if (tips[0] + free.reach()).powi(2) >= nearest * nearest - bases[0] * bases[0] {
            FarFlanks::BesideTips
        } else {
            FarFlanks::Clear
        }
    }
}

/// Whether [`is_solid`] can be true or root circles can overlap at some pose, which is rare.
pub(super) fn may_be_solid(assembly: &GearPair) -> bool {
    let locked = assembly.gear(assembly.locked());
    let free = assembly.gear(assembly.free());
    let nearest = assembly.center_distance() - locked.eccentricity();
    // The free gear reaches further than its root circle.
    nearest - locked.gear().tip_radius() < solid_radius(free)
        || nearest - locked.gear().root_radius() < free.reach()
}

/// The result `found` at `pose`, or a jam where root circles overlap.
///
/// Facing half teeth do not show this overlap between two spaces: the half of one space faces the other half of the other one.
///
/// # Errors
/// [`Error::ContactLost`] if the runout of the free gear alone makes them overlap, and nothing else jams the pose.
pub(super) fn beside_root_circles(
    assembly: &GearPair,
    pose: &Pose,
    found: LostMotion,
) -> Result<LostMotion, Error> {
    let [locked, free] = [assembly.locked(), assembly.free()].map(|member| assembly.gear(member));
    let centre = placed_locked(assembly, pose).centre();
    let distance = (assembly.axis(assembly.free()) - centre).norm();
    let room = distance - locked.gear().root_radius() - free.gear().root_radius();
    if room >= free.eccentricity() || found.status() == Status::Jammed {
        return Ok(found);
    }
    if room < -free.eccentricity() {
        return Ok(LostMotion::JAMMED);
    }
    let (mating, free) = (pose.mating(), assembly.free());
    let teeth = [free.mate(), free].map(|member| mating.tooth(member));
    let reason = "root circles overlap at some rotations of the free gear";
    Err(contact_lost(free, teeth, mating.flank, pose, reason))
}

/// The locked gear at `pose`.
fn placed_locked<'a>(assembly: &'a GearPair, pose: &Pose) -> Placed<'a> {
    let locked = assembly.locked();
    let tooth_1 = assembly.mate_direction(locked) + pose.locked_rotation();
    Placed::new(assembly.gear(locked), assembly.axis(locked), tooth_1)
}

/// Radius about its axis within which a gear is solid at every rotation, mm.
pub(super) fn solid_radius(gear: &AsBuilt) -> f64 {
    gear.gear().root_radius() - gear.eccentricity()
}

/// Whether teeth of one gear are in the body of the other at every rotation of the free gear.
pub(super) fn is_solid(assembly: &GearPair, pose: &Pose) -> bool {
    let locked = assembly.gear(assembly.locked());
    let free = assembly.gear(assembly.free());
    let (tip, root) = (locked.gear().tip_radius(), locked.gear().root_radius());
    let solid = solid_radius(free);
    let placed = placed_locked(assembly, pose);
    let axis = assembly.axis(assembly.free());
    let distance = (axis - placed.centre()).norm();
    let off = free.eccentricity();
    if distance - tip < solid {
        let teeth = placed.teeth_near(axis, solid.max(0.0));
        if teeth
            .iter()
            .any(|&tooth| land_distance(&placed, tooth, axis) < solid)
        {
            return true;
        }
    }
    let spans = [distance - off, distance + off].map(|distance| widest_arc(distance, root, free));
    spans[0].min(spans[1]) > widest_space(free)
}

/// Least distance of a tooth's tip land from `point`, mm.
fn land_distance(placed: &Placed, tooth: u32, point: nalgebra::Point2<f64>) -> f64 {
    let gear = placed.as_built();
    let tip = gear.gear().tip_radius();
    let half = gear.gear().tip_half_angle();
    let to_point = point - placed.centre();
    let beside = to_point.y.atan2(to_point.x) - placed.direction(tooth);
    let beside = beside - 2.0 * PI * (beside / (2.0 * PI)).round();
    let ends = [
        gear.flank_offset(Side::Right, tooth) - half,
        gear.flank_offset(Side::Left, tooth) + half,
    ];
    let off = beside - beside.clamp(ends[0].min(ends[1]), ends[1]);
    let d = to_point.norm();
    (d * d + tip * tip - 2.0 * d * tip * off.cos()).sqrt()
}

/// Angle of the widest arc about the centre of the free outline, between its form and tip circle, inside the locked
/// root circle of radius `root` at `distance`.
fn widest_arc(distance: f64, root: f64, free: &AsBuilt) -> f64 {
    let gear = free.gear();
    if !(distance > root) {
        return 0.0;
    }
    let widest = ((distance - root) * (distance + root)).sqrt();
    let radius = widest.clamp(gear.form_radius(), gear.tip_radius());
    let cos = (distance * distance + radius * radius - root * root) / (2.0 * distance * radius);
    2.0 * cos.clamp(-1.0, 1.0).acos()
}

/// Greatest angle between two neighbouring tip lands.
fn widest_space(gear: &AsBuilt) -> f64 {
    let half = gear.gear().tip_half_angle();
    let nominal = gear.gear().basic_data().angular_pitch() - 2.0 * half;
    let teeth = gear.gear().basic_data().teeth();
    let wider = (1..=teeth).map(|tooth| {
        let next = gear.counter_clockwise(tooth, 1);
        gear.flank_offset(Side::Right, next) - gear.flank_offset(Side::Left, tooth)
    });
    nominal + wider.fold(f64::NEG_INFINITY, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{CutPair, ExactKernel};
    use crate::gear::{BasicGearData, BasicRack, Deviations, Face, GearDesign};
    use crate::pair::Mating;
    use nalgebra::{Point2, Vector2};

    /// Module 3, 20 teeth, each tooth with a different thickness.
    fn gear(face: Face, tip_diameter: Option<f64>, eccentricity: f64) -> AsBuilt {
        let wave = |tooth: i32| 0.2 * (1.3 * f64::from(tooth)).sin();
        let deviations = Deviations {
            per_tooth: (1..=20).map(wave).collect(),
            ..Deviations::off_axis(eccentricity, 3.4)
        };
        let design = GearDesign {
            tip_diameter,
            ..GearDesign::plain(20, 3.0)
        };
        design.built(face, &deviations)
    }

    fn towards(angle: f64) -> Vector2<f64> {
        Vector2::new(angle.cos(), angle.sin())
    }

    /// Possible positions of the free outline's centre.
    fn free_centres(assembly: &GearPair) -> impl Iterator<Item = Point2<f64>> + Clone {
        let (axis, off) = (
            assembly.axis(assembly.free()),
            assembly.gear(assembly.free()).eccentricity(),
        );
        (0..120).map(move |k| axis + off * towards(f64::from(k) * PI / 60.0))
    }

    /// Depth of the deepest point of a locked land inside the free root circle, for any turn of that circle. Negative
    /// if that point is outside. Source: dense points of all lands, without special cases.
    fn land_in_root(assembly: &GearPair, placed: &Placed) -> f64 {
        let locked = placed.as_built();
        let tip = locked.gear().tip_radius();
        let half = locked.gear().half_angle_at_roll(locked.gear().tip_roll());
        let root = assembly.gear(assembly.free()).gear().root_radius();
        let centres = free_centres(assembly);
        let depth = |point: Point2<f64>| {
            let deepest = centres.clone().map(|centre| root - (point - centre).norm());
            deepest.fold(f64::INFINITY, f64::min)
        };
        let points = (1..=20).flat_map(|tooth| {
            let from = locked.flank_offset(Side::Right, tooth) - half;
            let to = locked.flank_offset(Side::Left, tooth) + half;
            (0..=60).map(move |k| (tooth, from + (to - from) * f64::from(k) / 60.0))
        });
        points
            .map(|(tooth, angle)| {
                depth(placed.centre() + tip * towards(placed.direction(tooth) + angle))
            })
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// Excess angle of the locked root circle over the widest space, on circles between the free form and tip circle, for any turn of the
    /// free gear. Source: a walk along the circles from the direction of the locked centre until outside the root circle.
    fn space_filled(assembly: &GearPair, placed: &Placed) -> f64 {
        let (root, free) = (
            placed.as_built().gear().root_radius(),
            assembly.gear(assembly.free()),
        );
        let wide = |centre: Point2<f64>, radius: f64| {
            let to = placed.centre() - centre;
            let inside = |beside: f64| {
                let point = centre + radius * towards(to.y.atan2(to.x) + beside);
                (point - placed.centre()).norm() < root
            };
            let (mut low, mut high) = (0.0, PI);
            if !inside(low) {
                return 0.0;
            }
            for _ in 0..40 {
                let middle = 0.5 * (low + high);
                *(if inside(middle) { &mut low } else { &mut high }) = middle;
            }
            2.0 * low
        };
        let (form, tip) = (free.gear().form_radius(), free.gear().tip_radius());
        let widest = |centre: Point2<f64>| {
            let radii = (0..=40).map(|k| form + (tip - form) * f64::from(k) / 40.0);
            radii.map(|radius| wide(centre, radius)).fold(0.0, f64::max)
        };
        let seen = free_centres(assembly)
            .map(widest)
            .fold(f64::INFINITY, f64::min);
        let half = free.gear().half_angle_at_roll(free.gear().tip_roll());
        let space = (1..=20)
            .map(|tooth| {
                let next = free.counter_clockwise(tooth, 1);
                let turn = free.tooth_angle(f64::from(next)) - free.tooth_angle(f64::from(tooth));
                let ends = free.flank_offset(Side::Right, next)
                    - free.flank_offset(Side::Left, tooth)
                    - 2.0 * half;
                turn - 2.0 * PI * (turn / (2.0 * PI)).floor() + ends
            })
            .fold(0.0, f64::max);
        seen - space
    }

    /// Teeth are in the mate's body exactly if some of their points are at every rotation, and both methods find such a
    /// pose jammed. Source: points of the lands and of the root circle; cases within ±1e-3 mm or rad are omitted.
    #[test]
    fn teeth_are_in_the_body_if_their_points_are() {
        let mut met = [0; 3];
        for (tips, off, distances) in [
            ([None; 2], [0.0, 0.0], [58.5, 58.9, 59.15, 59.3]),
            ([None; 2], [0.3, 0.5], [58.3, 58.6, 58.9, 59.2]),
            // The pinion's long teeth fill a space whose bottom the wheel's short teeth do not reach.
            (
                [Some(61.0), Some(67.5)],
                [0.4, 0.2],
                [58.4, 58.8, 59.2, 59.6],
            ),
            (
                [Some(61.0), Some(66.0)],
                [0.0, 0.6],
                [57.8, 58.3, 58.8, 59.3],
            ),
        ] {
            let wheel = gear(Face::Front, tips[0], off[0]);
            let pinion = gear(Face::Back, tips[1], off[1]);
            let cut = CutPair::for_certificates(&wheel, &pinion);
            for (a, locked, k) in distances
                .into_iter()
                .flat_map(|a| Member::BOTH.map(|locked| (a, locked)))
                .flat_map(|(a, locked)| (0..10).map(move |k| (a, locked, k)))
            {
                let gears = (wheel.clone(), pinion.clone());
                let assembly = GearPair::with_locked(gears.0, gears.1, a, locked).unwrap();
                let mating = Mating {
                    fraction: f64::from(k) / 10.0,
                    ..Mating::at(1 + 3 * k % 20, 1 + 7 * k % 20, Side::Right)
                };
                let pose = Pose::new(&assembly, mating);
                let placed = placed_locked(&assembly, &pose);
                let land = land_in_root(&assembly, &placed);
                let space = space_filled(&assembly, &placed);
                if land.abs().min(space.abs()) < 1e-3 {
                    continue;
                }
                let solid = land > 0.0 || space > 0.0;
                let what = format!("{a} {locked:?} {k}: {land} mm, {space} rad");
                let found = may_be_solid(&assembly) && is_solid(&assembly, &pose);
                assert_eq!(found, solid, "{what}");
                met[0] += usize::from(land > 0.0 && space < 0.0);
                met[1] += usize::from(land < 0.0 && space > 0.0);
                met[2] += usize::from(!solid);
                if solid {
                    let exact = ExactKernel::new(&assembly).lost_motion(&pose).unwrap();
                    let polygon = cut.kernel(&assembly).lost_motion(&pose).unwrap();
                    let found = [exact, polygon].map(|found| found.status());
                    assert_eq!(found, [Status::Jammed; 2], "{what}");
                }
            }
        }
        assert!(met.iter().all(|count| *count >= 30), "{met:?}");
    }

    /// Outlines that are off their axes by `e_1` and `e_2` have the least distance `a − e_1 − e_2`. A tip circle of
    /// that radius just reaches the mate's centre.
    #[test]
    fn an_axis_is_reached_over_by_both_eccentricities() {
        let built = |(teeth, tip_diameter), face, eccentricity| {
            let design = GearDesign {
                basic_data: BasicGearData::new(teeth, 1.0, 22f64.to_radians()).unwrap(),
                rack: BasicRack::new(0.8, 1.0, 0.0).unwrap(),
                tip_diameter: Some(tip_diameter),
                ..GearDesign::plain(teeth, 1.0)
            };
            design.built(face, &Deviations::off_axis(eccentricity, 1.0))
        };
        let (long, short) = ((14, 16.0), (3, 3.3));
        for (wheel, pinion) in [(long, short), (short, long)] {
            for [first, second] in [[0.0, 0.0], [0.3, 0.0], [0.0, 0.3], [0.2, 0.3]] {
                for beyond in [-1e-9, 1e-9] {
                    let gears = [
                        built(wheel, Face::Front, first),
                        built(pinion, Face::Back, second),
                    ];
                    let [wheel, pinion] = gears;
                    let pair = GearPair::new(wheel, pinion, 8.0 + first + second + beyond);
                    let reached = reaches_over_an_axis(&pair.unwrap());
                    assert_eq!(reached, beyond < 0.0, "{first} {second} {beyond}");
                }
            }
        }
    }
}
