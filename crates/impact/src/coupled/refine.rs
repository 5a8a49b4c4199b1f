//! Refinement of an impact in steps and rings until its outcome settles.

use carom_laws::stiffness::ContactStiffness;
use nalgebra::{Matrix3, Vector3};

use super::ImpactLaw;
use super::adams::Order;
use super::extrapolation::Extrapolation;
use super::trajectory::{LawFailure, Point, Trajectory};

/// Finds duration and number of steps; fine enough that the fastest oscillation stays stable.
const SCOUT: Level = Level { steps: 32, rings: 16, taken: 32 };
const FIRST: Level = Level { steps: 64, rings: 32, taken: 64 };
/// Runs by the clock, and those that choose their steps.
const TIMED_SCOUT: Level = Level { steps: 16, rings: 8, taken: 16 };
const TIMED: Series = Series { first: SCOUT, most: 1 << 22 };
const CHOSEN: Series = Series { first: FIRST, most: 1 << 26 };
/// The first level at which an outcome may count.
const LEAST: usize = 64;

/// How many rings may be moved where a law without rings may take one step.
const RINGED: usize = 2;

/// What the last change of the outcome counts for where a law has rings: which of them slip jumps
/// from run to run, and so the errors do. Of 60 random impacts two were off by up to three times a
/// tolerance of 1e-5 or 1e-6 where it counted once, none where it counts twice.
const DOUBT: f64 = 2.0;

/// Runs that double steps and rings, while the next one takes no more than so many steps.
#[derive(Debug, Clone, Copy)]
struct Series {
    first: Level,
    most: usize,
}

/// The initial value problem.
#[derive(Debug, Clone, Copy)]
pub(super) struct Problem {
    pub(super) mobility: Matrix3<f64>,
    pub(super) velocity: Vector3<f64>,
    pub(super) stiffness: ContactStiffness,
    /// A first guess of the duration, where steps by the clock may do.
    pub(super) expected: Option<f64>,
}

/// How fine a run is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Level {
    /// Steps of a free impact.
    pub(super) steps: usize,
    pub(super) rings: usize,
    /// Steps that it will take, about.
    pub(super) taken: usize,
}

/// What one run, or the limit of finer runs, gives.
#[derive(Debug, Clone, Copy)]
pub(super) struct Run {
    pub(super) velocity: Vector3<f64>,
    pub(super) impulse: Vector3<f64>,
    pub(super) duration: f64,
    pub(super) peak: f64,
    pub(super) compressions: u32,
    pub(super) steps: usize,
    /// The most rings of the law, if it has rings.
    pub(super) rings: Option<usize>,
    /// Rings of all steps together, or steps of a law without.
    pub(super) work: usize,
}

/// Where the runs lead, how far it may be off over |v_A|, and the finest level used.
#[derive(Debug, Clone, Copy)]
pub(super) struct Settled {
    pub(super) run: Run,
    pub(super) error: f64,
    pub(super) level: Level,
    /// As the finest run saw it.
    problem: Problem,
    /// To the tolerance asked for.
    pub(super) settled: bool,
}

/// Why the runs gave nothing.
#[derive(Debug)]
pub(super) enum Failure<E: std::error::Error + 'static> {
    Law(LawFailure<E>),
    NoSeparation,
}

impl Problem {
    /// Runs of twice as many steps and rings until their limit is sure to the tolerance times
    /// |v_A|, or further ones would take too long: then the best.
    ///
    /// `make` gives a fresh law as fine as that; `hold` moves the impulse of a limit to where it
    /// may be.
    pub(super) fn settle<L: ImpactLaw>(
        &self,
        tolerance: f64,
        make: impl Fn(Level) -> L,
        hold: impl Fn(&Vector3<f64>) -> Vector3<f64>,
    ) -> Result<Settled, Failure<L::Error>> {
        if let Some(settled) = self.timed(tolerance, &make, &hold)? {
            return Ok(settled);
        }
        let problem = Self { expected: None, ..*self };
        let scout = problem.run(SCOUT, &make, |_, _| ())?;
        let longer = FIRST.steps / SCOUT.steps;
        let first = Level { taken: longer * scout.steps, ..FIRST };
        problem.refined(&Series { first, ..CHOSEN }, tolerance, &make, &hold)
    }

