//! Static friction above kinetic friction as a threshold of full sliding, for shifts that turn.
//!
//! Shifts are normalised by the coefficient f_s of static friction. While some annulus sticks, the
//! memory is that of one coefficient, f_s. When the last annulus reaches its limit, every traction
//! drops to the share rho = f_k/f_s of it and keeps its direction. The contact then slides with f_k
//! as long as every annulus slips; as soon as one of them sticks, the limit is that of f_s again.
//!
//! In the units of f_k a stretch has the length that it had before the drop in those of f_s: its
//! limit in these units is the same. So the curve of anchors W(s) is not changed by the drop; it is
//! only read in other units. A memory that slides has the regime `Sliding`, stretches `X - W` in the
//! units of f_k, and its tip at the shift X. A path dX is dX/rho in these units. When the contact
//! sticks again, every stretch is multiplied by rho, and lies within the cone of f_s.
//!
//! On a straight step the traction of an annulus that slips turns towards the path, and slip becomes
//! faster. So an annulus slips from where it reaches its limit to the end of the step, and whether
//! sliding goes on is decided where the step begins. The last annulus to reach its limit is the
//! centre if the directions of traction do not differ; otherwise annuli of the whole curve are
//! asked.

mod heat;
mod slides;

pub(crate) use slides::{Slides, slides_by_own_names};

use carom_special::RangeError;

use crate::bounds::LEAST_APPROACH;
use crate::coulomb::{CoulombMemory, Node};
use crate::memory::{
    Lateral, Memory, MemoryRegime as Regime, NodeStack, Tangent, VertexStack, cone_exit,
};

/// A memory with static friction above kinetic friction, in the units of static friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct StaticMemory<M> {
    memory: M,
    /// f_k/f_s, below 1.
    ratio: f64,
}

/// What a straight step does next.
#[derive(Debug, Clone, Copy)]
enum Leg {
    /// Up to this part of it, the contact does not slide as a whole; then the force drops.
    Rise { onset: f64 },
    /// The contact slides to the end of the step.
    Slide,
    /// The contact does not slide as a whole to the end of the step.
    Within,
}

/// The way of a straight step. Whether a contact slides on depends on its direction alone, which is that of the whole
/// step at each place of it: what is left behind a drop may be as short as the round-off of the shift.
#[derive(Debug, Clone, Copy)]
struct Way<V> {
    /// The shift, in the units of f_k.
    path: V,
    /// The growth of the approach.
    growth: f64,
}

/// A contact that recedes may drop, stick again at once, and drop in another direction.
const MOST_DROPS: usize = 8;
/// Sliding by this many approaches in the units of f_k aligns all tractions with the path, to the
/// last bit: what is left of the tangent of half their angle is below exp(-100).
const LONGEST_PATH: f64 = 100.0;
/// A shift of more approaches has less than ten digits for a stretch.
const FAR: f64 = 1e6;
/// Cosine of the angle between traction and path that counts as zero.
const LEAST_COSINE: f64 = 1e-9;

impl<M: Slides> StaticMemory<M> {
    /// Byte offset of the memory in the struct.
    pub(crate) const MEMORY_AT: usize = std::mem::offset_of!(Self, memory);

    /// A memory in its initial state, and f_k/f_s.
    pub(crate) const fn new(memory: M, ratio: f64) -> Self {
        Self { memory, ratio }
    }

    /// f_k/f_s.
    pub(crate) const fn ratio(&self) -> f64 {
        self.ratio
    }

    pub(crate) fn zeta(&self) -> f64 {
        self.memory.approach()
    }

    pub(crate) fn shift(&self) -> M::V {
        self.memory.place()
    }

    pub(crate) fn regime(&self) -> Regime {
        self.memory.stage()
    }

    pub(crate) fn stack(&self) -> &M::Stack {
        self.memory.vertices()
    }

    pub(crate) fn stick_fraction(&self) -> f64 {
        self.memory.stick_share()
    }

    #[inline]
    pub(crate) fn force(&self) -> M::V {
        self.memory.phi().times(self.factor())
    }

    pub(crate) fn stored_energy(&self) -> M::V {
        self.memory.elastic().times(self.factor() * self.factor())
    }

    pub(crate) fn traction(&self, q: f64) -> M::V {
        self.memory.traction_at(q).times(self.factor())
    }

    /// The tangent of the last step. Force and shift have the same factor in sliding.
    pub(crate) fn tangent(&self) -> Tangent {
        let Tangent { by_shift, by_approach } = self.memory.rates();
        Tangent { by_shift, by_approach: by_approach.map(|rate| rate * self.factor()) }
    }

    pub(crate) fn translate(&mut self, by: M::V) {
        self.memory.move_by(by);
    }

