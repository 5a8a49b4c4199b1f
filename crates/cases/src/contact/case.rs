//! A case of an input of CONTACT, with everything that it takes from the cases before it.

use super::block::Block;
use super::falling::Falling;
use super::potential::{Ellipse, Potential};
use super::springs::{Bound, Fastsim};
use super::surface::Surface;
use carom_halfspace::MaterialPair;
use carom_rolling::{SteadyMethod, Way};
use carom_solver::Driven;
use carom_special::RangeError;
use std::sync::Arc;

/// A case. Units are those of CONTACT: mm, N, N/mm^2, s, rad.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactCase {
    /// Its number in the file, from 1.
    pub number: usize,
    /// The line of its control digits.
    pub line: usize,
    /// With which tractions it begins.
    pub begin: Begin,
    /// What happens along the surface.
    pub motion: Motion,
    /// What drives it.
    pub drive: ContactDrive,
    /// One coefficient of friction, or one for each row of cells; that at rest if it falls.
    pub friction: Arc<[f64]>,
    /// How it falls with the slip velocity.
    pub falling: Option<Falling>,
    /// Whether forces are given and told over FSTAT FN, not over FN.
    pub by_friction: bool,
    /// The pressures.
    pub bound: Bound,
    /// The contact of Hertz that gives the cells.
    pub ellipse: Option<Ellipse>,
    /// Springs for the particles instead of elastic bodies.
    pub fastsim: Option<Fastsim>,
    /// Both bodies.
    pub materials: MaterialPair,
    /// The file of influence numbers; none for half-spaces.
    pub influence: Option<String>,
    /// The cells.
    pub area: Potential,
    /// The undeformed distance.
    pub surface: Arc<Surface>,
    /// The extra rigid slip of each cell.
    pub extra: Option<Arc<[[f64; 2]]>>,
    /// Where stresses are told.
    pub blocks: Arc<[Block]>,
    /// What CONTACT calls its accuracy; loads below half of it are told as 0.
    pub eps: f64,
    /// What is told about it.
    pub notes: Vec<String>,
}

/// What drives a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactDrive {
    /// PEN or FN.
    pub normal: Driven,
    /// CKSI and CETA, or FX and FY.
    pub along: [Asked; 2],
    /// CPHI.
    pub spin: f64,
    /// SPINXO and SPINYO.
    pub spin_centre: [f64; 2],
}

/// The tractions before a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Begin {
    /// Those of the case before.
    Tractions,
    /// Its pressures.
    Pressures,
    /// None.
    Apart,
}

/// What happens along the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// Nothing: there are no tangential tractions.
    None,
    /// A shift.
    Shift,
    /// A step of rolling.
    Step(Rolling),
    /// Steady rolling.
    Steady(Rolling),
}

/// How a contact rolls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rolling {
    /// CHI.
    pub chi: f64,
    /// DQ.
    pub dq: f64,
    /// VELOC.
    pub veloc: f64,
    /// FACPHI.
    pub facphi: f64,
}

/// What is given along an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Asked {
    /// A creepage, or a shift.
    Creepage(f64),
    /// A relative force.
    Force(f64),
}

impl Rolling {
    pub(super) fn way(&self) -> Result<Way, RangeError> {
        Way::new(self.dq)?.towards(self.chi)?.with_spin_at(self.facphi)
    }

    pub(super) fn method(&self, falling: Option<Falling>) -> Result<SteadyMethod, RangeError> {
        let method = SteadyMethod::default().towards(self.chi)?.with_spin_at(self.facphi)?;
        let method = method.in_steps_of(self.dq)?;
        Ok(match falling {
            Some(falling) => method.with_friction_by_slip(falling.rolling(self.veloc)?),
            None => method,
        })
    }
}

impl Motion {
    pub(super) const fn rolling(&self) -> Option<Rolling> {
        match self {
            Self::Step(rolling) | Self::Steady(rolling) => Some(*rolling),
            Self::None | Self::Shift => None,
        }
    }
}

impl ContactCase {
    /// By what relative forces are multiplied for forces over FN.
    pub(super) fn scale(&self) -> f64 {
        if self.by_friction { self.friction[0] } else { 1.0 }
    }

    /// The creepages of body 1 against body 2 at the middle of the area, beyond those at its origin.
    pub(super) fn of_middle(&self) -> [f64; 2] {
        let ([x, y], [at_x, at_y]) = (self.area.middle(), self.drive.spin_centre);
        [-(y - at_y) * self.drive.spin, (x - at_x) * self.drive.spin]
    }
}
