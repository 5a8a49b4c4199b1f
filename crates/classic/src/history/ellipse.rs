//! The N-th decrease of chapter 7 in two directions, as printed in (7.55)-(7.64), corrected.

use carom_laws::memory::Lateral;

/// A slip annulus: the traction added from `star` to the edge.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Level {
    /// p_i.
    added: [f64; 2],
    /// `zeta_i*`.
    star: f64,
    /// The point `P_{i-1}` at which this decrease began.
    zeta: f64,
    shift: [f64; 2],
}

/// The load history of an elliptical contact, by points of instantaneous adhesion.
///
/// Only for partial slip: steps into complete adhesion or gross sliding return `None` and leave the
/// state unchanged. Normalised as [`carom_laws::memory::Memory`].
///
/// ```
/// use carom_classic::history::ellipse::EllipseHistory;
/// use carom_laws::memory::VectorMemory;
/// let mut literal = EllipseHistory::new(1.0);
/// let mut memory = VectorMemory::new();
/// memory.advance(1.0, [0.0, 0.0])?;
/// for (zeta, x) in [(1.0, [0.5, 0.0]), (1.0, [0.3, 0.2]), (0.9, [0.2, 0.3])] {
///     let force = literal.advance(zeta, x).ok_or("outside partial slip")?;
///     let want = memory.advance(zeta, x)?;
///     assert!((force[0] - want[0]).hypot(force[1] - want[1]) < 1e-14);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct EllipseHistory {
    levels: Vec<Level>,
    zeta: f64,
    shift: [f64; 2],
    force: [f64; 2],
}

impl EllipseHistory {
    /// A contact pressed to an approach, not yet shifted.
    #[must_use]
    pub const fn new(zeta: f64) -> Self {
        Self { levels: Vec::new(), zeta, shift: [0.0; 2], force: [0.0; 2] }
    }

    /// The number N of the present decrease.
    #[must_use]
    pub fn decrease(&self) -> usize {
        self.levels.len()
    }

    /// `zeta_N*` of the present decrease; zeta before any slip.
    #[must_use]
    pub fn star(&self) -> f64 {
        self.levels.last().map_or(self.zeta, |level| level.star)
    }

    /// Direction of the traction in the annulus of the first `n` levels, `-s_n`.
    fn traction(&self, n: usize) -> [f64; 2] {
        self.levels[..n].iter().fold([0.0; 2], |sum, level| sum.plus(level.added))
    }

    /// Advances to a new approach and shift. Returns the force, or `None` outside partial slip.
    pub fn advance(&mut self, zeta: f64, shift: [f64; 2]) -> Option<[f64; 2]> {
        let (dz, dx) = (zeta - self.zeta, shift.minus(self.shift));
        if zeta <= 0.0 || dx.length() < dz {
            return None;
        }
        let mut next = self.clone();
        let n = next.levels.len();
        // A new point P_N: |de - (zeta - zeta_N*) s_N| < zeta' - zeta_N*, s = -traction.
        let star = self.star();
        let arm = dx.plus(self.traction(n).times(self.zeta - star));
        let begins = n == 0 || (arm.length() < zeta - star && dx.length() > dz.abs());
        if begins {
            next.levels.push(Level {
                added: [0.0; 2],
                star: 0.0,
                zeta: self.zeta,
                shift: self.shift,
            });
        }
        next.settle(zeta, shift)?;
        let root = |z: f64| z * z.sqrt();
        let grow = |level: &Level| level.added.times(root(zeta) - root(level.star));
        next.force = next.levels.iter().fold([0.0; 2], |sum, level| sum.plus(grow(level)));
        (next.zeta, next.shift) = (zeta, shift);
        *self = next;
        Some(self.force)
    }

    /// Drops the levels that the present decrease overlays and finds its slip annulus.
    fn settle(&mut self, zeta: f64, shift: [f64; 2]) -> Option<()> {
        loop {
            let n = self.levels.len();
            if n <= 1 {
                // First decrease (7.5): p_1 = e/|e|, zeta_1* = zeta - |e|.
                let length = shift.length();
                let first = self.levels.first_mut()?;
                if length == 0.0 {
                    first.star = zeta;
                    return Some(());
                }
                first.added = shift.times(1.0 / length);
                first.star = zeta - length;
                return (first.star > 0.0).then_some(());
            }
            let running = self.levels[n - 1];
            let before = self.traction(n - 1);
            // d'' = e - e_P + s_{N-1} (zeta - zeta_P); zeta_N* = zeta - |d''|^2/(2 s_{N-1}.d'').
            let d = shift.minus(running.shift).minus(before.times(zeta - running.zeta));
            let double = -2.0 * before.dot(d);
            if double > 0.0 {
                let height = d.dot(d) / double;
                let star = zeta - height;
                if star > self.levels[n - 2].star {
                    let added = d.times(1.0 / height);
                    self.levels[n - 1] = Level { added, star, ..running };
                    return Some(());
                }
            }
            // The (N-1)-th decrease continues from its own point.
            self.levels.pop();
        }
    }
}
