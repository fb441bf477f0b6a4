//! The class of a contact: on the line of action, or the parts that meet off it.
//!
//! The formulas cover only involutes on the line of action. Every other contact has a kind, in order of severity. A tip
//! corner on a flank comes with any deviation near hand-over; a contact on a fillet or a root must not happen at all.

use super::lost_motion::{Contact, LostMotion, Status, Touch};
use crate::gear::{ProfilePart, Side};
use crate::pair::{GearPair, Member};

/// Distance from the form circle of an undercut flank, mm, within which a contact is on its edge. Results use the same
/// width for tip corners.
const EDGE_MM: f64 = 1e-7;

/// The curves that meet, in order of severity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum ContactKind {
    /// Involute on involute, on the line of action.
    Involute,
    /// A tip corner on the mate's involute, off the line of action.
    TipInvolute,
    /// Two tip corners.
    TipTip,
    /// The edge that undercut leaves at the form circle, on anything but a root.
    Edge,
    /// A fillet on an involute or a fillet.
    Fillet,
    /// A tip on its mate's fillet.
    TipFillet,
    /// A root land touches.
    Root,
}

impl ContactKind {
    /// All, in order.
    pub const ALL: [ContactKind; 7] = [
        ContactKind::Involute,
        ContactKind::TipInvolute,
        ContactKind::TipTip,
        ContactKind::Edge,
        ContactKind::Fillet,
        ContactKind::TipFillet,
        ContactKind::Root,
    ];

    /// Its name in results.
    pub fn name(self) -> &'static str {
        match self {
            ContactKind::Involute => "involute-involute",
            ContactKind::TipInvolute => "tip-involute",
            ContactKind::TipTip => "tip-tip",
            ContactKind::Edge => "undercut-edge",
            ContactKind::Fillet => "involute-fillet",
            ContactKind::TipFillet => "tip-fillet",
            ContactKind::Root => "root",
        }
    }

    /// Whether the contact is below an involute, which K (8) excludes.
    pub fn is_non_involute(self) -> bool {
        self >= ContactKind::Edge
    }
}

/// The time in the mesh of its teeth at which a tip corner touches, with the gears turning as in a sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Moment {
    /// Before the teeth reach the line of action.
    Premature,
    /// After they have left it.
    Late,
}

impl Moment {
    /// `premature` or `late`.
    pub fn name(self) -> &'static str {
        match self {
            Moment::Premature => "premature",
            Moment::Late => "late",
        }
    }

    /// The time at which the tip of `member` touches in `side` contact.
    ///
    /// A right flank faces clockwise. If its gear turns counter-clockwise, the mate pushes it, and it comes into mesh
    /// tip first. If it turns clockwise, it pushes, and its tip leaves last. In a sweep the locked gear turns so that
    /// ascending teeth come into mesh, against their direction of ascent.
    pub fn of(assembly: &GearPair, side: Side, member: Member) -> Moment {
        let locked = -assembly.gear(assembly.locked()).face().ascending();
        let sense = if member == assembly.locked() {
            locked
        } else {
            -locked
        };
        if sense * side.sense() < 0.0 {
            Moment::Premature
        } else {
            Moment::Late
        }
    }
}

/// The class of one contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ContactClass {
    /// The kind of the contact.
    pub kind: ContactKind,
    /// The gear whose tip touches, if exactly one does.
    pub tip: Option<Member>,
    /// When that tip touches; only known for a single tip.
    pub moment: Option<Moment>,
}

impl ContactClass {
    /// The class of the `side` contact `contact` of `assembly`.
    pub fn of(assembly: &GearPair, side: Side, contact: &Contact) -> ContactClass {
        let touches = [
            (Member::Wheel, contact.wheel),
            (Member::Pinion, contact.pinion),
        ];
        let any = |curve| touches.iter().any(|(_, touch)| touch.curve == curve);
        let mut tips = touches
            .iter()
            .filter(|(_, touch)| touch.curve == ProfilePart::Tip)
            .map(|(member, _)| *member);
        let (tip, second) = (tips.next(), tips.next());
        let edge = || {
            touches
                .iter()
                .any(|(m, touch)| is_edge(assembly, *m, touch))
        };
        let kind = if any(ProfilePart::Root) {
            ContactKind::Root
        } else if any(ProfilePart::Fillet) {
            match tip {
                Some(_) => ContactKind::TipFillet,
                None => ContactKind::Fillet,
            }
        } else if edge() {
            ContactKind::Edge
        } else {
            match (tip, second) {
                (None, _) => ContactKind::Involute,
                (Some(_), None) => ContactKind::TipInvolute,
                (Some(_), Some(_)) => ContactKind::TipTip,
            }
        };
        let tip = tip.filter(|_| second.is_none());
        ContactClass {
            kind,
            tip,
            moment: tip.map(|member| Moment::of(assembly, side, member)),
        }
    }
}

/// Whether the edge between fillet and involute touches, which only undercut leaves.
fn is_edge(assembly: &GearPair, member: Member, touch: &Touch) -> bool {
    let gear = assembly.gear(member).gear();
    gear.is_undercut()
        && touch.curve == ProfilePart::Involute
        && touch.radius <= gear.form_radius() + EDGE_MM
}

/// The class of a pose: the more severe of its two contacts, or the reason why it has none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum PoseClass {
    /// Out of mesh.
    NoContact,
    /// Both sides touch; this is the more severe contact.
    Contact(ContactKind),
    /// A tip is in a root.
    Jammed,
    /// Not proven; see [`super::Unproven`].
    Unproven,
}

impl PoseClass {
    /// The class of `lost_motion`, found on `assembly`.
    pub fn of(assembly: &GearPair, lost_motion: &LostMotion) -> PoseClass {
        let kind = |side, contact: &Option<Contact>| {
            let contact = contact.as_ref()?;
            Some(ContactClass::of(assembly, side, contact).kind)
        };
        let kinds = (
            kind(Side::Right, &lost_motion.right),
            kind(Side::Left, &lost_motion.left),
        );
        match (lost_motion.status(), kinds) {
            (Status::Jammed, _) => PoseClass::Jammed,
            (_, (Some(right), Some(left))) => PoseClass::Contact(right.max(left)),
            _ => PoseClass::NoContact,
        }
    }

    /// Its name in results: that of the kind, `jammed`, `no-contact` or `unproven`.
    pub fn name(self) -> &'static str {
        match self {
            PoseClass::NoContact => "no-contact",
            PoseClass::Contact(kind) => kind.name(),
            PoseClass::Jammed => "jammed",
            PoseClass::Unproven => "unproven",
        }
    }

    /// Whether a contact is below an involute.
    pub fn is_non_involute(self) -> bool {
        match self {
            PoseClass::NoContact | PoseClass::Unproven => false,
            PoseClass::Contact(kind) => kind.is_non_involute(),
            PoseClass::Jammed => true,
        }
    }
}
