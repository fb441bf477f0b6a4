//! Classic tolerance analysis: the worst case and the root sum of squares.

use super::assembly::Assembly;
use super::factor::Factor;
use super::members::Population;
use super::scatter::Scatter;
use super::scatters::{GearScatter, LeadScatter};
use crate::analysis::extremes::phases_differ;
use crate::contact::End;
use crate::error::Error;
use crate::gear::{AsBuilt, Face, Flank, Lead};
use crate::outline::{AssembledPair, GearChange};
use crate::pair::{Member, ToothNumbers};
use crate::parallel;

/// Standard deviations of a flank's cumulative pitch deviation in the worst case.
pub const PITCH_LIMIT_SIGMAS: f64 = 3.0;

/// Least and greatest `j_wt`, mm, with every scatter at its limits, and by the root sum of squares. `None` if a pair there is jammed, out
/// of mesh or impossible. If the assembly phase scatters, they are the least and the greatest of all phases.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LimitCases {
    /// Each scatter at its mean, a drawn runout, wobble or pitch at 0, and everything else as in the pair.
    pub mean: [Option<f64>; 2],
    /// The least with all scatters at one limit, the greatest with all at the other.
    pub worst: [Option<f64>; 2],
    /// `j − √(Σ Δ_i²)` and `j + √(Σ Δ_i²)`. `Δ_i` is the effect of one quantity alone: on the least at its limit
    /// towards less backlash, on the greatest at its limit towards more.
    pub root_sum_of_squares: [Option<f64>; 2],
}

/// The quantities that have limits.
const LIMITED_FACTORS: [Factor; 15] = [
    Factor::Thickness(Member::Wheel),
    Factor::Thickness(Member::Pinion),
    Factor::Runout(Member::Wheel),
    Factor::Runout(Member::Pinion),
    Factor::Pitch(Member::Wheel),
    Factor::Pitch(Member::Pinion),
    Factor::PerTooth(Member::Wheel),
    Factor::PerTooth(Member::Pinion),
    Factor::CenterDistance,
    Factor::BearingClearance,
    Factor::Lead(Member::Wheel),
    Factor::Lead(Member::Pinion),
    Factor::Wobble(Member::Wheel),
    Factor::Wobble(Member::Pinion),
    Factor::Misalignment,
];

/// Ends of the face, +1 away from the viewer, where leads and axes at their limits tighten right and left flanks. 0: slopes and axes are at their means.
const FACE_ENDS: [[f64; 2]; 5] = [
    [0.0, 0.0],
    [1.0, 1.0],
    [-1.0, -1.0],
    [1.0, -1.0],
    [-1.0, 1.0],
];

/// The limit cases of `population`. `None` if whole gears are drawn at random, which have no limits. `None` also if the runout of a gear
/// given by a drawing scatters: its worst direction is not searched.
///
/// An assembly phase has no limits. If it scatters, each case covers all gcd(z_1, z_2) phases. Its least and its
/// greatest can come from different phases.
///
/// Leads and axes take backlash in either sense. Their limits tighten either flank at either end of the face. The extremes are the least and the
/// greatest of these cases, and of slopes and axes at their means. Wobbling teeth are assumed to lean against each other where wheel tooth 1 meets
/// its mate.
///
/// Distributions without an end are cut at their limits ([`Scatter::limits`]). A runout is in its worst direction. Pitch is a list of
/// numbers that close on the circle. The flanks in contact are [`PITCH_LIMIT_SIGMAS`] standard deviations of a cumulative deviation out, or
/// in, on both sides of both gears. For `z` closed single deviations of standard deviation `σ` about their mean, that deviation is
///
/// ```text
/// σ_F² = (z + 1)/12 σ²
/// ```
///
/// because `f_i = g_i − mean(g)` with `σ_g² = σ² z/(z − 1)` gives `F_i = Σ_j c(i − j) g_j`, with `c(m) = (z − 1)/(2z) −
/// m/z` at `m = 0 … z − 1`, and `Σ c² = (z² − 1)/(12 z)`.
///
/// # Errors
/// As [`Assembly::outcome`].
pub fn limit_cases(population: &Population) -> Result<Option<LimitCases>, Error> {
    let scatters = population.scatters();
    let are_whole = |member| scatters.of(member).gears.is_some();
    // The worst direction of a runout is searched for gears by data alone.
    let off_axis = Member::BOTH.map(|member| GearChange {
        runout: scatters.of(member).runout.as_ref().map(|_| (0.0, None)),
        ..GearChange::default()
    });
    if Member::BOTH.into_iter().any(are_whole) || !population.pair().allows(&off_axis) {
        return Ok(None);
    }
    let both = |of: &dyn Fn(Factor) -> bool| {
        let [least, greatest] = End::BOTH.map(|end| case(population, of, end));
        Ok::<_, Error>([least?, greatest?])
    };
    let mean = both(&|_| false)?;
    let mut squares = [Some(0.0); 2];
    let mut thickness = [[Some(0.0); 2]; 2];
    let varies = |one: &Factor| scatters.varies(*one, population.pair());
    // Each with all others at their mean.
    for alone in LIMITED_FACTORS.into_iter().filter(varies) {
        let moved = both(&|one| one == alone)?;
        for end in 0..2 {
            let change = moved[end].zip(mean[end]).map(|(moved, mean)| moved - mean);
            if let Factor::Thickness(member) = alone {
                thickness[member as usize][end] = change;
            }
            squares[end] = squares[end]
                .zip(change)
                .map(|(sum, change)| sum + change * change);
        }
    }
    // Correlated quantities add 2 ρ Δ_1 Δ_2 to the sum of squares.
    let correlation = scatters.thickness_correlation;
    let roots = [0, 1].map(|end| {
        let product = thickness[0][end]
            .zip(thickness[1][end])
            .map(|(one, other)| one * other);
        let sum = squares[end]
            .zip(product)
            .map(|(sum, product)| sum + 2.0 * correlation * product);
        let sign = [-1.0, 1.0][end];
        mean[end]
            .zip(sum)
            .map(|(mean, sum)| mean + sign * sum.max(0.0).sqrt())
    });
    Ok(Some(LimitCases {
        mean,
        worst: both(&|_| true)?,
        root_sum_of_squares: roots,
    }))
}

