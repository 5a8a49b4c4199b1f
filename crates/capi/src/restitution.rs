//! The tangential coefficient of restitution of spheres.

use carom_impact::oblique::{Groups, ObliqueError};
use carom_impact::restitution::{
    DissimilarGroups, DissimilarMethod, DissimilarTable, RestitutionError, RestitutionTable,
    with_normal_restitution,
};
use carom_laws::friction::Friction;
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::pointers::{Strided, write, write_or_null};

/// R_x from the table: within 1e-8 of the exact impact, in tens of nanoseconds.
pub const CAROM_BY_TABLE: u32 = 0;
/// R_x by the exact impact, in microseconds.
pub const CAROM_EXACT: u32 = 1;
/// R_x of dissimilar spheres by rings, in milliseconds.
pub const CAROM_BY_RINGS: u32 = 2;

/// R_x, the tangential velocity after an impact of solid spheres over that before, reversed in sign.
///
/// `kappa` = (2 - nu)/(2 (1 - nu)) is that of the materials, in (0.75, 1.5]; `lambda` >= 0 the
/// tangential velocity of the contact over f times the normal one; `normal_restitution`, in [0, 1], is e of a viscous
/// material, 1 of an elastic one. `method` is CAROM_BY_TABLE (with a loss within 3e-3) or CAROM_EXACT (within 1e-5).
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_restitution(
    kappa: f64,
    lambda: f64,
    normal_restitution: f64,
    method: u32,
    restitution: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let place = write(restitution, "restitution")?;
        *place = one([kappa, lambda, normal_restitution], method)?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// R_x of many pairs of `kappa` and `lambda`, with one `normal_restitution`. The strides are the bytes from one entry to the next; 0
/// takes the same entry again and again. The first pair without an answer ends the call:
/// `error->index` names it, and those before it have been written.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `kappa`, `lambda` and `restitution` must have `count` entries; those of `restitution` must overlap
/// nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_restitution_many(
    count: usize,
    kappa: *const f64,
    kappa_stride: usize,
    lambda: *const f64,
    lambda_stride: usize,
    normal_restitution: f64,
    method: u32,
    restitution: *mut f64,
    restitution_stride: usize,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let kappa = Strided::new(kappa.cast_mut(), kappa_stride, count, "kappa")?;
        let lambda = Strided::new(lambda.cast_mut(), lambda_stride, count, "lambda")?;
        let places = Strided::apart(restitution, restitution_stride, count, "restitution")?;
        for i in 0..count {
            let answer = one([*kappa.at(i), *lambda.at(i), normal_restitution], method);
            *places.at(i) = answer.map_err(|failure| failure.at(i))?;
        }
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// R_x of spheres or planes of dissimilar materials without spin about the normal.
///
/// `gamma`, of either sign, is the coupling (15.2) of the materials, at most 3/2 - `kappa`, which is in
/// [0.75, 1.5]. `friction` is f, from 0 to infinity; `lambda` >= 0 as for `carom_restitution`, 0 where f is
/// infinite. `mobility_ratio`, in (0, 75], is D_xx/D_zz: 3.5 of solid spheres, 2.5 of hollow ones.
///
/// `method` tells how it was found, and `error_estimate` how far it may be off; each may be null:
/// - CAROM_EXACT: gamma = 0, with the bits of `carom_restitution`, or no friction.
/// - CAROM_BY_TABLE: in half a microsecond, for kappa from 1, lambda to 8, f to 1, |gamma|/f to 12 and
///   mobility_ratio from 1 to 6.
/// - CAROM_BY_RINGS: elsewhere, by time steps, in milliseconds to seconds.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_restitution_dissimilar(
    kappa: f64,
    gamma: f64,
    friction: f64,
    lambda: f64,
    mobility_ratio: f64,
    restitution: *mut f64,
    error_estimate: *mut f64,
    method: *mut u32,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let place = write(restitution, "restitution")?;
        let estimate = write_or_null(error_estimate, "error_estimate")?;
        let by = write_or_null(method, "method")?;
        let friction = Friction::new(friction)?;
        let groups = DissimilarGroups::new(kappa, gamma, friction, lambda, mobility_ratio)?;
        let found = DissimilarTable::shared().restitution(&groups)?;
        *place = found.r_x;
        if let Some(estimate) = estimate {
            *estimate = found.error_estimate;
        }
        if let Some(by) = by {
            *by = method_of(found.method);
        }
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

fn method_of(method: DissimilarMethod) -> u32 {
    match method {
        DissimilarMethod::Frictionless | DissimilarMethod::Uncoupled => CAROM_EXACT,
        DissimilarMethod::Table => CAROM_BY_TABLE,
        DissimilarMethod::Rings => CAROM_BY_RINGS,
    }
}

fn one([kappa, lambda, e]: [f64; 3], method: u32) -> Result<f64, Failure> {
    let groups = Groups::of_spheres(kappa, lambda)?;
    RangeError::check("normal_restitution", e, (0.0..=1.0).contains(&e), "from 0 to 1")?;
    match method {
        CAROM_BY_TABLE => Ok(RestitutionTable::shared().restitution_with(groups, e)?),
        CAROM_EXACT => Ok(with_normal_restitution(groups, e)?),
        _ => {
            let text = format_args!("method = {method} is neither the table (0) nor exact (1)");
            Err(Failure::new(CaromStatus::OutOfRange, "method", text))
        }
    }
}

impl From<RestitutionError> for Failure {
    fn from(error: RestitutionError) -> Self {
        match error {
            RestitutionError::Range(error) => error.into(),
            RestitutionError::Oblique(error) => error.into(),
        }
    }
}

impl From<ObliqueError> for Failure {
    fn from(error: ObliqueError) -> Self {
        Self::new(CaromStatus::NotFollowed, "", error)
    }
}
