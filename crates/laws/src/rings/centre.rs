//! The way of the centre of a contact of dissimilar bodies.
//!
//! Tangential tractions lift the normal surface by `v(r) cos(theta)`; about a fixed centre the pressure of this harmonic
//! is singular at the rim. Bodies that may part have no such pressure: the circle moves by delta instead, and about the
//! new centre
//!
//! ```text
//! K0 p_1 = v - delta r,   p_1 without a singular part,   a^2 = approach - delta^2/2
//! ```
//!
//! With the pressure `P = K0^-1 v` about the fixed centre, the tilt `T = K0^-1 r`, which is singular as `r/sqrt(1 - r^2)`,
//! and the smooth `S = K0^-1 (r - 3 r^3/4)`, which vanishes at the rim as `r sqrt(1 - r^2)`, delta is what remains of P
//! on the two outermost rings: `P = delta T + c S`. All are in units of the radius. Slip stays at places of the bodies:
//! it is carried to the rings about the new centre.

use super::dense::Rows;
use super::influence::Harmonic;
use super::layout::Layout;

/// The largest way over the radius: beyond it the bodies part on one side.
const FARTHEST: f64 = 0.5;
const ROUNDING: f64 = 1e-12;

/// How the circle follows normal displacements.
#[derive(Debug)]
pub(super) struct Centre {
    /// The inverse of the harmonic 1 without singular pressures.
    pub(super) normal_inverse: Rows,
    /// The way by the lift of each ring.
    pub(super) way: Vec<f64>,
}

impl Centre {
    /// With the inverse of the harmonic 1 about a fixed centre.
    pub(super) fn new<const N: usize>(inverse: &Rows, layout: &Layout<N>) -> Self {
        let by = |lift: &dyn Fn(usize) -> f64| -> Vec<f64> {
            inverse
                .iter()
                .map(|row| row.iter().enumerate().map(|(i, x)| x * lift(i)).sum())
                .collect()
        };
        let tilt = by(&|i| layout.radius[i]);
        let smooth = by(&|i| layout.radius[i] - 0.75 * layout.mean_cube(i));
        let [inner, outer] = [N - 2, N - 1];
        let scale = 1.0 / (tilt[outer] * smooth[inner] - tilt[inner] * smooth[outer]);
        let parts = inverse[outer].iter().zip(&inverse[inner]);
        let way: Vec<f64> =
            parts.map(|(o, i)| scale * (o * smooth[inner] - i * smooth[outer])).collect();
        let less = |row: &Vec<f64>, tilt: &f64| {
            row.iter().zip(&way).map(|(x, way)| x - tilt * way).collect()
        };
        let normal_inverse = inverse.iter().zip(&tilt).map(|(row, tilt)| less(row, tilt)).collect();
        Self { normal_inverse, way }
    }

    /// The harmonics with the inverse about the moving centre.
    pub(super) fn of_moving(&self, harmonics: &[Harmonic]) -> Vec<Harmonic> {
        let mut out = harmonics.to_vec();
        if let Some(first) = out.get_mut(1) {
            first.normal_inverse.clone_from(&self.normal_inverse);
        }
        out
    }
}

/// The way over the radius, at most [`FARTHEST`].
pub(super) fn bounded([x, y]: [f64; 2]) -> [f64; 2] {
    let size = libm::hypot(x, y);
    if size <= FARTHEST { [x, y] } else { [x, y].map(|part| part * FARTHEST / size) }
}

/// Whether a contact of this approach can have this centre.
pub(super) fn fits([x, y]: [f64; 2], approach: f64) -> bool {
    x * x + y * y <= (1.0 + ROUNDING) * FARTHEST * FARTHEST * approach
}

/// The square of the radius about a centre.
pub(super) fn square([x, y]: [f64; 2], approach: f64) -> f64 {
    approach - 0.5 * (x * x + y * y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rings::influence::Influence;

    /// The way by the mean of a power of r over rings, and the pressures that are left of it.
    fn by<const N: usize>(lift: impl Fn(&Layout<N>, usize) -> f64) -> (f64, Vec<f64>) {
        let influence = Influence::<N>::shared(8);
        let lift: Vec<f64> = (0..N).map(|i| lift(&influence.layout, i)).collect();
        let dot = |row: &Vec<f64>| row.iter().zip(&lift).map(|(x, lift)| x * lift).sum();
        let centre = &influence.centre;
        (dot(&centre.way), centre.normal_inverse.iter().map(dot).collect())
    }

    #[test]
    fn a_tilt_moves_the_centre_and_leaves_no_pressure() {
        let (way, pressures) = by::<8>(|layout, i| layout.radius[i]);
        assert!((way - 1.0).abs() < 1e-12, "{way}");
        assert!(pressures.iter().all(|p| p.abs() < 1e-12), "{pressures:?}");
    }

    #[test]
    fn a_lift_in_proportion_to_the_cube_moves_the_centre_by_four_thirds() {
        // r - 3 r^3/4 has a pressure that vanishes at the rim, in proportion to r sqrt(1 - r^2).
        let (way, pressures) = by::<8>(|layout, i| layout.mean_cube(i));
        assert!((way - 4.0 / 3.0).abs() < 1e-12, "{way}");
        assert!(pressures[7].abs() < 0.6 * pressures[5].abs(), "{pressures:?}");
    }

    /// The fifth power asks for another smooth pressure, which two rings tell from the singular one the better the finer.
    #[test]
    fn the_way_by_a_fifth_power_is_eight_fifths() {
        let fifth = |edges: &[f64], i: usize| {
            let [low, high] = [edges[i], edges[i + 1]];
            2.0 / 7.0 * (high.powi(7) - low.powi(7)) / ((high - low) * (high + low))
        };
        let (coarse, _) = by::<8>(|layout, i| fifth(&layout.edges, i));
        let (fine, _) = by::<16>(|layout, i| fifth(&layout.edges, i));
        let [coarse, fine] = [coarse, fine].map(|way| (way - 1.6).abs());
        assert!(coarse < 0.03 && fine < 0.5 * coarse, "{coarse} {fine}");
    }

    #[test]
    fn a_way_is_at_most_half_of_the_radius() {
        assert_eq!(bounded([0.3, -0.4]), [0.3, -0.4]);
        assert_eq!(bounded([3.0, -4.0]), [0.3, -0.4]);
        assert!(fits([0.3, -0.4], 1.0) && !fits([0.3, -0.41], 1.0) && !fits([f64::NAN, 0.0], 1.0));
    }
}
