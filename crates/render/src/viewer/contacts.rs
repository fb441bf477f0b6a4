//! The drawn contacts of a pose.

use gearlash::contact::{Contact, PoseResult};
use gearlash::gear::Side;

/// The contact on `side`; `None` for a pose without numbers.
pub fn touching(pose: &PoseResult, side: Side) -> Option<Contact> {
    let found = pose.proven()?;
    found.on(side).filter(|_| found.angle().is_some())
}
