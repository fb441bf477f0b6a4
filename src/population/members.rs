//! What scatters in a population, and one of its assemblies.

use super::assembly::Assembly;
use super::scatter::{Scatter, normal_share, standard_normal};
use super::stream::{Draw, Stream};
use crate::error::GearError;
use crate::gear::{AsBuilt, Deviations, Pitch};
use crate::pair::{GearPair, Member, SweepPlan};
use std::sync::Arc;

/// What scatters of one gear; lengths in mm. `None`: as the pair has it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct GearScatter {
    /// What all teeth are thicker, at the reference circle.
    pub thickness: Option<Scatter>,
    /// Runout `F_r`, twice the eccentricity, in place of the pair's; its direction is uniform.
    pub runout: Option<Scatter>,
    /// Standard deviation of the single pitch deviations `f_p`, each by itself but that they close on the circle; right and left flanks
    /// apart. On top of the pair's pitch.
    pub pitch: Option<f64>,
    /// What each tooth is thicker, on top of the pair's.
    pub per_tooth: Option<Scatter>,
    /// Whole gears, one of which is drawn in place of the pair's; the others are then `None`.
    pub gears: Option<Arc<[AsBuilt]>>,
}

/// What scatters of a pair; lengths in mm. `None`: as the pair has it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Scatters {
    /// Of the wheel.
    pub wheel: GearScatter,
    /// Of the pinion.
    pub pinion: GearScatter,
    /// What the centre distance is greater.
    pub center_distance: Option<Scatter>,
    /// Radial play of both bearings together: the axes may be nearer, and farther apart, by as much.
    pub bearing_play: Option<Scatter>,
    /// Whether the gears are put together in any of their gcd(z_1, z_2) ways, or always alike ([`Population::with_phase`]).
    pub phase: bool,
    /// Correlation of both thicknesses (of their normal scores), −1 … 1; 1 where both gears come from one batch.
    pub thickness_correlation: f64,
}

/// A quantity that scatters by itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Factor {
    /// Thickness of a gear.
    Thickness(Member),
    /// Thickness of both gears, where it is correlated.
    Thicknesses,
    /// Runout of a gear, with its direction.
    Runout(Member),
    /// Pitch of a gear, both flanks of all teeth.
    Pitch(Member),
    /// Thickness of each tooth of a gear.
    PerTooth(Member),
    /// Which whole gear is taken.
    Gear(Member),
    /// Centre distance.
    CenterDistance,
    /// Play of the bearings.
    BearingPlay,
    /// How the gears are put together.
    Phase,
}

impl Factor {
    /// All there are.
    pub const ALL: [Factor; 14] = [
        Factor::Thicknesses,
        Factor::Thickness(Member::Wheel),
        Factor::Runout(Member::Wheel),
        Factor::Pitch(Member::Wheel),
        Factor::PerTooth(Member::Wheel),
        Factor::Gear(Member::Wheel),
        Factor::Thickness(Member::Pinion),
        Factor::Runout(Member::Pinion),
        Factor::Pitch(Member::Pinion),
        Factor::PerTooth(Member::Pinion),
        Factor::Gear(Member::Pinion),
        Factor::CenterDistance,
        Factor::BearingPlay,
        Factor::Phase,
    ];

    /// Which numbers it is drawn from: never to be changed, or a seed would mean another population.
    fn quantity(self) -> u32 {
        let of = |first, member| first + 8 * u32::from(member == Member::Pinion);
        match self {
            Factor::Thickness(member) => of(0, member),
            Factor::Runout(member) => of(1, member),
            Factor::Pitch(member) => of(2, member),
            Factor::PerTooth(member) => of(3, member),
            Factor::Gear(member) => of(4, member),
            Factor::CenterDistance => 16,
            Factor::BearingPlay => 17,
            Factor::Phase => 18,
            Factor::Thicknesses => 19,
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
            Factor::Gear(m) => of(m, ["which wheel", "which pinion"]),
            Factor::Thicknesses => "thickness of both gears",
            Factor::CenterDistance => "centre distance",
            Factor::BearingPlay => "play of the bearings",
            Factor::Phase => "assembly phase",
        }
    }
}

