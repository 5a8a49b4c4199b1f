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
const CHIS: usize = 17;
const RANGE: [f64; 2] = [0.66, 6.5];
/// Nodes over the logarithm of chi: (CHIS - 1)/ln(6.5/.66).
const PER_LOG: f64 = 6.995_093_228_006_278;
/// Nodes of psi in a block.
const PSIS: usize = 17;
/// Numbers of one restitution, of one chi.
const GRID: usize = CHIS * ROW;
const ROW: usize = 2 * PSIS;
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
    /// e from .1, 2e-4 in the mean; exact where the contact slides throughout. At e = 1 it is [`RestitutionTable::restitution`].
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
        let at = At::new(chi, psi);
        let (first, weights) = of_e(e);
        let mut sum = 0.0;
        for (k, weight) in weights.into_iter().enumerate() {
            sum += weight
                * match (first + k).checked_sub(1) {
                    None => self.restitution(groups)?,
                    Some(loss) => at.loss(loss),
                };
        }
        Ok(sum)
    }

    /// The numbers of the table with a loss, as bytes.
    #[must_use]
    pub fn losses_to_bytes() -> Vec<u8> {
        let mut bytes = Vec::with_capacity(4 * COUNT);
        for e in LOSSES {
            for i in 0..CHIS {
                let chi = RANGE[0] * libm::pow(RANGE[1] / RANGE[0], i as f64 / (CHIS - 1) as f64);
                for k in 0..ROW {
                    let part = (k % PSIS) as f64 / (PSIS - 1) as f64;
                    let psi = if k < PSIS { part } else { 1.0 + part * (border(chi, e) - 1.0) };
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
    chi: f64,
    psi: f64,
    column: usize,
    along_chi: [f64; 4],
    /// (psi - 1)/(chi - 1): beyond psi = 1, psi over its border is this over 1 + e.
    beyond: f64,
    /// Below psi = 1.
    along_psi: Weights,
}

impl At {
    fn new(chi: f64, psi: f64) -> Self {
        let (column, along_chi) = of_chi(chi);
        let beyond = if psi < 1.0 { 0.0 } else { (psi - 1.0) / (chi - 1.0) };
        let along_psi = evenly(psi.min(1.0) * (PSIS - 1) as f64, PSIS);
        Self { chi, psi, column, along_chi, beyond, along_psi }
    }

    /// R_x at one restitution of the table.
    #[inline(always)]
    fn loss(&self, loss: usize) -> f64 {
        let start = loss * GRID + self.column * ROW;
        if self.psi < 1.0 {
            return self.sum(start, &self.along_psi);
        }
        let part = self.beyond * PARTS[loss];
        if self.chi <= 1.0 || part >= 1.0 {
            return slid(self.chi, self.psi, LOSSES[loss]);
        }
        self.sum(start + PSIS, &evenly(part * (PSIS - 1) as f64, PSIS))
    }

    #[inline(always)]
    fn sum(&self, start: usize, (row, along_psi): &Weights) -> f64 {
        let along = |i: usize| {
            let [a, b, c, d] = stored(start + row + i * ROW);
            (along_psi[0] * a + along_psi[1] * b) + (along_psi[2] * c + along_psi[3] * d)
        };
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| self.along_chi[i] * along(i));
        (a + b) + (c + d)
    }
}

/// 1/(1 + e) of each restitution.
const PARTS: [f64; LOSSES.len()] = {
    let mut parts = [0.0; LOSSES.len()];
    let mut loss = 0;
    while loss < parts.len() {
        parts[loss] = 1.0 / (1.0 + LOSSES[loss]);
        loss += 1;
    }
    parts
};

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
            for (k, psi) in [(4, 0.25), (PSIS + 8, 0.5 * (1.0 + border(chi, e)))] {
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
