//! Displacements by ring tractions: integrals of `W(m, n) = int_0^inf J_m(k r) J_n(k r') dk` over rings.

use std::f64::consts::PI;

use carom_special::gamma::{gamma, reciprocal};

/// Number of terms of the first partial sum of a series that is extrapolated, and number of its doublings.
const FIRST: usize = 16;
const DOUBLINGS: usize = 9;
/// Relative size of a term below which a series is cut off.
const SMALL: f64 = 1e-17;
const MOST_TERMS: usize = 200_000;

/// W(m, n) for r > r': `(1/r) sum_j c_j (r'/r)^(n + 2 j)`, the integral of Weber and Schafheitlin (DLMF
/// 10.22.56). For odd m - n only the cases that contacts need are implemented: m = n + 1 with a single term,
/// and m = n - 1, which vanishes.
#[derive(Debug, Clone, Copy)]
struct Outer {
    m: usize,
    n: usize,
}

impl Outer {
    /// The terms (c_j, n + 2 j).
    fn terms(self) -> impl Iterator<Item = (f64, f64)> {
        let (m, n) = (self.m as f64, self.n as f64);
        let (a, b) = (0.5 * (m + n + 1.0), 0.5 * (n - m + 1.0));
        let mut next = gamma(a) * reciprocal(n + 1.0) * reciprocal(0.5 * (m - n + 1.0));
        (0..MOST_TERMS).map(move |j| {
            let now = next;
            let j = j as f64;
            next *= (a + j) * (b + j) / ((n + 1.0 + j) * (j + 1.0));
            (now, n + 2.0 * j)
        })
    }

    /// The sum over all terms, times a factor that decreases as 1/p or faster.
    fn whole(self, factor: impl Fn(f64) -> f64) -> f64 {
        if self.m.abs_diff(self.n) % 2 == 1 {
            return self.terms().next().map_or(0.0, |(c, p)| c * factor(p));
        }
        // The remainder has a series in 1/J: Richardson extrapolation.
        let mut terms = self.terms().map(|(c, p)| c * factor(p));
        let mut sum = 0.0;
        let mut row: Vec<f64> = Vec::with_capacity(DOUBLINGS);
        for level in 0..DOUBLINGS {
            let count = if level == 0 { FIRST } else { FIRST << (level - 1) };
            sum += terms.by_ref().take(count).sum::<f64>();
            let mut better = sum;
            for (order, old) in row.iter_mut().enumerate() {
                let part = 1.0 / ((2_u64 << order) as f64 - 1.0);
                (*old, better) = (better, better + (better - *old) * part);
            }
            row.push(better);
        }
        row.last().copied().unwrap_or(0.0)
    }

    /// The sum of `c_j t^(p + shift) factor(p)` for t below 1.
    fn partly(self, t: f64, shift: f64, factor: impl Fn(f64) -> f64) -> f64 {
        let mut power = libm::pow(t, self.n as f64 + shift);
        let mut sum = 0.0;
        for (c, p) in self.terms() {
            let term = c * power * factor(p);
            sum += term;
            if c == 0.0 || (p > 4.0 && term.abs() <= SMALL * sum.abs()) {
                break;
            }
            power *= t * t;
        }
        sum
    }

    /// The contribution of r > r' to `int_0^outer r dr int_0^inner r' dr' W`.
    fn double(self, outer: f64, inner: f64) -> f64 {
        if inner >= outer {
            return outer * outer * outer / 3.0 * self.whole(|p| 1.0 / (p + 2.0));
        }
        let skip = |p: f64, value: f64| if p == 1.0 { 0.0 } else { value };
        let cube = inner * inner * inner;
        let t = inner / outer;
        if t == 0.0 {
            return 0.0;
        }
        let level = self.whole(|p| skip(p, 1.0 / (3.0 * (p - 1.0))));
        let rest = self.partly(t, -1.0, |p| skip(p, 1.0 / ((p - 1.0) * (p + 2.0))));
        // The term p = 1 gives a logarithm.
        let first = self.terms().next().filter(|&(_, p)| p == 1.0);
        let logarithm = first.map_or(0.0, |(c, _)| c / 3.0 * (1.0 / 3.0 - libm::log(t)));
        cube * (level - rest + logarithm)
    }

