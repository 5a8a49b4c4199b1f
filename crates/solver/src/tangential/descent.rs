//! Accelerated projected gradients: slow but sure to converge, used when the active-set iteration
//! stalls.
//!
//! If loads are prescribed, each step is projected onto the tractions with these loads: the
//! corresponding shifts move until the discs around the updated tractions hold the loads.

use carom_halfspace::operator::{OperatorError, SurfaceOperator};
use nalgebra::{Matrix3, Vector3};

use super::active_set::ActiveSet;
use super::law::project_to_disc;
use super::plane::Plane;
use super::rigid;
use super::task::TangentialTask;
use crate::convergence::Products;
use crate::state::CellState;

/// Gradient steps of one restart.
const GRADIENT_STEPS: usize = 12;
/// Newton steps to find the shifts for prescribed loads.
const NEWTON_STEPS: usize = 20;
/// Newton steps longer than this many sure ones are not made.
const FARTHEST: f64 = 1e6;
/// The squared error of the loads is reduced by this factor.
const LOAD_REDUCTION: f64 = 1e-20;

/// Steps of fixed length, the inverse of a bound on the norm of the operator.
pub(super) struct Descent {
    length: f64,
}

impl Descent {
    pub(super) fn new(operator: &dyn SurfaceOperator) -> Self {
        Self { length: 1.0 / row_sum(operator) }
    }

    /// Moves the tractions towards the solution; updates slip and states.
    pub(super) fn run(
        &self,
        set: &mut ActiveSet,
        task: &mut TangentialTask<'_>,
        products: &mut Products,
    ) -> Result<(), OperatorError> {
        let count = task.limits.len();
        for i in 0..count {
            let inside =
                project_to_disc([task.traction[0][i], task.traction[1][i]], task.limits[i]);
            (task.traction[0][i], task.traction[1][i]) = (inside[0], inside[1]);
        }
        let mut ahead = [task.traction[0].to_vec(), task.traction[1].to_vec()];
        let mut momentum = 1.0_f64;
        for _ in 0..GRADIENT_STEPS {
            self.slip_at(set, task, &ahead, products)?;
            self.meet_loads(set, task, &ahead);
            let next_momentum = 0.5 * (1.0 + (1.0 + 4.0 * momentum * momentum).sqrt());
            let share = (momentum - 1.0) / next_momentum;
            let mut uphill = 0.0;
            let [ahead_x, ahead_y] = &mut ahead;
            for (i, (x, y)) in ahead_x.iter_mut().zip(ahead_y).enumerate() {
                let slip = [set.slip[0][i], set.slip[1][i]];
                let pulled = [*x - self.length * slip[0], *y - self.length * slip[1]];
                let next = project_to_disc(pulled, task.limits[i]);
                let moved = [next[0] - task.traction[0][i], next[1] - task.traction[1][i]];
                uphill += slip[0] * moved[0] + slip[1] * moved[1];
                (task.traction[0][i], task.traction[1][i]) = (next[0], next[1]);
                (*x, *y) = (next[0] + share * moved[0], next[1] + share * moved[1]);
            }
            momentum = next_momentum;
            if uphill > 0.0 {
                momentum = 1.0;
                for (ahead, traction) in ahead.iter_mut().zip(&task.traction) {
                    ahead.copy_from_slice(traction);
                }
            }
        }
        self.settle(set, task, products)
    }

    /// Moves the tractions towards the solution for a positive influence that is no gradient: each
    /// step is repeated from its beginning with the slip to which it leads, because the slip alone
    /// would drive the tractions around the solution.
    pub(super) fn run_twice(
        &self,
        set: &mut ActiveSet,
        task: &mut TangentialTask<'_>,
        steps: usize,
        products: &mut Products,
    ) -> Result<(), OperatorError> {
        for i in 0..task.limits.len() {
            let inside =
                project_to_disc([task.traction[0][i], task.traction[1][i]], task.limits[i]);
            (task.traction[0][i], task.traction[1][i]) = (inside[0], inside[1]);
        }
        let mut from = [task.traction[0].to_vec(), task.traction[1].to_vec()];
        let mut trial = from.clone();
        for _ in 0..steps {
            self.slip_at(set, task, &from, products)?;
            self.move_with(set, task, &from, &mut trial);
            self.slip_at(set, task, &trial, products)?;
            self.move_with(set, task, &from, &mut trial);
            std::mem::swap(&mut from, &mut trial);
        }
        for (traction, from) in task.traction.iter_mut().zip(&from) {
            traction.copy_from_slice(from);
        }
        self.settle(set, task, products)
    }

    /// A step from given tractions with the present slip, onto the discs and the prescribed loads.
    fn move_with(
        &self,
        set: &mut ActiveSet,
        task: &mut TangentialTask<'_>,
        from: &Plane,
        to: &mut Plane,
    ) {
        self.meet_loads(set, task, from);
        for (i, limit) in task.limits.iter().enumerate() {
            let pulled = [0, 1].map(|axis| from[axis][i] - self.length * set.slip[axis][i]);
            [to[0][i], to[1][i]] = project_to_disc(pulled, *limit);
        }
    }

