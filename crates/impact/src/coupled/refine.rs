//! Refinement of an impact in steps and annuli until its outcome converges.

use carom_laws::stiffness::ContactStiffness;
use nalgebra::{Matrix3, Vector3};

use super::ImpactLaw;
use super::adams::Order;
use super::extrapolation::Extrapolation;
use super::trajectory::{LawFailure, Point, Trajectory};

/// The pilot run finds the duration and the number of steps. It is fine enough for the fastest
/// oscillation to be stable.
const PILOT: Level = Level { steps: 32, rings: 16, taken: 32 };
const FIRST: Level = Level { steps: 64, rings: 32, taken: 64 };
/// Runs with steps in time, and runs with steps chosen from the state.
const TIMED_PILOT: Level = Level { steps: 16, rings: 8, taken: 16 };
const TIMED: Series = Series { first: PILOT, most: 1 << 22 };
const FROM_STATE: Series = Series { first: FIRST, most: 1 << 26 };
/// Smallest number of steps of a free impact at which an outcome may count as converged.
const MIN_STEPS_TO_CONVERGE: usize = 64;

/// Number of annuli that may be updated at the cost of one step of a law without annuli.
const ANNULI_PER_STEP: usize = 2;

/// Factor of the last change of the outcome for a law with annuli. Which annuli slip changes
/// abruptly between runs, and so do the errors. Of 60 random impacts, two had errors of up to three
/// times a tolerance of 1e-5 or 1e-6 with the factor 1, none with 2.
const ERROR_FACTOR_OF_ANNULI: f64 = 2.0;

/// Runs with doubled numbers of steps and annuli, as long as the next one takes at most `most`
/// steps.
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
    /// Estimated duration, if steps in time are suitable.
    pub(super) expected: Option<f64>,
}

/// The resolution of a run.
#[derive(Debug, Clone, Copy)]
pub(super) struct Level {
    /// Steps of a free impact.
    pub(super) steps: usize,
    pub(super) rings: usize,
    /// Estimated number of steps that it will take.
    pub(super) taken: usize,
}

/// Result of one run, or the limit of several.
#[derive(Debug, Clone, Copy)]
pub(super) struct Run {
    pub(super) velocity: Vector3<f64>,
    pub(super) impulse: Vector3<f64>,
    pub(super) duration: f64,
    pub(super) peak: f64,
    pub(super) compressions: u32,
    pub(super) steps: usize,
    /// The largest number of annuli of the law, if it has annuli.
    pub(super) rings: Option<usize>,
    /// Cost: annuli of all steps together, or steps of a law without annuli.
    pub(super) work: usize,
}

/// The limit of the runs, its estimated error over |v_A|, and the finest level.
#[derive(Debug, Clone, Copy)]
pub(super) struct Settled {
    pub(super) run: Run,
    pub(super) error: f64,
    pub(super) level: Level,
    /// The problem as solved by the finest run.
    problem: Problem,
    /// Whether it converged to the requested tolerance.
    pub(super) settled: bool,
}

/// Why the runs gave no result.
#[derive(Debug)]
pub(super) enum Failure<E: std::error::Error + 'static> {
    Law(LawFailure<E>),
    NoSeparation,
}

impl Problem {
    /// Runs with doubled numbers of steps and annuli until the limit has converged to the tolerance
    /// times |v_A|, or further runs would take too long; then the best one.
    ///
    /// `make` returns a fresh law for a level. `restrict` brings the impulse of a limit within its
    /// bounds.
    pub(super) fn settle<L: ImpactLaw>(
        &self,
        tolerance: f64,
        make: impl Fn(Level) -> L,
        restrict: impl Fn(&Vector3<f64>) -> Vector3<f64>,
    ) -> Result<Settled, Failure<L::Error>> {
        if let Some(settled) = self.timed(tolerance, &make, &restrict)? {
            return Ok(settled);
        }
        let problem = Self { expected: None, ..*self };
        let pilot = problem.run(PILOT, &make, |_, _| ())?;
        let longer = FIRST.steps / PILOT.steps;
        let first = Level { taken: longer * pilot.steps, ..FIRST };
        problem.refined(&Series { first, ..FROM_STATE }, tolerance, &make, &restrict)
    }

    // The cheapest method, where it is suitable and converges.
    fn timed<L: ImpactLaw>(
        &self,
        tolerance: f64,
        make: &impl Fn(Level) -> L,
        restrict: &impl Fn(&Vector3<f64>) -> Vector3<f64>,
    ) -> Result<Option<Settled>, Failure<L::Error>> {
        if self.expected.is_none() {
            return Ok(None);
        }
        let refined = || {
            let mut problem = *self;
            for _ in 0..2 {
                problem = problem.with_duration_of(&problem.run(TIMED_PILOT, make, |_, _| ())?);
            }
            problem.refined(&TIMED, tolerance, make, restrict)
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
        restrict: &impl Fn(&Vector3<f64>) -> Vector3<f64>,
    ) -> Result<Settled, Failure<L::Error>> {
        let scale = self.velocity.norm();
        let mut problem = *self;
        let mut level = series.first;
        let mut table = Extrapolation::new(problem.run(level, make, |_, _| ())?);
        loop {
            problem = problem.with_duration_of(table.finest());
            level = level.doubled();
            table.refine(problem.run(level, make, |_, _| ())?);
            let mut run = table.best();
            let restricted = restrict(&run.impulse);
            let estimate = run.error_factor() * table.error();
            let moved = self.mobility * (run.impulse - restricted);
            let error = estimate.max(moved.norm()) / scale;
            (run.impulse, run.velocity) = (restricted, run.velocity + moved);
            let settled =
                error <= tolerance && run.velocity.z < 0.0 && level.steps >= MIN_STEPS_TO_CONVERGE;
            if settled || table.finest().next() > series.most {
                return Ok(Settled { run, error, level, problem, settled });
            }
        }
    }

    /// Repeats the finest run with the converged duration as estimate; `observe` sees every
    /// instant.
    pub(super) fn replay<L: ImpactLaw>(
        settled: &Settled,
        make: impl Fn(Level) -> L,
        observe: impl FnMut(&Point, &L),
    ) -> Result<Run, Failure<L::Error>> {
        settled.problem.with_duration_of(&settled.run).run(settled.level, &make, observe)
    }

    fn with_duration_of(&self, run: &Run) -> Self {
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
        // The errors of steps in time are smooth enough for extrapolation.
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
    // The cost of a run with twice as many steps, and twice as many annuli if there are any, in
    // steps of a law without annuli.
    fn next(&self) -> usize {
        self.rings.map_or(2 * self.work, |_| self.work.saturating_mul(4) / ANNULI_PER_STEP)
    }

    // The factor of a change in the error estimate.
    fn error_factor(&self) -> f64 {
        self.rings.map_or(1.0, |_| ERROR_FACTOR_OF_ANNULI)
    }

    /// Richardson extrapolation with a run of half as many steps, whose error is `gain + 1` times
    /// as large.
    pub(super) fn extrapolated(&self, coarse: &Self, gain: f64) -> Self {
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

/// Records the maximum approach and counts the compressions.
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
            self.highest = self.highest.max(max_approach_between(&last, point));
        } else if last.velocity.z <= 0.0 && point.velocity.z > 0.0 {
            self.compressions += 1;
        }
    }
}

// The maximum approach between two instants, by the cubic of both approaches and their rates.
fn max_approach_between(from: &Point, to: &Point) -> f64 {
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

    // A planar impact in units of the free impact.
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
