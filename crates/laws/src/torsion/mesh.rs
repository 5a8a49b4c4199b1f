//! The rings of a twisted contact: their edges, and the influence of one ring on another.
//!
//! The edges are powers of one number, closely spaced at the edge of the contact and wider inside. The
//! influence of one ring on another then depends only on their distance and width, and is computed once.

use std::f64::consts::FRAC_2_PI;
use std::sync::OnceLock;

use super::sliding::sliding_twist;

/// The least ring width that may be requested, and by how many levels rings at the edge itself are
/// narrower: just above the threshold of the rate the outer slip annulus is thin.
pub(super) const NARROWEST: f64 = 1.0 / 256.0;
const AT_RIM: usize = 2;
/// ln of the ratio of neighbouring ring edges on the finest level; the rings of each level are
/// twice as wide as those of the previous one.
const FINEST: f64 = NARROWEST / (1 << AT_RIM) as f64;
/// The default level, for the width 1/128, and the widest.
pub(super) const USUAL_LEVEL: usize = 1;
pub(super) const WIDEST_LEVEL: usize = 6;

/// Depths below the edge of the contact, in units of [`FINEST`], from which rings are wider by one
/// level each.
const WIDER: [i32; 5] = [16, 48, 384, 768, 1536];
/// Greatest depth of the rings, in the same unit: 0.03 of the radius.
const DEEPEST: i32 = 3584;

const LEVELS: usize = WIDEST_LEVEL + WIDER.len() + 1;
/// Number of distances of ring edges: the deepest, and one ring more at both ends.
const DISTANCES: usize = DEEPEST as usize + (4 << (LEVELS - 1));

/// Traction and slip of a ring due to discs up to a ring edge that lies `d` units outside or inside
/// its outer edge.
struct Influence {
    /// `arcosh(s/rho)` by units outwards.
    traction: Vec<f64>,
    /// `int_0^(s/rho) W dx` by units inwards.
    slip: Vec<f64>,
}

impl Influence {
    fn new(level: usize) -> Self {
        // The outer edge of a ring divided by its middle radius.
        let edge = 2.0 / (1.0 + libm::exp(-FINEST * f64::from(1 << level)));
        let at = |sign: f64, d: usize| edge * libm::exp(sign * FINEST * d as f64);
        Self {
            traction: (0..DISTANCES).map(|d| arc(at(1.0, d))).collect(),
            slip: (0..DISTANCES).map(|d| slip_integral(at(-1.0, d).min(1.0))).collect(),
        }
    }
}

fn arc(ratio: f64) -> f64 {
    libm::acosh(ratio.max(1.0))
}

/// `int_0^x W dx`, `W = 1 - (2/pi) [asin x - x sqrt(1 - x^2)]`.
fn slip_integral(x: f64) -> f64 {
    let root = ((1.0 - x) * (1.0 + x)).sqrt();
    // The integral of the bracket decreases as x^3 towards the centre, below everything that
    // matters there.
    x - FRAC_2_PI * (x * libm::asin(x) + root + (root * root * root - 4.0) / 3.0)
}

static INFLUENCES: [OnceLock<Influence>; LEVELS] = [const { OnceLock::new() }; LEVELS];

fn influence(level: usize) -> &'static Influence {
    INFLUENCES[level].get_or_init(|| Influence::new(level))
}

/// Rings from the edge of the contact inwards. All edges but the outermost are powers of one
/// number, the same for every contact radius, so that a receding contact keeps its rings.
pub(super) struct Mesh {
    radius: f64,
    /// Radii of the ring edges, outermost first; one more than the number of rings.
    edges: Vec<f64>,
    middles: Vec<f64>,
    /// Sliding densities averaged over rings.
    sliding: Vec<f64>,
    places: Places,
}

impl Mesh {
    /// Rings for a contact of given radius down to `inner`, as far as they extend, with edges counted
    /// from a radius `unit` and the given level of width near the edge.
    pub(super) fn new(radius: f64, inner: f64, unit: f64, level: usize) -> Self {
        let places = Places::new(radius / unit, inner / unit, level.min(WIDEST_LEVEL));
        let edges = places.edges(radius, unit);
        let middles: Vec<f64> = edges.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        let twists: Vec<f64> = edges.iter().map(|&s| sliding_twist(s, radius)).collect();
        let slope = |(s, t): (&[f64], &[f64])| (t[1] - t[0]) / (s[0] - s[1]);
        let sliding = edges.windows(2).zip(twists.windows(2)).map(slope).collect();
        Self { radius, edges, middles, sliding, places }
    }

    /// The number of rings.
    pub(super) const fn len(&self) -> usize {
        self.middles.len()
    }

