//! A pair with adjustable centre distance.

use super::class::PoseClass;
use super::exact::ExactKernel;
use super::lost_motion::{LostMotion, Status};
use crate::error::Error;
use crate::pair::{GearPair, Mating, Member, Pose};
use crate::parallel;

/// Width of the bracket of a centre distance, mm: a tenth of the tolerance of a met limit. The rounding of `j_bn` is a
/// few 1e-13 mm, so the sign at its ends is certain.
pub(crate) const BRACKET_WIDTH: f64 = 1e-10;

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

    /// The centre distance, mm, at which the pose of `mating` has no play. The result is a bracket at most 1e-10 mm
    /// wide with negative play at its first end and none at its second. `guess`, mm, is the start of the search.
    ///
    /// The mating defines a pose at every distance ([`crate::pair::Pose`]). `None` without a root between touching base
    /// circles and tips that pass each other.
    ///
    /// # Errors
    /// A lost contact.
    pub fn play_free_distance(
        &self,
        guess: f64,
        mating: &Mating,
    ) -> Result<Option<[f64; 2]>, Error> {
        root_of_play(&self.assembly, guess, |distance| {
            self.at(distance)?.play(mating)
        })
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

/// Bracket, at most [`BRACKET_WIDTH`] wide, of the sign change of `play`, which rises with the centre distance.
///
/// `play` has the slope `2 sin α_wt` while involutes touch. The first steps use that; then the bracket shrinks by
/// secants, or by halving if they do not halve it.
pub(crate) fn root_of_play(
    assembly: &GearPair,
    guess: f64,
    play: impl Fn(f64) -> Result<f64, Error>,
) -> Result<Option<[f64; 2]>, Error> {
    let [nearest, farthest] = reach(assembly);
    let start = guess.clamp(nearest, farthest);
    let slope = 2.0 * assembly.at(start)?.operating_pressure_angle().sin();
    let module = assembly.gear(assembly.free()).gear().basic_data().module();
    let value = play(start)?;
    // (distance, play) with play below zero, and not below zero.
    let (mut low, mut high) = ((nearest, f64::NAN), (farthest, f64::NAN));
    let mut known = (start, value);
    let mut stride = if value.is_finite() {
        value.abs() / slope + 0.4 * BRACKET_WIDTH
    } else {
        0.1 * module
    };
    while low.1.is_nan() || high.1.is_nan() {
        let towards = if known.1 < 0.0 {
            low = known;
            known.0 + stride
        } else {
            high = known;
            known.0 - stride
        };
        if !low.1.is_nan() && !high.1.is_nan() {
            break;
        }
        if !(nearest..=farthest).contains(&towards) {
            return Ok(None);
        }
        known = (towards, play(towards)?);
        stride *= 2.0;
    }
    let mut halve = false;
    while high.0 - low.0 > BRACKET_WIDTH {
        let width = high.0 - low.0;
        let secant = low.0 - low.1 * width / (high.1 - low.1);
        // Past the root by a part of the requested width, on the far side of the nearer end: that closes the bracket.
        let nudge = if secant - low.0 < 0.5 * width {
            0.4 * BRACKET_WIDTH
        } else {
            -0.4 * BRACKET_WIDTH
        };
        let inside = |x: f64| x > low.0 && x < high.0;
        let middle = 0.5 * (low.0 + high.0);
        let next = if halve || !secant.is_finite() || !inside(secant + nudge) {
            middle
        } else {
            secant + nudge
        };
        if !inside(next) {
            break;
        }
        let value = play(next)?;
        if value < 0.0 {
            low = (next, value);
        } else {
            high = (next, value);
        }
        halve = high.0 - low.0 > 0.5 * width;
    }
    Ok(Some([low.0, high.0]))
}
