//! The contact problem: two bodies on a grid with friction.

use carom_halfspace::MaterialPair;
use carom_laws::friction::Friction;

use crate::gap::Gap;

/// What a method of chapters 11 to 14 solves: gap, materials, friction.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    /// The gap over the grid.
    pub gap: Gap,
    /// The materials.
    pub materials: MaterialPair,
    /// The friction.
    pub friction: Friction,
}
