//! Division of a contact of radius 1 into rings.

use std::f64::consts::PI;

use super::kernel;

/// Refinement towards the rim: 0 for rings of equal width, 1 for edges by a sine.
const CROWDING: f64 = 0.8;
/// Excess of the outer edge of the last ring over the contact radius, in widths of its part inside.
const WIDER: f64 = 0.13;

/// The rings of a contact of radius 1, and quantities that do not depend on the materials.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Layout<const N: usize> {
    /// Radii of the edges, from 0; the last lies outside the contact.
    pub(super) edges: Vec<f64>,
    /// Mean radius of each ring.
    pub(super) radius: [f64; N],
    /// Mean of the squared radius.
    pub(super) square: [f64; N],
    /// Area of each ring.
    pub(super) area: [f64; N],
    /// Mean of Hertz's pressure over each ring.
    pub(super) pressure: [f64; N],
    /// Mean radial displacement of each ring by Hertz's pressure.
    pub(super) spread: [f64; N],
}

impl<const N: usize> Layout<N> {
    pub(super) fn new() -> Self {
        let edge = |i: usize| {
            let t = i as f64 / N as f64;
            (1.0 - CROWDING) * t + CROWDING * libm::sin(0.5 * PI * t)
        };
        let mut edges: Vec<f64> = (0..N).map(edge).collect();
        let last = 1.0 - edges[N - 1];
        edges.push(1.0 + WIDER * last);
        let ring =
            |of: &dyn Fn(f64, f64) -> f64| std::array::from_fn(|i| of(edges[i], edges[i + 1]));
        let half_area = |low: f64, high: f64| 0.5 * (high - low) * (high + low);
        let load = |low: f64, high: f64| kernel::load_beyond(low) - kernel::load_beyond(high);
        let spread = |low, high| kernel::spread_of_hertz(high) - kernel::spread_of_hertz(low);
        Self {
            radius: ring(&|low, high| (high.powi(3) - low.powi(3)) / 3.0 / half_area(low, high)),
            square: ring(&|low, high| 0.5 * (low * low + high * high)),
            area: ring(&|low, high| 2.0 * PI * half_area(low, high)),
            pressure: ring(&|low, high| load(low, high) / (2.0 * PI * half_area(low, high))),
            spread: ring(&|low, high| 4.0 / (3.0 * PI) * spread(low, high) / half_area(low, high)),
            edges,
        }
    }
}

impl<const N: usize> Layout<N> {
    /// Mean of the cubed radius of a ring.
    pub(super) fn mean_cube(&self, ring: usize) -> f64 {
        let [low, high] = [self.edges[ring], self.edges[ring + 1]];
        0.4 * (high.powi(5) - low.powi(5)) / ((high - low) * (high + low))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn pressures_carry_hertzs_load() {
        let layout = Layout::<6>::new();
        let load: f64 = layout.area.iter().zip(&layout.pressure).map(|(a, p)| a * p).sum();
        assert_relative_eq!(load, 8.0 / 3.0, max_relative = 1e-14);
        // Each mean lies between the values at its edges.
        for i in 0..5 {
            let at = |r: f64| 4.0 / PI * (1.0 - r * r).sqrt();
            assert!(layout.pressure[i] < at(layout.edges[i]));
            assert!(layout.pressure[i] > at(layout.edges[i + 1]));
            let spread = layout.spread[i];
            assert!(spread < kernel::spread_at(layout.edges[i + 1]));
            assert!(i == 0 || spread > kernel::spread_at(layout.edges[i]));
        }
    }
}
