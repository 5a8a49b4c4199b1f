//! A twisted contact by rings of any pattern of stick and slip.
//!
//! One unknown a ring: tractions within the friction limit, and slip only where it is reached,
//! along it. The density of [`super::history`] ties tractions to rotations: a disc of radius s
//! with the density b turns the surface by b inside s and by `b [1 - W(s/rho)]` outside. Discs
//! inside all slip keep their density, so that rings are needed only outside a radius. Their edges
//! are powers of one number, narrow at the rim and wider inwards: the influence of a ring on
//! another depends on their distance and width alone, and its numbers are found once.

use std::f64::consts::FRAC_2_PI;
use std::sync::OnceLock;

use super::complementarity::Friction;
use super::sliding::sliding_twist;

/// The least width of rings that may be asked for, and by how many levels those at the rim itself
/// are narrower: just above the threshold of the rate the outer slip ring is thin.
pub(super) const NARROWEST: f64 = 1.0 / 256.0;
const AT_RIM: usize = 2;
/// ln of the ratio of neighbouring edges on the finest rings; those of a level are twice as wide
/// as those of the one before.
const FINEST: f64 = NARROWEST / (1 << AT_RIM) as f64;
/// The level of 1/128, unless another is asked for, and the widest.
pub(super) const USUAL_LEVEL: usize = 1;
pub(super) const WIDEST_LEVEL: usize = 6;

/// Depths below the rim, in units of [`FINEST`], from which on rings are wider by one level each.
const WIDER: [i32; 5] = [16, 48, 384, 768, 1536];
/// The depth, in those units, that rings do not exceed: a part 0.03 of the radius.
const DEEPEST: i32 = 3584;

const LEVELS: usize = WIDEST_LEVEL + WIDER.len() + 1;
/// Distances of edges: the deepest, and a ring more at the rim and at the bottom.
const DISTANCES: usize = DEEPEST as usize + (4 << (LEVELS - 1));

/// What tells a ring's traction and slip by discs up to an edge that lies `d` units outside or
/// inside its outer edge.
struct Influence {
    /// `arcosh(s/rho)` by units outwards.
    traction: Vec<f64>,
    /// `int_0^(s/rho) W dx` by units inwards.
    slip: Vec<f64>,
}

impl Influence {
    fn new(level: usize) -> Self {
        // The outer edge of a ring over its middle.
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
    // The bracket's integral falls as x^3 towards the centre, below all that matters there.
    x - FRAC_2_PI * (x * libm::asin(x) + root + (root * root * root - 4.0) / 3.0)
}

/// Changes of the densities from the rim inwards, and where rings slip.
pub(super) struct RingSolution {
    pub(super) changes: Vec<f64>,
    /// Change of the twist below the rings; none if the innermost one sticks.
    pub(super) core: f64,
    /// +1 or -1 on rings that slip, 0 on those that stick.
    pub(super) slips: Vec<f64>,
}

static INFLUENCES: [OnceLock<Influence>; LEVELS] = [const { OnceLock::new() }; LEVELS];

fn influence(level: usize) -> &'static Influence {
    INFLUENCES[level].get_or_init(|| Influence::new(level))
}

/// Rings from the rim of the contact inwards. The edges but the rim are powers of one number, the
/// same at every radius of contact, so that a contact that recedes keeps its rings.
pub(super) struct Rings {
    radius: f64,
    /// Edges from the rim inwards, one more than rings.
    edges: Vec<f64>,
    middles: Vec<f64>,
    /// Traction over radius of a ring by the density of another, row by row: from outside only.
    traction: Vec<f64>,
    /// Slip of a ring by the density of another: from inside only.
    slip: Vec<f64>,
    /// Densities of sliding, averaged over rings, and their tractions over radius: the limits.
    sliding: Vec<f64>,
    limits: Vec<f64>,
}

