//! Pictures of a population.

use crate::chart::{Chart, Heading, PictureError, population};
use gearlash_files::tolerance::{ToleranceResult, shares};

/// Pictures of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Pictures {
    /// Histogram with limits; `None` where no assembly has a backlash.
    pub histogram: Option<Chart>,
    /// The share outside the requirement over the number of assemblies.
    pub convergence: Chart,
    /// Contributions to the extreme that the requirement limits first; `None` where none were computed.
    pub contributions: Option<Chart>,
}

/// The pictures of `result`.
///
/// # Errors
/// None for a run of at least one assembly.
pub fn pictures(result: &ToleranceResult) -> Result<Pictures, PictureError> {
    let about = &result.about;
    // The contributions are a picture of their own.
    let first = shares(result);
    let heading = |prefix| Heading {
        prefix,
        title: &about.title,
        subtitle: &first,
    };
    let least = about.min_mm.is_some() || about.others.iter().any(|one| one.min.is_some());
    let most = about.max_mm.is_some() || about.others.iter().any(|one| one.max.is_some());
    let greatest = !least && most;
    let found = &result.contributions[usize::from(greatest)];
    let of = ["least", "greatest"][usize::from(greatest)];
    let subtitle = format!("What the spread of the {of} backlash comes from");
    let contributions = Heading {
        subtitle: &subtitle,
        ..heading("contributions")
    };
    Ok(Pictures {
        histogram: population::histogram(&heading("histogram"), result).ok(),
        convergence: population::convergence(&heading("convergence"), &result.convergence())?,
        contributions: population::contributions(&contributions, found).ok(),
    })
}
