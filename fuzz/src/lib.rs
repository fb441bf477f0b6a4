//! What the fuzz targets share.

pub mod folder;
pub mod pose;
pub mod table;
