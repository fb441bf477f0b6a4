//! The greatest gap so far, and every pair that ties with it.

use super::candidate::CandidateContact;
use super::flank_problem::FlankProblem;
use super::shape::C;

/// Difference in distance from the pitch point, mm, below which tied contacts count as equally near. It is far above
/// rounding and far below a base pitch.
const EQUALLY_NEAR_MM: f64 = 1e-6;

/// Candidates kept without an allocation: a contact ratio of four.
const FEW: usize = 4;

/// Candidates whose gaps lie within a tie of the greatest.
#[derive(Debug, Clone)]
pub(super) struct TightestContacts {
    width: f64,
    pitch_point: C,
    greatest: f64,
    few: [Option<(i64, CandidateContact)>; FEW],
    count: usize,
    more: Vec<(i64, CandidateContact)>,
}

impl TightestContacts {
    pub fn new(problem: &FlankProblem) -> TightestContacts {
        TightestContacts {
            width: problem.tie,
            pitch_point: problem.pitch_point,
            greatest: f64::NEG_INFINITY,
            few: [None; FEW],
            count: 0,
            more: Vec::new(),
        }
    }

    /// Tie tolerance, rad.
    pub fn width(&self) -> f64 {
        self.width
    }

    pub fn greatest(&self) -> f64 {
        self.greatest
    }

    /// The least gap that ties with the greatest so far.
    pub fn least_tied_gap(&self) -> f64 {
        self.greatest - self.width
    }

    /// Whether a candidate with this gap counts.
    pub fn admits(&self, gap: f64) -> bool {
        gap >= self.least_tied_gap()
    }

    /// Adds the candidate of a step.
    pub fn offer(&mut self, step: i64, candidate: CandidateContact) {
        if candidate.gap > self.greatest + self.width {
            self.count = 0;
            self.more.clear();
        }
        self.greatest = self.greatest.max(candidate.gap);
        if self.count < FEW {
            self.few[self.count] = Some((step, candidate));
            self.count += 1;
        } else {
            self.more.push((step, candidate));
        }
    }

    fn candidates(&self) -> impl Iterator<Item = &(i64, CandidateContact)> {
        let least_tied_gap = self.least_tied_gap();
        let few = self.few[..self.count].iter().flatten();
        few.chain(&self.more)
            .filter(move |(_, candidate)| candidate.gap >= least_tied_gap)
    }

    /// The reported contact of those that tie with the greatest gap. It is nearest to the operating pitch point; of equally near ones,
    /// first counter-clockwise on the locked gear as in [`super::flank_problem`]. A pair counts with its greatest candidate.
    pub fn choose(&self) -> Option<FirstContact> {
        let away =
            |candidate: &CandidateContact| (candidate.point - self.pitch_point).norm_sqr().sqrt();
        let mut chosen: Option<&(i64, CandidateContact)> = None;
        for one in self.candidates() {
            let better = match chosen {
                None => true,
                Some(other) if other.0 == one.0 => one.1.gap > other.1.gap,
                Some(other) => {
                    let gain = away(&other.1) - away(&one.1);
                    gain > EQUALLY_NEAR_MM || (gain >= -EQUALLY_NEAR_MM && one.0 < other.0)
                }
            };
            if better {
                chosen = Some(one);
            }
        }
        chosen.map(|&(step, candidate)| FirstContact {
            step,
            candidate,
            greatest: self.greatest,
        })
    }
}

/// The pair that touches, and the greatest gap of all pairs.
#[derive(Debug, Clone, Copy)]
pub(super) struct FirstContact {
    pub step: i64,
    pub candidate: CandidateContact,
    pub greatest: f64,
}
