//! What the measurements of one gear say of each other; for tables and reports.

/// What was found of one gear beyond the gear itself.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct GearNotes {
    /// Where the pitch was measured about the datum axis.
    pub eccentricity: Option<EccentricityNote>,
    /// Where the thickness is stated by readings all round.
    pub all_round: Option<AllRoundNote>,
    /// Where a second thickness statement stands beside the one that counts.
    pub thickness: Option<ThicknessStatements>,
}

/// An eccentricity: amount and direction.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Eccentricity {
    /// `e`, µm.
    pub um: f64,
    /// The tooth (fractional) it points to.
    pub high_tooth: f64,
}

/// The eccentricity that datum-axis pitch contains, beside the one that is stated.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct EccentricityNote {
    /// By the pitch of both flanks; a first harmonic of the gear's own pitch cannot be told from it.
    pub in_pitch: Eccentricity,
    /// By `[runout]`, where that is given.
    pub stated: Option<Eccentricity>,
    /// Which of the two is the gear's: the stated one, or that of the pitch.
    pub stated_counts: bool,
    /// The distance between the two displacements, µm, where both are given.
    pub difference_um: Option<f64>,
}

/// What readings all round determine.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct AllRoundNote {
    /// How many there are.
    pub readings: usize,
    /// The growth of a reading's error into a tooth's own thickness: at worst this, at random its root;
    /// `None` where only the mean thickness is taken.
    pub amplification: Option<u32>,
}

/// Two statements about the thickness of one gear, as base thickness.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ThicknessStatements {
    /// `s_b` least and greatest, mm, of the statement that counts.
    pub counts: [f64; 2],
    /// The same of the cross-check.
    pub cross: [f64; 2],
    /// Cross-check minus the statement that counts, middle of each, µm.
    pub difference_um: f64,
    /// How far the two ranges lie apart, µm; 0 where they share a value.
    pub gap_um: f64,
    /// How far they may lie apart and still agree, µm.
    pub tolerance_um: f64,
}

impl ThicknessStatements {
    /// Compares two ranges of `s_b`, mm, least value first.
    pub fn new(counts: [f64; 2], cross: [f64; 2], tolerance_um: f64) -> ThicknessStatements {
        let middle = |range: [f64; 2]| (range[0] + range[1]) / 2.0;
        let gap = (cross[0] - counts[1]).max(counts[0] - cross[1]);
        ThicknessStatements {
            counts,
            cross,
            difference_um: 1000.0 * (middle(cross) - middle(counts)),
            gap_um: 1000.0 * gap.max(0.0),
            tolerance_um,
        }
    }

    /// Whether one tooth can be meant by both.
    pub fn agree(&self) -> bool {
        self.gap_um <= self.tolerance_um
    }
}
