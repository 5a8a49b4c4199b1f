//! The impact of two solid spheres over Poisson's ratio and the angle of incidence.

use carom_impact::oblique::{Groups, ObliqueImpact, TracePoint};
use carom_impact::restitution::of_spheres;
use std::f64::consts::PI;

use crate::Failure;
use crate::spheres::kappa;

/// Number of Poisson's ratios, from 0 to 1/2.
pub(super) const POISSONS: usize = 11;
/// Number of values of lambda/(7 - kappa), from 0 to 1.
pub(super) const PARTS: usize = 73;
/// Number of instants of each impact; the normal velocity varies as a cosine.
const INSTANTS: usize = 49;
/// The integer that represents 1.
const INTEGER_FOR_ONE: f64 = 32_000.0;

/// The impact at an instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Instant {
    /// F_x over the maximum of f F_z.
    pub(crate) force: f64,
    /// Radius of the stick area over the maximum contact radius.
    pub(crate) stick: f64,
    /// Tangential velocity over that at first contact.
    pub(crate) velocity: f64,
}

/// All impacts; the normal motion is the same for all.
#[derive(Debug, Clone)]
pub(crate) struct Table {
    normal: Vec<(f64, f64)>,
    instants: Vec<[i16; 3]>,
}

/// Solid spheres of one material slide throughout from this lambda on.
pub(crate) fn lambda_of_sliding(poisson: f64) -> f64 {
    7.0 - kappa(poisson)
}

/// R_x, exactly.
pub(crate) fn restitution(poisson: f64, lambda: f64) -> Result<f64, Failure> {
    Ok(of_spheres(kappa(poisson), lambda)?)
}

/// The normal velocities of the instants.
pub(crate) fn velocities() -> [f64; INSTANTS] {
    std::array::from_fn(|i| libm::cos(PI * i as f64 / (INSTANTS - 1) as f64))
}

/// The instants of an impact, exactly.
pub(crate) fn exact(poisson: f64, lambda: f64) -> Result<Vec<(TracePoint, Instant)>, Failure> {
    let groups = Groups::of_spheres(kappa(poisson), lambda)?;
    let points = ObliqueImpact::trace(groups, &velocities())?;
    let instant = |point: &TracePoint| Instant {
        force: point.friction_used * point.compression * point.compression.sqrt(),
        stick: point.stick_depth.max(0.0).sqrt(),
        velocity: point.velocity,
    };
    Ok(points.iter().map(|point| (*point, instant(point))).collect())
}

fn at(index: usize, count: usize) -> f64 {
    index as f64 / (count - 1) as f64
}

impl Table {
    /// Computes all impacts.
    pub(crate) fn new() -> Result<Self, Failure> {
        let (mut normal, mut instants) = (Vec::new(), Vec::new());
        for i in 0..POISSONS {
            let poisson = 0.5 * at(i, POISSONS);
            for j in 0..PARTS {
                let points = exact(poisson, lambda_of_sliding(poisson) * at(j, PARTS))?;
                if points.len() != INSTANTS {
                    return Err("an impact without all its instants".into());
                }
                if normal.is_empty() {
                    let of = |(point, _): &(TracePoint, Instant)| (point.time, point.compression);
                    normal = points.iter().map(of).collect();
                }
                instants.extend(points.iter().map(|(_, instant)| written(instant)));
            }
        }
        Ok(Self { normal, instants })
    }

    /// The instants of an impact, interpolated linearly between four entries; sliding throughout is
    /// exact.
    pub(crate) fn read(&self, poisson: f64, lambda: f64) -> Vec<Instant> {
        let part = lambda / lambda_of_sliding(poisson);
        if part >= 1.0 {
            let slides = |(w, (_, compression)): (f64, &(f64, f64))| Instant {
                force: compression * compression.sqrt(),
                stick: 0.0,
                velocity: 1.0 - 3.5 * (1.0 - w) / lambda, // (9.33)
            };
            return velocities().into_iter().zip(&self.normal).map(slides).collect();
        }
        let (i, x) = place(2.0 * poisson, POISSONS);
        let (j, y) = place(part, PARTS);
        let corners = [
            (i, j, (1.0 - x) * (1.0 - y)),
            (i, j + 1, (1.0 - x) * y),
            (i + 1, j, x * (1.0 - y)),
            (i + 1, j + 1, x * y),
        ];
        (0..INSTANTS)
            .map(|k| {
                corners.iter().fold(Instant::default(), |sum, (i, j, weight)| {
                    let numbers = self.instants[(i * PARTS + j) * INSTANTS + k];
                    let [force, stick, velocity] =
                        numbers.map(|n| weight * f64::from(n) / INTEGER_FOR_ONE);
                    Instant {
                        force: sum.force + force,
                        stick: sum.stick + stick,
                        velocity: sum.velocity + velocity,
                    }
                })
            })
            .collect()
    }

    /// Times of the instants, in zeta_max over the approach velocity.
    pub(super) fn times(&self) -> Vec<f64> {
        self.normal.iter().map(|(time, _)| rounded(*time)).collect()
    }

    /// Compressions of the instants, over the maximum.
    pub(super) fn compressions(&self) -> Vec<f64> {
        self.normal.iter().map(|(_, compression)| rounded(*compression)).collect()
    }

    /// Force, stick radius and velocity of all instants, as 16-bit numbers, little-endian.
    pub(super) fn bytes(&self) -> Vec<u8> {
        self.instants.iter().flatten().flat_map(|number| number.to_le_bytes()).collect()
    }
}

/// The interval and the position in it.
fn place(part: f64, count: usize) -> (usize, f64) {
    let scaled = part.clamp(0.0, 1.0) * (count - 1) as f64;
    let index = (scaled as usize).min(count - 2);
    (index, scaled - index as f64)
}

fn written(instant: &Instant) -> [i16; 3] {
    [instant.force, instant.stick, instant.velocity]
        .map(|number| (number * INTEGER_FOR_ONE).round() as i16)
}

fn rounded(number: f64) -> f64 {
    (1e6 * number).round() / 1e6
}
