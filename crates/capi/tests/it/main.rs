//! Tests of `carom-capi` through its public interface: one executable with a module for each subject.

mod border;
mod creep;
mod dissimilar;
mod garbled;
mod header;
mod hostile;
mod impact_friction;
mod losses;
mod mechanics;
mod meshes;
mod particles;
mod programs;
mod told;
mod validity_of_all;
mod wrong_bodies;
