//! One run of an impact: normal motion and row of springs, with so many steps in each half.

use super::pulse::{Half, Pulse, State, TOUCH};
use super::springs::{Press, Springs};

/// The middle of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Instant {
    /// Time over (m/K)^(2/5) v^(-1/5).
    pub(crate) time: f64,
    /// Approach over (m v^2/K)^(2/5).
    pub(crate) approach: f64,
    /// Speed of approach over v.
    pub(crate) speed: f64,
    /// F_z over K times that approach^(3/2).
    pub(crate) normal_force: f64,
    /// Shift over f kappa, in units of approach.
    pub(crate) shift: f64,
    /// Its rate.
    pub(crate) rate: f64,
    /// F_x over f, in units of F_z.
    pub(crate) force: f64,
    /// The share of the contact radius that sticks.
    pub(crate) sticks: f64,
}

/// What a run gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Run {
    /// Rate of the shift after the impact.
    pub(super) rate: f64,
    /// Heat of friction over f^2 kappa m v^2.
    pub(super) heat: f64,
}

/// The ends of both halves, as [`Pulse::ends`] gives them.
pub(super) type Ends = [(f64, State); 2];

impl Run {
    /// An impact with the given groups, in `steps` steps of compression and as many of rebound.
    pub(super) fn of(
        pulse: &Pulse,
        ends: &Ends,
        [chi, psi]: [f64; 2],
        steps: usize,
        mut observe: impl FnMut(Instant),
    ) -> Self {
        let mut springs = Springs::with_capacity(steps + 1);
        springs.touch(0.0);
        let mut walk = Walk { rate: psi, shift: 0.0, heat: 0.0, gain: 0.0 };
        let mut from = TOUCH;
        for (half, (length, end)) in [Half::Compression, Half::Rebound].into_iter().zip(ends) {
            let step = length / steps as f64;
            for number in 1..=steps {
                let middle = pulse.step(half, &from, 0.5 * step);
                let to = match number == steps {
                    true => *end,
                    false => pulse.step(half, &middle, 0.5 * step),
                };
                let fresh = if half == Half::Compression { pulse.tau } else { 0.0 };
                let depth = middle.edge * middle.edge + fresh * middle.speed;
                let dt = to.time - from.time;
                let press = Press { edge: middle.edge, depth, dt, tau: pulse.tau, fresh };
                if half == Half::Rebound {
                    springs.leave(middle.edge);
                }
                let normal_force = pulse.force(half, &middle);
                observe(walk.step(&mut springs, &press, chi, (&middle, normal_force)));
                if half == Half::Compression {
                    springs.touch(to.edge);
                }
                from = to;
            }
        }
        Self { rate: walk.rate, heat: walk.heat }
    }
}

/// The shift, as it goes.
#[derive(Debug, Clone, Copy)]
struct Walk {
    rate: f64,
    shift: f64,
    heat: f64,
    /// What the rate gained in the last half step.
    gain: f64,
}

impl Walk {
    fn step(
        &mut self,
        springs: &mut Springs,
        press: &Press,
        chi: f64,
        (at, normal_force): (&State, f64),
    ) -> Instant {
        let middle = springs.step(press, chi, self.rate, self.rate + self.gain);
        self.gain = middle.rate - self.rate;
        let half = 0.5 * press.dt * middle.rate;
        let instant = Instant {
            time: at.time,
            approach: at.approach,
            speed: at.speed,
            normal_force,
            shift: self.shift + half,
            rate: middle.rate,
            force: middle.force,
            sticks: middle.sticks,
        };
        self.shift += 2.0 * half;
        self.rate += 2.0 * self.gain;
        self.heat += middle.heat;
        instant
    }
}
