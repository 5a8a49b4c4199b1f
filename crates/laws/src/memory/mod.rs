//! The memory polyline of chapters 6 and 7: the tangential force for any load history.
//!
//! In normalised shifts the state is a polyline `W(s)`, `0 <= s <= zeta`, of slopes at most 1. The
//! anchor W(s) is the shift at which the annulus that came into contact at the approach s would
//! carry no tangential load. A step cuts the polyline by the cone `|X - W(s)| <= zeta - s`; the
//! part outside is replaced by a segment of slope 1, the new slip annulus. All rules of chapters 6,
//! 7 and 8.4 (points of instantaneous adhesion, the N-th decrease, overlays, wipe-outs) follow from
//! this one rule, and so does the release at a receding edge, which the thesis omits.
//!
//! The vertices of the polyline are a stack: a step removes vertices at the edge of the contact and adds a few
//! there. A long history therefore costs no more per step, in the mean, than a short one. A stack that grows
//! ([`Growing`]) keeps all vertices that still count, and is exact; one of fixed capacity ([`Fixed`]) is plain data.
//!
//! Shifts are normalised so that the friction cone has the slope 1: `X = (c_x xi, c_y eta)/(f c_z)`
//! (chapter 7). For two equal spheres and the one-sphere displacements of chapter 6 this is `xi/(f
//! kappa)`. The normalised force is Phi, with `F = (2/3) f c_z Phi` and `|Phi| <= zeta^(3/2)`.
//! [`crate::shift_law`] converts to physical quantities.
//!
//! In one direction the law is exact within the assumptions of Cattaneo and Mindlin. In two
//! directions it is the approximation of chapter 7 (one direction of traction in each slip
//! annulus), which agrees with the one-dimensional law on straight paths. For paths whose direction
//! changes see [`crate::coulomb`].

mod adhesion;
mod energy;
mod lateral;
mod loss;
mod merge;
mod pack;
mod report;
mod slides;
mod slip_in_line;
mod slip_in_plane;
mod stack;
mod stored;

pub use adhesion::AdhesionMemory;
pub use lateral::Lateral;
pub(crate) use lateral::cone_exit;
pub(crate) use report::Turn;
pub use report::{Segment, Tangent};
pub use stack::{Fixed, FixedStack, Growing, GrowingStack, NodeStack, Nodes, Vertex, VertexStack};
pub(crate) use stored::{Form, Head};

use carom_special::RangeError;

use crate::bounds::{LEAST_APPROACH, LEAST_SQUARE, in_memory};
use crate::profile::{Hertzian, NormalProfile};
use merge::push;

/// The contact state after the last step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[repr(u8)]
pub enum MemoryRegime {
    /// The bodies are separated.
    #[default]
    Separated,
    /// Complete adhesion: the contact grew faster than the shift.
    Adhesion,
    /// The edge receded, and the rest of the contact did not slip.
    Release,
    /// A slip annulus: slip began, or the stick area continued to shrink.
    Slip,
    /// Slip began again at the edge after a point of instantaneous adhesion.
    Reversal,
    /// A slip annulus overlaid older ones: at least one point of instantaneous adhesion was wiped
    /// out.
    Overlay,
    /// Gross sliding.
    Sliding,
}

/// The load history of a contact in one direction, `V = f64`, or two, `V = [f64; 2]`.
///
/// `S` is the storage of the vertices ([`Growing`] is exact, [`Fixed`] is plain data) and `P` the
/// normal law.
///
/// ```
/// use carom_laws::memory::{Memory, MemoryRegime};
/// let mut memory: Memory<f64> = Memory::new();
/// memory.advance(1.0, 0.0)?; // press
/// memory.advance(1.0, 0.6)?; // shift
/// assert_eq!(memory.regime(), MemoryRegime::Slip);
/// assert_eq!(memory.stick_depth(), 0.4);
/// let virgin = 1.0 - 0.4_f64.powf(1.5);
/// assert!((memory.force() - virgin).abs() < 1e-15);
/// memory.advance(1.0, -0.6)?; // all the way back: the loop is symmetric
/// assert!((memory.force() + virgin).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Memory<V, S = Growing<V>, P = Hertzian> {
    zeta: f64,
    shift: V,
    force: V,
    regime: MemoryRegime,
    stack: S,
    profile: P,
}

/// The exact memory for shifts in one direction.
pub type ScalarMemory = Memory<f64>;
/// The memory of chapter 7 for shifts in two directions, with storage that grows.
pub type VectorMemory = Memory<[f64; 2]>;

