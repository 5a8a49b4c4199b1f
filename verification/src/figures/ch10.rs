//! Chapter 10: torsional impact.

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("10.1", "Rotation during the torsional impact"),
    Entry::table("table-10.42", "Contact radius of steel spheres of growing size, at (10.42)"),
    Entry::figure("10.2", "Rebound of the spin of two spheres"),
];