    /// The contact radius.
    pub(super) const fn radius(&self) -> f64 {
        self.radius
    }

    /// Radii of the ring edges, outermost first; one more than the number of rings.
    pub(super) fn edges(&self) -> &[f64] {
        &self.edges
    }

    /// Middle radii of the rings.
    pub(super) fn middles(&self) -> &[f64] {
        &self.middles
    }

    /// Sliding densities averaged over rings.
    pub(super) fn sliding(&self) -> &[f64] {
        &self.sliding
    }

    /// Widths of the rings.
    pub(super) fn widths(&self) -> impl Iterator<Item = f64> + '_ {
        self.edges.windows(2).map(|pair| pair[0] - pair[1])
    }

    /// Tractions divided by radius of ring i due to the densities of the rings from the edge to
    /// itself.
    pub(super) fn tractions(&self, i: usize, row: &mut [f64]) {
        self.places.tractions(i, self.radius / self.middles[i], row);
    }

    /// Tractions divided by radius of ring i due to two densities, from their changes at the outer edges of
    /// the rings.
    pub(super) fn tractions_of_jumps(&self, i: usize, jumps: &[[f64; 2]]) -> [f64; 2] {
        let Places { units, levels } = &self.places;
        let table = &influence(levels[i]).traction;
        let mut sums = jumps[0].map(|jump| arc(self.radius / self.middles[i]) * jump);
        for (unit, jump) in units[1..=i].iter().zip(&jumps[1..]) {
            let part = table[(units[i] - unit) as usize];
            sums = [sums[0] + part * jump[0], sums[1] + part * jump[1]];
        }
        sums
    }

    /// Slips of ring i due to the densities of the rings from itself inwards.
    pub(super) fn slips(&self, i: usize, row: &mut [f64]) {
        self.places.slips(i, &self.edges, self.middles[i], row);
    }
}

/// Positions of the ring edges on a logarithmic scale.
struct Places {
    /// Outer edges of the rings in units of [`FINEST`] from unit radius inwards, and the inner edge
    /// of the last; the first is that of the grid outside the contact.
    units: Vec<i32>,
    levels: Vec<usize>,
}

impl Places {
    fn new(radius: f64, inner: f64, level: usize) -> Self {
        let width = 1 << level;
        let depth = -libm::log(radius) / FINEST;
        // The outermost ring is between a third and four thirds as wide as the next.
        let first = (depth / f64::from(width) + 1.0 / 3.0).ceil() as i32 * width;
        let top = depth.floor() as i32;
        let bottom = (-libm::log(inner) / FINEST).ceil().min(depth + f64::from(DEEPEST)) as i32;
        let (mut units, mut levels) = (vec![first - width, first], vec![level]);
        let mut at = first;
        while at < bottom || levels.len() < 4 {
            let wider = WIDER.iter().filter(|&&depth| at - top >= depth).count();
            // Wider rings begin at edges of their own level.
            let own = (0..=wider).rev().find(|w| at % (1 << (level + w)) == 0).unwrap_or(0);
            at += 1 << (level + own);
            units.push(at);
            levels.push(level + own);
        }
        Self { units, levels }
    }

    fn edges(&self, radius: f64, whole: f64) -> Vec<f64> {
        let rest = self.units[1..].iter().map(|&unit| whole * libm::exp(-FINEST * f64::from(unit)));
        std::iter::once(radius).chain(rest).collect()
    }

    /// Tractions divided by radius of ring i due to the densities of the rings from the edge to
    /// itself.
    fn tractions(&self, i: usize, rim: f64, row: &mut [f64]) {
        let table = &influence(self.levels[i]).traction;
        let own = self.units[i];
        let mut at = arc(rim);
        for (entry, unit) in row.iter_mut().zip(&self.units[1..=i]) {
            let inner = table[(own - unit) as usize];
            *entry = at - inner;
            at = inner;
        }
        // Of itself.
        row[i] = at;
    }

    /// Slips of ring i due to the densities of the rings from itself inwards.
    fn slips(&self, i: usize, edges: &[f64], middle: f64, row: &mut [f64]) {
        if i == 0 {
            let below = edges.iter().map(|edge| slip_integral((edge / middle).min(1.0)));
            return differences(middle, below, row);
        }
        let table = &influence(self.levels[i]).slip;
        let own = self.units[i];
        differences(middle, self.units[i..].iter().map(|unit| table[(unit - own) as usize]), row);
    }
}

/// Sets entries to a factor times the decreases of values.
fn differences(factor: f64, mut values: impl Iterator<Item = f64>, row: &mut [f64]) {
    let Some(mut at) = values.next() else { return };
    for (entry, inner) in row.iter_mut().zip(values) {
        *entry = factor * (at - inner);
        at = inner;
    }
}
