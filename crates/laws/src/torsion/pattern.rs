//! The densities of rings of which it is known which of them slip.
//!
//! A slipping ring has the traction of its limit, to which only the densities of itself and outside
//! contribute; a sticking ring has no slip, to which only those of itself and inside contribute. Inside
//! all slip the changes of density are therefore those that one of them causes, by which the core inside
//! the rings turns: they decrease quickly inwards. What remains are as many equations as there
//! are rings from the outermost that sticks to the innermost that slips.

use super::rings::{Rings, dot};

/// Solves for the changes of density.
pub(super) struct Pattern<'a> {
    rings: &'a Rings<'a>,
    /// The changes of density inside all slip if the core turns by 1, for any number of rings.
    calm: Vec<f64>,
    matrix: Vec<f64>,
}

/// The rings inside all slip, per unknown: the twist of the core and the densities.
struct Inside {
    core: f64,
    densities: Vec<f64>,
}

impl<'a> Pattern<'a> {
    pub(super) fn new(rings: &'a Rings<'a>) -> Self {
        let n = rings.mesh().len();
        let mut calm = vec![0.0; n];
        for i in (0..n).rev() {
            let (own, row) = rings.slips_of(i);
            calm[i] = -(1.0 + dot(row, &calm[i + 1..])) / own;
        }
        Self { rings, calm, matrix: Vec::new() }
    }

    /// The changes of the densities and of the twist inside, if rings with a sign slip and their tractions
    /// change by `rests`; all discs turn by `turned`. `None` if the equations have no solution.
    pub(super) fn solve(
        &mut self,
        signs: &[f64],
        rests: impl Fn(usize) -> f64,
        turned: f64,
    ) -> Option<(Vec<f64>, f64)> {
        let n = signs.len();
        let slipping = signs.iter().rposition(|sign| *sign != 0.0).map_or(0, |i| i + 1);
        let lead = signs.iter().position(|sign| *sign == 0.0).unwrap_or(n);
        let mut changes = Vec::with_capacity(n);
        for i in 0..lead {
            let (row, own) = self.rings.tractions_of(i);
            changes.push((rests(i) - dot(row, &changes)) / own);
        }
        let inside = self.inside(slipping);
        let mut right = self.equations(signs, &changes, slipping, &inside, rests, turned);
        let mut unknown =
            eliminate(&mut self.matrix, &mut right, &signs[lead..slipping.max(lead)])?;
        let last = unknown.pop()?;
        changes.append(&mut unknown);
        changes.extend(inside.densities.iter().map(|density| density * last));
        let core = inside.core * last;
        (core.is_finite() && changes.iter().all(|change| change.is_finite()))
            .then_some((changes, core))
    }

    /// The rings from this one inwards, by the density of the first, or the core alone.
    fn inside(&self, from: usize) -> Inside {
        match self.calm.get(from) {
            Some(first) => Inside {
                core: 1.0 / first,
                densities: self.calm[from..].iter().map(|density| density / first).collect(),
            },
            None => Inside { core: 1.0, densities: Vec::new() },
        }
    }

    /// Fills the matrix for the rings after those whose changes are known, up to `slipping`, and for what is
    /// inside. Returns the right sides.
    fn equations(
        &mut self,
        signs: &[f64],
        known: &[f64],
        slipping: usize,
        inside: &Inside,
        rests: impl Fn(usize) -> f64,
        turned: f64,
    ) -> Vec<f64> {
        let lead = known.len();
        let size = slipping.saturating_sub(lead) + 1;
        let mut right = Vec::with_capacity(size);
        self.matrix.clear();
        self.matrix.resize(size * size, 0.0);
        let mut rows = self.matrix.chunks_exact_mut(size);
        for (i, row) in (lead..slipping).zip(&mut rows) {
            if signs[i] == 0.0 {
                let (own, slips) = self.rings.slips_of(i);
                let (outer, inner) = slips.split_at(slipping - i - 1);
                row[i - lead] = own;
                row[i - lead + 1..size - 1].copy_from_slice(outer);
                row[size - 1] = inside.core + dot(inner, &inside.densities);
                right.push(0.0);
            } else {
                let (tractions, own) = self.rings.tractions_of(i);
                let (of_known, rest) = tractions.split_at(lead);
                row[..i - lead].copy_from_slice(rest);
                row[i - lead] = own;
                right.push(rests(i) - dot(of_known, known));
            }
        }
        // The twist of all discs.
        let mut widths = self.rings.mesh().widths();
        let twisted: f64 =
            known.iter().zip(&mut widths).map(|(change, width)| change * width).sum();
        for row in rows {
            for (entry, width) in row[..size - 1].iter_mut().zip(&mut widths) {
                *entry = width;
            }
            let rings = inside.densities.iter().zip(&mut widths);
            row[size - 1] =
                inside.core + rings.map(|(density, width)| density * width).sum::<f64>();
        }
        right.push(turned - twisted);
        right
    }
}

