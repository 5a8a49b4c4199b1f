//! The motion through one contact: dv/dt = -D F with a law that remembers (8.29).

use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use nalgebra::{Matrix3, Vector3};

/// The initial value problem of an impact in any consistent units, contact axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Course {
    /// D: dv/dt = -D F.
    pub mobility: Matrix3<f64>,
    /// Velocity of body 2 against body 1 at first touch; z > 0.
    pub velocity: Vector3<f64>,
    /// The expected duration: steps are fine at both of its ends, where the force begins and
    /// ends with the power 3/2 of time.
    pub duration: f64,
    /// Steps within it.
    pub steps: usize,
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
}

/// Contact lasting longer than this many expected durations is given up.
const PATIENCE: usize = 200;

impl Course {
    /// Follows the impact with this law to separation and returns the instant of separation;
    /// none if the bodies do not part within 200 expected durations. `observe` sees every
    /// instant, touch and separation included, with the law's state there.
    ///
    /// Steps of the Verlet kind: one evaluation of the law each, second order in the step, and
    /// the path between two instants is straight.
    ///
    /// # Errors
    /// The law's own.
    pub fn follow<L: ContactLaw>(
        &self,
        law: &mut L,
        mut observe: impl FnMut(&Point, &L),
    ) -> Result<Option<Point>, L::Error> {
        let mut now = Point {
            time: 0.0,
            shift: Vector3::zeros(),
            velocity: self.velocity,
            force: Vector3::zeros(),
        };
        observe(&now, law);
        for step in 0..PATIENCE * self.steps {
            let length = self.step_length(step, &now);
            let half = now.velocity - self.mobility * now.force * (0.5 * length);
            let shift = now.shift + half * length;
            if shift.z <= 0.0 {
                let last = self.separation(&now, &half, length);
                let mut apart = last.shift;
                apart.z = 0.0;
                law.advance(as_shift(&apart))?;
                observe(&last, law);
                return Ok(Some(last));
            }
            let force = as_vector(&law.advance(as_shift(&shift))?);
            let velocity = half - self.mobility * force * (0.5 * length);
            now = Point { time: now.time + length, shift, velocity, force };
            observe(&now, law);
        }
        Ok(None)
    }

    // t = T u^2 (3 - 2 u) within the expected duration; then as far as separation seems to be,
    // or a mean step if the bodies still approach.
    fn step_length(&self, step: usize, now: &Point) -> f64 {
        let mean = self.duration / self.steps as f64;
        if step < self.steps {
            let at = |i: usize| {
                let u = i as f64 / self.steps as f64;
                u * u * (3.0 - 2.0 * u)
            };
            return self.duration * (at(step + 1) - at(step));
        }
        let outward = -now.velocity.z;
        if outward > 0.0 { (now.shift.z / outward * (1.0 + 1e-9)).min(mean) } else { mean }
    }

    // The force falls to zero with the power 3/2 of the time left: its mean is 2/5.
    fn separation(&self, now: &Point, half: &Vector3<f64>, length: f64) -> Point {
        let part = (now.shift.z / (-half.z * length)).clamp(0.0, 1.0) * length;
        let mut shift = now.shift + half * part;
        shift.z = 0.0;
        let velocity = now.velocity - self.mobility * now.force * (0.4 * part);
        Point { time: now.time + part, shift, velocity, force: Vector3::zeros() }
    }
}

fn as_shift(shift: &Vector3<f64>) -> Shift {
    Shift { zeta: shift.z, xi: shift.x, eta: shift.y, omega: 0.0 }
}

fn as_vector(load: &ContactLoad) -> Vector3<f64> {
    Vector3::new(load.f_x, load.f_y, load.f_z)
}
