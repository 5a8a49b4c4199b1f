//! Resolutions of an impact by rings, from coarse to fine, and a run with each.

use std::f64::consts::PI;

use carom_laws::friction::Friction;
use carom_laws::rings::{AlikePlane, Plane, RingLaw, Symmetry, Tolerance};
use carom_laws::shift_law::ShiftLaw;
use nalgebra::Vector3;

use super::RingImpactError;
use super::motion::{Instant, Motion, Passage, Turned};
use super::problem::Problem;
use crate::coupled::{Sample, Stage};

/// Numbers of rings and steps.
#[derive(Debug, Clone, Copy)]
pub(super) struct Level {
    run: Run,
    pub(super) rings: usize,
    steps: usize,
    tolerance: f64,
    /// The error estimate over the change from the coarser level.
    pub(super) left: f64,
    /// What finer levels would change of the tangential velocity, over that change; it is added.
    pub(super) beyond: f64,
    pub(super) floor: Floor,
    /// Whether impacts with the default tolerance may take it; others take 40 ms and more.
    pub(super) is_usual: bool,
}

/// Lower bound of the error of the velocity over f v_z, for cases where that change is accidentally small: a
/// sum.
#[derive(Debug, Clone, Copy)]
pub(super) struct Floor {
    pub(super) always: f64,
    /// Coefficient of |gamma|.
    pub(super) by_gamma: f64,
    /// Coefficient of |gamma| f.
    pub(super) by_strength: f64,
    /// Coefficient of |gamma|/f if the contact slides: the direction of slip then varies more than the angles
    /// resolve.
    pub(super) by_spread: f64,
    /// Lower bound of the error of the spin after the impact over that before.
    pub(super) of_spin: f64,
}

/// Rings, angles of a turn, of half and a quarter; steps, tolerance, share of the change that is left, floors.
macro_rules! level {
    ($n:literal, $m:literal, $h:literal, $q:literal; $steps:expr, $tolerance:expr, $left:expr, $floor:expr, $spin:expr) => {
        Level {
            run: run::<$n, $m, $h, $q>,
            rings: $n,
            steps: $steps,
            tolerance: $tolerance,
            left: $left,
            beyond: 0.0,
            floor: Floor::new($floor, $spin),
            is_usual: true,
        }
    };
}

/// From coarse to fine. The factors of the error estimates were fitted to 150 drawn impacts (the finest level to 94) against a
/// grid and hold for others (`tests/it/rings.rs` of `carom-numerical`).
pub(super) const LEVELS: [Level; 4] = [
    level!(4, 8, 5, 3; 32, 1.0 / 300.0, 1.0, [1e-2, 0.0, 0.0, 0.0], 1e-2),
    level!(8, 8, 5, 3; 64, 2e-3, 0.3, [1e-3, 1.1e-2, 1.5e-2, 4e-3], 1.3e-3),
    level!(12, 16, 9, 5; 128, 1e-3, 0.6, [2e-4, 4.4e-3, 8.6e-3, 1.2e-3], 8e-4),
    level!(24, 16, 9, 5; 256, 1e-4, 0.3, [1e-4, 3.5e-3, 3e-3, 8e-4], 3e-4).fine(),
];

/// The same for unlike bodies. Their slip turns, so that more rings matter, and their errors fall in proportion to each other.
pub(super) const UNLIKE: [Level; 4] = [
    LEVELS[0],
    LEVELS[1],
    level!(16, 16, 9, 5; 128, 2e-3, 0.5, [2e-4, 4.4e-3, 8.6e-3, 1.2e-3], 8e-4).extrapolated(0.3),
    LEVELS[3].extrapolated(0.6),
];

/// The same with a spin about the normal (`tests/it/rings.rs` of `carom-numerical`).
pub(super) const SPINNING: [Level; 4] = [
    level!(6, 8, 5, 3; 48, 2e-3, 0.0, [1e-2, 0.0, 0.0, 0.0], 1e-2),
    level!(12, 8, 5, 3; 96, 2e-3, 0.3, [1.8e-3, 4.4e-3, 8.6e-3, 1e-3], 1.5e-3),
    level!(12, 16, 9, 5; 192, 5e-4, 0.3, [1.8e-3, 4.4e-3, 8.6e-3, 1e-4], 1.5e-3),
    level!(24, 16, 9, 5; 384, 1e-4, 0.3, [1.3e-3, 1.5e-3, 3e-3, 1e-4], 8e-4).fine(),
];

/// The level for tables. With twice the steps the tangential velocity changes by 5e-4 f v_z in the mean.
pub(super) const FILLING: Level = level!(16, 16, 9, 5; 128, 5e-4, 0.0, [0.0; 4], 0.0);

/// A run at one resolution, observed at each instant.
type Run = fn(&Problem, usize, f64, &mut dyn FnMut(Sample)) -> Result<Passage, RingImpactError>;

impl Floor {
    const fn new([always, by_gamma, by_strength, by_spread]: [f64; 4], of_spin: f64) -> Self {
        Self { always, by_gamma, by_strength, by_spread, of_spin }
    }
}

impl Level {
    /// For tolerances finer than the default only.
    const fn fine(self) -> Self {
        Self { is_usual: false, ..self }
    }

    /// With what finer levels would change of the tangential velocity, over the change from the coarser level.
    const fn extrapolated(self, beyond: f64) -> Self {
        Self { beyond, ..self }
    }

