//! The tangential coefficient of restitution over arrays.

use carom::impact::RingImpact;
use carom::impact::oblique::Groups;
use carom::impact::restitution::{
    DissimilarGroups, DissimilarMethod, DissimilarRestitution, DissimilarTable, RestitutionError,
    RestitutionTable, of_dissimilar, with_normal_restitution,
};
use carom::laws::friction::Friction;
use carom::special::RangeError;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::arrays::{Numbers, map_by, of_three, same_length};
use crate::error::Fault;
use crate::records::arrays;

/// Entries that a thread takes at least: an impact by rings takes milliseconds.
const SHARE: usize = 16;
/// What the table of alike spheres is within.
const ALIKE: f64 = 1e-8;

/// The bytes of the tables of R_x of alike bodies, with a loss, and of dissimilar ones.
#[pyfunction]
pub(crate) fn restitution_tables(py: Python<'_>) -> [Bound<'_, PyBytes>; 3] {
    let alike = RestitutionTable::shared().to_bytes();
    [&alike, RestitutionTable::stored_losses(), DissimilarTable::as_bytes()]
        .map(|bytes| PyBytes::new(py, bytes))
}

/// R_x of solid spheres.
#[pyfunction]
pub(crate) fn restitution<'py>(
    py: Python<'py>,
    kappa: Numbers<'py>,
    lambda: Numbers<'py>,
    normal: Numbers<'py>,
    exact: bool,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    of_three(py, [&kappa, &lambda, &normal], answer(exact, Groups::of_spheres))
}

/// R_x of any bodies whose normal and tangential motions are uncoupled.
#[pyfunction]
pub(crate) fn restitution_of_groups<'py>(
    py: Python<'py>,
    chi: Numbers<'py>,
    psi: Numbers<'py>,
    normal: Numbers<'py>,
    exact: bool,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    of_three(py, [&chi, &psi, &normal], answer(exact, Groups::new))
}

type MakeGroups = fn(f64, f64) -> Result<Groups, RangeError>;

/// R_x with a restitution e along the normal.
fn answer(exact: bool, groups: MakeGroups) -> impl Fn(f64, f64, f64) -> Result<f64, Fault> {
    let table = RestitutionTable::shared();
    move |x, y, e| {
        let groups = groups(x, y)?;
        let allowed = "from 0 to 1";
        RangeError::check("normal_restitution", e, (0.0..=1.0).contains(&e), allowed)?;
        match exact {
            true => with_normal_restitution(groups, e).map_err(|error| match error {
                RestitutionError::Range(error) => error.into(),
                RestitutionError::Oblique(error) => error.into(),
            }),
            false => Ok(table.restitution_with(groups, e)?),
        }
    }
}

/// R_x of spheres of dissimilar materials, how it was found and how far it may be off.
#[pyfunction]
pub(crate) fn restitution_of_dissimilar<'py>(
    py: Python<'py>,
    numbers: [Numbers<'py>; 5],
    exact: bool,
) -> PyResult<Bound<'py, PyDict>> {
    let [kappa, lambda, gamma, friction, ratio] = &numbers;
    let [kappa, lambda, gamma, friction, ratio] = [
        kappa.as_slice()?,
        lambda.as_slice()?,
        gamma.as_slice()?,
        friction.as_slice()?,
        ratio.as_slice()?,
    ];
    for other in [lambda, gamma, friction, ratio] {
        same_length("an argument", other.len(), kappa.len())?;
    }
    let found = map_by(SHARE, py, kappa.len(), |i| {
        let friction = Friction::new(friction[i])?;
        let groups = DissimilarGroups::new(kappa[i], gamma[i], friction, lambda[i], ratio[i])?;
        if exact {
            return Ok(of_dissimilar(&groups, RingImpact::TOLERANCE)?);
        }
        if gamma[i] == 0.0 && friction != Friction::NONE {
            return of_alike(Groups::new(ratio[i] / kappa[i], lambda[i] / kappa[i])?);
        }
        Ok(DissimilarTable::shared().restitution(&groups)?)
    })?;
    arrays(py, DissimilarRestitution::COLUMNS, &found)
}

/// By the table of alike bodies.
fn of_alike(groups: Groups) -> Result<DissimilarRestitution, Fault> {
    let r_x = RestitutionTable::shared().restitution(groups)?;
    let method = DissimilarMethod::Table;
    Ok(DissimilarRestitution { r_x, method, error_estimate: ALIKE })
}
