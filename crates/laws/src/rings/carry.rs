//! Slip carried along with rings that move: cubic interpolation over the radius.

use super::transform::Field;

/// The largest number of rings.
pub(super) const MOST_RINGS: usize = 24;

/// Four neighbours of a place and their weights.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Stencil {
    first: usize,
    weights: [f64; 4],
}

/// The nodes of a contact of radius 1: two rings beyond the middle, the rings, the rim.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Nodes<const N: usize> {
    at: [f64; MOST_RINGS + 3],
}

impl<const N: usize> Nodes<N> {
    pub(super) fn new(radius: &[f64; N]) -> Self {
        const { assert!(N >= 3 && N <= MOST_RINGS, "3 to 24 rings") }
        let mut at = [1.0; MOST_RINGS + 3];
        at[0] = -radius[1];
        at[1] = -radius[0];
        at[2..N + 2].copy_from_slice(radius);
        Self { at }
    }

    #[inline]
    fn stencil(&self, x: f64) -> Stencil {
        // Between nodes j + 1 and j + 2 of the stencil, where there are as many.
        let first = (0..N - 1).take_while(|&j| self.at[j + 2] <= x).last().unwrap_or(0);
        let at: [f64; 4] = std::array::from_fn(|k| self.at[first + k]);
        let [a, b, c, d] = at.map(|node| x - node);
        let weights = [
            b * c * d / ((at[0] - at[1]) * (at[0] - at[2]) * (at[0] - at[3])),
            a * c * d / ((at[1] - at[0]) * (at[1] - at[2]) * (at[1] - at[3])),
            a * b * d / ((at[2] - at[0]) * (at[2] - at[1]) * (at[2] - at[3])),
            a * b * c / ((at[3] - at[0]) * (at[3] - at[1]) * (at[3] - at[2])),
        ];
        Stencil { first, weights }
    }

    /// The field on rings whose radii have changed by a factor, from the field and its values on the
    /// old rim; rings outside the old contact take those of the rim.
    #[inline]
    pub(super) fn carried<const M: usize>(
        &self,
        field: &Field<N, M>,
        rim: &[[f64; 2]; M],
        factor: f64,
    ) -> Field<N, M> {
        let mut stencils = [Stencil::default(); N];
        for (stencil, node) in stencils.iter_mut().zip(&self.at[2..]) {
            let x = node * factor;
            *stencil = if x >= 1.0 {
                Stencil { first: N - 1, weights: [0.0, 0.0, 0.0, 1.0] }
            } else {
                self.stencil(x)
            };
        }
        let mut out = [[[0.0; N]; 2]; M];
        let mut line = [0.0; MOST_RINGS + 3];
        for (j, parts) in out.iter_mut().enumerate() {
            for (c, part) in parts.iter_mut().enumerate() {
                // Beyond the middle both directions of the frame are reversed.
                let across = &field[(j + M / 2) % M][c];
                line[0] = -across[1];
                line[1] = -across[0];
                line[2..N + 2].copy_from_slice(&field[j][c]);
                line[N + 2] = rim[j][c];
                for (value, Stencil { first, weights }) in part.iter_mut().zip(&stencils) {
                    let near = &line[*first..first + 4];
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
    use crate::rings::transform::directions;

    #[test]
    fn a_cubic_field_is_carried_exactly() {
        let layout = Layout::<6>::new();
        let nodes = Nodes::new(&layout.radius);
        let turns = directions::<8>();
        // A vector field of second order in x and y, in the turning frame.
        let at = |r: f64, [c, s]: [f64; 2]| {
            let (x, y) = (r * c, r * s);
            let (u, v) = (0.3 + x - 2.0 * y + x * y, 0.1 + y * y * y - x);
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
        for factor in [1.0, 1.01, 0.97, 0.5, 0.02, 1.6] {
            let got = nodes.carried(&field_at(1.0), &rim, factor);
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
