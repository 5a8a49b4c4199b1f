//! Friction of grains that is not one coefficient: by the slip speed at the first touch, and static friction.

use carom_laws::coupling::coupling_bound;
use carom_laws::friction::Friction;
use carom_laws::slip_speed::SlipSpeedFriction;
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::grains::CaromGrains;
use crate::pair::{CAROM_LAW_RINGS, CaromPair};
use crate::pointers::{read, write};
use crate::touch::{CAROM_TOUCH_NUMBERS, CaromTouch};

/// Gives contacts static friction above kinetic friction, `unit.friction`, as `carom_pair_static_friction`. Not for
/// CAROM_LAW_RINGS, and not beside friction by the slip speed; a twist has none.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_grains_static_friction(
    grains: *mut CaromGrains,
    static_friction: f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let grains = write(grains, "grains")?;
        let holds = !grains.has_slip_friction();
        let allowed = "left out beside friction by the slip speed";
        RangeError::check("static_friction", static_friction, holds, allowed)?;
        grains.unit.set_static_friction(static_friction)
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Gives each contact the coefficient of friction f = a + b exp(-c v), v the slip speed of its first touch, which it
/// keeps while it lasts; instead of the one of `carom_grains_of`. a, a + b and c must be finite and at least 0.
/// Bodies that part and touch again in the same `carom_touch` have another first touch. Not for CAROM_LAW_RINGS, and
/// not beside static friction; a twist has none. Contacts that have begun keep theirs. To store a contact,
/// `carom_touch_friction` tells its coefficient, which `carom_touch_unpack_with_friction` needs.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_grains_slip_friction(
    grains: *mut CaromGrains,
    a: f64,
    b: f64,
    c: f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe { write(grains, "grains")?.set_slip_friction(a, b, c) };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The coefficient of friction of a contact: that of its first touch, or of static friction if there is one; 0 for
/// separated grains.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_friction(
    touch: *const CaromTouch,
    friction: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let contact = read(touch, "touch")?.present()?;
        let told = contact.map_or(0.0, |contact| contact.law().friction().get());
        *write(friction, "friction")? = told;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// As `carom_touch_unpack`, for a contact whose coefficient `carom_touch_friction` told.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `numbers` must have CAROM_TOUCH_NUMBERS entries.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_unpack_with_friction(
    grains: *const CaromGrains,
    radius_1: f64,
    radius_2: f64,
    friction: f64,
    numbers: *const f64,
    touch: *mut CaromTouch,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let grains = read(grains, "grains")?;
        let numbers = read(numbers.cast::<[f64; CAROM_TOUCH_NUMBERS]>(), "numbers")?;
        let touch = write(touch, "touch")?;
        let holds = friction.is_finite();
        RangeError::check("friction", friction, holds, "finite for a state that is stored")?;
        touch.unpack(&grains.with_friction(friction), [radius_1, radius_2], numbers)
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

impl CaromGrains {
    fn set_slip_friction(&mut self, a: f64, b: f64, c: f64) -> Result<(), Failure> {
        self.unit.check_version()?;
        let friction = SlipSpeedFriction::new(a, b, c)?;
        let allowed = "0 for law rings, and beside static friction";
        let holds = self.unit.law != CAROM_LAW_RINGS && self.unit.static_friction == 0.0;
        RangeError::check("b", b, holds || b == 0.0, allowed)?;
        let [at_rest, fast] = [friction.at(0.0)?, Friction::new(a)?].map(Friction::get);
        // The bound grows as friction falls, also where that tends to zero; it is 0 without friction alone.
        let smallest = if b == 0.0 { 0.0 } else { 1e-30 };
        let least = Friction::new(at_rest.min(fast).max(smallest))?;
        let coupling_bound = coupling_bound(self.unit.gamma, least);
        self.unit = CaromPair { friction: a, coupling_bound, ..self.unit };
        (self.slip_friction_b, self.slip_friction_c) = (b, c);
        Ok(())
    }

    /// Refuses friction by the slip speed, which a twist does not have.
    pub(crate) fn check_constant_friction(&self) -> Result<(), RangeError> {
        let holds = !self.has_slip_friction();
        RangeError::check("slip_friction_b", self.slip_friction_b, holds, "0 for a twist")?;
        Ok(())
    }
}
