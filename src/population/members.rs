//! A population, and one of its assemblies.

use super::assembly::Assembly;
use super::factor::Factor;
use super::scatter::{Scatter, normal_share, standard_normal};
use super::scatters::{GearScatter, LeadScatter, PopulationError, Scatters, not_negative};
use super::stream::{Draw, SampleKind, Stream};
use crate::error::Error;
use crate::gear::{AsBuilt, Lead, Pitch};
use crate::outline::{AssembledPair, GearChange};
use crate::pair::{Member, ToothNumbers};

/// A pair and its scatters.
#[derive(Debug, Clone, PartialEq)]
pub struct Population {
    pair: AssembledPair,
    scatters: Scatters,
    /// Clearance of both bearings if none scatters, mm.
    pub(super) clearance: f64,
    /// The pinion tooth that meets wheel tooth 1 if the phase does not scatter.
    pub(super) phase: u32,
    factors: Vec<Factor>,
}

impl Population {
    /// The population of pairs equal to `pair` except for `scatters`.
    ///
    /// # Errors
    /// [`PopulationError`].
    pub fn new(
        pair: impl Into<AssembledPair>,
        scatters: Scatters,
    ) -> Result<Population, PopulationError> {
        let mut population = Population {
            pair: pair.into(),
            scatters,
            clearance: 0.0,
            phase: 1,
            factors: Vec::new(),
        };
        let Population { pair, scatters, .. } = &population;
        for member in Member::BOTH {
            scatters.of(member).check(pair.as_built(member))?;
        }
        let nonnegative = |what, scatter: &Option<Scatter>| match scatter {
            Some(scatter) => not_negative(what, scatter),
            None => Ok(()),
        };
        nonnegative("the play of the bearings", &scatters.bearing_clearance)?;
        let correlation = scatters.thickness_correlation;
        if !(-1.0..=1.0).contains(&correlation) {
            return Err(PopulationError::Correlation(correlation));
        }
        let first = Draw {
            seed: 0,
            sample: SampleKind::Population,
            number: 1,
        };
        if !pair.allows(&population.changes(&|factor| first.stream(factor.stream_number()))) {
            return Err(PopulationError::Drawn);
        }
        let [near, far] = pair.face();
        if scatters.vary_along_face() && near == far {
            return Err(PopulationError::NoFace);
        }
        let thicknesses = [&scatters.wheel.thickness, &scatters.pinion.thickness];
        if correlation != 0.0 && thicknesses.iter().any(|thickness| thickness.is_none()) {
            return Err(PopulationError::NothingToCorrelate);
        }
        population.factors = scatters.factors(pair);
        if population.factors.is_empty() {
            return Err(PopulationError::Nothing);
        }
        Ok(population)
    }

    /// This population with a radial clearance of both bearings together, mm, if none scatters.
    #[must_use]
    pub fn with_bearing_clearance(self, clearance: f64) -> Population {
        Population { clearance, ..self }
    }

    /// This population with wheel tooth 1 on pinion tooth `phase` at their right flanks, if the phase does not scatter.
    #[must_use]
    pub fn with_phase(self, phase: u32) -> Population {
        Population { phase, ..self }
    }

    /// The pair without scatter.
    pub fn pair(&self) -> &AssembledPair {
        &self.pair
    }

    /// The scatters.
    pub fn scatters(&self) -> &Scatters {
        &self.scatters
    }

    /// The quantities that scatter independently, in a fixed order.
    pub fn factors(&self) -> &[Factor] {
        &self.factors
    }

    /// The assembly of `draw`.
    ///
    /// # Errors
    /// Values of an impossible gear or pair.
    pub fn assembly(&self, draw: Draw) -> Result<Assembly, Error> {
        self.assembled(&|_| draw)
    }

    /// The assembly whose quantities have separate draws.
    pub(super) fn assembled(&self, of: &dyn Fn(Factor) -> Draw) -> Result<Assembly, Error> {
        let stream = |factor: Factor| of(factor).stream(factor.stream_number());
        let one = |scatter: &Option<Scatter>, factor: Factor| {
            let scatter = scatter.as_ref()?;
            Some(scatter.at(stream(factor).uniform()))
        };
        let farther = one(&self.scatters.center_distance, Factor::CenterDistance).unwrap_or(0.0);
        let distance = self.pair.center_distance() + farther;
        let play = one(&self.scatters.bearing_clearance, Factor::BearingClearance);
        let phases = f64::from(self.pair.phase_count());
        let phase = if self.scatters.phase {
            (stream(Factor::Phase).uniform() * phases) as u32 + 1
        } else {
            self.phase
        };
        let pair = self.pair.varied(distance, &self.changes(&stream))?;
        let lean = self.scatters.lean.each_ref().map(Option::as_ref);
        Ok(Assembly {
            pair: if lean == [None, None] {
                pair
            } else {
                pair.leaning_further(each_at(lean, &mut stream(Factor::Misalignment)))?
            },
            clearance: play.unwrap_or(self.clearance),
            phase,
        })
    }

    /// The changes of both gears from those of the pair.
    fn changes(&self, stream: &dyn Fn(Factor) -> Stream) -> [GearChange; 2] {
        let shares = self.thickness_shares(stream);
        Member::BOTH.map(|member| {
            let share = shares[member as usize];
            let scatter = self.scatters.of(member);
            draw_gear(scatter, &self.pair, member, share, stream)
        })
    }

