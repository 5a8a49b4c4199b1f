//! Integration steps of second or fourth order, from the forces at the last instants.

use nalgebra::Vector3;

/// Order of the integration where the force is smooth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    /// Verlet's method: uses the last force only, so that a jump of the force affects only the step
    /// in which it occurs.
    Second,
    /// Adams's method.
    Fourth,
}

/// The last forces and the steps between them, for unit mass: impulse and velocity are the same.
///
/// At fourth order, a polynomial through the last three forces gives the next position. The law
/// gives the force there, and the polynomial through all four gives the impulse (Adams; Stoermer).
/// There is one evaluation of the law per step, and no step is repeated. If the force oscillates,
/// the error of the phase is about 0.04, and the loss of amplitude about 0.6, times the fourth
/// power of the angle per step, for angles up to 0.8. Steps that are too coarse damp the motion and
/// do not gain energy.
#[derive(Debug, Clone, Copy)]
pub(super) struct Adams {
    order: Order,
    last: [Vector3<f64>; 3],
    steps: [f64; 2],
    known: usize,
}

impl Adams {
    /// The state before the first step, without forces.
    pub(super) fn new(order: Order) -> Self {
        Self { order, last: [Vector3::zeros(); 3], steps: [0.0; 2], known: 0 }
    }

    /// Displacement in a step of this length, beyond v h.
    pub(super) fn ahead(&self, h: f64) -> Vector3<f64> {
        let (first, second) = self.differences();
        let cube = h * h * h;
        self.last[0] * (0.5 * h * h)
            + first * (cube / 6.0)
            + second * (cube * (h / 12.0 + self.steps[0] / 6.0))
    }

    /// The impulse of a step with this force at its end.
    pub(super) fn gain(&self, h: f64, next: &Vector3<f64>) -> Vector3<f64> {
        let mut gain = (self.last[0] + next) * (0.5 * h);
        if self.known == 0 {
            return gain;
        }
        let (first, second) = self.differences();
        let near = ((next - self.last[0]) / h - first) / (h + self.steps[0]);
        let cube = h * h * h;
        gain -= near * (cube / 6.0);
        if self.known > 1 {
            let third = (near - second) / (h + self.steps[0] + self.steps[1]);
            gain -= third * (cube * (h / 12.0 + self.steps[0] / 6.0));
        }
        gain
    }

    /// Adds the force at the end of a step.
    pub(super) fn push(&mut self, h: f64, next: Vector3<f64>) {
        self.last = [next, self.last[0], self.last[1]];
        self.steps = [h, self.steps[0]];
        if self.order == Order::Fourth {
            self.known = (self.known + 1).min(2);
        }
    }

    /// Goes on with this force after a jump; those before it are forgotten.
    pub(super) fn restart(&mut self, force: Vector3<f64>) {
        self.last[0] = force;
        self.known = 0;
    }

    // Divided differences; zero while too few forces are known.
    fn differences(&self) -> (Vector3<f64>, Vector3<f64>) {
        let ([now, before, earlier], [step, earlier_step]) = (self.last, self.steps);
        if self.known == 0 {
            return (Vector3::zeros(), Vector3::zeros());
        }
        let first = (now - before) / step;
        if self.known == 1 {
            return (first, Vector3::zeros());
        }
        let second = (first - (before - earlier) / earlier_step) / (step + earlier_step);
        (first, second)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // Steps of changing lengths under a given acceleration.
    fn followed(acceleration: impl Fn(f64) -> f64) -> (f64, f64, f64) {
        let along = |t: f64| Vector3::new(acceleration(t), 0.0, 0.0);
        let last = [along(0.3), along(0.25), along(0.15)];
        let mut steps = Adams { order: Order::Fourth, last, steps: [0.05, 0.1], known: 2 };
        let (mut t, mut x, mut v) = (0.3, 0.0, 0.0);
        for h in [0.1, 0.07, 0.2, 0.11] {
            x += v * h + steps.ahead(h).x;
            t += h;
            v += steps.gain(h, &along(t)).x;
            steps.push(h, along(t));
        }
        (t, x, v)
    }

    #[test]
    fn polynomials_are_exact() {
        // Accelerations of second order carry exactly, those of third order change the velocity so.
        let (t, x, v) = followed(|t| 1.0 - 2.0 * t + 3.0 * t * t);
        let at = |t: f64| t - t * t + t * t * t;
        let place = |t: f64| 0.5 * t * t - t * t * t / 3.0 + 0.25 * t * t * t * t;
        assert!((v - (at(t) - at(0.3))).abs() < 1e-15, "{v}");
        let exact = place(t) - place(0.3) - at(0.3) * (t - 0.3);
        assert!((x - exact).abs() < 1e-15, "{x} {exact}");
        let (t, _, v) = followed(|t| t * t * t);
        assert!((v - 0.25 * (t.powi(4) - 0.3_f64.powi(4))).abs() < 1e-15);
    }

    #[test]
    fn an_oscillation_keeps_its_phase_to_fourth_order() {
        let phase = |steps: usize| {
            let h = 20.0 / steps as f64;
            let back = |t: f64| Vector3::new(-libm::cos(t), 0.0, 0.0);
            let last = [back(0.0), back(h), back(2.0 * h)];
            let mut adams = Adams { order: Order::Fourth, last, steps: [h, h], known: 2 };
            let (mut x, mut v) = (1.0, 0.0);
            for _ in 0..steps {
                x += v * h + adams.ahead(h).x;
                let next = Vector3::new(-x, 0.0, 0.0);
                v += adams.gain(h, &next).x;
                adams.push(h, next);
            }
            libm::hypot(x - libm::cos(20.0), v + libm::sin(20.0))
        };
        let (coarse, fine) = (phase(200), phase(400));
        assert!(fine < 1e-5 && (12.0..20.0).contains(&(coarse / fine)), "{coarse:e} {fine:e}");
        // As coarse as steps may be: it dies away.
        assert!(phase(25) < 1.2);
    }
}
