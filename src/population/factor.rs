//! The quantities that scatter independently, and the random numbers of each.

use crate::pair::Member;

/// A quantity that scatters independently.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Factor {
    /// Thickness of a gear.
    Thickness(Member),
    /// Thickness of both gears, if correlated.
    Thicknesses,
    /// Runout of a gear, with its direction.
    Runout(Member),
    /// Pitch of a gear, both flanks of all teeth.
    Pitch(Member),
    /// Thickness of each tooth of a gear.
    PerTooth(Member),
    /// Lead of a gear: slope and crowning of right and of left flanks.
    Lead(Member),
    /// Wobble of a gear, with its direction.
    Wobble(Member),
    /// Choice of a whole gear.
    Gear(Member),
    /// Centre distance.
    CenterDistance,
    /// Deviations of the axes from parallel, in and out of their plane.
    Misalignment,
    /// Clearance of the bearings.
    BearingClearance,
    /// Assembly phase.
    Phase,
}

impl Factor {
    /// All quantities.
    pub const ALL: [Factor; 19] = [
        Factor::Thicknesses,
        Factor::Thickness(Member::Wheel),
        Factor::Runout(Member::Wheel),
        Factor::Pitch(Member::Wheel),
        Factor::PerTooth(Member::Wheel),
        Factor::Lead(Member::Wheel),
        Factor::Wobble(Member::Wheel),
        Factor::Gear(Member::Wheel),
        Factor::Thickness(Member::Pinion),
        Factor::Runout(Member::Pinion),
        Factor::Pitch(Member::Pinion),
        Factor::PerTooth(Member::Pinion),
        Factor::Lead(Member::Pinion),
        Factor::Wobble(Member::Pinion),
        Factor::Gear(Member::Pinion),
        Factor::CenterDistance,
        Factor::Misalignment,
        Factor::BearingClearance,
        Factor::Phase,
    ];

    /// The number of its random stream. It must never change: a seed would give another population.
    pub(super) fn stream_number(self) -> u32 {
        let of = |first, member| first + 8 * u32::from(member == Member::Pinion);
        match self {
            Factor::Thickness(member) => of(0, member),
            Factor::Runout(member) => of(1, member),
            Factor::Pitch(member) => of(2, member),
            Factor::PerTooth(member) => of(3, member),
            Factor::Gear(member) => of(4, member),
            Factor::Lead(member) => of(5, member),
            Factor::Wobble(member) => of(6, member),
            Factor::CenterDistance => 16,
            Factor::BearingClearance => 17,
            Factor::Phase => 18,
            Factor::Thicknesses => 19,
            Factor::Misalignment => 20,
        }
    }

    /// In words, such as `thickness of the wheel`.
    pub fn name(self) -> &'static str {
        let of = |member, names: [&'static str; 2]| names[usize::from(member == Member::Pinion)];
        match self {
            Factor::Thickness(m) => of(m, ["thickness of the wheel", "thickness of the pinion"]),
            Factor::Runout(m) => of(m, ["runout of the wheel", "runout of the pinion"]),
            Factor::Pitch(m) => of(m, ["pitch of the wheel", "pitch of the pinion"]),
            Factor::PerTooth(m) => of(
                m,
                [
                    "thickness of the wheel's single teeth",
                    "thickness of the pinion's single teeth",
                ],
            ),
            Factor::Lead(m) => of(m, ["lead of the wheel", "lead of the pinion"]),
            Factor::Wobble(m) => of(m, ["wobble of the wheel", "wobble of the pinion"]),
            Factor::Gear(m) => of(m, ["which wheel", "which pinion"]),
            Factor::Thicknesses => "thickness of both gears",
            Factor::CenterDistance => "centre distance",
            Factor::Misalignment => "misalignment of the axes",
            Factor::BearingClearance => "play of the bearings",
            Factor::Phase => "assembly phase",
        }
    }
}
