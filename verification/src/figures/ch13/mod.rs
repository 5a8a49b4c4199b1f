//! Chapter 13: convergence.

mod integrals;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] =
    &[Entry::table("table-13.1", "Integrals of the convergence estimates").by(integrals::draw)];
