//! Materials.

use carom::prelude::RangeError;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::Fault;
use crate::mistakes::{needed, refuse};
use crate::quantities::{In, arguments};
use crate::show::{self, Quantity, repr};

arguments! {
    Poisson "poisson" "",
    ShearModulus "shear_modulus" "Pa",
    YieldStress "yield_stress" "Pa",
    YoungModulus "young_modulus" "Pa",
}

const MATERIAL: &[Quantity] = &[
    ("young_modulus", "Pa", "Young's modulus"),
    ("shear_modulus", "Pa", "shear modulus"),
    ("poisson", "", "Poisson's ratio"),
    ("yield_stress", "Pa", "yield stress"),
];
const PAIR: &[Quantity] = &[
    ("shear_modulus", "Pa", "combined shear modulus"),
    ("poisson", "", "combined Poisson's ratio"),
    ("kappa", "", "normal over tangential stiffness of a circular contact"),
    ("gamma", "", "coupling of normal and tangential displacements"),
];

const NO_POISSON: &str = "Material() needs `poisson`, Poisson's ratio, in (-1, 0.5]: 0.3 is that of steel; \
                          a rigid body has none, Material(float(\"inf\"))";

/// An isotropic elastic material.
///
/// Material(young_modulus, poisson) or Material(shear_modulus=..., poisson=...), moduli in Pa; an infinite
/// modulus makes the body rigid. It stays elastic; `yield_stress` (Pa, in tension; of a hardness H it is H/2.8)
/// lets `OutsideTheoryWarning` tell where the greatest pressure exceeds 1.6 times it.
#[pyclass(frozen, eq, module = "carom")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Material(pub(crate) carom::halfspace::Material);

#[pymethods]
impl Material {
    #[new]
    #[pyo3(
        signature = (
            young_modulus=None, poisson=None, *, shear_modulus=None, yield_stress=None, **others
        ),
        text_signature = "(young_modulus=None, poisson=None, *, shear_modulus=None, yield_stress=None)"
    )]
    fn new(
        py: Python<'_>,
        young_modulus: Option<In<YoungModulus>>,
        poisson: Option<In<Poisson>>,
        shear_modulus: Option<In<ShearModulus>>,
        yield_stress: Option<In<YieldStress>>,
        others: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        use carom::halfspace::Material;
        refuse(&py.get_type::<Self>(), "", others)?;
        let is_rigid =
            [young_modulus.map(|e| e.0), shear_modulus.map(|g| g.0)].contains(&Some(f64::INFINITY));
        let poisson = match poisson {
            Some(poisson) => poisson.0,
            None if is_rigid || young_modulus.is_some() == shear_modulus.is_some() => 0.0,
            None => return Err(PyTypeError::new_err(NO_POISSON)),
        };
        let material = match (young_modulus.map(|e| e.0), shear_modulus.map(|g| g.0)) {
            (Some(f64::INFINITY), None) | (None, Some(f64::INFINITY)) => {
                let is_own = poisson == 0.0 || poisson == Material::RIGID.poisson();
                RangeError::check("poisson", poisson, is_own, "0 for a rigid body, which has none")
                    .map(|_| Material::RIGID)
            }
            (Some(modulus), None) => Material::from_young(modulus, poisson),
            (None, Some(modulus)) => Material::from_shear(modulus, poisson),
            _ => {
                let text = "a material takes exactly one of young_modulus and shear_modulus";
                return Err(PyTypeError::new_err(text));
            }
        };
        let material = material
            .and_then(|material| material.yielding_at(yield_stress.map_or(f64::INFINITY, |y| y.0)));
        Ok(Self(material.map_err(Fault::from)?))
    }

    /// Young's modulus E, Pa.
    #[getter]
    fn young_modulus(&self) -> f64 {
        self.0.young_modulus()
    }

    /// The shear modulus G, Pa.
    #[getter]
    fn shear_modulus(&self) -> f64 {
        self.0.shear_modulus()
    }

    /// Poisson's ratio.
    #[getter]
    fn poisson(&self) -> f64 {
        self.0.poisson()
    }

    /// The yield stress in tension, Pa; infinite if none is known.
    #[getter]
    fn yield_stress(&self) -> f64 {
        self.0.yield_stress()
    }

    pub(crate) fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let modulus = match self.short_young_modulus() {
            Some(modulus) => format!("young_modulus={}", repr(py, modulus)?),
            None => format!("shear_modulus={}", repr(py, self.shear_modulus())?),
        };
        let yields = match self.yield_stress() {
            f64::INFINITY => String::new(),
            stress => format!(", yield_stress={}", repr(py, stress)?),
        };
        Ok(format!("Material({modulus}, poisson={}{yields})", repr(py, self.poisson())?))
    }

    fn _repr_html_(slf: &Bound<'_, Self>) -> PyResult<String> {
        show::html(slf, MATERIAL)
    }

    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<((), Bound<'py, PyDict>)> {
        let named = PyDict::new(py);
        named.set_item("shear_modulus", self.0.shear_modulus())?;
        named.set_item("poisson", self.0.poisson())?;
        named.set_item("yield_stress", self.0.yield_stress())?;
        Ok(((), named))
    }
}

