//! The edge of a tube as the flange meets it.

use carom_dense::c64;
use carom_special::RangeError;
use nalgebra::{Complex, Matrix4};

/// A motion of an edge or of a section of the ring.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EdgeMotion {
    /// w, outward.
    Radial,
    /// v, along phi.
    Tangential,
    /// u, along the tube.
    Axial,
    /// beta = dw/dx.
    Rotation,
}

/// Stiffness of the edge of a tube in one harmonic e^(ik phi): a Hermitian 4 by 4 matrix K on the
/// coefficients (w, v, u, beta). The energy of a motion is y^H K y/2, summed over k.
///
/// ```
/// use carom_shells::{Wall, flange::{EdgeMotion, Tube}};
/// let tube = Tube::half_momentless(1.0, Wall::new(1.0, 0.3, 0.02)?)?;
/// let ovalling = tube.edge_stiffness(2)?;
/// // w alone strains only the boundary part: 8 pi R D lambda^3.
/// let radial = ovalling.entry(EdgeMotion::Radial, EdgeMotion::Radial);
/// assert!((radial.re - 0.0138256).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgeStiffness {
    matrix: Matrix4<c64>,
}

impl EdgeStiffness {
    pub(super) const fn new(matrix: Matrix4<c64>) -> Self {
        Self { matrix }
    }

    /// The load on one motion due to another of size 1.
    #[must_use]
    pub fn entry(&self, on: EdgeMotion, by: EdgeMotion) -> Complex<f64> {
        self.matrix[(on as usize, by as usize)]
    }

    pub(super) const fn matrix(&self) -> &Matrix4<c64> {
        &self.matrix
    }
}

/// Where the edge of the tube meets the section of the ring, from its centroid. The section is
/// rigid: the edge moves by w + e_x beta, v (1 + e_r/R) - e_r w'/R - e_x u'/R and u - e_r beta.
///
/// ```
/// use carom_shells::flange::TubeEdge;
/// let edge = TubeEdge::new(0.04, -0.03)?; // further along the tube, and inside
/// assert_eq!(edge.outward(), -0.03);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TubeEdge {
    along: f64,
    outward: f64,
}

impl TubeEdge {
    /// At the centroid.
    #[must_use]
    pub const fn at_centroid() -> Self {
        Self { along: 0.0, outward: 0.0 }
    }

    /// At `along` (e_x) and `outward` (e_r) of the centroid.
    ///
    /// # Errors
    /// [`RangeError`] unless both are finite.
    pub fn new(along: f64, outward: f64) -> Result<Self, RangeError> {
        Ok(Self {
            along: RangeError::finite("along", along)?,
            outward: RangeError::finite("outward", outward)?,
        })
    }

    /// Distance from the centroid along x.
    #[must_use]
    pub const fn along(&self) -> f64 {
        self.along
    }

    /// Distance from the centroid outward.
    #[must_use]
    pub const fn outward(&self) -> f64 {
        self.outward
    }

    /// Motion of the edge due to (w, v, u, beta) of a ring of this radius in harmonic k.
    pub(super) fn motion(&self, radius: f64, k: i64) -> Matrix4<c64> {
        let k = k as f64;
        let real = |value: f64| c64::new(value, 0.0);
        let slope = |length: f64| c64::new(0.0, -k * length / radius);
        let mut motion = Matrix4::identity();
        motion[(0, 3)] = real(self.along);
        motion[(1, 0)] = slope(self.outward);
        motion[(1, 1)] = real(1.0 + self.outward / radius);
        motion[(1, 2)] = slope(self.along);
        motion[(2, 3)] = real(-self.outward);
        motion
    }
}
