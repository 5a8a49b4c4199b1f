//! The tube: theory, length and the stiffness of its edge.

use std::f64::consts::PI;

use carom_special::RangeError;
use nalgebra::Matrix4;

use super::FlangeError;
use super::edge::EdgeStiffness;
use super::{half_momentless, whole_shell};
use crate::Wall;

/// Greatest thickness over radius of a thin tube.
const THICKEST: f64 = 0.2;
/// Least thickness over radius. Below it the strains of stretching and bending differ by more than
/// double precision holds.
const THINNEST: f64 = 1e-6;
/// Least length in sqrt(radius * thickness): the edge effects of both ends stay apart (e^-5).
const SHORTEST: f64 = 4.0;

/// How far the tube reaches, and by what theory.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Theory {
    HalfMomentless,
    HalfMomentlessUpTo { length: f64 },
    KoiterSanders,
}

/// A circular cylindrical tube of constant wall at x >= 0.
///
/// - **Half-momentless** (Vlasov, Axelrad): no hoop strain, no shear, no axial moment inside; each
///   harmonic is a beam on an elastic foundation, W'''' + 4 mu^4 W = 0 with
///   4 mu^4 = n^4 (n^2-1)^2 t^2/(12(1-nu^2) R^6). An edge effect that decays with
///   lambda = (3(1-nu^2))^(1/4)/sqrt(R t) takes the rest of the motion of the edge. It holds for
///   n^2 t/R << 1.
/// - **Koiter-Sanders**: the whole linear shell theory, semi-infinite, for every |n| >= 2.
///
/// ```
/// use carom_shells::{Wall, flange::Tube};
/// let wall = Wall::new(2e11, 0.3, 2e-3)?;
/// let tube = Tube::half_momentless(0.1, wall)?;
/// // The boundary part decays within millimetres, ovalling reaches many radii.
/// assert!(1.0 / tube.boundary_decay() < 0.02 && 1.0 / tube.main_decay(2) > 0.3);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tube {
    radius: f64,
    wall: Wall,
    theory: Theory,
}

impl Tube {
    /// A semi-infinite tube by the half-momentless theory.
    ///
    /// # Errors
    /// [`RangeError`] unless the radius is positive and thickness/radius from 1e-6 to 0.2.
    pub fn half_momentless(radius: f64, wall: Wall) -> Result<Self, RangeError> {
        Self::new(radius, wall, Theory::HalfMomentless)
    }

    /// A tube of length `length` by the half-momentless theory, clamped at its far end.
    ///
    /// # Errors
    /// [`RangeError`] as above, and unless the length is from 4 sqrt(R t), so that the edge effects
    /// of both ends stay apart, to 1e6 R.
    pub fn half_momentless_clamped(
        radius: f64,
        wall: Wall,
        length: f64,
    ) -> Result<Self, RangeError> {
        let tube = Self::new(radius, wall, Theory::HalfMomentlessUpTo { length })?;
        let shortest = SHORTEST * (radius * wall.thickness()).sqrt();
        let fits = (shortest..=1e6 * radius).contains(&length);
        RangeError::check("length", length, fits, "from 4 sqrt(radius * thickness) to 1e6 radius")?;
        Ok(tube)
    }

    /// A semi-infinite tube by the shell theory of Koiter and Sanders. For |n| <= 1 it is the
    /// half-momentless theory.
    ///
    /// # Errors
    /// [`RangeError`] as for [`Tube::half_momentless`].
    pub fn koiter_sanders(radius: f64, wall: Wall) -> Result<Self, RangeError> {
        Self::new(radius, wall, Theory::KoiterSanders)
    }

    fn new(radius: f64, wall: Wall, theory: Theory) -> Result<Self, RangeError> {
        let radius = RangeError::positive("radius", radius)?;
        let fits = (THINNEST..=THICKEST).contains(&(wall.thickness() / radius));
        let allowed = "from 1e-6 to 0.2 of the radius";
        RangeError::check("thickness", wall.thickness(), fits, allowed)?;
        Ok(Self { radius, wall, theory })
    }

    /// Radius R of the middle surface.
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// Its wall.
    #[must_use]
    pub const fn wall(&self) -> &Wall {
        &self.wall
    }

    /// Length, if the far end is clamped; otherwise the tube is semi-infinite.
    #[must_use]
    pub const fn length(&self) -> Option<f64> {
        match self.theory {
            Theory::HalfMomentlessUpTo { length } => Some(length),
            Theory::HalfMomentless | Theory::KoiterSanders => None,
        }
    }

    /// Whether its theory is that of the whole shell (Koiter, Sanders).
    #[must_use]
    pub const fn is_whole_shell(&self) -> bool {
        matches!(self.theory, Theory::KoiterSanders)
    }

    /// mu of the main part in harmonic n: it decays as e^(-mu x); 0 for n <= 1.
    #[must_use]
    pub fn main_decay(&self, n: usize) -> f64 {
        half_momentless::main_decay(self, n as f64)
    }

    /// lambda of the boundary part: it decays as e^(-lambda x).
    #[must_use]
    pub fn boundary_decay(&self) -> f64 {
        half_momentless::boundary_decay(self)
    }

    /// Stiffness of its edge in harmonic k, |k| <= 1000.
    ///
    /// # Errors
    /// [`FlangeError::Range`] for k out of range; [`FlangeError::Singular`] if the four decaying
    /// solutions of the whole shell cannot be told apart.
    pub fn edge_stiffness(&self, k: i64) -> Result<EdgeStiffness, FlangeError> {
        let fits = (-1000..=1000).contains(&k);
        RangeError::check("k", k as f64, fits, "from -1000 to 1000")?;
        let matrix = match self.theory {
            Theory::HalfMomentless => half_momentless::stiffness(self, k),
            Theory::HalfMomentlessUpTo { length } => {
                half_momentless::stiffness(self, k) + self.ends(k, length)
            }
            Theory::KoiterSanders if k.abs() < 2 => half_momentless::stiffness(self, k),
            Theory::KoiterSanders => whole_shell::stiffness(self, k)?,
        };
        Ok(EdgeStiffness::new(matrix))
    }

    /// Uniform stretching and twisting between the ends, which the main part does not contain.
    fn ends(&self, k: i64, length: f64) -> Matrix4<carom_dense::c64> {
        let mut matrix = Matrix4::<carom_dense::c64>::zeros();
        if k == 0 {
            let section = 2.0 * PI * self.radius * self.wall.thickness() / length;
            matrix[(1, 1)].re = section * self.wall.shear_modulus();
            matrix[(2, 2)].re = section * self.wall.young_modulus();
        }
        matrix
    }
}
