//! Refinement of an impact in steps and rings until its outcome settles.

use carom_laws::law::ContactLaw;
use nalgebra::{Matrix3, Vector3};

use super::course::{Course, Point};

/// Steps of the first runs, which find duration and greatest approach.
const SCOUT: Level = Level { steps: 32, rings: 16 };
const SCOUTS: usize = 2;
/// Steps and rings of the coarsest run that counts; each further one has twice as many.
const COARSEST: Level = Level { steps: 64, rings: 32 };
const LEVELS: u32 = 6;

/// The initial value problem and first guesses of what it leads to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Problem {
    pub(super) mobility: Matrix3<f64>,
    pub(super) velocity: Vector3<f64>,
    pub(super) duration: f64,
    pub(super) peak: f64,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Level {
    steps: usize,
    rings: usize,
}

/// What one run, or the limit of finer runs, gives.
#[derive(Debug, Clone, Copy)]
pub(super) struct Run {
    pub(super) velocity: Vector3<f64>,
    pub(super) duration: f64,
    pub(super) peak: f64,
    pub(super) compressions: u32,
}

/// The settled run, how far it may be off, and the finest level used.
#[derive(Debug, Clone, Copy)]
pub(super) struct Settled {
    pub(super) run: Run,
    pub(super) error: f64,
    pub(super) level: Level,
}

/// Why the runs gave nothing.
#[derive(Debug)]
pub(super) enum Failure<E> {
    Law(E),
    NoSeparation,
}

impl Problem {
    /// Runs of twice as many steps and rings until Richardson's extrapolation (both errors fall
    /// with the square) changes by less than the tolerance times |v_A|, or the levels end.
    ///
    /// `make` gives a fresh law whose rings reach up to the approach given.
    pub(super) fn settle<L: ContactLaw>(
        &self,
        tolerance: f64,
        make: impl Fn(f64, usize) -> L,
    ) -> Result<Settled, Failure<L::Error>> {
        let mut problem = *self;
        for _ in 0..SCOUTS {
            problem = problem.scouted(problem.run(SCOUT, &make, |_, _| ())?);
        }
        let scale = self.velocity.norm();
        let mut level = COARSEST;
        let mut before = problem.run(level, &make, |_, _| ())?;
        let mut best = before;
        let mut error = f64::INFINITY;
        for round in 1..LEVELS {
            problem = problem.scouted(before);
            level = Level { steps: 2 * level.steps, rings: 2 * level.rings };
            let now = problem.run(level, &make, |_, _| ())?;
            let limit = extrapolated(&before, &now);
            error = (limit.velocity - best.velocity).norm() / scale;
            (before, best) = (now, limit);
            if round > 1 && error <= tolerance {
                break;
            }
        }
        Ok(Settled { run: best, error, level })
    }

    /// One run with the duration and the peak of another as guesses, seen by `observe`.
    pub(super) fn replay<L: ContactLaw>(
        &self,
        settled: &Settled,
        make: impl Fn(f64, usize) -> L,
        observe: impl FnMut(&Point, &L),
    ) -> Result<Run, Failure<L::Error>> {
        self.scouted(settled.run).run(settled.level, &make, observe)
    }

    fn scouted(&self, run: Run) -> Self {
        Self { duration: run.duration, peak: run.peak, ..*self }
    }

    fn run<L: ContactLaw>(
        &self,
        level: Level,
        make: &impl Fn(f64, usize) -> L,
        mut observe: impl FnMut(&Point, &L),
    ) -> Result<Run, Failure<L::Error>> {
        let mut law = make(self.peak, level.rings);
        let mut peaks = Peaks::default();
        let course = Course {
            mobility: self.mobility,
            velocity: self.velocity,
            duration: self.duration,
            steps: level.steps,
        };
        let end = course
            .follow(&mut law, |point, law| {
                peaks.see(point);
                observe(point, law);
            })
            .map_err(Failure::Law)?
            .ok_or(Failure::NoSeparation)?;
        Ok(Run {
            velocity: end.velocity,
            duration: end.time,
            peak: peaks.highest,
            compressions: peaks.compressions,
        })
    }
}

fn extrapolated(coarse: &Run, fine: &Run) -> Run {
    let limit = |fine: f64, coarse: f64| fine + (fine - coarse) / 3.0;
    Run {
        velocity: fine.velocity + (fine.velocity - coarse.velocity) / 3.0,
        duration: limit(fine.duration, coarse.duration),
        peak: limit(fine.peak, coarse.peak),
        compressions: fine.compressions,
    }
}

/// Keeps the greatest approach and counts the compressions.
#[derive(Debug, Default)]
struct Peaks {
    last: Option<Point>,
    highest: f64,
    compressions: u32,
}

impl Peaks {
    fn see(&mut self, point: &Point) {
        let before = self.last.replace(*point);
        let Some(last) = before else {
            self.compressions = 1;
            return;
        };
        if last.velocity.z > 0.0 && point.velocity.z <= 0.0 {
            // The velocity is linear between two instants.
            let part = last.velocity.z / (last.velocity.z - point.velocity.z);
            let rise = 0.5 * last.velocity.z * part * (point.time - last.time);
            self.highest = self.highest.max(last.shift.z + rise);
        } else if last.velocity.z <= 0.0 && point.velocity.z > 0.0 {
            self.compressions += 1;
        }
    }
}
