//! A twisted contact divided into rings, with any pattern of stick and slip.
//!
//! Each ring has one unknown: tractions are within the friction limit, and slip occurs only where
//! the limit is reached, in the direction of the traction. The density of [`super::history`]
//! relates tractions to rotations: a disc of radius s with the density b rotates the surface by b
//! inside s and by `b [1 - W(s/rho)]` outside. Discs inside all slip keep their density, so that
//! rings are needed only outside a radius.

use super::mesh::Mesh;

/// The influence of all rings of a contact on each other.
pub(super) struct Rings<'a> {
    mesh: &'a Mesh,
    /// Traction divided by radius of a ring due to the density of another, row by row; only
    /// densities outside contribute.
    traction: Vec<f64>,
    /// Slip of a ring due to the density of another; only densities inside contribute.
    slip: Vec<f64>,
    /// Tractions divided by radius of the averaged sliding densities, the limits.
    limits: Vec<f64>,
}

impl<'a> Rings<'a> {
    pub(super) fn new(mesh: &'a Mesh) -> Self {
        let n = mesh.len();
        let (mut traction, mut slip) = (vec![0.0; n * n], vec![0.0; n * n]);
        for i in 0..n {
            mesh.tractions(i, &mut traction[i * n..=i * n + i]);
            mesh.slips(i, &mut slip[i * n + i..(i + 1) * n]);
        }
        let mut rings = Self { mesh, traction, slip, limits: Vec::new() };
        rings.limits = rings.tractions(mesh.sliding());
        rings
    }

    /// The rings.
    pub(super) const fn mesh(&self) -> &'a Mesh {
        self.mesh
    }

    /// Greatest tractions divided by radius. They are those of the averaged sliding density, so
    /// that smaller densities are within friction and sliding is represented exactly.
    pub(super) fn limits(&self) -> &[f64] {
        &self.limits
    }

    /// Tractions divided by radius, from densities.
    pub(super) fn tractions(&self, densities: &[f64]) -> Vec<f64> {
        let n = densities.len();
        (0..n).map(|i| dot(&self.traction[i * n..=i * n + i], &densities[..=i])).collect()
    }

    /// Densities, from tractions divided by radius.
    pub(super) fn densities(&self, tractions: &[f64]) -> Vec<f64> {
        let n = tractions.len();
        let mut densities = Vec::with_capacity(n);
        for (i, traction) in tractions.iter().enumerate() {
            let row = &self.traction[i * n..=i * n + i];
            densities.push((traction - dot(&row[..i], &densities)) / row[i]);
        }
        densities
    }

    /// Slip of a ring, as an angle, from changes of the densities and of the twist inside the rings.
    pub(super) fn slip(&self, i: usize, changes: &[f64], core: f64) -> f64 {
        let n = self.mesh.len();
        core + dot(&self.slip[i * n + i..(i + 1) * n], &changes[i..])
    }

    /// Tractions divided by radius of a ring due to the densities outside it, and due to its own.
    pub(super) fn tractions_of(&self, i: usize) -> (&[f64], f64) {
        let row = &self.traction[i * self.mesh.len()..];
        (&row[..i], row[i])
    }

    /// Slips of a ring due to its own density, and due to those inside it.
    pub(super) fn slips_of(&self, i: usize) -> (f64, &[f64]) {
        let n = self.mesh.len();
        (self.slip[i * n + i], &self.slip[i * n + i + 1..(i + 1) * n])
    }

    /// Rotations of a ring due to unit tractions divided by radius: that of all discs together,
    /// minus its slip.
    pub(super) fn compliance(&self, i: usize) -> Vec<f64> {
        let n = self.mesh.len();
        let slip = &self.slip[i * n..(i + 1) * n];
        let mut row: Vec<f64> =
            self.mesh.widths().zip(slip).map(|(width, slip)| width - slip).collect();
        // From rotations due to densities to those due to tractions.
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

    /// The twist of the rings, from their densities.
    pub(super) fn twist(&self, densities: &[f64]) -> f64 {
        self.mesh.widths().zip(densities).map(|(width, density)| width * density).sum()
    }
}

/// The sum of products of two rows.
pub(super) fn dot(row: &[f64], values: &[f64]) -> f64 {
    // Eight independent sums, for instruction-level parallelism.
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