    // The cheapest way, where it may do and does.
    fn timed<L: ImpactLaw>(
        &self,
        tolerance: f64,
        make: &impl Fn(Level) -> L,
        hold: &impl Fn(&Vector3<f64>) -> Vector3<f64>,
    ) -> Result<Option<Settled>, Failure<L::Error>> {
        if self.expected.is_none() {
            return Ok(None);
        }
        let refined = || {
            let mut problem = *self;
            for _ in 0..2 {
                problem = problem.scouted(&problem.run(TIMED_SCOUT, make, |_, _| ())?);
            }
            problem.refined(&TIMED, tolerance, make, hold)
        };
        match refined() {
            Ok(settled) => Ok(settled.settled.then_some(settled)),
            Err(Failure::NoSeparation) => Ok(None),
            Err(failure) => Err(failure),
        }
    }

    fn refined<L: ImpactLaw>(
        &self,
        series: &Series,
        tolerance: f64,
        make: &impl Fn(Level) -> L,
        hold: &impl Fn(&Vector3<f64>) -> Vector3<f64>,
    ) -> Result<Settled, Failure<L::Error>> {
        let scale = self.velocity.norm();
        let mut problem = *self;
        let mut level = series.first;
        let mut table = Extrapolation::new(problem.run(level, make, |_, _| ())?);
        loop {
            problem = problem.scouted(table.finest());
            level = level.doubled();
            table.refine(problem.run(level, make, |_, _| ())?);
            let mut run = table.best();
            let held = hold(&run.impulse);
            let off = run.doubt() * table.error();
            let moved = self.mobility * (run.impulse - held);
            let error = off.max(moved.norm()) / scale;
            (run.impulse, run.velocity) = (held, run.velocity + moved);
            let settled = error <= tolerance && run.velocity.z < 0.0 && level.steps >= LEAST;
            if settled || table.finest().next() > series.most {
                return Ok(Settled { run, error, level, problem, settled });
            }
        }
    }

    /// The finest run again, with what it led to as a guess, seen by `observe`.
    pub(super) fn replay<L: ImpactLaw>(
        settled: &Settled,
        make: impl Fn(Level) -> L,
        observe: impl FnMut(&Point, &L),
    ) -> Result<Run, Failure<L::Error>> {
        settled.problem.scouted(&settled.run).run(settled.level, &make, observe)
    }

    fn scouted(&self, run: &Run) -> Self {
        let expected = self.expected.map(|_| run.duration);
        Self { expected, ..*self }
    }

    fn run<L: ImpactLaw>(
        &self,
        level: Level,
        make: &impl Fn(Level) -> L,
        mut observe: impl FnMut(&Point, &L),
    ) -> Result<Run, Failure<L::Error>> {
        let mut law = make(level);
        let mut peaks = Peaks::default();
        let mut rings = law.rings();
        let mut work: usize = 0;
        let trajectory = Trajectory {
            mobility: self.mobility,
            velocity: self.velocity,
            stiffness: self.stiffness,
            steps: level.steps,
            expected: self.expected,
        };
        // The errors of steps by the clock are smooth enough to be extrapolated.
        let order = self.expected.map_or(Order::Fourth, |_| Order::Second);
        let end = trajectory
            .follow_to(order, &mut law, |point, law| {
                peaks.see(point);
                let moved = law.rings();
                rings = rings.max(moved);
                work = work.saturating_add(moved.map_or(1, |count| count.max(1)));
                observe(point, law);
            })
            .map_err(Failure::Law)?
            .ok_or(Failure::NoSeparation)?;
        Ok(Run {
            velocity: end.velocity,
            impulse: end.impulse,
            duration: end.time,
            peak: peaks.highest,
            compressions: peaks.compressions,
            steps: peaks.steps,
            rings,
            work,
        })
    }
}

impl Level {
    const fn doubled(self) -> Self {
        Self { steps: 2 * self.steps, rings: 2 * self.rings, taken: 2 * self.taken }
    }
}

