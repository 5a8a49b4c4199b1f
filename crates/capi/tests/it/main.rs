//! Tests of `carom-capi` through its public interface: one executable with a module for each subject.

mod apart;
mod border;
mod creep;
mod dissimilar;
mod encounters;
mod garbled;
mod grain_friction;
mod grain_spin;
mod grains;
mod grains_validity;
mod header;
mod hostile;
mod losses;
mod mechanics;
mod programs;
mod rebound;
mod ring_grains;
mod rolling;
mod surfaces;
mod told;
mod validity;
mod validity_of_all;
mod wrong_bodies;
