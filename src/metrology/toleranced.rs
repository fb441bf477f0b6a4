//! One value, or one at least and one at most material.

/// What is stated of a toleranced quantity, and what follows from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Toleranced<T> {
    /// A single value.
    Single(T),
    /// Thinnest and thickest teeth.
    Band {
        /// At least material.
        least: T,
        /// At most material.
        most: T,
    },
}

impl<T> Toleranced<T> {
    /// The value at most material.
    pub fn most(&self) -> &T {
        match self {
            Toleranced::Single(value) | Toleranced::Band { most: value, .. } => value,
        }
    }

    /// The value at least material.
    pub fn least(&self) -> &T {
        match self {
            Toleranced::Single(value) | Toleranced::Band { least: value, .. } => value,
        }
    }

    /// Whether it has two values.
    pub fn is_band(&self) -> bool {
        matches!(self, Toleranced::Band { .. })
    }

    /// `make` of each value, most material first; the first error ends it.
    ///
    /// # Errors
    /// Those of `make`.
    pub fn try_map<U, E>(
        &self,
        mut make: impl FnMut(&T) -> Result<U, E>,
    ) -> Result<Toleranced<U>, E> {
        Ok(match self {
            Toleranced::Single(value) => Toleranced::Single(make(value)?),
            Toleranced::Band { least, most } => {
                let most = make(most)?;
                Toleranced::Band {
                    least: make(least)?,
                    most,
                }
            }
        })
    }
}
