//! What can be asked of the law: stick area, tractions, tangent stiffness.

use super::piece::Piece;
use super::{CoulombMemory, Node};
use crate::memory::{Lateral, MemoryRegime as Regime, NodeStack, Tangent, Turn};
use crate::profile::GAUSS;

/// A piece of the curve of zero-traction shifts: `W = chord + 4 tau (1 - tau) bubble`, with tau
/// from 0 to 1 over the depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc<V> {
    /// Depth of the lower end.
    pub from: f64,
    /// Depth of the upper end.
    pub to: f64,
    /// Zero-traction shifts at both ends.
    pub anchors: [V; 2],
    /// Deviation of the middle from the chord.
    pub bubble: V,
}

/// Error of the force over its limit by round-off alone, for small shifts.
const ROUND_OFF: f64 = 1e-12;
/// Below this tolerance the summed error of the pieces is multiplied by `FACTOR_AT_FINE_TOLERANCE`:
/// pieces are then fitted until the error at a few annuli is small, and the error between them
/// counts for more.
const COARSE_TOLERANCE: f64 = 5e-3;
const FACTOR_AT_FINE_TOLERANCE: f64 = 2.0;

impl<V: Lateral, S: NodeStack<Node<V>>> CoulombMemory<V, S> {
    /// The approach zeta; negative while the bodies are separated.
    #[must_use]
    pub fn zeta(&self) -> f64 {
        self.zeta
    }

    /// The normalised shift X.
    #[must_use]
    pub fn shift(&self) -> V {
        self.shift
    }

    /// The normalised force Phi; F = (2/3) f c_z Phi.
    #[inline]
    #[must_use]
    pub fn force(&self) -> V {
        self.force
    }

    /// The normalised normal force, zeta^(3/2).
    #[must_use]
    pub fn normal_force(&self) -> f64 {
        let zeta = self.zeta.max(0.0);
        zeta * zeta.sqrt()
    }

    /// What the last step did. Alternating zones of stick and slip are not distinguished.
    #[must_use]
    pub fn regime(&self) -> Regime {
        self.regime
    }

    /// Whether the bodies are in contact.
    #[must_use]
    pub fn is_touching(&self) -> bool {
        !self.stack.is_empty()
    }

    /// The storage of the vertices, for state that is stored elsewhere.
    #[must_use]
    pub fn stack(&self) -> &S {
        &self.stack
    }

    /// How often two pieces were merged for lack of room, regardless of the tolerance.
    #[must_use]
    pub fn merges(&self) -> u32 {
        self.stack.merges()
    }

    /// An estimate of the error of the force over its limit `zeta^(3/2)` since first contact: at
    /// most 2, and round-off alone where the law is exact.
    ///
    /// It sums `(3/2) int e dt` over the pieces of the curve, e the error of W. The displacement by
    /// joins and merges is exact. The error of a fitted parabola is estimated from three to five of
    /// its annuli and from the change of its deviation from the chord. No error grows afterwards,
    /// and slip that turns a traction reduces it. Below a tolerance of 5e-3 the sum is doubled. The
    /// tolerance itself is added, for errors that no sampled annulus shows.
    ///
    /// This is no proven bound, since the error between the sampled annuli is not enclosed. A hill
    /// climb over paths (the example `adversary`) seeks the largest ratio of error to estimate, in
    /// growing storage and for 8, 12, 16 and 32 vertices. Climbs of 40 seconds each (seed 31), and
    /// of 80 at 1e-5 (seed 22), reached a ratio of 0.74 at a tolerance of 1e-2, 0.42 at 1e-3 and
    /// 0.44 at 1e-5. The error itself reached 8 times the tolerance at 1e-2, and more in full
    /// storage: if the contact recedes to a hundredth of its approach, errors allowed for the whole
    /// contact count for more. On ordinary paths the estimate is some hundred times the error, and
    /// up to a thousand times if each step is divided into 16.
    ///
    /// It counts from first contact, or from [`CoulombMemory::unpack`], since a packed state does
    /// not contain it. Work and heat have errors of their own: [`CoulombMemory::joined_energy`].
    #[must_use]
    pub fn error_estimate(&self) -> f64 {
        let limit = self.normal_force();
        if limit <= 0.0 {
            return 0.0;
        }
        let error: f64 = self.chain().map(|piece| piece.force_error(self.zeta)).sum();
        let round_off = ROUND_OFF * (1.0 + self.shift.length() / self.zeta);
        let share = if self.tolerance < COARSE_TOLERANCE { FACTOR_AT_FINE_TOLERANCE } else { 1.0 }
            * error
            / limit;
        let unseen = if share > round_off { self.tolerance } else { 0.0 };
        (share + unseen + round_off).min(2.0)
    }

