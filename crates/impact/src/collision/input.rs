//! The inputs of an impact of spheres or planes: what each is in the bodies, and what it changes.

use carom_geometry::{Inertia, Surface};
use carom_halfspace::Material;
use nalgebra::RowSVector;

use super::{Collision, CollisionError};
use crate::body::Body;

/// Numbers of a rebound: velocity and spin of body 1, then of body 2, in axes of space.
pub(super) const OUTPUTS: usize = 12;
/// The same before the impact, then the inputs of [`Input::ALL`].
pub(super) const INPUTS: usize = 24;

/// A number by each input.
pub(super) type Row = RowSVector<f64, INPUTS>;

/// An input of an impact of spheres or planes; bodies are counted from 0. Of a body with a new mass or radius the
/// shape of its mass stays: I/(m R^2) is an input of its own, [`Input::Inertia`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Input {
    /// A component of the velocity of a body.
    Velocity(usize, usize),
    /// A component of its spin.
    Spin(usize, usize),
    /// Its radius; no effect for a plane.
    Radius(usize),
    /// Its mass; no effect if it is infinite.
    Mass(usize),
    /// Its I/(m R^2).
    Inertia(usize),
    /// Its shear modulus; no effect if the ratio of stiffnesses was given.
    ShearModulus(usize),
    /// Its Poisson's ratio; no effect if the ratio of stiffnesses was given.
    Poisson(usize),
    /// The coefficient of friction; no effect if it is infinite.
    Friction,
    /// Normal over tangential stiffness, kappa, alone.
    StiffnessRatio,
}

impl Input {
    /// All of them, as columns of [`ReboundDerivatives::matrix`](super::ReboundDerivatives::matrix).
    pub const ALL: [Self; INPUTS] = {
        let mut all = [Self::StiffnessRatio; INPUTS];
        let mut i = 0;
        while i < 2 {
            let mut axis = 0;
            while axis < 3 {
                all[6 * i + axis] = Self::Velocity(i, axis);
                all[6 * i + 3 + axis] = Self::Spin(i, axis);
                axis += 1;
            }
            all[12 + i] = Self::Radius(i);
            all[14 + i] = Self::Mass(i);
            all[16 + i] = Self::Inertia(i);
            all[18 + i] = Self::ShearModulus(i);
            all[20 + i] = Self::Poisson(i);
            i += 1;
        }
        all[22] = Self::Friction;
        all
    };

    /// Its column.
    #[must_use]
    pub const fn column(self) -> usize {
        match self {
            Self::Velocity(body, axis) => 6 * body + axis,
            Self::Spin(body, axis) => 6 * body + 3 + axis,
            Self::Radius(body) => 12 + body,
            Self::Mass(body) => 14 + body,
            Self::Inertia(body) => 16 + body,
            Self::ShearModulus(body) => 18 + body,
            Self::Poisson(body) => 20 + body,
            Self::Friction => 22,
            Self::StiffnessRatio => 23,
        }
    }
}

impl Collision {
    /// An input, and the size by which its step is measured; none if it has no effect.
    pub(super) fn value(&self, input: Input) -> Option<(f64, f64)> {
        let speed = self.velocity().norm();
        let of = |i: usize| (&self.bodies[i], self.bodies[i].height().unwrap_or(0.0));
        let (value, size) = match input {
            Input::Velocity(i, axis) => (of(i).0.motion().velocity[axis], speed),
            Input::Spin(i, axis) => match of(i) {
                (body, height) if height > 0.0 => (body.motion().spin[axis], speed / height),
                _ => return None,
            },
            Input::Radius(i) => (of(i).1, of(i).1),
            Input::Mass(i) => own(of(i).0.inertia().mass()),
            Input::Inertia(i) => own(inertia_ratio(of(i).0)),
            Input::ShearModulus(i) => own(of(i).0.material().shear_modulus()),
            Input::Poisson(i) if of(i).0.material().is_rigid() => return None,
            Input::Poisson(i) => (of(i).0.material().poisson(), 0.5),
            Input::Friction => own(self.friction.get()),
            Input::StiffnessRatio => own(self.stiffness_ratio?),
        };
        (value.is_finite() && size > 0.0 && size.is_finite()).then_some((value, size))
    }

    /// The same collision with another value of an input.
    pub(super) fn with_input(&self, input: Input, value: f64) -> Result<Self, CollisionError> {
        let mut bodies = self.bodies.clone();
        match input {
            Input::Friction => {
                let friction = carom_laws::friction::Friction::new(value)?;
                return Ok(self.clone().with_friction(friction)?);
            }
            Input::StiffnessRatio => return Ok(self.clone().with_stiffness_ratio(value)?),
            Input::Velocity(i, _)
            | Input::Spin(i, _)
            | Input::Radius(i)
            | Input::Mass(i)
            | Input::Inertia(i)
            | Input::ShearModulus(i)
            | Input::Poisson(i) => bodies[i] = changed(&bodies[i], input, value)?,
        }
        let [one, two] = bodies;
        let fresh = Self::along(one, two, self.frame().z().into(), self.friction)?;
        let Self { bodies, contact, materials, hertz, levers, mobility, .. } = fresh;
        Ok(Self { bodies, contact, materials, hertz, levers, mobility, ..self.clone() })
    }
}

