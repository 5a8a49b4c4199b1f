//! The constants of a contact of relative radius 1, from which those of any radius follow.

use carom_halfspace::MaterialPair;
use carom_laws::curvature::RelativeCurvature;
use carom_laws::hertz::Hertz;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::torsion::law::TorsionConstants;
use carom_special::RangeError;

use crate::error::Failure;

/// The constants of a contact of relative radius 1. Lengths grow with the radius, stiffnesses with its root.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Unit {
    stiffness: ContactStiffness,
    /// a^2 and b^2 over the approach.
    pub(crate) squares: [f64; 2],
    torsion: TorsionConstants,
    pub(crate) yield_stress: f64,
}

impl Unit {
    pub(super) fn new(gap: RelativeCurvature, materials: MaterialPair) -> Result<Self, Failure> {
        let hertz = Hertz::new(gap, materials)?;
        let ellipse = hertz.ellipse(1.0)?;
        let squares = [ellipse.semi_axis_a(), ellipse.semi_axis_b()].map(|a| a * a);
        let torsion = TorsionConstants::of(&hertz)?;
        let yield_stress = materials.yield_stress();
        Ok(Self { stiffness: hertz.stiffness(), squares, torsion, yield_stress })
    }

    pub(crate) fn c_z(&self) -> f64 {
        self.stiffness.c_z
    }

    /// c_z/c_x.
    pub(super) fn kappa(&self) -> f64 {
        self.stiffness.c_z / self.stiffness.c_x
    }

    pub(super) fn stiffness(&self, relative_radius: f64) -> Result<ContactStiffness, RangeError> {
        let (by, ContactStiffness { c_x, c_y, c_z }) = (relative_radius.sqrt(), self.stiffness);
        ContactStiffness::new(by * c_x, by * c_y, by * c_z)
    }

    /// c_z and the radius of the contact over the root of the approach.
    pub(super) fn circle(&self, relative_radius: f64) -> [f64; 2] {
        let by = relative_radius.sqrt();
        [by * self.stiffness.c_z, (relative_radius * self.squares[0]).sqrt()]
    }

    pub(super) fn torsion(&self, relative_radius: f64) -> TorsionConstants {
        let (by, TorsionConstants { c_z, stiffness, arm }) = (relative_radius.sqrt(), self.torsion);
        TorsionConstants {
            c_z: by * c_z,
            stiffness: relative_radius * by * stiffness,
            arm: by * arm,
        }
    }
}

/// The gap of two grains of relative radius 1.
pub(super) fn gap_of_grains() -> Result<RelativeCurvature, Failure> {
    Ok(RelativeCurvature::from_coefficients(0.5, 0.5)?)
}

/// The gap of a grain of radius 1 at a wall with as much smaller radii.
pub(super) fn gap_at_wall(
    radius: f64,
    [x, y]: [f64; 2],
    by_rings: bool,
) -> Result<RelativeCurvature, Failure> {
    RangeError::positive("radius", radius)?;
    for (field, curvature) in [("curvature_x", x), ("curvature_y", y)] {
        let holds = curvature * radius > -1.0;
        RangeError::check(field, curvature, holds, "above -1 over the radius")?;
    }
    RangeError::check("curvature_y", y, !by_rings || x == y, "curvature_x for law rings")?;
    Ok(RelativeCurvature::from_coefficients(0.5 * (1.0 + x * radius), 0.5 * (1.0 + y * radius))?)
}

/// The relative radius of two spheres, of a sphere and a wall if one radius is infinite.
#[inline]
pub(crate) fn relative_radius([one, two]: [f64; 2]) -> Result<f64, Failure> {
    RangeError::positive("radius_1", one)?;
    RangeError::check("radius_2", two, two > 0.0, "> 0")?;
    Ok(1.0 / (1.0 / one + 1.0 / two))
}