/// Scatter that no population can have.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PopulationError {
    /// A runout or a play below 0.
    #[error("{what} reaches {low} mm, it cannot be below 0")]
    Negative {
        /// What it is.
        what: &'static str,
        /// The least there may be, mm.
        low: f64,
    },
    /// A correlation that is none.
    #[error("the correlation is {0}, it must be −1 … 1")]
    Correlation(f64),
    /// A correlation of what does not scatter.
    #[error("a correlation of both thicknesses, of which one at least does not scatter")]
    NothingToCorrelate,
    /// A standard deviation that is none.
    #[error("the standard deviation of the pitch is {0} mm, it must be above 0")]
    Pitch(f64),
    /// Whole gears beside other scatter of the same gear, or none of them.
    #[error("whole gears are drawn, at least one, and nothing of them scatters beside")]
    WholeGears,
    /// A whole gear that is no such wheel, or pinion.
    #[error("gear {number} of the list has {what} {found}, not {wanted}")]
    OtherGear {
        /// Its place in the list, from 1.
        number: usize,
        /// What differs.
        what: &'static str,
        /// What it has.
        found: f64,
        /// What the pair's gear has.
        wanted: f64,
    },
    /// Nothing scatters.
    #[error("nothing scatters")]
    Nothing,
}

/// A pair and what scatters about it.
#[derive(Debug, Clone, PartialEq)]
pub struct Population {
    pair: GearPair,
    scatters: Scatters,
    clearance: f64,
    phase: u32,
    factors: Vec<Factor>,
}

