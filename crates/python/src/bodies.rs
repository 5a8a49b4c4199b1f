//! Bodies of a collision.

use carom::geometry::{Attitude, Inertia, Surface, SurfaceError};
use carom::impact::{Body as Colliding, Motion};
use carom::prelude::RangeError;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::Fault;
use crate::materials::Material;
use crate::mistakes::needed;
use crate::quantities::{In, Row, Several, arguments};
use crate::show::{self, Quantity, repr};

arguments! {
    Turned "attitude" "",
    Centre "centre" "m",
    Density "density" "kg/m**3",
    Mass "mass" "kg",
    Moments "moments" "kg*m**2",
    Sizes "sizes" "m",
    Spin "spin" "rad/s",
    Velocity "velocity" "m/s",
}

const QUANTITIES: &[Quantity] = &[
    ("shape", "", "shape"),
    ("sizes", "m", "dimensions of the shape"),
    ("material", "", "material"),
    ("mass", "kg", "mass; inf for a fixed body"),
    ("hollow", "", "whether the body is a thin shell"),
    ("moments", "kg m^2", "principal moments of inertia"),
    ("centre", "m", "centre of mass"),
    ("attitude", "", "quaternion (w, i, j, k)"),
    ("velocity", "m/s", "of the centre of mass"),
    ("spin", "rad/s", "angular velocity in space axes"),
];

/// Default centre, velocity and spin.
const AT_REST: [f64; 3] = [0.0; 3];
/// Default attitude: body axes along those of space.
const ALONG_SPACE: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

/// A body before a collision.
///
/// Body(shape, sizes, material, mass): the shape is 'sphere' (radius), 'plane' (no size, fixed), 'ellipsoid'
/// (three semi-axes), 'cylinder' or 'capsule' (radius, length), 'torus' (radius of the centre circle, of the
/// tube) or 'box' (three edge lengths); sizes in m, a list or one number, mass in kg, or the density of a solid body in
/// kg/m3. Without them the body is fixed. By default it is solid, at the origin, at rest, its axes along those of space;
/// see hollow, moments, centre, attitude, velocity and spin.
#[pyclass(frozen, eq, from_py_object, module = "carom", subclass)]
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Body {
    /// 'sphere', 'plane', 'ellipsoid', 'cylinder', 'capsule', 'torus' or 'box'.
    #[pyo3(get)]
    shape: String,
    /// The dimensions of the shape, m.
    #[pyo3(get)]
    sizes: Vec<f64>,
    /// The material.
    #[pyo3(get)]
    material: Material,
    /// The mass, kg; inf for a fixed body.
    #[pyo3(get)]
    mass: f64,
    /// Whether the body is a thin shell.
    #[pyo3(get)]
    hollow: bool,
    /// The principal moments of inertia, kg m^2; None for those of the shape.
    #[pyo3(get)]
    moments: Option<[f64; 3]>,
    /// The centre of mass, m.
    centre: [f64; 3],
    /// The unit quaternion (w, i, j, k) that transforms components in body axes to space axes.
    attitude: [f64; 4],
    /// The velocity of the centre of mass, m/s.
    velocity: [f64; 3],
    /// The angular velocity in space axes, rad/s.
    spin: [f64; 3],
}

#[pymethods]
impl Body {
    /// The centre of mass, m. Vectors are tuples, since a change of a list would be lost.
    #[getter]
    fn centre(&self) -> (f64, f64, f64) {
        self.centre.into()
    }

    /// The unit quaternion (w, i, j, k) that transforms components in body axes to space axes.
    #[getter]
    fn attitude(&self) -> (f64, f64, f64, f64) {
        self.attitude.into()
    }

    /// The velocity of the centre of mass, m/s.
    #[getter]
    fn velocity(&self) -> (f64, f64, f64) {
        self.velocity.into()
    }

    /// The angular velocity in space axes, rad/s.
    #[getter]
    fn spin(&self) -> (f64, f64, f64) {
        self.spin.into()
    }

