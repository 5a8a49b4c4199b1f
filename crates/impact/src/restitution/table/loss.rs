//! R_x with a loss from a table: what lossy particle and game codes need in tens of nanoseconds.
//!
//! For each of fifteen restitutions below 1 a grid over chi (geometric) and psi, in two blocks: up to psi = 1, where the
//! contact sticks at first, and from there to the border of sliding throughout. Interpolation is cubic in all three; at
//! e = 1 the table of elastic impacts takes part, so that R_x goes over into it without a jump.

use crate::oblique::{Groups, ObliqueError};
use crate::viscoelastic::{ViscoelasticImpact, ViscousLoss};

use super::RestitutionTable;

/// The restitutions of the table, below e = 1.
const LOSSES: [f64; 15] =
    [0.99, 0.98, 0.95, 0.9, 0.85, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.25, 0.2, 0.15, 0.1];
/// Nodes of chi, from and to.
const CHIS: usize = 25;
const RANGE: [f64; 2] = [0.66, 6.5];
/// Nodes over the logarithm of chi: (CHIS - 1)/ln(6.5/.66).
const PER_LOG: f64 = 10.492_639_842_009_416;
/// Nodes of psi up to 1, and beyond.
const PSIS: usize = 17;
const PSIS_BEYOND: usize = 33;
/// Numbers of one restitution, of one chi.
const GRID: usize = CHIS * ROW;
const ROW: usize = PSIS + PSIS_BEYOND;
/// All numbers.
const COUNT: usize = LOSSES.len() * GRID;
/// Tolerance of the impacts that fill the table.
const FILLING: f64 = 3e-5;
/// Tolerance of the impacts beyond the table.
const BEYOND: f64 = 1e-4;
/// The least psi that is followed.
const SLOWEST: f64 = 1e-9;

/// Made by `cargo run --release -p carom-impact --example restitution_table`: numbers of four bytes, little-endian.
static STORED: &[u8; 4 * COUNT] = include_bytes!("loss.bin");

/// First of four nodes, and their weights.
type Weights = (usize, [f64; 4]);

impl RestitutionTable {
    /// R_x of a viscous material with the normal restitution e: within 3e-3 of [`ViscoelasticImpact`] for solid spheres with
    /// e from .1, 4e-5 in the mean; exact where the contact slides throughout. At e = 1 it is [`RestitutionTable::restitution`].
    ///
    /// Outside chi from .66 to 6.5 and e from .1 the impact is integrated, some thousand times slower; an e outside 0 to 1 is
    /// taken as the nearest.
    ///
    /// ```
    /// use carom_impact::oblique::Groups;
    /// use carom_impact::restitution::RestitutionTable;
    /// let r_x = RestitutionTable::shared().restitution_with(Groups::of_spheres(1.2, 2.0)?, 0.5)?;
    /// assert!((r_x - 0.15564).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`RestitutionTable::restitution`].
    pub fn restitution_with(&self, groups: Groups, e: f64) -> Result<f64, ObliqueError> {
        if e >= 1.0 {
            return self.restitution(groups);
        }
        let (chi, psi) = (groups.chi(), groups.psi());
        if psi >= border(chi, e) {
            return Ok(slid(chi, psi, e));
        }
        let covers = (RANGE[0]..=RANGE[1]).contains(&chi) && e >= LOSSES[LOSSES.len() - 1];
        if !covers {
            return Ok(followed(groups, e, BEYOND));
        }
        let at = At::new(chi, psi, border(chi, e));
        let (first, weights) = of_e(e);
        // Each restitution is taken at the same part of its way from psi = 1 to sliding throughout.
        let Some(second) = first.checked_sub(1) else {
            let elastic =
                self.restitution(Groups::new(chi, at.elastic_psi(psi)).unwrap_or(groups))?;
            let [a, b, c] = [0, 1, 2].map(|loss| weights[loss + 1] * at.loss(loss));
            return Ok((weights[0] * elastic + a) + (b + c));
        };
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| weights[k] * at.loss(second + k));
        Ok((a + b) + (c + d))
    }

    /// The stored numbers of the table with a loss: by e, then chi, then psi, each of four bytes, little-endian.
    #[must_use]
    pub const fn stored_losses() -> &'static [u8] {
        STORED
    }

    /// The numbers of the table with a loss, computed anew, as bytes.
    #[must_use]
    pub fn losses_to_bytes() -> Vec<u8> {
        let mut bytes = Vec::with_capacity(4 * COUNT);
        for e in LOSSES {
            for i in 0..CHIS {
                let chi = RANGE[0] * libm::pow(RANGE[1] / RANGE[0], i as f64 / (CHIS - 1) as f64);
                for k in 0..ROW {
                    let psi = if k < PSIS {
                        k as f64 / (PSIS - 1) as f64
                    } else {
                        let part = (k - PSIS) as f64 / (PSIS_BEYOND - 1) as f64;
                        1.0 + part * (border(chi, e) - 1.0)
                    };
                    let r_x = Groups::new(chi, psi.max(SLOWEST))
                        .map_or(f64::NAN, |groups| followed(groups, e, FILLING));
                    bytes.extend((r_x as f32).to_le_bytes());
                }
            }
        }
        bytes
    }
}

/// What all restitutions of the table share at a chi and a psi.
struct At {
    /// The place of the first number within the grid of a restitution.
    start: usize,
    /// Weights of four chi, of four psi each.
    weights: [[f64; 4]; 4],
    chi: f64,
    /// The part of the way from psi = 1 to sliding throughout; 0 below psi = 1.
    part: f64,
}

