//! The way of a step of rolling.

use carom_halfspace::{Grid, Offset};
use carom_laws::law::Shift;
use carom_special::RangeError;

use crate::Creepage;

/// The way that the contact moves over both bodies in a step: its length d, its direction chi from
/// the x axis, and the point about which spin turns the bodies.
///
/// In a step particles move from x + d to x. The rigid shift of a spin differs between both points;
/// it is taken at x + q d. With q = 0, the default, that is where the particle is at the end of the
/// step, with q = 1/2 the middle of its way.
///
/// ```
/// use carom_rolling::Way;
/// let way = Way::new(0.1)?.towards(std::f64::consts::PI)?.with_spin_at(0.5)?;
/// assert!((way.ahead().x + 0.1).abs() < 1e-16);
/// assert_eq!(Way::new(0.0).unwrap_err().field, "rolling distance");
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Way {
    length: f64,
    direction: f64,
    spin_at: f64,
}

impl Way {
    /// A way along +x.
    ///
    /// # Errors
    /// [`RangeError`] unless the distance is positive and finite.
    pub fn new(distance: f64) -> Result<Self, RangeError> {
        RangeError::positive("rolling distance", distance)?;
        Ok(Self { length: distance, direction: 0.0, spin_at: 0.0 })
    }

    /// The same way in the direction chi, an angle from +x towards +y.
    ///
    /// # Errors
    /// [`RangeError`] unless the angle is finite.
    pub fn towards(self, direction: f64) -> Result<Self, RangeError> {
        RangeError::finite("rolling direction", direction)?;
        Ok(Self { direction, ..self })
    }

    /// The same way with the rigid shift of a spin taken at x + q d.
    ///
    /// # Errors
    /// [`RangeError`] unless the part q is from -1 to 1.
    pub fn with_spin_at(self, part: f64) -> Result<Self, RangeError> {
        let holds = (-1.0..=1.0).contains(&part);
        RangeError::check("spin offset", part, holds, "from -1 to 1")?;
        Ok(Self { spin_at: part, ..self })
    }

    /// Its length d.
    #[must_use]
    pub const fn length(&self) -> f64 {
        self.length
    }

    /// Its direction chi.
    #[must_use]
    pub const fn direction(&self) -> f64 {
        self.direction
    }

    /// The part q of the way at which the rigid shift of a spin is taken.
    #[must_use]
    pub const fn spin_at(&self) -> f64 {
        self.spin_at
    }

    /// The creepages of the shifts of a step.
    #[must_use]
    pub fn creepage(&self, shift: Shift) -> Creepage {
        let (Shift { xi, eta, omega, .. }, at) = (shift, self.spin_offset());
        Creepage {
            along: (xi - at.y * omega) / self.length,
            across: (eta + at.x * omega) / self.length,
            spin: omega / self.length,
        }
    }

    /// The vector d, from a particle at the end of a step to where it comes from.
    #[must_use]
    pub fn ahead(&self) -> Offset {
        let (sin, cos) = libm::sincos(self.direction);
        // A multiple of a right angle is meant as such.
        let exact = |part: f64| if part.abs() < 1e-15 { 0.0 } else { part };
        Offset { x: self.length * exact(cos), y: self.length * exact(sin) }
    }

    /// Where the rigid shift of a spin is taken, from the particle at the end of the step.
    #[must_use]
    pub fn spin_offset(&self) -> Offset {
        let ahead = self.ahead();
        Offset { x: self.spin_at * ahead.x, y: self.spin_at * ahead.y }
    }

    /// Checks that a step does not leave a grid.
    pub(crate) fn check_on(&self, grid: Grid) -> Result<(), RangeError> {
        let ahead = self.ahead();
        let along = ahead.x.abs() < grid.nx() as f64 * grid.dx();
        let across = ahead.y.abs() < grid.ny() as f64 * grid.dy();
        let allowed = "below the length of the grid";
        RangeError::check("rolling distance", self.length, along && across, allowed).map(drop)
    }
}
