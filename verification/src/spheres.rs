//! Solid spheres of one material, by Poisson's ratio.

/// kappa = c_z/c_x.
pub(crate) fn kappa(nu: f64) -> f64 {
    (2.0 - nu) / (2.0 * (1.0 - nu))
}

/// chi = 7/(2 kappa).
pub(crate) fn chi(nu: f64) -> f64 {
    7.0 * (1.0 - nu) / (2.0 - nu)
}
