//! Stresses in a body below a contact.

use carom::halfspace::{Point, Traction};
use carom::laws::field::partial_slip_stress;
use carom::laws::validity::PressureLimits;
use carom::prelude::ContactEllipse;
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::prelude::*;

use crate::arrays::{Numbers, map, same_length};
use crate::error::Fault;
use crate::materials::Material;
use crate::quantities::{In, Row, arguments};
use crate::told::{Told, of_contact};

arguments! {
    Pressure "pressure" "Pa",
    SemiAxes "semi_axes" "m",
    StickRadius "stick_radius" "",
    SurfaceTraction "traction" "Pa",
}

/// The stress (xx, yy, zz, xy, yz, zx) at points of a body, an array (n, 6), and warnings.
#[pyfunction]
#[allow(clippy::too_many_arguments)] // named ones, in Python
pub(crate) fn stress<'py>(
    py: Python<'py>,
    semi_axes: Row<SemiAxes, 2>,
    material: Material,
    pressure: In<Pressure>,
    traction: Row<SurfaceTraction, 2>,
    stick_radius: In<StickRadius>,
    x: Numbers<'py>,
    y: Numbers<'py>,
    z: Numbers<'py>,
) -> PyResult<(Bound<'py, PyArray2<f64>>, Told)> {
    let [a, b] = semi_axes.0;
    let ellipse = ContactEllipse::new(a, b).map_err(Fault::from)?;
    let peak = Traction { x: traction.0[0], y: traction.0[1], normal: pressure.0 };
    let (x, y, z) = (x.as_slice()?, y.as_slice()?, z.as_slice()?);
    same_length("y", y.len(), x.len())?;
    same_length("z", z.len(), x.len())?;
    let stresses = map(py, x.len(), |i| {
        let at = Point { x: x[i], y: y[i], z: z[i] };
        let s = partial_slip_stress(ellipse, material.0, peak, stick_radius.0, at)?;
        Ok([s.xx, s.yy, s.zz, s.xy, s.yz, s.zx])
    })?;
    let stresses = PyArray1::from_vec(py, stresses.into_iter().flatten().collect());
    let told = of_contact(PressureLimits::of_body(&material.0).validity(pressure.0));
    Ok((stresses.reshape([x.len(), 6])?, told))
}
