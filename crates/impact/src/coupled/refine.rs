//! Refinement of an impact in steps and annuli until its outcome converges.

use carom_laws::stiffness::ContactStiffness;
use nalgebra::{Matrix3, Vector3};

use super::ImpactLaw;
use super::adams::Order;
use super::extrapolation::Extrapolation;
use super::point::Point;
use super::run::Run;
use super::trajectory::{LawFailure, MAX_STEPS_OVER_FREE_IMPACT, Trajectory};

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
/// Below this estimate, over |v_A|, round-off outweighs the error of the steps once the estimate
/// has grown this many times in succession.
const ROUND_OFF: f64 = 1e-10;
const GROWTHS_BY_ROUND_OFF: u32 = 2;

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
    /// times |v_A|. If round-off grows or further runs would take too long, the limit with the
    /// smallest estimate.
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
        let mut best: Option<Settled> = None;
        let mut growths = 0;
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
            let limit = Settled { run, error, level, problem, settled };
            if settled {
                return Ok(limit);
            }
            let least = best.filter(|best| best.error <= error).unwrap_or(limit);
            growths = if least.error < error { growths + 1 } else { 0 };
            if growths >= GROWTHS_BY_ROUND_OFF && least.error < ROUND_OFF {
                // Both limits have round-off; the larger estimate holds for either.
                return Ok(Settled { error, ..least });
            }
            if table.finest().next() > series.most {
                return Ok(least);
            }
            best = Some(least);
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
            .follow_to((order, MAX_STEPS_OVER_FREE_IMPACT), &mut law, |point, law| {
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
            strongest: peaks.strongest,
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

/// Records the maximum approach and counts the compressions.
#[derive(Debug, Default)]
struct Peaks {
    last: Option<Point>,
    highest: f64,
    strongest: f64,
    compressions: u32,
    steps: usize,
}

impl Peaks {
    fn see(&mut self, point: &Point) {
        self.steps += 1;
        self.strongest = self.strongest.max(point.force.z);
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
