//! A population, and one of its assemblies.

use super::assembly::Assembly;
use super::factor::Factor;
use super::scatter::{Scatter, normal_share, standard_normal};
use super::scatters::{
    GearScatter, LeadScatter, PopulationError, Scatters, not_negative, phase_count,
};
use super::stream::{Draw, Stream};
use crate::error::{Error, GearError, OutlineError};
use crate::gear::{AsBuilt, Deviations, Lead, Pitch};
use crate::outline::{AssembledPair, OutlineGear};
use crate::pair::Member;

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
        let pair = pair.into();
        for member in Member::BOTH {
            let gear = scatters.of(member);
            gear.check(pair.as_built(member), pair.flank_offset(member))?;
        }
        let nonnegative = |what, scatter: &Option<Scatter>| match scatter {
            Some(scatter) => not_negative(what, scatter),
            None => Ok(()),
        };
        nonnegative("the play of the bearings", &scatters.bearing_play)?;
        let [near, far] = pair.face();
        if scatters.vary_along_face() && near == far {
            return Err(PopulationError::NoFace);
        }
        let correlation = scatters.thickness_correlation;
        if !(-1.0..=1.0).contains(&correlation) {
            return Err(PopulationError::Correlation(correlation));
        }
        let thicknesses = [&scatters.wheel.thickness, &scatters.pinion.thickness];
        if correlation != 0.0 && thicknesses.iter().any(|thickness| thickness.is_none()) {
            return Err(PopulationError::NothingToCorrelate);
        }
        let factors = scatters.factors(&pair);
        if factors.is_empty() {
            return Err(PopulationError::Nothing);
        }
        Ok(Population {
            pair,
            scatters,
            clearance: 0.0,
            phase: 1,
            factors,
        })
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
        let stream = |factor: Factor| of(factor).stream(factor.quantity());
        let one = |scatter: &Option<Scatter>, factor: Factor| {
            let scatter = scatter.as_ref()?;
            Some(scatter.at(stream(factor).uniform()))
        };
        let farther = one(&self.scatters.center_distance, Factor::CenterDistance).unwrap_or(0.0);
        let distance = self.pair.center_distance() + farther;
        let play = one(&self.scatters.bearing_play, Factor::BearingPlay);
        let phases = f64::from(phase_count(&self.pair));
        let phase = if self.scatters.phase {
            (stream(Factor::Phase).uniform() * phases) as u32 + 1
        } else {
            self.phase
        };
        let shares = self.thickness_shares(&stream);
        let pair = self.pair.varied(
            distance,
            |own, member| {
                let share = shares[member as usize];
                self.scatters.of(member).draw(own, member, share, &stream)
            },
            |own, member| {
                let share = shares[member as usize];
                let scatter = self.scatters.of(member);
                scatter.draw_outline(own, member, share, &stream)
            },
        )?;
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

    /// Leads of right and left flanks on top of the pair's in the assembly of `draw`; `None` where none scatter.
    pub fn leads(&self, draw: Draw, member: Member) -> Option<[Lead; 2]> {
        let lead = self.scatters.of(member).lead.as_ref()?;
        Some(lead.draw(draw.stream(Factor::Lead(member).quantity())))
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

impl GearScatter {
    /// One gear like `own`, with its thickness at `share` of the distribution.
    fn draw(
        &self,
        own: &AsBuilt,
        member: Member,
        share: f64,
        stream: &dyn Fn(Factor) -> Stream,
    ) -> Result<AsBuilt, GearError> {
        let whole = self.gears.as_ref().map(|gears| {
            let index = stream(Factor::Gear(member)).uniform() * gears.len() as f64;
            gears[(index as usize).min(gears.len() - 1)].clone()
        });
        let gear = whole.unwrap_or_else(|| own.clone());
        let teeth = gear.gear().basic_data().teeth();
        let thicker = self.thickness.as_ref().map(|scatter| scatter.at(share));
        let per_tooth = self.per_tooth.as_ref().map(|scatter| {
            let mut each = stream(Factor::PerTooth(member));
            (0..teeth).map(|_| scatter.at(each.uniform())).collect()
        });
        let pitch = self.pitch.map(|sigma| {
            let mut each = stream(Factor::Pitch(member));
            single_pitches(sigma, teeth, &mut each)
        });
        let gear = if thicker.is_none() && per_tooth.is_none() && pitch.is_none() {
            gear
        } else {
            gear.varied(
                thicker.unwrap_or(0.0),
                &Deviations {
                    per_tooth: per_tooth.unwrap_or_default(),
                    pitch,
                    ..Deviations::default()
                },
            )?
        };
        let gear = match &self.lead {
            Some(lead) => gear.with_further_leads(&lead.draw(stream(Factor::Lead(member))))?,
            None => gear,
        };
        let wobble = self.wobble.as_ref().map(|scatter| {
            let mut wobble = stream(Factor::Wobble(member));
            [
                scatter.at(wobble.uniform()),
                any_tooth(teeth, wobble.uniform()),
            ]
        });
        let is_open = self.runout.is_some() || gear.any_direction();
        let runout = is_open.then(|| self.runout_of(gear.eccentricity(), (member, teeth), stream));
        displaced(gear, wobble, |gear| match runout {
            Some([eccentricity, high_tooth]) => gear.with_runout(eccentricity, high_tooth),
            None => Ok(gear),
        })
    }

    /// The eccentricity of a gear whose own one is `eccentricity`, mm, and the high tooth.
    fn runout_of(
        &self,
        eccentricity: f64,
        (member, teeth): (Member, u32),
        stream: &dyn Fn(Factor) -> Stream,
    ) -> [f64; 2] {
        let mut runout = stream(Factor::Runout(member));
        let amount = runout.uniform();
        let scatter = self.runout.as_ref();
        let eccentricity = scatter.map_or(eccentricity, |scatter| 0.5 * scatter.at(amount));
        [eccentricity, any_tooth(teeth, runout.uniform())]
    }

    /// One drawn gear like `own`, with its thickness at `share` of the distribution.
    fn draw_outline(
        &self,
        own: &OutlineGear,
        member: Member,
        share: f64,
        stream: &dyn Fn(Factor) -> Stream,
    ) -> Result<OutlineGear, OutlineError> {
        let gear = match &self.thickness {
            Some(scatter) => own.thicker(scatter.at(share))?,
            None => own.clone(),
        };
        if self.runout.is_none() {
            return Ok(gear);
        }
        let [eccentricity, high_tooth] =
            self.runout_of(own.eccentricity(), (member, own.teeth()), stream);
        gear.with_runout(eccentricity, high_tooth)
    }
}

/// The place of a share of the circle among the teeth, fractional.
fn any_tooth(teeth: u32, share: f64) -> f64 {
    1.0 + f64::from(teeth) * share
}

/// `gear` with another wobble, where one is given, and after `runout`. Where teeth lean, both are those of its measuring plane.
pub(super) fn displaced(
    gear: AsBuilt,
    wobble: Option<[f64; 2]>,
    runout: impl Fn(AsBuilt) -> Result<AsBuilt, GearError>,
) -> Result<AsBuilt, GearError> {
    if wobble.is_none() && gear.wobble() == 0.0 {
        return runout(gear);
    }
    let own = runout(gear.in_measuring_plane())?;
    let own = match wobble {
        Some([lean, tooth]) => own.with_wobble(lean, tooth),
        None => own,
    };
    Ok(own.section_at(gear.place()))
}

impl LeadScatter {
    /// Leads of right and left flanks.
    fn draw(&self, mut stream: Stream) -> [Lead; 2] {
        let mut both = |scatter: &Option<Scatter>| each_at([scatter.as_ref(); 2], &mut stream);
        let (slopes, crownings) = (both(&self.slope), both(&self.crowning));
        [0, 1].map(|flank| self.with(slopes[flank], crownings[flank]))
    }
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
