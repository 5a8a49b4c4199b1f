//! The energy dissipated by slip.
//!
//! In the units of [`super::history`] the elastic energy is `(3/2) int s^2 u^2 ds` and the torque
//! `3 int s^2 u ds`, with `u(s) = int_s^al b ds`. The work of a step minus the increase of the
//! energy is `3 int s^2 u (dbh - du) ds`. Where the contact sticks du = dbh; in a slip annulus
//! outside c, u is `sign B(s; al)` with `dB/dal = (2/pi) K`. With the depth v = ln(al/c) a step
//! therefore dissipates `al^4 [p(v) sign dbh - g(v) dal]`, where `p = (6/pi) int_0^v exp(-3 x) (K -
//! E) dx` and `g = (12/pi^2) int_0^v exp(-3 x) (K - E) K dx` at `k' = exp(-x)`.

use carom_special::quadrature::FixedRule;

use super::front::Front;
use super::history::{SlipPath, TwistHistory};
use super::mesh::Mesh;
use super::sliding::{heat_of_growth, heat_of_twist, mean_of_fourth_powers};

/// Gauss nodes and weights on (0, 1).
const GAUSS: [(f64, f64); 6] = FixedRule::parts();

/// An observer of the parts of a step.
pub(super) trait Meter {
    /// Whether it needs the states.
    const LOOKS: bool;

    /// A path between two states.
    fn follows(&mut self, before: &TwistHistory, after: &TwistHistory, way: SlipPath);
    /// A part that was solved by rings.
    fn slides(&mut self, heat: RingHeat<'_>);
    /// The history of a contact so small that it no longer counts.
    fn forgets(&mut self, last: &TwistHistory);
}

/// Ignores all parts.
pub(super) struct Unmetered;

impl Meter for Unmetered {
    const LOOKS: bool = false;

    fn follows(&mut self, _: &TwistHistory, _: &TwistHistory, _: SlipPath) {}
    fn slides(&mut self, _: RingHeat<'_>) {}
    fn forgets(&mut self, _: &TwistHistory) {}
}

/// Sums up the heat.
#[derive(Debug, Default)]
pub(super) struct Heat(pub(super) f64);

impl Meter for Heat {
    const LOOKS: bool = true;

    fn follows(&mut self, before: &TwistHistory, after: &TwistHistory, way: SlipPath) {
        self.0 += match way {
            SlipPath::Adhere => 0.0,
            SlipPath::Outward { annulus, .. } => of_steady_ring(before, after, annulus.depth),
            SlipPath::FromRim | SlipPath::Inward(_) => of_ring(before, after, way),
        };
    }

    fn slides(&mut self, heat: RingHeat<'_>) {
        self.0 += heat.sum();
    }

    fn forgets(&mut self, last: &TwistHistory) {
        self.0 += last.stored_energy();
    }
}

/// Growth with a slip annulus of constant depth.
fn of_steady_ring(before: &TwistHistory, after: &TwistHistory, depth: f64) -> f64 {
    let (grown, turned) = (after.radius - before.radius, (after.twist - before.twist).abs());
    let rate = heat_of_twist(depth) * turned - heat_of_growth(depth) * grown;
    mean_of_fourth_powers(before.radius, after.radius) * rate.max(0.0)
}

/// A substep with one slip annulus that spreads inwards.
fn of_ring(before: &TwistHistory, after: &TwistHistory, way: SlipPath) -> f64 {
    let Some(sign) = after.slip_sign().filter(|_| after.stick < after.radius) else {
        return of_edge(before, after);
    };
    let turns_on = after.radius >= before.radius && sign * (after.twist - before.twist) > 0.0;
    let slipped = before.slip_sign() == Some(sign);
    let goes_on = slipped && (turns_on || matches!(way, SlipPath::Inward(_)));
    let start = if goes_on { before.stick } else { before.radius };
    // An annulus that begins anew inside one of its own sign moves outwards.
    let heat = (goes_on == slipped).then(|| Front::new(before, after, sign));
    let heat = heat.and_then(|front| front.heat(start, after.stick));
    heat.filter(|heat| heat.is_finite()).unwrap_or_else(|| by_parts(before, after, way))
}

/// The energy released by a receding edge without a slip annulus: the limit of a thin annulus, in
/// which `v = |bh - T|/al` and `p = g = (3/2) v^2`.
fn of_edge(before: &TwistHistory, after: &TwistHistory) -> f64 {
    let lost = before.radius - after.radius;
    if lost <= 0.0 {
        return 0.0;
    }
    let rounding = 4.0 * f64::EPSILON * before.twist.abs().max(after.twist.abs());
    let rate = |t: f64| {
        let radius = (1.0 - t) * before.radius + t * after.radius;
        let twist = (1.0 - t) * before.twist + t * after.twist;
        let rest = twist - before.twist_below(radius);
        if rest.abs() <= rounding {
            return 0.0;
        }
        let turned = rest.signum() * (after.twist - before.twist);
        1.5 * (radius * rest) * (radius * rest) * (turned + lost).max(0.0)
    };
    GAUSS.iter().map(|(node, weight)| weight * rate(*node)).sum()
}

/// A substep with one slip annulus, by Gauss quadrature over the step. If rings were needed before,
/// the inner radius may move outwards.
fn by_parts(before: &TwistHistory, after: &TwistHistory, way: SlipPath) -> f64 {
    let (grown, turned) = (after.radius - before.radius, after.twist - before.twist);
    let rate = |t: f64| {
        let mut at = before.clone();
        at.follow(way, at.radius + t * grown, at.twist + t * turned);
        let Some(sign) = at.slip_sign() else { return 0.0 };
        let depth = if at.stick > 0.0 { libm::log(at.radius / at.stick) } else { f64::INFINITY };
        let square = at.radius * at.radius;
        let rate = heat_of_twist(depth) * sign * turned - heat_of_growth(depth) * grown;
        square * square * rate.max(0.0)
    };
    GAUSS.iter().map(|(node, weight)| weight * rate(*node)).sum()
}

/// Slipping rings, and the contact radius at the start.
pub(super) struct RingHeat<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) from: f64,
    pub(super) signs: &'a [f64],
    pub(super) slips: &'a [f64],
}

impl RingHeat<'_> {
    fn sum(&self) -> f64 {
        let (edges, middles) = (self.mesh.edges(), self.mesh.middles());
        let limit = |al: f64, rho: f64| ((al - rho) * (al + rho)).max(0.0).sqrt();
        (0..middles.len())
            .map(|i| {
                let rho = middles[i];
                let inner = if i + 1 == middles.len() { 0.0 } else { edges[i + 1] };
                // sqrt(al^2 - rho^2) vanishes at the edge, within its ring.
                let area = |al: f64| {
                    let outer = edges[i].min(al);
                    if i == 0 {
                        let rest = (al - inner) * (al + inner);
                        return rho * rest * rest.max(0.0).sqrt() / 3.0;
                    }
                    limit(al, rho) * (outer.powi(3) - inner.powi(3)) / 3.0
                };
                let mean = 0.5 * (area(self.mesh.radius()) + area(self.from));
                1.5 * mean * (self.signs[i] * self.slips[i]).max(0.0)
            })
            .sum()
    }
}
