//! Charts as SVG: curves over the teeth, over the centre distance, and bars per tooth.
//!
//! Drawn with the kit that all pictures share, on the `svg` crate.
//!
//! Colours are Okabe and Ito's. Right flanks are solid and dark, left flanks dashed, so that they are distinguished in black and
//! white, too. The same input gives the same bytes. All ids of a chart start with its prefix, so that one page can hold several.

mod bars;
mod captions;
mod difference;
mod distance;
mod field;
mod inspection;
mod labels;
mod marks;
mod panel;
pub(crate) mod population;
mod revolution;
mod sheet;
mod thin;

pub use crate::kit::Plot;
pub use bars::{BarPanel, BarSeries, Limits, bar_panels, curve};
pub use difference::difference;
pub use distance::distance;
pub use field::{field, field_at_least};
pub use inspection::{inspection, inspection_and_leads, leads, profiles};
pub use panel::Look;
pub use revolution::revolution;
pub use sheet::{Chart, Heading, PictureError};
