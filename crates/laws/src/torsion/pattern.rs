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
/// `signs` are those of the rings of the rows, of which the last has none. Rows of rings that stick depend on rings
/// inside only: they take part from their own column on, so that in each column few rows do.
fn eliminate(matrix: &mut [f64], right: &mut [f64], signs: &[f64]) -> Option<Vec<f64>> {
    let m = right.len();
    let sticks = |row: usize| signs.get(row) == Some(&0.0);
    let mut active: Vec<usize> = (0..m).filter(|row| !sticks(*row)).collect();
    let mut pivots = Vec::with_capacity(m);
    let mut pivot_row = vec![0.0; m];
    for k in 0..m {
        if sticks(k) {
            active.push(k);
        }
        let size = |row: usize| matrix[row * m + k].abs();
        let place =
            (0..active.len()).max_by(|i, j| size(active[*i]).total_cmp(&size(active[*j])))?;
        let row = active.swap_remove(place);
        pivots.push(row);
        let pivot_row = &mut pivot_row[k..];
        pivot_row.copy_from_slice(&matrix[row * m + k..(row + 1) * m]);
        let (pivot, side) = (pivot_row[0], right[row]);
        if !(pivot != 0.0 && pivot.is_finite()) {
            return None;
        }
        for row in &active {
            let entries = &mut matrix[row * m + k..(row + 1) * m];
            let factor = entries[0] / pivot;
            for (entry, above) in entries.iter_mut().zip(&*pivot_row) {
                *entry -= factor * above;
            }
            right[*row] -= factor * side;
        }
    }
    let mut solution = vec![0.0; m];
    for (k, row) in pivots.into_iter().enumerate().rev() {
        let entries = &matrix[row * m + k..(row + 1) * m];
        let known = dot(&entries[1..], &solution[k + 1..]);
        solution[k] = (right[row] - known) / entries[0];
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
        for every in [2, 3, 5, 30] {
            let signs: Vec<f64> = (0..m - 1).map(|i| f64::from(u8::from(i % every == 1))).collect();
            let matrix: Vec<f64> = (0..m * m)
                .map(|at| {
                    let (row, column) = (at / m, at % m);
                    let value = random();
                    if signs.get(row) == Some(&0.0) && column < row { 0.0 } else { value }
                })
                .collect();
            let want: Vec<f64> = (0..m).map(|_| random()).collect();
            let mut right: Vec<f64> = matrix
                .chunks_exact(m)
                .map(|row| row.iter().zip(&want).map(|(a, b)| a * b).sum())
                .collect();
            let got = eliminate(&mut matrix.clone(), &mut right, &signs).expect("regular");
            for (got, want) in got.iter().zip(&want) {
                assert!((got - want).abs() < 1e-9, "{every}: {got} {want}");
            }
        }
    }
}
