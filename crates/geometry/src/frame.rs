//! The contact frame: common normal, principal directions of the relative curvature, A >= B.

use crate::curvature::{CurvatureError, PrincipalRadii, RelativeCurvature};
use nalgebra::{Matrix3, Vector3};

use crate::surface::LocalSurface;

/// Greatest angle between the outward normal of one body and the reversed normal of the other,
/// radians.
const NORMAL_TOLERANCE: f64 = 1e-5;

/// Why two surfaces have no contact frame.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum FrameError {
    /// The surfaces conform, or touch along a line.
    #[error(transparent)]
    Curvature(#[from] CurvatureError),
    /// The surfaces do not face each other.
    #[error("the outward normals are {angle} rad from opposite, more than {NORMAL_TOLERANCE}")]
    NotOpposed {
        /// Angle between the normal of body 2 and the reversed normal of body 1, radians.
        angle: f64,
    },
}

/// The axes of a contact: z along the common normal into body 1, x along the larger relative
/// curvature 2A, y along the smaller one 2B.
///
/// The gap between the undeformed surfaces is A x^2 + B y^2. If A = B, x is any tangential
/// direction.
///
/// ```
/// use carom_geometry::{Attitude, ContactFrame, Surface};
/// use nalgebra::Vector3;
/// let egg = Surface::ellipsoid([3.0, 2.0, 1.5])?.local(&Vector3::new(0.0, 0.0, -1.5))?;
/// let table = Surface::plane().local(&Vector3::zeros())?;
/// let frame = ContactFrame::new(&egg, &table)?;
/// assert!((frame.relative_curvature().a() - 0.5 * 0.375).abs() < 1e-15);
/// // The larger curvature lies along axis b of the ellipsoid.
/// assert!(frame.x().y.abs() > 1.0 - 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactFrame {
    axes: Matrix3<f64>,
    relative: RelativeCurvature,
}

impl ContactFrame {
    /// The contact frame of two surfaces at the point where they touch, both given in space.
    ///
    /// The shape operators of both bodies, each relative to its own inward normal, are added; x is
    /// the direction of the larger eigenvalue.
    ///
    /// # Errors
    /// [`FrameError::Curvature`] if B <= 0 (conforming surfaces, line contact),
    /// [`FrameError::NotOpposed`] if the normals are not opposite.
    pub fn new(one: &LocalSurface, two: &LocalSurface) -> Result<Self, FrameError> {
        let into_one = two.normal() - one.normal();
        let angle = libm::asin((0.5 * (two.normal() + one.normal()).norm()).min(1.0)) * 2.0;
        if angle.is_nan() || angle > NORMAL_TOLERANCE {
            return Err(FrameError::NotOpposed { angle });
        }
        let z = into_one.normalize();
        let (x_1, x_2) = (in_plane(&one.direction(), &z), in_plane(&two.direction(), &z));
        // About z, from the first principal direction of body 1 to that of body 2.
        let omega = libm::atan2(z.dot(&x_1.cross(&x_2)), x_1.dot(&x_2));
        let relative = RelativeCurvature::new(radii(one)?, radii(two)?, omega)?;
        let (sin, cos) = libm::sincos(relative.angle());
        let x = in_plane(&(x_1 * cos + z.cross(&x_1) * sin), &z);
        Ok(Self { axes: Matrix3::from_columns(&[x, z.cross(&x), z]), relative })
    }

    /// The axes as columns: rotates contact components into space components.
    #[must_use]
    pub const fn axes(&self) -> &Matrix3<f64> {
        &self.axes
    }

    /// The x axis, direction of the larger relative curvature.
    #[must_use]
    pub fn x(&self) -> Vector3<f64> {
        self.axes.column(0).into()
    }

    /// The y axis.
    #[must_use]
    pub fn y(&self) -> Vector3<f64> {
        self.axes.column(1).into()
    }

    /// The common normal, from body 2 into body 1.
    #[must_use]
    pub fn z(&self) -> Vector3<f64> {
        self.axes.column(2).into()
    }

    /// The coefficients A >= B of the gap.
    #[must_use]
    pub const fn relative_curvature(&self) -> RelativeCurvature {
        self.relative
    }

    /// Contact components of a vector in space.
    #[must_use]
    pub fn to_contact(&self, in_space: &Vector3<f64>) -> Vector3<f64> {
        self.axes.tr_mul(in_space)
    }

    /// Space components of a vector given in the contact axes.
    #[must_use]
    pub fn to_space(&self, in_contact: &Vector3<f64>) -> Vector3<f64> {
        self.axes * in_contact
    }
}

fn in_plane(direction: &Vector3<f64>, normal: &Vector3<f64>) -> Vector3<f64> {
    (direction - normal * normal.dot(direction)).normalize()
}

fn radii(local: &LocalSurface) -> Result<PrincipalRadii, CurvatureError> {
    let [k_1, k_2] = local.curvatures();
    Ok(PrincipalRadii::new(1.0 / k_1, 1.0 / k_2)?)
}
