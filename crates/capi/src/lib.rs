//! The interface for C, C++ and Fortran: contact laws with memory, impact and restitution as plain data and
//! functions.
//!
//! - A [`CaromPair`] holds the constants of a contact. It is made once for two materials, their curvatures
//!   and a coefficient of friction.
//! - The state of a contact lies in memory of the caller. [`CaromContact`] is the form that is advanced; only
//!   the build that wrote it can read it, and zero bytes stand for two bodies that just touch. It packs into
//!   a [`CaromState`] of 66 numbers, which any build of this format version can read, for files and other
//!   processes. [`CaromTwist`] is the state of a twist, 83 numbers.
//! - [`CaromTouch`] is the contact of two grains, or of a grain and a wall, for particle codes: positions,
//!   velocities and spins in, force and torques out. [`CaromRingTouch`] is the same with the law of rings,
//!   for dissimilar materials and spin about the normal. Its matrices, [`CaromRings`], are the only memory
//!   that the library allocates for a caller.
//! - Every function returns a [`CaromStatus`] and describes an error in the caller's [`CaromError`], which
//!   may be null. The library keeps nothing between calls, no panic crosses the border, and a failed call
//!   leaves the caller's data as they were.
//!
//! The header `include/carom.h` is generated from this crate, in groups by task.
//!
//! # Pointers
//! A pointer must be null or point to an object of its type; where the function names a number of entries, to
//! the first of so many. The objects that a call writes must overlap no other. A null pointer where none is
//! allowed gives [`CaromStatus::NullPointer`], one that is not aligned [`CaromStatus::Misaligned`].
//!
//! A memory ([`CaromContact`], [`CaromTouch`], [`CaromRingTouch`]) must be zero bytes or written by this build
//! of the library; other bytes give an error status or meaningless numbers. [`CaromRings`] must be made by
//! [`carom_rings_of`] and not yet freed.

mod batch;
mod collide_options;
mod contact;
mod creep;
mod encounters;
mod error;
mod grain_friction;
mod grains;
mod impact;
mod law;
mod pair;
mod pointers;
mod restitution;
mod ring_touch;
mod rings;
mod state;
mod stored;
mod touch;
mod touch_roll;
mod touch_twist;
mod twist;
mod validity;
mod version;

pub use carom_laws::grains::{
    Grain as CaromGrain, Heats as CaromHeats, Surface as CaromSurface, Wall as CaromWall,
};

pub use batch::carom_contact_advance_many;
pub use collide_options::{
    CAROM_IMPACT_AUTO, CAROM_IMPACT_COULOMB, CAROM_IMPACT_FIXED_DIRECTION, CAROM_IMPACT_RINGS,
    CAROM_LOSS_BY_WAVES, CAROM_LOSS_GIVEN, CAROM_LOSS_NONE, CAROM_LOSS_VISCOELASTIC,
    CAROM_LOSS_YIELD, CAROM_TORSION_AUTO, CAROM_TORSION_INCLUDED, CAROM_TORSION_LEFT_OUT,
    CaromCollideOptions,
};
pub use contact::{
    CAROM_CONTACT_WORDS, CaromContact, carom_contact_advance, carom_contact_energy,
    carom_contact_heat, carom_contact_load, carom_contact_pack, carom_contact_report,
    carom_contact_turn_frame, carom_contact_unpack,
};
pub use creep::{CaromCreep, carom_creep_coefficients};
pub use encounters::{CaromEncounter, carom_touch_many};
pub use error::{CaromError, CaromStatus, carom_status_text};
pub use grain_friction::{
    carom_grains_slip_friction, carom_grains_static_friction, carom_touch_friction,
    carom_touch_unpack_with_friction,
};
pub use grains::{
    CaromGrainLoad, CaromGrains, carom_grains_impact_time, carom_grains_of,
    carom_grains_on_curved_wall, carom_grains_restitution,
};
pub use impact::{
    CAROM_SHAPE_BOX, CAROM_SHAPE_CAPSULE, CAROM_SHAPE_CYLINDER, CAROM_SHAPE_ELLIPSOID,
    CAROM_SHAPE_PLANE, CAROM_SHAPE_SPHERE, CAROM_SHAPE_TORUS, CaromBody, CaromRebound,
    carom_collide,
};
pub use law::{CaromLoad, CaromRegime, CaromReport, CaromShift};
pub use pair::{
    CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION, CAROM_LAW_RINGS, CaromMaterial, CaromPair,
    carom_pair_of_curvatures, carom_pair_of_spheres, carom_pair_of_stiffness,
    carom_pair_static_friction,
};
pub use restitution::{
    CAROM_BY_RINGS, CAROM_BY_TABLE, CAROM_EXACT, carom_restitution, carom_restitution_dissimilar,
    carom_restitution_many,
};
pub use ring_touch::{
    CAROM_RING_TOUCH_MARK, CAROM_RING_TOUCH_NUMBERS, CAROM_RING_TOUCH_WORDS, CaromRingTouch,
    carom_ring_touch_energy, carom_ring_touch_grains, carom_ring_touch_grains_load,
    carom_ring_touch_pack, carom_ring_touch_report, carom_ring_touch_surface,
    carom_ring_touch_surface_load, carom_ring_touch_unpack, carom_ring_touch_wall,
    carom_ring_touch_wall_load,
};
pub use rings::{CaromRings, carom_rings_free, carom_rings_of};
pub use state::{CAROM_STATE_NUMBERS, CaromState};
pub use touch::{
    CAROM_TOUCH_NUMBERS, CAROM_TOUCH_WORDS, CaromTouch, carom_touch_energy, carom_touch_grains,
    carom_touch_grains_load, carom_touch_pack, carom_touch_report, carom_touch_surface,
    carom_touch_surface_load, carom_touch_unpack, carom_touch_wall, carom_touch_wall_load,
};
pub use touch_roll::{
    CAROM_ROLL_NUMBERS, CaromRoll, CaromRolling, carom_touch_roll_energy, carom_touch_roll_grains,
    carom_touch_roll_surface,
};
pub use touch_twist::{
    carom_touch_twist_energy, carom_touch_twist_grains, carom_touch_twist_surface,
    carom_touch_twist_wall,
};
pub use twist::{
    CAROM_TWIST_NUMBERS, CaromTwist, carom_twist_advance, carom_twist_energy, carom_twist_heat,
    carom_twist_torque,
};
pub use validity::{
    CAROM_WARNING_COUPLING, CAROM_WARNING_LARGE_APPROACH, CAROM_WARNING_LARGE_CONTACT,
    CAROM_WARNING_NOT_SETTLED, CAROM_WARNING_POINT_SAMPLED, CAROM_WARNING_SPIN_LEFT_ALONE,
    CAROM_WARNING_SPIN_ON_SHIFT, CAROM_WARNING_TIME_STEP, CAROM_WARNING_WAVE_LOSS,
    CAROM_WARNING_YIELDS, CaromValidity, carom_encounters_validity, carom_grains_impact_validity,
    carom_grains_validity, carom_pair_validity, carom_validity_text, carom_warning_text,
};
pub use version::{CAROM_ABI_VERSION, carom_abi_version, carom_state_version, carom_version};
