//! R_x of dissimilar spheres, and how it was found.

use carom_laws::law_name::LawName;
use carom_table::Column;

/// R_x is from -1 to 1.
const RANGE: f64 = 2.0;

/// How R_x of dissimilar spheres was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DissimilarMethod {
    /// There is no friction, or slip is so fast that friction is nothing: R_x = -1.
    Frictionless,
    /// gamma = 0: the exact impact of alike bodies.
    Uncoupled,
    /// From the stored table.
    Table,
    /// The impact was followed by rings.
    Rings,
}

impl DissimilarMethod {
    /// The name of the method, as in results.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Frictionless => "frictionless",
            Self::Uncoupled => "uncoupled",
            Self::Table => "table",
            Self::Rings => LawName::Rings.name(),
        }
    }
}

/// R_x of dissimilar spheres or planes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DissimilarRestitution {
    /// The tangential velocity after the impact over that before, reversed.
    pub r_x: f64,
    /// How it was found.
    pub method: DissimilarMethod,
    /// How far R_x may be off. It was fitted to cover 95 of 100 drawn impacts; it is no bound.
    pub error_estimate: f64,
}

impl DissimilarRestitution {
    /// The columns of results.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("R_x", "", "tangential restitution", |found| found.r_x.into()),
        Column::text("method", "", "how it was found", |found| found.method.name().into()),
        Column::new("error_estimate", "", "how far R_x may be off", |found| {
            found.error_estimate.into()
        }),
    ];

    /// Without friction.
    pub(super) const FRICTIONLESS: Self =
        Self { r_x: -1.0, method: DissimilarMethod::Frictionless, error_estimate: 0.0 };

    /// The exact one of alike bodies.
    pub(super) const fn uncoupled(r_x: f64) -> Self {
        Self { r_x, method: DissimilarMethod::Uncoupled, error_estimate: 0.0 }
    }

    /// One with an error.
    pub(super) const fn estimated(r_x: f64, method: DissimilarMethod, estimate: f64) -> Self {
        Self { r_x: r_x.clamp(-1.0, 1.0), method, error_estimate: estimate.min(RANGE) }
    }
}
