//! Chapter 3: survey of the theories.

mod ball_under_book;
mod diagonal_shift;
mod impacts;
mod point_force;
mod semisphere;
mod shifts;
mod surfaces;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("3.1", "Surfaces of the two bodies near the contact point").by(surfaces::draw),
    Entry::figure("3.2", "Surface displacements under a normal point force").by(point_force::draw),
    Entry::figure("3.3", "Tangential stress of Cattaneo and Mindlin for several shifts")
        .by(shifts::draw),
    Entry::figure("3.4", "Displacements under a semispherical tangential traction, ν = 0.5")
        .by(semisphere::draw),
    Entry::figure("3.5", "Tangential force for a diagonal shift of a slender contact, ν = 0.5")
        .by(diagonal_shift::draw),
    Entry::figure("3.6", "Normal, tangential and torsional impact").by(impacts::draw),
    Entry::figure("3.7", "A rubber ball between table and book").by(ball_under_book::draw),
];
