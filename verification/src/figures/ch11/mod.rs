//! Chapter 11: Kalker's method.

mod charts;
mod mesh;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("11.1", "Discretisation of the contact area").by(mesh::draw),
    Entry::figure("11.2", "The process Norm").by(charts::norm),
    Entry::figure("11.3", "The process Tang").by(charts::tang),
];
