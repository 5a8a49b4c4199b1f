//! The attitude of a body: the directions of its axes in space.

use carom_special::RangeError;
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use crate::direction::perpendicular;

/// Greatest deviation of the norm of a quaternion from one; a smaller one is normalised.
const NORM_TOLERANCE: f64 = 1e-6;

/// The rotation between a body's axes (a, b, c) and the axes of space (x, y, z).
///
/// ```
/// use carom_geometry::Attitude;
/// use nalgebra::Vector3;
/// let half = std::f64::consts::FRAC_1_SQRT_2;
/// let turned = Attitude::from_quaternion([half, 0.0, 0.0, half])?; // 90 degrees about z
/// assert!((turned.to_space(&Vector3::x()) - Vector3::y()).norm() < 1e-15);
/// assert!(Attitude::from_quaternion([1.0, 0.1, 0.0, 0.0]).is_err());
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attitude {
    rotation: Matrix3<f64>,
}

impl Default for Attitude {
    fn default() -> Self {
        Self::ALIGNED
    }
}

impl Attitude {
    /// The body's axes are parallel to those of space.
    pub const ALIGNED: Self =
        Self { rotation: Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0) };

    /// From a unit quaternion (w, i, j, k) that rotates body components into space components.
    ///
    /// # Errors
    /// [`RangeError`] unless its norm is 1 to within 1e-6.
    pub fn from_quaternion(components: [f64; 4]) -> Result<Self, RangeError> {
        let [w, i, j, k] = components;
        let quaternion = Quaternion::new(w, i, j, k);
        let norm = quaternion.norm();
        RangeError::check(
            "quaternion norm",
            norm,
            (norm - 1.0).abs() <= NORM_TOLERANCE,
            "1 to within 1e-6",
        )?;
        let unit = UnitQuaternion::from_quaternion(quaternion);
        Ok(Self { rotation: unit.to_rotation_matrix().into_inner() })
    }

    /// From the three angles of the thesis, in radians: starting from the axes of space, rotate by
    /// gamma about z, by beta about the new y, by alpha about the newest x (8.3), corrected.
    ///
    /// # Errors
    /// [`RangeError`] that names the first angle that is not finite.
    pub fn from_angles(alpha: f64, beta: f64, gamma: f64) -> Result<Self, RangeError> {
        RangeError::finite("alpha", alpha)?;
        RangeError::finite("beta", beta)?;
        RangeError::finite("gamma", gamma)?;
        Ok(Self { rotation: angle_matrix(alpha, beta, gamma).transpose() })
    }

    /// From a rotation axis and an angle about it, in radians.
    ///
    /// # Errors
    /// [`RangeError`] unless the axis is finite and not zero and the angle is finite.
    pub fn about(axis: [f64; 3], angle: f64) -> Result<Self, RangeError> {
        let axis = Vector3::from(axis);
        RangeError::positive("rotation axis", axis.norm())?;
        RangeError::finite("rotation angle", angle)?;
        let (sin, cos) = libm::sincos(0.5 * angle);
        let vector = axis.normalize() * sin;
        let unit = UnitQuaternion::from_quaternion(Quaternion::from_parts(cos, vector));
        Ok(Self { rotation: unit.to_rotation_matrix().into_inner() })
    }

    /// An attitude with the body's axis c in this direction.
    ///
    /// # Errors
    /// [`RangeError`] unless the direction is finite and not zero.
    pub fn facing(direction: [f64; 3]) -> Result<Self, RangeError> {
        let vector = Vector3::from(direction);
        let length = vector.norm();
        RangeError::positive("normal", length)?;
        Ok(Self::along(&(vector / length)))
    }

    /// [`Attitude::facing`] for a unit vector.
    pub(crate) fn along(direction: &Vector3<f64>) -> Self {
        let first = perpendicular(direction);
        Self { rotation: Matrix3::from_columns(&[first, direction.cross(&first), *direction]) }
    }

    /// From the matrix of (8.1), which rotates space components into body components. Its rows are
    /// the body's axes in space.
    ///
    /// # Errors
    /// [`RangeError`] unless the matrix is a proper rotation to within 1e-6.
    pub fn from_matrix(to_body: Matrix3<f64>) -> Result<Self, RangeError> {
        let residue = (to_body * to_body.transpose() - Matrix3::identity()).amax();
        let allowed = "orthogonal to within 1e-6";
        RangeError::check("rotation matrix residue", residue, residue <= NORM_TOLERANCE, allowed)?;
        let determinant = to_body.determinant();
        RangeError::check("rotation determinant", determinant, determinant > 0.0, "+1")?;
        Ok(Self { rotation: orthonormal(&to_body).transpose() })
    }

    /// The matrix that rotates space components into body components.
    #[must_use]
    pub const fn matrix(&self) -> &Matrix3<f64> {
        &self.rotation
    }

    /// Space components of a vector given in the body's axes.
    #[must_use]
    pub fn to_space(&self, in_body: &Vector3<f64>) -> Vector3<f64> {
        self.rotation * in_body
    }

    /// Components in the body's axes of a vector in space.
    #[must_use]
    pub fn to_body(&self, in_space: &Vector3<f64>) -> Vector3<f64> {
        self.rotation.tr_mul(in_space)
    }
}

