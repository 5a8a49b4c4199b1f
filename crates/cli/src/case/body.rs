//! A body of a case: `[body_1]` and `[body_2]`.

use super::error::CaseError;
use super::range::Range;
use super::section::{Section, Words};
use super::unit::Dimension;
use carom_halfspace::Material;
use carom_special::RangeError;
use std::f64::consts::PI;

const FIELDS: &[&str] =
    &["shape", "radius", "material", "density", "mass", "fixed", "velocity", "spin"];
const MATERIAL_FIELDS: &[&str] = &["young_modulus", "shear_modulus", "poisson", "rigid"];
const SHAPES: Words = Words { words: &["sphere", "plane"], allowed: "\"sphere\" or \"plane\"" };
pub(super) const MASS: &str = "given as `mass`, as `density` of a sphere, or as `fixed = true`";

/// A body as a case file describes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyCase {
    /// Its surface near the contact.
    pub shape: Shape,
    /// What it is made of.
    pub material: Material,
    /// How heavy it is.
    pub mass: Mass,
    /// Velocity of the centre, m/s; none if the case gives an approach instead.
    pub velocity: Option<[f64; 3]>,
    /// Angular velocity, rad/s.
    pub spin: [f64; 3],
}

/// Shape of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// A solid sphere.
    Sphere {
        /// Its radius, m.
        radius: f64,
    },
    /// A plane.
    Plane,
}

/// Mass of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mass {
    /// In kg; may be infinite.
    Given(f64),
    /// Infinitely heavy and at rest.
    Fixed,
}

impl Mass {
    /// Whether no impulse moves the body.
    #[must_use]
    pub fn is_infinite(self) -> bool {
        match self {
            Self::Given(mass) => mass.is_infinite(),
            Self::Fixed => true,
        }
    }
}

/// Whether the file must give a velocity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Motion {
    /// By `velocity`.
    Velocity,
    /// By `[approach]` instead.
    Approach,
}

impl BodyCase {
    /// Reads the body in table `name` of the case.
    ///
    /// # Errors
    /// If a field is missing, unknown, out of range or in conflict with another.
    pub fn read(case: &Section<'_>, name: &str, motion: Motion) -> Result<Self, CaseError> {
        let body = case.section(name, FIELDS)?;
        let shape = read_shape(&body)?;
        let material = read_material(&body)?;
        let mass = read_mass(&body, shape)?;
        let velocity = read_velocity(&body, mass, motion)?;
        let spin = match mass {
            Mass::Fixed => [0.0; 3],
            _ => body.vector("spin", Range::Speed.of(Dimension::Spin))?,
        };
        Ok(Self { shape, material, mass, velocity, spin })
    }
}

fn read_shape(body: &Section<'_>) -> Result<Shape, CaseError> {
    match body.word("shape", SHAPES)? {
        "plane" if body.has("radius") => {
            Err(body.conflict("radius", "shape", "a plane has no radius"))
        }
        "plane" => Ok(Shape::Plane),
        _ => Ok(Shape::Sphere {
            radius: body.number("radius", Range::Positive.of(Dimension::Length))?,
        }),
    }
}

pub(super) fn read_material(body: &Section<'_>) -> Result<Material, CaseError> {
    let material = body.section("material", MATERIAL_FIELDS)?;
    if material.switch("rigid")? {
        let others = ["young_modulus", "shear_modulus", "poisson"];
        return match others.into_iter().find(|name| material.has(name)) {
            Some(name) => {
                Err(material.conflict(name, "rigid", "a rigid body has no elastic constants"))
            }
            None => Ok(Material::RIGID),
        };
    }
    if material.has("shear_modulus") && material.has("young_modulus") {
        let reason = "give one of the two";
        return Err(material.conflict("shear_modulus", "young_modulus", reason));
    }
    let poisson = |material: &Section<'_>| material.number("poisson", Range::Poisson);
    let made = if material.has("shear_modulus") {
        let modulus = material.number("shear_modulus", Range::Positive.of(Dimension::Pressure))?;
        Material::from_shear(modulus, poisson(&material)?)
    } else if material.has("young_modulus") {
        let modulus = material.number("young_modulus", Range::Positive.of(Dimension::Pressure))?;
        Material::from_young(modulus, poisson(&material)?)
    } else {
        let allowed = "finite and > 0 (or `shear_modulus`, or `rigid = true`)";
        return Err(material.missing("young_modulus", allowed));
    };
    made.map_err(|RangeError { field, value, allowed }| {
        material.out_of_range(field, value, allowed)
    })
}

fn read_mass(body: &Section<'_>, shape: Shape) -> Result<Mass, CaseError> {
    let given: Vec<&str> =
        ["mass", "density", "fixed"].into_iter().filter(|name| body.has(name)).collect();
    match given.as_slice() {
        [] => Err(body.missing("mass", MASS)),
        [one, other, ..] => Err(body.conflict(other, one, "give one of them")),
        ["density"] => read_density(body, shape),
        ["mass"] => {
            Ok(Mass::Given(body.number("mass", Range::PositiveOrInfinite.of(Dimension::Mass))?))
        }
        _ if body.switch("fixed")? => Ok(Mass::Fixed),
        _ => Err(body.missing("mass", MASS)),
    }
}

fn read_density(body: &Section<'_>, shape: Shape) -> Result<Mass, CaseError> {
    let density = body.number("density", Range::Positive.of(Dimension::Density))?;
    let Shape::Sphere { radius } = shape else {
        return Err(body.conflict("density", "shape", "a plane has no volume; give its `mass`"));
    };
    let mass = density * (4.0 / 3.0 * PI * radius * radius * radius);
    if !(mass.is_finite() && mass > 0.0) {
        let allowed = "such that the mass of the sphere is finite and > 0";
        return Err(body.out_of_range("density", density, allowed));
    }
    Ok(Mass::Given(mass))
}

fn read_velocity(
    body: &Section<'_>,
    mass: Mass,
    motion: Motion,
) -> Result<Option<[f64; 3]>, CaseError> {
    if mass == Mass::Fixed {
        let moving = ["velocity", "spin"].into_iter().find(|name| body.has(name));
        return match moving {
            Some(name) => Err(body.conflict(
                name,
                "fixed",
                "a fixed body is at rest; a moving one of infinite mass has `mass = inf`",
            )),
            None => Ok(Some([0.0; 3])),
        };
    }
    match motion {
        Motion::Velocity => body.vector("velocity", Range::Speed.of(Dimension::Speed)).map(Some),
        Motion::Approach if body.has("velocity") => {
            let reason = "[approach] gives the velocity of body 1";
            Err(body.conflict("velocity", "approach", reason))
        }
        Motion::Approach => Ok(None),
    }
}
