//! Floor 5 of carom: impact of elastic bodies with friction (chapters 8, 9, 10 and 15).
//!
//! [`Encounter`] takes two bodies of any smooth shape, finds where they touch and gives an
//! [`Outcome`]; [`coupled`] is the same by its matrices. [`Collision`] takes two spheres, or a
//! sphere and a plane; [`oblique`] is the same in two dimensionless groups, [`restitution`] its
//! one number, [`closed_form`] its limits.
#![forbid(unsafe_code)]

mod attitude;
mod body;
mod collision;
mod contact_point;
mod encounter;
mod frame;
mod meeting;
mod mobility;
mod normal_spin;
mod outcome;
mod placed_body;
mod surface;
mod volume;
mod wave_share;

pub mod closed_form;
pub mod coupled;
pub mod normal;
pub mod oblique;
pub mod restitution;
pub mod scene;
pub mod torsional;
pub mod uncertain;

pub use attitude::{Attitude, angle_matrix};
pub use body::{Body, Inertia, Motion, Shape, kinetic_energy};
pub use collision::{Collision, CollisionError};
pub use contact_point::{Certainty, NearestPoints, SearchError, TOUCH_TOLERANCE, nearest_points};
pub use encounter::{Encounter, EncounterError, PlacedBody};
pub use frame::{ContactFrame, FrameError};
pub use mobility::{Lever, Mobility};
pub use normal_spin::NormalSpinError;
pub use outcome::{EnergyBudget, HistoryPoint, LogEntry, Outcome, Rebound, Torsion, Warning};
pub use surface::{Height, Jet, LocalSurface, Side, Surface, SurfaceError};