impl<V: Lateral, S: VertexStack<V>> Default for Memory<V, S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<V: Lateral, S: VertexStack<V>> Memory<V, S> {
    /// Two bodies at first contact, without shift.
    #[must_use]
    pub fn new() -> Self {
        Self::with_profile(Hertzian)
    }
}

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> Memory<V, S, P> {
    /// Byte offset of the regime.
    pub(crate) const REGIME_AT: usize = std::mem::offset_of!(Self, regime);

    /// Two bodies with another normal law at first contact, without shift.
    #[must_use]
    pub fn with_profile(profile: P) -> Self {
        Self {
            zeta: 0.0,
            shift: V::default(),
            force: V::default(),
            regime: MemoryRegime::Separated,
            stack: S::default(),
            profile,
        }
    }

    /// Advances on a straight path to a new approach and shift and returns the force Phi.
    ///
    /// The bodies separate if the approach is at most 1e-130, and the memory is lost. In the step
    /// that closes the gap the shift at first contact is interpolated.
    ///
    /// # Errors
    /// [`RangeError`] for a value that is NaN or above 1e100 in magnitude; the state is then
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

    /// A step whose arguments were checked.
    #[inline]
    pub(crate) fn step(&mut self, zeta: f64, shift: V) {
        if zeta <= LEAST_APPROACH {
            self.separate(zeta.min(0.0), shift);
            return;
        }
        if self.stack.is_empty() {
            self.touch(zeta, shift);
        }
        let dz = zeta - self.zeta;
        let dx = shift.minus(self.shift);
        if dz > 0.0 && dx.dot(dx) <= dz * dz {
            self.adhere(zeta, dx.times(1.0 / dz));
        } else {
            self.cut(zeta, shift);
        }
        self.zeta = zeta;
        self.shift = shift;
    }

    #[cold]
    fn separate(&mut self, zeta: f64, shift: V) {
        self.stack.truncate(0);
        (self.zeta, self.shift, self.regime) = (zeta, shift, MemoryRegime::Separated);
        self.force = V::default();
    }

    /// Moves a separated pair to the point of first contact on its path.
    #[cold]
    fn touch(&mut self, zeta: f64, shift: V) {
        let part = self.zeta / (self.zeta - zeta);
        self.shift = self.shift.plus(shift.minus(self.shift).times(part));
        (self.zeta, self.force) = (0.0, V::default());
        let vertex = Vertex { anchor: self.shift, curb: 1.0, ..Vertex::default() };
        push(&mut self.stack, vertex, &self.profile);
    }

    /// Appends the segment of complete adhesion (6.45), (7.54).
    #[inline]
    fn adhere(&mut self, zeta: f64, slope: V) {
        let vertex = Vertex {
            depth: self.zeta,
            anchor: self.shift,
            slope,
            force_slope: slope,
            force: self.force,
            curb: (1.0 - slope.dot(slope)).max(0.0),
        };
        let top = self.stack.len() - 1;
        let below = self.stack.get_mut(top);
        if below.depth >= vertex.depth {
            *below = vertex; // the first segment after touch
        } else if below.slope != slope || below.force_slope != slope {
            push(&mut self.stack, vertex, &self.profile);
        }
        self.finish(zeta, MemoryRegime::Adhesion);
    }

    #[inline]
    fn finish(&mut self, zeta: f64, regime: MemoryRegime) {
        self.force = self.stack.get(self.stack.len() - 1).force_at(zeta, &self.profile);
        self.regime = regime;
    }

    /// Cuts the polyline by the cone below the new point and appends the segment of the slip
    /// annulus.
    #[inline]
    fn cut(&mut self, zeta: f64, shift: V) {
        let (mut end, mut anchor) = (self.zeta, self.shift);
        let mut rings = 0_u32;
        for i in (0..self.stack.len()).rev() {
            let segment = self.stack.get(i);
            if segment.depth < zeta {
                let beyond = zeta - end;
                let d = shift.minus(anchor).minus(segment.slope.times(beyond));
                // The new point is on the segment's line. It may be beyond the end by rounding
                // only, or in slip: true growth along an adhering segment is adhesion, not a cut.
                if d.dot(d) < LEAST_SQUARE {
                    self.recede(zeta, i);
                    return;
                }
                let length = zeta - segment.depth;
                if let Some(reach) = V::reach(d, segment.slope, segment.curb, length) {
                    self.lay_slip(zeta, i, d, reach.max(beyond), rings);
                    return;
                }
                rings += u32::from(segment.is_slip());
            }
            (end, anchor) = (segment.depth, segment.anchor);
        }
        self.slide(zeta, shift);
    }

    /// No slip: the point stays on segment i, or on a slip segment that continues i.
    fn recede(&mut self, zeta: f64, i: usize) {
        if zeta == self.zeta && i + 1 == self.stack.len() {
            return; // not a step at all
        }
        self.stack.truncate(i + 1);
        let in_ring = self.stack.get(i).is_slip();
        self.finish(zeta, if in_ring { MemoryRegime::Slip } else { MemoryRegime::Release });
    }

    /// The slip annulus that ends on segment i, `reach` deep.
    #[inline]
    fn lay_slip(&mut self, zeta: f64, i: usize, d: V, reach: f64, rings: u32) {
        let below = self.stack.get(i);
        let depth = zeta - reach;
        let slope = V::slip_slope(d, below.slope, reach);
        let force = below.force_at(depth, &self.profile);
        let anchor = below.anchor_at(depth);
        let reversed = rings == 0 && below.is_slip();
        self.stack.truncate(i + 1);
        push(
            &mut self.stack,
            Vertex { depth, anchor, slope, force_slope: slope, force, curb: 0.0 },
            &self.profile,
        );
        self.force = force.plus(slope.times(self.profile.growth(depth, reach)));
        self.regime = match rings {
            0 if reversed => MemoryRegime::Reversal,
            0 | 1 => MemoryRegime::Slip,
            _ => MemoryRegime::Overlay,
        };
    }

    /// Gross sliding: the whole polyline is one segment of slope 1 whose lower end is dragged
    /// along.
    #[cold]
    fn slide(&mut self, zeta: f64, shift: V) {
        let base = *self.stack.get(0);
        let dx = shift.minus(self.shift);
        let dz = zeta - self.zeta;
        let offset = self.shift.minus(base.anchor);
        let onset = V::sliding_onset(offset, dx, self.zeta, dz);
        let arm = offset.plus(dx.times(onset));
        let from = self.zeta + onset * dz;
        let before = V::slip_slope(arm, base.slope, 0.0);
        let slope = V::dragged(before, dx.times(1.0 - onset), from, zeta);
        self.stack.truncate(0);
        push(
            &mut self.stack,
            Vertex {
                depth: 0.0,
                anchor: shift.minus(slope.times(zeta)),
                slope,
                force_slope: slope,
                force: V::default(),
                curb: 0.0,
            },
            &self.profile,
        );
        self.finish(zeta, MemoryRegime::Sliding);
    }
}
