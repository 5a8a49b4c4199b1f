//! Small dense matrices, as rows.

/// A matrix by rows.
pub(super) type Rows = Vec<Vec<f64>>;

pub(super) fn zeros(rows: usize, columns: usize) -> Rows {
    vec![vec![0.0; columns]; rows]
}

/// The product of two matrices.
pub(super) fn product(left: &Rows, right: &Rows) -> Rows {
    let columns = right.first().map_or(0, Vec::len);
    let mut out = zeros(left.len(), columns);
    for (row, into) in left.iter().zip(&mut out) {
        for (value, from) in row.iter().zip(right) {
            for (sum, x) in into.iter_mut().zip(from) {
                *sum += value * x;
            }
        }
    }
    out
}

/// `p left + q right`.
pub(super) fn combined(p: f64, left: &Rows, q: f64, right: &Rows) -> Rows {
    let row =
        |(a, b): (&Vec<f64>, &Vec<f64>)| a.iter().zip(b).map(|(x, y)| p * x + q * y).collect();
    left.iter().zip(right).map(row).collect()
}

/// The inverse, by Gauss-Jordan elimination with column pivoting.
pub(super) fn inverse(matrix: &Rows) -> Rows {
    let n = matrix.len();
    let mut a = matrix.clone();
    let mut out = zeros(n, n);
    for (i, row) in out.iter_mut().enumerate() {
        row[i] = 1.0;
    }
    for column in 0..n {
        let larger = |&i: &usize, &j: &usize| a[i][column].abs().total_cmp(&a[j][column].abs());
        let pivot = (column..n).max_by(larger).unwrap_or(column);
        a.swap(column, pivot);
        out.swap(column, pivot);
        let scale = 1.0 / a[column][column];
        a[column].iter_mut().chain(&mut out[column]).for_each(|x| *x *= scale);
        let (top_a, top_out) = (a[column].clone(), out[column].clone());
        for i in (0..n).filter(|&i| i != column) {
            let factor = a[i][column];
            a[i].iter_mut().zip(&top_a).for_each(|(x, top)| *x -= factor * top);
            out[i].iter_mut().zip(&top_out).for_each(|(x, top)| *x -= factor * top);
        }
    }
    out
}
