//! Chapter 10: torsional impact.

mod dead_weight;
mod rebound;
mod rotation;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("10.1", "Rotation during the torsional impact").by(rotation::draw),
    Entry::table("table-10.42", "Contact radius of steel spheres of growing size, at (10.42)")
        .by(dead_weight::draw),
    Entry::figure("10.2", "Rebound of the spin of two spheres").by(rebound::draw),
];
