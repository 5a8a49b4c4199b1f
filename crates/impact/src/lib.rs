//! Floor 5 of carom: impact of elastic bodies with friction (chapters 8, 9, 10 and 15).
//!
//! [`Encounter`] takes two bodies of any smooth shape, finds where they touch and gives an
//! [`Outcome`]; [`coupled`] is the same by its matrices. [`Collision`] takes two spheres, or a
//! sphere and a plane; [`oblique`] is the same in two dimensionless groups, [`restitution`] its
//! one number, [`closed_form`] its limits.
#![forbid(unsafe_code)]

mod body;
mod collision;
mod encounter;
mod mobility;
mod normal_spin;
mod numerical;
mod outcome;
mod placed_body;
mod wave_share;

pub mod closed_form;
pub mod coupled;
pub mod normal;
pub mod oblique;
pub mod restitution;
pub mod scene;
pub mod torsional;
pub mod uncertain;

pub use body::{Body, Motion, Shape, kinetic_energy};
pub use carom_geometry::{
    Attitude, Certainty, ContactFrame, FrameError, Height, Inertia, Jet, LocalSurface,
    NearestPoints, SearchError, Side, Surface, SurfaceError, TOUCH_TOLERANCE, angle_matrix,
    nearest_points,
};
pub use collision::{Collision, CollisionError};
pub use encounter::{Encounter, EncounterError, PlacedBody};
pub use mobility::{Lever, Mobility};
pub use normal_spin::NormalSpinError;
pub use numerical::{NumericalImpact, NumericalImpactError};
pub use outcome::{EnergyBudget, HistoryPoint, LogEntry, Outcome, Rebound, Torsion, Warning};
