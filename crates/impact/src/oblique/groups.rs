//! The dimensionless groups of an uncoupled oblique impact.

use carom_special::RangeError;

/// chi and psi, the two dimensionless groups of an uncoupled impact in one direction.
///
/// ```
/// use carom_impact::oblique::Groups;
/// let spheres = Groups::of_spheres(1.2, 2.0)?; // kappa, lambda
/// assert!((spheres.chi() - 3.5 / 1.2).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Groups {
    chi: f64,
    psi: f64,
}

/// Largest chi accepted, far above that of any body: solid bodies have chi <= 7.5.
const CHI_MAX: f64 = 100.0;

impl Groups {
    /// `chi = D_xx c_x/(D_zz c_z)` in (0, 100], `psi = c_x |xi'|/(f c_z zeta') >= 0`.
    ///
    /// `psi = infinity` is without friction; `psi = 0` is infinite friction or no tangential
    /// motion.
    ///
    /// # Errors
    /// [`RangeError`] that names `chi` or `psi` if it is out of range.
    pub fn new(chi: f64, psi: f64) -> Result<Self, RangeError> {
        RangeError::check("chi", chi, chi > 0.0 && chi <= CHI_MAX, "in (0, 100]")?;
        RangeError::check("psi", psi, psi >= 0.0, ">= 0")?;
        Ok(Self { chi, psi })
    }

    /// Solid spheres with stiffness ratio `kappa` (15.1) and impact parameter `lambda`
    /// = |xi'|/(f zeta') (15.1).
    ///
    /// # Errors
    /// [`RangeError`] unless kappa is in (0.75, 1.5] (Poisson's ratio in (-1, 0.5]) and lambda >= 0.
    pub fn of_spheres(kappa: f64, lambda: f64) -> Result<Self, RangeError> {
        // Computed from nu, 3/2 may come out above itself by round-off.
        let holds = kappa > 0.75 && kappa <= 1.5 * (1.0 + 4.0 * f64::EPSILON);
        RangeError::check(
            "kappa",
            kappa,
            holds,
            "in (0.75, 1.5], for Poisson's ratios from -1 to 1/2",
        )?;
        RangeError::check("lambda", lambda, lambda >= 0.0, ">= 0")?;
        Self::new(3.5 / kappa, lambda / kappa)
    }

    /// chi = D_xx c_x/(D_zz c_z).
    #[must_use]
    pub fn chi(&self) -> f64 {
        self.chi
    }

    /// psi = c_x |xi'|/(f c_z zeta').
    #[must_use]
    pub fn psi(&self) -> f64 {
        self.psi
    }
}
