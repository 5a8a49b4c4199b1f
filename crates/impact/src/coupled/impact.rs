//! Oblique impact with a full mobility matrix.

use carom_laws::friction::Friction;
use carom_laws::static_friction::StaticFriction;
use carom_laws::stiffness::ContactStiffness;
use carom_special::RangeError;
use nalgebra::Vector3;

use super::ImpactMethod;
use super::direction::length_and_direction;
use crate::mobility::Mobility;
use crate::normal::NormalImpact;
use crate::viscoelastic::ViscousLoss;

/// Default tolerances over |v_A|. In a plane the memory is exact and the runs converge fast; with
/// turning directions they do not. Of a hundred common impacts with fixed directions, fifteen do
/// not converge to 1e-8 after 2^24 steps.
const PLANAR_TOLERANCE: f64 = 1e-8;
const SPATIAL_TOLERANCE: f64 = 5e-6;
/// With a loss: the law of steps itself is off by more.
const LOSSY_TOLERANCE: f64 = 1e-3;

/// An impact given by mobility D, stiffness, friction and approach velocity, in contact axes.
///
/// ```
/// use carom_impact::Mobility;
/// use carom_impact::coupled::{CoupledImpact, TurningLaw};
/// use carom_laws::friction::Friction;
/// use carom_laws::stiffness::ContactStiffness;
/// use nalgebra::{Matrix3, Vector3};
/// let d = Mobility::from_matrix(Matrix3::new(3.0, 0.0, 0.2, 0.0, 2.5, 0.4, 0.2, 0.4, 1.5))?;
/// let stiffness = ContactStiffness::new(0.9, 0.8, 1.1)?;
/// let velocity = Vector3::new(0.3, 0.5, 1.0);
/// let impact = CoupledImpact::new(d, stiffness, Friction::new(0.2)?, velocity)?;
/// let outcome = impact.solve(TurningLaw::Coulomb)?;
/// assert!(outcome.velocity.z < 0.0);
/// assert!(d.energy(&outcome.velocity) < d.energy(&velocity));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoupledImpact {
    pub(super) mobility: Mobility,
    pub(super) stiffness: ContactStiffness,
    /// The greatest coefficient: that of static friction.
    pub(super) friction: Friction,
    /// Both coefficients, if static friction exceeds kinetic friction.
    pub(super) static_friction: Option<StaticFriction>,
    pub(super) velocity: Vector3<f64>,
    pub(super) normal: NormalImpact,
    pub(super) is_symmetric: bool,
    pub(super) tolerance: Option<f64>,
    pub(super) unsettled: Unsettled,
    /// The loss of the material; none of an elastic one.
    pub(super) loss: Option<ViscousLoss>,
}

/// What to do with an impact that does not converge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Unsettled {
    Refused,
    Accepted,
}

impl CoupledImpact {
    /// An impact with this velocity of body 2 against body 1 at the contact point, in contact axes.
    ///
    /// # Errors
    /// [`RangeError`] if the velocity is not finite or its z component, the approach velocity, is
    /// not positive.
    pub fn new(
        mobility: Mobility,
        stiffness: ContactStiffness,
        friction: Friction,
        velocity: Vector3<f64>,
    ) -> Result<Self, RangeError> {
        RangeError::finite("velocity", velocity.x)?;
        RangeError::finite("velocity", velocity.y)?;
        let normal = NormalImpact::new(mobility.matrix().m33, stiffness.c_z, velocity.z)?;
        Ok(Self {
            mobility,
            stiffness,
            friction,
            static_friction: None,
            velocity,
            normal,
            is_symmetric: false,
            tolerance: None,
            unsettled: Unsettled::Refused,
            loss: None,
        })
    }

