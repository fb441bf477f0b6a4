//! The readings as charts, one a gauge: what each tooth reads less the mean.
//!
//! Each says what gear it is of, how its teeth are numbered, where its zero stands, and, where there is an accuracy
//! grade, between which lines that grade wants the values.

mod bars;
mod deviations;
mod lengths;
mod roll;

use crate::error::PictureError;
use gearlash_files::results::gauge::GaugedGear;

/// The charts of one gear: file name and SVG. What could not be measured has none.
///
/// # Errors
/// [`PictureError`]: none for a gear that has teeth.
pub fn charts(gauged: &GaugedGear) -> Result<Vec<(String, String)>, PictureError> {
    let mut files = lengths::charts(gauged)?;
    files.extend(deviations::charts(gauged)?);
    files.extend(roll::chart(gauged)?);
    Ok(files)
}
