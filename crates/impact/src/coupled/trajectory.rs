//! The motion through one contact: dv/dt = -D F with a law with memory (8.29).

use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::stiffness::ContactStiffness;
use carom_special::interrupt;
use nalgebra::{Matrix3, Vector3};

use super::adams::{Adams, Order};
use super::jump::{Jump, LEAST_PART};
use super::pace::Pace;
use super::point::Point;
use super::schedule::Schedule;

/// The initial value problem of an impact, in any consistent units and contact axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trajectory {
    /// D: dv/dt = -D F.
    pub mobility: Matrix3<f64>,
    /// Velocity of body 2 against body 1 at first contact; z > 0.
    pub velocity: Vector3<f64>,
    /// Stiffness of the law in adhesion; it determines the steps.
    pub stiffness: ContactStiffness,
    /// Approximate number of steps of a free impact. Coupled impacts take more if friction drives
    /// the normal motion or the tangential motion oscillates fast.
    pub steps: usize,
    /// The expected duration, if the impact resembles a free one; its steps are then taken in time.
    /// `None`: every step is chosen from the state.
    pub expected: Option<f64>,
}

/// Largest number of steps of a contact, over that of a free impact.
pub(super) const MAX_STEPS_OVER_FREE_IMPACT: usize = 1 << 14;

/// Steps between two questions whether to end.
const ASKS_EVERY: usize = 256;

/// The part of a step to which the end of sliding is found: the direction of so short a path is still beyond round-off.
const LEAST_PART_OF_SLIDING: f64 = 1.0 / (1_u64 << 20) as f64;

/// How the next step is chosen.
#[derive(Debug, Clone, Copy)]
enum Steps {
    /// In time: the number of the next step, and the rest of one that ended at a jump of the force.
    Timed {
        schedule: Schedule,
        number: usize,
        rest: Option<f64>,
    },
    Chosen(Pace),
}

impl Steps {
    const fn timed(schedule: Schedule) -> Self {
        Self::Timed { schedule, number: 0, rest: None }
    }

    fn next(&mut self, now: &Point) -> f64 {
        match self {
            Self::Timed { schedule, number, rest } => rest.take().unwrap_or_else(|| {
                *number += 1;
                schedule.step(*number - 1, now)
            }),
            Self::Chosen(pace) => pace.step(now),
        }
    }

    /// A step of this length ended early. The steps in time go on with its rest, so that the errors
    /// of runs remain alike.
    fn cut(&mut self, length: f64, end: f64) {
        if let Self::Timed { rest, .. } = self {
            *rest = Some(length - end).filter(|rest| *rest > LEAST_PART * length);
        }
    }
}

/// Failure of a step of the contact law.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("step {step} of the contact law, {time:e} after first contact")]
pub struct LawFailure<E: std::error::Error + 'static> {
    /// Number of steps before it.
    pub step: usize,
    /// Time since first contact.
    pub time: f64,
    /// The error of the law.
    pub source: E,
}

impl Trajectory {
    /// Integrates the impact with this law up to separation and returns that instant. `None` if the
    /// bodies do not separate within 2^14 times the steps of a free impact.
    ///
    /// `observe` is called at every instant, including first contact and separation, with the state
    /// of the law there.
    ///
    /// The steps are of Verlet's kind: one evaluation of the law each, of second order. The path
    /// between two instants is straight. Where the load of the law jumps
    /// ([`ContactLaw::jumps`]), a step ends; that instant is observed before and after the jump. A step also ends where
    /// sliding ends, if friction then rises ([`ContactLaw::slides_on`]).
    ///
    /// # Errors
    /// The error of the law, with the number of the step.
    pub fn follow<L: ContactLaw>(
        &self,
        law: &mut L,
        observe: impl FnMut(&Point, &L),
    ) -> Result<Option<Point>, LawFailure<L::Error>> {
        self.follow_to((Order::Second, MAX_STEPS_OVER_FREE_IMPACT), law, observe)
    }

    /// The same with at most `patience` times the steps of a free impact, for laws that take long.
    ///
    /// # Errors
    /// As [`Self::follow`].
    pub fn follow_at_most<L: ContactLaw>(
        &self,
        patience: usize,
        law: &mut L,
        observe: impl FnMut(&Point, &L),
    ) -> Result<Option<Point>, LawFailure<L::Error>> {
        self.follow_to((Order::Second, patience), law, observe)
    }

