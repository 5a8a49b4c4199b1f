//! Given loads close to what friction can hold: found by the motions that lead to them.
//!
//! There the loads hardly answer to the motions: all cells slip, each pulls nearly the way the bodies
//! go, and what is missing to the limit falls as the inverse square of the distance. Corrections
//! without loads of their own, which serve elsewhere, have no direction left. At given motions
//! the problem stays well posed. The motions are the maximum of a concave function, whose
//! gradient is what the loads are off; Newton's method finds them with the loads L stretched to
//! `L / sqrt(1 - g^2)`, where g is the part of the limit that they use. That grows with the distance.

use carom_halfspace::operator::OperatorError;
use nalgebra::{Matrix3, Vector3};

use super::active_set::{ActiveSet, Limits, Plane, TangentialTask, dot};
use super::course::Course;
use super::law::force_scale;
use super::limit_surface::LimitSurface;
use super::rigid::{self, Rigid};
use crate::convergence::{Convergence, Observer, Products, Residuals, Stop};
use crate::state::CellState;

/// Newton's steps of one search.
const STEPS: usize = 60;
/// How often one of them is halved.
const HALVINGS: usize = 30;
/// Part of the tolerance to which tractions are found at given motions.
const TIGHT: f64 = 0.3;
/// What is left of the answers of the tractions to a motion, over what there was.
const ANSWERED: f64 = 1e-6;
/// Gradient steps for one of them.
const GRADIENTS: usize = 100;

/// The working memory of a search.
#[derive(Clone, Default)]
pub(super) struct Search {
    surface: LimitSurface,
    /// Where the last step began.
    traction: Plane,
    cells: Vec<CellState>,
}

/// Loads, stretched so that they grow with the motions, and how that answers to the loads.
struct Stretched {
    loads: Vector3<f64>,
    slope: Matrix3<f64>,
}

/// Stretches loads; none beyond the limit.
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
    /// Solves a packed task with given loads.
    pub(super) fn search(
        &mut self,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        cells: usize,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        let mut search = std::mem::take(&mut self.search);
        let went = self.search_with(&mut search, task, limits, cells, observer);
        self.search = search;
        went
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
        for step in 0..=STEPS {
            let got = self.given_loads(task, &given);
            task.rigid.loads = given;
            let unbalance = self.unbalance(task, touching) / scale;
            reached.residuals.tangential = reached.residuals.tangential.max(unbalance);
            if reached.stop != Stop::Converged || unbalance <= limits.tolerance {
                return Ok(reached);
            }
            if step == STEPS {
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

    /// The loads whose motions are given, zero for the others.
    fn given_loads(&self, task: &TangentialTask<'_>, given: &[Option<f64>; 3]) -> Vector3<f64> {
        let sums = rigid::sums(&self.centres, [task.traction[0], task.traction[1]]);
        Vector3::from_fn(|k, _| if given[k].is_some() { sums[k] } else { 0.0 })
    }

    /// Tractions at the motions of a task.
    fn at_motions(
        &mut self,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        cells: usize,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        let given = task.rigid;
        task.rigid = Rigid { loads: [None; 3], ..given };
        let limits = Limits { tolerance: TIGHT * limits.tolerance, change: 0.0, ..limits };
        let went = self.iterate(task, limits, cells, observer);
        task.rigid.loads = given.loads;
        went
    }

    /// How the given loads answer to their motions while no cell changes what it does.
    fn answers(
        &mut self,
        task: &TangentialTask<'_>,
        given: &[Option<f64>; 3],
        products: &mut Products,
    ) -> Result<Matrix3<f64>, OperatorError> {
        self.linearise(task);
        let mut answers = Matrix3::identity();
        for k in (0..3).filter(|k| given[*k].is_some()) {
            let loads = self.answer(task, k, products)?;
            for l in (0..3).filter(|l| given[*l].is_some()) {
                answers[(l, k)] = loads[l];
            }
        }
        Ok(0.5 * (answers + answers.transpose()))
    }

    /// Rims and bends of a solution.
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

    /// The loads of the tractions that a unit of one motion leads to: conjugate gradients.
    fn answer(
        &mut self,
        task: &TangentialTask<'_>,
        k: usize,
        products: &mut Products,
    ) -> Result<Vector3<f64>, OperatorError> {
        let mut course = Course::default();
        let motion = Vector3::from_fn(|l, _| f64::from(u8::from(l == k)));
        for i in 0..task.limits.len() {
            let whole = rigid::displacement(&motion, self.centres[0][i], self.centres[1][i]);
            let [x, y] = self.admitted(task.cells[i], i, whole);
            (self.rest[0][i], self.rest[1][i]) = (x, y);
        }
        let mut loads = Vector3::zeros();
        let mut power = self.invert(task.cells, &mut course);
        let least = ANSWERED * ANSWERED * power;
        for axis in 0..2 {
            self.direction[axis].copy_from_slice(&self.preconditioned[axis]);
        }
        for _ in 0..GRADIENTS {
            if power.is_nan() || power <= least {
                break;
            }
            self.multiply(task.operator, &mut course.products)?;
            for i in 0..task.limits.len() {
                let own =
                    [0, 1].map(|axis| self.image[axis][i] + self.bend[i] * self.direction[axis][i]);
                let [x, y] = self.admitted(task.cells[i], i, own);
                (self.image[0][i], self.image[1][i]) = (x, y);
            }
            let curvature = dot(&self.direction, &self.image);
            if curvature.is_nan() || curvature <= 0.0 {
                break;
            }
            let length = power / curvature;
            let sums = rigid::sums(&self.centres, [&self.direction[0], &self.direction[1]]);
            loads += sums * length;
            for (rest, image) in self.rest.iter_mut().zip(&self.image) {
                rest.iter_mut().zip(image).for_each(|(rest, image)| *rest -= length * image);
            }
            let next = self.invert(task.cells, &mut course);
            let share = next / power;
            for (direction, step) in self.direction.iter_mut().zip(&self.preconditioned) {
                let both = direction.iter_mut().zip(step);
                both.for_each(|(direction, step)| *direction = step + share * *direction);
            }
            power = next;
        }
        *products = products.plus(course.products);
        Ok(loads)
    }
}

/// What makes of loads forces: torques over the radius of the grid.
fn arms(task: &TangentialTask<'_>) -> Vector3<f64> {
    let grid = task.operator.grid();
    let arm = 0.5 * (grid.nx() as f64 * grid.dx()).hypot(grid.ny() as f64 * grid.dy());
    Vector3::new(1.0, 1.0, arm)
}

impl Search {
    fn keep(&mut self, task: &TangentialTask<'_>) {
        for (kept, traction) in self.traction.iter_mut().zip(&task.traction) {
            kept.clear();
            kept.extend_from_slice(traction);
        }
        self.cells.clear();
        self.cells.extend_from_slice(task.cells);
    }

    fn give_back(&self, task: &mut TangentialTask<'_>) {
        for (kept, traction) in self.traction.iter().zip(&mut task.traction) {
            traction.copy_from_slice(kept);
        }
        task.cells.copy_from_slice(&self.cells);
    }
}
