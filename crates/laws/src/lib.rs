//! Layer 3 of carom: contact laws with memory (chapters 3, 5, 6, 7, 10.5 and 14.4 of the thesis).
//!
//! Curvatures and materials define a [`hertz::Hertz`] contact; a contact law maps a history of
//! rigid shifts to loads. Any consistent system of units may be used.
//!
//! - Statics: [`curvature`], [`ellipse`], [`stiffness`], [`hertz`], [`shift`], [`field`].
//! - Load histories: [`memory`] is the law of the thesis, exact in one direction, with storage that
//!   grows or has a fixed capacity; [`coulomb`] is the law for shifts whose direction changes;
//!   [`turning_law`] is the choice between them. [`sliders`] is an alternative with springs and
//!   sliders, and [`profile`] contains other indenters.
//! - Friction: [`friction`] is the coefficient, [`slip_speed`] one that depends on the slip speed;
//!   [`static_friction`] is a pair, static friction above kinetic friction, for
//!   [`shift_law::ShiftLaw`] along a line and in two directions.
//! - Twist: [`torsion`].
//! - Rolling: [`creep`], the forces of vanishing creepage.
//! - Limits of the theory: [`validity`].
//! - Dissimilar bodies: [`rings`], a law for approach, shift and twist with their coupling.
//! - [`law::ContactLaw`] is the interface for the higher layers: [`shift_law::ShiftLaw`],
//!   [`torsion::law::TorsionLaw`], [`torsion::law::ShiftTwistLaw`], [`rings::RingLaw`].
//!   [`accounted`] sums up the heat, [`differentiated`] has derivatives by parameters, [`grains`] moves contacts along with spheres and walls.
//!
//! ```
//! use carom_halfspace::{Material, MaterialPair};
//! use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
//! use carom_laws::friction::Friction;
//! use carom_laws::hertz::Hertz;
//! use carom_laws::law::{ContactLaw, Shift};
//! use carom_laws::shift_law::ShiftLaw;
//! let steel = Material::from_young(208e9, 0.3)?;
//! let ball = PrincipalRadii::sphere(0.01)?;
//! let gap = RelativeCurvature::new(ball, ball, 0.0)?;
//! let hertz = Hertz::new(gap, MaterialPair::new(steel, steel)?)?;
//! let mut law = ShiftLaw::<[f64; 2]>::new(hertz.stiffness(), Friction::new(0.3)?);
//! law.advance(Shift { zeta: 1e-6, ..Shift::default() })?;
//! let load = law.advance(Shift { zeta: 1e-6, xi: 1e-7, ..Shift::default() })?;
//! assert!(load.f_x > 0.0 && load.f_x < 0.3 * load.f_z);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

pub mod accounted;
mod bounds;
pub mod coulomb;
pub mod coupling;
pub mod creep;
pub mod damping;
pub mod differentiated;
pub mod ellipse;
pub mod field;
pub mod friction;
mod goodman;
pub mod grains;
pub mod hertz;
pub mod law;
pub mod law_name;
pub mod line;
pub mod memory;
pub mod profile;
pub mod rings;
pub mod shift;
pub mod shift_law;
pub mod sliders;
pub mod slip_lag;
pub mod slip_speed;
pub mod static_friction;
mod static_slip;
pub mod stiffness;
mod stored;
pub mod torsion;
pub mod turning_law;
pub mod validity;
pub mod viscous;
mod work_by_forces;

pub use carom_geometry::curvature;
pub use goodman::goodman_stick_radius;
