//! Layer 5 of carom: impact of elastic bodies with friction (chapters 8, 9, 10 and 15).
//!
//! [`Collision`] takes two bodies of any smooth shape and gives an [`Outcome`]: their motions after the
//! impact, the contact regimes, and the energy that friction dissipates. z points into body 1; any consistent
//! units.
//!
//! | item | what |
//! |---|---|
//! | [`Body`], [`Motion`], [`Collision`] | two bodies, their motions, and their impact |
//! | [`Rebound`], [`HistoryPoint`], [`Warning`] | motions afterwards, history of the impact, limits of validity |
//! | [`coupled`] | the impact from its matrices: mobility and stiffness |
//! | [`oblique`] | the exact impact of spheres and planes, in two dimensionless groups |
//! | [`restitution`], [`closed_form`] | R_x as one number, as a table and as a tensor; its limits |
//! | [`torsional`] | the impact of a spin about the normal |
//! | [`RingImpact`] | an impact of spheres of dissimilar materials, with spin about the normal |
//! | [`CollisionSolver`], [`AnalyticOrRings`] | the contact law of the impacts in scenes and studies |
//! | [`scene`], [`uncertain`] | repeated bounces between walls; inputs with distributions |
//!
//! ```
//! use carom_halfspace::Material;
//! use carom_impact::{Body, Collision, Motion};
//! use carom_laws::friction::Friction;
//! let steel = Material::from_young(208e9, 0.3)?;
//! let ball = Body::sphere(0.01, steel, 0.033)?.moving(Motion::new([1.0, 0.0, -2.0], [0.0; 3])?);
//! let outcome = Collision::new(ball, Body::plane(steel), Friction::new(0.15)?)?.solve()?;
//! let rebound = outcome.rebound().ok_or("they meet")?;
//! assert!((rebound.motions[0].velocity.z - 2.0).abs() < 1e-12);
//! assert!(rebound.motions[0].spin.y > 0.0 && rebound.energy.after < rebound.energy.before);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

mod body;
mod collision;
mod impact_friction;
mod mobility;
mod motion;
mod normal_restitution;
mod normal_spin;
mod outcome;
mod outcome_columns;
mod restitution_by_speed;
mod rings;
mod warning;
mod wave_share;

pub mod closed_form;
pub mod coupled;
pub mod normal;
pub mod oblique;
pub mod restitution;
pub mod scene;
pub mod torsional;
pub mod uncertain;
pub mod viscoelastic;

pub use body::Body;
pub use collision::{
    AnalyticOrRings, Collision, CollisionError, CollisionSolver, Input, Instants, NeededLaw,
    ReboundDerivatives, ReboundDifferences, TabledCollision, TabledRebound, TwistBound,
};
pub use impact_friction::ImpactFriction;
pub use mobility::{Lever, Mobility};
pub use motion::Motion;
pub use normal_restitution::{LossCause, NormalRestitution};
pub use normal_spin::NormalSpinError;
pub use outcome::{EnergyBudget, HistoryPoint, LogEntry, Outcome, Rebound, Torsion, TorsionMode};
pub use restitution_by_speed::RestitutionBySpeed;
pub use rings::{RingImpact, RingImpactError};
pub use warning::Warning;