    #[new]
    #[pyo3(
        signature = (
            shape=None, sizes=None, material=None, mass=None, *, density=None, hollow=false, moments=None,
            centre=Row::of(AT_REST), attitude=Row::of(ALONG_SPACE), velocity=Row::of(AT_REST),
            spin=Row::of(AT_REST), **others
        ),
        text_signature = "(shape, sizes, material, mass=None, *, density=None, hollow=False, moments=None, \
                          centre=(0.0, 0.0, 0.0), attitude=(1.0, 0.0, 0.0, 0.0), \
                          velocity=(0.0, 0.0, 0.0), spin=(0.0, 0.0, 0.0))"
    )]
    #[allow(clippy::too_many_arguments)] // named ones, in Python
    fn new(
        py: Python<'_>,
        shape: Option<String>,
        sizes: Option<Several<Sizes>>,
        material: Option<Material>,
        mass: Option<In<Mass>>,
        density: Option<In<Density>>,
        hollow: bool,
        moments: Option<Row<Moments, 3>>,
        centre: Row<Centre, 3>,
        attitude: Row<Turned, 4>,
        velocity: Row<Velocity, 3>,
        spin: Row<Spin, 3>,
        others: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        needed!(py, "", others; shape, sizes, material);
        let mut body = Self {
            shape,
            sizes: sizes.0,
            material,
            mass: mass.as_ref().map_or(f64::INFINITY, |mass| mass.0),
            hollow,
            moments: moments.map(|moments| moments.0),
            centre: centre.0,
            attitude: attitude.0,
            velocity: velocity.0,
            spin: spin.0,
        };
        if let Some(density) = density {
            body.mass = body.weighed(density.0, mass.is_some())?;
        }
        body.colliding()?; // checks all
        Ok(body)
    }

    /// A copy of the body with another motion.
    #[pyo3(
        signature = (velocity=Row::of(AT_REST), spin=Row::of(AT_REST)),
        text_signature = "($self, velocity=(0.0, 0.0, 0.0), spin=(0.0, 0.0, 0.0))"
    )]
    fn moving(&self, velocity: Row<Velocity, 3>, spin: Row<Spin, 3>) -> PyResult<Self> {
        let (velocity, spin) = (velocity.0, spin.0);
        motion(velocity, spin)?;
        Ok(Self { velocity, spin, ..self.clone() })
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let (shape, sizes) = (repr(py, &self.shape)?, repr(py, &self.sizes)?);
        let mut text = format!("Body({shape}, {sizes}, {}", self.material.__repr__(py)?);
        if self.mass != f64::INFINITY {
            text += &format!(", mass={}", repr(py, self.mass)?);
        }
        if self.hollow {
            text += ", hollow=True";
        }
        if let Some(moments) = self.moments {
            text += &format!(", moments={}", repr(py, moments)?);
        }
        if self.attitude != ALONG_SPACE {
            text += &format!(", attitude={}", repr(py, self.attitude)?);
        }
        let vectors = [("centre", self.centre), ("velocity", self.velocity), ("spin", self.spin)];
        for (name, vector) in vectors.into_iter().filter(|(_, vector)| *vector != AT_REST) {
            text += &format!(", {name}={}", repr(py, vector)?);
        }
        Ok(text + ")")
    }

    fn _repr_html_(slf: &Bound<'_, Self>) -> PyResult<String> {
        show::html(slf, QUANTITIES)
    }

    #[allow(clippy::type_complexity)] // the arguments of `__new__`
    fn __getnewargs_ex__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<((String, Vec<f64>, Material, f64), Bound<'py, PyDict>)> {
        let named = PyDict::new(py);
        named.set_item("hollow", self.hollow)?;
        named.set_item("moments", self.moments)?;
        named.set_item("centre", self.centre)?;
        named.set_item("attitude", self.attitude)?;
        named.set_item("velocity", self.velocity)?;
        named.set_item("spin", self.spin)?;
        Ok(((self.shape.clone(), self.sizes.clone(), self.material, self.mass), named))
    }
}

