//! A pose: the keys of the interface, units in their names.

use crate::column::{Array, Column, Format, Row, Value, Values, columns, row_type, shown};
use gearlash::analysis::compare::ComparedPose;
use gearlash::analysis::tally::RunTally;
use gearlash::contact::{
    Contact, ContactClass, FacePlace, LostMotion, PoseClass, PoseResult, Status, Unproven,
};
use gearlash::gear::Side;
use gearlash::outline::AssembledPair;
use gearlash::pair::{Backlash, Mating, Member, Pose, arcmin};
use gearlash_text::numbers::um_ascii;
use serde_json::json;
use std::f64::consts::{PI, TAU};

/// A pose of a run.
#[derive(Debug)]
pub struct PoseRow {
    center_distance: f64,
    material: &'static str,
    /// Wheel and pinion tooth of the assembly phase, where phases are run separately.
    phase: Option<(u32, u32)>,
    locked: Member,
    pose: ComparedPose,
    /// Lost motion, rad; `None` for a jammed, unmeshed or unproven pose, which has no numbers.
    angle: Option<f64>,
    /// Lost motion at the wheel and at the pinion, arcmin.
    arcmin: [Option<f64>; 2],
    /// The backlash in units that need a module or a base circle; `None` for a drawn pair.
    backlash: Option<Backlash>,
    class: Option<PoseClass>,
    right: Option<ContactRow>,
    left: Option<ContactRow>,
}

impl PoseRow {
    /// The row of `pose` in `run`.
    pub fn of_run(run: &RunTally, pose: &ComparedPose) -> PoseRow {
        PoseRow {
            material: run.material.name(),
            phase: run.phase,
            ..PoseRow::new(&run.assembly, pose)
        }
    }

    /// The row of a `pose` of `assembly`, without a run.
    pub fn new(assembly: &AssembledPair, pose: &ComparedPose) -> PoseRow {
        let result = &pose.simulated;
        let (data, found) = (assembly.data(), result.proven());
        let contact = |side, contact: fn(&LostMotion) -> Option<&Contact>| {
            let found = found.filter(|found| found.angle().is_some())?;
            Some(ContactRow::new(
                assembly,
                side,
                &result.pose,
                contact(found)?,
            ))
        };
        PoseRow {
            class: data.map(|pair| result.class(pair)),
            right: contact(Side::Right, |found| found.right.as_ref()),
            left: contact(Side::Left, |found| found.left.as_ref()),
            ..PoseRow::without_contacts(assembly, pose.clone())
        }
    }

    /// The row of a `pose` of `assembly` without contacts and classes: computing them takes as long as the pose itself.
    fn without_contacts(assembly: &AssembledPair, pose: ComparedPose) -> PoseRow {
        let result = &pose.simulated;
        let j_wt = result.backlash;
        PoseRow {
            center_distance: assembly.center_distance(),
            material: "",
            phase: None,
            locked: assembly.locked(),
            angle: result.proven().and_then(LostMotion::angle),
            arcmin: Member::BOTH.map(|at| Some(arcmin(assembly.angle(at, j_wt?)))),
            backlash: j_wt.and_then(|j_wt| assembly.backlash(j_wt)),
            class: None,
            right: None,
            left: None,
            pose,
        }
    }

    /// Its centre distance, mm.
    pub fn center_distance(&self) -> f64 {
        self.center_distance
    }

    fn result(&self) -> &PoseResult {
        &self.pose.simulated
    }

    fn mating(&self) -> &Mating {
        self.result().pose.mating()
    }

    fn rotation(&self, member: Member) -> Value {
        let locked = self.locked == member;
        Value::optional(locked.then(|| self.result().pose.locked_rotation()))
    }

    /// Rotation of the free gear at right-flank contact.
    fn right_rad(&self) -> Option<f64> {
        Some(principal(self.right.as_ref()?.contact.rotation))
    }

    /// Rotation of the free gear at right-flank contact, not wrapped; its nominal rotation without contact.
    fn free_rotation(&self) -> f64 {
        let nominal = self.result().pose.free_rotation();
        let right = self.right.as_ref();
        right.map_or(nominal, |right| right.contact.rotation)
    }

    fn unproven(&self) -> Option<&Unproven> {
        self.result().found.as_ref().err()
    }

