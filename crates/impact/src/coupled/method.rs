//! The method by which an impact is solved: closed form, exact, planar or spatial.
//!
//! Symmetry chooses it. Without friction the impact is in closed form. If the mobility couples no normal and
//! tangential motion and the path stays straight, the solution of [`crate::oblique`] is exact. If it is coupled but
//! stays in one plane, or turns in space, the impact is stepped in time to a tolerance. Couplings that vanish by
//! the symmetry of the bodies are exact zeros in the mobility, not small computed numbers.

use carom_laws::law_name::LawName;
use carom_laws::stiffness::ContactStiffness;
use nalgebra::{Matrix3, Vector3};

use super::direction::length_and_direction;

/// Couplings below this share of the largest entry are round-off. Couplings that vanish by the
/// symmetry of the bodies are already exact zeros, whatever their sizes ([`crate::Mobility::new`]).
const MAX_COUPLING_OF_ROUND_OFF: f64 = 1e-13;

/// Whether a normal impulse changes the tangential velocity.
pub(crate) fn is_coupled(mobility: &Matrix3<f64>) -> bool {
    mobility.m13.abs().max(mobility.m23.abs()) > MAX_COUPLING_OF_ROUND_OFF * mobility.amax()
}

/// The method by which an impact is solved; it follows from the coupling in its matrices.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ImpactMethod {
    /// No friction: the impulse is 2 v_z/D_zz along the normal, in closed form.
    Frictionless,
    /// Normal and tangential motion are uncoupled, the tangential one along this direction: the
    /// exact solution of [`crate::oblique`].
    Uncoupled {
        /// Unit vector of the tangential motion, contact axes.
        direction: Vector3<f64>,
    },
    /// Motion in the plane of the normal and this direction: the memory for one direction is exact.
    Planar {
        /// Unit tangent of that plane, contact axes.
        direction: Vector3<f64>,
    },
    /// Spatial motion: a law for turning shifts.
    Spatial {
        /// Whether the normal motion is coupled to the tangential one.
        coupled: bool,
    },
    /// Spheres or planes of dissimilar materials: the contact is solved on annuli, step by step.
    Rings,
    /// The contact is solved on a grid, step by step.
    Numerical,
}

impl ImpactMethod {
    pub(super) fn of(
        mobility: &Matrix3<f64>,
        stiffness: &ContactStiffness,
        velocity: &Vector3<f64>,
    ) -> Self {
        let small = MAX_COUPLING_OF_ROUND_OFF * mobility.amax();
        let pull = Vector3::new(mobility.m13, mobility.m23, 0.0);
        let coupled = is_coupled(mobility);
        let (slip, mut direction) = length_and_direction(velocity);
        if slip == 0.0 && coupled {
            direction = pull.normalize();
        }
        let across = Vector3::z().cross(&direction);
        let stays = (mobility * direction).dot(&across).abs() <= small
            && (!coupled || pull.dot(&across).abs() <= small);
        let twist = (stiffness.c_y - stiffness.c_x) * direction.x * direction.y;
        let straight =
            stays && twist.abs() <= MAX_COUPLING_OF_ROUND_OFF * stiffness.c_x.max(stiffness.c_y);
        match (coupled, straight || (slip == 0.0 && !coupled)) {
            (false, true) => Self::Uncoupled { direction },
            (true, true) => Self::Planar { direction },
            (coupled, false) => Self::Spatial { coupled },
        }
    }

    /// Whether the method includes the coupling of normal and tangential displacements of
    /// dissimilar materials.
    #[must_use]
    pub const fn counts_coupling(&self) -> bool {
        matches!(self, Self::Rings | Self::Numerical)
    }

    /// The name of the method, as in results.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Frictionless => "frictionless",
            Self::Uncoupled { .. } => "uncoupled",
            Self::Planar { .. } => "planar",
            Self::Spatial { .. } => "spatial",
            Self::Rings => LawName::Rings.name(),
            Self::Numerical => "numerical",
        }
    }
}
