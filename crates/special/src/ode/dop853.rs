//! The Dormand-Prince method of order 8(5,3) for small systems of fixed size, without allocation.

use super::tableau::{
    A1, A2, A3, A4, A5, A6, A7, A8, A9, A10, A11, A13, A14, A15, B, C, D, E3, E5,
};

/// Absolute and relative tolerance of a step, the same for every component.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Absolute tolerance, in the units of the unknowns.
    pub absolute: f64,
    /// Relative tolerance.
    pub relative: f64,
}

/// Why an integration failed. The state is that of the last accepted step.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum OdeError {
    /// The step became too small to change the argument.
    #[error("step {step:e} at x = {x} is too small to go on")]
    StepTooSmall {
        /// Argument of the last accepted step.
        x: f64,
        /// The step that was tried.
        step: f64,
    },
    /// The derivative was not finite at an accepted point.
    #[error("the slope is not finite at x = {x}")]
    NotFinite {
        /// The argument at that point.
        x: f64,
    },
}

/// An integration of `y' = f(x, y)` with `N` unknowns.
///
/// Each call of [`Stepper::step`] takes one accepted step of adaptive length (order 8, error
/// estimates of order 5 and 3), never beyond the limit given. No allocation.
///
/// ```
/// use carom_special::ode::{Stepper, Tolerance};
/// let slope = |_: f64, y: &[f64; 2]| [y[1], -y[0]];
/// let tolerance = Tolerance { absolute: 1e-13, relative: 1e-13 };
/// let mut stepper = Stepper::new(0.0, [0.0, 1.0], 1.0, tolerance, slope)?;
/// while stepper.x() < 2.0 {
///     stepper.step(2.0)?;
/// }
/// assert!((stepper.y()[0] - 2.0_f64.sin()).abs() < 1e-12);
/// # Ok::<(), carom_special::ode::OdeError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Stepper<const N: usize, F> {
    slope: F,
    tolerance: Tolerance,
    x: f64,
    y: [f64; N],
    trial: f64,
    last: f64,
    previous: [f64; N],
    stages: [[f64; N]; 16],
}

impl<const N: usize, F: FnMut(f64, &[f64; N]) -> [f64; N]> Stepper<N, F> {
    /// Starts at `x`, `y` with a first trial step of `step`, whose sign is the direction.
    ///
    /// # Errors
    /// [`OdeError::NotFinite`] if the derivative at the start is not finite.
    pub fn new(
        x: f64,
        y: [f64; N],
        step: f64,
        tolerance: Tolerance,
        mut slope: F,
    ) -> Result<Self, OdeError> {
        let mut stages = [[0.0; N]; 16];
        stages[0] = slope(x, &y);
        if !all_finite(&stages[0]) {
            return Err(OdeError::NotFinite { x });
        }
        Ok(Self { slope, tolerance, x, y, trial: step, last: 0.0, previous: y, stages })
    }

    /// The present argument.
    #[must_use]
    pub fn x(&self) -> f64 {
        self.x
    }

    /// The present unknowns.
    #[must_use]
    pub fn y(&self) -> &[f64; N] {
        &self.y
    }

    /// The present derivative.
    #[must_use]
    pub fn slope(&self) -> &[f64; N] {
        &self.stages[0]
    }

    /// The argument and the unknowns before the last accepted step.
    #[must_use]
    pub fn before(&self) -> (f64, &[f64; N]) {
        (self.x - self.last, &self.previous)
    }

    /// The length (with sign) that the next step will try.
    #[must_use]
    pub fn trial_step(&self) -> f64 {
        self.trial
    }

    /// Makes one accepted step towards `limit`, ending there at the latest.
    ///
    /// # Errors
    /// [`OdeError::StepTooSmall`] if no step length satisfies the tolerance; the state is
    /// unchanged.
    pub fn step(&mut self, limit: f64) -> Result<(), OdeError> {
        let room = limit - self.x;
        if room == 0.0 {
            return Ok(());
        }
        let mut step = self.trial.abs().copysign(room);
        let mut rejected = false;
        loop {
            // Lengthen the step by up to 1 % rather than leave a very short last step.
            let lands = step.abs() * 1.01 >= room.abs();
            if lands {
                step = room;
            }
            if step.abs() <= f64::EPSILON * self.x.abs() * 0.5 || step.abs() < 1e-300 {
                return Err(OdeError::StepTooSmall { x: self.x, step });
            }
            let (y, error) = self.attempt(step);
            if error <= 1.0 {
                self.accept(step, y, if lands { limit } else { self.x + step });
                let factor = if error == 0.0 { 10.0 } else { 0.9 * growth(error) };
                let factor = factor.clamp(0.333, if rejected { 1.0 } else { 6.0 });
                // A step shortened by the limit is no reason to reduce the trial step.
                self.trial = (step * factor).abs().max(if lands && !rejected {
                    self.trial.abs()
                } else {
                    0.0
                });
                return Ok(());
            }
            rejected = true;
            let factor = if error.is_finite() { 0.9 * growth(error) } else { 0.1 };
            step *= factor.clamp(0.1, 0.9);
        }
    }