/// A value whose steps are parts of itself.
fn own(value: f64) -> (f64, f64) {
    (value, value)
}

fn inertia_ratio(body: &Body) -> f64 {
    let (inertia, height) = (body.inertia(), body.height().unwrap_or(0.0));
    inertia.moments()[0] / (inertia.mass() * height * height)
}

/// A body with another value of an input.
fn changed(body: &Body, input: Input, value: f64) -> Result<Body, CollisionError> {
    let (mut motion, material) = (body.motion(), body.material());
    let (mass, radius) = (body.inertia().mass(), body.height().unwrap_or(0.0));
    let ball = |mass: f64, radius: f64, ratio: f64| -> Result<Body, CollisionError> {
        let inertia = Inertia::new(mass, [ratio * mass * radius * radius; 3])?;
        Ok(Body::new(Surface::sphere(radius)?, material, inertia).moving(motion))
    };
    let with = |shear: f64, poisson: f64| -> Result<Body, CollisionError> {
        Ok(body.clone().with_material(Material::from_shear(shear, poisson)?))
    };
    Ok(match input {
        Input::Mass(_) => ball(value, radius, inertia_ratio(body))?,
        Input::Radius(_) if mass.is_finite() => ball(mass, value, inertia_ratio(body))?,
        Input::Radius(_) => {
            Body::new(Surface::sphere(value)?, material, body.inertia()).moving(motion)
        }
        Input::Inertia(_) => ball(mass, radius, value)?,
        Input::ShearModulus(_) => with(value, material.poisson())?,
        Input::Poisson(_) => with(material.shear_modulus(), value)?,
        Input::Velocity(_, axis) => {
            motion.velocity[axis] = value;
            body.clone().moving(motion)
        }
        Input::Spin(_, axis) => {
            motion.spin[axis] = value;
            body.clone().moving(motion)
        }
        Input::Friction | Input::StiffnessRatio => body.clone(),
    })
}

/// D_xx and D_zz with their derivatives.
pub(super) fn mobilities(parts: &[Part; 2]) -> [(f64, Row); 2] {
    let along = parts[0].inverse_mass + parts[1].inverse_mass;
    let (mut across, mut by_along, mut by_across) = (along, Row::zeros(), Row::zeros());
    for (i, part) in parts.iter().enumerate() {
        let turning = part.height * part.turning;
        across += turning;
        by_along[Input::Mass(i).column()] = -part.inverse_mass * part.by_mass;
        by_across[Input::Mass(i).column()] = -(part.inverse_mass + turning) * part.by_mass;
        by_across[Input::Inertia(i).column()] = -turning * part.by_inertia;
    }
    [(across, by_across), (along, by_along)]
}

/// What an impulse does to a body.
#[derive(Clone, Copy)]
pub(super) struct Part {
    height: f64,
    pub(super) inverse_mass: f64,
    /// R/I.
    pub(super) turning: f64,
    /// 1/m, 1/R and 1/(I/(m R^2)), or 0 where the input has no effect.
    by_mass: f64,
    by_radius: f64,
    by_inertia: f64,
}

impl Part {
    /// None if an impulse acts on a body otherwise than on a ball or on one that is fixed.
    pub(super) fn of(collision: &Collision, i: usize) -> Option<Self> {
        let body = &collision.bodies[i];
        let (height, inertia) = (body.height()?, body.inertia());
        let (inverse_mass, inverse) = (inertia.inverse_mass(), inertia.inverse_moments().x);
        let one_kind = (inverse_mass > 0.0) == (inverse > 0.0) && inertia.is_isotropic();
        let moves = inverse_mass > 0.0;
        let turns = moves && height > 0.0;
        one_kind.then(|| Self {
            height,
            inverse_mass,
            turning: height * inverse,
            by_mass: if moves { inverse_mass } else { 0.0 },
            by_radius: if turns { 1.0 / height } else { 0.0 },
            by_inertia: if turns { height * height * inverse / inverse_mass } else { 0.0 },
        })
    }

    /// By each input of this body, numbered `i`, the changes of 1/m and of R/I, over these.
    pub(super) fn changes(&self, i: usize) -> [(Input, [f64; 2]); 3] {
        [
            (Input::Mass(i), [-self.by_mass; 2]),
            (Input::Radius(i), [0.0, -self.by_radius]),
            (Input::Inertia(i), [0.0, -self.by_inertia]),
        ]
    }
}
