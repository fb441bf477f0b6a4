//! The worst case and the root sum of squares: what designers reckoned with before they drew.

use super::assembly::Assembly;
use super::members::Population;
use super::scatter::Scatter;
use super::scatters::{GearScatter, Scatters, phase_count};
use crate::analysis::extremes::phases_differ;
use crate::error::{Error, GearError};
use crate::gear::{AsBuilt, Deviations};
use crate::pair::Member;
use crate::parallel;

/// How many standard deviations of a flank's cumulative pitch deviation the worst case takes.
pub const PITCH_LIMIT_SIGMAS: f64 = 3.0;

/// Least and greatest `j_wt`, mm, with every scatter at its limits, and by the root sum of squares. `None` where a pair there is jammed,
/// out of mesh or none. Where the assembly phase scatters, each is the least, or the greatest, of all phases.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LimitCases {
    /// Each scatter at its mean, a drawn runout or pitch at 0, and all else as the pair has it.
    pub mean: [Option<f64>; 2],
    /// The least with all at their limits to one side, the greatest with all to the other.
    pub worst: [Option<f64>; 2],
    /// `j − √(Σ Δ_i²)` and `j + √(Σ Δ_i²)`: `Δ_i` what each alone changes of the mean's, of the least at its limit towards less backlash, of
    /// the greatest at that towards more.
    pub root_sum_of_squares: [Option<f64>; 2],
}

/// A quantity at a limit, all others at their mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Alone {
    Thickness(Member),
    Runout(Member),
    Pitch(Member),
    PerTooth(Member),
    Distance,
    Play,
}

const EACH: [Alone; 10] = [
    Alone::Thickness(Member::Wheel),
    Alone::Thickness(Member::Pinion),
    Alone::Runout(Member::Wheel),
    Alone::Runout(Member::Pinion),
    Alone::Pitch(Member::Wheel),
    Alone::Pitch(Member::Pinion),
    Alone::PerTooth(Member::Wheel),
    Alone::PerTooth(Member::Pinion),
    Alone::Distance,
    Alone::Play,
];

/// Towards less or more backlash.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Towards {
    Less,
    More,
}

