//! The tangential coefficient of restitution as a function of the governing numbers.

use carom_special::RangeError;

use crate::oblique::{Groups, ObliqueError, ObliqueImpact};
use crate::viscoelastic::{ViscoelasticImpact, ViscousLoss};

mod dissimilar;
mod map;
mod sensitivity;
mod table;
mod tensor;

pub use dissimilar::{
    DissimilarGroups, DissimilarMethod, DissimilarRestitution, DissimilarTable, check_dissimilar,
    fill_dissimilar, of_dissimilar,
};
pub use map::restitution_map;
pub use sensitivity::Sensitivity;
pub use table::RestitutionTable;
pub use tensor::RestitutionTensor;

/// Why a coefficient of restitution cannot be given.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum RestitutionError {
    /// An argument out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The impact could not be followed.
    #[error(transparent)]
    Oblique(#[from] ObliqueError),
}

/// R_x of solid spheres as function of kappa (15.1) and lambda = |xi'|/(f zeta') (fig. 15.2).
///
/// ```
/// use carom_impact::restitution::of_spheres;
/// // Sliding throughout from lambda = 7 - kappa on: R_x = -1 + 7/lambda.
/// assert_eq!(of_spheres(1.0, 7.0)?, 0.0);
/// # Ok::<(), carom_impact::restitution::RestitutionError>(())
/// ```
///
/// # Errors
/// [`RestitutionError::Range`] unless kappa is in (0.75, 1.5] and lambda >= 0.
pub fn of_spheres(kappa: f64, lambda: f64) -> Result<f64, RestitutionError> {
    Ok(ObliqueImpact::new(Groups::of_spheres(kappa, lambda)?)?.restitution())
}

/// R_x of any bodies whose normal and tangential motions are uncoupled, by chi and psi.
///
/// # Errors
/// [`RestitutionError::Range`] unless chi is in (0, 100] and psi >= 0.
pub fn of_groups(chi: f64, psi: f64) -> Result<f64, RestitutionError> {
    Ok(ObliqueImpact::new(Groups::new(chi, psi)?)?.restitution())
}

/// R_x of an impact of a viscous material whose normal restitution is `normal` (e): exact for Kelvin-Voigt bodies, by
/// [`crate::viscoelastic`], within 1e-5.
///
/// ```
/// use carom_impact::{oblique::Groups, restitution::with_normal_restitution};
/// // Sliding: 1 + R_x = f (1 + e) v_z D_xx/(D_zz v_x) = (1 + e) chi/psi.
/// let sliding = with_normal_restitution(Groups::new(3.0, 8.0)?, 0.5)?;
/// assert!((sliding - (1.5 * 3.0 / 8.0 - 1.0)).abs() < 1e-15);
/// let sticking = with_normal_restitution(Groups::of_spheres(1.2, 2.0)?, 0.5)?;
/// assert!((sticking - 0.15564).abs() < 2e-5);
/// # Ok::<(), carom_impact::restitution::RestitutionError>(())
/// ```
///
/// # Errors
/// [`RestitutionError::Range`] unless e is in [0, 1].
pub fn with_normal_restitution(groups: Groups, normal: f64) -> Result<f64, RestitutionError> {
    let loss = ViscousLoss::of_restitution(normal)?;
    if normal == 1.0 {
        return Ok(ObliqueImpact::new(groups)?.restitution());
    }
    Ok(ViscoelasticImpact::new(groups, loss).solve(TOLERANCE).restitution)
}

/// Tolerance of R_x with a loss.
const TOLERANCE: f64 = 1e-5;

/// R_x of an impact of bodies that yield, whose normal restitution is `normal` (e), by
/// [`crate::NormalRestitution::by_yield`]: `R_x = (1 + e)(1 + R_x elastic)/2 - 1`.
///
/// ```
/// use carom_impact::{oblique::Groups, restitution::with_yield};
/// let sliding = with_yield(Groups::new(3.0, 8.0)?, 0.5)?;
/// assert!((sliding - (1.5 * 3.0 / 8.0 - 1.0)).abs() < 1e-15);
/// # Ok::<(), carom_impact::restitution::RestitutionError>(())
/// ```
///
/// # Errors
/// [`RestitutionError::Range`] unless e is in [0, 1].
pub fn with_yield(groups: Groups, normal: f64) -> Result<f64, RestitutionError> {
    RangeError::check("normal_restitution", normal, (0.0..=1.0).contains(&normal), "from 0 to 1")?;
    let elastic = ObliqueImpact::new(groups)?.restitution();
    Ok(0.5 * (1.0 + normal) * (1.0 + elastic) - 1.0)
}