impl Material {
    /// Young's modulus with at most twelve digits, if it makes the same material.
    fn short_young_modulus(&self) -> Option<f64> {
        let modulus = self.young_modulus();
        if modulus == f64::INFINITY {
            return Some(modulus);
        }
        let short = format!("{modulus:.11e}").parse().ok()?;
        let same = carom::halfspace::Material::from_young(short, self.poisson()).ok()?;
        (same.shear_modulus() == self.shear_modulus()).then_some(short)
    }
}

/// The combined constants of two materials in contact.
#[pyclass(frozen, eq, from_py_object, module = "carom")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MaterialPair(pub(crate) carom::halfspace::MaterialPair);

impl<'py> FromPyObject<'_, 'py> for Material {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        given
            .cast::<Self>()
            .map(|material| *material.get())
            .map_err(|_| not(&given, "material: must be a Material"))
    }
}

/// The error of an argument of another class.
fn not(given: &Bound<'_, PyAny>, told: &str) -> PyErr {
    match given.get_type().name() {
        Ok(name) => PyTypeError::new_err(format!("{told}, not {name}")),
        Err(error) => error,
    }
}

/// A pair as an argument; one material stands for two alike.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pair(pub(crate) carom::halfspace::MaterialPair);

impl<'py> FromPyObject<'_, 'py> for Pair {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(pair) = given.extract::<MaterialPair>() {
            return Ok(Self(pair.0));
        }
        let told = |_| not(&given, "materials: must be a MaterialPair or a Material");
        let material = given.extract::<Material>().map_err(told)?;
        Ok(Self(MaterialPair::of(material, None)?.0))
    }
}

impl MaterialPair {
    fn of(material_1: Material, material_2: Option<Material>) -> PyResult<Self> {
        let two = material_2.unwrap_or(material_1);
        let pair = carom::halfspace::MaterialPair::new(material_1.0, two.0);
        Ok(Self(pair.map_err(Fault::from)?))
    }
}

#[pymethods]
impl MaterialPair {
    #[new]
    #[pyo3(
        signature = (material_1=None, material_2=None, **others),
        text_signature = "(material_1, material_2=None)"
    )]
    fn new(
        py: Python<'_>,
        material_1: Option<Material>,
        material_2: Option<Material>,
        others: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        needed!(py, "", others; material_1);
        Self::of(material_1, material_2)
    }

    /// The material of body 1.
    #[getter]
    fn material_1(&self) -> Material {
        Material(self.0.body_1())
    }

    /// The material of body 2.
    #[getter]
    fn material_2(&self) -> Material {
        Material(self.0.body_2())
    }

    /// The combined shear modulus G, 1/G = 1/G1 + 1/G2, Pa.
    #[getter]
    fn shear_modulus(&self) -> f64 {
        self.0.shear_modulus()
    }

    /// The combined Poisson's ratio, nu/G = nu1/G1 + nu2/G2.
    #[getter]
    fn poisson(&self) -> f64 {
        self.0.poisson()
    }

    /// Epsilon, the coupling of normal and tangential displacements, 1/Pa; 0 for like materials.
    #[getter]
    fn epsilon(&self) -> f64 {
        self.0.epsilon()
    }

    /// Gamma, epsilon without dimension; 0 for like materials.
    #[getter]
    fn gamma(&self) -> f64 {
        self.0.gamma()
    }

    /// Kappa, the ratio of normal to tangential stiffness of a circular contact, (2 - nu)/(2 (1 - nu)).
    #[getter]
    fn kappa(&self) -> f64 {
        self.0.kappa()
    }

    /// The smaller yield stress of the two, Pa; infinite if none is known.
    #[getter]
    fn yield_stress(&self) -> f64 {
        self.0.yield_stress()
    }

    pub(crate) fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let [one, two] = [self.material_1(), self.material_2()];
        let mut text = format!("MaterialPair({}", one.__repr__(py)?);
        if one != two {
            text += &format!(", {}", two.__repr__(py)?);
        }
        Ok(text + ")")
    }

    fn _repr_html_(slf: &Bound<'_, Self>) -> PyResult<String> {
        show::html(slf, PAIR)
    }

    fn __getnewargs__(&self) -> (Material, Material) {
        (Material(self.0.body_1()), Material(self.0.body_2()))
    }
}
