//! A twisted contact that recedes, solved by rings of any pattern of stick and slip.
//!
//! One unknown a ring: tractions within the friction limit, and slip only where it is reached,
//! along it. The density of [`super::history`] ties tractions to rotations: a disc of radius s
//! with the density b turns the surface by b inside s and by `b [1 - W(s/rho)]` outside. Discs
//! inside all slip keep their density, so that rings are needed only outside a radius. Their edges
//! are a geometric sequence from the rim inwards: the influence of a ring on another then depends
//! on their distance alone, and its numbers are found once.

use std::f64::consts::FRAC_2_PI;
use std::sync::LazyLock;

/// ln of the ratio of neighbouring edges on the finest rings; those of a level are twice as wide
/// as those of the one before.
pub(super) const FINEST: f64 = 1.0 / 256.0;
const LEVELS: usize = 8;
/// The level of 1/64, unless another is asked for.
pub(super) const USUAL_LEVEL: usize = 2;
/// Rings at most, and on the usual and wider levels.
const MOST: usize = 256;
const USUALLY_MOST: usize = 128;
/// Sweeps of relaxation at most, and the change of traction (over the radius) at which they stop.
const SWEEPS: usize = 5000;
const TOLERANCE: f64 = 1e-6;

/// The influence of rings `m` apart, for one width.
struct Influence {
    /// Traction of a ring over its radius, by the density `m` rings outwards.
    traction: [f64; MOST],
    /// The inverse of that triangle: density by the traction `m` rings outwards.
    density: [f64; MOST],
    /// Slip of a ring over its radius, by the density `m` rings inwards.
    slip: [f64; MOST],
}

impl Influence {
    fn new(width: f64) -> Self {
        // The outer edge of a ring over its middle.
        let edge = 2.0 / (1.0 + libm::exp(-width));
        let at = |m: usize, sign: f64| edge * libm::exp(sign * width * m as f64);
        let arc = |s: f64| libm::acosh(s.max(1.0));
        let inner = edge * libm::exp(-width);
        let traction: [f64; MOST] = std::array::from_fn(|m| {
            let below = if m == 0 { inner } else { at(m - 1, 1.0) };
            arc(at(m, 1.0)) - arc(below)
        });
        let slip = std::array::from_fn(|m| {
            slip_integral(at(m, -1.0).min(1.0)) - slip_integral(at(m + 1, -1.0))
        });
        let mut density = [0.0; MOST];
        density[0] = 1.0 / traction[0];
        for m in 1..MOST {
            let known: f64 = (1..=m).map(|k| traction[k] * density[m - k]).sum();
            density[m] = -known / traction[0];
        }
        Self { traction, density, slip }
    }
}

/// `int_0^x W dx`, `W = 1 - (2/pi) [asin x - x sqrt(1 - x^2)]`.
fn slip_integral(x: f64) -> f64 {
    let root = ((1.0 - x) * (1.0 + x)).sqrt();
    // The bracket's integral falls as x^3 towards the centre, below all that matters there.
    x - FRAC_2_PI * (x * libm::asin(x) + root + (root * root * root - 4.0) / 3.0)
}

static INFLUENCES: LazyLock<[Influence; LEVELS]> =
    LazyLock::new(|| std::array::from_fn(|level| Influence::new(FINEST * f64::from(1 << level))));

/// Rings from the rim of the contact inwards. The edges but the rim are powers of one number, the
/// same at every radius of contact, so that a contact that recedes keeps its rings.
pub(super) struct Rings {
    influence: &'static Influence,
    level: usize,
    /// Edges from the rim inwards, one more than rings.
    edges: Vec<f64>,
    /// Traction over radius of the rings by the density of the outermost, which has its own width.
    rim: Vec<f64>,
    /// Rotation of ring i by the traction over radius of ring k, row by row.
    compliance: Vec<f64>,
    limits: Vec<f64>,
}

/// Changes of the densities from the rim inwards, and where rings slip.
pub(super) struct RingSolution {
    pub(super) changes: Vec<f64>,
    /// +1 or -1 on rings that slip, 0 on those that stick.
    pub(super) slips: Vec<f64>,
}

impl Rings {
    /// Rings of a contact of given radius down to `inner` or below, of the given level of width or
    /// the finest one that fits.
    pub(super) fn new(radius: f64, inner: f64, level: usize) -> Self {
        let span = libm::log(radius / inner);
        let width = |level: usize| FINEST * f64::from(1 << level);
        let most = |level: usize| if level < USUAL_LEVEL { MOST } else { USUALLY_MOST };
        let fits = |level: &usize| span < width(*level) * (most(*level) - 2) as f64;
        let level = (level..LEVELS).find(fits).unwrap_or(LEVELS - 1);
        let width = width(level);
        // The rim's ring is between a third and four thirds of the others.
        let first = (-libm::log(radius) / width + 1.0 / 3.0).ceil();
        let count = ((span / width).ceil() as usize + 1).clamp(4, MOST);
        let edges: Vec<f64> = (0..=count)
            .map(|i| if i == 0 { radius } else { libm::exp(-width * (first + (i - 1) as f64)) })
            .collect();
        let influence = &INFLUENCES[level];
        let (rim, compliance, limits) = (Vec::new(), Vec::new(), Vec::new());
        let mut rings = Self { influence, level, edges, rim, compliance, limits };
        let middles: Vec<f64> = (0..count).map(|i| rings.middle(i)).collect();
        let limit = |rho: &f64| ((radius - rho) * (radius + rho)).sqrt() / rho;
        rings.limits = middles.iter().map(limit).collect();
        let arc = |s: f64| libm::acosh(s.max(1.0));
        rings.rim =
            middles.iter().map(|rho| arc(radius / rho) - arc(rings.edges[1] / rho)).collect();
        rings.compliance = rings.compliances(&middles);
        rings
    }

