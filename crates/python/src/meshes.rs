//! Surfaces of triangles.

use carom::geometry::mesh::{self, MeshError, Search};
use carom::prelude::RangeError;
use carom::special::interrupt::is_wanted;
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::prelude::*;

use crate::arrays::Rows;
use crate::error::Fault;
use crate::threads::without_python;

/// Balls between two questions for an interrupt.
const SHARE: usize = 16;
/// Numbers of a place: point, normal, distance.
const EACH: usize = 7;

/// Numbers of all places; ball, part, and whether it is sharp, of each.
type Places<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<i64>>);

impl From<MeshError> for Fault {
    fn from(error: MeshError) -> Self {
        let of = |field, value, allowed| Self::from(RangeError::new(field, value, allowed));
        match error {
            MeshError::Range(error) => error.into(),
            MeshError::NotFinite { number } => {
                of("triangles", f64::NAN, "finite and below 1e50").at(number - 1)
            }
            MeshError::NoArea { number } => of("area of a triangle", 0.0, "> 0").at(number - 1),
            MeshError::TooLong { axis, period, .. } => {
                of("period", period, "at least the length of the surface").at(axis)
            }
            MeshError::Interrupted => Self::interrupted(),
        }
    }
}

/// A surface of triangles, which places of balls are searched on.
#[pyclass(frozen, module = "carom._carom")]
#[derive(Debug)]
pub(crate) struct TriangleMesh(mesh::TriangleMesh);

#[pymethods]
impl TriangleMesh {
    /// Rows of `triangles` are corners, three for each.
    #[new]
    fn new(py: Python<'_>, triangles: Rows<'_>, smooth: f64, periods: [f64; 3]) -> PyResult<Self> {
        let triangles = triangles.as_slice()?.as_chunks().0.as_chunks().0;
        let made = || mesh::TriangleMesh::new(triangles, smooth, periods);
        Ok(Self(without_python(py, made)?.map_err(Fault::from)?))
    }

    /// The places where balls touch it; a row of `balls` has the centre and the radius.
    fn places<'py>(&self, py: Python<'py>, balls: Rows<'py>) -> PyResult<Places<'py>> {
        let balls: &[[f64; 4]] = balls.as_slice()?.as_chunks().0;
        let (numbers, words) = without_python(py, || self.all(balls))??;
        let rows = words.len() / 3;
        Ok((
            PyArray1::from_vec(py, numbers).reshape([rows, EACH])?,
            PyArray1::from_vec(py, words).reshape([rows, 3])?,
        ))
    }
}

impl TriangleMesh {
    fn all(&self, balls: &[[f64; 4]]) -> Result<(Vec<f64>, Vec<i64>), Fault> {
        let (mut numbers, mut words, mut search) = (Vec::new(), Vec::new(), Search::default());
        for (i, [x, y, z, radius]) in balls.iter().enumerate() {
            if i.is_multiple_of(SHARE) && is_wanted() {
                return Err(Fault::interrupted());
            }
            let found = self.0.places([*x, *y, *z].into(), *radius, &mut search);
            for place in found.map_err(|error| Fault::from(error).at(i))? {
                numbers.extend(place.point.iter().chain(place.normal.iter()));
                numbers.push(place.distance);
                words.extend([i as i64, place.part as i64, place.is_sharp.into()]);
            }
        }
        Ok((numbers, words))
    }
}