    /// The reason why the backlash at one end of the bearing clearance is not proven.
    fn unproven_end(&self, end: usize) -> Option<&Unproven> {
        let ends = self.result().with_clearance.as_ref()?;
        ends[end].as_ref().err()
    }

    /// `11,10 +0.5`: the mating and the fraction of a pitch beyond it.
    fn mating_words(&self) -> String {
        let mating = self.mating();
        let beyond = match mating.fraction {
            0.0 => String::new(),
            fraction => format!(" +{fraction}"),
        };
        format!("{},{}{beyond}", mating.wheel_tooth, mating.pinion_tooth)
    }
}

row_type!(PoseRow = columns());

row_type!(row: Mating {
    "wheel_tooth" Plain => row.wheel_tooth;
    "pinion_tooth" Plain => row.pinion_tooth;
    "flank" Plain => Value::word(row.flank.name());
    "fraction" Plain => row.fraction;
});

fn columns() -> Vec<Column<PoseRow>> {
    let mut columns = columns!(row: PoseRow {
        "" Distance [csv("center_distance_mm"), rank(0), heading(shown("a mm"))] => row.center_distance;
        "" Plain [csv("material"), rank(0), heading(shown("material"))] => Value::word(row.material);
        "" Plain [csv("phase_wheel_tooth"), rank(0)] => row.phase.map(|phase| phase.0);
        "" Plain [csv("phase_pinion_tooth"), rank(0)] => row.phase.map(|phase| phase.1);
        "wheel_rotation_rad" Plain => row.rotation(Member::Wheel);
        "pinion_rotation_rad" Plain => row.rotation(Member::Pinion);
        "mating.wheel_tooth" Plain [csv("wheel_tooth"), rank(0), array("wheel_tooth", Values::COUNTS)] => row.mating().wheel_tooth;
        "mating.pinion_tooth" Plain [csv("pinion_tooth"), rank(0), array("pinion_tooth", Values::COUNTS)] => row.mating().pinion_tooth;
        "" Plain [heading(shown("mating"))] => row.mating_words();
        "mating.flank" Plain [csv("flank"), rank(0), heading(shown("flank")), array("flank", Values::words(Side::BOTH.map(Side::name))), page("flank")] => Value::word(row.mating().flank.name());
        "mating.fraction" Plain [csv("fraction"), rank(0), array("fraction", Values::NUMBERS)] => row.mating().fraction;
        "" Angle [page("locked_rad")] => row.result().pose.locked_rotation();
        "" Angle [page("free_rad")] => row.free_rotation();
        "right_rad" Plain => row.right_rad();
        "left_rad" Plain => row.right_rad().zip(row.angle).map(|(right, angle)| right + angle);
        "lost_motion_rad" Angle [page("lost_motion_rad")] => row.angle;
        "j_wt_um" Backlash [heading(shown("j_wt")), array("j_wt_um", Values::NUMBERS), page("j_wt_um")] => Value::um(row.result().backlash);
        "j_t_um" Plain [array("j_t_um", Values::NUMBERS)] => Value::um(row.backlash.map(|of| of.j_t));
        "j_bn_um" Plain [array("j_bn_um", Values::NUMBERS)] => Value::um(row.backlash.map(|of| of.j_bn));
        "j_r_um" Plain [rank(3)] => Value::um(row.backlash.and_then(|of| of.j_r));
        "lost_motion_arcmin.wheel" Plain [csv("lost_motion_wheel_arcmin"), rank(3), array("wheel_arcmin", Values::NUMBERS)] => row.arcmin[0];
        "lost_motion_arcmin.pinion" Plain [csv("lost_motion_pinion_arcmin"), rank(3), array("pinion_arcmin", Values::NUMBERS)] => row.arcmin[1];
        "j_wt_range_um.0" Plain [csv("j_wt_range_min_um")] => Value::um(row.result().range()[0]);
        "j_wt_range_um.1" Plain [csv("j_wt_range_max_um")] => Value::um(row.result().range()[1]);
        "error_bound_um" Bound [heading(shown("± bound").spare(6)), array("error_bound_um", Values::NUMBERS)] => Value::um(row.angle.and(row.result().error_bound));
        "status" Severity [heading(shown("status")), array("status", Values::words(Status::ALL.map(Status::name)))] => Value::word(row.result().status().name());
    });
    let unproven = Unproven::columns();
    columns.extend(unproven.within("unproven", |row: &PoseRow| row.unproven()));
    let low = unproven.within("unproven_range.0", |row: &PoseRow| row.unproven_end(0));
    let high = unproven.within("unproven_range.1", |row: &PoseRow| row.unproven_end(1));
    columns.extend(low.chain(high).map(Column::no_csv));
    columns.extend(columns!(row: PoseRow {
        "" Plain [csv("unproven_range_min_reason"), rank(2)] => row.unproven_end(0).map(|end| end.reason.clone());
        "" Plain [csv("unproven_range_max_reason"), rank(2)] => row.unproven_end(1).map(|end| end.reason.clone());
        "class" Plain => Value::word(row.class.map(PoseClass::name));
        "right" Plain [no_csv] => row.right.as_ref().map_or(Value::NULL, |_| Value::Absent);
        "" Plain [heading(shown("right contact").spare(3))] => row.right.as_ref().map(ContactRow::words);
    }));
    columns.extend(ContactRow::columns().within("right", |row: &PoseRow| row.right.as_ref()));
    columns.extend(columns!(row: PoseRow {
        "left" Plain [no_csv] => row.left.as_ref().map_or(Value::NULL, |_| Value::Absent);
        "" Plain [heading(shown("left contact").spare(2))] => row.left.as_ref().map(ContactRow::words);
    }));
    columns.extend(ContactRow::columns().within("left", |row: &PoseRow| row.left.as_ref()));
    columns.extend(columns!(row: PoseRow {
        "proof" Plain [no_csv] => Value::optional(row.result().proof.as_deref().map(|proof| json!(proof)));
        "analytic.michalec_um" BacklashAgain [csv("michalec_um"), heading(shown("Michalec").spare(5))] => Value::um(row.pose.michalec);
        "analytic.involute_um" BacklashAgain [csv("involute_um"), heading(shown("involute").spare(4))] => Value::um(row.pose.involute);
        "analytic.line_of_action_um" BacklashAgain [csv("line_of_action_um"), heading(shown("line of action").spare(1))] => Value::um(row.pose.line_of_action);
    }));
    columns
}

