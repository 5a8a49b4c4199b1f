//! Which bodies meet, and the groups of numbers on which their impact depends.

use super::Arguments;
use crate::error::CliError;
use carom_impact::oblique::Groups;
use carom_impact::restitution::{DissimilarGroups, DissimilarRestitution, DissimilarTable};
use carom_laws::friction::Friction;
use carom_special::RangeError;

/// Which bodies meet.
#[derive(Debug, Clone, Copy)]
pub(super) enum Bodies {
    /// Alike solid spheres, by kappa and lambda.
    Spheres,
    /// Any whose normal and tangential motions are uncoupled, by chi and psi.
    Any,
    /// Spheres of dissimilar materials, by kappa and lambda.
    Dissimilar(Coupling),
}

/// What the impact of dissimilar spheres depends on besides kappa and lambda.
#[derive(Debug, Clone, Copy)]
pub(super) struct Coupling {
    pub(super) gamma: f64,
    pub(super) friction: Friction,
    /// D_xx/D_zz.
    pub(super) ratio: f64,
}

impl Coupling {
    fn groups(&self, [kappa, lambda]: [f64; 2]) -> Result<DissimilarGroups, RangeError> {
        let groups = DissimilarGroups::new(kappa, self.gamma, self.friction, lambda, self.ratio);
        groups.map_err(|error| match error.field {
            "mobility_ratio" => RangeError { field: "mobility-ratio", ..error },
            _ => error,
        })
    }

    pub(super) fn found(&self, pair: [f64; 2]) -> Result<DissimilarRestitution, CliError> {
        Ok(DissimilarTable::shared().restitution(&self.groups(pair)?)?)
    }
}

impl Bodies {
    pub(super) fn of(arguments: &Arguments) -> Result<Self, RangeError> {
        match (arguments.gamma, arguments.friction, &arguments.kappa) {
            (Some(gamma), Some(friction), _) => {
                let friction = Friction::new(friction)?;
                let ratio = arguments.mobility_ratio;
                Ok(Self::Dissimilar(Coupling { gamma, friction, ratio }))
            }
            (_, _, Some(_)) => Ok(Self::Spheres),
            _ => Ok(Self::Any),
        }
    }

    /// The groups of alike bodies.
    pub(super) fn groups(&self, [a, b]: [f64; 2]) -> Result<Groups, RangeError> {
        match self {
            Self::Any => Groups::new(a, b),
            Self::Spheres | Self::Dissimilar(_) => Groups::of_spheres(a, b),
        }
    }

    pub(super) fn check(&self, pair: [f64; 2]) -> Result<(), RangeError> {
        match self {
            Self::Dissimilar(coupling) => coupling.groups(pair).map(|_| ()),
            _ => self.groups(pair).map(|_| ()),
        }
    }
}
