//! The displacements that the conditions of a step require.

use carom_special::RangeError;

use super::DirectError;
use carom_solver::{ContactProblem, ContactState, Drive, Driven, Residuals};

/// The displacements that a step requires (12.2): those of sticking surfaces, and approach minus
/// gap where the surfaces are in contact.
#[derive(Debug, Clone)]
pub(crate) struct Demand {
    pub(crate) target: [Vec<f64>; 3],
    /// Friction coefficient of each cell.
    pub(crate) friction: Vec<f64>,
    own: [f64; 3],
}

impl Demand {
    /// Checks that a method with direct coefficients can solve the problem.
    pub(crate) fn check(problem: &ContactProblem) -> Result<(), DirectError> {
        for cell in 0..problem.grid().cells() {
            let friction = problem.friction().at(cell);
            if friction.rest() != friction.motion() {
                let (rest, motion) = (friction.rest().get(), friction.motion().get());
                return Err(DirectError::TwoFrictions { rest, motion });
            }
        }
        Ok(())
    }

    pub(crate) fn new(
        problem: &ContactProblem,
        own: [f64; 3],
        from: &ContactState,
        drive: &Drive,
    ) -> Result<Self, DirectError> {
        drive.check()?;
        from.check_grid(problem.grid())?;
        let loads =
            [("F_z", drive.normal), ("F_x", drive.x), ("F_y", drive.y), ("M_z", drive.twist)];
        for (load, driven) in loads {
            if matches!(driven, Driven::Load(_)) {
                return Err(DirectError::GivenLoad { load });
            }
        }
        let (now, before) = (drive.shift_after(from.shift), from.shift);
        let turn = now.omega - before.omega;
        let [dx, dy] = [now.xi - before.xi, now.eta - before.eta];
        let old = from.displacement_x.values().iter().zip(from.displacement_y.values());
        let (u, v) = problem
            .grid()
            .centres()
            .zip(old)
            .map(|((x, y), (u, v))| (u + dx + y * turn, v + dy - x * turn)) // (12.2)
            .unzip();
        let w = problem.gap().heights().values().iter().map(|height| now.zeta - height).collect();
        let friction =
            (0..problem.grid().cells()).map(|i| problem.friction().at(i).motion().get()).collect();
        Ok(Self { target: [u, v, w], friction, own })
    }

    /// The approach at the deepest point.
    pub(crate) fn depth(&self) -> f64 {
        self.target[2].iter().copied().fold(0.0, f64::max)
    }

    /// f p; zero outside the contact and without friction.
    pub(crate) fn limit(&self, cell: usize, pressure: f64) -> f64 {
        if pressure > 0.0 && self.friction[cell] > 0.0 {
            self.friction[cell] * pressure
        } else {
            0.0
        }
    }

    /// The slip (12.5) of a cell with this displacement.
    pub(crate) fn slip(&self, cell: usize, displacement: &[Vec<f64>; 3]) -> [f64; 2] {
        [0, 1].map(|axis| displacement[axis][cell] - self.target[axis][cell])
    }

    /// The violations of the conditions (12.3) to (12.6).
    pub(crate) fn residuals(
        &self,
        traction: &[Vec<f64>; 3],
        displacement: &[Vec<f64>; 3],
    ) -> Residuals {
        let (mut normal, mut tangential) = (0.0_f64, 0.0_f64);
        let (mut top, mut rough) = (0.0_f64, false);
        for cell in 0..traction[2].len() {
            let pressure = traction[2][cell];
            let gap = displacement[2][cell] - self.target[2][cell];
            let tension = -pressure * self.own[2];
            normal = worst(normal, if pressure > 0.0 { gap.abs() } else { (-gap).max(tension) });
            let limit = self.limit(cell, pressure);
            rough |= limit.is_infinite();
            top = top.max(if limit.is_finite() { limit } else { 0.0 });
            tangential = worst(tangential, self.off(cell, limit, traction, displacement));
        }
        let (depth, own) = (self.depth(), self.own[0].max(self.own[1]));
        let scale = if rough || top == 0.0 { depth / own } else { top };
        let over = |value: f64, scale: f64| if scale > 0.0 { value / scale } else { value };
        Residuals { normal: over(normal, depth), tangential: over(tangential, scale) }
    }

    /// Distance of the traction of a cell from the traction that its slip leads to.
    fn off(
        &self,
        cell: usize,
        limit: f64,
        traction: &[Vec<f64>; 3],
        displacement: &[Vec<f64>; 3],
    ) -> f64 {
        let own = self.own[0].max(self.own[1]);
        let slip = self.slip(cell, displacement);
        let t = [traction[0][cell], traction[1][cell]];
        if limit == 0.0 {
            return t[0].hypot(t[1]);
        }
        let pulled = [t[0] - slip[0] / own, t[1] - slip[1] / own];
        let size = pulled[0].hypot(pulled[1]);
        let part = if size > limit { limit / size } else { 1.0 };
        (t[0] - part * pulled[0]).hypot(t[1] - part * pulled[1])
    }
}

/// The larger of two values; NaN if either is NaN.
fn worst(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

/// Checks that a tolerance is above rounding error.
pub(crate) fn check_tolerance(tolerance: f64) -> Result<(), RangeError> {
    let holds = (1e-13..=0.01).contains(&tolerance);
    RangeError::check("tolerance", tolerance, holds, "from 1e-13 to 0.01").map(drop)
}
