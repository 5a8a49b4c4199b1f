//! Hertz contacts.

use carom::laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom::laws::hertz::{Hertz as Contact, HertzState};
use carom::laws::validity::Validity;
use carom::prelude::{ContactStiffness, RangeError};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{Numbers, map};
use crate::error::Fault;
use crate::materials::{MaterialPair, Pair};
use crate::mistakes::needed;
use crate::quantities::{Angle, In, Row, arguments};
use crate::records::arrays;
use crate::show::{self, Quantity, repr};
use crate::told::{Told, of_loads};

arguments! {
    CurvatureA "curvature_a" "1/m",
    CurvatureB "curvature_b" "1/m",
    Radii1 "radii_1" "m",
    Radii2 "radii_2" "m",
    SmallestRadius "smallest_radius" "m",
    Stiffness "stiffness" "N/m**(3/2)",
}

const QUANTITIES: &[Quantity] = &[
    ("materials", "", "of both bodies"),
    ("curvature", "1/m", "coefficients of the gap A x^2 + B y^2"),
    ("axis_ratio", "", "a/b of the contact ellipse"),
    ("smallest_radius", "m", "of curvature of both bodies"),
    ("stiffness", "N/m^1.5", "c_x, c_y, c_z"),
];

/// A Hertz contact before it is loaded: two curvatures and two materials.
///
/// Hertz(materials, curvature_a, curvature_b, smallest_radius=None) has the gap A x^2 + B y^2, A and B in 1/m.
/// Hertz.of_radii and hertz_of_spheres make it from radii; hertz() computes it under load. The smallest radius of
/// curvature of both bodies (m) tells where contacts leave the theory; by default it is that of a body on a plane.
#[pyclass(frozen, eq, from_py_object, module = "carom")]
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hertz(pub(crate) Contact, f64);

/// Contacts are equal if curvatures and materials are; the radii from which they were made do not count.
impl PartialEq for Hertz {
    fn eq(&self, other: &Self) -> bool {
        self.curvature() == other.curvature() && self.0.materials() == other.0.materials()
    }
}

