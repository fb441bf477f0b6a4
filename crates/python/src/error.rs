//! Errors as Python exceptions. `gearlash._errors` defines them; the text is the command's.

use gearlash_files::InputError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyTuple, PyType};

/// A class of `gearlash._errors`.
fn class<'py>(py: Python<'py>, name: &'static str) -> PyResult<Bound<'py, PyType>> {
    static MODULE: PyOnceLock<Py<PyModule>> = PyOnceLock::new();
    let module = MODULE.get_or_try_init(py, || py.import("gearlash._errors").map(Bound::unbind))?;
    Ok(module.bind(py).getattr(name)?.cast_into()?)
}

/// `GearlashError` with this text.
pub fn error(py: Python<'_>, text: impl ToString) -> PyErr {
    match class(py, "GearlashError") {
        Ok(class) => PyErr::from_type(class, text.to_string()),
        Err(error) => error,
    }
}

/// `InputError` with its problems: key, value as written, reason, remedy.
pub fn input(py: Python<'_>, error: &InputError) -> PyErr {
    let made = || {
        let problems = error.problems.iter().map(|problem| {
            let value = problem.value.as_deref();
            (&problem.key, value, &problem.reason, &problem.help)
        });
        let problems = PyTuple::new(py, problems)?;
        Ok::<_, PyErr>(PyErr::from_type(
            class(py, "InputError")?,
            (error.to_string(), problems.unbind()),
        ))
    };
    made().unwrap_or_else(|error| error)
}
