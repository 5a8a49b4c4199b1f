//! Kalker's creep coefficients of a rolling contact.

use carom_laws::creep::CreepCoefficients;
use carom_laws::creep::force::CreepContact;

use crate::error::{CaromError, CaromStatus, border};
use crate::pointers::{read, write};

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

/// Forces of steady rolling on body 1.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct CaromCreepForce {
    /// Along the direction of rolling, N.
    pub f_x: f64,
    /// Across it, N.
    pub f_y: f64,
    /// Torque about the normal, N m.
    pub m_z: f64,
    /// How far each force may be off, N; the torque by sqrt(ab) times as much.
    pub error: f64,
}

/// Creep forces of an elliptical contact of two bodies of like materials at any creepage and spin, from a table, in
/// microseconds and without allocation.
///
/// `semi_axes` are a along the direction of rolling and b across it in m, a/b from 0.1 to 10; `shear_modulus` in Pa and
/// `poisson`, from 0 to 0.5, are those of each body; `friction` and `normal_force` in N are > 0. `creepages` are those of body 2
/// against body 1: along, across, and spin in rad/m.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `semi_axes` must have 2 and `creepages` 3 entries.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_creep_force(
    semi_axes: *const f64,
    shear_modulus: f64,
    poisson: f64,
    friction: f64,
    normal_force: f64,
    creepages: *const f64,
    force: *mut CaromCreepForce,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let place = write(force, "force")?;
        let semi_axes = *read(semi_axes.cast::<[f64; 2]>(), "semi_axes")?;
        let creepages = *read(creepages.cast::<[f64; 3]>(), "creepages")?;
        let contact = CreepContact::new(semi_axes, shear_modulus, poisson)?;
        let found = contact.force(friction, normal_force, creepages)?;
        *place =
            CaromCreepForce { f_x: found.f_x, f_y: found.f_y, m_z: found.m_z, error: found.error };
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}