    /// Slip and states of the cells for the present tractions.
    fn settle(
        &self,
        set: &mut ActiveSet,
        task: &mut TangentialTask<'_>,
        products: &mut Products,
    ) -> Result<(), OperatorError> {
        let ahead = [task.traction[0].to_vec(), task.traction[1].to_vec()];
        self.slip_at(set, task, &ahead, products)?;
        for (i, limit) in task.limits.iter().enumerate() {
            let (x, y) = (task.traction[0][i], task.traction[1][i]);
            let along = set.slip[0][i] * x + set.slip[1][i] * y;
            task.cells[i] = match *limit {
                limit if x.hypot(y) >= (1.0 - 1e-9) * limit && along < 0.0 => CellState::Slip,
                _ => CellState::Stick,
            };
        }
        Ok(())
    }

    /// Finds the shifts for which the tractions of the next step have the prescribed loads:
    /// Newton's method on a convex function whose second derivative is bounded.
    fn meet_loads(&self, set: &mut ActiveSet, task: &mut TangentialTask<'_>, ahead: &Plane) {
        if !task.rigid.is_loaded() {
            return;
        }
        let mut wrong = self.load_error(set, task, ahead);
        let bound = wrong.bound.try_inverse().unwrap_or_default();
        let size = |wrong: &LoadError| wrong.loads.dot(&(bound * wrong.loads));
        let enough = LOAD_REDUCTION * size(&wrong);
        for _ in 0..NEWTON_STEPS {
            if size(&wrong) <= enough {
                break;
            }
            let sure = bound * wrong.loads;
            let newton = wrong.slope.try_inverse().unwrap_or_default() * wrong.loads;
            // Far beyond the discs loads no longer depend on the shifts.
            if newton.iter().any(|part| !part.is_finite()) || newton.norm() > FARTHEST * sure.norm()
            {
                move_rigidly(set, task, &-sure);
                wrong = self.load_error(set, task, ahead);
                continue;
            }
            move_rigidly(set, task, &-newton);
            let next = self.load_error(set, task, ahead);
            if size(&next) < size(&wrong) {
                wrong = next;
                continue;
            }
            move_rigidly(set, task, &(newton - sure));
            wrong = self.load_error(set, task, ahead);
        }
    }

    /// The error of the loads in the next step.
    fn load_error(&self, set: &ActiveSet, task: &TangentialTask<'_>, ahead: &Plane) -> LoadError {
        let mut off = LoadError::default();
        for (i, &limit) in task.limits.iter().enumerate() {
            let (x, y) = (set.centres[0][i], set.centres[1][i]);
            let [u, v] = [Vector3::new(1.0, 0.0, y), Vector3::new(0.0, 1.0, -x)];
            let q = [0, 1].map(|axis| ahead[axis][i] - self.length * set.slip[axis][i]);
            let t = project_to_disc(q, limit);
            off.loads += u * t[0] + v * t[1];
            off.bound += self.length * (u * u.transpose() + v * v.transpose());
            let size = q[0].hypot(q[1]);
            off.slope += if size > limit {
                let around = (v * q[0] - u * q[1]) / size;
                self.length * limit / size * (around * around.transpose())
            } else {
                self.length * (u * u.transpose() + v * v.transpose())
            };
        }
        for k in 0..3 {
            if let Some(load) = task.rigid.loads[k] {
                off.loads[k] -= load;
                continue;
            }
            off.loads[k] = 0.0;
            for matrix in [&mut off.bound, &mut off.slope] {
                matrix.row_mut(k).fill(0.0);
                matrix.column_mut(k).fill(0.0);
                matrix[(k, k)] = 1.0;
            }
        }
        off
    }

    fn slip_at(
        &self,
        set: &mut ActiveSet,
        task: &TangentialTask<'_>,
        traction: &[Vec<f64>; 2],
        products: &mut Products,
    ) -> Result<(), OperatorError> {
        for (direction, traction) in set.direction.iter_mut().zip(traction) {
            direction.copy_from_slice(traction);
        }
        set.multiply(task.operator, products)?;
        set.slip_of_image(task);
        Ok(())
    }
}

/// Error of the loads, its derivative with respect to the shifts, and a bound on that derivative.
#[derive(Default)]
struct LoadError {
    loads: Vector3<f64>,
    slope: Matrix3<f64>,
    bound: Matrix3<f64>,
}

/// Moves the rigid shifts whose loads are prescribed; updates the slip.
fn move_rigidly(set: &mut ActiveSet, task: &mut TangentialTask<'_>, by: &Vector3<f64>) {
    for i in 0..task.limits.len() {
        let convergence = rigid::displacement(by, set.centres[0][i], set.centres[1][i]);
        set.slip[0][i] -= convergence[0];
        set.slip[1][i] -= convergence[1];
    }
    for k in 0..3 {
        task.rigid.moved[k] += by[k];
    }
}

/// The greatest absolute row sum of the tangential influence, a bound on its norm.
fn row_sum(operator: &dyn SurfaceOperator) -> f64 {
    let (nx, ny) = (operator.grid().nx() as i32, operator.grid().ny() as i32);
    let mut sum = [0.0; 2];
    for rows in 1 - ny..ny {
        for columns in 1 - nx..nx {
            let [x, y, _] = operator.coefficients(columns, rows).rows;
            sum[0] += x[0].abs() + x[1].abs();
            sum[1] += y[0].abs() + y[1].abs();
        }
    }
    sum[0].max(sum[1])
}
