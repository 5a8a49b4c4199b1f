//! Accelerated projected gradients: slow, sure, and needed only where the active set loses its way.

use carom_halfspace::operator::{OperatorError, SurfaceOperator};

use super::active_set::{ActiveSet, TangentialTask};
use super::law::within;
use crate::convergence::Products;
use crate::state::CellState;

/// Steps of one rescue.
const STEPS: usize = 12;

/// Steps of a fixed length, the inverse of a bound on the operator's norm.
pub(super) struct Descent {
    length: f64,
}

impl Descent {
    pub(super) fn new(operator: &dyn SurfaceOperator) -> Self {
        Self { length: 1.0 / row_sum(operator) }
    }

    /// Takes the tractions nearer to the solution; slip and states follow.
    pub(super) fn run(
        &self,
        set: &mut ActiveSet,
        task: &mut TangentialTask<'_>,
        products: &mut Products,
    ) -> Result<(), OperatorError> {
        let count = task.limits.len();
        for i in 0..count {
            let inside = within([task.traction[0][i], task.traction[1][i]], task.limits[i]);
            (task.traction[0][i], task.traction[1][i]) = (inside[0], inside[1]);
        }
        let mut ahead = [task.traction[0].to_vec(), task.traction[1].to_vec()];
        let mut momentum = 1.0_f64;
        for _ in 0..STEPS {
            self.slip_at(set, task, &ahead, products)?;
            let next_momentum = 0.5 * (1.0 + (1.0 + 4.0 * momentum * momentum).sqrt());
            let share = (momentum - 1.0) / next_momentum;
            let mut uphill = 0.0;
            let [ahead_x, ahead_y] = &mut ahead;
            for (i, (x, y)) in ahead_x.iter_mut().zip(ahead_y).enumerate() {
                let slip = [set.slip[0][i], set.slip[1][i]];
                let pulled = [*x - self.length * slip[0], *y - self.length * slip[1]];
                let next = within(pulled, task.limits[i]);
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
        ahead = [task.traction[0].to_vec(), task.traction[1].to_vec()];
        self.slip_at(set, task, &ahead, products)?;
        for (i, limit) in task.limits.iter().enumerate() {
            let (x, y) = (task.traction[0][i], task.traction[1][i]);
            let along = set.slip[0][i] * x + set.slip[1][i] * y;
            task.cells[i] = match *limit {
                0.0 => CellState::Exterior,
                limit if x.hypot(y) >= (1.0 - 1e-9) * limit && along < 0.0 => CellState::Slip,
                _ => CellState::Stick,
            };
        }
        Ok(())
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

/// The greatest sum of the sizes in a row of the tangential block: no norm is larger.
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
