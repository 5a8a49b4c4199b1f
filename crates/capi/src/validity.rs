//! Whether a contact or an impact lies within the theory.

use std::ffi::c_char;

use carom_impact::{Rebound, Warning};
use carom_laws::validity::{Limit, Validity};
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border, copy};
use crate::pointers::{read, write};

/// Normal and tangential displacements are coupled by the materials; the result neglects this.
pub const CAROM_WARNING_COUPLING: u32 = 1;
/// The contact is not small compared with the bodies: a/R exceeds 0.1, beyond Hertz's theory.
pub const CAROM_WARNING_LARGE_CONTACT: u32 = 2;
/// Elastic waves would carry away more than 1 % of the normal energy.
pub const CAROM_WARNING_WAVE_LOSS: u32 = 4;
/// Friction was not applied to the spin about the normal, although torsion would take more than 1 % of it.
pub const CAROM_WARNING_SPIN_LEFT_ALONE: u32 = 8;
/// The outcome did not converge to its tolerance.
pub const CAROM_WARNING_NOT_SETTLED: u32 = 16;
/// The contact point was found by sampling the surfaces; the bodies may touch elsewhere too.
pub const CAROM_WARNING_POINT_SAMPLED: u32 = 32;
/// The approach exceeds a tenth of the radius: the bodies are no half-spaces, and the result is approximate at
/// best. Check the units.
pub const CAROM_WARNING_LARGE_APPROACH: u32 = 64;
/// The greatest pressure exceeds 1.6 times the yield stress of the weaker body, from which metals flow below
/// the surface.
pub const CAROM_WARNING_YIELDS: u32 = 128;
/// The time step is too long: an impact lasts fewer than 20 steps.
pub const CAROM_WARNING_TIME_STEP: u32 = 256;
/// The spin about the normal uses up friction, which the law leaves out: R_x may change by more than 0.005.
pub const CAROM_WARNING_SPIN_ON_SHIFT: u32 = 512;
/// The cause of the loss along the normal is not given, and another one would change the velocity after the impact by more
/// than 5 % of that before.
pub const CAROM_WARNING_UNKNOWN_LOSS: u32 = 1024;

/// How far a contact or an impact lies within the theory, which holds for elastic contacts that are small
/// compared with the bodies, and how much the result leaves out. R is the smallest radius of curvature of the
/// two bodies at the contact. A ratio is 0 where it does not apply. Of many contacts take the largest of each.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct CaromValidity {
    /// a/R: the larger semi-axis of the contact over R. Hertz's theory requires at most 0.1.
    pub semi_axis_over_radius: f64,
    /// zeta/R: the approach over R. Above 0.1 the result is approximate at best, above 1 meaningless.
    pub approach_over_radius: f64,
    /// The greatest pressure over 1.6 times the smaller yield stress of the bodies, where metals begin to
    /// flow; 0 if no yield stress is known.
    pub pressure_over_yield: f64,
    /// The share of the normal energy of an impact that elastic waves would carry away; worth a warning
    /// above 0.01.
    pub wave_share: f64,
    /// Upper bound of the change of R_x by the coupling of dissimilar materials, if the law neglects it; worth
    /// a warning above 0.005.
    pub coupling: f64,
    /// The time step over the duration of the impact, at most 1/20.
    pub step_over_duration: f64,
    /// The CAROM_WARNING bits of the ratios that exceed their limits; 0 if none does.
    pub warnings: u32,
}

/// The bit of a limit.
const fn bit_of(limit: Limit) -> u32 {
    match limit {
        Limit::Coupling => CAROM_WARNING_COUPLING,
        Limit::LargeContact | Limit::LargePressure => CAROM_WARNING_LARGE_CONTACT,
        Limit::LargeApproach => CAROM_WARNING_LARGE_APPROACH,
        Limit::Yields => CAROM_WARNING_YIELDS,
        Limit::Waves => CAROM_WARNING_WAVE_LOSS,
        Limit::Spin => CAROM_WARNING_SPIN_LEFT_ALONE,
        Limit::SpinOnShift => CAROM_WARNING_SPIN_ON_SHIFT,
        Limit::TimeStep => CAROM_WARNING_TIME_STEP,
    }
}