    /// The same impact with static friction f_s above kinetic friction f_k as a threshold of full
    /// sliding, by [`carom_laws::shift_law::ShiftLaw::with_static_friction`].
    ///
    /// It is computed in time steps, one of which ends where sliding begins. If f_s = f_k, the impact
    /// is that of one coefficient.
    ///
    /// ```
    /// use carom_impact::Mobility;
    /// use carom_impact::coupled::{CoupledImpact, TurningLaw};
    /// use carom_laws::friction::Friction;
    /// use carom_laws::static_friction::StaticFriction;
    /// use carom_laws::stiffness::ContactStiffness;
    /// use nalgebra::{Matrix3, Vector3};
    /// let d = Mobility::from_matrix(Matrix3::new(3.5, 0.0, 0.0, 0.0, 3.5, 0.0, 0.0, 0.0, 1.0))?;
    /// let stiffness = ContactStiffness::new(0.9, 0.9, 1.1)?;
    /// let [f_s, f_k] = [Friction::new(0.3)?, Friction::new(0.2)?];
    /// let impact = CoupledImpact::new(d, stiffness, f_k, Vector3::new(0.4, 0.0, 1.0))?;
    /// let outcome = impact.solve(TurningLaw::Coulomb)?;
    /// let grips = impact.with_static_friction(StaticFriction::new(f_s, f_k)?);
    /// assert!(grips.solve(TurningLaw::Coulomb)?.velocity.x > outcome.velocity.x);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with_static_friction(self, friction: StaticFriction) -> Self {
        Self {
            friction: friction.threshold(),
            static_friction: friction.drops().then_some(friction),
            ..self
        }
    }

    /// The same impact with this tolerance instead of the default: the error of the velocity over
    /// |v_A|.
    ///
    /// Defaults are 1e-8 in a plane and 5e-6 with either law in space, where fifteen of a hundred
    /// common impacts do not converge to 1e-8. The error is estimated by the change in the last
    /// refinements. The true error is mostly several times smaller, and seldom three times as
    /// large.
    ///
    /// # Errors
    /// [`RangeError`] if it is not finite and positive.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        RangeError::positive("tolerance", tolerance)?;
        Ok(Self { tolerance: Some(tolerance), ..self })
    }

    /// The same impact, but if it does not converge, the best velocity and a
    /// [`CoupledOutcome::warning`](super::CoupledOutcome::warning) instead of [`CoupledError::NotSettled`](super::CoupledError::NotSettled).
    #[must_use]
    pub const fn accepting_unsettled(self) -> Self {
        Self { unsettled: Unsettled::Accepted, ..self }
    }

    /// The same impact of bodies whose shapes make D and the stiffness isotropic in the tangential
    /// plane and uncouple normal and tangential motion: round-off of both is removed.
    pub(crate) const fn of_symmetric_bodies(self) -> Self {
        Self { is_symmetric: true, ..self }
    }

    pub(super) fn tolerance(&self) -> f64 {
        let spatial = matches!(self.method(), ImpactMethod::Spatial { .. });
        let default = match (self.loss.is_some(), spatial) {
            (true, _) => LOSSY_TOLERANCE,
            (false, true) => SPATIAL_TOLERANCE,
            (false, false) => PLANAR_TOLERANCE,
        };
        self.tolerance.unwrap_or(default)
    }

    /// The method by which this impact is solved.
    #[must_use]
    pub fn method(&self) -> ImpactMethod {
        if self.friction.get() == 0.0 {
            return ImpactMethod::Frictionless;
        }
        let method = match self.is_symmetric {
            true => ImpactMethod::Uncoupled { direction: length_and_direction(&self.velocity).1 },
            false => ImpactMethod::of(self.mobility.matrix(), &self.stiffness, &self.velocity),
        };
        match method {
            ImpactMethod::Uncoupled { direction } if self.static_friction.is_some() => {
                ImpactMethod::Planar { direction }
            }
            // chi is outside the range of the exact solution: the memory is integrated in steps.
            ImpactMethod::Uncoupled { direction } if self.groups(&direction).is_err() => {
                ImpactMethod::Planar { direction }
            }
            method => method,
        }
    }

    /// The velocity before the impact.
    #[must_use]
    pub const fn velocity(&self) -> Vector3<f64> {
        self.velocity
    }
}
