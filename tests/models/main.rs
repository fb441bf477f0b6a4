//! The analytic models: published tables, closed forms, properties of random pairs.

mod analytic;
#[path = "../common/mod.rs"]
mod common;
mod deviating;
mod examples;
mod helical;
#[path = "../common/helical_dimensions.rs"]
mod helical_dimensions;
mod karba;
mod limits;
mod line_of_action;
mod properties;
mod published;
mod rack_positions;
