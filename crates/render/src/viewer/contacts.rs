//! The drawn contacts of a pose.

use super::precision::degrees;
use gearlash::contact::{Contact, PoseResult};
use gearlash::gear::Side;

/// The contact on `side`; `None` for a pose without numbers.
pub fn touching(pose: &PoseResult, side: Side) -> Option<Contact> {
    let found = pose.proven()?;
    found.on(side).filter(|_| found.angle().is_some())
}

/// The direction of a contact's normal, degrees.
pub fn normal_degrees(contact: &Contact) -> f64 {
    degrees(contact.normal.y.atan2(contact.normal.x))
}
