//! Coulomb's law with memory for shifts in two directions: each annulus of the contact slips by
//! itself.
//!
//! The state is that of [`crate::memory`]: the zero-traction shift W(s) of each annulus (`anchor`
//! in code), from the centre, s = 0, to the tip of the curve, (zeta, X). The annulus of depth s was
//! the edge of the contact at the approach s. Its traction is proportional to the stretch X - W(s),
//! and Coulomb's limit is `|X - W(s)| <= zeta - s`. W(s) changes only in slip, and then moves
//! towards X along a tractrix. The force is `Phi = (3/2) int (X - W(t^2)) dt`, t from 0 to
//! sqrt(zeta). In one direction this is the exact law of chapter 6. Where the shift turns, chapter
//! 7 gives a slip annulus one direction of traction over its whole width. How far both laws are from
//! half-spaces there is said in [`crate::turning_law`]; [`SlipTurn`] tells by how much slip has turned.
//!
//! W is stored as a chain of parabolas. Each is a chord and the deviation of its middle from the
//! chord (`bubble` in code). A step applies the exact return mapping of a straight step to the
//! nodes and the middles of the pieces that slip. A piece whose deviation exceeds the tolerance is
//! split. Two pieces that one parabola can replace are joined in such a way that the force does not
//! change. An annulus that slips may lie inside one that sticks, since the curve may be steeper
//! than the friction cone. Therefore all annuli are checked.
//!
//! Each piece carries an estimate of the error of W. Fitting and joining pieces adds to it. The
//! return mapping is the play operator: it does not increase the distance of two values of W. So no
//! error grows, and slip that turns the traction reduces it. [`CoulombMemory::error_estimate`]
//! gives the error of the force.
//!
//! If c_x and c_y differ, an annulus slips along its traction in the normalised shifts of chapter
//! 7, not in lengths. [`crate::sliders`] makes the distinction.

mod capacity;
mod chain;
mod check;
mod drag;
mod energy;
mod fit;
mod heat;
mod join;
mod pack;
mod piece;
mod remaining_error;
mod report;
mod slides;
mod slip_turn;
mod step;
mod storage;
mod zones;

pub(crate) use drag::Step;
pub use pack::packed_numbers;
pub use piece::Node;
pub use report::Arc;
pub use slip_turn::SlipTurn;

use carom_special::RangeError;

use crate::bounds::in_memory;
use crate::memory::{FixedStack, GrowingStack, Lateral, MemoryRegime as Regime, NodeStack};

/// The memory of a contact in which each annulus slips by itself.
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
pub struct CoulombMemory<V, S = GrowingStack<Node<V>>> {
    zeta: f64,
    /// The square root of zeta.
    root: f64,
    shift: V,
    force: V,
    regime: Regime,
    /// Depth of the slip front: the deepest annulus that slipped in the last step. After adhesion,
    /// the approach at which the step began.
    front: f64,
    /// The largest stretch |X - W(0)| of the centre since first contact.
    extent: f64,
    tolerance: f64,
    /// The largest deviation of a parabola from its chord, over the approach.
    max_bubble: f64,
    stack: S,
}

/// Storage of at most N nodes for a [`CoulombMemory`]: plain data.
pub type FixedCurve<V, const N: usize> = FixedStack<Node<V>, N>;

/// Relative accuracy of the curve W(s), and through it of the force: > 0 and at most 0.1.
///
/// It is a share of the approach or, if that is smaller, of the largest shift since first contact.
/// Pieces of the curve are split and joined such that the force stays within this share of the
/// friction limit.
///
/// It controls the discretisation and is no bound of the error; [`CoulombMemory::error_estimate`]
/// estimates the error.
///
/// Errors of the force over its limit, measured against annuli of sliders on ordinary turning
/// paths: at 1e-2, 5e-5 in the mean and 1e-3 at most (3e-4 and 4e-3 with each step divided into
/// 16); at 1e-3, 4e-6 and 4e-5 (divided, 2e-5 and 2e-4). On paths found by hill climbing the error
/// reached 8 times the tolerance at 1e-2. Pieces deep in the contact are joined to an accuracy
/// relative to their own approach, since the contact may recede to it. Pieces that carry little of
/// the force may be less accurate.
///
/// Full storage does not keep the tolerance. Pieces are then merged until the vertices fit, and the
/// curve is resolved no finer than the storage allows: to 7e-3 for 8 vertices and 2e-3 for 12.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Tolerance(f64);

/// The largest deviation of a parabola from its chord, over the power 2/3 of the tolerance.
const BUBBLE_PER_TOLERANCE: f64 = 0.24;

impl Tolerance {
    /// For many particles: 1e-2.
    pub const PARTICLES: Self = Self(1e-2);
    /// For single contacts: 1e-3.
    pub const FINE: Self = Self(1e-3);

    /// A tolerance, > 0 and at most 0.1.
    ///
    /// # Errors
    /// [`RangeError`] if it is not above 0 or is above 0.1.
    pub fn new(tolerance: f64) -> Result<Self, RangeError> {
        let holds = tolerance > 0.0 && tolerance <= 0.1;
        RangeError::check("tolerance", tolerance, holds, "> 0 and <= 0.1").map(Self)
    }

    /// The largest deviation from the chord. The error of a parabola is of third order, as the
    /// power 3/2 of this deviation.
    fn max_bubble(self) -> f64 {
        let root = libm::cbrt(self.0);
        BUBBLE_PER_TOLERANCE * root * root
    }

    /// The tolerance as a number.
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

impl<V: Lateral, S: NodeStack<Node<V>>> CoulombMemory<V, S> {
    /// Byte offset of the regime in the struct.
    pub(crate) const REGIME_AT: usize = std::mem::offset_of!(Self, regime);

    /// Two bodies in first contact at zero shift.
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
            max_bubble: tolerance.max_bubble(),
            stack: S::default(),
        }
    }

    /// Makes a straight step to a new approach and shift and returns the force Phi.
    ///
    /// An approach of at most 1e-130 separates the bodies and deletes the memory. In the step
    /// that closes the gap, the shift at first contact is interpolated.
    ///
    /// # Errors
    /// [`RangeError`] if a value is above 1e100 in size or not a number; the state is then
    /// unchanged.
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