impl Rings {
    /// Rings of a contact of given radius down to `inner`, as far as they go, of the given level of
    /// width near the rim.
    pub(super) fn new(radius: f64, inner: f64, level: usize) -> Self {
        let places = Places::new(radius, inner, level.min(WIDEST_LEVEL));
        let n = places.levels.len();
        let edges = places.edges(radius);
        let middles: Vec<f64> = edges.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        let (mut traction, mut slip) = (vec![0.0; n * n], vec![0.0; n * n]);
        for i in 0..n {
            places.tractions(i, radius / middles[i], &mut traction[i * n..=i * n + i]);
            places.slips(i, &edges, middles[i], &mut slip[i * n + i..(i + 1) * n]);
        }
        let twists: Vec<f64> = edges.iter().map(|&s| sliding_twist(s, radius)).collect();
        let sliding =
            (0..n).map(|i| (twists[i + 1] - twists[i]) / (edges[i] - edges[i + 1])).collect();
        let limits = Vec::new();
        let mut rings = Self { radius, edges, middles, traction, slip, sliding, limits };
        rings.limits = rings.tractions(&rings.sliding);
        rings
    }

    /// The contact radius.
    pub(super) const fn radius(&self) -> f64 {
        self.radius
    }

    /// Edges from the rim inwards, one more than rings.
    pub(super) fn edges(&self) -> &[f64] {
        &self.edges
    }

    /// Radii of the middles of rings.
    pub(super) fn middles(&self) -> &[f64] {
        &self.middles
    }

    /// Densities of sliding, averaged over rings.
    pub(super) fn sliding(&self) -> &[f64] {
        &self.sliding
    }

    /// Greatest tractions over radius. Those of the averaged sliding density, so that densities
    /// below it are within friction and sliding is met exactly.
    pub(super) fn limits(&self) -> &[f64] {
        &self.limits
    }

    /// Tractions over radius by densities.
    pub(super) fn tractions(&self, densities: &[f64]) -> Vec<f64> {
        let n = densities.len();
        (0..n).map(|i| dot(&self.traction[i * n..=i * n + i], &densities[..=i])).collect()
    }

    /// Densities by tractions over radius.
    fn densities(&self, tractions: &[f64]) -> Vec<f64> {
        let n = tractions.len();
        let mut densities = Vec::with_capacity(n);
        for (i, traction) in tractions.iter().enumerate() {
            let row = &self.traction[i * n..=i * n + i];
            densities.push((traction - dot(&row[..i], &densities)) / row[i]);
        }
        densities
    }

    /// Slip of the rings, an angle, by changes of the densities and of the twist below the rings.
    pub(super) fn slips(&self, changes: &[f64], core: f64) -> Vec<f64> {
        let n = changes.len();
        (0..n).map(|i| core + dot(&self.slip[i * n + i..(i + 1) * n], &changes[i..])).collect()
    }

    /// Rotations of a ring by unit tractions over radius: of all discs together, less its slip.
    pub(super) fn compliance(&self, i: usize) -> Vec<f64> {
        let n = self.middles.len();
        let slip = &self.slip[i * n..(i + 1) * n];
        let widths = self.edges.windows(2).map(|pair| pair[0] - pair[1]);
        let mut row: Vec<f64> = widths.zip(slip).map(|(width, slip)| width - slip).collect();
        // From rotations by densities to those by tractions.
        for k in (0..n).rev() {
            let by = &self.traction[k * n..=k * n + k];
            let share = row[k] / by[k];
            for (entry, by) in row[..k].iter_mut().zip(by) {
                *entry -= share * by;
            }
            row[k] = share;
        }
        row
    }

    /// The state after the twist of all discs changed by `turned`, from the densities before. None
    /// if neither way to it converges.
    pub(super) fn turn(&self, densities: &[f64], turned: f64) -> Option<RingSolution> {
        let before = self.tractions(densities);
        let (tractions, slips) = Friction::new(self, &before, turned).solve()?;
        let changes: Vec<f64> = tractions.iter().zip(&before).map(|(now, old)| now - old).collect();
        let changes = self.densities(&changes);
        let core = turned - self.twist(&changes);
        Some(RingSolution { changes, core, slips })
    }

