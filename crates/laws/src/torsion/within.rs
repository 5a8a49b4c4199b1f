//! Whether the densities that a step keeps stay within friction, without rings.
//!
//! The traction at rho is within friction if `D(rho) = int_rho^al d/sqrt(s^2 - rho^2) ds >= 0` with the
//! spare density `d = bF(s; al) - b`, and likewise for `-b`. That holds where no density is above the
//! sliding one. A density that is above it by up to e between p and q is balanced by a spare d between
//! u and v further outside: since `1/sqrt(s^2 - rho^2)` grows faster with rho the smaller s is, the ratio of
//! their integrals is greatest at rho = p, where it is at most
//! `e sqrt(2 (q - p)/p) sqrt(v^2 - p^2) / (d (v - u))`. A constant density is above the sliding one only outside
//! the radius at which they meet, which is then p: without it a piece from the centre is never balanced. If these ratios add up to 1 at most, D is nowhere
//! negative.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, FRAC_PI_4};

use super::history::TwistHistory;
use super::segment::{Density, Segment};

/// Densities are above the sliding density by rounding only up to this fraction.
const ROUNDING: f64 = 1e-12;
/// The spare density where the contact slid in the other direction, at least.
const SPARE_IN_ANNULUS: f64 = 2.0;

/// Densities of a history from the centre to a radius.
#[derive(Clone, Copy)]
pub(super) struct Kept<'a> {
    pieces: &'a [Segment],
    top: f64,
    /// A slip annulus outside, in the direction of less traction.
    annulus: Option<Annulus>,
    /// Whether the outermost piece is known to be within friction.
    known: bool,
}

/// The width of a slip annulus and a contact radius that is not exceeded while it has this width.
#[derive(Clone, Copy)]
pub(super) struct Annulus {
    pub(super) width: f64,
    pub(super) radius: f64,
}

impl TwistHistory {
    /// The densities inside a radius; slip of the present annulus does not count.
    pub(super) fn kept(&self, top: f64) -> Kept<'_> {
        let slips = usize::from(self.slip_sign().is_some());
        let pieces = &self.segments[..self.segments.len() - slips];
        Kept { pieces, top, annulus: None, known: false }
    }
}

impl<'a> Kept<'a> {
    /// With a slip annulus outside, in the direction of less traction.
    pub(super) fn with_annulus(self, annulus: Annulus) -> Self {
        Self { annulus: Some(annulus), ..self }
    }

    /// With an outermost piece that is within friction because a slip annulus spread into it: if its
    /// density is constant, it is below the sliding density where the annulus ends.
    pub(super) fn inside_front(self) -> Self {
        let sticks = |last: &Segment| matches!(last.density(), Density::Stick(_));
        let known = self.pieces.last().is_some_and(sticks);
        Self { known, ..self }
    }

    /// Whether the outermost density is constant up to the radius.
    pub(super) fn ends_in_stick(self) -> bool {
        let Some(last) = self.pieces.last() else { return false };
        last.from < self.top && matches!(last.density(), Density::Stick(_))
    }

    /// Whether the twist in the direction of a sign is a convex function of the radius in the outermost piece.
    pub(super) fn twist_is_convex(self, sign: f64) -> bool {
        let slid = |piece: &Segment| matches!(piece.density(), Density::Slip { sign: own, .. } if own == sign);
        !self.pieces.last().is_some_and(slid)
    }

    /// The number of pieces.
    pub(super) const fn len(self) -> usize {
        self.pieces.len()
    }

    /// The radius outside which an annulus may have spread over any of these densities.
    pub(super) fn swept_from(self) -> f64 {
        match self.pieces {
            [.., last] if self.known => last.from,
            _ => self.top,
        }
    }

    /// Whether outside a radius no density is above the sliding density of a contact radius, in the direction
    /// of a sign.
    pub(super) fn below_sliding(self, outside: f64, radius: f64, sign: f64) -> bool {
        self.inwards(radius)
            .take_while(|(_, end)| *end > outside)
            .all(|(piece, end)| piece.density().above_sliding(piece.from, end, radius, sign) <= 0.0)
    }

    /// The radius inside which no density is above the sliding density of a contact radius.
    pub(super) fn calm_inside(self, radius: f64) -> f64 {
        let above = |(piece, end): &(&Segment, f64)| {
            [1.0, -1.0]
                .iter()
                .any(|sign| piece.density().above_sliding(piece.from, *end, radius, *sign) > 0.0)
        };
        self.inwards(radius).filter(above).last().map_or(self.top, |(piece, _)| piece.from)
    }

    /// Whether densities above the sliding density of a contact radius, in the direction of a sign, are
    /// balanced by those outside.
    pub(super) fn balance(self, radius: f64, sign: f64) -> bool {
        let mut used = 0.0;
        self.inwards(radius).skip(usize::from(self.known)).all(|(piece, end)| {
            let over = piece.density().above_sliding(piece.from, end, radius, sign);
            if over > 0.0 {
                let from = piece.from.max(piece.density().covered_inside(radius));
                let spare = self.spare(from, end, radius, sign);
                used += over * (2.0 * (end - from) / from).sqrt() / spare;
            }
            used <= 1.0
        })
    }