impl At {
    fn new(chi: f64, psi: f64, border: f64) -> Self {
        let (column, along_chi) = of_chi(chi);
        let part = if psi < 1.0 { 0.0 } else { (psi - 1.0) / (border - 1.0) };
        let (block, place, count) =
            if psi < 1.0 { (0, psi, PSIS) } else { (PSIS, part, PSIS_BEYOND) };
        let (row, along_psi) = evenly(place * (count - 1) as f64, count);
        let weights = along_chi.map(|of_chi| along_psi.map(|of_psi| of_chi * of_psi));
        Self { start: column * ROW + block + row, weights, chi, part }
    }

    /// psi of an elastic impact at the same part.
    fn elastic_psi(&self, psi: f64) -> f64 {
        if psi < 1.0 { psi } else { 1.0 + self.part * (border(self.chi, 1.0) - 1.0) }
    }

    /// R_x at one restitution of the table.
    #[inline(always)]
    fn loss(&self, loss: usize) -> f64 {
        let mut sums = [0.0; 4];
        for (i, weights) in self.weights.iter().enumerate() {
            let numbers = stored(loss * GRID + self.start + i * ROW);
            for k in 0..4 {
                sums[k] += weights[k] * numbers[k];
            }
        }
        (sums[0] + sums[1]) + (sums[2] + sums[3])
    }
}

/// Four numbers of the table.
fn stored(from: usize) -> [f64; 4] {
    let bytes: Option<&[u8; 16]> = STORED.get(4 * from..).and_then(|bytes| bytes.first_chunk());
    let Some(bytes) = bytes else { return [f64::NAN; 4] };
    let (numbers, _) = bytes.as_chunks::<4>();
    [0, 1, 2, 3].map(|i| f64::from(f32::from_le_bytes(numbers[i])))
}

/// psi from which the contact slides throughout.
fn border(chi: f64, e: f64) -> f64 {
    (chi * (1.0 + e) - e).max(1.0)
}

fn slid(chi: f64, psi: f64, e: f64) -> f64 {
    chi * (1.0 + e) / psi - 1.0
}

fn followed(groups: Groups, e: f64, tolerance: f64) -> f64 {
    let loss = ViscousLoss::of_restitution(e.max(0.0));
    loss.map_or(f64::NAN, |loss| ViscoelasticImpact::new(groups, loss).solve(tolerance).restitution)
}

fn of_chi(chi: f64) -> Weights {
    evenly(libm::log(chi / RANGE[0]) * PER_LOG, CHIS)
}

/// Cubic weights of nodes at 0, 1, 2, ...
fn evenly(place: f64, count: usize) -> Weights {
    let first = (place as usize).saturating_sub(1).min(count - 4);
    let t = place - first as f64;
    let [a, b, c, d] = [t, t - 1.0, t - 2.0, t - 3.0];
    (first, [-b * c * d / 6.0, a * c * d / 2.0, -a * b * d / 2.0, a * b * c / 6.0])
}

/// Cubic weights of e = 1 and the restitutions of the table.
fn of_e(e: f64) -> Weights {
    let below: usize = LOSSES.iter().map(|loss| usize::from(*loss >= e)).sum();
    let first = below.saturating_sub(1).min(LOSSES.len() - 3);
    let [a, b, c, d] = [0, 1, 2, 3].map(|k| e - node(first + k));
    let scale = &SCALES[first];
    (
        first,
        [b * c * d * scale[0], a * c * d * scale[1], a * b * d * scale[2], a * b * c * scale[3]],
    )
}

/// e = 1 and the restitutions of the table.
const fn node(k: usize) -> f64 {
    if k == 0 { 1.0 } else { LOSSES[k - 1] }
}

/// One over the products of the distances of each of four nodes to the others, by the first.
const SCALES: [[f64; 4]; LOSSES.len() - 2] = {
    let mut scales = [[1.0; 4]; LOSSES.len() - 2];
    let mut first = 0;
    while first < scales.len() {
        let mut k = 0;
        while k < 4 {
            let mut product = 1.0;
            let mut other = 0;
            while other < 4 {
                if other != k {
                    product *= node(first + k) - node(first + other);
                }
                other += 1;
            }
            scales[first][k] = 1.0 / product;
            k += 1;
        }
        first += 1;
    }
    scales
};

#[cfg(test)]
mod tests {
    use super::*;

    /// The numbers are those of impacts, at nodes that a test can afford.
    #[test]
    fn the_stored_numbers_are_those_of_impacts() {
        for (loss, e) in LOSSES.into_iter().enumerate() {
            let chi = RANGE[0] * libm::pow(RANGE[1] / RANGE[0], 0.5);
            for (k, psi) in [(4, 0.25), (PSIS + PSIS_BEYOND / 2, 0.5 * (1.0 + border(chi, e)))] {
                let known = followed(Groups::new(chi, psi).unwrap(), e, FILLING);
                let [told, ..] = stored(loss * GRID + (CHIS / 2) * ROW + k);
                assert!((told - known).abs() < 1e-6, "{e} {psi}: {told} {known}");
            }
        }
    }

    #[test]
    #[ignore = "builds the table: half a minute"]
    fn the_stored_table_is_what_is_built() {
        assert_eq!(RestitutionTable::losses_to_bytes(), STORED);
    }
}
