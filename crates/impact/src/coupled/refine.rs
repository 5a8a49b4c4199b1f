//! Refinement of an impact in steps and rings until its outcome settles.

use carom_laws::law::ContactLaw;
use nalgebra::{Matrix3, Vector3};

use super::course::{Course, Point};

/// Steps of the first runs, which find duration and greatest approach.
const SCOUT: Level = Level { steps: 32, rings: 16 };
const SCOUTS: usize = 2;
/// Steps and rings of the coarsest run; each further one has twice as many.
const COARSEST: Level = Level { steps: 32, rings: 16 };
const LEVELS: u32 = 7;

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
    /// Runs of twice as many steps and rings until their limit changes by less than the tolerance
    /// times |v_A|, or the levels end.
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
        let mut table = Extrapolation::new(problem.run(level, &make, |_, _| ())?);
        for round in 1..LEVELS {
            problem = problem.scouted(table.plain);
            level = Level { steps: 2 * level.steps, rings: 2 * level.rings };
            table.refine(problem.run(level, &make, |_, _| ())?);
            if round > 1 && table.error <= tolerance * scale {
                break;
            }
        }
        let (best, error) = (table.best(), table.error / scale);
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

/// Runs of twice as many steps and rings each, and their limit.
///
/// The error of a run falls with the square of the step. What Richardson's extrapolation leaves
/// falls with its cube while the contact's stages change smoothly, which the last three limits
/// show; then a second extrapolation counts.
#[derive(Debug)]
struct Extrapolation {
    plain: Run,
    once: Option<Run>,
    twice: Option<Run>,
    change: f64,
    error: f64,
    smooth: bool,
}

/// Ratio of successive changes that passes for 2^3.
const CUBIC: std::ops::Range<f64> = 5.0..12.0;

impl Extrapolation {
    const fn new(plain: Run) -> Self {
        let (change, error) = (f64::INFINITY, f64::INFINITY);
        Self { plain, once: None, twice: None, change, error, smooth: false }
    }

    fn refine(&mut self, run: Run) {
        let once = run.beyond(&self.plain, 3.0);
        let twice = self.once.map(|before| once.beyond(&before, 7.0));
        let moved = |now: &Run, before: Option<Run>| {
            before.map_or(f64::INFINITY, |before| (now.velocity - before.velocity).norm())
        };
        let change = moved(&once, self.once);
        self.smooth = twice.is_some() && CUBIC.contains(&(self.change / change));
        self.error = match &twice {
            Some(twice) if self.smooth => moved(twice, self.twice),
            _ => change,
        };
        *self = Self { plain: run, once: Some(once), twice, change, ..*self };
    }

    fn best(&self) -> Run {
        let smooth = self.twice.filter(|_| self.smooth);
        smooth.or(self.once).unwrap_or(self.plain)
    }
}

impl Run {
    /// Extrapolated from a run of half as many steps, whose error is this much + 1 times as large.
    fn beyond(&self, coarse: &Self, gain: f64) -> Self {
        let limit = |fine: f64, coarse: f64| fine + (fine - coarse) / gain;
        Self {
            velocity: self.velocity + (self.velocity - coarse.velocity) / gain,
            duration: limit(self.duration, coarse.duration),
            peak: limit(self.peak, coarse.peak),
            compressions: self.compressions,
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    fn run(error: f64) -> Run {
        let velocity = Vector3::new(1.0 + error, -error, -1.0 - 2.0 * error);
        Run { velocity, duration: 3.0 + error, peak: 1.0 - error, compressions: 1 }
    }

    fn after(rounds: i32, error: impl Fn(f64) -> f64) -> Extrapolation {
        let mut table = Extrapolation::new(run(error(0.1)));
        for round in 1..=rounds {
            table.refine(run(error(0.1 * 0.5_f64.powi(round))));
        }
        table
    }

    #[test]
    fn square_and_cube_of_the_step_cancel() {
        let table = after(3, |h| 0.3 * h * h - 0.2 * h * h * h);
        assert!(table.smooth && table.error < 1e-15);
        let best = table.best();
        assert!((best.velocity - Vector3::new(1.0, 0.0, -1.0)).norm() < 1e-15);
        assert!((best.duration - 3.0).abs() < 1e-15 && (best.peak - 1.0).abs() < 1e-15);
    }

    #[test]
    fn the_second_extrapolation_waits_for_smooth_errors() {
        // A remainder that jumps from run to run, as where an event falls between steps.
        let table = after(4, |h| 0.3 * h * h * (1.0 + 0.5 * (1.0 / h).sin()));
        assert!(!table.smooth);
        let best = (table.best().velocity.x - 1.0).abs();
        assert!(best <= table.error, "{best:e} {:e}", table.error);
        // Too few runs tell nothing.
        assert!(!after(1, |h| h * h).smooth && after(0, |h| h * h).error.is_infinite());
    }
}
