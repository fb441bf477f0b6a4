//! Errors as Python exceptions. `gearlash._errors` defines them; the text is the command's.

use gearlash_text::InputError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyTuple, PyType};
use std::any::Any;
use std::fmt::Display;

/// The exception of a call without a result.
pub struct Failure(PyErr);

/// The result of a call.
pub type Outcome<T> = Result<T, Failure>;

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> PyErr {
        failure.0
    }
}

/// An exception stays; an [`InputError`] keeps its problems; any other error becomes `GearlashError` with its text.
impl<E: Display + Any> From<E> for Failure {
    fn from(error: E) -> Failure {
        let (text, any): (String, &dyn Any) = (error.to_string(), &error);
        let exception = |py: Python<'_>| match any.downcast_ref::<InputError>() {
            None => Ok(PyErr::from_type(class(py, "GearlashError")?, text)),
            Some(input) => {
                let problems = input.problems.iter().map(|problem| {
                    let value = problem.value.as_deref();
                    (&problem.key, value, &problem.reason, &problem.help)
                });
                let problems = PyTuple::new(py, problems)?.unbind();
                let class = class(py, "InputError")?;
                Ok(PyErr::from_type(class, (text, problems)))
            }
        };
        Failure(Python::attach(|py| match any.downcast_ref::<PyErr>() {
            Some(raised) => raised.clone_ref(py),
            None => exception(py).unwrap_or_else(|raised: PyErr| raised),
        }))
    }
}

/// A class of `gearlash._errors`.
fn class<'py>(py: Python<'py>, name: &'static str) -> PyResult<Bound<'py, PyType>> {
    static MODULE: PyOnceLock<Py<PyModule>> = PyOnceLock::new();
    let module = MODULE.get_or_try_init(py, || py.import("gearlash._errors").map(Bound::unbind))?;
    Ok(module.bind(py).getattr(name)?.cast_into()?)
}
