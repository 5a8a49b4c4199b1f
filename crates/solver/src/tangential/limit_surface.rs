//! The loads that friction can hold: the limit surface.
//!
//! In rigid sliding with the velocity `n = (n_x, n_y, n_turn)` a cell of bound R at (x, y) exerts R
//! in the direction of its own velocity `v = (n_x + y n_turn, n_y - x n_turn)` (12.2). Friction
//! dissipates the power `S(n) = sum R |v|`, and the loads of these tractions are its gradient. S is
//! convex: tractions within the bounds exist for loads L if and only if `L.n <= S(n)` for every n.
//! The greatest `L.n / S(n)` is the fraction of the limit that the loads use; it is one on the
//! limit surface.

use nalgebra::{Matrix3, Vector3};

use super::rigid::displacement;

/// Greatest number of steps in the search for the least power.
const MOST_STEPS: usize = 100;
/// The search ends when the power falls by less than this fraction.
const LEAST_DECREASE: f64 = 1e-15;
/// Speeds below this fraction of the greatest one are replaced by it.
const LEAST_SPEED: f64 = 1e-12;

/// The bounds of all cells, and the motions whose loads are prescribed.
#[derive(Clone, Default)]
pub(crate) struct LimitSurface {
    /// Position and bound.
    cells: Vec<[f64; 3]>,
    given: [bool; 3],
    total: f64,
}

/// The fraction of the limit that given loads use.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Used {
    /// The fraction of the limit, 1 where the contact slides.
    pub(crate) part: f64,
    /// The velocity of rigid sliding that is closest to these loads, scaled to unit power.
    pub(crate) motion: Vector3<f64>,
}

/// The power at a velocity, with its derivatives.
struct Power {
    value: f64,
    gradient: Vector3<f64>,
    curvature: Matrix3<f64>,
    /// Sum of `R/|v|` times the squares of the motions: a quadratic form that touches the power at
    /// this velocity and lies above it elsewhere.
    weights: Matrix3<f64>,
}

impl LimitSurface {
    /// Sets cells (x, y, bound) and prescribed loads.
    pub(crate) fn take(&mut self, cells: impl Iterator<Item = [f64; 3]>, loads: &[Option<f64>; 3]) {
        self.cells.clear();
        self.cells.extend(cells.filter(|[_, _, limit]| *limit > 0.0));
        self.given = loads.map(|load| load.is_some());
        self.total = self.cells.iter().map(|[_, _, limit]| limit).sum();
    }

    /// The fraction of the limit that loads use. Loads of motions with prescribed shifts are
    /// ignored.
    pub(crate) fn used(&self, loads: &Vector3<f64>) -> Used {
        let loads = Vector3::from_fn(|k, _| if self.given[k] { loads[k] } else { 0.0 });
        let none = |part| Used { part, motion: Vector3::zeros() };
        if loads == Vector3::zeros() || self.total.is_infinite() {
            return none(0.0);
        }
        if self.total == 0.0 {
            return none(f64::INFINITY);
        }
        if !self.given[2] {
            let size = loads.norm();
            return Used { part: size / self.total, motion: loads / size / self.total };
        }
        let radius = self.radius();
        if radius == 0.0 {
            return none(if loads[2] == 0.0 { loads.norm() / self.total } else { f64::INFINITY });
        }
        // Torques are divided by the radius, so that all loads are forces.
        let loads = Vector3::new(loads[0], loads[1], loads[2] / radius);
        let (mut motion, power) = self.least_power(&loads, radius);
        motion[2] /= radius;
        Used { part: 1.0 / power, motion: motion / power }
    }

    /// An upper bound on the fraction of the limit that loads use, from a rotation about the centre
    /// of the bounds combined with a translation.
    pub(crate) fn used_at_most(&self, loads: &Vector3<f64>) -> f64 {
        if !self.given[2] || self.total == 0.0 || self.total.is_infinite() {
            return self.used(loads).part;
        }
        let mut middle = [0.0; 2];
        for [x, y, limit] in &self.cells {
            middle[0] += limit / self.total * x;
            middle[1] += limit / self.total * y;
        }
        let (mut torque, mut force) = (0.0, [0.0; 2]);
        for [x, y, limit] in &self.cells {
            let [x, y] = [x - middle[0], y - middle[1]];
            let arm = x.hypot(y);
            torque += limit * arm;
            if arm > 0.0 {
                force[0] += limit * y / arm;
                force[1] -= limit * x / arm;
            }
        }
        let load = |k: usize| if self.given[k] { loads[k] } else { 0.0 };
        let [f_x, f_y, turning] = [load(0), load(1), load(2)];
        let about_middle = turning - (middle[1] * f_x - middle[0] * f_y);
        let part = if about_middle == 0.0 { 0.0 } else { about_middle / torque };
        (f_x - part * force[0]).hypot(f_y - part * force[1]) / self.total + part.abs()
    }

    /// Root mean square distance from the centre of the grid.
    fn radius(&self) -> f64 {
        let squares = self.cells.iter().map(|[x, y, limit]| limit * (x * x + y * y));
        (squares.sum::<f64>() / self.total).sqrt()
    }