    pub(super) fn passage(&self, problem: &Problem) -> Result<Passage, RingImpactError> {
        self.observed(problem, &mut |_| ())
    }

    pub(super) fn observed(
        &self,
        problem: &Problem,
        observe: &mut dyn FnMut(Sample),
    ) -> Result<Passage, RingImpactError> {
        (self.run)(problem, self.steps, self.tolerance, observe)
    }

    /// The normal velocity after the same impact without friction: what steps alone miss.
    pub(super) fn normal(&self, problem: &Problem) -> Result<f64, RingImpactError> {
        let law = ShiftLaw::<f64>::with_fixed_direction(problem.stiffness(), Friction::new(0.0)?);
        let motion = problem.motion.straight();
        let passage = ended(match problem.viscosity()? {
            None => motion.follow(law, self.steps, |_, _| ())?,
            Some(viscosity) => {
                motion.follow(problem.viscous_law(law, viscosity), self.steps, |_, _| ())?
            }
        })?;
        Ok(passage.after[0])
    }
}

/// One run with this many steps; `FINE` is the inverse of the tolerance of the law.
///
/// H is the number of angles from 0 to half a turn and Q that to a quarter, for motions in a plane.
fn run<const N: usize, const M: usize, const H: usize, const Q: usize>(
    problem: &Problem,
    steps: usize,
    tolerance: f64,
    observe: &mut dyn FnMut(Sample),
) -> Result<Passage, RingImpactError> {
    let Problem { motion, constants, friction, .. } = problem;
    let tolerance = Tolerance::new(tolerance)?;
    let turned = motion.direction();
    if motion.before[3] != 0.0 {
        let law = RingLaw::<N, M>::from_constants(*constants, *friction, tolerance)?;
        let directions = [turned, turned.ahead_by(PI / M as f64)];
        return in_two_directions((problem, &law), directions, steps, observe);
    }
    let motion = motion.along_x();
    let observe = &mut |sample: Sample| observe(turned.back(sample));
    let passage = if constants.gamma == 0.0 {
        let law = RingLaw::<N, Q, AlikePlane>::alike_in_plane(*constants, *friction, tolerance)?;
        followed((problem, &motion), law, steps, observe)
    } else {
        let law = RingLaw::<N, H, Plane>::in_plane(*constants, *friction, tolerance)?;
        followed((problem, &motion), law, steps, observe)
    };
    passage.map(|passage| Passage { after: turned.rates_back(passage.after), ..passage })
}

/// The mean of a run with its axes along the tangential velocity and one with axes half of the distance of two angles
/// ahead, for which the largest part of the error by too few angles has the other sign.
fn in_two_directions<const N: usize, const M: usize>(
    (problem, law): (&Problem, &RingLaw<N, M>),
    [first, second]: [Turned; 2],
    steps: usize,
    observe: &mut dyn FnMut(Sample),
) -> Result<Passage, RingImpactError> {
    let along = |direction: Turned, observe: &mut dyn FnMut(Sample)| {
        let motion = problem.motion.along(direction);
        let observe = &mut |sample: Sample| observe(direction.back(sample));
        let passage = followed((problem, &motion), law.clone(), steps, observe)?;
        Ok::<_, RingImpactError>((passage, direction.rates_back(passage.after)))
    };
    let (passage, one) = along(first, observe)?;
    let (_, other) = along(second, &mut |_| ())?;
    let by_direction = 0.5 * libm::hypot(one[1] - other[1], one[2] - other[2]);
    Ok(Passage {
        after: std::array::from_fn(|i| 0.5 * (one[i] + other[i])),
        by_direction,
        ..passage
    })
}

/// One motion with a law, in the material of the problem.
fn followed<const N: usize, const H: usize, S: Symmetry<H>>(
    (problem, motion): (&Problem, &Motion),
    law: RingLaw<N, H, S>,
    steps: usize,
    observe: &mut dyn FnMut(Sample),
) -> Result<Passage, RingImpactError> {
    ended(match problem.viscosity()? {
        None => motion.follow(law, steps, |at, law| observe(sample(at, law)))?,
        Some(viscosity) => {
            let law = problem.viscous_law(law, viscosity);
            motion.follow(law, steps, |at, law| observe(sample(at, law.elastic())))?
        }
    })
}

fn ended(passage: Option<Passage>) -> Result<Passage, RingImpactError> {
    passage.ok_or(RingImpactError::NoSeparation)
}

fn sample<const N: usize, const H: usize, S: Symmetry<H>>(
    instant: Instant,
    law: &RingLaw<N, H, S>,
) -> Sample {
    let Instant { time, shift: [zeta, xi, eta, _], rates: [speed, x, y, _], load } = instant;
    Sample {
        time,
        shift: Vector3::new(xi, eta, zeta),
        velocity: Vector3::new(x, y, speed),
        force: Vector3::new(load.f_x, load.f_y, load.f_z),
        stage: stage(law),
    }
}

/// The part that slipped in the last step; the last ring extends beyond the contact.
fn stage<const N: usize, const H: usize, S: Symmetry<H>>(law: &RingLaw<N, H, S>) -> Stage {
    let slipping = || law.slipping().map(|(_, share)| share);
    if slipping().all(|share| share == 0.0) {
        Stage::Adhesion
    } else if slipping().all(|share| share == 1.0) {
        Stage::Slide
    } else {
        Stage::Slip
    }
}