    /// The twist of the rings by their densities.
    fn twist(&self, densities: &[f64]) -> f64 {
        let widths = self.edges.windows(2).map(|pair| pair[0] - pair[1]);
        widths.zip(densities).map(|(width, density)| width * density).sum()
    }

    /// Slip of the rings by changes of their tractions over radius and of the twist.
    pub(super) fn slips_by_tractions(&self, changes: &[f64], turned: f64) -> Vec<f64> {
        let changes = self.densities(changes);
        self.slips(&changes, turned - self.twist(&changes))
    }
}

/// Where the edges of rings lie on the scale of logarithms.
struct Places {
    /// Outer edges of the rings in units of [`FINEST`] from unit radius inwards, and the inner one
    /// of the last; the first is that of the grid outside the rim.
    units: Vec<i32>,
    levels: Vec<usize>,
}

impl Places {
    fn new(radius: f64, inner: f64, level: usize) -> Self {
        let width = 1 << level;
        let depth = -libm::log(radius) / FINEST;
        // The rim's ring is between a third and four thirds of the next.
        let first = (depth / f64::from(width) + 1.0 / 3.0).ceil() as i32 * width;
        let top = depth.floor() as i32;
        let bottom = (-libm::log(inner) / FINEST).ceil().min(depth + f64::from(DEEPEST)) as i32;
        let (mut units, mut levels) = (vec![first - width, first], vec![level]);
        let mut at = first;
        while at < bottom || levels.len() < 4 {
            let wider = WIDER.iter().filter(|&&depth| at - top >= depth).count();
            // Wider rings begin at edges of their own.
            let own = (0..=wider).rev().find(|w| at % (1 << (level + w)) == 0).unwrap_or(0);
            at += 1 << (level + own);
            units.push(at);
            levels.push(level + own);
        }
        Self { units, levels }
    }

    fn edges(&self, radius: f64) -> Vec<f64> {
        let rest = self.units[1..].iter().map(|&unit| libm::exp(-FINEST * f64::from(unit)));
        std::iter::once(radius).chain(rest).collect()
    }

    /// Tractions over radius of ring i by the densities of those from the rim to itself.
    fn tractions(&self, i: usize, rim: f64, row: &mut [f64]) {
        let table = &influence(self.levels[i]).traction;
        let outer = |j: usize| match j {
            0 => arc(rim),
            j => table[(self.units[i] - self.units[j]) as usize],
        };
        let mut at = outer(0);
        for (j, entry) in row.iter_mut().enumerate() {
            let inner = if j == i { 0.0 } else { outer(j + 1) };
            *entry = at - inner;
            at = inner;
        }
    }

    /// Slips of ring i by the densities of those from itself inwards.
    fn slips(&self, i: usize, edges: &[f64], middle: f64, row: &mut [f64]) {
        let table = &influence(self.levels[i]).slip;
        let below = |j: usize| match i {
            0 => slip_integral((edges[j] / middle).min(1.0)),
            i => table[(self.units[j] - self.units[i]) as usize],
        };
        let mut at = below(i);
        for (k, entry) in row.iter_mut().enumerate() {
            let inner = below(i + k + 1);
            *entry = middle * (at - inner);
            at = inner;
        }
    }
}

/// The sum of products of two rows.
pub(super) fn dot(row: &[f64], values: &[f64]) -> f64 {
    // Eight sums at once.
    let mut sums = [0.0; 8];
    let (rows, values) = (row.chunks_exact(8), values.chunks_exact(8));
    let rest: f64 = rows.remainder().iter().zip(values.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in rows.zip(values) {
        for i in 0..8 {
            sums[i] += a[i] * b[i];
        }
    }
    sums.iter().sum::<f64>() + rest
}
