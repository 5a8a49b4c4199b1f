//! The ball of a scene: a sphere of finite mass and where its centre is.

use carom_special::RangeError;
use nalgebra::Vector3;

use super::error::SceneError;
use crate::body::{Body, Shape};

/// A ball at its start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    body: Body,
    radius: f64,
    position: Vector3<f64>,
}

impl Ball {
    /// The sphere `body`, with its motion, whose centre is at `position`.
    ///
    /// # Errors
    /// [`SceneError::NotASphere`] for a body of another shape; [`SceneError::Range`] for an
    /// infinite mass, which no plane held fast turns back, moments of inertia that differ, or a
    /// position that is not finite.
    pub fn new(body: Body, position: [f64; 3]) -> Result<Self, SceneError> {
        let Shape::Sphere(radius) = body.shape() else {
            return Err(SceneError::NotASphere);
        };
        RangeError::positive("mass", body.inertia().mass())?;
        let [theta, ..] = body.inertia().moments();
        for moment in body.inertia().moments() {
            RangeError::positive("moment of inertia", moment)?;
            let allowed = "the same about all axes of a ball";
            RangeError::check("moment of inertia", moment, moment == theta, allowed)?;
        }
        for value in position {
            RangeError::finite("position", value)?;
        }
        Ok(Self { body, radius, position: position.into() })
    }

    /// The sphere with its motion.
    #[must_use]
    pub const fn body(&self) -> Body {
        self.body
    }

    /// Its radius.
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// Where its centre is.
    #[must_use]
    pub const fn position(&self) -> Vector3<f64> {
        self.position
    }
}
