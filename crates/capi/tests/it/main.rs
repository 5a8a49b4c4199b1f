//! The tests of `carom-capi` that see it as its users do: one executable, a module for each subject.

mod border;
mod garbled;
mod grains;
mod header;
mod hostile;
mod losses;
mod mechanics;
mod programs;
mod ring_grains;
mod told;
mod wrong_bodies;
