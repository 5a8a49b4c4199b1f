//! Coulomb's law on rings: tractions within their limits, and slip only where the limits are
//! reached.

use super::rings::{Rings, dot};

/// Greatest number of guesses of the slipping rings before Gauss-Seidel is used, and of its sweeps.
const GUESSES: usize = 60;
const SWEEPS: usize = 5000;
/// The sweeps end when tractions change by less than this fraction of their limits.
const TOLERANCE: f64 = 1e-7;

/// Changes of the densities, from the edge inwards, and the slipping rings.
pub(super) struct RingSolution {
    pub(super) changes: Vec<f64>,
    /// Change of the twist inside the rings; zero if the innermost ring sticks.
    pub(super) core: f64,
    /// +1 or -1 for rings that slip, 0 for those that stick.
    pub(super) slips: Vec<f64>,
}

impl Rings {
    /// The state after the twist of all discs has changed by `turned`, from the densities before;
    /// `None` if neither method converges.
    pub(super) fn turn(&self, densities: &[f64], turned: f64) -> Option<RingSolution> {
        let before = self.tractions(densities);
        let (tractions, slips) = Friction::new(self, &before, turned).solve()?;
        let changes: Vec<f64> = tractions.iter().zip(&before).map(|(now, old)| now - old).collect();
        let changes = self.densities(&changes);
        let core = turned - self.twist(&changes);
        Some(RingSolution { changes, core, slips })
    }
}

/// A step of the rings: all are rotated by `turned`, and the tractions resist by their compliance.
pub(super) struct Friction<'a> {
    rings: &'a Rings,
    limits: &'a [f64],
    before: &'a [f64],
    turned: f64,
    /// Rotation of a ring due to the tractions of all rings, computed when needed.
    rows: Vec<Option<Vec<f64>>>,
}

impl<'a> Friction<'a> {
    pub(super) fn new(rings: &'a Rings, before: &'a [f64], turned: f64) -> Self {
        let limits = rings.limits();
        Self { rings, limits, before, turned, rows: vec![None; limits.len()] }
    }

    /// Tractions divided by radius, and the signs of slip.
    pub(super) fn solve(&mut self) -> Option<(Vec<f64>, Vec<f64>)> {
        self.by_guesses().or_else(|| self.by_sweeps())
    }

    /// Guesses which rings stick, solves for their tractions and corrects the guess until it is
    /// consistent: a few systems of equations.
    fn by_guesses(&mut self) -> Option<(Vec<f64>, Vec<f64>)> {
        let n = self.limits.len();
        let mut signs: Vec<f64> = (0..n).map(|i| self.over(i, self.before[i])).collect();
        let mut next = vec![0.0; n];
        for _ in 0..GUESSES {
            let now = self.stick(&signs)?;
            let slips = self.rings.slips_by_tractions(&self.changes(&now), self.turned);
            for (i, next) in next.iter_mut().enumerate() {
                *next = match signs[i] {
                    0.0 => self.over(i, now[i]),
                    sign if sign * slips[i] > 0.0 => sign,
                    _ => 0.0,
                };
            }
            if next == signs {
                return Some((now, signs));
            }
            std::mem::swap(&mut next, &mut signs);
        }
        None
    }

    /// Tractions of the sticking rings by elimination; slipping rings are at their limits.
    fn stick(&mut self, signs: &[f64]) -> Option<Vec<f64>> {
        let n = signs.len();
        let sticking: Vec<usize> = (0..n).filter(|&i| signs[i] == 0.0).collect();
        self.ask_for(&sticking);
        let mut now: Vec<f64> = (0..n)
            .map(|i| if signs[i] == 0.0 { self.before[i] } else { signs[i] * self.limits[i] })
            .collect();
        let changes = self.changes(&now);
        let m = sticking.len();
        let mut rest: Vec<f64> = Vec::with_capacity(m);
        let mut matrix: Vec<f64> = Vec::with_capacity(m * m);
        for &i in &sticking {
            let row = self.rows[i].as_deref()?;
            rest.push(self.turned - dot(row, &changes));
            matrix.extend(sticking.iter().map(|&k| row[k]));
        }
        eliminate(&mut matrix, &mut rest)?;
        for (&i, change) in sticking.iter().zip(&rest) {
            now[i] += change;
        }
        Some(now)
    }

    /// Gauss-Seidel sweeps; each ring sticks or reaches its friction limit.
    fn by_sweeps(&mut self) -> Option<(Vec<f64>, Vec<f64>)> {
        let n = self.limits.len();
        self.ask_for(&(0..n).collect::<Vec<_>>());
        let mut now: Vec<f64> =
            (0..n).map(|i| self.before[i].clamp(-self.limits[i], self.limits[i])).collect();
        let mut changes = self.changes(&now);
        for _ in 0..SWEEPS {
            let mut greatest = 0.0_f64;
            for i in 0..n {
                let row = self.rows[i].as_deref()?;
                let slip = self.turned - dot(row, &changes);
                let next = (now[i] + slip / row[i]).clamp(-self.limits[i], self.limits[i]);
                greatest = greatest.max((next - now[i]).abs() / self.limits[i]);
                now[i] = next;
                changes[i] = next - self.before[i];
            }
            if greatest <= TOLERANCE {
                let at_limit = |i: usize| now[i].abs() >= self.limits[i];
                let signs = (0..n).map(|i| if at_limit(i) { now[i].signum() } else { 0.0 });
                let signs = signs.collect();
                return Some((now, signs));
            }
        }
        None
    }

    fn ask_for(&mut self, rings: &[usize]) {
        for &i in rings {
            self.rows[i].get_or_insert_with(|| self.rings.compliance(i));
        }
    }

    fn changes(&self, now: &[f64]) -> Vec<f64> {
        now.iter().zip(self.before).map(|(now, before)| now - before).collect()
    }

    /// The sign of a traction beyond its limit.
    fn over(&self, i: usize, traction: f64) -> f64 {
        if traction.abs() > self.limits[i] { traction.signum() } else { 0.0 }
    }
}

/// Elimination without pivoting: the compliances are nearly symmetric and positive definite.
fn eliminate(matrix: &mut [f64], right: &mut [f64]) -> Option<()> {
    let m = right.len();
    for k in 0..m {
        let (upper, lower) = matrix.split_at_mut((k + 1) * m);
        let pivot_row = &upper[k * m + k..];
        let pivot = pivot_row[0];
        if !(pivot > 0.0 && pivot.is_finite()) {
            return None;
        }
        for (below, row) in lower.chunks_exact_mut(m).enumerate() {
            let factor = row[k] / pivot;
            for (entry, above) in row[k..].iter_mut().zip(pivot_row) {
                *entry -= factor * above;
            }
            right[k + 1 + below] -= factor * right[k];
        }
    }
    for k in (0..m).rev() {
        let row = &matrix[k * m..(k + 1) * m];
        let known = dot(&row[k + 1..], &right[k + 1..]);
        right[k] = (right[k] - known) / row[k];
    }
    Some(())
}