impl Population {
    /// Pairs like `pair`, but for `scatters`.
    ///
    /// # Errors
    /// [`PopulationError`].
    pub fn new(pair: GearPair, scatters: Scatters) -> Result<Population, PopulationError> {
        for (member, gear) in [
            (Member::Wheel, &scatters.wheel),
            (Member::Pinion, &scatters.pinion),
        ] {
            gear.check(pair.gear(member))?;
        }
        let nonnegative = |what, scatter: &Option<Scatter>| match scatter {
            Some(scatter) => not_negative(what, scatter),
            None => Ok(()),
        };
        nonnegative("the play of the bearings", &scatters.bearing_play)?;
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

    /// The same with a radial play of both bearings together, mm, where none scatters.
    #[must_use]
    pub fn with_bearing_clearance(self, clearance: f64) -> Population {
        Population { clearance, ..self }
    }

    /// The same, wheel tooth 1 with pinion tooth `phase` at their right flanks where the phase does not scatter.
    #[must_use]
    pub fn with_phase(self, phase: u32) -> Population {
        Population { phase, ..self }
    }

    /// The pair about which it scatters.
    pub fn pair(&self) -> &GearPair {
        &self.pair
    }

    /// What scatters.
    pub fn scatters(&self) -> &Scatters {
        &self.scatters
    }

    /// Play of both bearings where none scatters, mm.
    pub(super) fn clearance(&self) -> f64 {
        self.clearance
    }

    /// The pinion tooth that meets wheel tooth 1 where the phase does not scatter.
    pub(super) fn phase(&self) -> u32 {
        self.phase
    }

    /// The quantities that scatter, each by itself, in a fixed order.
    pub fn factors(&self) -> &[Factor] {
        &self.factors
    }

    /// The assembly of `draw`.
    ///
    /// # Errors
    /// Numbers that no gear or pair has.
    pub fn assembly(&self, draw: Draw) -> Result<Assembly, GearError> {
        self.assembled(&|_| draw)
    }

    /// The assembly whose quantities are each of a draw of their own.
    pub(super) fn assembled(&self, of: &dyn Fn(Factor) -> Draw) -> Result<Assembly, GearError> {
        let stream = |factor: Factor| of(factor).stream(factor.quantity());
        let one = |scatter: &Option<Scatter>, factor: Factor| {
            let scatter = scatter.as_ref()?;
            Some(scatter.at(stream(factor).uniform()))
        };
        let [wheel_share, pinion_share] = self.thickness_shares(&stream);
        let gear = |member, share| {
            let (scatter, own) = (self.scatters.of(member), self.pair.gear(member));
            scatter.draw(own, member, share, &stream)
        };
        let wheel = gear(Member::Wheel, wheel_share)?;
        let pinion = gear(Member::Pinion, pinion_share)?;
        let farther = one(&self.scatters.center_distance, Factor::CenterDistance).unwrap_or(0.0);
        let distance = self.pair.center_distance() + farther;
        let play = one(&self.scatters.bearing_play, Factor::BearingPlay);
        let phases = f64::from(phase_count(&self.pair));
        let phase = match self.scatters.phase {
            true => (stream(Factor::Phase).uniform() * phases) as u32 + 1,
            false => self.phase,
        };
        let pair = GearPair::with_locked(wheel, pinion, distance, self.pair.locked())?;
        Ok(Assembly::new(pair, play.unwrap_or(self.clearance), phase))
    }

    /// Where in their distributions the thicknesses of wheel and pinion stand.
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

impl Scatters {
    /// Those of one gear.
    pub fn of(&self, member: Member) -> &GearScatter {
        match member {
            Member::Wheel => &self.wheel,
            Member::Pinion => &self.pinion,
        }
    }

    fn factors(&self, pair: &GearPair) -> Vec<Factor> {
        let scatters = |scatter: &Option<Scatter>| {
            let scatter = scatter.as_ref();
            scatter.is_some_and(|scatter| !scatter.is_fixed())
        };
        let mut factors = Vec::new();
        let correlated = self.thickness_correlation != 0.0;
        if correlated {
            factors.push(Factor::Thicknesses);
        }
        for member in [Member::Wheel, Member::Pinion] {
            let (of, gear) = (self.of(member), pair.gear(member));
            // A runout without a direction has any.
            let open = of.gears.is_none() && gear.any_direction() && gear.eccentricity() > 0.0;
            let each = [
                (
                    !correlated && scatters(&of.thickness),
                    Factor::Thickness(member),
                ),
                (of.runout.is_some() || open, Factor::Runout(member)),
                (of.pitch.is_some(), Factor::Pitch(member)),
                (scatters(&of.per_tooth), Factor::PerTooth(member)),
                (of.gears.is_some(), Factor::Gear(member)),
            ];
            factors.extend(
                each.into_iter()
                    .filter_map(|(there, one)| there.then_some(one)),
            );
        }
        let rest = [
            (scatters(&self.center_distance), Factor::CenterDistance),
            (scatters(&self.bearing_play), Factor::BearingPlay),
            (self.phase && phase_count(pair) > 1, Factor::Phase),
        ];
        factors.extend(
            rest.into_iter()
                .filter_map(|(there, one)| there.then_some(one)),
        );
        factors
    }
}

impl GearScatter {
    fn check(&self, own: &AsBuilt) -> Result<(), PopulationError> {
        if let Some(runout) = &self.runout {
            not_negative("the runout", runout)?;
        }
        if let Some(sigma) = self.pitch
            && !(sigma > 0.0 && sigma.is_finite())
        {
            return Err(PopulationError::Pitch(sigma));
        }
        let Some(gears) = &self.gears else {
            return Ok(());
        };
        let alone = GearScatter {
            gears: Some(Arc::clone(gears)),
            ..GearScatter::default()
        };
        if gears.is_empty() || *self != alone {
            return Err(PopulationError::WholeGears);
        }
        for (index, gear) in gears.iter().enumerate() {
            let (found, wanted) = (gear.gear().basic_data(), own.gear().basic_data());
            for (what, found, wanted) in [
                ("teeth", f64::from(found.teeth()), f64::from(wanted.teeth())),
                ("module", found.module(), wanted.module()),
                (
                    "pressure angle",
                    found.pressure_angle(),
                    wanted.pressure_angle(),
                ),
            ] {
                if found != wanted {
                    return Err(PopulationError::OtherGear {
                        number: index + 1,
                        what,
                        found,
                        wanted,
                    });
                }
            }
        }
        Ok(())
    }

    /// One gear like `own`, its thickness at `share` of the distribution.
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
        let gear = match thicker.is_none() && per_tooth.is_none() && pitch.is_none() {
            true => gear,
            false => gear.varied(
                thicker.unwrap_or(0.0),
                &Deviations {
                    per_tooth: per_tooth.unwrap_or_default(),
                    pitch,
                    ..Deviations::default()
                },
            )?,
        };
        if self.runout.is_none() && !gear.any_direction() {
            return Ok(gear);
        }
        let mut runout = stream(Factor::Runout(member));
        let amount = runout.uniform();
        let eccentricity = match &self.runout {
            Some(scatter) => 0.5 * scatter.at(amount),
            None => gear.eccentricity(),
        };
        gear.with_runout(eccentricity, 1.0 + f64::from(teeth) * runout.uniform())
    }
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

fn not_negative(what: &'static str, scatter: &Scatter) -> Result<(), PopulationError> {
    let [low, _] = scatter.limits();
    // The least of all: a normal one has none.
    let least = scatter.at(f64::MIN_POSITIVE).min(low);
    let right = least >= 0.0;
    right
        .then_some(())
        .ok_or(PopulationError::Negative { what, low: least })
}

/// Ways to put the gears together.
fn phase_count(pair: &GearPair) -> u32 {
    let teeth = |member| pair.gear(member).gear().basic_data().teeth();
    SweepPlan::phase_count(teeth(Member::Wheel), teeth(Member::Pinion))
}
