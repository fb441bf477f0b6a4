//! Sides of a tooth and of a gear, with their signs.

/// A side of a tooth in the picture, seen from the front. See [`Flank`] for the gear's own sides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Side {
    /// Front-right: the right-hand flank of a tooth that points up, its clockwise side.
    Right,
    /// Front-left: the counter-clockwise side.
    Left,
}

impl Side {
    /// Both sides, right first.
    pub const BOTH: [Side; 2] = [Side::Right, Side::Left];

    /// Direction from the tooth's centre to this flank: −1 clockwise (right), +1 counter-clockwise.
    pub fn sense(self) -> f64 {
        match self {
            Side::Right => -1.0,
            Side::Left => 1.0,
        }
    }

    /// Index in a list of both sides, right first.
    pub(crate) fn index(self) -> usize {
        self as usize
    }

    /// The other side.
    pub fn other(self) -> Side {
        match self {
            Side::Right => Side::Left,
            Side::Left => Side::Right,
        }
    }

    /// `right` or `left`.
    pub const fn name(self) -> &'static str {
        match self {
            Side::Right => "right",
            Side::Left => "left",
        }
    }
}

/// A flank of a gear, seen on its reference face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Flank {
    /// The right-hand flank of a tooth that points up.
    Right,
    /// The left-hand flank.
    Left,
}

impl Flank {
    /// Both flanks, right first.
    pub const BOTH: [Flank; 2] = [Flank::Right, Flank::Left];

    /// Index in a list of both flanks, right first.
    pub fn index(self) -> usize {
        self as usize
    }

    /// Direction from the tooth's centre, seen on the reference face: −1 clockwise (right), +1 counter-clockwise.
    pub fn sense(self) -> f64 {
        Face::Front.seen_from_front(self).sense()
    }

    /// `right` or `left`.
    pub fn name(self) -> &'static str {
        match self {
            Flank::Right => "right",
            Flank::Left => "left",
        }
    }
}

/// Orientation of a gear's reference face.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schemars", derive(schemars::JsonSchema), schemars(inline))]
pub enum Face {
    // The viewer sees it.
    /// Its numbers run clockwise in the picture.
    #[default]
    Front,
    // The viewer sees the other face: own right flanks are on the left.
    /// Its numbers run counter-clockwise in the picture.
    Back,
}

impl Face {
    /// `front` or `back`.
    pub fn name(self) -> &'static str {
        match self {
            Face::Front => "front",
            Face::Back => "back",
        }
    }

    /// Direction of ascending tooth numbers, seen from the front: −1 clockwise, +1 counter-clockwise.
    pub fn ascending(self) -> f64 {
        match self {
            Face::Front => -1.0,
            Face::Back => 1.0,
        }
    }

    /// Heights of both ends of teeth, mm over the measuring plane away from this reference face; its own end is first. The teeth run
    /// `from` … `to`, mm from that plane away from the viewer.
    pub fn heights(self, [from, to]: [f64; 2]) -> [f64; 2] {
        match self {
            Face::Front => [from, to],
            Face::Back => [-to, -from],
        }
    }

    /// Number of the tooth `steps` places counter-clockwise of `tooth` on a gear with this number of `teeth`.
    pub fn counter_clockwise(self, teeth: u32, tooth: u32, steps: i64) -> u32 {
        let ascending = match self {
            Face::Front => -steps,
            Face::Back => steps,
        };
        let index = (i64::from(tooth) - 1 + ascending).rem_euclid(i64::from(teeth));
        u32::try_from(index).unwrap_or(0) + 1
    }

    /// The side of the gear's own `flank` in the picture.
    pub fn seen_from_front(self, flank: Flank) -> Side {
        match (self, flank) {
            (Face::Front, Flank::Right) | (Face::Back, Flank::Left) => Side::Right,
            (Face::Front, Flank::Left) | (Face::Back, Flank::Right) => Side::Left,
        }
    }

    /// The gear's own flank on a side of the picture.
    pub fn flank_of(self, side: Side) -> Flank {
        match (self, side) {
            (Face::Front, Side::Right) | (Face::Back, Side::Left) => Flank::Right,
            (Face::Front, Side::Left) | (Face::Back, Side::Right) => Flank::Left,
        }
    }
}
