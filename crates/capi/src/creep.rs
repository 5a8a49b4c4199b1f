//! Kalker's creep coefficients of a rolling contact.

use carom_laws::creep::CreepCoefficients;

use crate::error::{CaromError, CaromStatus, border};
use crate::pointers::write;

/// Creep coefficients of two equal bodies of shear modulus G, on an elliptical contact with semi-axes a along
/// the direction of rolling and b across it: forces on body 1 at creepages xi, eta (sliding velocity of body 2
/// against body 1 over the rolling speed) and phi (spin, rad per length rolled) that are small.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct CaromCreep {
    /// F_x = G a b c11 xi.
    pub c11: f64,
    /// F_y = G a b c22 eta.
    pub c22: f64,
    /// F_y = -G (ab)^1.5 c23 phi, and M_z = G (ab)^1.5 c23 eta. Kalker's C23, and his -C32.
    pub c23: f64,
    /// M_z = G (ab)^2 c33 phi.
    pub c33: f64,
}

/// Kalker's creep coefficients, from a table, in less than a microsecond.
///
/// `axis_ratio` is a/b, from 0.05 to 20, with a along the direction of rolling; `poisson` that of both bodies,
/// from 0 to 0.5. Neither they nor the coefficients have units. An exchange of a and b is another contact: no
/// coefficient follows from those of b/a.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_creep_coefficients(
    axis_ratio: f64,
    poisson: f64,
    coefficients: *mut CaromCreep,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let place = write(coefficients, "coefficients")?;
        let CreepCoefficients { c11, c22, c23, c33, .. } =
            CreepCoefficients::by_table(axis_ratio, poisson)?;
        *place = CaromCreep { c11, c22, c23, c33 };
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}
