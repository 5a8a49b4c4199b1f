//! Static friction above kinetic friction as a threshold of full sliding, in one direction.
//!
//! Shifts are normalised by the coefficient f_s of static friction, so that the friction cone has
//! the slope 1 until all of the contact slides. Where the path leaves the cone, the force drops to
//! the share `f_k/f_s`: the polyline becomes a single segment of that slope from depth zero. Sliding
//! goes on as long as the path is steeper than that segment. Since the cone is convex, a straight
//! step leaves it at most once.

use super::{Lateral, Memory, MemoryRegime, Vertex, VertexStack, push};
use crate::bounds::LEAST_APPROACH;
use crate::profile::{GAUSS, NormalProfile};

/// The drop of friction, and the direction of the traction while all of the contact slides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Threshold {
    /// f_k/f_s, below 1.
    ratio: f64,
    /// The sign of the traction in sliding; zero if the contact does not slide.
    direction: f64,
}

/// What a straight step does first.
#[derive(Clone, Copy)]
enum Leg {
    /// The contact slides to the end of the step: it slid before, or slides from this part of the
    /// step on.
    Slide { sign: f64, onset: Option<f64> },
    /// At this part of the step the contact slides and sticks again at once, since it recedes.
    Drop { sign: f64, onset: f64 },
    /// The contact does not slide as a whole.
    Within,
}

/// A receding contact may drop in one direction, then in the other, and then slides on.
const MOST_LEGS: usize = 3;

impl Threshold {
    /// A contact that does not slide.
    pub(crate) const fn new(ratio: f64) -> Self {
        Self { ratio, direction: 0.0 }
    }

    /// How far a shift lies beyond the cone of static friction, if the straight step to it begins
    /// inside; negative infinity if the contact slides on or does not touch.
    pub(crate) fn beyond<S, P>(&self, memory: &Memory<f64, S, P>, zeta: f64, shift: f64) -> f64
    where
        S: VertexStack<f64>,
        P: NormalProfile,
    {
        if !memory.is_touching() || self.slides_on(memory, zeta, shift) {
            return f64::NEG_INFINITY;
        }
        (shift - memory.slide_offset()).abs() - zeta
    }

    /// A step whose arguments were checked.
    pub(crate) fn step<S, P>(&mut self, memory: &mut Memory<f64, S, P>, zeta: f64, shift: f64)
    where
        S: VertexStack<f64>,
        P: NormalProfile,
    {
        if zeta <= LEAST_APPROACH {
            memory.step(zeta, shift);
            self.direction = 0.0;
        } else {
            self.follow(memory, zeta, shift, |_, _| ());
        }
    }

    /// The normalised energy that a straight step would dissipate.
    pub(crate) fn heat<S, P>(mut self, memory: &Memory<f64, S, P>, zeta: f64, shift: f64) -> f64
    where
        S: VertexStack<f64>,
        P: NormalProfile,
    {
        if memory.zeta <= 0.0 && zeta <= 0.0 {
            return 0.0;
        }
        // Of a step that separates the bodies, the part in contact.
        let part = if zeta < 0.0 { memory.zeta / (memory.zeta - zeta) } else { 1.0 };
        let (zeta, shift) = match zeta < 0.0 {
            true => (0.0, memory.place_at(part, zeta, shift).1),
            false => (zeta, shift),
        };
        let (ratio, mut heat) = (self.ratio, 0.0);
        self.follow(&mut memory.clone(), zeta, shift, |memory, leg| {
            heat += leg.heat(memory, ratio, zeta, shift);
        });
        heat
    }

    /// Takes the legs of a step that ends in contact; `see` is called before each of them.
    fn follow<S, P>(
        &mut self,
        memory: &mut Memory<f64, S, P>,
        zeta: f64,
        shift: f64,
        mut see: impl FnMut(&Memory<f64, S, P>, Leg),
    ) where
        S: VertexStack<f64>,
        P: NormalProfile,
    {
        if !memory.is_touching() {
            memory.touch(zeta, shift);
        }
        if zeta == memory.zeta && shift == memory.shift {
            return; // not a step at all: what slides, slides on
        }
        for _ in 0..MOST_LEGS {
            let leg = self.next(memory, zeta, shift);
            see(memory, leg);
            match leg {
                Leg::Slide { sign, .. } => {
                    self.direction = sign;
                    memory.slide_to(zeta, shift, sign * self.ratio);
                    return;
                }
                Leg::Within => break,
                Leg::Drop { sign, onset } => {
                    self.direction = 0.0;
                    let (zeta, shift) = memory.place_at(onset, zeta, shift);
                    memory.slide_to(zeta, shift, sign * self.ratio);
                }
            }
        }
        self.direction = 0.0;
        memory.step(zeta, shift);
    }

