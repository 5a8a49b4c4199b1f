//! Creep coefficients of an elliptical contact, and forces without a solution: FASTSIM, the table, Carter's of a line.

use crate::Error;
use crate::case::{Elliptical, RollCase, Straight, Touching};
use carom_laws::creep::force::{CreepContact, CreepForce};
use carom_rolling::{
    CreepCoefficients, Creepage, Fastsim, FastsimForces, RollingError, creep_coefficients,
};
use carom_table::Column;

/// Strips and elements of FASTSIM.
const SPRINGS: [usize; 2] = [100, 100];

/// Creep coefficients of the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Creep {
    /// Kalker's coefficients.
    pub coefficients: CreepCoefficients,
    /// Axis ratio a/b, a along the direction of rolling.
    pub ratio: f64,
    /// Combined modulus, as that of each of two equal bodies.
    pub shear_modulus: f64,
    /// Poisson's ratio of each of them.
    pub poisson: f64,
}

/// The columns of `--coefficients`.
pub const CREEP: &[Column<Creep>] = &[
    Column::new("axis_ratio", "", "a/b, a along the direction of rolling", |c| c.ratio.into()),
    Column::new("G", "Pa", "shear modulus of each of two equal bodies", |c| c.shear_modulus.into()),
    Column::new("nu", "", "Poisson's ratio of each of them", |c| c.poisson.into()),
    Column::new("C11", "", "F_x = G a b C11 creepage", |c| c.coefficients.c11.into()),
    Column::new("C22", "", "F_y = G a b C22 creepage_across", |c| c.coefficients.c22.into()),
    Column::new("C23", "", "F_y = -G (ab)^1.5 C23 spin", |c| c.coefficients.c23.into()),
    Column::new("C32", "", "M_z = G (ab)^1.5 C32 creepage_across", |c| c.coefficients.c32.into()),
    Column::new("C33", "", "M_z = G (ab)^2 C33 spin", |c| c.coefficients.c33.into()),
];

/// The contact, whose axis a lies along the direction of rolling.
fn touching(case: &RollCase) -> Result<&Touching, Error> {
    let touching = case.touching.as_ref().ok_or_else(|| {
        Error::input(
            "creep coefficients, FASTSIM and the table are for a contact in closed form: give \
             `contact.semi_axes`, `contact.radii`, or `contact.radius` and `contact.length` instead of `gap`",
        )
    })?;
    match case.method.direction() == 0.0 {
        true => Ok(touching),
        false => Err(Error::input(
            "creep coefficients, FASTSIM and the table are for rolling along x: remove `rolling.direction`",
        )),
    }
}

fn ellipse(case: &RollCase) -> Result<&Elliptical, Error> {
    match touching(case)? {
        Touching::Ellipse(ellipse) => Ok(ellipse),
        Touching::Line(_) => Err(Error::input(
            "creep coefficients and FASTSIM are for an elliptical contact; `--table` has Carter's closed form of a line",
        )),
    }
}

/// The creep coefficients of the contact, with its bodies replaced by two equal ones.
pub(super) fn of(case: &RollCase) -> Result<Creep, Error> {
    let Elliptical { hertz, loaded } = ellipse(case)?;
    let (ellipse, materials) = (loaded.ellipse, hertz.materials());
    let ratio = ellipse.semi_axis_a() / ellipse.semi_axis_b();
    let poisson = materials.poisson();
    let coefficients = creep_coefficients(ratio, poisson).map_err(|source| match source {
        RollingError::Range(source) => source.into(),
        source => Error::from(source).at("row", 1),
    })?;
    Ok(Creep { coefficients, ratio, shear_modulus: 2.0 * materials.shear_modulus(), poisson })
}

/// The forces of FASTSIM at a creepage.
pub(super) fn springs(
    case: &RollCase,
    coefficients: CreepCoefficients,
    creepage: Creepage,
) -> Result<FastsimForces, Error> {
    let Elliptical { hertz, loaded } = ellipse(case)?;
    let fastsim = Fastsim {
        semi_axes: [loaded.ellipse.semi_axis_a(), loaded.ellipse.semi_axis_b()],
        shear_modulus: 2.0 * hertz.materials().shear_modulus(),
        coefficients,
        force: loaded.force,
        friction: case.friction.motion,
        mesh: SPRINGS,
    };
    Ok(fastsim.forces(creepage)?)
}

/// A contact whose creep forces need no solution: one in the table, or a line by Carter's closed form.
pub(super) struct Tabulated {
    of: Theory,
    friction: f64,
    force: f64,
}

enum Theory {
    Table(CreepContact),
    Carter(Straight),
}

impl Tabulated {
    /// The contact of a case.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Input`] unless it is an ellipse or a line, of like bodies that roll along x; a line also unless it
    /// creeps along x alone; [`crate::ErrorKind::Range`] if the table does not hold it.
    pub(super) fn of(case: &RollCase) -> Result<Self, Error> {
        let touching = touching(case)?;
        let materials = case.materials;
        if !materials.is_uncoupled() {
            let text = "the table of creep forces and Carter's closed form are for bodies of like materials";
            return Err(Error::input(text));
        }
        let of = match touching {
            Touching::Ellipse(Elliptical { loaded, .. }) => {
                let semi_axes = [loaded.ellipse.semi_axis_a(), loaded.ellipse.semi_axis_b()];
                let shear_modulus = 2.0 * materials.shear_modulus();
                Theory::Table(CreepContact::new(semi_axes, shear_modulus, materials.poisson())?)
            }
            Touching::Line(line) => Theory::Carter(line.clone()),
        };
        Ok(Self { of, friction: case.friction.motion, force: touching.force() })
    }

    pub(super) fn force(&self, creepage: Creepage) -> Result<CreepForce, Error> {
        let Creepage { along, across, spin } = creepage;
        match &self.of {
            Theory::Table(contact) => {
                Ok(contact.force(self.friction, self.force, [along, across, spin])?)
            }
            Theory::Carter(_) if across != 0.0 || spin != 0.0 => Err(Error::input(
                "Carter's closed form is for creepage along x: remove `creepage_across`, `spin` and their forces, or `--table`",
            )),
            Theory::Carter(Straight { line, loaded }) => {
                let part = line.carter(loaded, self.friction, along)?;
                let f_x = part * self.friction * self.force;
                Ok(CreepForce { f_x, f_y: 0.0, m_z: 0.0, error: 0.0 })
            }
        }
    }
}
