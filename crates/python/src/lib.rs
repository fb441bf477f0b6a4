//! The extension module `gearlash._core`: one function per call of the Python package.
//!
//! Python's side (`python/gearlash/`) has the classes, their types and their documentation; here are the conversions. Gears and
//! pairs are made from text with the keys of gear and pair files. Every value is thus checked, and rejected with the same words,
//! as in a file. Arrays become numpy arrays; one pose, or one gear's readings, become the JSON of the command's results. The
//! interpreter's lock is released while the library works.

mod call;
mod command;
mod error;
mod extremes;
mod gauge;
mod gear;
mod pair;
mod pictures;
mod population;
mod poses;

/// The Rust side of the package gearlash.
#[pyo3::pymodule]
mod _core {
    use gearlash::contact::Status;
    use gearlash::population::OutcomeKind;
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::extremes::{check, extremes};
    #[pymodule_export]
    use super::pictures::{field, inspection, over_distance, over_teeth, snapshot};
    #[pymodule_export]
    use super::population::{match_cells, match_result, rows_columns};
    #[pymodule_export]
    use super::population::{tolerance_assemblies, tolerance_result, tolerance_rows};
    #[pymodule_export]
    use super::poses::{lost_motion, lost_motions, revolution};
    #[pymodule_export]
    use super::{command::run, gauge::gauge, gear::Gear, pair::Pair};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        module.add("STATUSES", Status::ALL.map(Status::name))?;
        module.add("OUTCOMES", OutcomeKind::ALL.map(OutcomeKind::name))
    }
}
