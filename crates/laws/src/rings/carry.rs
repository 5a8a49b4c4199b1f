//! Transport of slip with rings that move: interpolation over the radius with six neighbours.
//!
//! With four neighbours, errors of repeated interpolation doubled the error of paths of 800 steps against
//! those of 100.

use super::symmetry::Symmetry;
use super::transform::Field;

/// The largest number of rings.
pub(super) const MOST_RINGS: usize = 24;
/// Number of neighbours in an interpolation.
const NEAR: usize = 6;
/// Number of rings mirrored beyond the centre.
const BEYOND: usize = NEAR / 2;
/// Largest number of nodes: those beyond the centre, the rings, the rim.
const NODES: usize = BEYOND + MOST_RINGS + 1;

/// The neighbours of a radius and their weights.
#[derive(Debug, Clone, Copy)]
struct Stencil {
    first: usize,
    weights: [f64; NEAR],
}

/// The nodes of a contact of radius 1: rings mirrored beyond the centre, the rings, the rim.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Nodes<const N: usize> {
    at: [f64; NODES],
    /// For each first neighbour, the constant factors of the Lagrange polynomials.
    factors: Vec<[f64; NEAR]>,
}

impl<const N: usize> Nodes<N> {
    pub(super) fn new(radius: &[f64; N]) -> Self {
        const { assert!(N >= 4 && N <= MOST_RINGS, "4 to 24 rings") }
        let mut at = [1.0; NODES];
        for i in 0..BEYOND {
            at[i] = -radius[BEYOND - 1 - i];
        }
        at[BEYOND..N + BEYOND].copy_from_slice(radius);
        let factor = |first: usize, k: usize| {
            let others = (0..NEAR).filter(|&m| m != k);
            1.0 / others.map(|m| at[first + k] - at[first + m]).product::<f64>()
        };
        let factors =
            (0..=Self::last()).map(|first| std::array::from_fn(|k| factor(first, k))).collect();
        Self { at, factors }
    }

    /// The last possible first neighbour, next to the rim.
    const fn last() -> usize {
        N + BEYOND + 1 - NEAR
    }

    /// The stencil of a radius; `near` is a first neighbour nearby, where the search starts.
    #[inline]
    fn stencil(&self, x: f64, near: usize) -> Stencil {
        let mut first = near.min(Self::last());
        while first < Self::last() && self.at[first + NEAR / 2] <= x {
            first += 1;
        }
        while first > 0 && self.at[first + NEAR / 2 - 1] > x {
            first -= 1;
        }
        let off: [f64; NEAR] = std::array::from_fn(|k| x - self.at[first + k]);
        let mut weights = self.factors[first];
        let (mut below, mut above) = (1.0, 1.0);
        for k in 0..NEAR {
            weights[k] *= below;
            below *= off[k];
            weights[NEAR - 1 - k] *= above;
            above *= off[NEAR - 1 - k];
        }
        Stencil { first, weights }
    }

    /// The stencil of a radius, inside or outside.
    #[inline]
    fn stencil_or_rim(&self, x: f64, near: usize) -> Stencil {
        if x < 1.0 {
            return self.stencil(x.max(self.at[0]), near);
        }
        let mut weights = [0.0; NEAR];
        weights[NEAR - 1] = 1.0;
        Stencil { first: Self::last(), weights }
    }

    /// The field on rings whose radii have changed by a factor, interpolated from the old field and its
    /// values at the old rim; at each angle from `outwards` further outside, if given. Rings outside the old contact take
    /// the values at the rim.
    #[inline]
    pub(super) fn carried<const H: usize, S: Symmetry<H>>(
        &self,
        field: &Field<N, H>,
        rim: &[[f64; 2]; H],
        factor: f64,
        outwards: Option<&[f64; H]>,
    ) -> Field<N, H> {
        let stencils_at = |further: f64| -> [Stencil; N] {
            let at = |i: usize| self.at[BEYOND + i] * factor + further;
            std::array::from_fn(|i| self.stencil_or_rim(at(i), i))
        };
        let mut stencils = stencils_at(outwards.map_or(0.0, |outwards| outwards[0]));
        let mut out = [[[0.0; N]; 2]; H];
        let mut line = [0.0; NODES];
        for (j, parts) in out.iter_mut().enumerate() {
            let (opposite, signs) = S::opposite(j);
            if let Some(outwards) = outwards {
                stencils = stencils_at(outwards[j]);
            }
            for (c, part) in parts.iter_mut().enumerate() {
                // Beyond the centre both directions of the polar frame are reversed.
                let across = &field[opposite][c];
                for i in 0..BEYOND {
                    line[i] = -signs[c] * across[BEYOND - 1 - i];
                }
                line[BEYOND..N + BEYOND].copy_from_slice(&field[j][c]);
                line[N + BEYOND] = rim[j][c];
                for (value, Stencil { first, weights }) in part.iter_mut().zip(&stencils) {
                    let near = &line[*first..first + NEAR];
                    *value = weights.iter().zip(near).map(|(w, x)| w * x).sum();
                }
            }
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rings::layout::Layout;
    use crate::rings::symmetry::Whole;
    use crate::rings::transform::directions;

    #[test]
    fn a_smooth_field_is_carried_exactly() {
        let layout = Layout::<6>::new();
        let nodes = Nodes::new(&layout.radius);
        let turns = directions::<8>();
        // A vector field of fifth order in x and y, in polar components.
        let at = |r: f64, [c, s]: [f64; 2]| {
            let (x, y) = (r * c, r * s);
            let (u, v) = (0.3 + x - 2.0 * y + x * y, 0.1 + y * y * y * x * x - x);
            [c * u + s * v, c * v - s * u]
        };
        let field_at = |factor: f64| -> Field<6, 8> {
            std::array::from_fn(|j| {
                std::array::from_fn(|c| {
                    std::array::from_fn(|i| at(factor * layout.radius[i], turns[j])[c])
                })
            })
        };
        let rim: [[f64; 2]; 8] = std::array::from_fn(|j| at(1.0, turns[j]));
        for factor in [1.0, 1.01, 0.97, 0.5, 0.02, 1e-9, 1.6] {
            let got = nodes.carried::<8, Whole>(&field_at(1.0), &rim, factor, None);
            let want = field_at(factor);
            for j in 0..8 {
                for i in 0..6 {
                    let outside = factor * layout.radius[i] >= 1.0;
                    for c in 0..2 {
                        let want = if outside { rim[j][c] } else { want[j][c][i] };
                        assert!((got[j][c][i] - want).abs() < 1e-13, "{factor} {j} {i}");
                    }
                }
            }
        }
    }
}
