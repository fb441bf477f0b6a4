//! The scatters of a pair and of its gears, and their errors.

use super::factor::Factor;
use super::scatter::Scatter;
use crate::gear::{AsBuilt, Lead};
use crate::outline::AssembledPair;
use crate::pair::{Member, ToothNumbers};
use std::sync::Arc;

/// Scatters of one gear; lengths in mm. `None`: as the pair has it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct GearScatter {
    /// Additional thickness of all teeth: at the reference circle, or of a drawn gear along the normals of its flanks.
    pub thickness: Option<Scatter>,
    /// Runout `F_r`, twice the eccentricity, in place of the pair's; its direction is uniform.
    pub runout: Option<Scatter>,
    /// Standard deviation of the single pitch deviations `f_p`, independent except that they close on the circle; right
    /// and left flanks separately. In addition to the pair's pitch.
    pub pitch: Option<f64>,
    /// Additional thickness of each tooth, on top of the pair's.
    pub per_tooth: Option<Scatter>,
    /// Lead deviations on top of the pair's.
    pub lead: Option<LeadScatter>,
    /// Wobble, mm per mm, in place of the pair's; its direction is uniform.
    pub wobble: Option<Scatter>,
    /// Whole gears, one of which is drawn in place of the pair's; the others are then `None`.
    pub gears: Option<Arc<[AsBuilt]>>,
}

/// Lead deviations that all teeth share, drawn for right and for left flanks separately.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LeadScatter {
    /// Face, evaluation range and zero of the leads.
    pub shape: Lead,
    /// Slope over the evaluation range.
    pub slope: Option<Scatter>,
    /// Crowning.
    pub crowning: Option<Scatter>,
}

impl LeadScatter {
    /// The lead of flanks with this slope and crowning, mm.
    pub(super) fn with(&self, slope: f64, crowning: f64) -> Lead {
        Lead {
            slope,
            crowning,
            ..self.shape.clone()
        }
    }
}

/// Scatters of a pair; lengths in mm. `None`: as the pair has it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Scatters {
    /// Scatters of the wheel.
    pub wheel: GearScatter,
    /// Scatters of the pinion.
    pub pinion: GearScatter,
    /// Addition to the centre distance.
    pub center_distance: Option<Scatter>,
    /// Addition to the lean of the pinion's axis, mm per mm: in the plane of the axes, and out of it.
    pub lean: [Option<Scatter>; 2],
    /// Radial clearance of both bearings together: the axes can move nearer or apart by this.
    pub bearing_clearance: Option<Scatter>,
    /// Whether the assembly phase is any of the gcd(z_1, z_2), or always one ([`with_phase`](crate::population::Population::with_phase)).
    pub phase: bool,
    /// Correlation of both thicknesses (of their normal scores), −1 … 1; 1 if both gears come from one batch.
    pub thickness_correlation: f64,
}

/// Invalid scatters of a population.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PopulationError {
    /// A negative runout, wobble or clearance.
    #[error("{what} reaches {low} mm, it cannot be below 0")]
    Negative {
        /// Name of the quantity.
        what: &'static str,
        /// The lowest value in its distribution, mm.
        low: f64,
    },
    /// A value that is no correlation.
    #[error("the correlation is {0}, it must be −1 … 1")]
    Correlation(f64),
    /// A correlation without two scattering quantities.
    #[error("a correlation of both thicknesses, of which one at least does not scatter")]
    NothingToCorrelate,
    /// A value that is no standard deviation.
    #[error("the standard deviation of the pitch is {0} mm, it must be above 0")]
    Pitch(f64),
    /// Whole gears in addition to another scatter of the same gear, or an empty list of them.
    #[error("whole gears are drawn, at least one, and nothing of them scatters beside")]
    WholeGears,
    /// A whole gear that does not match the wheel, or the pinion.
    #[error("gear {number} of the list has {what} {found}, not {wanted}")]
    OtherGear {
        /// Its place in the list, from 1.
        number: usize,
        /// Name of the value that differs.
        what: &'static str,
        /// Value of the listed gear.
        found: f64,
        /// Value of the pair's gear.
        wanted: f64,
    },
    /// A scatter that a gear of a pair with a drawn one has not.
    #[error(
        "beside a drawing the runout of each gear can scatter, and the thickness of a drawn one"
    )]
    Drawn,
    /// Deviations along the face of a pair without one.
    #[error("lead, wobble or axes scatter, and the gears have no common face")]
    NoFace,
    /// Nothing scatters.
    #[error("nothing scatters")]
    Nothing,
}

