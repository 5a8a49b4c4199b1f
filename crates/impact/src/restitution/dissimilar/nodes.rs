//! Where the table has its entries, and interpolation between them.
//!
//! | coordinate | nodes | interpolation |
//! |---|---|---|
//! | Gamma/(Gamma + 1.5), Gamma = gamma/f from 0 to 12 | 25, equal distances | cubic, four nodes |
//! | lambda/(lambda + 2), lambda from 0 to 8 | 25, equal distances | cubic, four nodes |
//! | D_xx/D_zz from 1 to 6 | 9, Chebyshev's | by all |
//! | kappa from 1 to 1.5 | 5, Chebyshev's | by all |
//! | gamma^2 over its largest, that of (1.5 - kappa)^2 and Gamma^2 (f = 1) | 4, Chebyshev's | by all |

use super::groups::DissimilarGroups;
use wide::f64x4;

pub(super) const SPREADS: usize = 25;
pub(super) const LAMBDAS: usize = 25;
pub(super) const RATIOS: usize = 9;
pub(super) const KAPPAS: usize = 5;
pub(super) const SQUARES: usize = 4;
/// Entries of one Gamma, one lambda and one ratio.
const LINE: usize = KAPPAS * SQUARES;
/// Entries of one Gamma and one lambda.
pub(super) const PLANE: usize = RATIOS * LINE;
/// Pairs of Gamma and lambda that count between entries.
const PLANES: usize = 4 * 4;
/// All entries: by Gamma, lambda, ratio, kappa and gamma^2, the last fastest.
pub(super) const ENTRIES: usize = SPREADS * LAMBDAS * PLANE;

const MOST_SPREAD: f64 = 12.0;
const MOST_LAMBDA: f64 = 8.0;
const MIDDLE_SPREAD: f64 = 1.5;
const MIDDLE_LAMBDA: f64 = 2.0;
const RATIO: [f64; 2] = [1.0, 6.0];
const KAPPA: [f64; 2] = [1.0, 1.5];
/// What rounding may add to gamma^2 over its largest.
const ROUNDING: f64 = 1e-9;

/// The arguments of an entry: kappa, gamma, friction, lambda and D_xx/D_zz.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Node {
    pub(super) kappa: f64,
    pub(super) gamma: f64,
    /// None where Gamma = 0.
    pub(super) friction: Option<f64>,
    pub(super) lambda: f64,
    pub(super) ratio: f64,
}

impl Node {
    /// That of an entry.
    pub(super) fn of(entry: usize) -> Self {
        let (square, entry) = (entry % SQUARES, entry / SQUARES);
        let (kappa, entry) = (entry % KAPPAS, entry / KAPPAS);
        let (ratio, entry) = (entry % RATIOS, entry / RATIOS);
        let (lambda, spread) = (entry % LAMBDAS, entry / LAMBDAS);
        let even = |i: usize, count: usize, most: f64, middle: f64| {
            let part = i as f64 / (count - 1) as f64 * (most / (most + middle));
            part * middle / (1.0 - part)
        };
        let spread = even(spread, SPREADS, MOST_SPREAD, MIDDLE_SPREAD);
        let kappa = within(KAPPA, points::<KAPPAS>()[kappa]);
        let part = within([0.0, 1.0], points::<SQUARES>()[square]);
        let gamma = part.sqrt() * (KAPPA[1] - kappa).min(spread);
        Self {
            kappa,
            gamma,
            friction: (spread > 0.0).then(|| gamma / spread),
            lambda: even(lambda, LAMBDAS, MOST_LAMBDA, MIDDLE_LAMBDA),
            ratio: within(RATIO, points::<RATIOS>()[ratio]),
        }
    }
}

/// A place from -1 to 1 in a range.
fn within([low, high]: [f64; 2], x: f64) -> f64 {
    0.5 * ((high + low) + (high - low) * x)
}

/// The place from -1 to 1 of a value; none beyond.
fn place([low, high]: [f64; 2], value: f64) -> Option<f64> {
    let holds = value >= low && value <= high;
    holds.then(|| (2.0 * value - (high + low)) / (high - low))
}

/// Chebyshev's points.
fn points<const N: usize>() -> [f64; N] {
    std::array::from_fn(|i| -libm::cos((i as f64 + 0.5) * std::f64::consts::PI / N as f64))
}

/// What each of N points counts at a place: Lagrange's polynomials.
#[inline]
fn weights<const N: usize>(points: &[f64; N], factors: &[f64; N], x: f64) -> [f64; N] {
    let mut weights = *factors;
    let (mut below, mut above) = (1.0, 1.0);
    for k in 0..N {
        weights[k] *= below;
        below *= x - points[k];
        let last = N - 1 - k;
        weights[last] *= above;
        above *= x - points[last];
    }
    weights
}

/// The constant factors of Lagrange's polynomials.
fn factors<const N: usize>(points: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|k| {
        let others = (0..N).filter(|&m| m != k);
        1.0 / others.map(|m| points[k] - points[m]).product::<f64>()
    })
}

/// The four nodes about a part from 0 to 1 of equal distances, and what each counts.
#[inline]
fn near<const COUNT: usize>(part: f64) -> (usize, [f64; 4]) {
    let x = part * (COUNT - 1) as f64;
    let first = (x as usize).saturating_sub(1).min(COUNT - 4);
    let t = x - first as f64;
    let [a, b, c, d] = [t, t - 1.0, t - 2.0, t - 3.0];
    (first, [-b * c * d / 6.0, 0.5 * a * c * d, -0.5 * a * b * d, a * b * c / 6.0])
}

