//! Coulomb's law on rings: tractions within their limits, and slip only where the limits are
//! reached.

use super::pattern::Pattern;
use super::rings::{Rings, dot};

/// Greatest number of guesses of the slipping rings before Gauss-Seidel is used, and of its sweeps.
const GUESSES: usize = 60;
const SWEEPS: usize = 5000;
/// The sweeps end when tractions change by less than this fraction of their limits.
const TOLERANCE: f64 = 1e-7;

/// Changes of the densities, from the edge inwards, and the slipping rings.
pub(super) struct RingSolution {
    pub(super) changes: Vec<f64>,
    /// Change of the twist inside the rings; negligible if the innermost ring sticks.
    pub(super) core: f64,
    /// +1 or -1 for rings that slip, 0 for those that stick.
    pub(super) slips: Vec<f64>,
}

impl Rings<'_> {
    /// The state after the twist of all discs has changed by `turned`, from the densities before;
    /// `None` if neither method converges. `slips`, the signs of a solution with one slip annulus, is where the
    /// search begins.
    pub(super) fn turn(
        &self,
        densities: &[f64],
        turned: f64,
        slips: &[f64],
    ) -> Option<RingSolution> {
        let before = self.tractions(densities);
        let friction = Friction { rings: self, limits: self.limits(), before: &before, turned };
        friction.by_guesses(slips).or_else(|| friction.by_sweeps())
    }
}

/// A step of the rings: all are rotated by `turned`, and the tractions resist by their compliance.
struct Friction<'a> {
    rings: &'a Rings<'a>,
    limits: &'a [f64],
    before: &'a [f64],
    turned: f64,
}

impl Friction<'_> {
    /// Guesses which rings stick, solves for the densities and corrects the guess until it is
    /// consistent: a few systems of equations.
    fn by_guesses(&self, slips: &[f64]) -> Option<RingSolution> {
        let n = self.limits.len();
        let mut pattern = Pattern::new(self.rings);
        let over = |(i, slip): (usize, &f64)| match self.over(i, self.before[i]) {
            0.0 => *slip,
            sign => sign,
        };
        let mut signs: Vec<f64> = slips.iter().enumerate().map(over).collect();
        let mut next = vec![0.0; n];
        for _ in 0..GUESSES {
            let rests = |i: usize| signs[i] * self.limits[i] - self.before[i];
            let (changes, core) = pattern.solve(&signs, rests, self.turned)?;
            let added = self.rings.tractions(&changes);
            for (i, next) in next.iter_mut().enumerate() {
                *next = match signs[i] {
                    0.0 => self.over(i, self.before[i] + added[i]),
                    sign if sign * self.rings.slip(i, &changes, core) > 0.0 => sign,
                    _ => 0.0,
                };
            }
            if next == signs {
                return Some(RingSolution { changes, core, slips: signs });
            }
            std::mem::swap(&mut next, &mut signs);
        }
        None
    }

    /// Gauss-Seidel sweeps; each ring sticks or reaches its friction limit.
    fn by_sweeps(&self) -> Option<RingSolution> {
        let n = self.limits.len();
        let rows: Vec<Vec<f64>> = (0..n).map(|i| self.rings.compliance(i)).collect();
        let mut now: Vec<f64> =
            (0..n).map(|i| self.before[i].clamp(-self.limits[i], self.limits[i])).collect();
        let mut changes: Vec<f64> =
            now.iter().zip(self.before).map(|(now, old)| now - old).collect();
        for _ in 0..SWEEPS {
            let mut greatest = 0.0_f64;
            for (i, row) in rows.iter().enumerate() {
                let slip = self.turned - dot(row, &changes);
                let next = (now[i] + slip / row[i]).clamp(-self.limits[i], self.limits[i]);
                greatest = greatest.max((next - now[i]).abs() / self.limits[i]);
                now[i] = next;
                changes[i] = next - self.before[i];
            }
            if greatest <= TOLERANCE {
                let at_limit = |i: usize| now[i].abs() >= self.limits[i];
                let signs = (0..n).map(|i| if at_limit(i) { now[i].signum() } else { 0.0 });
                let changes = self.rings.densities(&changes);
                let core = self.turned - self.rings.twist(&changes);
                return Some(RingSolution { changes, core, slips: signs.collect() });
            }
        }
        None
    }

    /// The sign of a traction beyond its limit.
    fn over(&self, i: usize, traction: f64) -> f64 {
        if traction.abs() > self.limits[i] { traction.signum() } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::super::mesh::{Mesh, WIDEST_LEVEL};
    use super::*;

    /// Turned to and fro, the rings slip by the same whichever method finds it.
    #[test]
    fn sweeps_find_what_guesses_find() {
        let mesh = Mesh::new(1.0, 0.5, 1.0, WIDEST_LEVEL);
        let (rings, n) = (Rings::new(&mesh), mesh.len());
        let mut densities = vec![0.0; n];
        for turned in [0.05, -0.12, 0.11, -0.4] {
            let before = rings.tractions(&densities);
            let friction =
                Friction { rings: &rings, limits: rings.limits(), before: &before, turned };
            let guessed = friction.by_guesses(&vec![0.0; n]).unwrap();
            let swept = friction.by_sweeps().unwrap();
            assert_eq!(swept.slips, guessed.slips, "{turned}");
            assert!(guessed.slips.iter().any(|slip| *slip != 0.0), "{turned}");
            let [one, two] = [&guessed, &swept].map(|found| rings.tractions(&found.changes));
            for ((one, two), limit) in one.iter().zip(two).zip(rings.limits()) {
                assert!((one - two).abs() < 1e-5 * limit, "{turned}: {one} {two}");
            }
            assert!((guessed.core - swept.core).abs() < 1e-5, "{turned}");
            densities.iter_mut().zip(&guessed.changes).for_each(|(own, by)| *own += by);
        }
    }
}
