//! The choice of the contact law that a collision is followed with.

use std::fmt;
use std::str::FromStr;

use carom_impact::coupled::TurningLaw;
use carom_impact::{
    Collision, CollisionError, CollisionSolver, HistoryPoint, Instants, NeededLaw, Outcome,
    RingImpact, RingImpactError,
};
use carom_special::{RangeError, WordError};

use crate::{NumericalImpact, NumericalImpactError};

/// The contact law that a collision is followed with.
///
/// ```
/// use carom_halfspace::Material;
/// use carom_impact::{Body, Collision, Motion};
/// use carom_laws::friction::Friction;
/// use carom_numerical::CollisionLaw;
/// // A ball of alumina on glass, nearly along the normal: coupling throws it back.
/// let alumina = Material::from_young(380e9, 0.23)?;
/// let ball = Body::sphere(2.5e-3, alumina, 2.6e-4)?
///     .moving(Motion::new([0.1, 0.0, -2.0], [0.0; 3])?);
/// let plate = Body::plane(Material::from_young(70e9, 0.22)?);
/// let collision = Collision::new(ball, plate, Friction::new(0.092)?)?;
/// let r_x = |law: CollisionLaw| -> Result<f64, Box<dyn std::error::Error>> {
///     let outcome = law.solve(&collision)?;
///     Ok(outcome.rebound().and_then(|rebound| rebound.r_x).ok_or("they meet")?)
/// };
/// assert!(r_x("coulomb".parse()?)? < -0.2 && r_x(CollisionLaw::default())? > 0.19);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum CollisionLaw {
    /// The cheapest law in which everything that matters counts: an analytic law where the coupling of dissimilar
    /// bodies is negligible ([`Collision::needed_law`]), rings for spheres and planes, else the grid. Where
    /// the grid cannot be used (infinite friction) the analytic law, with a warning.
    #[default]
    Auto,
    /// An analytic law, whichever the materials. It neglects coupling.
    Analytic(TurningLaw),
    /// Rings ([`RingImpact`]), for spheres and planes.
    Rings,
    /// The contact on a grid ([`NumericalImpact`]).
    Numerical,
}

/// Why a collision could not be followed with a law.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CollisionLawError {
    /// The collision cannot be computed.
    #[error(transparent)]
    Collision(#[from] CollisionError),
    /// The law of rings cannot follow it.
    #[error(transparent)]
    Rings(#[from] RingImpactError),
    /// It cannot be followed on a grid.
    #[error(transparent)]
    Numerical(#[from] NumericalImpactError),
}

/// What is used for one collision.
enum Used {
    Analytic(TurningLaw),
    AnalyticWithTorsion,
    Rings,
    Grid,
}

impl CollisionLaw {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Auto,
        Self::Analytic(TurningLaw::Coulomb),
        Self::Analytic(TurningLaw::FixedDirection),
        Self::Rings,
        Self::Numerical,
    ];
    const NAMES: [&'static str; 5] = [
        Self::Auto.name(),
        TurningLaw::Coulomb.name(),
        TurningLaw::FixedDirection.name(),
        Self::Rings.name(),
        Self::Numerical.name(),
    ];

    /// Its word.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Analytic(law) => law.name(),
            Self::Rings => "rings",
            Self::Numerical => "numerical",
        }
    }

    /// Follows the collision to separation.
    ///
    /// # Errors
    /// [`CollisionLawError`] as the law says; [`RingImpactError::Range`] for rings of other bodies than spheres
    /// and planes.
    pub fn solve(self, collision: &Collision) -> Result<Outcome, CollisionLawError> {
        Ok(match self.used(collision) {
            Used::Analytic(law) => collision.clone().with_law(law).solve()?,
            Used::AnalyticWithTorsion => collision.solve_with_needed_torsion()?,
            Used::Rings => RingImpact::new(collision).solve()?,
            Used::Grid => NumericalImpact::new(collision).solve()?,
        })
    }

    /// The collision at so many instants equally spaced in time, touch and separation included, or at given times, in
    /// contact axes; empty if the bodies do not meet.
    ///
    /// # Errors
    /// As [`CollisionLaw::solve`]; [`RangeError`] as [`Instants::check`].
    pub fn history<'a>(
        self,
        collision: &Collision,
        instants: impl Into<Instants<'a>>,
    ) -> Result<Vec<HistoryPoint>, CollisionLawError> {
        let instants = instants.into();
        Ok(match self.used(collision) {
            Used::Analytic(law) => collision.clone().with_law(law).history(instants)?,
            Used::AnalyticWithTorsion => collision.history(instants)?,
            Used::Rings => RingImpact::new(collision).history(instants)?,
            Used::Grid => NumericalImpact::new(collision).history(instants)?,
        })
    }

    fn used(self, collision: &Collision) -> Used {
        match self {
            Self::Analytic(law) => Used::Analytic(law),
            Self::Rings => Used::Rings,
            Self::Numerical => Used::Grid,
            Self::Auto => match collision.default_law() {
                NeededLaw::Analytic => Used::AnalyticWithTorsion,
                NeededLaw::Rings => Used::Rings,
                NeededLaw::Grid if collision.friction().coefficient().is_none() => {
                    Used::Analytic(TurningLaw::Coulomb)
                }
                NeededLaw::Grid => Used::Grid,
            },
        }
    }
}

impl CollisionSolver for CollisionLaw {
    type Error = CollisionLawError;

    fn solve(&self, collision: &Collision) -> Result<Outcome, CollisionLawError> {
        (*self).solve(collision)
    }

    fn out_of_range(error: &CollisionLawError) -> Option<RangeError> {
        match error {
            CollisionLawError::Collision(CollisionError::Range(error))
            | CollisionLawError::Rings(RingImpactError::Range(error))
            | CollisionLawError::Numerical(NumericalImpactError::Range(error)) => Some(*error),
            _ => None,
        }
    }
}

impl fmt::Display for CollisionLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for CollisionLaw {
    type Err = WordError;

    /// # Errors
    /// [`WordError`] with the words that are allowed.
    fn from_str(word: &str) -> Result<Self, WordError> {
        let law = Self::ALL.into_iter().find(|law| law.name() == word);
        law.ok_or_else(|| WordError::new("law", word, &Self::NAMES))
    }
}

impl From<RangeError> for CollisionLawError {
    fn from(error: RangeError) -> Self {
        Self::Collision(error.into())
    }
}