/// Solves by elimination with pivoting of rows.
///
/// `signs` are those of the rings of the rows; the last row has none. Rows of rings that stick depend on themselves and
/// what is inside, those of rings that slip on themselves and what is outside. Columns are taken from outside if fewer
/// rings slip, else from inside, so that the other rows take part from their own column on: in each column few rows do.
fn eliminate(matrix: &mut [f64], right: &mut [f64], signs: &[f64]) -> Option<Vec<f64>> {
    let m = right.len();
    let slipping = signs.iter().filter(|sign| **sign != 0.0).count();
    let from_inside = 2 * slipping > signs.len();
    let waits = |row: usize| signs.get(row).is_some_and(|sign| (*sign != 0.0) == from_inside);
    let column = |step: usize| if from_inside { m - 1 - step } else { step };
    let others = |k: usize| if from_inside { 0..k } else { k + 1..m };
    let mut active: Vec<usize> = (0..m).filter(|row| !waits(*row)).collect();
    let mut pivots = Vec::with_capacity(m);
    let mut above = vec![0.0; m];
    for k in (0..m).map(column) {
        if waits(k) {
            active.push(k);
        }
        let size = |place: &usize| active.get(*place).map_or(0.0, |row| matrix[row * m + k].abs());
        let place = (0..active.len()).max_by(|i, j| size(i).total_cmp(&size(j)))?;
        let row = active.swap_remove(place);
        let above = &mut above[others(k)];
        above.copy_from_slice(&matrix[row * m..(row + 1) * m][others(k)]);
        let (pivot, side) = (matrix[row * m + k], right[row]);
        if !(pivot != 0.0 && pivot.is_finite()) {
            return None;
        }
        pivots.push((k, row));
        for row in &active {
            let entries = &mut matrix[row * m..(row + 1) * m];
            let factor = entries[k] / pivot;
            for (entry, above) in entries[others(k)].iter_mut().zip(&*above) {
                *entry -= factor * above;
            }
            right[*row] -= factor * side;
        }
    }
    let mut solution = vec![0.0; m];
    for (k, row) in pivots.into_iter().rev() {
        let entries = &matrix[row * m..(row + 1) * m];
        let known = dot(&entries[others(k)], &solution[others(k)]);
        solution[k] = (right[row] - known) / entries[k];
    }
    Some(solution)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elimination_solves_equations_of_sticking_and_slipping_rings() {
        let m = 24;
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        for slips in 0..24 {
            let signs: Vec<f64> = (0..m - 1)
                .map(|_| if random() * 23.0 + 11.5 < f64::from(slips) { 1.0 } else { 0.0 })
                .collect();
            // Rings that stick depend on what is inside, those that slip on what is outside.
            let depends = |row: usize, column: usize| match signs.get(row) {
                Some(0.0) => column >= row,
                Some(_) => column <= row,
                None => true,
            };
            let matrix: Vec<f64> =
                (0..m * m).map(|at| if depends(at / m, at % m) { random() } else { 0.0 }).collect();
            let want: Vec<f64> = (0..m).map(|_| random()).collect();
            let product = |row: &[f64]| row.iter().zip(&want).map(|(a, b)| a * b).sum();
            let mut right: Vec<f64> = matrix.chunks_exact(m).map(product).collect();
            let got = eliminate(&mut matrix.clone(), &mut right, &signs).expect("regular");
            for (got, want) in got.iter().zip(&want) {
                assert!((got - want).abs() < 1e-9, "{slips}: {got} {want}");
            }
        }
    }
}