    pub(crate) fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        self.memory.write(numbers)
    }

    pub(crate) fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        self.memory.read(numbers)
    }

    /// A step whose arguments were checked.
    #[inline(never)]
    pub(crate) fn step(&mut self, zeta: f64, shift: M::V) {
        if zeta <= LEAST_APPROACH {
            self.memory.go(zeta, shift);
        } else {
            self.follow(zeta, shift, |_, _| ());
        }
    }

    /// Whether the force drops on a straight step.
    pub(crate) fn jumps(&self, zeta: f64, shift: M::V) -> bool {
        if !self.memory.is_in_contact() || self.slides_on(&self.way(zeta, shift)) {
            return false;
        }
        let mut at_rest = self.clone();
        at_rest.stick();
        at_rest.onset(zeta, shift).is_some()
    }

    /// Whether a contact that slides would slide on at these rates of approach and shift; none if it does not slide.
    pub(crate) fn slides_along(&self, growth: f64, rate: M::V) -> Option<bool> {
        // Times f_k/f_s, since only the direction counts.
        let way = Way { path: rate, growth: growth * self.ratio };
        self.slides().then(|| self.is_outward(&way))
    }

    /// Takes the legs of a step that ends in contact; `see` is called before each of them.
    fn follow(&mut self, zeta: f64, shift: M::V, mut see: impl FnMut(&Self, Leg)) {
        if !self.memory.is_in_contact() {
            self.memory.begin(zeta, shift);
        }
        if zeta == self.zeta() && shift == self.shift() {
            return; // not a step at all: what slides, slides on
        }
        let way = self.way(zeta, shift);
        for _ in 0..MOST_DROPS {
            if self.slides_on(&way) {
                see(self, Leg::Slide);
                self.slide(zeta, shift);
                return;
            }
            self.stick();
            let Some(onset) = self.onset(zeta, shift) else { break };
            see(self, Leg::Rise { onset });
            self.rise(onset, zeta, shift);
            if self.is_outward(&way) {
                see(self, Leg::Slide);
                self.slide(zeta, shift);
                return;
            }
        }
        self.stick();
        see(self, Leg::Within);
        self.memory.go(zeta, shift);
        if self.slides() {
            self.memory.set_stage(Regime::Slip); // by round-off: the limit is that of f_s
        }
    }

    /// Up to a part of a straight step, at which the force drops.
    fn rise(&mut self, onset: f64, zeta: f64, shift: M::V) {
        let (at, place) = self.at(onset, zeta, shift);
        if at > LEAST_APPROACH {
            self.memory.go(at, place);
        }
        self.memory.set_stage(Regime::Sliding);
    }

    /// Slides to the end of a straight step.
    fn slide(&mut self, zeta: f64, shift: M::V) {
        let path = self.path(zeta, shift);
        if self.shift().length() > FAR * zeta {
            // A path of some approaches has the round-off of the shift, or is lost in it: it is made at the origin.
            self.memory.move_by(self.shift().times(-1.0));
        }
        self.memory.go(zeta, self.shift().plus(path));
        self.memory.move_by(shift.minus(self.memory.place()));
        if zeta > 0.0 {
            self.memory.set_stage(Regime::Sliding);
        }
    }

    /// What slid sticks: the tractions stay, and their limit is that of f_s.
    fn stick(&mut self) {
        if self.slides() {
            self.memory.shrink(self.ratio);
            self.memory.set_stage(Regime::Slip);
        }
    }

    /// Whether all of the contact slides.
    pub(crate) fn slides(&self) -> bool {
        self.memory.stage() == Regime::Sliding
    }

    /// What a force of the memory is multiplied by.
    fn factor(&self) -> f64 {
        if self.slides() { self.ratio } else { 1.0 }
    }

    /// The approach and shift at a part of a straight step.
    fn at(&self, part: f64, zeta: f64, shift: M::V) -> (f64, M::V) {
        let at = self.zeta() + part * (zeta - self.zeta());
        (at.max(0.0), self.shift().plus(shift.minus(self.shift()).times(part)))
    }

    /// The path of a straight step in the units of f_k; at most as long as the tractions notice.
    fn path(&self, zeta: f64, shift: M::V) -> M::V {
        let dx = shift.minus(self.shift());
        let (length, longest) = (dx.length(), LONGEST_PATH * self.zeta().max(zeta));
        if length > longest * self.ratio {
            dx.times(1.0 / length).times(longest)
        } else if length > 0.0 {
            dx.times(1.0 / self.ratio)
        } else {
            M::V::default()
        }
    }

    /// The way of a straight step from here.
    fn way(&self, zeta: f64, shift: M::V) -> Way<M::V> {
        Way { path: self.path(zeta, shift), growth: zeta - self.zeta() }
    }

    /// Whether sliding goes on at the start of a straight step, and then to its end.
    fn slides_on(&self, way: &Way<M::V>) -> bool {
        self.slides() && self.is_outward(way)
    }

    /// Whether no traction comes within its limit of f_k on this way.
    fn is_outward(&self, way: &Way<M::V>) -> bool {
        let least = way.growth - LEAST_COSINE * way.path.length();
        self.memory.annuli().all(|(_, stretch)| stretch.dot(way.path) >= least * stretch.length())
    }

    /// Whether every annulus in contact at the end of a straight path would exceed its limit there.
    fn all_exceed(&self, zeta: f64, path: M::V) -> bool {
        self.memory.annuli().all(|(depth, stretch)| {
            let (end, limit) = (stretch.plus(path), zeta - depth);
            limit <= 0.0 || end.dot(end) > limit * limit
        })
    }

    /// The part of a straight step from which all of the contact slides, if it slides at the end.
    fn onset(&self, zeta: f64, shift: M::V) -> Option<f64> {
        let (dz, dx) = (zeta - self.zeta(), shift.minus(self.shift()));
        let edge_sticks = dz > 0.0 && dx.dot(dx) <= dz * dz;
        if edge_sticks || !self.all_exceed(zeta, dx) {
            return None;
        }
        let exit = |(depth, stretch)| cone_exit(stretch, dx, self.zeta() - depth, dz);
        Some(self.memory.annuli().map(exit).fold(0.0, f64::max))
    }
}

impl<S: VertexStack<[f64; 2]>> StaticMemory<Memory<[f64; 2], S>> {
    /// Rotates the frame in the contact plane.
    pub(crate) fn turn_frame(&mut self, angle: f64) {
        self.memory.turn_frame(angle);
    }
}

impl<S: NodeStack<Node<[f64; 2]>>> StaticMemory<CoulombMemory<[f64; 2], S>> {
    /// Rotates the frame in the contact plane.
    pub(crate) fn turn_frame(&mut self, angle: f64) {
        self.memory.turn_frame(angle);
    }
}