    /// The contribution of r' < r to `int_0^to r' dr' W(r, r')`.
    fn below(self, r: f64, to: f64) -> f64 {
        if to >= r {
            return r * self.whole(|p| 1.0 / (p + 2.0));
        }
        r * self.partly(to / r, 2.0, |p| 1.0 / (p + 2.0))
    }

    /// `int_low^to r dr W(r, low)` with the source at `low`: the contribution of r > r'.
    fn above(self, low: f64, to: f64) -> f64 {
        if to <= low {
            return 0.0;
        }
        let t = low / to;
        let skip = |p: f64| if p == 1.0 { 0.0 } else { 1.0 / (p - 1.0) };
        let level = self.whole(skip);
        let rest = self.partly(t, -1.0, skip);
        let first = self.terms().next().filter(|&(_, p)| p == 1.0);
        let logarithm = first.map_or(0.0, |(c, _)| -c * libm::log(t));
        low * (level - rest + logarithm)
    }
}

/// `int_0^outer r dr int_0^inner r' dr' W(m, n)`.
fn of_discs([m, n]: [usize; 2], r: f64, other: f64) -> f64 {
    if r == 0.0 || other == 0.0 {
        return 0.0;
    }
    Outer { m, n }.double(r, other) + Outer { m: n, n: m }.double(other, r)
}

/// `int_0^to r' dr' W(m, n)(r, r')`.
fn of_disc([m, n]: [usize; 2], r: f64, to: f64) -> f64 {
    if to == 0.0 {
        return 0.0;
    }
    Outer { m, n }.below(r, to) + Outer { m: n, n: m }.above(r, to)
}

/// The mean displacement of ring i, weighted by radius, by a unit traction on ring j.
pub(super) fn between_rings(orders: [usize; 2], edges: &[f64]) -> Vec<Vec<f64>> {
    let corner: Vec<Vec<f64>> = edges
        .iter()
        .map(|&r| edges.iter().map(|&other| of_discs(orders, r, other)).collect())
        .collect();
    let rings = edges.len() - 1;
    (0..rings)
        .map(|i| {
            let half_area = 0.5 * (edges[i + 1] - edges[i]) * (edges[i + 1] + edges[i]);
            (0..rings)
                .map(|j| {
                    let outer = corner[i + 1][j + 1] - corner[i + 1][j];
                    (outer - (corner[i][j + 1] - corner[i][j])) / half_area
                })
                .collect()
        })
        .collect()
}

/// The displacement at a radius by a unit traction on each ring.
pub(super) fn at_radius(orders: [usize; 2], r: f64, edges: &[f64]) -> Vec<f64> {
    let discs: Vec<f64> = edges.iter().map(|&to| of_disc(orders, r, to)).collect();
    discs.windows(2).map(|pair| pair[1] - pair[0]).collect()
}

/// `int_0^rho [1 - (1 - x^2)^(3/2)] dx`; the integrand is 1 beyond x = 1.
pub(super) fn spread_of_hertz(rho: f64) -> f64 {
    let x = rho.min(1.0);
    let root = ((1.0 - x) * (1.0 + x)).max(0.0).sqrt();
    rho - (x * (5.0 - 2.0 * x * x) * root + 3.0 * libm::asin(x)) / 8.0
}

/// The part of Hertz's load outside a radius: `(8/3) (1 - rho^2)^(3/2)` over the circle.
pub(super) fn load_beyond(rho: f64) -> f64 {
    let left = ((1.0 - rho) * (1.0 + rho)).max(0.0);
    8.0 / 3.0 * left * left.sqrt()
}

