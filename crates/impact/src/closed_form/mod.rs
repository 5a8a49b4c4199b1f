//! Closed forms of chapter 9: limits of the oblique impact that need no integration.

use carom_special::RangeError;
use carom_special::gamma::reciprocal as reciprocal_gamma;

use crate::normal::DURATION;

mod adhesion;
mod constants;
mod energy;
mod wave_loss;

pub use adhesion::{AdhesiveCompression, compression_time};
pub use constants::ImpactConstants;
pub use energy::{normal_energy_loss, tangential_energy_loss};
pub use wave_loss::{radiation_coefficient, wave_loss, wave_loss_coefficient};

/// phi = sqrt(1 + 120 chi) of (9.15), the parameter of the adhesion solutions: from sqrt(61) to sqrt(721)
/// for chi from 1/2 to 6 (15.9).
#[must_use]
pub fn phi(chi: f64) -> f64 {
    (1.0 + 120.0 * chi).sqrt()
}

/// R_x of an impact without slip (9.46): 1 - 2 u^2, u = F((1-phi)/20, (1+phi)/20; 3/5; 1).
///
/// The limit of small tangential velocities or infinite friction, for any positive
/// `chi = D_xx c_x/(D_zz c_z)`. u follows from Gauss's theorem,
/// u = Gamma(3/5) Gamma(1/2) / (Gamma((11-phi)/20) Gamma((11+phi)/20)).
///
/// ```
/// use carom_impact::closed_form::restitution_without_slip;
/// // Spheres with nu = 0: chi = 7/2.
/// assert!((restitution_without_slip(3.5) + 0.386_984_566_472_707_8).abs() < 1e-14);
/// assert!((restitution_without_slip(1.0) - 1.0).abs() < 1e-15);
/// ```
#[must_use]
pub fn restitution_without_slip(chi: f64) -> f64 {
    const GAMMA_3_5: f64 = 1.489_192_248_812_817_1;
    let phi = phi(chi);
    // 1 - phi^2 = -120 chi: (11 - phi)/20 without cancellation near its zero at chi = 1.
    let low = (120.0 - 120.0 * chi) / (20.0 * (11.0 + phi));
    let u = GAMMA_3_5
        * std::f64::consts::PI.sqrt()
        * reciprocal_gamma(low)
        * reciprocal_gamma((11.0 + phi) / 20.0);
    1.0 - 2.0 * u * u
}

/// R_x of an impact that slides throughout (9.33): -1 + 2 chi/psi.
///
/// `None` outside its range of validity psi >= max(1, 2 chi - 1). The printed condition R_x < 0 is
/// only sufficient: spheres slide throughout from lambda = 7 - kappa on, not from 7.
///
/// ```
/// use carom_impact::closed_form::restitution_in_sliding;
/// assert_eq!(restitution_in_sliding(3.5, 7.0), Some(0.0));
/// assert_eq!(restitution_in_sliding(3.5, 5.9), None);
/// ```
#[must_use]
pub fn restitution_in_sliding(chi: f64, psi: f64) -> Option<f64> {
    (psi >= 1.0 && psi >= 2.0 * chi - 1.0).then(|| 2.0 * chi / psi - 1.0)
}

/// Duration of the impact (9.8), (9.50): T = 2.943.. zeta_max/zeta'_A.
///
/// # Errors
/// [`RangeError`] unless both are finite and positive.
pub fn duration(maximal_approach: f64, velocity: f64) -> Result<f64, RangeError> {
    RangeError::positive("maximal_approach", maximal_approach)?;
    RangeError::positive("velocity", velocity)?;
    Ok(DURATION * maximal_approach / velocity)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn full_reversal_where_the_release_retraces_the_loading() {
        // phi = 11 and 31: (11 - phi)/20 = 0 and -1.
        assert_eq!(restitution_without_slip(1.0), 1.0);
        assert!((restitution_without_slip(8.0) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn sliding_range_is_maw_barber_fawcetts() {
        assert!(restitution_in_sliding(3.5, 6.0).is_some());
        assert_eq!(restitution_in_sliding(0.4, 0.9), None);
    }
}