impl Body {
    /// The body as the Rust library takes it.
    pub(crate) fn colliding(&self) -> PyResult<Colliding> {
        let surface = self.surface()?;
        let inertia = self.inertia(&surface)?;
        let attitude = Attitude::from_quaternion(self.attitude).map_err(Fault::from)?;
        let body = Colliding::new(surface, self.material.0, inertia);
        let body = body.at(self.centre).map_err(Fault::from)?.turned(attitude);
        Ok(body.moving(motion(self.velocity, self.spin)?))
    }

    fn surface(&self) -> PyResult<Surface> {
        let surface = match (self.shape.as_str(), self.sizes.as_slice()) {
            ("sphere", [radius]) => Surface::sphere(*radius),
            ("plane", []) => Ok(Surface::plane()),
            ("ellipsoid", [a, b, c]) => Surface::ellipsoid([*a, *b, *c]),
            ("cylinder", [radius, length]) => Surface::cylinder(*radius, *length),
            ("capsule", [radius, length]) => Surface::capsule(*radius, *length),
            ("torus", [major, minor]) => Surface::torus(*major, *minor),
            ("box", [a, b, c]) => Surface::cuboid([*a, *b, *c]),
            (shape, sizes) => {
                let text = format!(
                    "shape = '{shape}' with {} sizes: must be 'sphere' (radius), 'plane' (none), \
                     'ellipsoid' (3 semi-axes), 'cylinder' or 'capsule' (radius, length), 'torus' \
                     (2 radii) or 'box' (3 edges)",
                    sizes.len()
                );
                return Err(PyValueError::new_err(text));
            }
        };
        Ok(surface.map_err(Fault::from)?)
    }

    /// The mass of a solid body of this density.
    fn weighed(&self, density: f64, has_mass: bool) -> PyResult<f64> {
        if has_mass {
            return Err(PyValueError::new_err("mass and density are both given: give one of them"));
        }
        if self.hollow {
            let text = "density: is that of a solid body; a hollow one has a mass";
            return Err(PyValueError::new_err(text));
        }
        let density = RangeError::positive("density", density).map_err(Fault::from)?;
        let volume = self.surface()?.volume().ok_or_else(|| {
            PyValueError::new_err(format!("density: a {} has no volume; it is fixed", self.shape))
        })?;
        Ok(density * volume)
    }

    fn inertia(&self, surface: &Surface) -> PyResult<Inertia> {
        if surface.is_plane() {
            RangeError::check("mass", self.mass, self.mass == f64::INFINITY, "inf for a plane")
                .map_err(Fault::from)?;
        }
        if self.mass == f64::INFINITY {
            return self.held();
        }
        let inertia = match self.moments {
            Some(_) if self.hollow => {
                let text = "hollow and moments are both given: give one of them";
                return Err(PyValueError::new_err(text));
            }
            Some(moments) => Inertia::new(self.mass, moments).map_err(SurfaceError::from),
            None if self.hollow => surface.shell(self.mass),
            None => surface.solid(self.mass),
        };
        Ok(inertia.map_err(Fault::from)?)
    }

    fn held(&self) -> PyResult<Inertia> {
        let given = [("moments", self.moments.is_some()), ("hollow", self.hollow)];
        match given.into_iter().find(|(_, is_given)| *is_given) {
            None => Ok(Inertia::FIXED),
            Some((name, _)) => {
                let text = format!("{name}: must not be given for a fixed body, without a mass");
                Err(PyValueError::new_err(text))
            }
        }
    }
}

/// A motion, if its numbers are finite.
pub(crate) fn motion(velocity: [f64; 3], spin: [f64; 3]) -> Result<Motion, Fault> {
    Ok(Motion::new(velocity, spin)?)
}
