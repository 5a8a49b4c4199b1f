//! Prescribed loads close to the friction limit, found by iterating on the shifts.
//!
//! Close to the limit the loads hardly depend on the shifts: all cells slip almost in the direction
//! of the rigid motion, and the distance to the limit falls with the inverse square of the shift.
//! Deflated corrections, which are used elsewhere, have no direction left. With prescribed shifts
//! the problem stays well posed. The shifts maximise a concave function whose gradient is the error
//! of the loads. Newton's method finds them with the loads L scaled to `L / sqrt(1 - g^2)`, where g
//! is the fraction of the limit that they use: the scaled loads grow linearly with the shift.

use carom_halfspace::operator::OperatorError;
use nalgebra::{Matrix3, Vector3};

use super::active_set::ActiveSet;
use super::iteration_state::IterationState;
use super::law::force_scale;
use super::limit_surface::LimitSurface;
use super::plane::dot;
use super::rigid::{self, Rigid};
use super::search_scratch::Search;
use super::task::{Limits, TangentialTask};
use crate::convergence::{Convergence, Observer, Products, Residuals, Stop};
use crate::state::CellState;

/// Greatest number of Newton steps of one search.
const NEWTON_STEPS: usize = 60;
/// Greatest number of halvings of a Newton step.
const HALVINGS: usize = 30;
/// Fraction of the tolerance to which tractions are solved at prescribed shifts.
const INNER_TOLERANCE: f64 = 0.3;
/// Relative residual to which the response to a shift is solved.
const RESPONSE_RESIDUAL: f64 = 1e-6;
/// Greatest number of conjugate-gradient steps for one response.
const GRADIENT_STEPS: usize = 100;

/// Loads L scaled to `L / sqrt(1 - g^2)`, and the derivative of the scaled loads with respect to L.
struct Stretched {
    loads: Vector3<f64>,
    slope: Matrix3<f64>,
}

/// Scales loads by `1 / sqrt(1 - g^2)`; `None` if they exceed the friction limit.
fn stretched(surface: &LimitSurface, loads: &Vector3<f64>) -> Option<Stretched> {
    let used = surface.used(loads);
    let missing = (1.0 - used.part) * (1.0 + used.part);
    if missing.is_nan() || missing <= 0.0 {
        return None;
    }
    let times = 1.0 / missing.sqrt();
    let slope = Matrix3::identity() * times
        + loads * used.motion.transpose() * (used.part * times / missing);
    Some(Stretched { loads: loads * times, slope })
}

impl ActiveSet {
    /// Solves a compressed task with prescribed loads.
    pub(super) fn search(
        &mut self,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        cells: usize,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        let mut search = std::mem::take(&mut self.search);
        let convergence = self.search_with(&mut search, task, limits, cells, observer);
        self.search = search;
        convergence
    }

    fn search_with(
        &mut self,
        search: &mut Search,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        cells: usize,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        let given = task.rigid.loads;
        let (scale, touching) = (force_scale(task), task.limits.len());
        let centres = self.centres[0].iter().zip(&self.centres[1]).zip(task.limits);
        search.surface.take(centres.map(|((x, y), limit)| [*x, *y, *limit]), &given);
        let wanted = Vector3::from_fn(|k, _| given[k].unwrap_or(0.0));
        let Some(target) = stretched(&search.surface, &wanted) else {
            let residuals = Residuals { normal: 0.0, tangential: f64::INFINITY };
            let (products, stop) = (Products::default(), Stop::Stalled);
            return Ok(Convergence { iterations: 0, products, residuals, stop });
        };
        let arms = arms(task);
        let size = |loads: &Vector3<f64>| loads.component_div(&arms).norm();
        let mut reached = self.at_motions(task, limits, cells, observer)?;
        for step in 0..=NEWTON_STEPS {
            let got = self.given_loads(task, &given);
            task.rigid.loads = given;
            let unbalance = self.unbalance(task, touching) / scale;
            reached.residuals.tangential = reached.residuals.tangential.max(unbalance);
            if reached.stop != Stop::Converged || unbalance <= limits.tolerance {
                return Ok(reached);
            }
            if step == NEWTON_STEPS {
                break;
            }
            let answers = self.answers(task, &given, &mut reached.products)?;
            let here = stretched(&search.surface, &got);
            let newton = match &here {
                Some(here) => (here.slope * answers)
                    .try_inverse()
                    .map(|inverse| inverse * (target.loads - here.loads)),
                None => answers.try_inverse().map(|inverse| inverse * (wanted - got)),
            };
            let Some(newton) = newton.filter(|step| step.iter().all(|part| part.is_finite()))
            else {
                break;
            };
            let off = here.map_or(f64::INFINITY, |here| size(&(target.loads - here.loads)));
            let (start, mut part) = (task.rigid.moved, 1.0);
            search.keep(task);
            let mut nearer = false;
            for _ in 0..HALVINGS {
                task.rigid.moved = (Vector3::from(start) + newton * part).into();
                let next = self.at_motions(task, limits, cells, observer)?;
                reached = Convergence {
                    iterations: reached.iterations + next.iterations,
                    products: reached.products.plus(next.products),
                    ..next
                };
                let there = stretched(&search.surface, &self.given_loads(task, &given));
                let there =
                    there.map_or(f64::INFINITY, |there| size(&(target.loads - there.loads)));
                if next.stop == Stop::Observer {
                    break;
                }
                if next.stop == Stop::Converged && there < off {
                    nearer = true;
                    break;
                }
                search.give_back(task);
                part *= 0.5;
            }
            if !nearer {
                task.rigid.moved = start;
                break;
            }
        }
        task.rigid.loads = given;
        if reached.stop == Stop::Converged {
            reached.stop = Stop::Stalled;
        }
        Ok(reached)
    }

