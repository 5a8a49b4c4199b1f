//! Anderson mixing: accelerates a fixed-point iteration by combining its last passes.

use nalgebra::{DMatrix, DVector};

/// Number of passes kept.
const KEPT_PASSES: usize = 10;
/// The memory is cleared if the residual exceeds this many times the least one.
const LARGEST_GROWTH: f64 = 10.0;

/// The last arguments x and residuals G(x) - x of a map G whose fixed point is sought.
#[derive(Debug, Clone, Default)]
pub(crate) struct Mixing {
    arguments: Vec<Vec<f64>>,
    residuals: Vec<Vec<f64>>,
    least: Option<f64>,
}

impl Mixing {
    /// Clears the memory.
    pub(crate) fn clear(&mut self) {
        (self.arguments, self.residuals, self.least) = Default::default();
    }

    /// Replaces the image G(x) of an argument x by a better next argument: the affine combination
    /// of the last passes with the smallest residual.
    pub(crate) fn mix(&mut self, argument: &[f64], image: &mut [f64]) {
        let residual: Vec<f64> = image.iter().zip(argument).map(|(g, x)| g - x).collect();
        let size = dot(&residual, &residual).sqrt();
        if self.least.is_some_and(|least| size > LARGEST_GROWTH * least) {
            self.clear();
        }
        self.least = Some(self.least.map_or(size, |least| least.min(size)));
        if self.residuals.len() > KEPT_PASSES {
            self.arguments.remove(0);
            self.residuals.remove(0);
        }
        let weights = self.weights(&residual);
        for (k, weight) in weights.iter().enumerate() {
            let (x, r) = (&self.arguments[k], &self.residuals[k]);
            for (i, next) in image.iter_mut().enumerate() {
                *next += weight * (x[i] + r[i] - argument[i] - residual[i]);
            }
        }
        self.arguments.push(argument.to_vec());
        self.residuals.push(residual);
    }

    /// The weights of the kept passes, by least squares of the residual. Nearly parallel directions
    /// are treated as one.
    fn weights(&self, residual: &[f64]) -> Vec<f64> {
        let count = self.residuals.len();
        if count == 0 {
            return Vec::new();
        }
        let change = |k: usize| self.residuals[k].iter().zip(residual).map(|(old, new)| old - new);
        let pair = |k: usize, l: usize| change(k).zip(change(l)).map(|(a, b)| a * b).sum::<f64>();
        let gram = DMatrix::from_fn(count, count, pair);
        let right = DVector::from_fn(count, |k, _| {
            -change(k).zip(residual).map(|(a, b)| a * b).sum::<f64>()
        });
        let scale: Vec<f64> = (0..count).map(|k| gram[(k, k)].sqrt()).collect();
        if scale.contains(&0.0) {
            return vec![0.0; count];
        }
        let scaled = DMatrix::from_fn(count, count, |k, l| gram[(k, l)] / (scale[k] * scale[l]));
        let right = DVector::from_fn(count, |k, _| right[k] / scale[k]);
        let solved = scaled.svd(true, true).solve(&right, 1e-10);
        solved.map_or(vec![0.0; count], |x| x.iter().zip(&scale).map(|(x, s)| x / s).collect())
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A linear map of four directions, two of which plain passes drive away.
    #[test]
    fn a_linear_map_is_solved_in_as_many_passes_as_it_has_directions() {
        let rates = [0.9, -1.5, 0.3, 1.7];
        let fixed = [1.0, -2.0, 0.5, 3.0];
        let (mut mixing, mut x) = (Mixing::default(), vec![0.0; 4]);
        for _ in 0..6 {
            let mut image: Vec<f64> =
                (0..4).map(|i| fixed[i] + rates[i] * (x[i] - fixed[i])).collect();
            mixing.mix(&x, &mut image);
            x = image;
        }
        assert!(x.iter().zip(fixed).all(|(x, fixed)| (x - fixed).abs() < 1e-7), "{x:?}");
    }
}