/// The least or the greatest with the quantities `at_limit` at their limit towards it and all others at their mean, over the possible phases.
fn case(
    population: &Population,
    at_limit: &dyn Fn(Factor) -> bool,
    end: End,
) -> Result<Option<f64>, Error> {
    let scatters = population.scatters();
    let of_face = |one: &Factor| matches!(one, Factor::Lead(_) | Factor::Misalignment);
    let mut of_face = LIMITED_FACTORS.into_iter().filter(of_face);
    let varies = |one| scatters.varies(one, population.pair());
    let count = if of_face.any(|one| varies(one) && at_limit(one)) {
        FACE_ENDS.len()
    } else {
        1
    };
    let made = FACE_ENDS.iter().take(count);
    let made = made.map(|ends| assembly(population, at_limit, end, *ends));
    // An impossible gear: the case does not exist.
    let Ok(assemblies) = made.collect::<Result<Vec<_>, _>>() else {
        return Ok(None);
    };
    let in_phases = assemblies.iter().flat_map(|assembly| {
        let pair = &assembly.pair;
        let phases = if scatters.phase && phases_differ(pair) {
            1..=pair.phase_count()
        } else {
            assembly.phase..=assembly.phase
        };
        phases.map(|phase| Assembly {
            phase,
            ..assembly.clone()
        })
    });
    let each = parallel::map(in_phases, |assembly: Assembly| assembly.outcome());
    let each = each.into_iter().collect::<Result<Vec<_>, _>>()?;
    let values = each
        .iter()
        .map(|found| [found.least, found.greatest][end as usize]);
    let beyond = match end {
        End::Least => f64::min,
        End::Greatest => f64::max,
    };
    // A phase without a value leaves no value for all.
    let farthest = values.reduce(|one, other| Some(beyond(one?, other?)));
    Ok(farthest.flatten())
}

