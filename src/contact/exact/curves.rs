//! Sets of pairs of curves, and their names in errors.

use crate::gear::ProfilePart;

/// A set of pairs of curves, the locked gear's first: a bit for each pair.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct CurvePairs(u16);

impl CurvePairs {
    /// Every pair.
    pub const ALL: CurvePairs = CurvePairs(u16::MAX);

    fn one(locked: ProfilePart, free: ProfilePart) -> u16 {
        1 << (4 * locked as u16 + free as u16)
    }

    /// This set without one pair.
    pub fn without(self, locked: ProfilePart, free: ProfilePart) -> CurvePairs {
        CurvePairs(self.0 & !CurvePairs::one(locked, free))
    }

    /// Every pair that contains a curve of this kind, on either gear.
    pub fn of(part: ProfilePart) -> CurvePairs {
        CurvePairs((0xf << (4 * part as u16)) | (0x1111 << part as u16))
    }

    /// This set without `others`.
    pub fn except(self, others: CurvePairs) -> CurvePairs {
        CurvePairs(self.0 & !others.0)
    }

    /// The pairs in both sets.
    pub fn intersection(self, others: CurvePairs) -> CurvePairs {
        CurvePairs(self.0 & others.0)
    }

    pub fn has(self, locked: ProfilePart, free: ProfilePart) -> bool {
        self.0 & CurvePairs::one(locked, free) != 0
    }

    pub fn add(&mut self, locked: ProfilePart, free: ProfilePart) {
        self.0 |= CurvePairs::one(locked, free);
    }

    pub fn add_unless(&mut self, settled: bool, locked: ProfilePart, free: ProfilePart) {
        if !settled {
            self.add(locked, free);
        }
    }

    pub fn is_empty(self) -> bool {
        self == CurvePairs::default()
    }
}

/// Two curves whose search did not end, the locked gear's first.
#[derive(Debug)]
pub(super) struct SearchExhausted(pub ProfilePart, pub ProfilePart);

impl SearchExhausted {
    /// The reason in words, for the error message.
    pub fn reason(&self) -> String {
        let [locked, free] = [self.0, self.1].map(|part| {
            let land = if part.is_land() { " land" } else { "" };
            format!("{}{land}", part.name())
        });
        format!("locked {locked} on free {free}: not settled")
    }
}
