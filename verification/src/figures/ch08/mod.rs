//! Chapter 8: equations of motion.

mod bodies;
mod rotations;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("8.1", "Rotations of the coordinate base").by(rotations::draw),
    Entry::figure("8.2", "The bodies at the beginning of contact and during impact")
        .by(bodies::draw),
];
