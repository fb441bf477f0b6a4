//! A pair with adjustable centre distance.

use super::class::PoseClass;
use super::exact::ExactKernel;
use super::lost_motion::{LostMotion, Status};
use crate::error::Error;
use crate::pair::{GearPair, Mating, Member, Pose};
use crate::parallel;

/// The pair at one centre distance.
pub struct PairAtDistance {
    assembly: GearPair,
    kernel: ExactKernel,
}

impl PairAtDistance {
    /// The pair as assembled.
    pub fn new(assembly: &GearPair) -> PairAtDistance {
        PairAtDistance {
            kernel: ExactKernel::new(assembly),
            assembly: assembly.clone(),
        }
    }

    /// The pair of these gears at `distance`, mm, in a time independent of the number of teeth.
    ///
    /// # Errors
    /// Base circles that overlap.
    pub fn at(&self, distance: f64) -> Result<PairAtDistance, Error> {
        let assembly = self.assembly.at(distance)?;
        Ok(PairAtDistance {
            kernel: self.kernel.at(&assembly),
            assembly,
        })
    }

    /// The pair at its centre distance.
    pub fn assembly(&self) -> &GearPair {
        &self.assembly
    }

    /// Right- and left-flank contact of `mating`.
    ///
    /// # Errors
    /// A lost contact.
    pub fn lost_motion(&self, mating: &Mating) -> Result<LostMotion, Error> {
        self.kernel.lost_motion(&Pose::new(&self.assembly, *mating))
    }

    pub(crate) fn class(&self, mating: &Mating) -> Result<PoseClass, Error> {
        Ok(PoseClass::of(&self.assembly, &self.lost_motion(mating)?))
    }

    /// Normal backlash `j_bn = φ_j r_b`, mm; −∞ when jammed, +∞ out of mesh.
    pub(crate) fn play(&self, mating: &Mating) -> Result<f64, Error> {
        let found = self.lost_motion(mating)?;
        let base = self
            .assembly
            .gear(self.assembly.free())
            .gear()
            .base_radius();
        Ok(match (found.status(), found.angle()) {
            (_, Some(angle)) => angle * base,
            (Status::Jammed, None) => f64::NEG_INFINITY,
            (_, None) => f64::INFINITY,
        })
    }

    /// [`PairAtDistance::play`] of each mating, in order.
    pub(crate) fn plays(&self, matings: &[Mating]) -> Result<Vec<f64>, Error> {
        let plays = parallel::map(matings, |mating| self.play(mating));
        plays.into_iter().collect()
    }
}

/// Centre distances between which two gears can touch, mm: from touching base circles (plus a millionth) to tips that
/// do not reach each other.
pub(crate) fn reach(assembly: &GearPair) -> [f64; 2] {
    let members = Member::BOTH;
    let base: f64 = members
        .map(|m| assembly.gear(m).gear().base_radius())
        .iter()
        .sum();
    let tips: f64 = members.map(|m| assembly.gear(m).reach()).iter().sum();
    [base * (1.0 + 1e-6), tips]
}