/// Points and factors of the coordinates with Chebyshev's points.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Nodes {
    ratio: [[f64; RATIOS]; 2],
    kappa: [[f64; KAPPAS]; 2],
    square: [[f64; SQUARES]; 2],
}

impl Nodes {
    pub(super) fn new() -> Self {
        let (ratio, kappa, square) = (points(), points(), points());
        Self {
            ratio: [ratio, factors(&ratio)],
            kappa: [kappa, factors(&kappa)],
            square: [square, factors(&square)],
        }
    }

    /// The value between entries, less `part` of the value at Gamma = 0; none out of their range.
    pub(super) fn value(
        &self,
        entries: &[f64],
        groups: &DissimilarGroups,
        part: f64,
    ) -> Option<f64> {
        let spread = groups.spread();
        if spread > MOST_SPREAD || groups.lambda > MOST_LAMBDA || groups.friction.get() > 1.0 {
            return None;
        }
        let ratio = place(RATIO, groups.ratio)?;
        // Computed from nu, 3/2 may come out above itself by round-off.
        let kappa = groups.kappa.min(KAPPA[1]);
        let most = (KAPPA[1] - kappa).min(spread);
        let kappa = place(KAPPA, kappa)?;
        // Where materials leave no choice of gamma any will do.
        let of_most = if most > 0.0 { groups.gamma / most } else { 0.0 };
        let square = of_most * of_most;
        let square = if square <= 1.0 + ROUNDING { square.min(1.0) } else { return None };
        let square = place([0.0, 1.0], square)?;
        let even = |value: f64, most: f64, middle: f64| {
            (value / (value + middle) * ((most + middle) / most)).min(1.0)
        };
        let (spread, by_spread) = near::<SPREADS>(even(spread, MOST_SPREAD, MIDDLE_SPREAD));
        let (lambda, by_lambda) = near::<LAMBDAS>(even(groups.lambda, MOST_LAMBDA, MIDDLE_LAMBDA));
        // Four by four entries of the table.
        let mut planes = [(&[0.0; PLANE], 0.0); PLANES];
        let pairs = (spread..)
            .zip(by_spread)
            .flat_map(|at| (lambda..).zip(by_lambda).map(move |to| (at, to)));
        for (plane, ((spread, of_spread), (lambda, of_lambda))) in planes.iter_mut().zip(pairs) {
            let first = (spread * LAMBDAS + lambda) * PLANE;
            let entries = entries.get(first..first + PLANE)?;
            *plane = (entries.try_into().ok()?, of_spread * of_lambda);
        }
        let first = lambda * PLANE;
        let alike = entries.get(first..first + 4 * PLANE)?;
        Some(self.across(
            &planes,
            (alike, by_lambda.map(|own| -part * own)),
            [ratio, kappa, square],
        ))
    }

    /// The weighted sum of planes at places of the other coordinates. Inside its caller its sums would leave the registers.
    #[inline(never)]
    fn across(
        &self,
        planes: &[(&[f64; PLANE], f64); PLANES],
        (alike, by_lambda): (&[f64], [f64; 4]),
        [ratio, kappa, square]: [f64; 3],
    ) -> f64 {
        let by_ratio = weights(&self.ratio[0], &self.ratio[1], ratio);
        let by_kappa = weights(&self.kappa[0], &self.kappa[1], kappa);
        let by_square = weights(&self.square[0], &self.square[1], square);
        // There are registers for all sums.
        let mut rows = [f64x4::ZERO; KAPPAS];
        for (i, of_ratio) in by_ratio.into_iter().enumerate() {
            let mut sums = [f64x4::ZERO; KAPPAS];
            for (plane, weight) in planes {
                let entries = &plane.as_chunks::<SQUARES>().0[i * KAPPAS..(i + 1) * KAPPAS];
                for (sum, row) in sums.iter_mut().zip(entries) {
                    *sum += *weight * f64x4::new(*row);
                }
            }
            // At Gamma = 0 all entries by gamma^2 are the same.
            for (k, sum) in sums.iter_mut().enumerate() {
                let own = |l: usize| by_lambda[l] * alike[l * PLANE + (i * KAPPAS + k) * SQUARES];
                *sum += f64x4::splat(own(0) + own(1) + own(2) + own(3));
            }
            rows.iter_mut().zip(sums).for_each(|(all, sum)| *all += of_ratio * sum);
        }
        rows.into_iter()
            .zip(by_kappa)
            .map(|(row, weight)| {
                let by_square = row.to_array().into_iter().zip(by_square);
                weight * by_square.map(|(x, w)| x * w).sum::<f64>()
            })
            .sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_lies_between_the_middle_two_of_its_four_nodes() {
        for i in 0..=480 {
            let part = f64::from(i) / 480.0;
            let (first, [below, low, high, above]) = near::<25>(part);
            let x = part * 24.0;
            if (1.0..=23.0).contains(&x) {
                // Lagrange's cubic weights have these signs there and nowhere else.
                assert!(below <= 0.0 && low >= 0.0 && high >= 0.0 && above <= 0.0, "{part}");
            }
            // A cubic is met.
            let cube = |k: usize| ((first + k) as f64).powi(3);
            let met = below * cube(0) + low * cube(1) + high * cube(2) + above * cube(3);
            assert!((met - x.powi(3)).abs() < 1e-10 * 24_f64.powi(3), "{part}");
        }
    }
}
