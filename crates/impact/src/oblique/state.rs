//! The moving state between two events.

use super::place::Place;

/// The moving state, tangential quantities in units of the initial tangential velocity.
#[derive(Debug, Clone, Copy)]
pub(super) struct State {
    pub(super) place: Place,
    pub(super) velocity: f64,
    pub(super) shift: f64,
    pub(super) traction: f64,
}
