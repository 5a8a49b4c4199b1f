//! The interface for C, C++ and Fortran: contact laws with memory, impact and restitution as plain data and
//! functions.
//!
//! - A [`CaromLaw`] is what the contacts of particles of two materials have in common, made once: materials, law,
//!   friction, damping, torsion, resistance to rolling. It and a
//!   [`CaromMesh`], a surface of triangles, are the only memory that the library allocates for a caller.
//! - A [`CaromTouch`] is one contact of a grain with another one or with a wall: positions, velocities and spins in,
//!   force and torques out. It lies in memory of the caller, whose size the law tells, and only the build that wrote it
//!   can read it; zero bytes stand for two separated bodies. It packs into numbers that any build of this format
//!   version can read, for files and other processes.
//! - A [`CaromPair`] and a [`CaromContact`] are the same where the caller knows approach and shift; the contact packs
//!   into a [`CaromState`] of 66 numbers.
//! - Every function that can fail returns a [`CaromStatus`] and describes an error in the caller's [`CaromError`], which
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
//! A memory ([`CaromContact`], [`CaromTouch`]) must be zero bytes or written by this build of the library; other bytes
//! give an error status or meaningless numbers. A touch has `carom_touch_size` bytes of the law that it is used with.
//! A [`CaromLaw`] must be made by this library and not yet freed.

mod batch;
mod collide_options;
mod contact;
mod creep;
mod error;
mod impact;
mod law;
mod material;
mod mesh;
mod pair;
mod pointers;
mod restitution;
mod shift;
mod sized;
mod state;
mod stored;
mod touch;
mod validity;
mod version;

pub use carom_laws::grains::{Grain as CaromGrain, Heats as CaromHeats, Surface as CaromSurface};

pub use batch::carom_contact_advance_many;
pub use collide_options::{
    CAROM_IMPACT_AUTO, CAROM_IMPACT_COULOMB, CAROM_IMPACT_FIXED_DIRECTION, CAROM_IMPACT_RINGS,
    CAROM_LOSS_BY_WAVES, CAROM_LOSS_CONSTANT_TANGENT, CAROM_LOSS_GIVEN, CAROM_LOSS_MAXWELL,
    CAROM_LOSS_NONE, CAROM_LOSS_STANDARD_SOLID, CAROM_LOSS_VISCOELASTIC, CAROM_LOSS_YIELD,
    CAROM_TORSION_AUTO, CAROM_TORSION_INCLUDED, CAROM_TORSION_LEFT_OUT, CaromCollideOptions,
};
pub use contact::{
    CAROM_CONTACT_WORDS, CaromContact, carom_contact_advance, carom_contact_energy,
    carom_contact_load, carom_contact_pack, carom_contact_unpack,
};
pub use creep::{CaromCreep, CaromCreepForce, carom_creep_coefficients, carom_creep_force};
pub use error::{CaromError, CaromStatus, carom_status_text};
pub use impact::{
    CAROM_SHAPE_BOX, CAROM_SHAPE_CAPSULE, CAROM_SHAPE_CYLINDER, CAROM_SHAPE_ELLIPSOID,
    CAROM_SHAPE_PLANE, CAROM_SHAPE_SPHERE, CAROM_SHAPE_TORUS, CaromBody, CaromRebound,
    carom_collide,
};
pub use law::limits::{
    carom_encounters_validity, carom_law_impact_time, carom_law_impact_validity, carom_law_validity,
};
pub use law::options::{CaromLawOptions, CaromRolling};
pub use law::{CaromLaw, carom_law_free, carom_law_make, carom_law_on_curved_wall};
pub use material::{
    CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION, CAROM_LAW_RINGS, CaromMaterial, carom_law_name,
    carom_law_of_name,
};
pub use mesh::{
    CAROM_PART_CORNER, CAROM_PART_EDGE, CAROM_PART_FACE, CaromMesh, CaromPlace, carom_mesh_free,
    carom_mesh_make, carom_mesh_places,
};
pub use pair::{CaromPair, carom_pair_of_curvatures, carom_pair_of_spheres};
pub use restitution::{
    CAROM_BY_RINGS, CAROM_BY_TABLE, CAROM_EXACT, carom_restitution, carom_restitution_dissimilar,
    carom_restitution_many,
};
pub use shift::{CaromLoad, CaromShift};
pub use state::{CAROM_STATE_NUMBERS, CaromState};
pub use touch::many::{CaromEncounter, carom_touch_step_many};
pub use touch::packed::{carom_touch_pack, carom_touch_pack_size, carom_touch_unpack};
pub use touch::report::{CaromRegime, CaromReport};
pub use touch::step::{CaromGrainLoad, carom_touch_step};
pub use touch::told::{carom_touch_energy, carom_touch_load, carom_touch_report};
pub use touch::{CaromTouch, carom_touch_size};
pub use validity::{
    CAROM_WARNING_COUPLING, CAROM_WARNING_LARGE_APPROACH, CAROM_WARNING_LARGE_CONTACT,
    CAROM_WARNING_NOT_SETTLED, CAROM_WARNING_POINT_SAMPLED, CAROM_WARNING_SPIN_LEFT_ALONE,
    CAROM_WARNING_SPIN_ON_SHIFT, CAROM_WARNING_TIME_STEP, CAROM_WARNING_UNKNOWN_LOSS,
    CAROM_WARNING_WAVE_LOSS, CAROM_WARNING_YIELDS, CaromValidity, carom_validity_text,
    carom_warning_text,
};
pub use version::{CAROM_ABI_VERSION, CAROM_STATE_VERSION, carom_abi_version, carom_version};