    fn attempt(&mut self, step: f64) -> ([f64; N], f64) {
        // Written out so that the compiler knows every index.
        self.stage::<1, _>(step, &A1);
        self.stage::<2, _>(step, &A2);
        self.stage::<3, _>(step, &A3);
        self.stage::<4, _>(step, &A4);
        self.stage::<5, _>(step, &A5);
        self.stage::<6, _>(step, &A6);
        self.stage::<7, _>(step, &A7);
        self.stage::<8, _>(step, &A8);
        self.stage::<9, _>(step, &A9);
        self.stage::<10, _>(step, &A10);
        self.stage::<11, _>(step, &A11);
        let y = self.combine(step, &B);
        (y, self.error_norm(step, &y))
    }

    #[inline(always)]
    fn stage<const I: usize, const M: usize>(&mut self, step: f64, weights: &[(usize, f64); M]) {
        let y = self.combine(step, weights);
        self.stages[I] = (self.slope)(self.x + C[I] * step, &y);
    }

    #[inline(always)]
    fn combine<const M: usize>(&self, step: f64, weights: &[(usize, f64); M]) -> [f64; N] {
        let sum = self.weighted(weights);
        std::array::from_fn(|n| self.y[n] + step * sum[n])
    }

    #[inline(always)]
    fn weighted<const M: usize>(&self, weights: &[(usize, f64); M]) -> [f64; N] {
        let mut sum = [0.0; N];
        for &(stage, weight) in weights {
            for (sum, slope) in sum.iter_mut().zip(&self.stages[stage]) {
                *sum += weight * slope;
            }
        }
        sum
    }

    fn error_norm(&self, step: f64, y: &[f64; N]) -> f64 {
        let (e3, e5) = (self.weighted(&E3), self.weighted(&E5));
        let (mut sum3, mut sum5) = (0.0, 0.0);
        for n in 0..N {
            let size = self.y[n].abs().max(y[n].abs());
            let scale = self.tolerance.absolute + self.tolerance.relative * size;
            sum3 += (e3[n] / scale) * (e3[n] / scale);
            sum5 += (e5[n] / scale) * (e5[n] / scale);
        }
        let denominator = sum5 + 0.01 * sum3;
        if denominator == 0.0 {
            return 0.0;
        }
        let error = step.abs() * sum5 / (denominator * N as f64).sqrt();
        if error.is_finite() && all_finite(y) { error } else { f64::INFINITY }
    }

    fn accept(&mut self, step: f64, y: [f64; N], x: f64) {
        // Stage 12 keeps the derivative at the new point, for the next step and for dense output.
        self.stages[12] = (self.slope)(x, &y);
        self.previous = self.y;
        self.y = y;
        self.last = step;
        self.x = x;
        self.swap_slopes();
    }

    // Stage 0 becomes the derivative at the new point, stage 12 that at the old one.
    fn swap_slopes(&mut self) {
        self.stages.swap(0, 12);
    }

    /// The dense output over the last accepted step; three more evaluations of the derivative.
    pub fn dense(&mut self) -> DenseStep<N> {
        let (start, step) = (self.x - self.last, self.last);
        let reached = self.x;
        self.swap_slopes();
        let end = std::mem::replace(&mut self.y, self.previous);
        self.x = start;
        self.stage::<13, _>(step, &A13);
        self.stage::<14, _>(step, &A14);
        self.stage::<15, _>(step, &A15);
        (self.x, self.y) = (reached, end);
        let delta: [f64; N] = std::array::from_fn(|n| self.y[n] - self.previous[n]);
        let mut terms = [[0.0; N]; 7];
        for n in 0..N {
            terms[0][n] = delta[n];
            terms[1][n] = step * self.stages[0][n] - delta[n];
            terms[2][n] = 2.0 * delta[n] - step * (self.stages[12][n] + self.stages[0][n]);
        }
        for (row, weights) in D.iter().enumerate() {
            let sum = self.weighted(weights);
            terms[3 + row] = sum.map(|value| step * value);
        }
        self.swap_slopes();
        DenseStep { start, step, origin: self.previous, terms }
    }
}

