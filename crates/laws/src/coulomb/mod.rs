//! Coulomb's law in two directions with memory: each ring of the contact slips by itself.
//!
//! The state is that of [`crate::memory`], the anchor W(s) of the ring that touches at the approach
//! s, up to the tip (zeta, X). A ring carries at most its limit, `|X - W(s)| <= zeta - s`; its
//! anchor moves only when it must, and then towards X, on a tractrix. The force is
//! `Phi = (3/2) int (X - W(t^2)) dt`, t from 0 to sqrt(zeta). In one direction this is the exact
//! law of chapter 6; where the shift turns, chapter 7 gives a slip ring one direction of traction in
//! its whole width, and misses the law by 5 % of the friction limit in the mean.
//!
//! W is a chain of parabolas, each a chord and a bubble. A step drags the vertices and the middles
//! of those that slip by the exact map of a straight step; a piece whose bubble outgrows the
//! tolerance is split, two pieces that one parabola replaces are joined such that the force stays.
//! Slip may lie below stick, as the curve may be steeper than the cone, so that all are looked at.
//!
//! Each piece carries an estimate of the error of its anchors. Laying and joining pieces adds to it. A
//! step does not expand the distance of two anchors of a ring (its map is the play operator), so that
//! no error grows; slip that turns the traction reduces it. [`CoulombMemory::error_estimate`] sums up.
//!
//! Where c_x and c_y differ, a ring slips along its traction in normalised shifts, as chapter 7
//! scales them, not in lengths; [`crate::sliders`] knows the difference.

mod check;
mod drag;
mod energy;
mod heat;
mod join;
mod lay;
mod left;
mod pack;
mod piece;
mod report;
mod room;
mod step;
mod storage;
mod zones;

pub(crate) use drag::Step;
pub use pack::packed_numbers;
pub use report::Arc;

use carom_special::RangeError;

use crate::bounds::in_memory;
use crate::memory::{Growing, Lateral, MemoryRegime as Regime, VertexStack};

/// The memory of a contact whose rings slip each by itself.
///
/// ```
/// use carom_laws::coulomb::{CoulombMemory, Tolerance};
/// let mut memory = CoulombMemory::<[f64; 2]>::new(Tolerance::new(1e-3)?);
/// memory.advance(1.0, [0.0, 0.0])?; // press
/// memory.advance(1.0, [0.6, 0.0])?; // shift
/// let turned = memory.advance(1.0, [0.6, 0.6])?; // and across
/// assert!(turned[1] > turned[0] && turned[0] > 0.2);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoulombMemory<V, S = Growing<V>> {
    zeta: f64,
    /// The square root of zeta.
    root: f64,
    shift: V,
    force: V,
    regime: Regime,
    /// The deepest ring that slipped in the last step; after adhesion where that began.
    front: f64,
    /// The largest stretch of the deepest ring since touch.
    extent: f64,
    tolerance: f64,
    /// The largest bubble over the approach.
    bulge: f64,
    stack: S,
}

/// How finely the curve of the anchors is drawn, over the approach or, where it is smaller, over the
/// largest shift since touch: pieces are split and joined such that the force stays within this share
/// of its limit.
///
/// It steers the law and is no bound of the error; [`CoulombMemory::error_estimate`] estimates that.
///
/// Against rings of sliders on ordinary turning paths the force at 1e-2 was off, over its limit, by
/// 5e-5 in the mean and 1e-3 at most, with each step in 16 by 3e-4 and 4e-3; at 1e-3 by 4e-6 and 4e-5,
/// in parts by 2e-5 and 2e-4. On paths found by climbing it was off by 8 times the tolerance at 1e-2. What
/// is joined deep in the contact is measured by its own approach, since the contact may recede to it,
/// and what carries little of the force may be off by more.
///
/// Storage that is full holds no tolerance: pieces are merged until the rest fits, and drawn no finer than so
/// few last, at a tolerance of 7e-3 for 8 vertices and 2e-3 for 12.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Tolerance(f64);

/// The largest bubble over the power 2/3 of the tolerance.
const BULGE: f64 = 0.24;

impl Tolerance {
    /// That of many particles: 1e-2.
    pub const PARTICLES: Self = Self(1e-2);
    /// That of single contacts: 1e-3.
    pub const FINE: Self = Self(1e-3);

    /// A tolerance.
    ///
    /// # Errors
    /// [`RangeError`] unless it is above 0 and not above 0.1.
    pub fn new(tolerance: f64) -> Result<Self, RangeError> {
        let holds = tolerance > 0.0 && tolerance <= 0.1;
        RangeError::check("tolerance", tolerance, holds, "> 0 and <= 0.1").map(Self)
    }

    /// The largest bubble: what a parabola then leaves out, of third order, goes as its power 3/2.
    fn bulge(self) -> f64 {
        let root = libm::cbrt(self.0);
        BULGE * root * root
    }

    /// The number.
    #[must_use]
    pub const fn get(self) -> f64 {
        self.0
    }
}

impl Default for Tolerance {
    fn default() -> Self {
        Self::FINE
    }
}

impl<V: Lateral, S: VertexStack<V>> CoulombMemory<V, S> {
    /// The place of the regime among the bytes.
    pub(crate) const REGIME_AT: usize = std::mem::offset_of!(Self, regime);

    /// Two bodies that just touch, unshifted.
    #[must_use]
    pub fn new(tolerance: Tolerance) -> Self {
        Self {
            zeta: 0.0,
            root: 0.0,
            shift: V::default(),
            force: V::default(),
            regime: Regime::Separated,
            front: 0.0,
            extent: 0.0,
            tolerance: tolerance.get(),
            bulge: tolerance.bulge(),
            stack: S::default(),
        }
    }

    /// Goes straight to a new approach and shift and returns the force Phi.
    ///
    /// An approach that is not positive separates the bodies: the memory is lost. In the step
    /// that closes the gap the shift at touch is interpolated.
    ///
    /// # Errors
    /// [`RangeError`] for a value above 1e100 in size or not a number; the state is then unchanged.
    #[inline]
    pub fn advance(&mut self, zeta: f64, shift: V) -> Result<V, RangeError> {
        in_memory("zeta", zeta)?;
        let [x, y] = shift.components();
        in_memory("shift", x)?;
        in_memory("shift", y)?;
        self.step(zeta, shift);
        Ok(self.force)
    }
}
