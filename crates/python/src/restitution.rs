//! The tangential coefficient of restitution over arrays.

use carom::impact::oblique::{Groups, ObliqueImpact};
use carom::impact::restitution::RestitutionTable;
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::arrays::{Numbers, of_two};
use crate::error::Fault;

/// R_x of solid spheres.
#[pyfunction]
pub(crate) fn restitution<'py>(
    py: Python<'py>,
    kappa: Numbers<'py>,
    lambda: Numbers<'py>,
    exact: bool,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    of_two(py, &kappa, &lambda, answer(exact, Groups::of_spheres))
}

/// R_x of any bodies whose normal and tangential motions are uncoupled.
#[pyfunction]
pub(crate) fn restitution_of_groups<'py>(
    py: Python<'py>,
    chi: Numbers<'py>,
    psi: Numbers<'py>,
    exact: bool,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    of_two(py, &chi, &psi, answer(exact, Groups::new))
}

type MakeGroups = fn(f64, f64) -> Result<Groups, carom::prelude::RangeError>;

fn answer(exact: bool, groups: MakeGroups) -> impl Fn(f64, f64) -> Result<f64, Fault> {
    let table = RestitutionTable::shared();
    move |x, y| {
        let groups = groups(x, y)?;
        match exact {
            true => Ok(ObliqueImpact::new(groups)?.restitution()),
            false => Ok(table.restitution(groups)?),
        }
    }
}