    fn next<S, P>(&self, memory: &Memory<f64, S, P>, zeta: f64, shift: f64) -> Leg
    where
        S: VertexStack<f64>,
        P: NormalProfile,
    {
        if self.slides_on(memory, zeta, shift) {
            return Leg::Slide { sign: self.direction, onset: None };
        }
        if self.beyond(memory, zeta, shift) <= 0.0 {
            return Leg::Within;
        }
        let offset = memory.shift - memory.slide_offset();
        let (dz, dx) = (zeta - memory.zeta, shift - memory.shift);
        let sign = 1.0_f64.copysign(offset + dx);
        let onset = f64::sliding_onset(offset, dx, memory.zeta, dz);
        match sign * dx > self.ratio * dz {
            true => Leg::Slide { sign, onset: Some(onset) },
            false => Leg::Drop { sign, onset },
        }
    }

    /// Whether sliding goes on at the start of a step, and then to its end.
    fn slides_on<S, P>(&self, memory: &Memory<f64, S, P>, zeta: f64, shift: f64) -> bool {
        let along = self.direction * (shift - memory.shift);
        self.direction != 0.0 && along > self.ratio * (zeta - memory.zeta)
    }
}

impl Leg {
    /// The heat of this leg of a step from the present state of the memory.
    fn heat<S, P>(self, memory: &Memory<f64, S, P>, ratio: f64, zeta: f64, shift: f64) -> f64
    where
        S: VertexStack<f64>,
        P: NormalProfile,
    {
        match self {
            Self::Within => memory.heat(zeta, shift, 1.0),
            Self::Drop { onset, .. } => memory.heat_of_drop(ratio, onset, zeta, shift),
            Self::Slide { sign, onset } => {
                let (from, start) = memory.place_at(onset.unwrap_or(0.0), zeta, shift);
                let slip = sign * (shift - start) - ratio * (zeta - from);
                let before = onset.map(|part| memory.heat_of_drop(ratio, part, zeta, shift));
                let mean = mean_force(&memory.profile, from, zeta);
                before.unwrap_or(0.0) + ratio * slip.max(0.0) * mean
            }
        }
    }
}

impl<S: VertexStack<f64>, P: NormalProfile> Memory<f64, S, P> {
    /// The approach and shift at a part of a straight step.
    fn place_at(&self, part: f64, zeta: f64, shift: f64) -> (f64, f64) {
        let at = self.zeta + part * (zeta - self.zeta);
        (at.max(0.0), self.shift + part * (shift - self.shift))
    }

    /// Sliding with friction below the cone: one segment of this slope from depth zero.
    #[cold]
    fn slide_to(&mut self, zeta: f64, shift: f64, slope: f64) {
        let vertex = Vertex {
            depth: 0.0,
            anchor: shift - slope * zeta,
            slope,
            force_slope: slope,
            force: 0.0,
            curb: (1.0 - slope * slope).max(0.0),
        };
        self.stack.truncate(0);
        push(&mut self.stack, vertex, &self.profile);
        (self.zeta, self.shift) = (zeta, shift);
        self.finish(zeta, MemoryRegime::Sliding);
    }

    /// The heat of a step up to the onset of sliding at this part of it, and that of the drop: all
    /// springs relax from f_s to f_k times their pressures.
    fn heat_of_drop(&self, ratio: f64, onset: f64, zeta: f64, shift: f64) -> f64 {
        let (at, place) = self.place_at(onset, zeta, shift);
        let before = self.heat(at, place, 1.0);
        before + (1.0 - ratio) * (1.0 + ratio) * self.profile.energy(at)
    }
}

/// The mean of the normal force over a range of approaches.
pub(crate) fn mean_force<P: NormalProfile>(profile: &P, from: f64, to: f64) -> f64 {
    let length = to - from;
    if length.abs() > 0.1 * from.max(to) {
        return (profile.energy(to) - profile.energy(from)) / length;
    }
    let at = |part: f64| profile.force(from + part * length);
    GAUSS.iter().fold(0.0, |sum, &(part, weight)| sum + weight * at(part))
}
