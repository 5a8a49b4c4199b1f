//! Tractions and displacements on all cells of a grid.

use super::OperatorError;

/// A component of a traction or displacement: along x, along y, or normal to the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Axis {
    /// Along x: traction x, displacement u.
    X,
    /// Along y: traction y, displacement v.
    Y,
    /// Normal: pressure, displacement w.
    Normal,
}

impl Axis {
    /// All three, in the order of the coefficients' rows and columns.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Normal];

    pub(crate) const fn traction_name(self) -> &'static str {
        match self {
            Self::X => "traction x",
            Self::Y => "traction y",
            Self::Normal => "pressure",
        }
    }

    pub(crate) const fn displacement_name(self) -> &'static str {
        match self {
            Self::X => "displacement u",
            Self::Y => "displacement v",
            Self::Normal => "displacement w",
        }
    }
}

/// The tractions on the cells of a grid; `None` means zero.
#[derive(Debug, Clone, Copy, Default)]
pub struct TractionField<'a> {
    /// Along x.
    pub x: Option<&'a [f64]>,
    /// Along y.
    pub y: Option<&'a [f64]>,
    /// The pressure.
    pub normal: Option<&'a [f64]>,
}

impl<'a> TractionField<'a> {
    /// Pressure only.
    #[must_use]
    pub const fn normal(pressure: &'a [f64]) -> Self {
        Self { x: None, y: None, normal: Some(pressure) }
    }

    /// Tangential tractions only.
    #[must_use]
    pub const fn tangential(x: &'a [f64], y: &'a [f64]) -> Self {
        Self { x: Some(x), y: Some(y), normal: None }
    }

    /// Tangential tractions and pressure.
    #[must_use]
    pub const fn full(x: &'a [f64], y: &'a [f64], pressure: &'a [f64]) -> Self {
        Self { x: Some(x), y: Some(y), normal: Some(pressure) }
    }

    pub(crate) fn by_axis(&self) -> [Option<&'a [f64]>; 3] {
        [self.x, self.y, self.normal]
    }

    /// Checks that every given field has `cells` finite values.
    pub(crate) fn check(&self, cells: usize) -> Result<(), OperatorError> {
        for (axis, values) in Axis::ALL.into_iter().zip(self.by_axis()) {
            let Some(values) = values else { continue };
            check_length(axis.traction_name(), values.len(), cells)?;
            if !all_finite(values) {
                return Err(first_not_finite(axis.traction_name(), values));
            }
        }
        Ok(())
    }
}

/// The displacements of the cells of a grid to be computed; `None` means not requested.
#[derive(Debug, Default)]
pub struct DisplacementField<'a> {
    /// Along x.
    pub u: Option<&'a mut [f64]>,
    /// Along y.
    pub v: Option<&'a mut [f64]>,
    /// Normal.
    pub w: Option<&'a mut [f64]>,
}

impl<'a> DisplacementField<'a> {
    /// The normal displacement only.
    #[must_use]
    pub const fn normal(w: &'a mut [f64]) -> Self {
        Self { u: None, v: None, w: Some(w) }
    }

    /// The tangential displacements only.
    #[must_use]
    pub const fn tangential(u: &'a mut [f64], v: &'a mut [f64]) -> Self {
        Self { u: Some(u), v: Some(v), w: None }
    }

    /// All three components.
    #[must_use]
    pub const fn full(u: &'a mut [f64], v: &'a mut [f64], w: &'a mut [f64]) -> Self {
        Self { u: Some(u), v: Some(v), w: Some(w) }
    }

    pub(crate) fn by_axis(self) -> [Option<&'a mut [f64]>; 3] {
        [self.u, self.v, self.w]
    }

    /// Checks that every requested field has `cells` values.
    pub(crate) fn check(&self, cells: usize) -> Result<(), OperatorError> {
        for (axis, values) in Axis::ALL.into_iter().zip([&self.u, &self.v, &self.w]) {
            if let Some(values) = values {
                check_length(axis.displacement_name(), values.len(), cells)?;
            }
        }
        Ok(())
    }
}

fn check_length(field: &'static str, found: usize, expected: usize) -> Result<(), OperatorError> {
    if found != expected {
        return Err(OperatorError::Length { field, found, expected });
    }
    Ok(())
}

/// A finite number times zero is zero. Blocks without branches let the compiler vectorise.
fn all_finite(values: &[f64]) -> bool {
    let mut chunks = values.chunks_exact(8);
    let mut sums = [0.0f64; 8];
    for chunk in &mut chunks {
        for (sum, value) in sums.iter_mut().zip(chunk) {
            *sum += value * 0.0;
        }
    }
    sums.iter().all(|sum| *sum == 0.0) && chunks.remainder().iter().all(|v| v.is_finite())
}

#[cold]
fn first_not_finite(field: &'static str, values: &[f64]) -> OperatorError {
    let index = values.iter().position(|value| !value.is_finite()).unwrap_or(0);
    OperatorError::NotFinite { field, index, value: values[index] }
}
