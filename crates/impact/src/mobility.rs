//! The mobility of a contact: the change of its velocity by an impulse, (8.25)-(8.44).

use carom_geometry::{Attitude, Inertia};
use carom_special::RangeError;
use nalgebra::{Matrix3, Vector3};

use crate::motion::Motion;

/// Couplings below this share of the largest rotational entry of D are round-off: arms are known to
/// some hundred round-off units of the size of the body.
const MAX_COUPLING_OF_ROUND_OFF: f64 = 1e-13;

/// [R]^T theta^-1 [R] for the arm R from the centre of mass to the contact point and the inverse
/// inertia tensor in the same axes (8.31), (8.43).
fn turning_share(inverse_tensor: &Matrix3<f64>, arm: &Vector3<f64>) -> Matrix3<f64> {
    let cross = arm.cross_matrix();
    cross.transpose() * inverse_tensor * cross
}

/// Resistance of a body to an impulse at its contact point: inertia, attitude and arm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lever {
    inertia: Inertia,
    inverse_tensor: Matrix3<f64>,
    arm: Vector3<f64>,
    /// Height of the contact point along the normal, if the shape puts it on the normal through the
    /// centre of mass. Normal and tangential motion are then uncoupled.
    height: Option<f64>,
}

impl Lever {
    /// A body with this inertia and attitude. `arm` is the vector from its centre of mass to the
    /// contact point, in space axes.
    ///
    /// # Errors
    /// [`RangeError`] if the arm is not finite.
    pub fn new(
        inertia: Inertia,
        attitude: &Attitude,
        arm: Vector3<f64>,
    ) -> Result<Self, RangeError> {
        RangeError::finite("arm", arm.sum())?;
        let inverse_tensor = inverse_tensor(&inertia, attitude);
        Ok(Self { inertia, inverse_tensor, arm, height: None })
    }

    /// The same for a body whose shape puts the contact point on the normal through its centre of
    /// mass, at this height: a sphere, or a plane with 0. The normal motion is then uncoupled
    /// exactly, without round-off.
    pub(crate) fn upright(
        inertia: Inertia,
        attitude: &Attitude,
        normal: &Vector3<f64>,
        height: f64,
    ) -> Self {
        let inverse_tensor = inverse_tensor(&inertia, attitude);
        Self { inertia, inverse_tensor, arm: normal * height, height: Some(height) }
    }

    /// The inverse of the inertia tensor in space.
    #[must_use]
    pub const fn inverse_tensor(&self) -> &Matrix3<f64> {
        &self.inverse_tensor
    }

    /// The vector from the centre of mass to the contact point.
    #[must_use]
    pub const fn arm(&self) -> Vector3<f64> {
        self.arm
    }

    /// Velocity of the contact point for this motion of the body.
    #[must_use]
    pub fn point_velocity(&self, velocity: &Vector3<f64>, spin: &Vector3<f64>) -> Vector3<f64> {
        velocity + spin.cross(&self.arm)
    }

    /// The same in the contact axes; the motion is given in space axes.
    pub(crate) fn point_velocity_in(&self, axes: &Matrix3<f64>, motion: &Motion) -> Vector3<f64> {
        axes.tr_mul(&motion.velocity) + axes.tr_mul(&motion.spin).cross(&self.arm_in(axes))
    }

    /// The motion after an impulse at the contact point, given in the contact axes.
    pub(crate) fn pushed(
        &self,
        axes: &Matrix3<f64>,
        motion: &Motion,
        impulse: &Vector3<f64>,
    ) -> Motion {
        let turn = axes * self.arm_in(axes).cross(impulse);
        Motion {
            velocity: motion.velocity + axes * impulse * self.inertia.inverse_mass(),
            spin: motion.spin + self.inverse_tensor * turn,
        }
    }

    fn arm_in(&self, axes: &Matrix3<f64>) -> Vector3<f64> {
        self.height.map_or_else(|| axes.tr_mul(&self.arm), |height| Vector3::new(0.0, 0.0, height))
    }

    // [R]^T theta^-1 [R] in contact axes, the part that couples.
    fn turning_share_in(&self, axes: &Matrix3<f64>) -> Matrix3<f64> {
        let tensor = match self.inertia.is_isotropic() {
            true => self.inverse_tensor,
            false => axes.transpose() * self.inverse_tensor * axes,
        };
        turning_share(&tensor, &self.arm_in(axes))
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
        turning_share(&self.inverse_tensor, &self.arm)
            + Matrix3::identity() * self.inertia.inverse_mass()
    }
}

// theta^-1 in space axes. For equal moments it is the same in all axes, without round-off.
fn inverse_tensor(inertia: &Inertia, attitude: &Attitude) -> Matrix3<f64> {
    let inverse = Matrix3::from_diagonal(&inertia.inverse_moments());
    if inertia.is_isotropic() {
        return inverse;
    }
    let turned = attitude.matrix();
    let product = turned * inverse * turned.transpose();
    0.5 * (product + product.transpose())
}

/// The mobility D of a contact in its own axes (8.29), (8.43): an impulse J on body 1, and -J on
/// body 2, changes the velocity v of body 2 against body 1 by -D J.
///
/// ```
/// use carom_geometry::{Attitude, Inertia};
/// use carom_impact::{Lever, Mobility};
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
    /// The mobility of two bodies in the contact axes, given as columns in space axes. Couplings
    /// within the round-off of the arms are set to zero.
    ///
    /// # Errors
    /// As [`Mobility::from_matrix`]; also if neither body can be moved.
    pub fn new(levers: &[Lever; 2], axes: &Matrix3<f64>) -> Result<Self, RangeError> {
        let [one, two] = levers.each_ref().map(|lever| lever.turning_share_in(axes));
        let round_off = MAX_COUPLING_OF_ROUND_OFF * (one.amax() + two.amax());
        let turning = (one + two).map(|d| if d.abs() <= round_off { 0.0 } else { d });
        let along = levers[0].inertia.inverse_mass() + levers[1].inertia.inverse_mass();
        Self::from_matrix(turning + Matrix3::identity() * along)
    }

    /// The mobility of a given matrix, of which the symmetric part is used.
    ///
    /// # Errors
    /// [`RangeError`] if it is not finite, not symmetric to 1e-9 or not positive definite.
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
