//! Which bodies meet, and the groups of numbers on which their impact depends.

use super::Arguments;
use crate::error::CliError;
use carom_impact::oblique::{Groups, ObliqueImpact};
use carom_impact::restitution::{
    DissimilarGroups, DissimilarRestitution, DissimilarTable, with_normal_restitution as lossy,
};
use carom_laws::friction::Friction;
use carom_special::RangeError;

/// Which bodies meet.
#[derive(Debug, Clone, Copy)]
pub(super) enum Bodies {
    /// Alike solid spheres, by kappa and lambda.
    Spheres(NormalLoss),
    /// Any whose normal and tangential motions are uncoupled, by chi and psi.
    Any(NormalLoss),
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

/// The restitution e along the normal; none of elastic bodies.
pub(super) type NormalLoss = Option<f64>;

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
            (_, _, Some(_)) => Ok(Self::Spheres(arguments.normal_restitution)),
            _ => Ok(Self::Any(arguments.normal_restitution)),
        }
    }

    /// The groups of alike bodies.
    pub(super) fn groups(&self, [a, b]: [f64; 2]) -> Result<Groups, RangeError> {
        match self {
            Self::Any(_) => Groups::new(a, b),
            Self::Spheres(_) | Self::Dissimilar(_) => Groups::of_spheres(a, b),
        }
    }

    /// The restitution along the normal.
    pub(super) const fn normal_loss(&self) -> NormalLoss {
        match self {
            Self::Spheres(loss) | Self::Any(loss) => *loss,
            Self::Dissimilar(_) => None,
        }
    }

    /// R_x of a pair.
    pub(super) fn restitution(&self, pair: [f64; 2]) -> Result<f64, CliError> {
        match (self, self.normal_loss()) {
            (Self::Dissimilar(coupling), _) => Ok(coupling.found(pair)?.r_x),
            (_, Some(e)) => Ok(lossy(self.groups(pair)?, e)?),
            (_, None) => Ok(ObliqueImpact::new(self.groups(pair)?)?.restitution()),
        }
    }

    pub(super) fn check(&self, pair: [f64; 2]) -> Result<(), RangeError> {
        if let Some(e) = self.normal_loss() {
            let holds = (0.0..=1.0).contains(&e);
            RangeError::check("normal-restitution", e, holds, "from 0 to 1")?;
        }
        match self {
            Self::Dissimilar(coupling) => coupling.groups(pair).map(|_| ()),
            _ => self.groups(pair).map(|_| ()),
        }
    }
}