    /// The pieces of the curve, from the centre to the edge.
    pub fn arcs(&self) -> impl Iterator<Item = Arc<V>> + '_ {
        self.chain().map(|piece| Arc {
            from: piece.low.depth,
            to: piece.high.depth,
            anchors: [piece.low.anchor, piece.high.anchor],
            bubble: piece.bubble,
        })
    }

    /// The zero-traction shift W(s): the shift at which the annulus of depth s would carry no load.
    /// Outside the contact it is the present shift.
    #[must_use]
    pub fn anchor(&self, depth: f64) -> V {
        let holds = |piece: &Piece<V>| depth < piece.high.depth;
        self.chain().find(holds).map_or(self.shift, |piece| {
            let length = piece.high.depth - piece.low.depth;
            piece.at((depth - piece.low.depth).max(0.0) / length)
        })
    }

    /// zeta*, the depth below which all annuli stuck in the last step; zero in sliding. Annuli
    /// above it may also have stuck: [`CoulombMemory::stick_fraction`].
    #[must_use]
    pub fn stick_depth(&self) -> f64 {
        match self.regime {
            Regime::Separated | Regime::Sliding => 0.0,
            Regime::Adhesion | Regime::Release => self.zeta,
            _ => self.front,
        }
    }

    /// The share of the contact area that sticks, from 0 to 1: the annuli below
    /// [`CoulombMemory::stick_depth`], and those above it that are farther from their limit than
    /// the tolerance.
    #[must_use]
    pub fn stick_fraction(&self) -> f64 {
        if self.zeta <= 0.0 {
            return 0.0;
        }
        let mut depth = self.stick_depth();
        for (from, to, middle) in self.halves() {
            let length = to - from.max(self.stick_depth());
            if length > 0.0 && self.sticks(0.5 * (from + to), middle) {
                depth += length;
            }
        }
        (depth / self.zeta).min(1.0)
    }

    /// Whether an annulus above the stick depth is farther from its limit than the tolerance.
    fn sticks(&self, depth: f64, anchor: V) -> bool {
        let stretch = self.shift.minus(anchor).length();
        self.zeta - depth - stretch > self.tolerance * self.zeta
    }

    /// The halves of all pieces: the depths of their ends, and W at their middle.
    fn halves(&self) -> impl Iterator<Item = (f64, f64, V)> + '_ {
        self.chain().flat_map(|piece| {
            let middle = piece.middle_depth();
            [(piece.low.depth, middle, piece.at(0.25)), (middle, piece.high.depth, piece.at(0.75))]
        })
    }

    /// The direction of the traction of the annulus of a depth, that of its stretch X - W: a unit
    /// vector, or zero if it has no traction.
    #[must_use]
    pub fn direction(&self, depth: f64) -> V {
        let stretch = self.shift.minus(self.anchor(depth));
        let length = stretch.length();
        if length > 0.0 { stretch.times(1.0 / length) } else { V::default() }
    }

    /// The traction in units of `f sigma_z0`, the greatest frictional traction.
    ///
    /// `q = (x/a)^2 + (y/b)^2` is the square of the elliptical radius in the present contact, and
    /// the traction `int sqrt(s - q zeta)' dW`.
    ///
    /// The limit holds for each annulus of the equivalent foundation. Where the direction turns,
    /// the traction at a point may exceed its limit by some percent.
    #[must_use]
    pub fn traction(&self, q: f64) -> V {
        if !(self.zeta > 0.0 && q < 1.0) {
            return V::default();
        }
        let depth = q * self.zeta;
        let g = |s: f64| (s - depth).max(0.0).sqrt();
        let area = |s: f64| 2.0 / 3.0 * (s - depth).max(0.0).powi(3).sqrt();
        let mut sum = V::default();
        for piece in self.chain().filter(|piece| piece.high.depth > depth) {
            let [low, high] = [piece.low.depth, piece.high.depth];
            let length = high - low;
            let rise = piece.high.anchor.minus(piece.low.anchor).times(1.0 / length);
            // W' = rise + 4 (1 - 2 tau) bubble/length, by parts
            let bubble = 2.0 * (area(high) - area(low)) / length - g(high) - g(low);
            sum = sum
                .plus(rise.times(g(high) - g(low)))
                .plus(piece.bubble.times(4.0 * bubble / length));
        }
        sum.times(1.0 / self.zeta.sqrt())
    }

    /// The derivatives of the force with respect to approach and shift if the last step continues.
    ///
    /// In adhesion they are those at the end of the step. In slip they are those of the last
    /// instant: the traction of a slipping annulus turns,
    /// `dPhi = (3/2) (I - m m^T) dX dt + (3/2) m dzeta dt`; the other annuli stick.
    #[must_use]
    pub fn tangent(&self) -> Tangent {
        let isotropic = |k: f64| [[k, 0.0], [0.0, k]];
        let mut tangent = Tangent { by_shift: isotropic(0.0), by_approach: [0.0; 2] };
        match self.regime {
            Regime::Separated => tangent,
            Regime::Release => Tangent { by_shift: isotropic(1.5 * self.root), ..tangent },
            Regime::Adhesion => self.adhesion_tangent(),
            _ => {
                let stick = 1.5 * self.stick_depth().sqrt();
                tangent.by_shift = isotropic(stick);
                for piece in self.chain() {
                    self.add_slip(&piece, &mut tangent);
                }
                tangent
            }
        }
    }

    /// The tangent of the piece appended by the last step, which began at `front`.
    fn adhesion_tangent(&self) -> Tangent {
        let (a, b) = (self.front.sqrt(), self.root);
        let chord = a + b - a * b / (a + b);
        // d/dzeta of dX (a^2 + a b + b^2)/(a + b)
        let by_depth = (1.0 - a * a / ((a + b) * (a + b))) / (2.0 * b);
        let rise = self.shift.minus(self.anchor(self.front)).components();
        Tangent { by_shift: [[chord, 0.0], [0.0, chord]], by_approach: rise.map(|r| r * by_depth) }
    }

    /// Adds the annuli of a piece above the stick depth.
    fn add_slip(&self, piece: &Piece<V>, tangent: &mut Tangent) {
        let (low, high) = (piece.low.root.max(self.stick_depth().sqrt()), piece.high.root);
        let length = piece.high.depth - piece.low.depth;
        if high <= low || length <= 0.0 {
            return;
        }
        for (part, weight) in GAUSS {
            let root = low + part * (high - low);
            let at = (root - piece.low.root) * (root + piece.low.root) / length;
            let anchor = piece.at(at);
            let stretch = self.shift.minus(anchor);
            let size = stretch.length();
            let weight = 1.5 * weight * (high - low);
            let slips = size > 0.0 && !self.sticks(root * root, anchor);
            let m = if slips { stretch.times(1.0 / size).components() } else { [0.0; 2] };
            for i in 0..2 {
                tangent.by_shift[i][i] += weight;
                for j in 0..2 {
                    tangent.by_shift[i][j] -= weight * m[i] * m[j];
                }
                tangent.by_approach[i] += weight * m[i];
            }
        }
    }

    /// Moves the origin of the shifts: adds `by` to X and W. Forces do not change.
    pub fn translate(&mut self, by: V) {
        self.shift = self.shift.plus(by);
        for i in 0..self.stack.len() {
            let vertex = self.stack.get_mut(i);
            vertex.anchor = vertex.anchor.plus(by);
        }
    }
}

impl<S: NodeStack<Node<[f64; 2]>>> CoulombMemory<[f64; 2], S> {
    /// Turns the frame in the contact plane: all components refer to axes rotated by `angle`
    /// (radians, counter-clockwise).
    pub fn turn_frame(&mut self, angle: f64) {
        let turn = Turn::by(angle);
        self.shift = turn.of(self.shift);
        self.force = turn.of(self.force);
        for i in 0..self.stack.len() {
            let node = self.stack.get_mut(i);
            for vector in [&mut node.anchor, &mut node.bubble, &mut node.force] {
                *vector = turn.of(*vector);
            }
        }
    }
}
