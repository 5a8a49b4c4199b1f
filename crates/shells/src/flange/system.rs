//! Assembly and solution of the equations of a flange.

use std::f64::consts::PI;

use carom_dense::{Mat, c64};
use carom_special::RangeError;
use nalgebra::{Matrix4, Vector4};

use super::edge::TubeEdge;
use super::force::RingForce;
use super::ring::{Ring, RingOperator};
use super::section::StiffnessKind;
use super::solution::FlangeSolution;
use super::tube::Tube;
use crate::dense::{self, Singular};
use crate::fourier::ComplexSeries;

/// Why a flange cannot be solved.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum FlangeError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// Equations without a solution in floating point.
    #[error(transparent)]
    Singular(#[from] Singular),
}

/// The tube of a flange and where it is fixed.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Support {
    tube: Tube,
    edge: TubeEdge,
}

/// A ring, bare or at the end of a tube.
///
/// Without a tube, and on a semi-infinite one, nothing fixes the motion of the whole: v_k = u_k = 0
/// for |k| <= 1 are held, and what holds them takes the resultant of the forces.
///
/// ```
/// use carom_shells::flange::{Flange, Ring, RingForce, RingStiffness};
/// let stiff = RingStiffness::new(1e6, 1.0, 1.0, 1.0)?; // cannot stretch
/// let pinched = Flange::bare(Ring::new(1.0, stiff)?).solve(&RingForce::pinch(1.0)?, 64)?;
/// // Timoshenko: M = P R/pi under the load, P R (1/pi - 1/2) a quarter further.
/// assert!((pinched.loads(0.0).in_plane - 0.3183099).abs() < 1e-7);
/// assert!((pinched.loads(1.5707963).in_plane + 0.1816901).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Flange {
    ring: Ring,
    support: Option<Support>,
}

/// Least and greatest number of harmonics.
const HARMONICS: std::ops::RangeInclusive<usize> = 4..=256;
/// The most forces.
const MOST_FORCES: usize = 10_000;

impl Flange {
    /// A ring alone.
    #[must_use]
    pub const fn bare(ring: Ring) -> Self {
        Self { ring, support: None }
    }

    /// A ring at the end of a tube. In a consistent geometry the edge lies tube radius - ring
    /// radius outward of the centroid; this is not required, so that an edge can be shifted alone.
    ///
    /// # Errors
    /// [`RangeError`] unless the radius of the tube is within a quarter of that of the ring, and
    /// the edge within a quarter of the radius from the centroid.
    pub fn on_tube(ring: Ring, tube: Tube, edge: TubeEdge) -> Result<Self, RangeError> {
        let radius = ring.radius();
        let near = |value: f64| value.abs() <= 0.25 * radius;
        let allowed = "within a quarter of the ring's radius of it";
        RangeError::check(
            "radius of the tube",
            tube.radius(),
            near(tube.radius() - radius),
            allowed,
        )?;
        let allowed = "within a quarter of the ring's radius";
        RangeError::check("along", edge.along(), near(edge.along()), allowed)?;
        RangeError::check("outward", edge.outward(), near(edge.outward()), allowed)?;
        Ok(Self { ring, support: Some(Support { tube, edge }) })
    }

    /// The ring.
    #[must_use]
    pub const fn ring(&self) -> &Ring {
        &self.ring
    }

    /// The tube, if there is one.
    #[must_use]
    pub fn tube(&self) -> Option<&Tube> {
        self.support.as_ref().map(|support| &support.tube)
    }

    /// The displacements under these forces with harmonics up to `harmonics`, from 4 to 256.
    /// Sums of these harmonics converge as `harmonics`^-3 (displacements) and 1/`harmonics` (loads of
    /// the ring); the solution adds the rest of the kinks and jumps where forces act.
    ///
    /// # Errors
    /// [`FlangeError::Range`] for the number of harmonics, or more than 10000 forces;
    /// [`FlangeError::Singular`] if numbers overflow.
    pub fn solve(
        &self,
        forces: &[RingForce],
        harmonics: usize,
    ) -> Result<FlangeSolution, FlangeError> {
        let fits = HARMONICS.contains(&harmonics);
        RangeError::check("harmonics", harmonics as f64, fits, "from 4 to 256")?;
        let count = forces.len();
        RangeError::check("forces", count as f64, count <= MOST_FORCES, "at most 10000")?;
        let system = System::new(self, harmonics)?;
        let found = system.solve(&self.right(forces, harmonics))?;
        FlangeSolution::new(self, &system, forces, &found)
    }

    /// Work of the forces on (w/R, v/R, u/R, beta) of each harmonic.
    fn right(&self, forces: &[RingForce], harmonics: usize) -> Vec<Vector4<c64>> {
        let order = harmonics as i64;
        let arm = Vector4::from(self.scale());
        let of_harmonic = |k: i64| {
            let each = forces.iter().map(|force| {
                let angle = k as f64 * force.angle();
                let turn = c64::new(libm::cos(angle), -libm::sin(angle));
                Vector4::from(force.components()).component_mul(&arm).map(|part| turn * part)
            });
            let mut sum: Vector4<c64> = each.sum();
            for &motion in self.held(k) {
                sum[motion] = c64::new(0.0, 0.0);
            }
            sum
        };
        (-order..=order).map(of_harmonic).collect()
    }

    /// Displacements per unit of (w/R, v/R, u/R, beta).
    pub(super) const fn scale(&self) -> [f64; 4] {
        let radius = self.ring.radius();
        [radius, radius, radius, 1.0]
    }

