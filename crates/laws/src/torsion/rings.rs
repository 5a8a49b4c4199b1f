//! A twisted contact that recedes, solved by rings of any pattern of stick and slip.
//!
//! One unknown a ring: tractions within the friction limit, and slip only where it is reached,
//! along it. The density of [`super::history`] ties tractions to rotations: a disc of radius s
//! with the density b turns the surface by b inside s and by `b [1 - W(s/rho)]` outside.

use std::f64::consts::FRAC_2_PI;

/// Rings of the area that stays, and of the area that is lost.
const KEPT: usize = 56;
const LOST: usize = 8;
const RINGS: usize = KEPT + LOST;
/// Sweeps of Gauss and Seidel at most, and the slip (relative) at which they stop.
const SWEEPS: usize = 5000;
const TOLERANCE: f64 = 1e-9;

/// A solution: constant densities on cells (from, to, density), and the largest radius that sticks.
pub(super) struct RingSolution {
    pub(super) cells: Vec<(f64, f64, f64)>,
    pub(super) stick_radius: f64,
}

/// The state after the contact radius went from `from` to `to` (smaller, positive) and the twist
/// from `twists[0]` to `twists[1]`, given the twist carried by the discs below each radius before.
///
/// None if the sweeps do not converge.
pub(super) fn recede(
    from: f64,
    to: f64,
    twists: [f64; 2],
    twist_below: impl Fn(f64) -> f64,
) -> Option<RingSolution> {
    let rings = Rings::new(from, to);
    let before = rings.densities(twist_below);
    let mut tractions = rings.tractions(&before);
    let mut slips = rings.slips(&tractions, twists[0]);
    let steps = (((from - to) / to * 20.0).ceil() as usize).clamp(1, 20);
    for step in 1..=steps {
        let t = step as f64 / steps as f64;
        let radius = from + t * (to - from);
        let twist = twists[0] + t * (twists[1] - twists[0]);
        rings.relax(&mut tractions, &slips, radius, twist)?;
        slips = rings.slips(&tractions, twist);
    }
    Some(rings.solution(&tractions, to))
}

struct Rings {
    /// Cell boundaries, from the centre outwards.
    edges: Vec<f64>,
    /// Radii at which tractions and slips are taken.
    middles: Vec<f64>,
    /// Traction of ring i by the density of cell j >= i.
    traction: Vec<[f64; RINGS]>,
    /// Rotation of ring i by the traction of ring j.
    compliance: Vec<[f64; RINGS]>,
}

impl Rings {
    fn new(from: f64, to: f64) -> Self {
        let edge = |i: usize| {
            if i <= KEPT {
                to * (i as f64 / KEPT as f64)
            } else {
                to + (from - to) * (i - KEPT) as f64 / LOST as f64
            }
        };
        let edges: Vec<f64> = (0..=RINGS).map(edge).collect();
        let middles: Vec<f64> = edges.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        let mut rings =
            Self { edges, middles, traction: vec![[0.0; RINGS]; RINGS], compliance: Vec::new() };
        for i in 0..RINGS {
            for j in i..RINGS {
                rings.traction[i][j] = rings.traction_of(i, j);
            }
        }
        rings.compliance = rings.compliances();
        rings
    }

    /// `rho int ds/sqrt(s^2 - rho^2)` over the part of cell j outside rho_i.
    fn traction_of(&self, i: usize, j: usize) -> f64 {
        let rho = self.middles[i];
        let arc = |s: f64| libm::acosh((s / rho).max(1.0));
        rho * (arc(self.edges[j + 1]) - arc(self.edges[j]))
    }

    /// The rotation of ring i by a unit density of cell j.
    fn rotation_of(&self, i: usize, j: usize) -> f64 {
        let rho = self.middles[i];
        let (low, high) = (self.edges[j], self.edges[j + 1]);
        // The integral over s of (2/pi) [asin(x) - x sqrt(1 - x^2)], x = s/rho, below rho.
        let inner = |s: f64| {
            let x = (s / rho).min(1.0);
            let root = ((1.0 - x) * (1.0 + x)).sqrt();
            FRAC_2_PI * rho * (x * libm::asin(x) + root + (root * root * root - 1.0) / 3.0)
        };
        inner(high) - inner(low) + (high.max(rho) - low.max(rho))
    }

    /// Rotations by unit tractions: the columns of U A^-1.
    fn compliances(&self) -> Vec<[f64; RINGS]> {
        (0..RINGS)
            .map(|i| {
                // Row i of U, then forward through the columns of the triangle A.
                let mut row = [0.0; RINGS];
                for j in 0..RINGS {
                    let known: f64 = (0..j).map(|k| row[k] * self.traction[k][j]).sum();
                    row[j] = (self.rotation_of(i, j) - known) / self.traction[j][j];
                }
                row
            })
            .collect()
    }

    fn densities(&self, twist_below: impl Fn(f64) -> f64) -> Vec<f64> {
        self.edges
            .windows(2)
            .map(|pair| (twist_below(pair[1]) - twist_below(pair[0])) / (pair[1] - pair[0]))
            .collect()
    }

    fn tractions(&self, densities: &[f64]) -> Vec<f64> {
        self.traction.iter().map(|row| dot(row, densities)).collect()
    }

    fn slips(&self, tractions: &[f64], twist: f64) -> Vec<f64> {
        self.compliance.iter().map(|row| twist - dot(row, tractions)).collect()
    }

    /// Gauss-Seidel sweeps, each ring to stick or to the friction limit.
    fn relax(&self, tractions: &mut [f64], slips: &[f64], radius: f64, twist: f64) -> Option<()> {
        let limit = |i: usize| {
            let rho = self.middles[i];
            ((radius - rho) * (radius + rho)).max(0.0).sqrt()
        };
        for _ in 0..SWEEPS {
            let mut change = 0.0_f64;
            for i in 0..RINGS {
                let slip = twist - dot(&self.compliance[i], tractions) - slips[i];
                let stick = tractions[i] + slip / self.compliance[i][i];
                let next = stick.clamp(-limit(i), limit(i));
                change = change.max((next - tractions[i]).abs());
                tractions[i] = next;
            }
            if change <= TOLERANCE * radius {
                return Some(());
            }
        }
        None
    }

    fn solution(&self, tractions: &[f64], radius: f64) -> RingSolution {
        let mut densities = [0.0; RINGS];
        for i in (0..RINGS).rev() {
            let known: f64 = (i + 1..RINGS).map(|j| self.traction[i][j] * densities[j]).sum();
            densities[i] = (tractions[i] - known) / self.traction[i][i];
        }
        let sticks = |i: &usize| {
            let rho = self.middles[*i];
            let limit = ((radius - rho) * (radius + rho)).max(0.0).sqrt();
            tractions[*i].abs() < (1.0 - 1e-6) * limit
        };
        let stick_radius =
            (0..KEPT).rev().find(sticks).map_or(self.edges[1], |i| self.edges[i + 1]);
        let cells = (0..KEPT).map(|i| (self.edges[i], self.edges[i + 1], densities[i])).collect();
        RingSolution { cells, stick_radius }
    }
}

fn dot(row: &[f64; RINGS], values: &[f64]) -> f64 {
    row.iter().zip(values).map(|(a, b)| a * b).sum()
}
