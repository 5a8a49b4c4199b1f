//! Displacements and loads of a flange.

use std::f64::consts::PI;

use carom_dense::c64;
use nalgebra::{Complex, Vector4};

use super::edge::EdgeMotion;
use super::force::RingForce;
use super::kink::Tails;
use super::ring::Ring;
use super::section::StiffnessKind;
use super::system::{Flange, FlangeError, System};
use crate::fourier::ComplexSeries;

/// Displacement of a section of the ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingDisplacement {
    /// w, outward.
    pub radial: f64,
    /// v, along phi.
    pub tangential: f64,
    /// u, along the tube.
    pub axial: f64,
    /// beta, of the section; dw/dx.
    pub rotation: f64,
}

/// Loads on a section of the ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingLoads {
    /// N, the hoop force; tension is positive.
    pub stretching: f64,
    /// M, positive if it increases the curvature of the ring.
    pub in_plane: f64,
    /// M_o, bending out of the plane.
    pub out_of_plane: f64,
    /// T, torsion.
    pub torsion: f64,
}

/// Whether the half-momentless theory of the tube applies: it needs n^2 t/R << 1 for the harmonics
/// that matter. A flange 0.08 by 0.10 R, t/R = 0.02: for pinching `mean` is 0.08 and the opening
/// 0.3 % off, for prying `mean` is 0.34 and the displacement 13 % off. Prying is local: use
/// [`super::Tube::koiter_sanders`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shallowness {
    /// The harmonic n that carries most energy of the tube.
    pub harmonic: usize,
    /// n^2 t/R of that harmonic.
    pub of_greatest: f64,
    /// The mean of n^2 t/R over harmonics, weighted by their energies in the tube.
    pub mean: f64,
}

/// The solution of [`Flange::solve`].
///
/// ```
/// use carom_shells::{Wall, flange::{Flange, Ring, RingForce, RingStiffness, Tube, TubeEdge}};
/// let ring = Ring::new(1.0, RingStiffness::rectangle(1.0, 0.3, 0.08, 0.1)?)?;
/// let tube = Tube::half_momentless(1.0, Wall::new(1.0, 0.3, 0.02)?)?;
/// let solved = Flange::on_tube(ring, tube, TubeEdge::at_centroid())?
///     .solve(&RingForce::pinch(1.0)?, 32)?;
/// // Work of the loads: twice the opening at one of them.
/// let opening = 2.0 * solved.partial_sum(0.0).radial;
/// assert!((solved.twice_energy() / opening - 1.0).abs() < 1e-12);
/// assert_eq!(solved.shallowness().unwrap().harmonic, 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FlangeSolution {
    ring: Ring,
    forces: Vec<RingForce>,
    harmonics: usize,
    /// w, v, u, beta.
    motions: [ComplexSeries; 4],
    /// N, M, M_o, T.
    loads: [ComplexSeries; 4],
    shallowness: Option<Shallowness>,
}

impl FlangeSolution {
    pub(super) fn new(
        flange: &Flange,
        system: &System,
        forces: &[RingForce],
        found: &[Vector4<c64>],
    ) -> Result<Self, FlangeError> {
        let radius = flange.ring().radius();
        let scale = flange.scale();
        let motion = |i: usize| {
            ComplexSeries::from_coefficients(found.iter().map(|y| y[i] * scale[i]).collect())
        };
        let load = |kind: StiffnessKind| {
            let unit = match kind {
                StiffnessKind::Stretching => 1.0 / (radius * radius),
                _ => 1.0 / radius,
            };
            let series = system.load(kind, found);
            let order = series.order() as i64;
            let coefficients = (-order..=order).map(|k| series.coefficient(k) * unit).collect();
            ComplexSeries::from_coefficients(coefficients)
        };
        Ok(Self {
            ring: flange.ring().clone(),
            forces: forces.to_vec(),
            harmonics: system.harmonics(),
            motions: [0, 1, 2, 3].map(motion),
            loads: StiffnessKind::ALL.map(load),
            shallowness: flange.tube().and_then(|tube| {
                shallowness(system, found, tube.wall().thickness() / tube.radius())
            }),
        })
    }

    /// Number of harmonics.
    #[must_use]
    pub const fn harmonics(&self) -> usize {
        self.harmonics
    }

    /// Coefficient of e^(ik phi) of a motion.
    #[must_use]
    pub fn coefficient(&self, motion: EdgeMotion, k: i64) -> Complex<f64> {
        self.motions[motion as usize].coefficient(k)
    }

    /// The displacement at an angle, by the harmonics that were solved for.
    #[must_use]
    pub fn partial_sum(&self, angle: f64) -> RingDisplacement {
        let [radial, tangential, axial, rotation] =
            self.motions.each_ref().map(|series| series.at(angle).re);
        RingDisplacement { radial, tangential, axial, rotation }
    }

