//! Horak's restitution tensor (3.3), v_iE = - sum_k R_ik v_kA, for uncoupled impacts.
//!
//! One impact does not determine nine numbers. Two choices are natural, and each is named.

use nalgebra::Matrix3;

use super::Sensitivity;
use crate::oblique::{Groups, ObliqueError, ObliqueImpact};

/// A restitution tensor and how it was chosen; x is the direction of the tangential velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RestitutionTensor {
    /// diag(R_x, R_x, 1): final over initial velocity, component by component. The thesis's use.
    Secant(Matrix3<f64>),
    /// -dv_iE/dv_kA: how the final velocity answers to small changes of the initial one. Because
    /// v_E is homogeneous of degree 1 in v_A it satisfies (3.3) exactly, too.
    Tangent(Matrix3<f64>),
}

impl RestitutionTensor {
    /// The secant tensor.
    ///
    /// # Errors
    /// [`ObliqueError`] as [`ObliqueImpact::new`].
    pub fn secant(groups: Groups) -> Result<Self, ObliqueError> {
        let restitution = ObliqueImpact::new(groups)?.restitution();
        Ok(Self::Secant(Matrix3::from_diagonal(&[restitution, restitution, 1.0].into())))
    }

    /// The tangent tensor; `velocity_ratio` is |v_x|/v_z of the initial velocity.
    ///
    /// dR_x/dpsi is that of [`Sensitivity`]: on the boundary of a regime that of one side.
    ///
    /// # Errors
    /// [`ObliqueError`] as [`ObliqueImpact::new`].
    pub fn tangent(groups: Groups, velocity_ratio: f64) -> Result<Self, ObliqueError> {
        let restitution = ObliqueImpact::new(groups)?.restitution();
        let change = change(groups)?;
        // v_xE = -R(psi) v_x, psi ~ v_x/v_z
        let mut tensor = Matrix3::from_diagonal(&[restitution, restitution, 1.0].into());
        tensor[(0, 0)] += change;
        tensor[(0, 2)] = -change * velocity_ratio;
        Ok(Self::Tangent(tensor))
    }

    /// The numbers, whichever choice made them.
    #[must_use]
    pub const fn matrix(&self) -> &Matrix3<f64> {
        match self {
            Self::Secant(matrix) | Self::Tangent(matrix) => matrix,
        }
    }
}

// psi dR_x/dpsi.
fn change(groups: Groups) -> Result<f64, ObliqueError> {
    let psi = groups.psi();
    if psi == 0.0 || psi.is_infinite() {
        Ok(0.0)
    } else {
        Ok(psi * Sensitivity::by_psi_of(groups)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    #[test]
    fn both_tensors_map_the_initial_velocity_to_the_final_one() {
        for (chi, psi) in [(3.5, 0.4), (2.9, 1.7), (2.9, 3.4), (2.9, 9.0)] {
            let groups = Groups::new(chi, psi).unwrap();
            let before = Vector3::new(0.7, 0.0, 2.0);
            let restitution = ObliqueImpact::new(groups).unwrap().restitution();
            let after = Vector3::new(-restitution * 0.7, 0.0, -2.0);
            let secant = RestitutionTensor::secant(groups).unwrap();
            let tangent = RestitutionTensor::tangent(groups, 0.35).unwrap();
            for tensor in [secant, tangent] {
                assert!((-tensor.matrix() * before - after).norm() < 1e-14);
            }
        }
    }

    #[test]
    fn frictionless_bodies_slide_on_in_both_tensors() {
        let groups = Groups::new(3.0, f64::INFINITY).unwrap();
        let secant = RestitutionTensor::secant(groups).unwrap();
        let tangent = RestitutionTensor::tangent(groups, 1.0).unwrap();
        assert_eq!(tangent.matrix(), secant.matrix());
        assert_eq!(tangent.matrix()[(0, 0)], -1.0);
    }

    #[test]
    fn tangent_is_the_derivative() {
        let (chi, psi, h) = (3.1, 0.8, 1e-4);
        let final_velocity = |v: f64| {
            -v * ObliqueImpact::new(Groups::new(chi, psi * v).unwrap()).unwrap().restitution()
        };
        let difference = (final_velocity(1.0 + h) - final_velocity(1.0 - h)) / (2.0 * h);
        let tangent = RestitutionTensor::tangent(Groups::new(chi, psi).unwrap(), 1.0).unwrap();
        assert!((tangent.matrix()[(0, 0)] + difference).abs() < 1e-7);
    }
}
