//! Creep coefficients and the forces of FASTSIM over arrays.

use carom::laws::creep::CreepCoefficients;
use carom::laws::creep::force::{CreepContact, CreepForce, CreepShape};
use carom::rolling::{Creepage, Fastsim, FastsimForces};
use carom::special::RangeError;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{Numbers, map, map_by, same_length};
use crate::error::Fault;
use crate::hertz::Hertz;
use crate::records::arrays;
use crate::told::{Told, of_loads};

/// Entries that a thread takes at least: the springs of a contact take a tenth of a millisecond.
const SHARE: usize = 4;
/// Forces from which on the table of their shape is made first; the bits are the same.
const MANY: usize = 400;

/// Kalker's creep coefficients by the table.
#[pyfunction]
pub(crate) fn creep_coefficients<'py>(
    py: Python<'py>,
    axis_ratio: Numbers<'py>,
    poisson: Numbers<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let (ratio, poisson) = (axis_ratio.as_slice()?, poisson.as_slice()?);
    same_length("poisson", poisson.len(), ratio.len())?;
    let found = map(py, ratio.len(), |i| Ok(CreepCoefficients::by_table(ratio[i], poisson[i])?))?;
    arrays(py, CreepCoefficients::COLUMNS, &found)
}

/// Forces by the table of creep forces in a Hertz contact, and warnings: for friction, normal force, and creepage along, across and
/// by spin.
#[pyfunction]
pub(crate) fn creep_force<'py>(
    py: Python<'py>,
    contact: Hertz,
    numbers: [Numbers<'py>; 5],
) -> PyResult<(Bound<'py, PyDict>, Told)> {
    let [friction, force, along, across, spin] = lines(&numbers)?;
    let hertz = contact.0;
    let materials = hertz.materials();
    if !materials.is_uncoupled() {
        let text = "contact: the table is for bodies of like materials; carom.roll takes others";
        return Err(PyValueError::new_err(text));
    }
    let constants =
        (hertz.axis_ratio().get(), 2.0 * materials.shear_modulus(), materials.poisson());
    let of_shape = || CreepShape::new(constants.0, constants.1, constants.2);
    let shape = (friction.len() >= MANY).then(of_shape).transpose().map_err(Fault::from)?;
    let found =
        map_by(SHARE, py, friction.len(), |i| {
            let state = hertz.at_force(RangeError::positive("F_z", force[i])?)?;
            let size = (state.ellipse.semi_axis_a() * state.ellipse.semi_axis_b()).sqrt();
            let creepage = [along[i], across[i], spin[i]];
            let found =
                match &shape {
                    Some(shape) => shape.force(size, friction[i], force[i], creepage)?,
                    None => CreepContact::of_size(size, constants.0, constants.1, constants.2)?
                        .force(friction[i], force[i], creepage)?,
                };
            Ok((state, found))
        })?;
    let (states, found): (Vec<_>, Vec<_>) = found.into_iter().unzip();
    Ok((arrays(py, CreepForce::COLUMNS, &found)?, of_loads(&contact, &states)))
}

/// The forces of FASTSIM in a Hertz contact, and warnings: for friction, normal force, and creepage along, across and by spin.
#[pyfunction]
pub(crate) fn fastsim<'py>(
    py: Python<'py>,
    contact: Hertz,
    numbers: [Numbers<'py>; 5],
    mesh: [usize; 2],
) -> PyResult<(Bound<'py, PyDict>, Told)> {
    let [friction, force, along, across, spin] = lines(&numbers)?;
    let hertz = contact.0;
    let materials = hertz.materials();
    let coefficients = CreepCoefficients::by_table(hertz.axis_ratio().get(), materials.poisson())
        .map_err(Fault::from)?;
    let found = map_by(SHARE, py, friction.len(), |i| {
        let state = hertz.at_force(RangeError::positive("F_z", force[i])?)?;
        let ellipse = state.ellipse;
        let springs = Fastsim {
            semi_axes: [ellipse.semi_axis_a(), ellipse.semi_axis_b()],
            shear_modulus: 2.0 * materials.shear_modulus(),
            coefficients,
            force: force[i],
            friction: friction[i],
            mesh,
        };
        let creepage = Creepage { along: along[i], across: across[i], spin: spin[i] };
        Ok((state, springs.forces(creepage)?))
    })?;
    let (states, found): (Vec<_>, Vec<_>) = found.into_iter().unzip();
    Ok((arrays(py, FastsimForces::COLUMNS, &found)?, of_loads(&contact, &states)))
}

/// Five lines of one length.
fn lines<'a>(numbers: &'a [Numbers<'_>; 5]) -> PyResult<[&'a [f64]; 5]> {
    let mut lines: [&[f64]; 5] = [&[]; 5];
    for (line, numbers) in lines.iter_mut().zip(numbers) {
        *line = numbers.as_slice()?;
    }
    for other in &lines[1..] {
        same_length("an argument", other.len(), lines[0].len())?;
    }
    Ok(lines)
}
