//! How far the contacts of a law lie within the theory, and how long their impacts last.

use std::f64::consts::PI;

use carom_impact::normal::NormalImpact;
use carom_laws::grains::{Grain, Surface};
use carom_laws::validity::Validity;
use carom_special::RangeError;

use super::CaromLaw;
use super::unit::relative_radius;
use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::pointers::{Strided, read, write};
use crate::touch::bodies::Second;
use crate::touch::many::CaromEncounter;
use crate::validity::CaromValidity;

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

impl CaromLaw {
    /// How far a contact of these radii at this approach is from the limits of the theory.
    fn validity(&self, [one, two]: [f64; 2], zeta: f64) -> Result<Validity, Failure> {
        let contact = self.squares(relative_radius([one, two])?, one.min(two), zeta);
        Ok(contact.validity(self.coupling_bound))
    }

    /// A contact of this relative radius between bodies of which this is the smaller radius.
    #[inline]
    fn squares(&self, relative: f64, smaller: f64, zeta: f64) -> Squares {
        let unit = &self.unit;
        let squares = unit.squares.map(|square| relative * square);
        // Per relative radius: c_z grows as its root.
        let of_unit = Squares::new(squares, unit.c_z(), zeta, unit.yield_stress, smaller);
        Squares { pressure: relative * of_unit.pressure, ..of_unit }
    }

    /// The share of the energy of an impact that the waves in one of the grains carry away.
    fn wave_share(&self, radii: [f64; 2], masses: [f64; 2], pulse: &NormalImpact) -> f64 {
        let share = |i: usize| {
            let density = masses[i] / (4.0 / 3.0 * PI * radii[i].powi(3));
            let is_grain = radii[i].is_finite() && masses[i].is_finite();
            if is_grain { pulse.wave_share(self.radiation[i], density) } else { 0.0 }
        };
        share(0).max(share(1))
    }

    /// The elastic impact of two grains without damping, by radii, masses and the velocity of approach.
    fn impact(
        &self,
        radii: [f64; 2],
        [mass_1, mass_2]: [f64; 2],
        velocity: f64,
    ) -> Result<NormalImpact, Failure> {
        let c_z = relative_radius(radii)?.sqrt() * self.unit.c_z();
        RangeError::check("mass_1", mass_1, mass_1 > 0.0, "> 0")?;
        RangeError::check("mass_2", mass_2, mass_2 > 0.0, "> 0")?;
        let mobility = 1.0 / mass_1 + 1.0 / mass_2;
        RangeError::check("mass_2", mass_2, mobility > 0.0, "finite if `mass_1` is not")?;
        RangeError::positive("velocity", velocity)?;
        Ok(NormalImpact::new(mobility, c_z, velocity)?)
    }
}

/// Relative and smaller radius and approach of two bodies.
#[inline]
fn closeness(one: &Grain, second: Second<'_>) -> [f64; 3] {
    match second {
        Second::Grain(two) => {
            let reach = one.radius + two.radius;
            let relative = one.radius * two.radius / reach;
            [relative, one.radius.min(two.radius), reach - distance(one, two)]
        }
        Second::Wall(&Surface { place, normal, .. }) => {
            let height: f64 = (0..3).map(|k| (one.place[k] - place[k]) * normal[k]).sum();
            [one.radius, one.radius, one.radius - height]
        }
    }
}

#[inline]
fn distance(one: &Grain, two: &Grain) -> f64 {
    let [x, y, z] = [0, 1, 2].map(|k| one.place[k] - two.place[k]);
    (x * x + y * y + z * z).sqrt()
}

/// The duration of an elastic impact of two grains without damping, s: whoever steps it chooses the time step
/// from this. The second is a wall if its radius is infinite; a mass may be infinite, not both. `velocity` is
/// that of approach, above 0.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_law_impact_time(
    law: *const CaromLaw,
    radius_1: f64,
    radius_2: f64,
    mass_1: f64,
    mass_2: f64,
    velocity: f64,
    time: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (law, place) = (read(law, "law")?, write(time, "time")?);
        *place = law.impact([radius_1, radius_2], [mass_1, mass_2], velocity)?.duration();
        Ok(())
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
pub unsafe extern "C" fn carom_law_validity(
    law: *const CaromLaw,
    radius_1: f64,
    radius_2: f64,
    zeta: f64,
    validity: *mut CaromValidity,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (law, place) = (read(law, "law")?, write(validity, "validity")?);
        RangeError::non_negative("zeta", zeta)?;
        *place = law.validity([radius_1, radius_2], zeta)?.into();
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// How far an impact of two grains, which approach with `velocity` (above 0), lies within the theory, and
/// whether a time step of this duration, s, resolves it; 0 for no steps. Radii and masses are as in
/// `carom_law_impact_time`.
///
/// The largest contact and the share of elastic waves are those without damping: they are 0 if the law is damped, which
/// stands for all losses. The density of the grains follows from mass and radius; waves in a wall are left out.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_law_impact_validity(
    law: *const CaromLaw,
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
        let (law, place) = (read(law, "law")?, write(validity, "validity")?);
        RangeError::non_negative("step", step)?;
        let (radii, masses) = ([radius_1, radius_2], [mass_1, mass_2]);
        let pulse = law.impact(radii, masses, velocity)?;
        let (depth, wave_share) = match law.is_elastic() {
            true => (pulse.maximal_approach(), law.wave_share(radii, masses, &pulse)),
            false => (0.0, 0.0),
        };
        let step_over_duration = step / pulse.duration();
        let contact = law.validity(radii, depth)?;
        *place = Validity { wave_share, step_over_duration, ..contact }.into();
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The worst of many contacts, in each ratio, by their present places. Their touches are not read.
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
            let met = &*all.at(i);
            let law = read(met.law, "law").map_err(|failure| failure.at(i))?;
            let second = met.second().map_err(|failure| failure.at(i))?;
            let [relative, smaller, zeta] = closeness(&met.one, second);
            if zeta > 0.0 {
                worst = worst.and(law.squares(relative, smaller, zeta));
                coupling = coupling.max(law.coupling_bound);
            }
        }
        *place = worst.validity(coupling).into();
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}
