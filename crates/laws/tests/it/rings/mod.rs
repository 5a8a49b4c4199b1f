//! The law of rings against closed forms, other laws and invariants.

mod common;

mod adhesion;
mod balance;
mod centre;
mod coupling;
mod invariance;
mod kept_angles;
mod known_sums;
mod limits;
mod packed;
mod partial_slip;
mod twist;
