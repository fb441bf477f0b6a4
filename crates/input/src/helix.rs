//! Helix angle, hand and face of a gear.

use super::spec::GearSpec;
use gearlash::gear::{AsBuilt, BasicGearData, Hand, thickness};
use gearlash_text::Table;
use gearlash_text::numbers::distinct_digits;
use std::fmt::Display;

/// The helix of a gear's teeth, and their length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Helix {
    /// `β`, degrees as written; 0 of a spur gear.
    pub angle_deg: f64,
    /// `None` where it is not stated; a spur gear can state one.
    pub hand: Option<Hand>,
    /// Its ends, mm from its measuring plane; `None` where none is stated.
    pub face_mm: Option<[f64; 2]>,
}

impl Helix {
    /// Reads the keys of the gear's table.
    pub fn read(table: &Table) -> Option<Helix> {
        let angle_deg = table.read("helix_angle_deg");
        let hand = table.read::<Hand>("hand");
        let width = table.read::<f64>("face_width_mm");
        let ends = table.read::<[f64; 2]>("face_mm");
        let (angle_deg, hand) = (angle_deg?.unwrap_or(0.0), hand?);
        if let Some([from, to]) = ends?
            && from >= to
        {
            return table.refuse(
                "face_mm",
                format!("{:?}, allowed is [from, to] with from below to", [from, to]),
                "give both ends of the teeth, mm along the axis from the measuring plane, growing away from the viewer",
            );
        }
        let face_mm = ends?.or(width?.map(|width| [-0.5 * width, 0.5 * width]));
        if angle_deg > 0.0 {
            if hand.is_none() {
                table.add(
                    "hand",
                    "missing, expected \"left\" or \"right\" beside a helix angle above 0",
                    "say which way the teeth wind: right as on a right-hand screw, whichever face is seen",
                );
            }
            if face_mm.is_none() {
                table.add(
                    "face_width_mm",
                    missing_face(", beside a helix angle above 0"),
                    "give the length of the teeth along the axis: helical teeth touch over all of it",
                );
            }
            if hand.is_none() || face_mm.is_none() {
                return None;
            }
        }
        Some(Helix {
            angle_deg,
            hand,
            face_mm,
        })
    }

    /// Whether the teeth wind about the axis.
    pub fn is_helical(&self) -> bool {
        self.angle_deg != 0.0
    }

    /// The hand of helical teeth; `None` for a spur gear.
    pub fn teeth_hand(&self) -> Option<Hand> {
        self.hand.filter(|_| self.is_helical())
    }

    /// `data` with this helix.
    pub fn apply_to(&self, data: BasicGearData, table: &Table) -> Option<BasicGearData> {
        let wound = data.with_helix(
            self.angle_deg.to_radians(),
            self.hand.unwrap_or(Hand::Right),
        );
        let help = "correct the helix angle, degrees at the reference circle";
        table.keep("helix_angle_deg", wound, help)
    }

    /// Puts it into the echo of a gear; a spur gear keeps its statements.
    pub fn echo(&self, spec: &mut GearSpec) {
        spec.helix_angle_deg = self.is_helical().then_some(self.angle_deg);
        spec.hand = self.hand;
        spec.face_mm = self.face_mm;
        if self.is_helical() {
            let statements = spec.thickness.statements_mut();
            for pins in statements.filter_map(|statement| statement.over_pins.as_mut()) {
                pins.kind.get_or_insert_default();
            }
        }
    }
}

/// The reason for a face that is not stated; `why` it is needed follows.
pub fn missing_face(why: impl Display) -> String {
    format!(
        "missing, expected the face width, or face_mm = [from, to] from the measuring plane{why}"
    )
}

/// A warning where the face of a helical gear is too short for its span: `b ≥ W_k sin β_b + b_M cos β_b` with the
/// contact width `b_M = 1.2 + 0.018 W_k` mm that shops leave.
pub fn short_for_span(
    face_mm: Option<[f64; 2]>,
    name: &str,
    gear: &AsBuilt,
    k: Option<u32>,
) -> Option<String> {
    let (gear, k) = (gear.gear(), k?);
    let [from, to] = face_mm.filter(|_| gear.basic_data().hand().is_some())?;
    let span = thickness::span_from_base(gear.basic_data(), k, gear.base_thickness());
    let (sin, cos) = gear.basic_data().base_helix_angle().sin_cos();
    let needed = span * sin + (1.2 + 0.018 * span) * cos;
    (to - from < needed).then(|| {
        let [needed, given] = distinct_digits([needed, to - from], 2);
        format!(
            "{name}.face_mm: a span over {k} teeth needs a face of {needed} mm, this one has {given} mm: both anvils may not rest on it"
        )
    })
}