    /// The integral of spare densities outside `end`, over `sqrt(s^2 - from^2)`, at least.
    fn spare(self, from: f64, end: f64, radius: f64, sign: f64) -> f64 {
        let weight =
            |width: f64, outer: f64| width / ((outer - from) * (outer + from)).max(0.0).sqrt();
        let rim = self.annulus.map_or(0.0, |at| SPARE_IN_ANNULUS * weight(at.width, at.radius));
        let pieces = self.inwards(0.0).take_while(|(piece, _)| piece.from >= end);
        // The annulus spreads over the outermost.
        let pieces = pieces.skip(usize::from(self.annulus.is_some()));
        let spare = |(piece, outer): (&Segment, f64)| {
            piece.density().below_sliding(outer, radius, sign) * weight(outer - piece.from, outer)
        };
        rim + pieces.map(spare).sum::<f64>()
    }

    /// The pieces and their ends from outside, down to those with densities below sliding anyway.
    fn inwards(self, radius: f64) -> impl Iterator<Item = (&'a Segment, f64)> {
        let mut next = self.top;
        self.pieces
            .iter()
            .rev()
            .take_while(move |piece| piece.demand > radius)
            .filter(move |piece| piece.from < self.top)
            .map(move |piece| (piece, std::mem::replace(&mut next, piece.from)))
    }
}

impl Density {
    /// How far the density is above the sliding one of a contact radius, at most, between two radii.
    fn above_sliding(self, from: f64, end: f64, radius: f64, sign: f64) -> f64 {
        match self {
            Self::Stick(density) => {
                let over = sign * density - lower_sliding_density(end / radius);
                if over <= ROUNDING * density.abs() { 0.0 } else { over }
            }
            // dbF/dal = (2/pi) B(k)/s, and B is a convex function of k^2 from pi/4 to 1.
            Self::Slip { sign: own, radius: slid } if own == sign && slid > radius => {
                let part = (1.0 - from / slid) * (1.0 + from / slid);
                FRAC_2_PI * (FRAC_PI_4 + (1.0 - FRAC_PI_4) * part) * (slid - radius) / from
            }
            Self::Slip { .. } => 0.0,
        }
    }

    /// A radius inside which the density is below the sliding one of a contact radius.
    fn covered_inside(self, radius: f64) -> f64 {
        match self {
            Self::Stick(density) => radius / demand_inside(1.0, density),
            Self::Slip { .. } => 0.0,
        }
    }

    /// How far the density is below the sliding one inside a radius, at least.
    fn below_sliding(self, end: f64, radius: f64, sign: f64) -> f64 {
        match self {
            Self::Stick(density) => (lower_sliding_density(end / radius) - sign * density).max(0.0),
            Self::Slip { sign: own, .. } if own == sign => 0.0,
            Self::Slip { .. } => SPARE_IN_ANNULUS,
        }
    }
}

/// A lower bound of the sliding density at a fraction of the contact radius, exact at the edge: Ramanujan's
/// first approximation of the perimeter of an ellipse, whose series no term of the exact one is below.
fn lower_sliding_density(at: f64) -> f64 {
    let part = (1.0 - at) / (1.0 + at);
    0.5 * (1.0 + at) * (3.0 - (4.0 - part * part).sqrt()) / at
}

/// A contact radius from which the sliding density inside `end` is above this density.
pub(super) fn demand_inside(end: f64, density: f64) -> f64 {
    let density = density.abs();
    end * (2.0 * density - 1.0).min(FRAC_PI_2 * density).max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_of_the_sliding_density_hold() {
        for i in 1..200 {
            let s = f64::from(i) / 200.0;
            let slid = |radius: f64| Density::Slip { sign: 1.0, radius }.at(s);
            let (got, want) = (lower_sliding_density(s), slid(1.0));
            assert!(got <= want * (1.0 + 1e-14), "{s}: {got} {want}");
            assert!(s < 0.5 || want - got < 1e-5, "{s}: {got} {want}");
            // Slip in the other direction has minus the sliding density.
            assert!(2.0 * want >= SPARE_IN_ANNULUS, "{s}: {want}");
            for density in [0.3, 1.0, 1.2, 2.0, 9.0] {
                let covers = Density::Slip { sign: 1.0, radius: demand_inside(s, density) }.at(s);
                assert!(covers >= density * (1.0 - 1e-12) || density < 1.0, "{s} {density}");
                let covered = Density::Stick(density).covered_inside(s);
                let covers = Density::Slip { sign: 1.0, radius: s }.at(covered);
                assert!(covers >= density * (1.0 - 1e-12), "{s} {density} {covered}");
            }
            for radius in [1.001, 1.1, 2.0] {
                let bound = Density::Slip { sign: 1.0, radius }.above_sliding(s, 1.0, 1.0, 1.0);
                let over = slid(radius) - slid(1.0);
                assert!(over <= bound * (1.0 + 1e-12), "{s} {radius}: {over} {bound}");
            }
        }
    }
}