    /// The motions of harmonic k that are held, because nothing else fixes the whole.
    fn held(&self, k: i64) -> &'static [usize] {
        let is_fixed = self.tube().is_some_and(|tube| tube.length().is_some());
        if is_fixed || k.abs() > 1 { &[] } else { &[1, 2] }
    }

    /// Stiffness of the tube against (w/R, v/R, u/R, beta) of the ring.
    fn tube_block(&self, k: i64) -> Result<Matrix4<c64>, FlangeError> {
        let Some(Support { tube, edge }) = &self.support else { return Ok(Matrix4::zeros()) };
        let scale = Matrix4::from_diagonal(&Vector4::from(self.scale()).map(|x| c64::new(x, 0.0)));
        let motion = edge.motion(self.ring.radius(), k) * scale;
        Ok(motion.adjoint() * tube.edge_stiffness(k)?.matrix() * motion)
    }
}

/// The equations: operators of the ring, blocks of the tube.
pub(super) struct System {
    harmonics: usize,
    operators: [RingOperator; 4],
    /// 2 pi/R, which makes an energy of the operators.
    per_radius: f64,
    pub(super) tube_blocks: Vec<Matrix4<c64>>,
    held: Vec<&'static [usize]>,
    is_uniform: bool,
}

impl System {
    fn new(flange: &Flange, harmonics: usize) -> Result<Self, FlangeError> {
        let order = harmonics as i64;
        let [a, b, c, d] = StiffnessKind::ALL.map(|kind| flange.ring.operator(kind, harmonics));
        let tube_blocks: Result<Vec<_>, _> =
            (-order..=order).map(|k| flange.tube_block(k)).collect();
        Ok(Self {
            harmonics,
            operators: [a?, b?, c?, d?],
            per_radius: 2.0 * PI / flange.ring.radius(),
            tube_blocks: tube_blocks?,
            held: (-order..=order).map(|k| flange.held(k)).collect(),
            is_uniform: flange.ring.is_uniform(),
        })
    }

    pub(super) const fn harmonics(&self) -> usize {
        self.harmonics
    }

    const fn harmonic(&self, index: usize) -> i64 {
        index as i64 - self.harmonics as i64
    }

    /// Stiffness of the harmonic of `row` against that of `column`.
    fn block(&self, row: usize, column: usize) -> Matrix4<c64> {
        let mut block = if row == column { self.tube_blocks[row] } else { Matrix4::zeros() };
        for (kind, operator) in StiffnessKind::ALL.into_iter().zip(&self.operators) {
            let entry = operator.entry(row, column) * self.per_radius;
            if entry == c64::new(0.0, 0.0) {
                continue;
            }
            let to = Ring::strain_row(kind, self.harmonic(row));
            let from = Ring::strain_row(kind, self.harmonic(column));
            block += Matrix4::from_fn(|i, j| to[i].conj() * entry * from[j]);
        }
        for (place, is_row) in [(row, true), (column, false)] {
            for &motion in self.held[place] {
                for other in 0..4 {
                    let at = if is_row { (motion, other) } else { (other, motion) };
                    block[at] = c64::new(0.0, 0.0);
                }
            }
        }
        if row == column {
            for &motion in self.held[row] {
                block[(motion, motion)] = c64::new(self.per_radius, 0.0);
            }
        }
        block
    }

    /// (w/R, v/R, u/R, beta) of each harmonic.
    fn solve(&self, right: &[Vector4<c64>]) -> Result<Vec<Vector4<c64>>, Singular> {
        let count = right.len();
        if self.is_uniform {
            let one = |i: usize| solve_blocks(1, |_, _| self.block(i, i), &right[i..=i]);
            let found: Result<Vec<_>, _> = (0..count).map(one).collect();
            return Ok(found?.concat());
        }
        solve_blocks(count, |row, column| self.block(row, column), right)
    }

    /// Coefficients of a load of the ring times R (times R^2 for N).
    pub(super) fn load(&self, kind: StiffnessKind, found: &[Vector4<c64>]) -> ComplexSeries {
        let strains: Vec<c64> = found
            .iter()
            .enumerate()
            .map(|(i, y)| {
                let row = Ring::strain_row(kind, self.harmonic(i));
                row.iter().zip(y.iter()).map(|(a, b)| a * b).sum()
            })
            .collect();
        let operator = &self.operators[kind as usize];
        let load = |row: usize| {
            strains.iter().enumerate().map(|(column, s)| operator.entry(row, column) * s).sum()
        };
        ComplexSeries::from_coefficients((0..found.len()).map(load).collect())
    }
}

fn solve_blocks(
    count: usize,
    block: impl Fn(usize, usize) -> Matrix4<c64>,
    right: &[Vector4<c64>],
) -> Result<Vec<Vector4<c64>>, Singular> {
    let mut matrix = Mat::<c64>::zeros(4 * count, 4 * count);
    for column in 0..count {
        for row in 0..count {
            let block = block(row, column);
            for j in 0..4 {
                for i in 0..4 {
                    matrix[(4 * row + i, 4 * column + j)] = block[(i, j)];
                }
            }
        }
    }
    let right = Mat::from_fn(4 * count, 1, |i, _| right[i / 4][i % 4]);
    let found = dense::solve(&matrix, &right)?;
    Ok((0..count).map(|k| Vector4::from_fn(|i, _| found[(4 * k + i, 0)])).collect())
}
