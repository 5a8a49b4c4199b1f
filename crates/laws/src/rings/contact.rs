//! The state of a contact of rings and its step, in normalised units.
//!
//! Lengths are such that the approach is a^2; shifts and displacements are over f, tractions over f
//! times the modulus (1 - nu)/G = 1, so that Hertz's pressure `(4/pi) sqrt(a^2 - r^2)` is their limit.
//! Vectors stand in the radial and circumferential direction. Twists are counter-clockwise.

use super::pair::Pair;
use super::solve::Tractions;
use super::transform::Field;

/// A ratio of steps above which slip is not looked ahead any further.
const FARTHEST: f64 = 2.0;

/// The contact since it touched.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Contact<const N: usize, const M: usize> {
    /// The contact radius; 0 where the bodies just touch.
    pub(super) radius: f64,
    /// What has slipped at each place, against the rigid shift and twist of now.
    pub(super) slip: Field<N, M>,
    /// As `slip`, at the rim.
    pub(super) rim: [[f64; 2]; M],
    pub(super) tractions: Tractions<N, M>,
    /// The length of the last step.
    pub(super) length: f64,
}

/// A step in normalised units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Step {
    pub(super) approach: f64,
    pub(super) approached: f64,
    pub(super) shifted: [f64; 2],
    pub(super) twisted: f64,
}

/// Loads in normalised units, tangential ones over f; and the heat of the step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Sums {
    pub(super) force: [f64; 2],
    pub(super) torque: f64,
    pub(super) normal: f64,
    pub(super) heat: f64,
    pub(super) stored: f64,
}

impl<const N: usize, const M: usize> Default for Contact<N, M> {
    fn default() -> Self {
        let none = [[[0.0; N]; 2]; M];
        let tractions = Tractions::default();
        Self { radius: 0.0, slip: none, rim: [[0.0; 2]; M], tractions, length: 0.0 }
    }
}

impl<const N: usize, const M: usize> Contact<N, M> {
    /// Goes straight to a positive approach; how many iterations that took.
    pub(super) fn advance(
        &mut self,
        pair: &Pair<N, M>,
        tolerance: f64,
        step: &Step,
    ) -> (usize, f64) {
        let radius = step.approach.sqrt();
        let square = step.approach;
        let way = |by: f64| by * by;
        let [x, y] = step.shifted;
        let length =
            (way(step.approached) + way(x) + way(y) + way(radius * step.twisted)).sqrt();
        let part = self.radius / radius;
        let by = self.ahead(length) * part * part;
        let ahead = self.tractions.y.map(|parts| parts.map(|ring| ring.map(|y| by * y)));
        // Slip before the step, on the rings of now.
        let mut before = match radius == self.radius {
            true => self.slip,
            // Nothing has slipped where the bodies just touch.
            false => pair.nodes.carried(&self.slip, &self.rim, radius / self.radius.max(f64::MIN_POSITIVE)),
        };
        let share = self.share(pair, radius);
        let enters = share[N - 1] > 0.0;
        let rim_spread = pair.spread * square * pair.spread_at_rim;
        let mut c = before;
        for (j, [cosine, sine]) in pair.directions.iter().enumerate() {
            let along = [x * cosine + y * sine, y * cosine - x * sine];
            for i in 0..N {
                let keeps = 1.0 - share[i];
                let turned = step.twisted * radius * pair.layout.radius[i];
                let [radial, around] = &mut before[j];
                radial[i] = keeps * (radial[i] - along[0]) + share[i] * rim_spread;
                around[i] = keeps * (around[i] - along[1] - turned);
                let spread = pair.spread * square * pair.layout.spread[i];
                c[j][0][i] = (spread - radial[i]) / square;
                c[j][1][i] = -around[i] / square;
            }
        }
        let count = pair.solve(&c, &ahead, enters.then_some(&share), tolerance, &mut self.tractions);
        let now = &self.tractions;
        let mut heat = 0.0;
        for j in 0..M {
            for d in 0..2 {
                for i in 0..N {
                    let slipped = square * pair.sigma[i] * now.y[j][d][i];
                    heat += pair.layout.area[i] * now.z[j][d][i] * slipped;
                    let from_rim = share[i] * square * now.rim[j][d];
                    self.slip[j][d][i] = before[j][d][i] - from_rim + slipped;
                }
            }
            self.rim[j] = [rim_spread - square * now.rim[j][0], -square * now.rim[j][1]];
        }
        (self.radius, self.length) = (radius, length);
        (count, heat * square * radius / M as f64)
    }

    /// The part of the rim's slip that each ring takes which comes into contact.
    #[inline]
    fn share(&self, pair: &Pair<N, M>, radius: f64) -> [f64; N] {
        let part = self.radius / radius;
        std::array::from_fn(|i| {
            if pair.layout.radius[i] <= part {
                return 0.0;
            }
            let old = part * part;
            ((pair.layout.square[i] - old) / (1.0 - old)).clamp(0.0, 1.0)
        })
    }

    /// By how much of the last slip this step begins ahead: of second order in the step.
    #[inline]
    fn ahead(&self, length: f64) -> f64 {
        if self.length == 0.0 {
            return 0.0;
        }
        let ratio = (length / self.length).min(FARTHEST);
        ratio * ratio / (1.0 + 2.0 * ratio)
    }

    /// Loads and stored energy of the tangential tractions.
    pub(super) fn sums(&self, pair: &Pair<N, M>) -> Sums {
        let mut sums = Sums::default();
        let (a, layout) = (self.radius, &pair.layout);
        for (j, [cosine, sine]) in pair.directions.iter().enumerate() {
            let [radial, around] = &self.tractions.z[j];
            let mut of = [0.0; 2];
            for i in 0..N {
                let area = layout.area[i];
                of[0] += area * radial[i];
                of[1] += area * around[i];
                sums.torque += area * layout.radius[i] * around[i];
                sums.normal += area * self.tractions.limit[j][i];
                let spread = pair.spread * a * a * layout.spread[i];
                let stretch = [spread - self.slip[j][0][i], -self.slip[j][1][i]];
                sums.stored += area * (radial[i] * stretch[0] + around[i] * stretch[1]);
            }
            sums.force[0] += cosine * of[0] - sine * of[1];
            sums.force[1] += sine * of[0] + cosine * of[1];
        }
        let part = a * a * a / M as f64;
        sums.force = sums.force.map(|f| part * f);
        sums.torque *= part * a;
        sums.normal *= part;
        sums.stored *= 0.5 * part;
        sums
    }
}
