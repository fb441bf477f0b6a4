//! The greatest gap so far, and every pair that ties with it.

use super::branch::Hit;
use super::facing::Facing;
use super::shape::C;

/// Of pairs that tie, contacts whose distances from the pitch point differ by less count as
/// equally near: far above rounding, far below a base pitch.
const EQUALLY_NEAR_MM: f64 = 1e-6;

/// Hits whose gaps lie within a tie of the greatest.
#[derive(Debug, Clone)]
pub(super) struct Ties {
    width: f64,
    pitch_point: C,
    greatest: f64,
    hits: Vec<(i64, Hit)>,
}

impl Ties {
    pub fn new(facing: &Facing) -> Ties {
        Ties {
            width: facing.tie(),
            pitch_point: facing.pitch_point(),
            greatest: f64::NEG_INFINITY,
            hits: Vec::new(),
        }
    }

    /// Tie tolerance, rad.
    pub fn width(&self) -> f64 {
        self.width
    }

    pub fn greatest(&self) -> f64 {
        self.greatest
    }

    /// The least gap that still matters.
    pub fn level(&self) -> f64 {
        self.greatest - self.width
    }

    /// Whether a hit of this gap matters.
    pub fn admits(&self, gap: f64) -> bool {
        gap >= self.level()
    }

    /// Takes the hit of a step.
    pub fn offer(&mut self, step: i64, hit: Hit) {
        self.greatest = self.greatest.max(hit.gap);
        self.hits.push((step, hit));
    }

    /// Of the hits that tie with the greatest, the one to name: nearest to the operating pitch point,
    /// of equally near ones the first counter-clockwise of the locked gear as [`super::facing`] sees it.
    pub fn choose(mut self) -> Option<Touching> {
        let level = self.level();
        self.hits.retain(|(_, hit)| hit.gap >= level);
        // One pair may have been offered by more than one of its curves: its greatest counts.
        self.hits
            .sort_by(|(a, one), (b, other)| a.cmp(b).then(other.gap.total_cmp(&one.gap)));
        self.hits.dedup_by_key(|(step, _)| *step);
        let mut chosen: Option<(f64, Touching)> = None;
        for &(step, hit) in &self.hits {
            let away = (hit.point - self.pitch_point).norm_sqr().sqrt();
            if chosen.is_none_or(|(least, _)| away < least - EQUALLY_NEAR_MM) {
                let touching = Touching {
                    step,
                    hit,
                    greatest: self.greatest,
                };
                chosen = Some((away, touching));
            }
        }
        chosen.map(|(_, touching)| touching)
    }
}

/// The pair that touches, and the greatest gap of all pairs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touching {
    pub step: i64,
    pub hit: Hit,
    pub greatest: f64,
}