    /// The velocity with `loads.n = 1` of least power, and that power; rotations are multiplied by
    /// the radius.
    fn least_power(&self, loads: &Vector3<f64>, radius: f64) -> (Vector3<f64>, f64) {
        let mut motion = loads / loads.norm_squared();
        let mut power = self.power(&motion, radius);
        for _ in 0..MOST_STEPS {
            let newton = Self::newton(loads, &power);
            let mut next = motion + newton;
            let mut there = self.power(&next, radius);
            let falls = |there: &Power| there.value < power.value * (1.0 - LEAST_DECREASE);
            if !falls(&there) {
                // The minimum of the quadratic form is never above the power.
                next = Self::least_form(loads, &power.weights);
                there = self.power(&next, radius);
                if !falls(&there) {
                    break;
                }
            }
            (motion, power) = (next, there);
        }
        (motion, power.value)
    }

    fn newton(loads: &Vector3<f64>, power: &Power) -> Vector3<f64> {
        // The power has no curvature along the velocity itself.
        let scale = power.weights.trace() / loads.norm_squared();
        let along = loads * loads.transpose() * scale;
        let Some(inverse) = (power.curvature + along).try_inverse() else {
            return Vector3::zeros();
        };
        let (down, load) = (inverse * power.gradient, inverse * loads);
        load * (loads.dot(&down) / loads.dot(&load)) - down
    }

    fn least_form(loads: &Vector3<f64>, weights: &Matrix3<f64>) -> Vector3<f64> {
        // If all cells lie on a line through their centre, one motion has no power.
        let least = Matrix3::identity() * (weights.trace() * 1e-15);
        let answer = (weights + least).try_inverse().unwrap_or_default() * loads;
        answer / loads.dot(&answer)
    }

    fn power(&self, motion: &Vector3<f64>, radius: f64) -> Power {
        let least = LEAST_SPEED * motion.norm();
        let mut power = Power {
            value: 0.0,
            gradient: Vector3::zeros(),
            curvature: Matrix3::zeros(),
            weights: Matrix3::zeros(),
        };
        for [x, y, limit] in &self.cells {
            let (x, y) = (x / radius, y / radius);
            let [u, v] = displacement(motion, x, y);
            let speed = u.hypot(v);
            power.value += limit * speed;
            let speed = speed.max(least);
            let weight = limit / speed;
            let [along, across] = [Vector3::new(1.0, 0.0, y), Vector3::new(0.0, 1.0, -x)];
            power.gradient += (along * u + across * v) * weight;
            let around = (across * u - along * v) / speed;
            power.curvature += around * around.transpose() * weight;
            power.weights += (along * along.transpose() + across * across.transpose()) * weight;
        }
        for k in (0..3).filter(|k| !self.given[*k]) {
            power.gradient[k] = 0.0;
            for matrix in [&mut power.curvature, &mut power.weights] {
                matrix.row_mut(k).fill(0.0);
                matrix.column_mut(k).fill(0.0);
            }
            power.curvature[(k, k)] = 1.0;
            power.weights[(k, k)] = 1.0;
        }
        power
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disc of even limits: its greatest torque is 2/3 of limit times radius.
    fn disc(loads: [Option<f64>; 3], offset: [f64; 2]) -> LimitSurface {
        let n = 200;
        let place = |k: i32| (f64::from(k) + 0.5) * 2.0 / f64::from(n) - 1.0;
        let cells = (0..n * n).map(|i| [place(i % n), place(i / n)]);
        let inside = cells.filter(|[x, y]| x * x + y * y < 1.0);
        let mut surface = LimitSurface::default();
        surface.take(inside.map(|[x, y]| [x + offset[0], y + offset[1], 0.7]), &loads);
        surface
    }

    #[test]
    fn forces_are_held_up_to_the_sum_of_the_limits_and_torques_up_to_rotation() {
        let surface = disc([Some(0.0), Some(0.0), Some(0.0)], [0.0; 2]);
        let total = surface.total;
        let force = surface.used(&(Vector3::new(0.3, 0.4, 0.0) * total));
        assert!((force.part - 0.5).abs() < 1e-12, "{force:?}");
        let turn = surface.used(&Vector3::new(0.0, 0.0, -0.5 * 2.0 / 3.0 * total));
        assert!((turn.part - 0.5).abs() < 1e-3 && turn.motion[2] < 0.0, "{turn:?}");
    }

    /// The loads of rigid sliding lie on the surface, those within use their part, whatever the middle.
    #[test]
    fn loads_of_rigid_sliding_use_all_of_the_limit() {
        for offset in [[0.0; 2], [0.4, -1.7]] {
            let surface = disc([Some(0.0), Some(0.0), Some(0.0)], offset);
            for motion in [[0.3, -0.2, 0.5], [1.0, 0.1, 1e-3], [0.01, 0.02, -1.0]] {
                let motion = Vector3::from(motion);
                let loads = surface.power(&motion, 1.0).gradient;
                let used = surface.used(&loads);
                assert!((used.part - 1.0).abs() < 1e-9, "{used:?}");
                let angle = used.motion.normalize() - motion.normalize();
                assert!(angle.norm() < 1e-4, "{used:?} {motion:?}");
                let half = loads * 0.5;
                assert!((surface.used(&half).part - 0.5).abs() < 1e-9);
                let bound = surface.used_at_most(&half);
                assert!((0.5 - 1e-12..0.9).contains(&bound), "{bound}");
            }
        }
    }

    #[test]
    fn loads_that_are_not_given_count_nothing() {
        let surface = disc([None, Some(0.0), None], [0.0; 2]);
        let used = surface.used(&Vector3::new(1e9, 0.25 * surface.total, 1e9));
        assert!((used.part - 0.25).abs() < 1e-12);
        assert!((used.motion[1] * surface.total - 1.0).abs() < 1e-12);
        let nothing = disc([Some(0.0); 3], [0.0; 2]).used(&Vector3::zeros());
        assert_eq!(nothing.part, 0.0);
    }
}
