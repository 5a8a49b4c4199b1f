//! Whether a contact or an impact lies within the theory.

use std::f64::consts::PI;
use std::ffi::{CStr, c_char};

use carom_impact::{Rebound, Warning};
use carom_laws::validity::Validity;
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::pair::CaromPair;
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

/// How far a contact lies within Hertz's theory, which holds for elastic contacts that are small compared with
/// the bodies. R is the smallest radius of curvature of the two bodies at the contact.
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
    /// The bits CAROM_WARNING_LARGE_CONTACT, CAROM_WARNING_LARGE_APPROACH and CAROM_WARNING_YIELDS that
    /// hold; 0 within the theory.
    pub warnings: u32,
}

impl From<Validity> for CaromValidity {
    fn from(validity: Validity) -> Self {
        let bits =
            Warning::of(validity).map(bit).fold(approach_bit(validity), |all, one| all | one);
        Self {
            semi_axis_over_radius: validity.semi_axis_over_radius,
            approach_over_radius: validity.approach_over_radius,
            pressure_over_yield: validity.pressure_over_yield,
            warnings: bits,
        }
    }
}

impl CaromPair {
    /// How far the contact at this approach is from the limits of the theory.
    fn validity(&self, zeta: f64, radius: f64) -> Validity {
        let [a, b] = [self.a_squared, self.b_squared].map(|square| square.sqrt() * zeta.sqrt());
        // (5.11) with F_z = (2/3) c_z zeta^1.5, without a contact of area 0.
        let area = PI * (self.a_squared * self.b_squared).sqrt();
        let pressure = self.c_z * zeta.sqrt() / area;
        Validity::of_contact([a.max(b), zeta, pressure], self.yield_stress, radius)
    }
}

fn approach_bit(validity: Validity) -> u32 {
    if validity.is_large_approach() { CAROM_WARNING_LARGE_APPROACH } else { 0 }
}

/// Whether a contact at the approach `zeta` (m, at least 0) lies within Hertz's theory. `radius` is the
/// smallest radius of curvature of the two bodies at the contact, m: of two spheres the smaller one. For grains
/// make the pair by `carom_pair_of_spheres`. The pair must know its contact ellipse: one of
/// `carom_pair_of_stiffness` does not.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_pair_validity(
    pair: *const CaromPair,
    zeta: f64,
    radius: f64,
    validity: *mut CaromValidity,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (pair, place) = (read(pair, "pair")?, write(validity, "validity")?);
        pair.check_version()?;
        RangeError::non_negative("zeta", zeta)?;
        RangeError::positive("radius", radius)?;
        RangeError::positive("a_squared", pair.a_squared)?;
        RangeError::positive("b_squared", pair.b_squared)?;
        RangeError::check("yield_stress", pair.yield_stress, pair.yield_stress > 0.0, "> 0")?;
        *place = pair.validity(zeta, radius).into();
        Ok::<(), Failure>(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// A sentence for one CAROM_WARNING bit. Never null, and not to be freed.
#[unsafe(no_mangle)]
pub extern "C" fn carom_warning_text(warning: u32) -> *const c_char {
    let text: &CStr = match warning {
        CAROM_WARNING_COUPLING => {
            c"dissimilar materials: the coupling of normal and tangential displacements is neglected"
        }
        CAROM_WARNING_LARGE_CONTACT => c"large contact: a/R exceeds 0.1, beyond Hertz's theory",
        CAROM_WARNING_WAVE_LOSS => {
            c"elastic waves would carry away more than 1 % of the normal energy"
        }
        CAROM_WARNING_SPIN_LEFT_ALONE => {
            c"torsion is not computed: it would take more than 1 % of the relative spin about the normal"
        }
        CAROM_WARNING_NOT_SETTLED => c"the outcome did not converge to its tolerance",
        CAROM_WARNING_POINT_SAMPLED => {
            c"the contact point was found by sampling: the bodies may touch elsewhere too"
        }
        CAROM_WARNING_LARGE_APPROACH => {
            c"the approach exceeds a tenth of the radius: check the units"
        }
        CAROM_WARNING_YIELDS => Validity::YIELDS,
        _ => c"not one CAROM_WARNING bit",
    };
    text.as_ptr()
}

/// The bits of all warnings of an impact.
pub(crate) fn bits(rebound: &Rebound) -> u32 {
    let told = rebound.warnings.iter().copied().map(bit);
    told.fold(approach_bit(rebound.validity), |all, one| all | one)
}

fn bit(warning: Warning) -> u32 {
    match warning {
        Warning::Coupling { .. } => CAROM_WARNING_COUPLING,
        Warning::LargeContact { .. } => CAROM_WARNING_LARGE_CONTACT,
        Warning::WaveLoss { .. } => CAROM_WARNING_WAVE_LOSS,
        Warning::Yields { .. } => CAROM_WARNING_YIELDS,
        Warning::SpinLeftAlone { .. } => CAROM_WARNING_SPIN_LEFT_ALONE,
        Warning::NotSettled { .. } => CAROM_WARNING_NOT_SETTLED,
        Warning::PointSampled => CAROM_WARNING_POINT_SAMPLED,
    }
}
