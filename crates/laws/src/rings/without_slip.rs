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
use crate::slip_lag::SlipLag;

/// The number of steps in which the contact grows, and the ratio of approaches in each.
const GROWTHS: i32 = 16;
const GROWTH: f64 = 1.25;

impl<const N: usize, const H: usize, S: Symmetry<H>> Pair<N, H, S> {
    /// The normal force at the radius 1 of a contact that grew. One step from first contact misses 1.2e-5 of it with
    /// eight rings, since what enters in a step is not yet similar to itself; sixteen miss 2e-8.
    pub(super) fn pressed_without_slip(&self) -> f64 {
        let mut contact = Contact::<N, H>::default();
        let mut before = 0.0;
        for k in (0..GROWTHS).rev() {
            let approach = GROWTH.powi(-k);
            let approached = approach - before;
            contact.advance(
                self,
                0.0,
                &Step {
                    approach,
                    approached,
                    shifted: [0.0; 2],
                    twisted: 0.0,
                    bent: [0.0; 3],
                    lag: SlipLag::NONE,
                },
            );
            before = approach;
        }
        contact.normal_by_pressures(self)
    }
}
