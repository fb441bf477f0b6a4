//! Shapes that teeth of a gear share.

/// The different shapes of a gear's teeth, and the shape of each tooth.
#[derive(Debug, Clone, PartialEq)]
pub struct ByTooth<T> {
    shapes: Vec<T>,
    /// Index of each tooth's shape, tooth 1 first; empty: all teeth have the first shape.
    of_tooth: Vec<usize>,
}

impl<T> ByTooth<T> {
    /// One shape of all teeth.
    pub(super) fn same(shape: T) -> ByTooth<T> {
        ByTooth {
            shapes: vec![shape],
            of_tooth: Vec::new(),
        }
    }

    /// These shapes, and the index of each tooth's shape, tooth 1 first.
    pub(super) fn new(shapes: Vec<T>, of_tooth: Vec<usize>) -> ByTooth<T> {
        ByTooth { shapes, of_tooth }
    }

    /// The different shapes.
    pub fn shapes(&self) -> &[T] {
        &self.shapes
    }

    /// Index of a tooth's shape. `tooth` counts from 1.
    pub(super) fn shape_of(&self, tooth: u32) -> usize {
        let shape = self.of_tooth.get(tooth as usize - 1);
        shape.copied().unwrap_or(0)
    }

    /// A tooth's shape. `tooth` counts from 1.
    pub fn of(&self, tooth: u32) -> &T {
        &self.shapes[self.shape_of(tooth)]
    }

    /// Every shape changed by `change`.
    pub(super) fn map<U>(&self, change: impl FnMut(&T) -> U) -> ByTooth<U> {
        ByTooth::new(
            self.shapes.iter().map(change).collect(),
            self.of_tooth.clone(),
        )
    }

    /// Every shape changed by `change`, or the first error.
    ///
    /// # Errors
    /// As `change`.
    pub(super) fn try_map<U, E>(
        &self,
        change: impl FnMut(&T) -> Result<U, E>,
    ) -> Result<ByTooth<U>, E> {
        let shapes = self.shapes.iter().map(change).collect::<Result<_, _>>()?;
        Ok(ByTooth::new(shapes, self.of_tooth.clone()))
    }
}
