//! Whether a contact or an impact lies within the theory.

use std::f64::consts::PI;
use std::ffi::c_char;

use carom_impact::normal::NormalImpact;
use carom_impact::{Rebound, Warning};
use carom_laws::grains::Grain;
use carom_laws::validity::{Limit, Validity};
use carom_special::RangeError;

use crate::encounters::CaromEncounter;
use crate::error::{CaromError, CaromStatus, Failure, border, copy};
use crate::grains::{CaromGrains, relative_radius};
use crate::pair::{CAROM_LAW_RINGS, CaromPair};
use crate::pointers::{Strided, read, write};

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

impl CaromPair {
    /// How far the contact at this approach is from the limits of the theory.
    fn validity(&self, zeta: f64, radius: f64) -> Validity {
        let squares = [self.a_squared, self.b_squared];
        let contact = Squares::new(squares, self.c_z, zeta, self.yield_stress, radius);
        contact.validity(self.left_out())
    }

    /// The bound of the effect of coupling, if the law leaves it out.
    #[inline]
    fn left_out(&self) -> f64 {
        if self.law == CAROM_LAW_RINGS { 0.0 } else { self.coupling_bound }
    }

    /// Rejects a pair without a contact ellipse.
    fn check_ellipse(&self) -> Result<(), Failure> {
        self.check_version()?;
        RangeError::positive("a_squared", self.a_squared)?;
        RangeError::positive("b_squared", self.b_squared)?;
        RangeError::check("yield_stress", self.yield_stress, self.yield_stress > 0.0, "> 0")?;
        Ok(())
    }
}

/// A contact by squares of its ratios, without roots.
#[derive(Debug, Clone, Copy, Default)]
struct Squares {
    /// Of a/R.
    contact: f64,
    /// zeta/R, no square.
    approach: f64,
    /// Of the pressure over that of yield.
    pressure: f64,
}

impl Squares {
    /// A contact with a^2 and b^2 over its approach.
    #[inline]
    fn new([a, b]: [f64; 2], c_z: f64, zeta: f64, yield_stress: f64, radius: f64) -> Self {
        // (5.11) with F_z = (2/3) c_z zeta^1.5, without a contact of area 0.
        let pressure = c_z / (PI * Validity::YIELDS_AT * yield_stress);
        let approach = zeta / radius;
        Self {
            contact: a.max(b) * approach / radius,
            approach,
            pressure: pressure * pressure * zeta / (a * b),
        }
    }

    #[inline]
    fn and(self, other: Self) -> Self {
        Self {
            contact: self.contact.max(other.contact),
            approach: self.approach.max(other.approach),
            pressure: self.pressure.max(other.pressure),
        }
    }

    fn validity(self, coupling: f64) -> Validity {
        Validity {
            semi_axis_over_radius: self.contact.sqrt(),
            approach_over_radius: self.approach,
            pressure_over_yield: self.pressure.sqrt(),
            coupling,
            ..Validity::default()
        }
    }
}

impl CaromGrains {
    /// How far a contact of these radii at this approach is from the limits of the theory.
    #[inline]
    fn validity(&self, [one, two]: [f64; 2], zeta: f64) -> Result<Validity, Failure> {
        let contact = self.squares(relative_radius(one, two)?, one.min(two), zeta);
        Ok(contact.validity(self.unit.left_out()))
    }

    /// A contact of this relative radius between bodies of which this is the smaller radius.
    #[inline]
    fn squares(&self, relative: f64, smaller: f64, zeta: f64) -> Squares {
        let unit = &self.unit;
        let squares = [unit.a_squared, unit.b_squared].map(|square| relative * square);
        // Per relative radius: c_z grows as its root.
        let of_unit = Squares::new(squares, unit.c_z, zeta, unit.yield_stress, smaller);
        Squares { pressure: relative * of_unit.pressure, ..of_unit }
    }

