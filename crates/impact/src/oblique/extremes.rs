//! The largest and the smallest tangential force of an oblique impact.

use super::groups::Groups;
use super::impact::{ObliqueImpact, PSI_MIN};
use super::position::Position;
use super::regime::{ObliqueError, Regime};
use super::trace::TracePoint;

/// Instants at which an extreme is looked for first, and parts into which its surroundings are cut then.
const INSTANTS: usize = 512;
const PARTS: usize = 32;
/// Rounds of cutting: the place is then known to 1e-14.
const ROUNDS: usize = 8;
/// A force below this, in the unit of [`TracePoint::force`], is none.
const NO_FORCE: f64 = 1e-12;

impl ObliqueImpact {
    /// The instants of the largest and of the smallest (most negative) tangential force on body 1.
    ///
    /// The smallest is that of separation, 0, if the force never changes its sign. An extreme is a zero of the rate
    /// of the force, so that its time is known as well as its size: both to 1e-9, unless psi is below 1e-5 and not 0.
    ///
    /// ```
    /// use carom_impact::{normal, oblique::{Groups, ObliqueImpact}};
    /// // Sliding throughout: the force is f F_z, largest at the greatest compression.
    /// let groups = Groups::new(3.0, 6.0)?;
    /// let [most, least] = ObliqueImpact::force_extremes(groups)?;
    /// assert!((groups.psi() * most.force - 1.0).abs() < 1e-12);
    /// assert!((most.time - 0.5 * normal::DURATION).abs() < 1e-12 && least.force == 0.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ObliqueError`] as for [`ObliqueImpact::new`].
    pub fn force_extremes(groups: Groups) -> Result<[TracePoint; 2], ObliqueError> {
        let places = between([1.0, -1.0], INSTANTS);
        let points = at(groups, &places)?;
        Ok([extreme(groups, &places, &points, 1.0)?, extreme(groups, &places, &points, -1.0)?])
    }
}

/// Places of equal distances between two, by the coordinate tau of [`Position`]: close together in time near first
/// contact and separation, where a force may act for a moment only.
fn between([first, last]: [f64; 2], parts: usize) -> Vec<f64> {
    (0..=parts).map(|i| first + (last - first) * (i as f64 / parts as f64)).collect()
}

/// The points at these places.
fn at(groups: Groups, places: &[f64]) -> Result<Vec<TracePoint>, ObliqueError> {
    let velocities: Vec<f64> = places.iter().map(|&tau| Position::at(tau).w).collect();
    ObliqueImpact::trace(groups, &velocities)
}

/// The point of the largest force times `sign`.
fn extreme(
    groups: Groups,
    places: &[f64],
    points: &[TracePoint],
    sign: f64,
) -> Result<TracePoint, ObliqueError> {
    let size = |i: &usize| sign * points[*i].force;
    let last = points.len() - 1;
    let best = (1..last).max_by(|i, j| size(i).total_cmp(&size(j))).unwrap_or(last);
    if size(&best) < NO_FORCE {
        return Ok(points[last]);
    }
    let mut around = [places[best - 1], places[best + 1]];
    for _ in 0..ROUNDS {
        let places = between(around, PARTS);
        let rates = rates(groups, &places)?;
        let turn = rates[1..].iter().position(|rate| sign * rate <= 0.0).unwrap_or(PARTS - 1);
        around = [places[turn], places[turn + 1]];
    }
    let found = at(groups, &[0.5 * (around[0] + around[1])])?;
    Ok(found.first().copied().unwrap_or(points[best]))
}

/// The rate of the force at these places, but for positive factors.
fn rates(groups: Groups, places: &[f64]) -> Result<Vec<f64>, ObliqueError> {
    let points = at(groups, places)?;
    if groups.psi() >= PSI_MIN {
        return Ok(points.iter().map(|point| rate(groups, point)).collect());
    }
    let releasing = places.iter().rev().filter(|&&tau| tau < 0.0);
    let attached = at(groups, &releasing.map(|tau| -tau).collect::<Vec<_>>())?;
    let (loading, unloading) = points.split_at(points.len() - attached.len());
    let loading = loading.iter().map(|point| point.velocity);
    let unloading = unloading.iter().zip(attached.iter().rev()).map(release_without_slip);
    Ok(loading.chain(unloading).collect())
}

/// Two thirds of the rate of the force, in the units of [`TracePoint`].
///
/// The stick area follows the shift, and the slip annulus carries s f times the normal load on it:
/// F' = c_x sqrt(z*) (xi' - s f (c_z/c_x) zeta') + s f c_z sqrt(zeta) zeta'.
fn rate(groups: Groups, point: &TracePoint) -> f64 {
    let radius = point.compression.sqrt();
    let sign = match point.regime {
        Regime::Adhesion => return radius * point.velocity,
        Regime::SlipForward | Regime::SlideForward => 1.0,
        Regime::SlipBackward | Regime::SlideBackward => -1.0,
    };
    let stick = point.stick_depth.sqrt();
    let grip = sign * point.normal_velocity / groups.psi();
    stick * point.velocity + (radius - stick) * grip
}

/// The rate in the release of a contact that never slips, times a positive factor, from the state when the same annulus
/// was pressed on: it lets go of the traction by the shift since then,
/// F' = c_x (sqrt(zeta) xi' + (xi - xi_attached) zeta'/(2 sqrt(zeta))).
fn release_without_slip((point, attached): (&TracePoint, &TracePoint)) -> f64 {
    2.0 * point.compression * point.velocity
        + (point.shift - attached.shift) * point.normal_velocity
}
