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

use pyo3::prelude::*;

/// The Rust side of the package gearlash.
#[pymodule]
fn _core(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add(
        "STATUSES",
        gearlash::contact::Status::ALL.map(|status| status.name()),
    )?;
    module.add_class::<gear::Gear>()?;
    module.add_class::<pair::Pair>()?;
    module.add_function(wrap_pyfunction!(command::run, module)?)?;
    module.add_function(wrap_pyfunction!(poses::lost_motion, module)?)?;
    module.add_function(wrap_pyfunction!(poses::lost_motions, module)?)?;
    module.add_function(wrap_pyfunction!(poses::revolution, module)?)?;
    module.add_function(wrap_pyfunction!(extremes::extremes, module)?)?;
    module.add_function(wrap_pyfunction!(extremes::check, module)?)?;
    module.add_function(wrap_pyfunction!(gauge::gauge, module)?)?;
    module.add(
        "OUTCOMES",
        gearlash::population::OutcomeKind::ALL.map(|kind| kind.name()),
    )?;
    module.add_function(wrap_pyfunction!(population::tolerance_assemblies, module)?)?;
    module.add_function(wrap_pyfunction!(population::tolerance_rows, module)?)?;
    module.add_function(wrap_pyfunction!(population::rows_columns, module)?)?;
    module.add_function(wrap_pyfunction!(population::tolerance_result, module)?)?;
    module.add_function(wrap_pyfunction!(population::match_cells, module)?)?;
    module.add_function(wrap_pyfunction!(population::match_result, module)?)?;
    module.add_function(wrap_pyfunction!(pictures::snapshot, module)?)?;
    module.add_function(wrap_pyfunction!(pictures::over_teeth, module)?)?;
    module.add_function(wrap_pyfunction!(pictures::over_distance, module)?)?;
    module.add_function(wrap_pyfunction!(pictures::inspection, module)?)?;
    Ok(())
}