    /// The loads that are prescribed; zero for the other motions.
    fn given_loads(&self, task: &TangentialTask<'_>, given: &[Option<f64>; 3]) -> Vector3<f64> {
        let sums = rigid::sums(self.threads, &self.centres, [task.traction[0], task.traction[1]]);
        Vector3::from_fn(|k, _| if given[k].is_some() { sums[k] } else { 0.0 })
    }

    /// Solves for the tractions at the shifts of a task.
    fn at_motions(
        &mut self,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        cells: usize,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        let given = task.rigid;
        task.rigid = Rigid { loads: [None; 3], ..given };
        let limits =
            Limits { tolerance: INNER_TOLERANCE * limits.tolerance, change: 0.0, ..limits };
        let convergence = self.iterate(task, limits, cells, observer);
        task.rigid.loads = given.loads;
        convergence
    }

    /// The derivative of the prescribed loads with respect to their shifts, at fixed states of the
    /// cells.
    fn answers(
        &mut self,
        task: &TangentialTask<'_>,
        given: &[Option<f64>; 3],
        products: &mut Products,
    ) -> Result<Matrix3<f64>, OperatorError> {
        self.linearise(task);
        let mut answers = Matrix3::identity();
        for k in (0..3).filter(|k| given[*k].is_some()) {
            let loads = if task.operator.is_reciprocal() {
                self.answer(task, k, products)?
            } else {
                self.answer_by_newton(task, k, products)?
            };
            for l in (0..3).filter(|l| given[*l].is_some()) {
                answers[(l, k)] = loads[l];
            }
        }
        let symmetric = task.operator.is_reciprocal();
        Ok(if symmetric { 0.5 * (answers + answers.transpose()) } else { answers })
    }

    /// Rim directions and curvature terms of a solution.
    fn linearise(&mut self, task: &TangentialTask<'_>) {
        for (i, limit) in task.limits.iter().enumerate() {
            self.bend[i] = 0.0;
            if task.cells[i] == CellState::Slip {
                let at = [task.traction[0][i], task.traction[1][i]];
                let rim = at.map(|t| t / at[0].hypot(at[1]));
                (self.rim[0][i], self.rim[1][i]) = (rim[0], rim[1]);
                let along = self.slip[0][i] * rim[0] + self.slip[1][i] * rim[1];
                self.bend[i] = (-along).max(0.0) / limit;
            }
        }
        self.weigh();
    }

    /// The loads of the tractions due to a unit of one motion, by conjugate gradients.
    fn answer(
        &mut self,
        task: &TangentialTask<'_>,
        k: usize,
        products: &mut Products,
    ) -> Result<Vector3<f64>, OperatorError> {
        let mut state = IterationState::default();
        let motion = Vector3::from_fn(|l, _| f64::from(u8::from(l == k)));
        for i in 0..task.limits.len() {
            let whole = rigid::displacement(&motion, self.centres[0][i], self.centres[1][i]);
            let [x, y] = self.admitted(task.cells[i], i, whole);
            (self.rest[0][i], self.rest[1][i]) = (x, y);
        }
        let mut loads = Vector3::zeros();
        let mut power = self.invert(task.cells, &mut state);
        let least = RESPONSE_RESIDUAL * RESPONSE_RESIDUAL * power;
        for axis in 0..2 {
            self.direction[axis].copy_from_slice(&self.preconditioned[axis]);
        }
        for _ in 0..GRADIENT_STEPS {
            if power.is_nan() || power <= least {
                break;
            }
            self.multiply(task.operator, &mut state.products)?;
            for i in 0..task.limits.len() {
                let own =
                    [0, 1].map(|axis| self.image[axis][i] + self.bend[i] * self.direction[axis][i]);
                let [x, y] = self.admitted(task.cells[i], i, own);
                (self.image[0][i], self.image[1][i]) = (x, y);
            }
            let curvature = dot(self.threads, &self.direction, &self.image);
            if curvature.is_nan() || curvature <= 0.0 {
                break;
            }
            let length = power / curvature;
            let sums =
                rigid::sums(self.threads, &self.centres, [&self.direction[0], &self.direction[1]]);
            loads += sums * length;
            for (rest, image) in self.rest.iter_mut().zip(&self.image) {
                rest.iter_mut().zip(image).for_each(|(rest, image)| *rest -= length * image);
            }
            let next = self.invert(task.cells, &mut state);
            let share = next / power;
            for (direction, step) in self.direction.iter_mut().zip(&self.preconditioned) {
                let both = direction.iter_mut().zip(step);
                both.for_each(|(direction, step)| *direction = step + share * *direction);
            }
            power = next;
        }
        *products = products.plus(state.products);
        Ok(loads)
    }
}

/// Lengths that convert loads to forces: the radius of the grid for the torque.
fn arms(task: &TangentialTask<'_>) -> Vector3<f64> {
    Vector3::new(1.0, 1.0, rigid::half_diagonal(task.operator.grid()))
}
