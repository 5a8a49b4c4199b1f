//! An impact by rings in contact axes, and the one of similar bodies whose solution is known.

use carom_laws::friction::Friction;
use carom_laws::rings::RingConstants;

use super::RingImpactError;
use super::motion::{Motion, Rates};
use crate::collision::CollisionError;
use crate::normal::DURATION;
use crate::oblique::{Groups, ObliqueImpact};

/// D_zz that gives a maximum approach of 1 for unit velocity and c_z = 4.
const MOBILITY: f64 = 15.0 / 32.0;

/// The impact in contact axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Problem {
    pub(super) motion: Motion,
    pub(super) constants: RingConstants,
    pub(super) friction: Friction,
}

impl Problem {
    /// An impact with unit normal velocity and maximum approach; `lambda` is the tangential velocity over f,
    /// `ratio` is D_xx/D_zz.
    pub(super) fn of_groups(
        [kappa, gamma]: [f64; 2],
        friction: Friction,
        lambda: f64,
        ratio: f64,
    ) -> Self {
        let motion = Motion {
            mobility: [MOBILITY, MOBILITY * ratio, 0.0],
            before: [1.0, lambda * friction.coefficient().unwrap_or(1.0), 0.0, 0.0],
            duration: DURATION,
        };
        let constants = RingConstants { c_z: 4.0, radius: 1.0, kappa, gamma };
        Self { motion, constants, friction }
    }

    /// The same impact of similar bodies without spin.
    pub(super) fn alike(&self) -> Self {
        let mut alike = *self;
        alike.constants.gamma = 0.0;
        alike.motion.before[3] = 0.0;
        alike
    }

    /// Scale of the tangential velocities: f, or 1 where f is too large to be one.
    pub(super) fn scale(&self) -> f64 {
        match self.friction.get() {
            f if f > 0.0 && f < 1.0 => f,
            _ => 1.0,
        }
    }

    /// The coupling over friction, gamma/f.
    pub(super) fn spread(&self) -> f64 {
        self.constants.gamma.abs() / self.friction.get()
    }

    /// R_x of the impact of similar bodies.
    pub(super) fn exact_restitution(&self) -> Result<f64, RingImpactError> {
        let [speed, xi, eta, _] = self.motion.before;
        let [along, across, _] = self.motion.mobility;
        let chi = across / (along * self.constants.kappa);
        let slip = xi.hypot(eta);
        let psi = match self.friction.coefficient() {
            None => 0.0,
            Some(0.0) => f64::INFINITY,
            Some(f) => slip / (self.constants.kappa * speed * f),
        };
        let groups = Groups::new(chi, psi)?;
        let impact = ObliqueImpact::new(groups).map_err(CollisionError::from)?;
        Ok(impact.restitution())
    }

    /// The rates after the same impact of similar bodies without spin.
    pub(super) fn exact(&self) -> Result<Rates, RingImpactError> {
        let [speed, xi, eta, _] = self.motion.before;
        let restitution = self.exact_restitution()?;
        Ok([-speed, -restitution * xi, -restitution * eta, 0.0])
    }
}