impl Run {
    // The work of a run of twice as many steps, and of twice as many rings if there are, in steps of a
    // law without.
    fn next(&self) -> usize {
        self.rings.map_or(2 * self.work, |_| self.work.saturating_mul(4) / RINGED)
    }

    // What a change counts for.
    fn doubt(&self) -> f64 {
        self.rings.map_or(1.0, |_| DOUBT)
    }

    /// Extrapolated from a run of half as many steps, whose error is this much + 1 times as large.
    pub(super) fn beyond(&self, coarse: &Self, gain: f64) -> Self {
        let limit = |fine: f64, coarse: f64| fine + (fine - coarse) / gain;
        let limits = |fine: Vector3<f64>, coarse: Vector3<f64>| fine + (fine - coarse) / gain;
        Self {
            velocity: limits(self.velocity, coarse.velocity),
            impulse: limits(self.impulse, coarse.impulse),
            duration: limit(self.duration, coarse.duration),
            peak: limit(self.peak, coarse.peak),
            compressions: self.compressions,
            steps: self.steps,
            rings: self.rings,
            work: self.work,
        }
    }
}

/// Keeps the greatest approach and counts the compressions.
#[derive(Debug, Default)]
struct Peaks {
    last: Option<Point>,
    highest: f64,
    compressions: u32,
    steps: usize,
}

impl Peaks {
    fn see(&mut self, point: &Point) {
        self.steps += 1;
        let before = self.last.replace(*point);
        let Some(last) = before else {
            self.compressions = 1;
            return;
        };
        if last.velocity.z > 0.0 && point.velocity.z <= 0.0 {
            self.highest = self.highest.max(summit(&last, point));
        } else if last.velocity.z <= 0.0 && point.velocity.z > 0.0 {
            self.compressions += 1;
        }
    }
}

// The greatest approach between two instants, by the cubic of both approaches and their rates.
fn summit(from: &Point, to: &Point) -> f64 {
    let h = to.time - from.time;
    let (rise, up, down) = (to.shift.z - from.shift.z, h * from.velocity.z, h * to.velocity.z);
    let (square, cube) = (3.0 * rise - 2.0 * up - down, up + down - 2.0 * rise);
    // up + 2 square u + 3 cube u^2 = 0.
    let root = (square * square - 3.0 * cube * up).max(0.0).sqrt();
    let u = (up / (root - square)).clamp(0.0, 1.0);
    from.shift.z + u * (up + u * (square + u * cube))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal;
    use carom_laws::friction::Friction;
    use carom_laws::shift_law::ShiftLaw;

    // In a plane, in units of the free impact.
    fn planar(tangential: f64, coupling: f64, slip: f64) -> Problem {
        Problem {
            mobility: 1.25
                * Matrix3::new(tangential, 0.0, coupling, 0.0, 1.0, 0.0, coupling, 0.0, 1.0),
            velocity: Vector3::new(slip, 0.0, 1.0),
            stiffness: ContactStiffness { c_x: 1.2, c_y: 1.2, c_z: 1.5 },
            expected: Some(normal::DURATION),
        }
    }

    #[test]
    fn steps_by_the_clock_and_by_the_state_agree() {
        let friction = Friction::new(0.4).expect("positive");
        for tangential in [1.0, 3.5, 9.0] {
            for coupling in [-0.5, 0.2, 0.9] {
                for slip in [-2.0, -0.1, 0.6, 5.0] {
                    let problem = planar(tangential, coupling, slip);
                    let settle = |problem: Problem| {
                        let make = |_| ShiftLaw::<f64>::new(problem.stiffness, friction);
                        problem.settle(1e-8, make, |impulse| *impulse).expect("separates")
                    };
                    let clock = settle(problem);
                    let state = settle(Problem { expected: None, ..problem });
                    assert!(clock.settled && state.settled);
                    let apart = (clock.run.velocity - state.run.velocity).norm();
                    let scale = problem.velocity.norm();
                    assert!(apart <= 1e-7 * scale, "{tangential} {coupling} {slip}: {apart:e}");
                    assert!((clock.run.duration - state.run.duration).abs() < 1e-6);
                    assert!((clock.run.peak - state.run.peak).abs() < 1e-6);
                }
            }
        }
    }
}
