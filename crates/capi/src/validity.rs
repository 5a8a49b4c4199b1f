//! Whether a contact or an impact lies within the theory.

use std::ffi::{CStr, c_char};

use carom_impact::{Rebound, Warning};
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

/// Largest approach over the smallest radius of curvature for which the bodies count as half-spaces.
const LARGE_APPROACH: f64 = 0.1;

/// How far a contact lies within Hertz's theory, which holds for contacts that are small compared with the
/// bodies. R is the smallest radius of curvature of the two bodies at the contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct CaromValidity {
    /// a/R: the larger semi-axis of the contact over R. Hertz's theory requires at most 0.1.
    pub semi_axis_over_radius: f64,
    /// zeta/R: the approach over R. Above 0.1 the result is approximate at best, above 1 meaningless.
    pub approach_over_radius: f64,
    /// CAROM_WARNING_LARGE_CONTACT, CAROM_WARNING_LARGE_APPROACH, both, or 0 within the theory.
    pub warnings: u32,
}

impl CaromValidity {
    fn new(semi_axis: f64, approach: f64, radius: f64) -> Self {
        let [contact, approach] = [semi_axis / radius, approach / radius];
        Self {
            semi_axis_over_radius: contact,
            approach_over_radius: approach,
            warnings: contact_bit(contact) | approach_bit(approach),
        }
    }
}

fn contact_bit(semi_axis_over_radius: f64) -> u32 {
    if semi_axis_over_radius > Warning::LARGE_CONTACT { CAROM_WARNING_LARGE_CONTACT } else { 0 }
}

fn approach_bit(approach_over_radius: f64) -> u32 {
    if approach_over_radius > LARGE_APPROACH { CAROM_WARNING_LARGE_APPROACH } else { 0 }
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
        let semi_axis = pair.a_squared.max(pair.b_squared).sqrt() * zeta.sqrt();
        *place = CaromValidity::new(semi_axis, zeta, radius);
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
        _ => c"not one CAROM_WARNING bit",
    };
    text.as_ptr()
}

/// The bits of all warnings of an impact.
pub(crate) fn bits(rebound: &Rebound) -> u32 {
    rebound.warnings.iter().map(|warning| bit(warning, rebound)).fold(0, |all, one| all | one)
}

fn bit(warning: &Warning, rebound: &Rebound) -> u32 {
    match warning {
        Warning::Coupling { .. } => CAROM_WARNING_COUPLING,
        Warning::LargeContact { ratio } => {
            let ellipse = rebound.maximal_contact;
            let radius = ellipse.semi_axis_a().max(ellipse.semi_axis_b()) / ratio;
            CAROM_WARNING_LARGE_CONTACT | approach_bit(rebound.maximal_approach / radius)
        }
        Warning::WaveLoss { .. } => CAROM_WARNING_WAVE_LOSS,
        Warning::SpinLeftAlone { .. } => CAROM_WARNING_SPIN_LEFT_ALONE,
        Warning::NotSettled { .. } => CAROM_WARNING_NOT_SETTLED,
        Warning::PointSampled => CAROM_WARNING_POINT_SAMPLED,
    }
}
