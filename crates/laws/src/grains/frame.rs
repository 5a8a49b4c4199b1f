//! What a contact of grains keeps beside its law: axes that move with the bodies, and the last step in them.

use super::dashpots::Dashpots;
use super::drag_heat::DragHeat;
use super::twisted::TwistState;
use super::vector::Vector;

/// The state of a contact of grains beside that of its law: numbers without pointers, which may be kept as bytes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct GrainFrame<T> {
    /// The axis x of the contact; zero while the grains are separated.
    pub(super) tangent: Vector,
    pub(super) normal: Vector,
    /// The tangential force of the last step, along x and y.
    pub(super) friction: [f64; 2],
    /// The damping force of the last step.
    pub(super) drag: f64,
    /// Of the last step of a damped contact.
    pub(super) drag_heat: DragHeat,
    /// The velocity of the shift in the last step.
    pub(super) velocity: [f64; 2],
    /// Difference between the shift given to the law and the true shift.
    pub(super) lead: [f64; 2],
    /// The approach after the last step of a damped contact, whose law has the effective one.
    pub(super) approach: f64,
    pub(super) dashpots: Dashpots,
    pub(super) twist: T,
}

impl<T: TwistState> GrainFrame<T> {
    /// That of two grains that are apart.
    pub(super) fn apart(dashpots: Dashpots) -> Self {
        let none = [0.0; 2];
        Self {
            tangent: [0.0; 3],
            normal: [0.0; 3],
            friction: none,
            drag: 0.0,
            drag_heat: DragHeat::default(),
            velocity: none,
            lead: none,
            approach: 0.0,
            dashpots,
            twist: T::default(),
        }
    }

    /// Whether the bodies have not touched yet.
    #[must_use]
    pub fn is_new(&self) -> bool {
        self.tangent == [0.0; 3]
    }
}
