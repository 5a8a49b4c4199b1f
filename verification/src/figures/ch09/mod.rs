//! Chapter 9: impact without torsion.

mod compression;
mod no_slip;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("9.1", "Compression against time and its sine approximation")
        .by(compression::draw),
    Entry::figure("9.2", "Tangential restitution for complete adhesion").by(no_slip::draw),
];