    /// Leads of right and left flanks on top of the pair's in the assembly of `draw`; `None` where none scatter.
    pub fn leads(&self, draw: Draw, member: Member) -> Option<[Lead; 2]> {
        let lead = self.scatters.of(member).lead.as_ref()?;
        let stream = draw.stream(Factor::Lead(member).stream_number());
        Some(draw_leads(lead, stream))
    }

    /// Shares of the thicknesses of wheel and pinion in their distributions.
    fn thickness_shares(&self, stream: &dyn Fn(Factor) -> Stream) -> [f64; 2] {
        let correlation = self.scatters.thickness_correlation;
        if correlation == 0.0 {
            let of = |member| match self.scatters.of(member).thickness {
                Some(_) => stream(Factor::Thickness(member)).uniform(),
                None => 0.5,
            };
            return [of(Member::Wheel), of(Member::Pinion)];
        }
        let mut both = stream(Factor::Thicknesses);
        let [wheel, other] = [both.uniform(), both.uniform()];
        let pinion = match correlation {
            1.0 => wheel,
            -1.0 => 1.0 - wheel,
            // Two standard normal scores whose correlation is ρ: z and ρ z + √(1 − ρ²) z'.
            correlation => normal_share(
                correlation * standard_normal(wheel)
                    + (1.0 - correlation * correlation).sqrt() * standard_normal(other),
            ),
        };
        [wheel, pinion]
    }
}

/// One gear of `pair`, whose scatters are `own`, in another assembly, with its thickness at `share` of the distribution.
fn draw_gear(
    own: &GearScatter,
    pair: &AssembledPair,
    member: Member,
    share: f64,
    stream: &dyn Fn(Factor) -> Stream,
) -> GearChange {
    let teeth = pair.teeth(member);
    let whole = own.gears.as_ref().map(|gears| {
        let index = stream(Factor::Gear(member)).uniform() * gears.len() as f64;
        &gears[(index as usize).min(gears.len() - 1)]
    });
    let is_open = whole.map_or(pair.any_direction(member), AsBuilt::any_direction);
    let eccentricity = whole.map_or(pair.eccentricity(member), AsBuilt::eccentricity);
    let per_tooth = own.per_tooth.as_ref().map(|scatter| {
        let mut each = stream(Factor::PerTooth(member));
        (0..teeth).map(|_| scatter.at(each.uniform())).collect()
    });
    let lead = own.lead.as_ref();
    GearChange {
        whole: whole.cloned(),
        thicker: own.thickness.as_ref().map(|scatter| scatter.at(share)),
        per_tooth: per_tooth.unwrap_or_default(),
        pitch: own.pitch.map(|sigma| {
            let mut each = stream(Factor::Pitch(member));
            single_pitches(sigma, teeth, &mut each)
        }),
        leads: lead.map(|lead| draw_leads(lead, stream(Factor::Lead(member)))),
        wobble: own.wobble.as_ref().map(|scatter| {
            let mut wobble = stream(Factor::Wobble(member));
            let lean = scatter.at(wobble.uniform());
            [lean, any_tooth(teeth, wobble.uniform())]
        }),
        runout: (is_open || own.runout.is_some()).then(|| {
            let mut runout = stream(Factor::Runout(member));
            let amount = runout.uniform();
            let scatter = own.runout.as_ref();
            let eccentricity = scatter.map_or(eccentricity, |scatter| 0.5 * scatter.at(amount));
            (eccentricity, Some(any_tooth(teeth, runout.uniform())))
        }),
    }
}

/// The place of a share of the circle among the teeth, fractional.
fn any_tooth(teeth: u32, share: f64) -> f64 {
    1.0 + f64::from(teeth) * share
}

/// Leads of right and left flanks.
fn draw_leads(own: &LeadScatter, mut stream: Stream) -> [Lead; 2] {
    let mut both = |scatter: &Option<Scatter>| each_at([scatter.as_ref(); 2], &mut stream);
    let (slopes, crownings) = (both(&own.slope), both(&own.crowning));
    [0, 1].map(|flank| own.with(slopes[flank], crownings[flank]))
}

/// One value of each scatter, 0 without one. An absent scatter takes its random number too, so that each keeps its own.
fn each_at(scatters: [Option<&Scatter>; 2], stream: &mut Stream) -> [f64; 2] {
    scatters.map(|scatter| {
        let share = stream.uniform();
        scatter.map_or(0.0, |scatter| scatter.at(share))
    })
}

/// Pitch of both flanks: `f_i = g_i − mean(g)` with `g` normal, whose variance is `z/(z − 1)` that of `f`.
fn single_pitches(sigma: f64, teeth: u32, stream: &mut Stream) -> Pitch {
    let z = f64::from(teeth);
    let own = sigma * (z / (z - 1.0)).sqrt();
    let mut flank = || -> Vec<f64> {
        let each = (0..teeth).map(|_| own * standard_normal(stream.uniform()));
        each.collect()
    };
    let (right, left) = (flank(), flank());
    Pitch::from_single(&right, &left)
}