    /// The share of the energy of an impact that the waves in one of the grains carry away.
    fn wave_share(&self, radii: [f64; 2], masses: [f64; 2], pulse: &NormalImpact) -> f64 {
        let radiation = [self.radiation_1, self.radiation_2];
        let share = |i: usize| {
            let density = masses[i] / (4.0 / 3.0 * PI * radii[i].powi(3));
            let is_grain = radii[i].is_finite() && masses[i].is_finite();
            if is_grain { pulse.wave_share(radiation[i], density) } else { 0.0 }
        };
        share(0).max(share(1))
    }
}

/// Whether a contact at the approach `zeta` (m, at least 0) lies within Hertz's theory. `radius` is the
/// smallest radius of curvature of the two bodies at the contact, m: of two spheres the smaller one. For grains
/// see `carom_grains_validity`. The pair must know its contact ellipse: one of `carom_pair_of_stiffness` does
/// not.
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
        RangeError::non_negative("zeta", zeta)?;
        RangeError::positive("radius", radius)?;
        pair.check_ellipse()?;
        *place = pair.validity(zeta, radius).into();
        Ok::<(), Failure>(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Whether the contact of two grains at the approach `zeta` (m, at least 0) lies within Hertz's theory. The
/// second is a wall if its radius is infinite.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_grains_validity(
    grains: *const CaromGrains,
    radius_1: f64,
    radius_2: f64,
    zeta: f64,
    validity: *mut CaromValidity,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (grains, place) = (read(grains, "grains")?, write(validity, "validity")?);
        grains.unit.check_ellipse()?;
        RangeError::non_negative("zeta", zeta)?;
        *place = grains.validity([radius_1, radius_2], zeta)?.into();
        Ok::<(), Failure>(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// How far an impact of two grains, which approach with `velocity` (above 0), lies within the theory, and
/// whether a time step of this duration, s, resolves it; 0 for no steps. Radii and masses are as in
/// `carom_grains_impact_time`.
///
/// The largest contact and the share of elastic waves are those without damping: they are 0 if the grains
/// have a relaxation time, which stands for all losses. The density of the grains follows from mass and
/// radius; waves in a wall are left out.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_grains_impact_validity(
    grains: *const CaromGrains,
    radius_1: f64,
    radius_2: f64,
    mass_1: f64,
    mass_2: f64,
    velocity: f64,
    step: f64,
    validity: *mut CaromValidity,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (grains, place) = (read(grains, "grains")?, write(validity, "validity")?);
        grains.unit.check_ellipse()?;
        RangeError::non_negative("step", step)?;
        let (radii, masses) = ([radius_1, radius_2], [mass_1, mass_2]);
        let pulse = grains.impact(radii, masses, velocity)?;
        let (depth, wave_share) = match grains.is_elastic() {
            true => (pulse.maximal_approach(), grains.wave_share(radii, masses, &pulse)),
            false => (0.0, 0.0),
        };
        let step_over_duration = step / pulse.duration();
        let contact = grains.validity(radii, depth)?;
        *place = Validity { wave_share, step_over_duration, ..contact }.into();
        Ok::<(), Failure>(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The worst of many contacts of grains, in each ratio, by their present places. Their touches are not read.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `encounters` must have `count` entries.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_encounters_validity(
    encounters: *const CaromEncounter,
    count: usize,
    validity: *mut CaromValidity,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let place = write(validity, "validity")?;
        let size = size_of::<CaromEncounter>();
        let all = Strided::new(encounters.cast_mut(), size, count, "encounters")?;
        let (mut worst, mut coupling) = (Squares::default(), 0.0_f64);
        for i in 0..count {
            let CaromEncounter { grains, one, two, .. } = &*all.at(i);
            let grains = read(*grains, "grains").map_err(|failure| failure.at(i))?;
            let reach = one.radius + two.radius;
            let zeta = reach - distance(one, two);
            if zeta > 0.0 {
                let relative = one.radius * two.radius / reach;
                worst = worst.and(grains.squares(relative, one.radius.min(two.radius), zeta));
                coupling = coupling.max(grains.unit.left_out());
            }
        }
        *place = worst.validity(coupling).into();
        Ok::<(), Failure>(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

#[inline]
fn distance(one: &Grain, two: &Grain) -> f64 {
    let [x, y, z] = [0, 1, 2].map(|k| one.place[k] - two.place[k]);
    (x * x + y * y + z * z).sqrt()
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
    }
}
