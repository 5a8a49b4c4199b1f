//! The N-th decrease of chapter 6, as printed in (6.48).

/// A stored point of instantaneous adhesion `P_i`, at which the i-th decrease ended.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Level {
    zeta: f64,
    shift: f64,
    force: f64,
    /// `zeta_i*` of the decrease that ended here.
    star: f64,
    /// Sign of that decrease's traction, `-s_i`.
    sign: f64,
}

/// The load history of two spheres, by points of instantaneous adhesion.
///
/// Only for partial slip: steps into complete adhesion or gross sliding return `None` and leave the
/// state unchanged. Normalised as [`carom_laws::memory::Memory`].
///
/// ```
/// use carom_classic::history::sphere::SphereHistory;
/// use carom_laws::memory::ScalarMemory;
/// let mut literal = SphereHistory::new(1.0);
/// let mut memory = ScalarMemory::new();
/// memory.advance(1.0, 0.0)?;
/// for (zeta, x) in [(1.0, 0.6), (0.9, 0.2), (1.1, 0.5)] {
///     let force = literal.advance(zeta, x).ok_or("outside partial slip")?;
///     assert!((force - memory.advance(zeta, x)?).abs() < 1e-15);
/// }
/// assert_eq!(literal.decrease(), 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SphereHistory {
    levels: Vec<Level>,
    zeta: f64,
    shift: f64,
    force: f64,
    star: f64,
    sign: f64,
}

impl SphereHistory {
    /// A contact pressed to an approach, not yet shifted.
    #[must_use]
    pub const fn new(zeta: f64) -> Self {
        Self { levels: Vec::new(), zeta, shift: 0.0, force: 0.0, star: zeta, sign: 0.0 }
    }

    /// The number N of the present decrease.
    #[must_use]
    pub fn decrease(&self) -> usize {
        self.levels.len() + 1
    }

    /// `zeta_N*` of the present decrease.
    #[must_use]
    pub const fn star(&self) -> f64 {
        self.star
    }

    /// Advances to a new approach and shift. Returns the force, or `None` outside partial slip.
    pub fn advance(&mut self, zeta: f64, shift: f64) -> Option<f64> {
        let (dz, dx) = (zeta - self.zeta, shift - self.shift);
        if zeta <= 0.0 || dx.abs() < dz {
            return None;
        }
        let mut next = self.clone();
        // A new point of instantaneous adhesion (6.44), (6.51).
        if dx.abs() > dz.abs() && self.sign * dx < 0.0 {
            next.levels.push(Level {
                zeta: self.zeta,
                shift: self.shift,
                force: self.force,
                star: self.star,
                sign: self.sign,
            });
            next.sign = -self.sign;
        }
        let (star, force) = next.settle(zeta, shift)?;
        (next.zeta, next.shift, next.star, next.force) = (zeta, shift, star, force);
        *self = next;
        Some(force)
    }

    /// Drops the levels that are wiped out. Returns `zeta_N*` and the force.
    fn settle(&mut self, zeta: f64, shift: f64) -> Option<(f64, f64)> {
        let root = |z: f64| z * z.sqrt();
        loop {
            let Some(&last) = self.levels.last() else {
                // First decrease (6.14), of either sign.
                if shift != 0.0 {
                    self.sign = 1.0_f64.copysign(shift);
                }
                let star = zeta - shift.abs();
                return (star > 0.0).then(|| (star, self.sign * (root(zeta) - root(star))));
            };
            // (6.48e): xi_N = xi_{N-1} + f kappa s_N (2 zeta_N* - zeta_N - zeta_{N-1}), s = -sign.
            let star = 0.5 * (zeta + last.zeta - self.sign * (shift - last.shift));
            if star >= zeta {
                // The edge receded behind the slip annulus: its point is erased.
                self.sign = last.sign;
                self.levels.pop();
            } else if star <= last.star {
                // (N-2) law: two points are wiped out; after one, the opposite first decrease.
                self.levels.pop();
                if let Some(before) = self.levels.pop() {
                    self.sign = before.sign;
                }
            } else {
                // (6.48d)
                let force =
                    last.force + self.sign * (root(zeta) + root(last.zeta) - 2.0 * root(star));
                return Some((star, force));
            }
        }
    }
}
