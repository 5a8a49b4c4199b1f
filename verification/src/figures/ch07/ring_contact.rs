//! A circular contact of half-spaces with Coulomb's law on rings, for ν = 0.
//!
//! Without Poisson's effect a traction that is constant along circles displaces them rigidly, in its own
//! direction. Tractions between rings are superpositions of semispheres; the displacement of each comes from
//! the field of the contact law. Every step is solved by the Gauss-Seidel method, with the traction of each
//! ring kept within its own limit.

use crate::Failure;
use carom_halfspace::{Material, MaterialPair};
use carom_laws::field::circular_shear;
use carom_laws::memory::Lateral;

const MAX_SWEEPS: usize = 20_000;
/// A step is converged if no traction changes by more than this, relative to the largest friction limit.
const SETTLED: f64 = 1e-7;

/// Rings on a contact of radius 1. Tractions are divided by f p_z at the centre, shifts by that of complete
/// sliding.
#[derive(Debug, Clone)]
pub(super) struct RingContact {
    radii: Vec<f64>,
    /// Displacement of ring i (rows) under a traction on ring j.
    compliance: Vec<Vec<f64>>,
    /// Force over f F_z under a traction on ring j.
    share: Vec<f64>,
    traction: Vec<[f64; 2]>,
    /// Accumulated slip, and slip of the last step.
    slid: Vec<[f64; 2]>,
    slip: Vec<[f64; 2]>,
}

impl RingContact {
    /// A contact in its initial state, with rings of equal width.
    pub(super) fn new(count: usize) -> Result<Self, Failure> {
        let pair = MaterialPair::new(Material::from_shear(1.0, 0.0)?, Material::RIGID)?;
        let edges: Vec<f64> = (1..=count).map(|k| k as f64 / count as f64).collect();
        let radii: Vec<f64> = edges.iter().map(|edge| edge - 0.5 / count as f64).collect();
        // Under f p_z all over, the centre moves by pi/4: the shift 1.
        let unit = 4.0 / std::f64::consts::PI;
        let field: Vec<Vec<f64>> = radii
            .iter()
            .map(|&r| {
                let by = |edge: &f64| unit * circular_shear(*edge, *edge, &pair, r, 0.0)[0];
                edges.iter().map(by).collect()
            })
            .collect();
        let semisphere =
            |i: usize, k: usize| (edges[k] * edges[k] - radii[i] * radii[i]).max(0.0).sqrt();
        let (mut compliance, mut share) = (vec![vec![0.0; count]; count], vec![0.0; count]);
        for j in 0..count {
            // Semispheres that together make the traction 1 on ring j alone, from the rim inwards.
            let mut parts = vec![0.0; count];
            for i in (0..=j).rev() {
                let outer: f64 = (i + 1..=j).map(|k| parts[k] * semisphere(i, k)).sum();
                parts[i] = (f64::from(u8::from(i == j)) - outer) / semisphere(i, i);
            }
            share[j] = parts.iter().zip(&edges).map(|(part, edge)| part * edge.powi(3)).sum();
            for (row, field) in compliance.iter_mut().zip(&field) {
                row[j] = parts.iter().zip(field).map(|(part, u)| part * u).sum();
            }
        }
        let rest = vec![[0.0; 2]; count];
        let (traction, slid, slip) = (rest.clone(), rest.clone(), rest);
        Ok(Self { radii, compliance, share, traction, slid, slip })
    }

    /// Goes straight to a shift, in one step.
    pub(super) fn advance(&mut self, shift: [f64; 2]) -> Result<(), Failure> {
        for _ in 0..MAX_SWEEPS {
            let mut change = 0.0_f64;
            for i in 0..self.radii.len() {
                let limit = (1.0 - self.radii[i] * self.radii[i]).sqrt();
                let lag = self.lag(i, shift);
                let trial = self.traction[i].plus(lag.times(1.0 / self.compliance[i][i]));
                let size = trial.length();
                let claims_that_hold = if size > limit { trial.times(limit / size) } else { trial };
                change = change.max(claims_that_hold.minus(self.traction[i]).length());
                self.traction[i] = claims_that_hold;
            }
            if change < SETTLED {
                for i in 0..self.radii.len() {
                    self.slip[i] = self.lag(i, shift);
                }
                for (slid, slip) in self.slid.iter_mut().zip(&self.slip) {
                    *slid = slid.plus(*slip);
                }
                return Ok(());
            }
        }
        Err("the rings do not settle".into())
    }

    /// The difference between the displacement of ring i and the shift.
    fn lag(&self, i: usize, shift: [f64; 2]) -> [f64; 2] {
        let pairs = self.compliance[i].iter().zip(&self.traction);
        let sum = pairs.fold([0.0; 2], |sum, (c, t)| [sum[0] + c * t[0], sum[1] + c * t[1]]);
        shift.minus(self.slid[i]).minus(sum)
    }

    /// Radii of the rings.
    pub(super) fn radii(&self) -> &[f64] {
        &self.radii
    }

    /// Tractions on body 1.
    pub(super) fn tractions(&self) -> &[[f64; 2]] {
        &self.traction
    }

    /// Slip of body 2 over body 1 in the last step.
    pub(super) fn slips(&self) -> &[[f64; 2]] {
        &self.slip
    }

    /// F_x, F_y over f F_z.
    pub(super) fn force(&self) -> [f64; 2] {
        let pairs = self.share.iter().zip(&self.traction);
        pairs.fold([0.0; 2], |sum, (share, t)| sum.plus(t.times(*share)))
    }
}