#[pymethods]
impl Hertz {
    /// The contact of two bodies with the gap A x^2 + B y^2; A and B in 1/m.
    #[new]
    #[pyo3(
        signature = (
            materials=None, curvature_a=None, curvature_b=None, smallest_radius=None, **others
        ),
        text_signature = "(materials, curvature_a, curvature_b, smallest_radius=None)"
    )]
    fn new(
        py: Python<'_>,
        materials: Option<Pair>,
        curvature_a: Option<In<CurvatureA>>,
        curvature_b: Option<In<CurvatureB>>,
        smallest_radius: Option<In<SmallestRadius>>,
        others: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        needed!(py, "", others; materials, curvature_a, curvature_b);
        let (a, b) = (curvature_a.0, curvature_b.0);
        let gap = RelativeCurvature::from_coefficients(a, b).map_err(Fault::from)?;
        let hertz = Contact::new(gap, materials.0).map_err(Fault::from)?;
        let radius = smallest_radius.map_or(on_a_plane(gap), |radius| radius.0);
        RangeError::check("smallest_radius", radius, radius > 0.0, "> 0").map_err(Fault::from)?;
        Ok(Self(hertz, radius))
    }

    /// The contact of two bodies with given principal radii (infinite: straight, negative: concave) and angle
    /// between their first principal directions.
    #[staticmethod]
    #[pyo3(
        signature = (materials=None, radii_1=None, radii_2=None, angle=None, **others),
        text_signature = "(materials, radii_1, radii_2, angle)"
    )]
    fn of_radii(
        py: Python<'_>,
        materials: Option<Pair>,
        radii_1: Option<Row<Radii1, 2>>,
        radii_2: Option<Row<Radii2, 2>>,
        angle: Option<In<Angle>>,
        others: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        needed!(py, "of_radii", others; materials, radii_1, radii_2, angle);
        let make = || -> Result<Self, Fault> {
            let one = PrincipalRadii::new(radii_1.0[0], radii_1.0[1])?;
            let two = PrincipalRadii::new(radii_2.0[0], radii_2.0[1])?;
            let gap = RelativeCurvature::new(one, two, angle.0)?;
            Ok(Self(Contact::new(gap, materials.0)?, PrincipalRadii::smallest([one, two])))
        };
        Ok(make()?)
    }

    /// The stiffnesses (c_x, c_y, c_z), N/m^1.5: in full adhesion dF = c sqrt(zeta) dshift, normally F_z =
    /// (2/3) c_z zeta^1.5.
    #[getter]
    fn stiffness(&self) -> (f64, f64, f64) {
        let ContactStiffness { c_x, c_y, c_z } = self.0.stiffness();
        (c_x, c_y, c_z)
    }

    /// The axis ratio a/b of the contact ellipse; it does not depend on the load.
    #[getter]
    fn axis_ratio(&self) -> f64 {
        self.0.axis_ratio().get()
    }

    /// The coefficients (A, B) of the gap, 1/m.
    #[getter]
    fn curvature(&self) -> (f64, f64) {
        let gap = self.0.curvature();
        (gap.a(), gap.b())
    }

    /// The smallest radius of curvature of both bodies, convex or concave, m.
    #[getter]
    pub(crate) fn smallest_radius(&self) -> f64 {
        self.1
    }

    /// The combined constants of the two materials.
    #[getter]
    fn materials(&self) -> MaterialPair {
        MaterialPair(self.0.materials())
    }

    /// The loaded contact, and warnings, for given values of "force", "approach", "semi_axis_a", "semi_axis_b" or "peak_pressure".
    #[pyo3(name = "_state")]
    fn state<'py>(
        &self,
        py: Python<'py>,
        given: &str,
        values: Numbers<'py>,
    ) -> PyResult<(Bound<'py, PyDict>, Told)> {
        let at: fn(&Contact, f64) -> Result<HertzState, RangeError> = match given {
            "force" => Contact::at_force,
            "approach" => Contact::at_approach,
            "semi_axis_a" => Contact::at_semi_axis_a,
            "semi_axis_b" => Contact::at_semi_axis_b,
            "peak_pressure" => Contact::at_peak_pressure,
            _ => {
                return Err(PyValueError::new_err(format!(
                    "unknown quantity `{given}` of a Hertz contact"
                )));
            }
        };
        let values = values.as_slice()?;
        let states = map(py, values.len(), |i| Ok(at(&self.0, values[i])?))?;
        Ok((arrays(py, HertzState::COLUMNS, &states)?, of_loads(self, &states)))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let (a, b) = self.curvature();
        let materials = self.materials().__repr__(py)?;
        let mut text = format!("Hertz({materials}, {}, {}", repr(py, a)?, repr(py, b)?);
        if self.1 != on_a_plane(self.0.curvature()) {
            text += &format!(", smallest_radius={}", repr(py, self.1)?);
        }
        Ok(text + ")")
    }

    fn _repr_html_(slf: &Bound<'_, Self>) -> PyResult<String> {
        show::html(slf, QUANTITIES)
    }

    fn __getnewargs__(&self) -> (MaterialPair, f64, f64, f64) {
        let gap = self.0.curvature();
        (MaterialPair(self.0.materials()), gap.a(), gap.b(), self.1)
    }
}

impl Hertz {
    /// How far the contact under this load is from the limits of the theory.
    pub(crate) fn validity(&self, state: &HertzState) -> Validity {
        Validity::of_hertz(&self.0, state, self.1)
    }
}

/// The smallest radius of a body that has this gap from a plane.
fn on_a_plane(gap: RelativeCurvature) -> f64 {
    0.5 / gap.a().max(gap.b())
}

/// The stiffness of a contact as Python passes it: a Hertz contact or three numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Given {
    Hertz(Hertz),
    Stiffness(ContactStiffness),
}

impl Given {
    pub(crate) fn stiffness(&self) -> ContactStiffness {
        match self {
            Self::Hertz(hertz) => hertz.0.stiffness(),
            Self::Stiffness(stiffness) => *stiffness,
        }
    }
}

impl<'py> FromPyObject<'_, 'py> for Given {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(hertz) = given.extract::<Hertz>() {
            return Ok(Self::Hertz(hertz));
        }
        let wrong = |error: String| PyValueError::new_err(format!("{error}; or a Hertz contact"));
        let three = given.extract::<Row<Stiffness, 3>>();
        let [c_x, c_y, c_z] = three.map_err(|error| wrong(error.value(given.py()).to_string()))?.0;
        Ok(Self::Stiffness(ContactStiffness::new(c_x, c_y, c_z).map_err(Fault::from)?))
    }
}

impl<'py> IntoPyObject<'py> for Given {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Self::Output> {
        match self {
            Self::Hertz(hertz) => Ok(Bound::new(py, hertz)?.into_any()),
            Self::Stiffness(ContactStiffness { c_x, c_y, c_z }) => {
                Ok((c_x, c_y, c_z).into_pyobject(py)?.into_any())
            }
        }
    }
}
