//! The displacement under a semi-ellipsoidal traction on a circle, inside and outside: (6.6).

use std::f64::consts::PI;

/// Relative displacement u_1 - u_2 along the traction `sqrt(1 - (rho/a)^2)` at the point (rho,
/// theta = 0), times the combined shear modulus G of (4.7): half of (6.6), whose G is that of one
/// body.
pub(super) fn along(radius: f64, rho: f64, poisson: f64) -> f64 {
    let (a, r) = (radius, rho);
    if r <= a {
        return PI / (32.0 * a) * (2.0 * (2.0 - poisson) * (2.0 * a * a - r * r) + poisson * r * r);
    }
    let (arc, root) = (libm::asin(a / r), ((r - a) * (r + a)).sqrt());
    let mean = (2.0 * a * a - r * r) * arc + a * root;
    let twofold = r * r * arc + a * (2.0 * a * a / (r * r) - 1.0) * root;
    (2.0 * (2.0 - poisson) * mean + poisson * twofold) / (16.0 * a)
}

/// Relative normal displacement w_1 + w_2 under the pressure `sqrt(1 - (rho/a)^2)`, times
/// G/(1 - nu).
pub(super) fn normal(radius: f64, rho: f64) -> f64 {
    let (a, r) = (radius, rho);
    let shape = if r <= a {
        0.5 * PI * (2.0 * a * a - r * r)
    } else {
        (2.0 * a * a - r * r) * libm::asin(a / r) + a * ((r - a) * (r + a)).sqrt()
    };
    shape / (4.0 * a)
}