    /// The same with steps of an order, and so many times those of a free impact.
    pub(super) fn follow_to<L: ContactLaw>(
        &self,
        (order, patience): (Order, usize),
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
        let mut steps = self.steps();
        let mut recent = Adams::new(order);
        for number in 0..patience * self.steps {
            if number % ASKS_EVERY == 0 && interrupt::is_wanted() {
                return Ok(None);
            }
            let length = steps.next(&now);
            let time = now.time;
            let failed = move |source| LawFailure { step: number, time, source };
            let shift = self.place(&now, &recent, length);
            let rates = self.rates(&now, length);
            let depth = law.depth(as_shift(&shift), as_shift(&rates));
            if depth <= 0.0 {
                let pressed = law.depth(as_shift(&now.shift), as_shift(&now.velocity));
                let last = self.separation(&now, &shift, length, [pressed, depth]);
                let mut separated = last.shift;
                separated.z = 0.0;
                law.advance(as_shift(&separated)).map_err(failed)?;
                observe(&last, law);
                return Ok(Some(last));
            }
            if law.jumps(as_shift(&shift)) {
                let from = now;
                let mut held = law.clone();
                now = self.at_jump(&from, &recent, length, &mut held).map_err(failed)?;
                observe(&now, &held);
                steps.cut(length, now.time - from.time);
                let (to, rates) = (as_shift(&now.shift), as_shift(&now.velocity));
                let lasted = now.time - from.time;
                now.force = as_vector(&law.advance_at(to, rates, lasted).map_err(failed)?);
                recent.restart(now.force);
                observe(&now, law);
                continue;
            }
            let slides = law.slides_on(as_shift(&now.velocity)) == Some(true);
            let held = slides.then(|| law.clone());
            let load =
                law.advance_at(as_shift(&shift), as_shift(&rates), length).map_err(failed)?;
            let force = as_vector(&load);
            let next = self.reached(&now, &recent, length, (shift, force));
            let ends = law.slides_on(as_shift(&next.velocity)) != Some(true);
            if let Some(held) = held.filter(|_| ends) {
                let from = now;
                (now, *law) =
                    self.at_end_of_sliding(&from, &recent, length, held).map_err(failed)?;
                steps.cut(length, now.time - from.time);
                recent.restart(now.force);
            } else {
                now = next;
                recent.push(length, force);
            }
            observe(&now, law);
        }
        Ok(None)
    }

    fn place(&self, now: &Point, recent: &Adams, length: f64) -> Vector3<f64> {
        let ahead = self.mobility * recent.ahead(length);
        now.shift + now.velocity * length - ahead
    }

    // The rates at the end of a step, with the force at its beginning; only a viscous law asks for them.
    fn rates(&self, now: &Point, length: f64) -> Vector3<f64> {
        now.velocity - self.mobility * now.force * length
    }

    fn reached(
        &self,
        now: &Point,
        recent: &Adams,
        length: f64,
        (shift, force): (Vector3<f64>, Vector3<f64>),
    ) -> Point {
        let impulse = now.impulse + recent.gain(length, &force);
        let velocity = self.velocity - self.mobility * impulse;
        Point { time: now.time + length, shift, velocity, force, impulse }
    }

    // The instant at which the load of the law jumps within a step, with the force before the jump.
    fn at_jump<L: ContactLaw>(
        &self,
        now: &Point,
        recent: &Adams,
        length: f64,
        law: &mut L,
    ) -> Result<Point, L::Error> {
        let place = |length: f64| self.place(now, recent, length);
        let jump = Jump::find(length, |length| law.jumps(as_shift(&place(length))));
        let [before, after] = [jump.before, jump.after].map(place);
        let rates = self.rates(now, jump.before);
        let force = as_vector(&law.advance_at(as_shift(&before), as_shift(&rates), jump.before)?);
        Ok(self.reached(now, recent, jump.after, (after, force)))
    }

    // The instant within a step from which the contact no longer slides, and the law there. The law decides by the
    // direction of a straight step where it begins, which is that of the velocity there only if the step is short: half
    // of what is left of the step is taken as long as the contact slides at its end.
    fn at_end_of_sliding<L: ContactLaw>(
        &self,
        now: &Point,
        recent: &Adams,
        length: f64,
        law: L,
    ) -> Result<(Point, L), L::Error> {
        let (mut now, mut recent, mut law, mut rest) = (*now, *recent, law, length);
        while rest > LEAST_PART_OF_SLIDING * length {
            rest *= 0.5;
            let (next, held) = self.tried(&now, &recent, rest, &law)?;
            if held.slides_on(as_shift(&next.velocity)) == Some(true) {
                recent.restart(next.force);
                (now, law) = (next, held);
            }
        }
        self.tried(&now, &recent, rest, &law)
    }

    // A step of this length from a copy of the law.
    fn tried<L: ContactLaw>(
        &self,
        now: &Point,
        recent: &Adams,
        length: f64,
        law: &L,
    ) -> Result<(Point, L), L::Error> {
        let (mut law, shift) = (law.clone(), self.place(now, recent, length));
        let rates = self.rates(now, length);
        let force = as_vector(&law.advance_at(as_shift(&shift), as_shift(&rates), length)?);
        Ok((self.reached(now, recent, length, (shift, force)), law))
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
            |duration| Steps::timed(Schedule::new(duration, self.steps)),
        )
    }

    // The force vanishes as the power 3/2 of the remaining time: its mean is 2/5. An elastic contact ends where its
    // approach does, a viscous one before.
    fn separation(
        &self,
        now: &Point,
        extrapolated: &Vector3<f64>,
        length: f64,
        [pressed, depth]: [f64; 2],
    ) -> Point {
        let part = (pressed / (pressed - depth)).clamp(0.0, 1.0);
        let mut shift = now.shift + (extrapolated - now.shift) * part;
        if depth == extrapolated.z {
            shift.z = 0.0;
        }
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
