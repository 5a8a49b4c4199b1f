//! Contacts of grains for particle codes (DEM).
//!
//! A code that integrates positions, velocities and angular velocities of spheres forms a
//! [`Meeting`] of two of them (or of one and a flat wall) in each step. A [`GrainContact`] computes
//! force and torques from it. It rotates the axes of the contact with the two bodies and holds a
//! [`crate::shift_law::ShiftLaw`] or any other [`GrainLaw`] in these axes, so that a pair that rotates as a whole does not
//! slip. A [`GrainTwist`] is used in addition where the torque about the normal matters. Contacts
//! of spheres may be advanced four at a time ([`advance_together`]). With [`crate::rings::RingLaw`] instead, shift, twist
//! and the coupling of dissimilar materials act together; the matrices of two materials
//! ([`crate::rings::RingMatrices`]) are made once and shared, and what one contact remembers
//! ([`crate::rings::RingMemory`]) is numbers without pointers. A [`Rolling`] resists
//! rolling. A [`WholeContact`] makes the step of all of them.
//!
//! Two corrections make a few time steps enough for an impact. The law is given the shift with Numerov's
//! correction, which cancels the error of second order of a leapfrog integrator. Without damping, friction is
//! averaged over the neighbouring half steps if the gap opens within four steps. [`GrainContact`] states both.
//!
//! A contact may be damped, by a relaxation time of its materials or by a restitution that is given. Both damp friction as
//! they damp the normal force ([`crate::viscous`]).
//!
//! ```
//! use carom_laws::friction::Friction;
//! use carom_laws::grains::{Grain, GrainContact, Meeting};
//! use carom_laws::shift_law::ShiftLaw;
//! use carom_laws::stiffness::ContactStiffness;
//! let law = ShiftLaw::<[f64; 2]>::new(ContactStiffness::new(1.0, 1.0, 1.2)?, Friction::new(0.3)?);
//! let mut contact = GrainContact::new(law, 0.0)?;
//! let below = Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 1.0, mass: 1.0 };
//! let above = Grain { place: [0.0, 0.0, 1.99], velocity: [0.1, 0.0, 0.0], ..below };
//! let meeting = Meeting::of_spheres(&above, &below, [0.5; 2])?;
//! let load = contact.advance(&meeting, 1e-3)?;
//! // Friction acts against the motion, and the contact pushes body 1 up.
//! assert!(load.force[0] < 0.0 && load.force[2] > 0.0);
//! # Ok::<(), carom_special::RangeError>(())
//! ```

mod account;
mod contact;
mod damped;
mod dashpots;
mod drag_heat;
mod frame;
mod heats;
mod law;
mod load;
mod meeting;
mod number;
mod pack;
mod rolling;
mod step;
mod together;
mod twist;
mod twisted;
mod undamped;
mod vector;
mod whole;

pub use contact::GrainContact;
pub use frame::GrainFrame;
pub use heats::Heats;
pub use law::GrainLaw;
pub use load::GrainLoad;
pub use meeting::{Apart, Grain, Meeting, Surface, Wall, compliance_shares};
pub use pack::{grain_numbers, ring_grain_numbers};
pub use rolling::{GrainRoll, Rolling, RollingResistance};
pub use together::{TOGETHER, Touching, advance_together};
pub use twist::GrainTwist;
pub use twisted::{TwistState, Twisted};
pub use whole::WholeContact;
