//! Limits of validity that an outcome reaches.

use carom_laws::validity::{Excess, Limit, Validity};

/// A limit of validity that an outcome reaches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Warning {
    /// A limit of the theory is exceeded, or what the result leaves out is noticeable.
    Exceeds(Excess),
    /// The outcome did not converge to the requested tolerance and was accepted
    /// ([`crate::coupled::CoupledImpact::accepting_unsettled`]).
    NotSettled {
        /// Estimated error of the velocity, over that before.
        error_estimate: f64,
        /// The requested tolerance.
        tolerance: f64,
    },
    /// The contact point was found by a search from many starting points on a body that need not be
    /// convex ([`carom_geometry::Certainty::Sampled`]): there may be other contacts.
    PointSampled,
    /// A restitution along the normal is given without its cause, on which the velocity after the impact depends.
    UnknownLoss {
        /// How far the velocity may be off, over that before.
        share: f64,
    },
}

impl Warning {
    /// The warnings on a contact, or on the largest contact of an impact.
    ///
    /// ```
    /// use carom_impact::Warning;
    /// use carom_laws::validity::{Limit, Validity};
    /// let validity = Validity { wave_share: 0.05, ..Validity::default() };
    /// let told: Vec<String> = Warning::of(validity).map(|warning| warning.to_string()).collect();
    /// let words = "elastic waves would carry away more than 1 % of the normal energy: about 5 %";
    /// assert_eq!(told, [words]);
    /// ```
    pub fn of(validity: Validity) -> impl Iterator<Item = Self> {
        validity.exceeded().map(Self::Exceeds)
    }

    /// The ratio by which this limit is exceeded; `None` if the warning is of something else.
    #[must_use]
    pub fn ratio(&self, of: Limit) -> Option<f64> {
        match self {
            Self::Exceeds(Excess { limit, value }) if *limit == of => Some(*value),
            _ => None,
        }
    }
}

impl std::fmt::Display for Warning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Exceeds(excess) => excess.fmt(f),
            Self::NotSettled { error_estimate, tolerance } => {
                write!(
                    f,
                    "not converged: the estimated error is {error_estimate:.1e} of the velocity \
                     before the impact, above the tolerance {tolerance:.1e}"
                )
            }
            Self::UnknownLoss { share } => write!(
                f,
                "the rebound depends on the cause of the loss, which `loss` can name: another cause may change the \
                 velocity by about {:.0} % of that before",
                100.0 * share
            ),
            Self::PointSampled => f.write_str(
                "the contact point was found by a search from many starting points; a body that is \
                 not convex may have other contacts",
            ),
        }
    }
}
