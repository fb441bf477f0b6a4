//! Cost of the deviations along the face over the mesh cycle.
//!
//! The loss by one kind of deviation is the least `j_wt` of the cycle without it, all others kept, minus the least with all. Losses need not
//! add up: two deviations that bind at one end of the face share the greater one.

use crate::pair::FaceDeviation;

/// Losses of the least `j_wt`, mm. `None` where a bracket does not hold or a pair is jammed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FaceLoss {
    /// Loss by each kind, in the order of [`FaceDeviation::ALL`]; 0 for a kind that the pair does not have.
    each: [Option<f64>; 3],
    /// The least without all of them.
    pub least_without: Option<f64>,
    /// Loss by all together.
    pub all: Option<f64>,
}

impl FaceLoss {
    /// The losses of a pair whose least is `least`, from the least without some kinds of deviation.
    pub(super) fn new<E>(
        has: impl Fn(FaceDeviation) -> bool,
        least: Option<f64>,
        without: impl Fn(&[FaceDeviation]) -> Result<Option<f64>, E>,
    ) -> Result<FaceLoss, E> {
        let own = FaceDeviation::ALL.into_iter().filter(|kind| has(*kind));
        let own: Vec<FaceDeviation> = own.collect();
        let least_without = without(&own)?;
        let loss = |without: Option<f64>| Some(without? - least?);
        let mut each = [Some(0.0); 3];
        for (kind, loss_by) in FaceDeviation::ALL.into_iter().zip(&mut each) {
            if own == [kind] {
                *loss_by = loss(least_without);
            } else if own.contains(&kind) {
                *loss_by = loss(without(&[kind])?);
            }
        }
        Ok(FaceLoss {
            each,
            all: loss(least_without),
            least_without,
        })
    }

    /// Loss by one kind.
    pub fn by(&self, kind: FaceDeviation) -> Option<f64> {
        self.each[kind as usize]
    }
}