    pub(super) fn edges(&self) -> &[f64] {
        &self.edges
    }

    pub(super) const fn level(&self) -> usize {
        self.level
    }

    fn middle(&self, i: usize) -> f64 {
        0.5 * (self.edges[i] + self.edges[i + 1])
    }

    /// Densities by tractions over radius.
    fn densities(&self, tractions: &[f64]) -> Vec<f64> {
        let rim = tractions[0] / self.rim[0];
        let rest: Vec<f64> =
            (1..tractions.len()).map(|i| tractions[i] - self.rim[i] * rim).collect();
        let mut all = vec![rim];
        all.extend(convolve(&self.influence.density, &rest));
        all
    }

    /// Tractions over radius by densities.
    fn tractions(&self, densities: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0];
        all.extend(convolve(&self.influence.traction, &densities[1..]));
        all.iter().zip(&self.rim).map(|(inner, rim)| inner + rim * densities[0]).collect()
    }

    /// Rotations by unit tractions over radius: of all discs together, less their slip.
    fn compliances(&self, middles: &[f64]) -> Vec<f64> {
        let (n, influence) = (middles.len(), self.influence);
        let mut matrix = vec![0.0; n * n];
        let reversed: Vec<f64> = influence.density[..n].iter().rev().copied().collect();
        for i in (1..n).rev() {
            let (rows, inner) = matrix.split_at_mut((i + 1) * n);
            let slip = influence.slip[n - 1 - i];
            for (entry, density) in rows[i * n + 1..].iter_mut().zip(&reversed[1..]) {
                *entry = slip * density;
            }
            for (entry, inner) in rows[i * n + 1..].iter_mut().zip(inner.iter().take(n).skip(2)) {
                *entry += inner;
            }
        }
        self.add_rim(middles, &mut matrix);
        let widths: Vec<f64> = self.edges.windows(2).map(|pair| pair[0] - pair[1]).collect();
        let mut whole: Vec<f64> =
            (0..n).map(|k| dot(&widths[k..], &influence.density[..n - k])).collect();
        whole[0] = dot(&widths, &self.density_by_rim(n));
        for (row, rho) in matrix.chunks_exact_mut(n).zip(middles) {
            for (entry, whole) in row.iter_mut().zip(&whole) {
                *entry = whole - rho * *entry;
            }
        }
        matrix
    }

    /// Densities by a unit traction over radius of the rim's ring alone.
    fn density_by_rim(&self, count: usize) -> Vec<f64> {
        let mut unit = vec![0.0; count];
        unit[0] = 1.0;
        self.densities(&unit)
    }

    /// The slip over radius that the rim's ring takes part in: the first column and row.
    fn add_rim(&self, middles: &[f64], matrix: &mut [f64]) {
        let (n, influence) = (middles.len(), self.influence);
        let by_rim = self.density_by_rim(n);
        let below: Vec<f64> =
            self.edges.iter().map(|s| slip_integral((s / middles[0]).min(1.0))).collect();
        let slip: Vec<f64> = below.windows(2).map(|pair| pair[0] - pair[1]).collect();
        for i in 1..n {
            matrix[i * n] = dot(&influence.slip[..n - i], &by_rim[i..]);
        }
        matrix[0] = dot(&slip, &by_rim);
        for k in 1..n {
            matrix[k] = dot(&slip[k..], &influence.density[..n - k]);
        }
    }

    /// Solves for the state after the twist of all discs changed by `turned`, from the densities
    /// before. None if the sweeps do not converge.
    pub(super) fn turn(&self, densities: &[f64], turned: f64) -> Option<RingSolution> {
        let n = self.limits.len();
        let before = self.tractions(densities);
        // To begin with, the rim alone takes the twist.
        let rim = turned / (self.edges[0] - self.edges[1]);
        let mut now: Vec<f64> = (0..n)
            .map(|i| {
                let free = before[i] + rim * self.rim[i];
                free.clamp(-self.limits[i], self.limits[i])
            })
            .collect();
        let mut changes: Vec<f64> = now.iter().zip(&before).map(|(now, old)| now - old).collect();
        self.relax(&before, &mut now, &mut changes, turned)?;
        let slips = now
            .iter()
            .zip(&self.limits)
            .map(|(now, limit)| if now.abs() < *limit { 0.0 } else { now.signum() })
            .collect();
        let changes = self.densities(&changes);
        Some(RingSolution { changes, slips })
    }

    /// Sweeps of Gauss and Seidel, each ring to stick or to the friction limit.
    fn relax(
        &self,
        before: &[f64],
        now: &mut [f64],
        changes: &mut [f64],
        turned: f64,
    ) -> Option<()> {
        let n = self.limits.len();
        for _ in 0..SWEEPS {
            let mut greatest = 0.0_f64;
            for i in 0..n {
                let row = &self.compliance[i * n..(i + 1) * n];
                let slip = turned - dot(row, changes);
                let next = (now[i] + slip / row[i]).clamp(-self.limits[i], self.limits[i]);
                greatest = greatest.max((next - now[i]).abs());
                now[i] = next;
                changes[i] = next - before[i];
            }
            if greatest <= TOLERANCE {
                return Some(());
            }
        }
        None
    }
}

/// Sums over the rings outwards.
fn convolve(influence: &[f64; MOST], values: &[f64]) -> Vec<f64> {
    let n = values.len();
    let reversed: Vec<f64> = influence[..n].iter().rev().copied().collect();
    (0..n).map(|i| dot(&reversed[n - 1 - i..], &values[..=i])).collect()
}

fn dot(row: &[f64], values: &[f64]) -> f64 {
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
