//! Shared code of the fuzz targets.

pub mod folder;
pub mod pose;
pub mod table;
