//! The contacts on one side as the script reads them.

use super::precision::Precision;
use gearlash::contact::{Contact, ContactClass, PoseResult};
use gearlash::gear::Side;
use gearlash::outline::AssembledPair;
use gearlash_files::numbers::rounded;
use serde::Serialize;

/// Decimals of a normal's direction in degrees: 0.1 µm along the longest line drawn at module 3.
const NORMAL: usize = 3;

/// An entry a pose; null where nothing of it is a number.
#[derive(Default, Serialize)]
pub struct Contacts {
    wheel: Vec<Option<u32>>,
    pinion: Vec<Option<u32>>,
    /// Counts the classes of all runs.
    class: Vec<Option<usize>>,
    x_mm: Vec<Option<f64>>,
    y_mm: Vec<Option<f64>>,
    normal_deg: Vec<Option<f64>>,
}

impl Contacts {
    /// Those of `poses` on `side`. Classes that are not in `classes` yet are added there.
    pub fn of<'p>(
        assembly: &AssembledPair,
        side: Side,
        poses: impl Iterator<Item = &'p PoseResult>,
        precision: Precision,
        classes: &mut Vec<String>,
    ) -> Contacts {
        let mut contacts = Contacts::default();
        for pose in poses {
            contacts.push(assembly, side, touching(pose, side), precision, classes);
        }
        contacts
    }

    fn push(
        &mut self,
        assembly: &AssembledPair,
        side: Side,
        contact: Option<&Contact>,
        precision: Precision,
        classes: &mut Vec<String>,
    ) {
        let class = contact.map(|contact| {
            let class = class(assembly, side, contact);
            let known = classes.iter().position(|known| *known == class);
            known.unwrap_or_else(|| {
                classes.push(class);
                classes.len() - 1
            })
        });
        let place = |value: f64| rounded(value, precision.decimals);
        self.wheel.push(contact.map(|c| c.wheel.tooth));
        self.pinion.push(contact.map(|c| c.pinion.tooth));
        self.class.push(class);
        self.x_mm.push(contact.map(|c| place(c.point.x)));
        self.y_mm.push(contact.map(|c| place(c.point.y)));
        self.normal_deg.push(contact.map(normal_degrees));
    }
}

/// The contact on `side`; none where nothing of the pose is a number.
pub fn touching(pose: &PoseResult, side: Side) -> Option<&Contact> {
    let found = pose.proven()?;
    let contact = match side {
        Side::Right => &found.right,
        Side::Left => &found.left,
    };
    contact.as_ref().filter(|_| found.angle().is_some())
}

/// Direction of a contact's normal, degrees.
pub fn normal_degrees(contact: &Contact) -> f64 {
    rounded(
        contact.normal.y.atan2(contact.normal.x).to_degrees(),
        NORMAL,
    )
}

/// The class of a contact, and whose tip touches when.
pub fn class(assembly: &AssembledPair, side: Side, contact: &Contact) -> String {
    let Some(pair) = assembly.data() else {
        let [wheel, pinion] = [contact.wheel, contact.pinion].map(|touch| touch.curve.name());
        return format!("{wheel} on {pinion}");
    };
    let class = ContactClass::of(pair, side, contact);
    let tip = class.tip.map(|member| format!("{} tip", member.name()));
    let moment = class.moment.map(|moment| moment.name().to_owned());
    let more: Vec<String> = tip.into_iter().chain(moment).collect();
    match more.is_empty() {
        true => class.kind.name().to_owned(),
        false => format!("{} ({})", class.kind.name(), more.join(", ")),
    }
}
