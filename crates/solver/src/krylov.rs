//! The generalised minimal residual method (GMRES) with a right preconditioner.

/// GMRES restarts after at most this number of directions.
const DIRECTIONS: usize = 240;
/// The greatest number of values of all directions together; thirty directions are always kept.
const VALUES: usize = 10_000_000;

/// A linear map with an approximate inverse.
pub(crate) trait LinearMap {
    type Error;

    /// Puts the image of `x` into `y`.
    fn apply(&mut self, x: &[f64], y: &mut [f64]) -> Result<(), Self::Error>;

    /// Puts an approximate solution of `map x = y` into `x`.
    fn precondition(&mut self, y: &[f64], x: &mut [f64]);
}

/// Solves `map x = right`, starting from zero, until the residual is at most `least` in norm, a restart makes no
/// progress, or this many products are spent; the last one, for the residual, may come on top. Returns the norm of
/// the residual.
///
/// # Errors
/// The errors of the map.
pub(crate) fn solve<M: LinearMap>(
    map: &mut M,
    right: &[f64],
    solution: &mut [f64],
    least: f64,
    products: usize,
) -> Result<f64, M::Error> {
    solution.fill(0.0);
    let mut rest = right.to_vec();
    let mut spent = 0;
    let mut left = norm(&rest);
    while left > least && spent < products {
        let kept = (VALUES / rest.len()).clamp(30, DIRECTIONS);
        let most = kept.min(products - spent);
        let before = left;
        spent += cycle(map, &mut rest, solution, least, most)?;
        left = norm(&rest);
        // A restart without progress is the last one.
        if left.is_nan() || left > 0.999 * before {
            break;
        }
    }
    Ok(left)
}

/// One cycle of up to `most` directions; updates `rest` and `solution`. Returns the number of
/// products.
fn cycle<M: LinearMap>(
    map: &mut M,
    rest: &mut [f64],
    solution: &mut [f64],
    least: f64,
    most: usize,
) -> Result<usize, M::Error> {
    let size = norm(rest);
    let mut basis: Vec<Vec<f64>> = vec![rest.iter().map(|value| value / size).collect()];
    let mut step = vec![0.0; rest.len()];
    // Columns of the triangular matrix that Givens rotations make of the Hessenberg matrix.
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut rotations: Vec<[f64; 2]> = Vec::new();
    let mut target = vec![size];
    for k in 0..most {
        map.precondition(&basis[k], &mut step);
        if !step.iter().all(|value| value.is_finite()) {
            break;
        }
        let mut image = vec![0.0; rest.len()];
        map.apply(&step, &mut image)?;
        let mut column = Vec::with_capacity(k + 2);
        for direction in &basis {
            let part = dot(direction, &image);
            image.iter_mut().zip(direction).for_each(|(value, d)| *value -= part * d);
            column.push(part);
        }
        let beyond = norm(&image);
        for (i, [c, s]) in rotations.iter().enumerate() {
            (column[i], column[i + 1]) =
                (c * column[i] + s * column[i + 1], c * column[i + 1] - s * column[i]);
        }
        let length = column[k].hypot(beyond);
        if length == 0.0 || !length.is_finite() {
            break;
        }
        let rotation = [column[k] / length, beyond / length];
        column[k] = length;
        columns.push(column);
        rotations.push(rotation);
        target.push(-rotation[1] * target[k]);
        target[k] *= rotation[0];
        if target[k + 1].abs() <= least || beyond <= 1e-14 * length {
            break;
        }
        image.iter_mut().for_each(|value| *value /= beyond);
        basis.push(image);
    }
    let parts = back(&columns, &target);
    let mut sum = vec![0.0; rest.len()];
    for (part, direction) in parts.iter().zip(&basis) {
        sum.iter_mut().zip(direction).for_each(|(sum, value)| *sum += part * value);
    }
    map.precondition(&sum, &mut step);
    if !step.iter().all(|value| value.is_finite()) {
        return Ok(parts.len() + 1);
    }
    solution.iter_mut().zip(&step).for_each(|(solution, step)| *solution += step);
    let mut image = vec![0.0; rest.len()];
    map.apply(&step, &mut image)?;
    rest.iter_mut().zip(&image).for_each(|(rest, image)| *rest -= image);
    Ok(parts.len() + 1)
}

/// Solves the triangular system by back substitution.
fn back(columns: &[Vec<f64>], target: &[f64]) -> Vec<f64> {
    let mut parts = target[..columns.len()].to_vec();
    for k in (0..columns.len()).rev() {
        parts[k] /= columns[k][k];
        let part = parts[k];
        for (i, entry) in columns[k][..k].iter().enumerate() {
            parts[i] -= part * entry;
        }
    }
    parts
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(crate) fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    struct Dense(DMatrix<f64>);

    impl LinearMap for Dense {
        type Error = std::convert::Infallible;

        fn apply(&mut self, x: &[f64], y: &mut [f64]) -> Result<(), Self::Error> {
            y.copy_from_slice((&self.0 * DVector::from_row_slice(x)).as_slice());
            Ok(())
        }

        fn precondition(&mut self, y: &[f64], x: &mut [f64]) {
            x.iter_mut().zip(y).enumerate().for_each(|(i, (x, y))| *x = y / self.0[(i, i)]);
        }
    }

    /// No symmetry.
    #[test]
    fn a_dense_system_without_symmetry_is_solved() {
        let n = 400;
        let entry = |i: usize, j: usize| {
            let (i, j) = (i as f64, j as f64);
            if i == j { 3.0 + 0.1 * i } else { (1.3 * i - 2.1 * j).sin() / (1.0 + (i - j).abs()) }
        };
        let matrix = DMatrix::from_fn(n, n, entry);
        let wanted = DVector::from_fn(n, |i, _| (0.7 * i as f64).cos());
        let right = &matrix * &wanted;
        let mut got = vec![0.0; n];
        let left = solve(&mut Dense(matrix), right.as_slice(), &mut got, 1e-12, 1000).unwrap();
        assert!(left <= 1e-12, "{left:e}");
        assert!(got.iter().zip(&wanted).all(|(got, wanted)| (got - wanted).abs() < 1e-11));
    }
}