fn assembly(
    population: &Population,
    at_limit: &dyn Fn(Factor) -> bool,
    end: End,
    ends: [f64; 2],
) -> Result<Assembly, Error> {
    let scatters = population.scatters();
    // More material means less backlash, more distance means more.
    let [less, more] = [1 - end as usize, end as usize];
    let of = |scatter: &Option<Scatter>, alone: Factor, side: usize| match scatter {
        Some(scatter) if at_limit(alone) => Some(scatter.limits()[side]),
        scatter => scatter.as_ref().map(Scatter::mean),
    };
    let pair = population.pair();
    let change = |member: Member| {
        let scatter = scatters.of(member);
        let each = of(&scatter.per_tooth, Factor::PerTooth(member), less).unwrap_or(0.0);
        let pitch = if at_limit(Factor::Pitch(member)) {
            pitch_limit(scatter, pair, member) * end.sign()
        } else {
            0.0
        };
        let lead = scatter.lead.as_ref();
        let lead_end = at_limit(Factor::Lead(member)).then_some((end, ends));
        let is_worst = end == End::Least && at_limit(Factor::Wobble(member));
        let is_off_axis = at_limit(Factor::Runout(member));
        GearChange {
            thicker: of(&scatter.thickness, Factor::Thickness(member), less),
            per_tooth: if each + pitch == 0.0 {
                Vec::new()
            } else {
                vec![each + pitch; pair.teeth(member) as usize]
            },
            leads: lead.map(|lead| lead_limit(lead, pair.shown_face(member), lead_end)),
            wobble: scatter.wobble.as_ref().map(|wobble| {
                let lean = if is_worst { wobble.limits()[1] } else { 0.0 };
                [lean, leaning_tooth(population, member)]
            }),
            runout: scatter.runout.as_ref().map(|runout| {
                if is_off_axis {
                    (0.5 * runout.limits()[1], None)
                } else {
                    (0.0, Some(1.0))
                }
            }),
            ..GearChange::default()
        }
    };
    let farther = of(&scatters.center_distance, Factor::CenterDistance, more);
    let distance = pair.center_distance() + farther.unwrap_or(0.0);
    let play = of(&scatters.bearing_clearance, Factor::BearingClearance, 1);
    // Axes that are nearer at the far end tighten it on both flanks, those with the pinion's far end at +y on right flanks.
    let senses = [-ends[0], ends[0]];
    let leaning = [0, 1].map(|k| match &scatters.lean[k] {
        Some(lean) if at_limit(Factor::Misalignment) && ends[0] != 0.0 => {
            lean.limits()[usize::from(senses[k] > 0.0)]
        }
        Some(lean) => lean.mean(),
        None => 0.0,
    });
    let pair = pair.varied(distance, &Member::BOTH.map(change))?;
    Ok(Assembly {
        pair: pair.leaning_further(leaning)?,
        clearance: play.unwrap_or(population.clearance),
        phase: population.phase,
    })
}

/// Leads of right and left flanks at their means, or at a limit with material at these ends of the face.
fn lead_limit(lead: &LeadScatter, own: Face, limit: Option<(End, [f64; 2])>) -> [Lead; 2] {
    let mean = |scatter: &Option<Scatter>| scatter.as_ref().map_or(0.0, Scatter::mean);
    let at = |scatter: &Option<Scatter>, end: usize| {
        scatter
            .as_ref()
            .map_or(0.0, |scatter| scatter.limits()[end])
    };
    // A crown costs what lies above the zero: both ends of a hollow flank, or the middle.
    let Lead { face, zero, .. } = &lead.shape;
    let from_middle = (2.0 * zero - face[0] - face[1]) / (face[1] - face[0]);
    let costly = usize::from(from_middle * from_middle > 0.5);
    Flank::BOTH.map(|flank| {
        let Some((end, ends)) = limit else {
            return lead.with(mean(&lead.slope), mean(&lead.crowning));
        };
        let tight = ends[own.seen_from_front(flank).index()];
        let slope = if tight == 0.0 {
            mean(&lead.slope)
        } else {
            // Heights rise away from the reference face.
            at(&lead.slope, usize::from(-own.ascending() * tight > 0.0))
        };
        let crowning = match end {
            End::Least => costly,
            End::Greatest => 1 - costly,
        };
        lead.with(slope, at(&lead.crowning, crowning))
    })
}

/// The tooth of a gear of `population` towards which it leans, against its mate where wheel tooth 1 meets the pinion.
fn leaning_tooth(population: &Population, member: Member) -> f64 {
    let pair = population.pair();
    if member == Member::Wheel {
        return 1.0;
    }
    let teeth = f64::from(pair.teeth(member));
    let facing = if pair.shown_face(Member::Wheel) == pair.shown_face(member) {
        0.0
    } else {
        0.5 * teeth
    };
    1.0 + (f64::from(population.phase - 1) + facing).rem_euclid(teeth)
}

/// Additional thickness of a tooth, mm, with both flanks at the limit of their cumulative pitch deviation.
fn pitch_limit(scatter: &GearScatter, pair: &AssembledPair, member: Member) -> f64 {
    let z = f64::from(pair.teeth(member));
    let sigma = scatter.pitch.unwrap_or(0.0) * ((z + 1.0) / 12.0).sqrt();
    // An arc of the transverse section; thickness is in the normal section.
    let helix_cos = |gear: &AsBuilt| gear.gear().basic_data().helix_cos();
    2.0 * PITCH_LIMIT_SIGMAS * sigma * pair.as_built(member).map_or(1.0, helix_cos)
}