    /// The displacement at an angle. To w, u and beta are added the remaining harmonics of a ring
    /// whose stiffness is that where a force acts; errors of order harmonics^-3, of beta under a
    /// couple harmonics^-1, go.
    #[must_use]
    pub fn displacement(&self, angle: f64) -> RingDisplacement {
        let mut sum = self.partial_sum(angle);
        let r = self.ring.radius();
        for force in &self.forces {
            let at = force.angle();
            let [stretching, in_plane, out_of_plane, torsion] =
                StiffnessKind::ALL.map(|kind| 1.0 / self.ring.stiffness_at(kind, at));
            let Tails { second, fourth, .. } = Tails::new(angle - at, self.harmonics);
            let [outward, _, along_tube, couple] = force.components();
            let unit = r / (2.0 * PI);
            let both = (out_of_plane + torsion) * fourth;
            sum.radial += outward * unit * (r * r * in_plane + stretching) * fourth;
            sum.axial += unit * r * (r * along_tube * out_of_plane * fourth - couple * both);
            sum.rotation += unit * (couple * torsion * second + (couple - r * along_tube) * both);
        }
        sum
    }

    /// The loads on a section, by the harmonics that were solved for.
    #[must_use]
    pub fn partial_loads(&self, angle: f64) -> RingLoads {
        let [stretching, in_plane, out_of_plane, torsion] =
            self.loads.each_ref().map(|series| series.at(angle).re);
        RingLoads { stretching, in_plane, out_of_plane, torsion }
    }

    /// The loads on a section. The remaining harmonics of the kinks and jumps that a force makes in
    /// them are added; they follow from equilibrium and do not depend on stiffness. Where a load
    /// jumps, it is the mean of both sides.
    #[must_use]
    pub fn loads(&self, angle: f64) -> RingLoads {
        let mut sum = self.partial_loads(angle);
        let r = self.ring.radius();
        for force in &self.forces {
            let tails = Tails::new(angle - force.angle(), self.harmonics);
            let [outward, along_ring, along_tube, couple] =
                force.components().map(|component| component / (2.0 * PI));
            let bending = outward * tails.second + along_ring * tails.third;
            sum.in_plane += r * bending;
            sum.stretching -= bending + along_ring * tails.first;
            let turning = r * along_tube - couple;
            sum.out_of_plane += turning * tails.second;
            sum.torsion += turning * tails.third - couple * tails.first;
        }
        sum
    }

    /// Twice the stored energy: the work of the forces on the displacements solved for.
    #[must_use]
    pub fn twice_energy(&self) -> f64 {
        let work = |force: &RingForce| {
            let y = self.partial_sum(force.angle());
            let y = [y.radial, y.tangential, y.axial, y.rotation];
            force.components().iter().zip(y).map(|(f, y)| f * y).sum::<f64>()
        };
        self.forces.iter().map(work).sum()
    }

    /// n^2 t/R of the harmonics that strain the tube; none without a tube or without its strain.
    #[must_use]
    pub const fn shallowness(&self) -> Option<Shallowness> {
        self.shallowness
    }

    /// The greatest coefficient of the last eighth of the harmonics over the greatest of all, the
    /// largest of w, v, u and R beta: an estimate of the truncation.
    #[must_use]
    pub fn truncation(&self) -> f64 {
        let order = self.harmonics as i64;
        let last = order - order / 8;
        let size = |from: i64, i: usize| {
            let weight = if i == 3 { self.ring.radius() } else { 1.0 };
            let each = (from..=order).map(|k| self.motions[i].coefficient(k).norm_sqr());
            weight * each.fold(0.0, f64::max).sqrt()
        };
        let greatest = |from: i64| (0..4).map(|i| size(from, i)).fold(0.0, f64::max);
        let all = greatest(0);
        if all > 0.0 { greatest(last) / all } else { 0.0 }
    }
}

fn shallowness(system: &System, found: &[Vector4<c64>], thinness: f64) -> Option<Shallowness> {
    let order = system.harmonics();
    let energy = |n: usize| -> f64 {
        let both = [order - n, order + n];
        let of = |i: usize| (found[i].adjoint() * system.tube_blocks[i] * found[i])[(0, 0)].re;
        both.into_iter().map(of).sum::<f64>().max(0.0)
    };
    let energies: Vec<f64> = (1..=order).map(energy).collect();
    let total: f64 = energies.iter().sum();
    let measure = |n: usize| (n * n) as f64 * thinness;
    let mut greatest = 0;
    for (i, energy) in energies.iter().enumerate() {
        if *energy > energies[greatest] {
            greatest = i;
        }
    }
    let weighted = energies.iter().enumerate().map(|(i, energy)| measure(i + 1) * energy);
    let mean = weighted.sum::<f64>() / total;
    (total > 0.0).then(|| Shallowness {
        harmonic: greatest + 1,
        of_greatest: measure(greatest + 1),
        mean,
    })
}