/// Pi of (8.5), corrected: rotates components in (x, y, z) into components in (a, b, c).
///
/// ```
/// let pi = carom_geometry::angle_matrix(0.4, 0.3, 1.2);
/// assert!((pi * pi.transpose() - nalgebra::Matrix3::identity()).amax() < 1e-15);
/// ```
#[must_use]
pub fn angle_matrix(alpha: f64, beta: f64, gamma: f64) -> Matrix3<f64> {
    let ((sa, ca), (sb, cb)) = (libm::sincos(alpha), libm::sincos(beta));
    let (sg, cg) = libm::sincos(gamma);
    Matrix3::new(
        cb * cg,
        cb * sg,
        -sb,
        sa * sb * cg - ca * sg,
        sa * sb * sg + ca * cg,
        sa * cb,
        ca * sb * cg + sa * sg,
        ca * sb * sg - sa * cg,
        ca * cb,
    )
}

// Gram-Schmidt on the rows.
fn orthonormal(matrix: &Matrix3<f64>) -> Matrix3<f64> {
    let first = matrix.row(0).transpose().normalize();
    let second = matrix.row(1).transpose();
    let second = (second - first * first.dot(&second)).normalize();
    Matrix3::from_rows(&[first.transpose(), second.transpose(), first.cross(&second).transpose()])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_three_turns_in_their_order() {
        let (alpha, beta, gamma) = (0.7, -0.4, 2.1);
        let about = |axis: [f64; 3], angle| *Attitude::about(axis, angle).unwrap().matrix();
        // Intrinsic turns multiply from the right: z, then y', then x''.
        let product = about([0.0, 0.0, 1.0], gamma)
            * about([0.0, 1.0, 0.0], beta)
            * about([1.0, 0.0, 0.0], alpha);
        let own = Attitude::from_angles(alpha, beta, gamma).unwrap();
        assert!((own.matrix() - product).amax() < 1e-15);
        let back = Attitude::from_matrix(product.transpose()).unwrap();
        assert!((back.matrix() - product).amax() < 1e-15);
    }

    #[test]
    fn what_is_no_rotation_is_refused() {
        let field = |result: Result<Attitude, RangeError>| result.unwrap_err().field;
        assert_eq!(field(Attitude::from_quaternion([0.0; 4])), "quaternion norm");
        assert_eq!(field(Attitude::from_quaternion([f64::NAN; 4])), "quaternion norm");
        for (i, name) in ["alpha", "beta", "gamma"].into_iter().enumerate() {
            let [alpha, beta, gamma] = [0, 1, 2].map(|k| if k == i { f64::INFINITY } else { 0.0 });
            assert_eq!(field(Attitude::from_angles(alpha, beta, gamma)), name);
        }
        assert_eq!(field(Attitude::about([0.0; 3], 1.0)), "rotation axis");
        let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, -1.0));
        assert_eq!(field(Attitude::from_matrix(mirror)), "rotation determinant");
        assert_eq!(field(Attitude::from_matrix(2.0 * mirror)), "rotation matrix residue");
    }

    /// To 1e-6, of quaternions and of matrices.
    #[test]
    fn a_rotation_may_be_off_by_its_stated_tolerance() {
        for (off, holds) in [(0.9e-6, true), (1.1e-6, false)] {
            for norm in [1.0 - off, 1.0 + off] {
                let quaternion = [0.5, 0.5, -0.5, 0.5].map(|part| norm * part);
                assert_eq!(Attitude::from_quaternion(quaternion).is_ok(), holds, "{norm}");
            }
            // Of a stretch by s, s^2 - 1 is left.
            let stretched = Matrix3::identity() * (1.0 + 0.5 * off);
            assert_eq!(Attitude::from_matrix(stretched).is_ok(), holds, "{off}");
        }
    }
}
