//! Rings
#![allow(dead_code)]
mod carry;
mod contact;
mod dense;
mod influence;
mod kernel;
mod law;
mod layout;
mod pair;
mod solve;
mod transform;

pub use law::{RingLaw, Tolerance};