/// The numpy arrays of `poses` of `assembly`.
pub fn pose_arrays(
    assembly: &AssembledPair,
    poses: impl IntoIterator<Item = PoseResult>,
) -> Vec<Array> {
    let poses = poses.into_iter().map(ComparedPose::from);
    let rows = poses.map(|pose| PoseRow::without_contacts(assembly, pose));
    PoseRow::columns().arrays(&rows.collect::<Vec<_>>())
}

/// The columns of `poses` of `assembly` in the data of a page: names, formats and values.
pub fn pose_page<'p>(
    assembly: &AssembledPair,
    poses: impl IntoIterator<Item = &'p ComparedPose>,
) -> Vec<(&'static str, Format, Vec<Value>)> {
    let rows = poses.into_iter().map(|pose| PoseRow::new(assembly, pose));
    PoseRow::columns().page(&rows.collect::<Vec<_>>())
}

/// The contact of a pose on one side.
#[derive(Debug)]
pub struct ContactRow {
    contact: Contact,
    /// `None` for a drawn pair.
    class: Option<ContactClass>,
    varies_along_face: bool,
    /// `None` for a pair that does not deviate along the face.
    at: Option<FacePlace>,
}

impl ContactRow {
    /// The row of the `contact` on `side` of `assembly` at `pose`.
    pub fn new(assembly: &AssembledPair, side: Side, pose: &Pose, contact: &Contact) -> ContactRow {
        let pair = assembly.data();
        ContactRow {
            at: pair.and_then(|pair| FacePlace::of(pair, pose, contact)),
            contact: *contact,
            class: pair.map(|pair| ContactClass::of(pair, side, contact)),
            varies_along_face: assembly.varies_along_face(),
        }
    }

    /// The class of the contact, with the touching tip, the moment and the place along the face where they are known.
    pub fn class_words(&self) -> String {
        let class = self.class_alone();
        (self.at).map_or(class.clone(), |at| format!("{class}, {}", at.words()))
    }

    fn class_alone(&self) -> String {
        let Some(class) = self.class else {
            return self.places();
        };
        let tip = class.tip.map(|member| format!("{} tip", member.name()));
        let moment = class.moment.map(|moment| moment.name().to_owned());
        let more: Vec<String> = tip.into_iter().chain(moment).collect();
        if more.is_empty() {
            class.kind.name().to_owned()
        } else {
            format!("{} ({})", class.kind.name(), more.join(", "))
        }
    }

