//! The tangential coefficient of restitution as a function of the governing numbers.

use carom_special::RangeError;

use crate::oblique::{Groups, ObliqueError, ObliqueImpact};

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
