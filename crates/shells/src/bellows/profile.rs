//! Shape and stresses along the meridian.

use super::fields::Point;
use super::grid::Grid;
use crate::Wall;

/// A place of the wall between crest and root: where it is and what it carries. The stress at the
/// outer face is membrane + bending, at the inner face membrane - bending.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallPoint {
    /// The parameter xi, from 0 at the crest to pi at the root.
    pub parameter: f64,
    /// Distance from the axis in this state.
    pub radius: f64,
    /// Height above the crest in this state.
    pub height: f64,
    /// u, the growth of the radius.
    pub radial_displacement: f64,
    /// beta, the growth of the angle of the meridian.
    pub rotation: f64,
    /// Membrane stress along the meridian, N_s/t.
    pub meridional_membrane: f64,
    /// Bending stress along the meridian, 6 M_s/t^2.
    pub meridional_bending: f64,
    /// Hoop membrane stress, N_t/t.
    pub hoop_membrane: f64,
    /// Hoop bending stress, 6 M_t/t^2.
    pub hoop_bending: f64,
}

/// The points of a state from crest to root.
pub(super) fn profile(grid: &Grid, wall: &Wall, points: &[Point]) -> Vec<WallPoint> {
    let growth: Vec<f64> = points.iter().map(Point::growth).collect();
    let order = grid.circle.count() - 1;
    let growth = grid.circle.even(&growth, order);
    // Integral of sum f_k cos k xi. The last coefficient stands for half of the highest wave.
    let waves: Vec<f64> = (1..order).map(|k| growth.coefficient(k) / k as f64).collect();
    let risen = grid.circle.sine_sum(&waves);
    let (t, e) = (wall.thickness(), wall.young_modulus());
    let at = |(j, point): (usize, &Point)| WallPoint {
        parameter: grid.circle.angle(j),
        radius: t * point.r,
        height: t
            * (grid.places[j].height + growth.coefficient(0) * grid.circle.angle(j) + risen[j]),
        radial_displacement: t * point.u,
        rotation: point.beta,
        meridional_membrane: e * point.n_s(),
        meridional_bending: 6.0 * e * point.m_s,
        hoop_membrane: e * point.n_t,
        hoop_bending: 6.0 * e * point.m_t,
    };
    points.iter().enumerate().map(at).collect()
}
