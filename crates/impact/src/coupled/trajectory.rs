//! The motion through one contact: dv/dt = -D F with a law that remembers (8.29).

use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::stiffness::ContactStiffness;
use nalgebra::{Matrix3, Vector3};

use super::adams::{Adams, Order};
use super::pace::Pace;
use super::schedule::Schedule;

/// The initial value problem of an impact in any consistent units, contact axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trajectory {
    /// D: dv/dt = -D F.
    pub mobility: Matrix3<f64>,
    /// Velocity of body 2 against body 1 at first touch; z > 0.
    pub velocity: Vector3<f64>,
    /// Of the law in adhesion; it chooses the steps.
    pub stiffness: ContactStiffness,
    /// About how many steps a free impact takes. Coupled ones take more where friction drives the
    /// normal motion and where the tangential one oscillates fast.
    pub steps: usize,
    /// The duration to be expected, where the impact passes much like a free one: its steps then
    /// follow the clock. None: every step is chosen from the state.
    pub expected: Option<f64>,
}

/// An instant of an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Time since touch.
    pub time: f64,
    /// Shift of body 2 against body 1 since touch: xi, eta, zeta.
    pub shift: Vector3<f64>,
    /// Its rate.
    pub velocity: Vector3<f64>,
    /// Force on body 1.
    pub force: Vector3<f64>,
    /// Its impulse since touch. It is what is added up: of a graze it would have lost its digits as a
    /// difference of velocities.
    pub impulse: Vector3<f64>,
}

/// Contact lasting longer than this many times the steps of a free impact is given up.
const PATIENCE: usize = 1 << 14;

/// How the next step is found.
#[derive(Debug, Clone, Copy)]
enum Steps {
    Timed(Schedule),
    Chosen(Pace),
}

/// A step of the law failed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("step {step} of the law, {time:e} after touch")]
pub struct LawFailure<E: std::error::Error + 'static> {
    /// Steps before it.
    pub step: usize,
    /// Time since touch.
    pub time: f64,
    /// Why.
    pub source: E,
}

impl Trajectory {
    /// Follows the impact with this law to separation and returns the instant of separation;
    /// none if the bodies do not part within 2^14 times the steps of a free impact. `observe` sees
    /// every instant, touch and separation included, with the law's state there.
    ///
    /// Steps of the Verlet kind: one evaluation of the law each, second order in the step, and
    /// the path between two instants is straight.
    ///
    /// # Errors
    /// The law's own, with the step.
    pub fn follow<L: ContactLaw>(
        &self,
        law: &mut L,
        observe: impl FnMut(&Point, &L),
    ) -> Result<Option<Point>, LawFailure<L::Error>> {
        self.follow_to(Order::Second, law, observe)
    }

    /// The same with steps of this order.
    pub(super) fn follow_to<L: ContactLaw>(
        &self,
        order: Order,
        law: &mut L,
        mut observe: impl FnMut(&Point, &L),
    ) -> Result<Option<Point>, LawFailure<L::Error>> {
        let mut now = Point {
            time: 0.0,
            shift: Vector3::zeros(),
            velocity: self.velocity,
            force: Vector3::zeros(),
            impulse: Vector3::zeros(),
        };
        observe(&now, law);
        let steps = self.steps();
        let mut recent = Adams::new(order);
        for number in 0..PATIENCE * self.steps {
            let length = match &steps {
                Steps::Timed(schedule) => schedule.step(number, &now),
                Steps::Chosen(pace) => pace.step(&now),
            };
            let failed = |source| LawFailure { step: number, time: now.time, source };
            let ahead = self.mobility * recent.ahead(length);
            let shift = now.shift + now.velocity * length - ahead;
            if shift.z <= 0.0 {
                let last = self.separation(&now, &shift, length);
                let mut apart = last.shift;
                apart.z = 0.0;
                law.advance(as_shift(&apart)).map_err(failed)?;
                observe(&last, law);
                return Ok(Some(last));
            }
            let force = as_vector(&law.advance(as_shift(&shift)).map_err(failed)?);
            let impulse = now.impulse + recent.gain(length, &force);
            let velocity = self.velocity - self.mobility * impulse;
            recent.push(length, force);
            now = Point { time: now.time + length, shift, velocity, force, impulse };
            observe(&now, law);
        }
        Ok(None)
    }

    fn steps(&self) -> Steps {
        self.expected.map_or_else(
            || {
                Steps::Chosen(Pace::new(
                    &self.mobility,
                    &self.stiffness,
                    self.velocity.z,
                    self.steps,
                ))
            },
            |duration| Steps::Timed(Schedule::new(duration, self.steps)),
        )
    }

    // The force falls to zero with the power 3/2 of the time left: its mean is 2/5.
    fn separation(&self, now: &Point, beyond: &Vector3<f64>, length: f64) -> Point {
        let part = (now.shift.z / (now.shift.z - beyond.z)).clamp(0.0, 1.0);
        let mut shift = now.shift + (beyond - now.shift) * part;
        shift.z = 0.0;
        let part = part * length;
        let impulse = now.impulse + now.force * (0.4 * part);
        let velocity = self.velocity - self.mobility * impulse;
        Point { time: now.time + part, shift, velocity, force: Vector3::zeros(), impulse }
    }
}

fn as_shift(shift: &Vector3<f64>) -> Shift {
    Shift { zeta: shift.z, xi: shift.x, eta: shift.y, omega: 0.0 }
}

fn as_vector(load: &ContactLoad) -> Vector3<f64> {
    Vector3::new(load.f_x, load.f_y, load.f_z)
}