    /// `tip on flank`, the wheel's place first.
    fn places(&self) -> String {
        let Contact { wheel, pinion, .. } = &self.contact;
        format!("{} on {}", wheel.curve.name(), pinion.curve.name())
    }

    /// The places of a contact without a class, which checks do not name.
    pub(crate) fn unchecked_places(&self) -> Option<String> {
        self.class.is_none().then(|| self.places())
    }

    /// `11,10 involute-tip`.
    fn words(&self) -> String {
        let Contact { wheel, pinion, .. } = &self.contact;
        let curves = format!("{}-{}", wheel.curve.name(), pinion.curve.name());
        let words = format!("{},{} {curves}", wheel.tooth, pinion.tooth);
        (self.at).map_or(words.clone(), |at| format!("{words} {}", at.words()))
    }
}

row_type!(row: ContactRow {
    "wheel_tooth" Plain [page("wheel_tooth")] => row.contact.wheel.tooth;
    "pinion_tooth" Plain [page("pinion_tooth")] => row.contact.pinion.tooth;
    "wheel_curve" Plain => Value::word(row.contact.wheel.curve.name());
    "pinion_curve" Plain => Value::word(row.contact.pinion.curve.name());
    "wheel_radius_mm" Plain [no_csv] => row.contact.wheel.radius;
    "pinion_radius_mm" Plain [no_csv] => row.contact.pinion.radius;
    "point_mm.0" Place [no_csv, page("x_mm")] => row.contact.point.x;
    "point_mm.1" Place [no_csv, page("y_mm")] => row.contact.point.y;
    "section_mm" Plain [optional_in_csv] => row.contact.section;
    "" Plain [page("section_mm")] => Value::optional(row.varies_along_face.then_some(row.contact.section));
    "at" Plain [optional_in_csv] => Value::optional(row.at.map(FacePlace::name).map(Value::Word));
    "normal.0" Plain [no_csv] => row.contact.normal.x;
    "normal.1" Plain [no_csv] => row.contact.normal.y;
    "" Angle [page("normal_rad")] => row.contact.normal.y.atan2(row.contact.normal.x);
    "class" Plain [no_csv] => Value::word(row.class.map(|class| class.kind.name()));
    "tip_gear" Plain [no_csv] => Value::optional(row.class.and_then(|class| class.tip).map(|member| Value::Word(member.name())));
    "tip_moment" Plain [no_csv] => Value::optional(row.class.and_then(|class| class.moment).map(|moment| Value::Word(moment.name())));
});

row_type!(row: Unproven {
    "reason" Plain [rank(2)] => row.reason.clone();
    "exact_j_wt_um" Plain [rank(2)] => Value::um(row.exact);
    "polygon_j_wt_um" Plain [rank(2)] => Value::um(row.polygon);
});

/// The equivalent rotation in (−π, π].
fn principal(rotation: f64) -> f64 {
    let turned = rotation - TAU * (rotation / TAU).round();
    if turned <= -PI { turned + TAU } else { turned }
}

/// The reason why a value is not proven, and the unverified values.
fn unproven_words(unproven: &Unproven) -> String {
    let value = |name: &str, value: Option<f64>| {
        let um = um_ascii(value?, 3);
        Some(format!("{name} method, not proven: {um} µm"))
    };
    let values = [
        value("exact", unproven.exact),
        value("polygon", unproven.polygon),
    ];
    let parts = [Some(unproven.reason.clone())].into_iter().chain(values);
    parts.flatten().collect::<Vec<_>>().join("; ")
}

/// All reasons for unproven values of `pose`, in words.
pub fn pose_doubts(pose: &ComparedPose) -> String {
    let result = &pose.simulated;
    let here = result.found.as_ref().err().map(unproven_words);
    let ends = result.with_clearance.iter().flatten();
    let ends = ends.zip(["a − c", "a + c"]).filter_map(|(end, name)| {
        let doubt = unproven_words(end.as_ref().err()?);
        Some(format!("at {name} of the bearing clearance: {doubt}"))
    });
    here.into_iter().chain(ends).collect::<Vec<_>>().join("; ")
}
