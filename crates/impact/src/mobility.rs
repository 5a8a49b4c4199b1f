//! The mobility of a contact: how its velocity answers an impulse, (8.25)-(8.44).

use carom_special::RangeError;
use nalgebra::{Matrix3, Vector3};

use crate::attitude::Attitude;
use crate::body::Inertia;

/// A body's share of D = sum of [R]^T theta^-1 [R] + 1/m, for the arm R from its centre of mass
/// to the contact point and the inverse inertia tensor in the same axes (8.31), (8.43).
#[must_use]
pub(crate) fn share(
    inertia: &Inertia,
    inverse_tensor: &Matrix3<f64>,
    arm: &Vector3<f64>,
) -> Matrix3<f64> {
    let cross = arm.cross_matrix();
    cross.transpose() * inverse_tensor * cross + Matrix3::identity() * inertia.inverse_mass()
}

/// Velocity of a body's contact point.
#[must_use]
pub(crate) fn point_velocity(
    velocity: &Vector3<f64>,
    spin: &Vector3<f64>,
    arm: &Vector3<f64>,
) -> Vector3<f64> {
    velocity + spin.cross(arm)
}

/// What of a body resists an impulse at its contact point: inertia, attitude and arm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lever {
    inertia: Inertia,
    inverse_tensor: Matrix3<f64>,
    arm: Vector3<f64>,
}

impl Lever {
    /// A body of this inertia and attitude; `arm` leads from its centre of mass to the contact
    /// point, in space.
    ///
    /// # Errors
    /// [`RangeError`] unless the arm is finite.
    pub fn new(
        inertia: Inertia,
        attitude: &Attitude,
        arm: Vector3<f64>,
    ) -> Result<Self, RangeError> {
        RangeError::finite("arm", arm.sum())?;
        let turned = attitude.matrix();
        let inverse = Matrix3::from_diagonal(&inertia.inverse_moments());
        let product = turned * inverse * turned.transpose();
        let inverse_tensor = 0.5 * (product + product.transpose());
        Ok(Self { inertia, inverse_tensor, arm })
    }

    /// The inverse of the inertia tensor in space.
    #[must_use]
    pub const fn inverse_tensor(&self) -> &Matrix3<f64> {
        &self.inverse_tensor
    }

    /// From the centre of mass to the contact point.
    #[must_use]
    pub const fn arm(&self) -> Vector3<f64> {
        self.arm
    }

    /// Velocity of the contact point of a body that moves so.
    #[must_use]
    pub fn point_velocity(&self, velocity: &Vector3<f64>, spin: &Vector3<f64>) -> Vector3<f64> {
        point_velocity(velocity, spin, &self.arm)
    }

    /// `E = theta^-1 [R]`, without the mass (8.43), corrected: an impulse J at the contact point
    /// changes the spin by E J.
    #[must_use]
    pub fn turning(&self) -> Matrix3<f64> {
        self.inverse_tensor * self.arm.cross_matrix()
    }

    /// `[R]^T theta^-1 [R] + 1/m` (8.31): an impulse J changes the contact point's velocity by
    /// this times J.
    #[must_use]
    pub fn mobility(&self) -> Matrix3<f64> {
        share(&self.inertia, &self.inverse_tensor, &self.arm)
    }
}

/// The mobility D of a contact in its own axes (8.29), (8.43): an impulse J on body 1, and -J on
/// body 2, changes the velocity v of body 2 against body 1 by -D J.
///
/// ```
/// use carom_impact::{Attitude, Inertia, Lever, Mobility};
/// use nalgebra::{Matrix3, Vector3};
/// let at_rest = Attitude::ALIGNED;
/// let ball = Lever::new(Inertia::solid_sphere(2.0, 1.0)?, &at_rest, -Vector3::z())?;
/// let wall = Lever::new(Inertia::FIXED, &at_rest, Vector3::zeros())?;
/// let d = Mobility::new(&[ball, wall], &Matrix3::identity())?;
/// assert!((d.matrix().m11 - 3.5 * d.matrix().m33).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mobility {
    matrix: Matrix3<f64>,
}

impl Mobility {
    /// The mobility of two bodies in the contact axes, given as columns in space.
    ///
    /// # Errors
    /// As [`Mobility::from_matrix`]; both bodies held fast leave no mobility.
    pub fn new(levers: &[Lever; 2], axes: &Matrix3<f64>) -> Result<Self, RangeError> {
        let sum = levers[0].mobility() + levers[1].mobility();
        Self::from_matrix(axes.transpose() * sum * axes)
    }

    /// A given matrix, of which the symmetric part counts.
    ///
    /// # Errors
    /// [`RangeError`] unless it is finite, symmetric to 1e-9 and positive definite.
    pub fn from_matrix(matrix: Matrix3<f64>) -> Result<Self, RangeError> {
        let skew = (matrix - matrix.transpose()).amax();
        let holds = skew <= 1e-9 * matrix.amax();
        RangeError::check("asymmetry of mobility D", skew, holds, "<= 1e-9 of its largest entry")?;
        let matrix = 0.5 * (matrix + matrix.transpose());
        let factor = matrix.cholesky();
        let determinant = matrix.determinant();
        let holds = factor.is_some() && matrix.iter().all(|d| d.is_finite());
        RangeError::check("determinant of mobility D", determinant, holds, "positive definite D")?;
        Ok(Self { matrix })
    }

    /// The matrix D in contact axes.
    #[must_use]
    pub const fn matrix(&self) -> &Matrix3<f64> {
        &self.matrix
    }

    /// The impulse on body 1 that changes the relative velocity from `before` to `after`:
    /// `J = D^-1 (v_A - v_E)`.
    #[must_use]
    pub fn impulse(&self, before: &Vector3<f64>, after: &Vector3<f64>) -> Vector3<f64> {
        let change = before - after;
        // Positive definite by construction.
        self.matrix.cholesky().map_or(Vector3::zeros(), |factor| factor.solve(&change))
    }

    /// Kinetic energy of the relative motion, `v D^-1 v/2`.
    #[must_use]
    pub fn energy(&self, velocity: &Vector3<f64>) -> f64 {
        0.5 * velocity.dot(&self.impulse(velocity, &Vector3::zeros()))
    }
}