impl Scatters {
    /// Scatters of one gear.
    pub fn of(&self, member: Member) -> &GearScatter {
        match member {
            Member::Wheel => &self.wheel,
            Member::Pinion => &self.pinion,
        }
    }

    /// Whether anything along the face scatters.
    pub fn vary_along_face(&self) -> bool {
        self.wheel.lead.is_some() || self.pinion.lead.is_some() || self.lean()
    }

    /// Whether an axis of teeth leans in some assembly.
    pub fn lean(&self) -> bool {
        let wobbles = [&self.wheel, &self.pinion].map(|gear| gear.wobble.is_some());
        wobbles.contains(&true) || self.lean.iter().any(Option::is_some)
    }

    /// The quantities that scatter independently in the assemblies of `pair`.
    pub(super) fn factors(&self, pair: &AssembledPair) -> Vec<Factor> {
        let correlated = self.varies(Factor::Thicknesses, pair);
        let is_own = |one: &Factor| {
            let is_part = correlated && matches!(one, Factor::Thickness(_));
            !is_part && self.varies(*one, pair)
        };
        Factor::ALL.into_iter().filter(is_own).collect()
    }

    /// Whether `factor` differs between the assemblies of `pair`.
    pub(super) fn varies(&self, factor: Factor, pair: &AssembledPair) -> bool {
        let varies = |scatter: &Option<Scatter>| {
            let scatter = scatter.as_ref();
            scatter.is_some_and(|scatter| !scatter.is_fixed())
        };
        match factor {
            Factor::Thicknesses => self.thickness_correlation != 0.0,
            Factor::Thickness(member) => varies(&self.of(member).thickness),
            Factor::Runout(member) => {
                let of = self.of(member);
                // A runout without direction can have any.
                let is_open = |gear: &AsBuilt| gear.any_direction() && gear.eccentricity() > 0.0;
                let open = match &of.gears {
                    Some(gears) => gears.iter().any(is_open),
                    None => pair.as_built(member).is_some_and(is_open),
                };
                of.runout.is_some() || open
            }
            Factor::Pitch(member) => self.of(member).pitch.is_some(),
            Factor::PerTooth(member) => varies(&self.of(member).per_tooth),
            Factor::Lead(member) => {
                let lead = self.of(member).lead.as_ref();
                lead.is_some_and(|lead| varies(&lead.slope) || varies(&lead.crowning))
            }
            Factor::Wobble(member) => self.of(member).wobble.is_some(),
            Factor::Gear(member) => self.of(member).gears.is_some(),
            Factor::CenterDistance => varies(&self.center_distance),
            Factor::Misalignment => self.lean.iter().any(varies),
            Factor::BearingClearance => varies(&self.bearing_clearance),
            Factor::Phase => self.phase && pair.phase_count() > 1,
        }
    }
}

impl GearScatter {
    /// Checks the scatters of a gear, and its whole gears against `own`.
    pub(super) fn check(&self, own: Option<&AsBuilt>) -> Result<(), PopulationError> {
        if let Some(runout) = &self.runout {
            not_negative("the runout", runout)?;
        }
        if let Some(wobble) = &self.wobble {
            not_negative("the wobble", wobble)?;
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
        let each = gears.iter().enumerate();
        for ((index, gear), own) in each.flat_map(|gear| Some(gear).zip(own)) {
            let (found, wanted) = (gear.gear().basic_data(), own.gear().basic_data());
            for (what, found, wanted) in [
                ("teeth", f64::from(found.teeth()), f64::from(wanted.teeth())),
                ("module", found.module(), wanted.module()),
                (
                    "pressure angle",
                    found.pressure_angle(),
                    wanted.pressure_angle(),
                ),
                ("helix angle", found.helix_angle(), wanted.helix_angle()),
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
}

pub(super) fn not_negative(what: &'static str, scatter: &Scatter) -> Result<(), PopulationError> {
    let least = scatter.least();
    let right = least >= 0.0;
    right
        .then_some(())
        .ok_or(PopulationError::Negative { what, low: least })
}