/// The solution over one accepted step as a polynomial of degree 7 in x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DenseStep<const N: usize> {
    start: f64,
    step: f64,
    origin: [f64; N],
    terms: [[f64; N]; 7],
}

impl<const N: usize> DenseStep<N> {
    /// The argument at the start of the step.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.start
    }

    /// The argument at the end of the step.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.start + self.step
    }

    /// The unknowns at `x`, for x between start and end.
    #[must_use]
    pub fn at(&self, x: f64) -> [f64; N] {
        let t = (x - self.start) / self.step;
        let mut y = [0.0; N];
        for (i, term) in self.terms.iter().rev().enumerate() {
            let factor = if i % 2 == 0 { t } else { 1.0 - t };
            for n in 0..N {
                y[n] = (y[n] + term[n]) * factor;
            }
        }
        std::array::from_fn(|n| y[n] + self.origin[n])
    }
}

// error^(-1/8)
fn growth(error: f64) -> f64 {
    1.0 / error.sqrt().sqrt().sqrt()
}

fn all_finite<const N: usize>(y: &[f64; N]) -> bool {
    y.iter().all(|value| value.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TIGHT: Tolerance = Tolerance { absolute: 1e-13, relative: 1e-13 };

    fn kepler(_: f64, y: &[f64; 4]) -> [f64; 4] {
        let r3 = (y[0] * y[0] + y[1] * y[1]).powf(1.5);
        [y[2], y[3], -y[0] / r3, -y[1] / r3]
    }

    #[test]
    fn kepler_orbit_closes_and_dense_output_follows_it() {
        let start = [0.4, 0.0, 0.0, 2.0]; // eccentricity 0.6, period 2 pi
        let period = 2.0 * std::f64::consts::PI;
        let mut stepper = Stepper::new(0.0, start, 0.1, TIGHT, kepler).unwrap();
        let mut worst: f64 = 0.0;
        while stepper.x() < period {
            stepper.step(period).unwrap();
            let dense = stepper.dense();
            assert_eq!(dense.at(dense.start()), *stepper.before().1);
            for i in 1..8 {
                let x = dense.start() + 0.125 * i as f64 * (dense.end() - dense.start());
                let y = dense.at(x);
                let energy = 0.5 * (y[2] * y[2] + y[3] * y[3]) - 1.0 / y[0].hypot(y[1]);
                worst = worst.max((energy + 0.5).abs());
                // Kepler's equation: the time at this place.
                let anomaly = (y[1] / 0.8).atan2(y[0] + 0.6);
                let off = anomaly - 0.6 * anomaly.sin() - x;
                worst = worst.max((off / period - (off / period).round()).abs());
            }
        }
        for (end, begin) in stepper.y().iter().zip(start) {
            assert!((end - begin).abs() < 3e-11, "{:?}", stepper.y());
        }
        assert!(worst < 1e-10, "{worst}");
    }

    #[test]
    fn order_is_eight() {
        // One fixed step of exp: the error falls by 2^9 when the step halves.
        let error = |step: f64| {
            let loose = Tolerance { absolute: 1.0, relative: 1.0 };
            let mut stepper =
                Stepper::new(0.0, [1.0], step, loose, |_, y: &[f64; 1]| [y[0]]).unwrap();
            stepper.step(step).unwrap();
            (stepper.y()[0] - step.exp()).abs()
        };
        let ratio = error(2.0) / error(1.0);
        assert!((256.0..1500.0).contains(&ratio), "{ratio}");
    }

    #[test]
    fn backward_integration_and_failure_are_typed() {
        let mut stepper = Stepper::new(1.0, [1.0], -0.1, TIGHT, |_, y: &[f64; 1]| [y[0]]).unwrap();
        while stepper.x() > 0.0 {
            stepper.step(0.0).unwrap();
        }
        assert!((stepper.y()[0] - (-1.0_f64).exp()).abs() < 1e-12);
        let mut blow =
            Stepper::new(0.0, [1.0], 0.1, TIGHT, |_, y: &[f64; 1]| [y[0] * y[0]]).unwrap();
        let error = loop {
            if let Err(error) = blow.step(2.0) {
                break error;
            }
        };
        assert!(matches!(error, OdeError::StepTooSmall { x, .. } if (x - 1.0).abs() < 1e-3));
    }
}
