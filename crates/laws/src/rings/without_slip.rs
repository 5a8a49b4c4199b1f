//! The normal force of dissimilar bodies that never slip.
//!
//! A place at the radius r then keeps the radial slip with which it entered: that of the rim of a contact of radius r,
//! in proportion to r^2. Shift and twist add no mean radial displacement, by symmetry. So the axisymmetric part of the
//! problem is the same at each contact radius, whatever the path, and F_z is Hertz's force times a constant. Summed over
//! the angles instead, the pressures by a shift would cancel to their rounding, which a shift far beyond the approach
//! lets exceed F_z.

use super::contact::{Contact, Step};
use super::pair::Pair;
use super::symmetry::Symmetry;

impl<const N: usize, const H: usize, S: Symmetry<H>> Pair<N, H, S> {
    /// The normal force at the radius 1 after pressing in one step from first contact.
    pub(super) fn pressed_without_slip(&self) -> f64 {
        let press = Step { approach: 1.0, approached: 1.0, shifted: [0.0; 2], twisted: 0.0 };
        let mut contact = Contact::<N, H>::default();
        contact.advance(self, 0.0, &press);
        contact.normal_by_pressures(self)
    }
}