/// Both, of `population`; `None` where whole gears are drawn, which have no limits.
///
/// An assembly phase has no limits. Where it scatters, each case covers all gcd(z_1, z_2) phases. Its least and its greatest may come
/// from different phases.
///
/// Distributions without an end are cut at their limits ([`Scatter::limits`]). A runout is in its worst direction. Pitch is a list of
/// numbers that close on the circle: the flanks in contact are taken [`PITCH_LIMIT_SIGMAS`] standard deviations of a cumulative
/// deviation out, or in, on both sides of both gears. For `z` closed single deviations of standard deviation `σ` about their mean, that deviation is
///
/// ```text
/// σ_F² = (z + 1)/12 σ²
/// ```
///
/// as `f_i = g_i − mean(g)` with `σ_g² = σ² z/(z − 1)` makes `F_i = Σ_j c(i − j) g_j`, `c(m) = (z − 1)/(2z) − m/z` at `m = 0 … z − 1`, and
/// `Σ c² = (z² − 1)/(12 z)`.
///
/// # Errors
/// As [`Assembly::outcome`].
pub fn limit_cases(population: &Population) -> Result<Option<LimitCases>, Error> {
    let scatters = population.scatters();
    let members = Member::BOTH;
    if members
        .iter()
        .any(|&member| scatters.of(member).gears.is_some())
    {
        return Ok(None);
    }
    let both = |of: &dyn Fn(Alone) -> bool| {
        let less = case(population, of, Towards::Less)?.0;
        Ok::<_, Error>([less, case(population, of, Towards::More)?.1])
    };
    let mean = both(&|_| false)?;
    let mut squares = [Some(0.0); 2];
    let mut thickness = [[Some(0.0); 2]; 2];
    for alone in EACH.into_iter().filter(|alone| alone.scatters(scatters)) {
        let moved = both(&|one| one == alone)?;
        for end in 0..2 {
            let change = moved[end].zip(mean[end]).map(|(moved, mean)| moved - mean);
            if let Alone::Thickness(member) = alone {
                thickness[usize::from(member == Member::Pinion)][end] = change;
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

impl Alone {
    fn scatters(self, scatters: &Scatters) -> bool {
        match self {
            Alone::Thickness(member) => scatters.of(member).thickness.is_some(),
            Alone::Runout(member) => scatters.of(member).runout.is_some(),
            Alone::Pitch(member) => scatters.of(member).pitch.is_some(),
            Alone::PerTooth(member) => scatters.of(member).per_tooth.is_some(),
            Alone::Distance => scatters.center_distance.is_some(),
            Alone::Play => scatters.bearing_play.is_some(),
        }
    }
}

/// Least and greatest with the quantities that `at_limit` says at their limit, all else at its mean, over the phases there may be.
fn case(
    population: &Population,
    at_limit: &dyn Fn(Alone) -> bool,
    towards: Towards,
) -> Result<(Option<f64>, Option<f64>), Error> {
    let assembly = match assembly(population, at_limit, towards) {
        Ok(assembly) => assembly,
        // As a draw that is no gear: there is no such case.
        Err(_) => return Ok((None, None)),
    };
    let pair = assembly.pair();
    let phases = if population.scatters().phase && phases_differ(pair) {
        (1..=phase_count(pair)).collect()
    } else {
        vec![assembly.phase()]
    };
    let each = parallel::map(phases, |phase| assembly.in_phase(phase).outcome());
    let each = each.into_iter().collect::<Result<Vec<_>, _>>()?;
    // A phase in which there is none leaves nothing that holds of all.
    let least = each.iter().map(|found| found.least);
    let least = least.reduce(|one, other| Some(one?.min(other?)));
    let greatest = each.iter().map(|found| found.greatest);
    let greatest = greatest.reduce(|one, other| Some(one?.max(other?)));
    Ok((least.flatten(), greatest.flatten()))
}

fn assembly(
    population: &Population,
    at_limit: &dyn Fn(Alone) -> bool,
    towards: Towards,
) -> Result<Assembly, GearError> {
    let (pair, scatters) = (population.pair(), population.scatters());
    // More material is less backlash, more distance more of it.
    let [less, more] = match towards {
        Towards::Less => [1, 0],
        Towards::More => [0, 1],
    };
    let of = |scatter: &Option<Scatter>, alone: Alone, side: usize| match scatter {
        None => 0.0,
        Some(scatter) if at_limit(alone) => scatter.limits()[side],
        Some(scatter) => scatter.mean(),
    };
    let gear = |member: Member| {
        let (own, scatter) = (pair.gear(member), scatters.of(member));
        let thicker = of(&scatter.thickness, Alone::Thickness(member), less);
        let each = of(&scatter.per_tooth, Alone::PerTooth(member), less);
        let pitch = if at_limit(Alone::Pitch(member)) {
            pitch_limit(scatter, own) * if towards == Towards::Less { 1.0 } else { -1.0 }
        } else {
            0.0
        };
        let teeth = own.gear().basic_data().teeth() as usize;
        let further = Deviations {
            per_tooth: if each + pitch == 0.0 {
                Vec::new()
            } else {
                vec![each + pitch; teeth]
            },
            ..Deviations::default()
        };
        let gear = own.varied(thicker, &further)?;
        match &scatter.runout {
            Some(runout) if at_limit(Alone::Runout(member)) => {
                gear.with_runout_of_any_direction(0.5 * runout.limits()[1])
            }
            Some(_) => gear.with_runout(0.0, 1.0),
            None => Ok(gear),
        }
    };
    let farther = of(&scatters.center_distance, Alone::Distance, more);
    let distance = pair.center_distance() + farther;
    let (wheel, pinion) = (gear(Member::Wheel)?, gear(Member::Pinion)?);
    let play = match &scatters.bearing_play {
        Some(play) if at_limit(Alone::Play) => play.limits()[1],
        Some(play) => play.mean(),
        None => population.clearance(),
    };
    let pair = pair.with_gears(wheel, pinion, distance)?;
    Ok(Assembly::new(pair, play, population.phase()))
}

/// Additional thickness of a tooth, mm, with both flanks at the limit of their cumulative pitch deviation.
fn pitch_limit(scatter: &GearScatter, gear: &AsBuilt) -> f64 {
    let z = f64::from(gear.gear().basic_data().teeth());
    let sigma = scatter.pitch.unwrap_or(0.0) * ((z + 1.0) / 12.0).sqrt();
    // An arc of the transverse section; thickness is that of the normal one.
    2.0 * PITCH_LIMIT_SIGMAS * sigma * gear.gear().basic_data().helix_cos()
}