/// The radial displacement by Hertz's pressure at a radius, contact of radius 1.
pub(super) fn spread_at(rho: f64) -> f64 {
    let left = ((1.0 - rho) * (1.0 + rho)).max(0.0);
    4.0 / (3.0 * PI * rho) * (1.0 - left * left.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use carom_special::quadrature::GaussLegendre;

    /// W(n, n) at r and r', by the integral over the angle between them: `W(n, n) = (1/pi) int_0^pi cos(n
    /// t)/d dt`, where d is the distance.
    fn equal_orders(n: usize, r: f64, other: f64) -> f64 {
        GaussLegendre::new(80).unwrap().integrate(0.0, PI, |angle| {
            let half = libm::sin(0.5 * angle);
            let d = ((r - other) * (r - other) + 4.0 * r * other * half * half).sqrt();
            libm::cos(n as f64 * angle) / d
        }) / PI
    }

    #[test]
    fn rings_of_equal_orders_are_those_of_the_potential() {
        let rule = GaussLegendre::new(24).unwrap();
        let edges = [0.0, 0.4, 0.7, 1.0];
        for n in 0..4 {
            let got = between_rings([n, n], &edges);
            let want = rule.integrate(0.7, 1.0, |r| {
                rule.integrate(0.0, 0.4, |other| r * other * equal_orders(n, r, other))
            });
            let half_area = 0.5 * (1.0 - 0.49);
            assert_relative_eq!(got[2][0], want / half_area, max_relative = 1e-9);
            // Reciprocity: exchanging two rings gives the same value times the ratio of their areas.
            assert_relative_eq!(got[2][0] * half_area, got[0][2] * 0.08, max_relative = 1e-11);
        }
    }

    #[test]
    fn a_disc_of_unit_pressure_has_the_known_displacement_in_its_middle_and_on_its_rim() {
        // u = (1/(2 pi)) int p/d: 1 at the centre of a unit disc, 2/pi on its rim.
        let rim: f64 = at_radius([0, 0], 1.0, &[0.0, 0.5, 1.0]).iter().sum();
        assert_relative_eq!(rim, 2.0 / PI, max_relative = 1e-12);
        let inside: f64 = at_radius([0, 0], 1e-9, &[0.0, 1e-9, 0.3, 1.0]).iter().sum();
        assert_relative_eq!(inside, 1.0, max_relative = 1e-9);
        let mean = between_rings([0, 0], &[0.0, 1.0])[0][0];
        assert_relative_eq!(mean, 8.0 / (3.0 * PI), max_relative = 1e-12);
    }

    #[test]
    fn a_mean_over_a_narrow_ring_is_the_value_there() {
        let edges = [0.0, 0.3, 0.47, 0.499, 0.501, 0.53, 0.8];
        for orders in
            [[0, 0], [1, 1], [2, 0], [0, 2], [3, 1], [1, 0], [0, 1], [2, 3], [2, 1], [1, 2]]
        {
            let means = between_rings(orders, &edges);
            let here = at_radius(orders, 0.5, &edges);
            for j in [0, 1, 5] {
                assert_relative_eq!(means[3][j], here[j], max_relative = 1e-4, epsilon = 1e-8);
            }
        }
    }

    #[test]
    fn orders_that_differ_by_two_are_those_of_the_quadrupole() {
        // W(2, 0)(r, r') = (1/pi) int cos(2 phi)/d dt, where phi is the angle between the direction from
        // source to point and that of the point.
        let (r, other) = (0.9, 0.35);
        let want = GaussLegendre::new(80).unwrap().integrate(0.0, PI, |angle| {
            let (x, y) = (r - other * libm::cos(angle), -other * libm::sin(angle));
            (x * x - y * y) / (x * x + y * y).powf(1.5)
        }) / PI;
        let width = 1e-4;
        let ring = [0.0, other - width, other + width, 1.0];
        let got = at_radius([2, 0], r, &ring)[1] / (2.0 * other * width);
        assert_relative_eq!(got, want, max_relative = 1e-6);
    }
}
