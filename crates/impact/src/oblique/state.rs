//! The state of the motion between two events.

use super::position::Position;

/// The state of the motion; tangential quantities in units of the initial tangential velocity.
#[derive(Debug, Clone, Copy)]
pub(super) struct State {
    pub(super) position: Position,
    pub(super) velocity: f64,
    pub(super) shift: f64,
    pub(super) traction: f64,
}