impl From<Validity> for CaromValidity {
    fn from(validity: Validity) -> Self {
        Self {
            semi_axis_over_radius: validity.semi_axis_over_radius,
            approach_over_radius: validity.approach_over_radius,
            pressure_over_yield: validity.pressure_over_yield,
            wave_share: validity.wave_share,
            coupling: validity.coupling,
            step_over_duration: validity.step_over_duration,
            warnings: validity.exceeded().fold(0, |all, excess| all | bit_of(excess.limit)),
        }
    }
}

impl From<&CaromValidity> for Validity {
    fn from(told: &CaromValidity) -> Self {
        Self {
            semi_axis_over_radius: told.semi_axis_over_radius,
            approach_over_radius: told.approach_over_radius,
            pressure_over_yield: told.pressure_over_yield,
            wave_share: told.wave_share,
            coupling: told.coupling,
            step_over_duration: told.step_over_duration,
            ..Self::default()
        }
    }
}

/// A sentence for one CAROM_WARNING bit. Never null, and not to be freed.
#[unsafe(no_mangle)]
pub extern "C" fn carom_warning_text(warning: u32) -> *const c_char {
    let text = match limit_of(warning) {
        Some(limit) => limit.words(),
        None => match warning {
            CAROM_WARNING_NOT_SETTLED => c"the outcome did not converge to its tolerance",
            CAROM_WARNING_POINT_SAMPLED => {
                c"the contact point was found by sampling: the bodies may touch elsewhere too"
            }
            CAROM_WARNING_UNKNOWN_LOSS => {
                c"the rebound depends on the cause of the loss, which is not given"
            }
            _ => c"not one CAROM_WARNING bit",
        },
    };
    text.as_ptr()
}

/// The sentence for one CAROM_WARNING bit with the number of a `carom_validity`, cut to `size` bytes with a
/// zero at the end; empty if that ratio does not exceed its limit. 200 bytes are enough.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `text` must have `size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_validity_text(
    validity: *const CaromValidity,
    warning: u32,
    text: *mut c_char,
    size: usize,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let told = read(validity, "validity")?;
        write(text, "text")?;
        RangeError::check("size", size as f64, size > 0, ">= 1")?;
        let limit = limit_of(warning).ok_or_else(|| unknown(warning))?;
        let words = Validity::from(told).excess(limit).map(|excess| excess.to_string());
        let place = std::slice::from_raw_parts_mut(text, size);
        copy(&words.unwrap_or_default(), place);
        Ok::<(), Failure>(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

fn unknown(warning: u32) -> Failure {
    let text = format_args!("warning = {warning} is not the CAROM_WARNING bit of a carom_validity");
    let value = f64::from(warning);
    Failure::new(CaromStatus::OutOfRange, "warning", text).with_value(value)
}

fn limit_of(warning: u32) -> Option<Limit> {
    Limit::ALL.into_iter().find(|limit| bit_of(*limit) == warning)
}

/// The bits of all warnings of an impact.
pub(crate) fn bits(rebound: &Rebound) -> u32 {
    rebound.warnings.iter().copied().map(bit).fold(0, |all, one| all | one)
}

const fn bit(warning: Warning) -> u32 {
    match warning {
        Warning::Exceeds(excess) => bit_of(excess.limit),
        Warning::NotSettled { .. } => CAROM_WARNING_NOT_SETTLED,
        Warning::PointSampled => CAROM_WARNING_POINT_SAMPLED,
        Warning::UnknownLoss { .. } => CAROM_WARNING_UNKNOWN_LOSS,
    }
}
