//! The ball of a scene: a sphere of finite mass with its position.

use carom_special::RangeError;
use nalgebra::Vector3;

use super::error::SceneError;
use crate::body::Body;

/// A ball at its start.
#[derive(Debug, Clone)]
pub struct Ball {
    body: Body,
    radius: f64,
}

impl Ball {
    /// A ball from the sphere `body`, solid or hollow, at its position and with its motion.
    ///
    /// # Errors
    /// [`SceneError::NotASphere`] for a body of another shape; [`SceneError::Range`] for an infinite mass,
    /// which a fixed wall cannot reflect, or moments of inertia that differ.
    pub fn new(body: Body) -> Result<Self, SceneError> {
        let surface = body.placed().surface();
        let radius =
            surface.radius().ok_or_else(|| SceneError::NotASphere { shape: surface.name() })?;
        RangeError::positive("mass", body.inertia().mass())?;
        let [theta, ..] = body.inertia().moments();
        for moment in body.inertia().moments() {
            RangeError::positive("moment of inertia", moment)?;
            let allowed = "the same about all axes of a ball";
            RangeError::check("moment of inertia", moment, moment == theta, allowed)?;
        }
        Ok(Self { body, radius })
    }

    /// The sphere with its motion.
    #[must_use]
    pub const fn body(&self) -> &Body {
        &self.body
    }

    /// Its radius.
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// The position of its centre.
    #[must_use]
    pub const fn position(&self) -> Vector3<f64> {
        self.body.placed().centre()
    }
}
