//! Limits of validity that an outcome reaches.

use carom_laws::validity::Validity;

/// A limit of validity that an outcome reaches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Warning {
    /// The materials couple normal and tangential displacements (epsilon of (5.20) is not zero),
    /// which the analytic law neglects. This matters for f/gamma below about 1 (section 15.2).
    Coupling {
        /// gamma of (15.2).
        gamma: f64,
        /// f/|gamma|.
        friction_over_gamma: f64,
    },
    /// The contact is not small against the bodies: Hertz's theory requires a/R below 0.1.
    LargeContact {
        /// Maximum contact radius (of an ellipse, the larger semi-axis) over the smallest radius of
        /// curvature.
        ratio: f64,
    },
    /// The greatest pressure exceeds that at which the weaker material begins to yield
    /// ([`Validity::YIELDS_AT`] times its yield stress).
    Yields {
        /// The greatest pressure over that one.
        ratio: f64,
    },
    /// Elastic waves would carry away more than 1 % of the normal energy (3.2), and the result does
    /// not include this loss.
    WaveLoss {
        /// The share, estimated as if both bodies were of this body's material.
        share: f64,
    },
    /// Torsion is not computed and would take more than 1 % of the relative spin about the normal.
    SpinLeftAlone {
        /// An approximate upper bound of that share.
        share: f64,
    },
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
}

impl Warning {
    /// The warnings on a contact, or on the largest contact of an impact.
    pub fn of(validity: Validity) -> impl Iterator<Item = Self> {
        let large = Self::LargeContact { ratio: validity.semi_axis_over_radius };
        let yields = Self::Yields { ratio: validity.pressure_over_yield };
        let waves = Self::WaveLoss { share: validity.wave_share };
        let all = [
            (validity.is_large_contact(), large),
            (validity.yields(), yields),
            (validity.has_waves(), waves),
        ];
        all.into_iter().filter_map(|(holds, warning)| holds.then_some(warning))
    }
}

impl std::fmt::Display for Warning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Coupling { gamma, friction_over_gamma } => {
                let verdict = if *friction_over_gamma < 1.0 { "matters" } else { "is small" };
                write!(
                    f,
                    "dissimilar materials: gamma = {gamma:.4}, f/|gamma| = {friction_over_gamma:.3}; \
                     the coupling of normal and tangential displacements is neglected and {verdict}"
                )
            }
            Self::Yields { ratio } => {
                let what = Validity::YIELDS.to_str().map_err(|_| std::fmt::Error)?;
                write!(f, "{what}: it is {ratio:.3} times that")
            }
            Self::WaveLoss { share } => {
                let percent = 100.0 * share;
                write!(f, "elastic waves carry away about {percent:.2} % of the normal energy")
            }
            Self::SpinLeftAlone { share } => {
                let percent = 100.0 * share;
                write!(
                    f,
                    "torsion is not computed: it would take up to {percent:.2} % of the relative spin \
                     about the normal"
                )
            }
            Self::NotSettled { error_estimate, tolerance } => {
                write!(
                    f,
                    "not converged: the estimated error is {error_estimate:.1e} of the velocity \
                     before the impact, above the tolerance {tolerance:.1e}"
                )
            }
            Self::PointSampled => f.write_str(
                "the contact point was found by a search from many starting points; a body that is \
                 not convex may have other contacts",
            ),
            Self::LargeContact { ratio } => {
                write!(
                    f,
                    "large contact: a/R = {ratio:.3} exceeds {}, beyond Hertz's theory",
                    Validity::LARGE_CONTACT
                )
            }
        }
    }
}
