//! Chapter 4: the elastic half-space.

mod mesh;
mod triangles;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("4.1", "Mesh of the contact area").by(mesh::draw),
    Entry::figure("4.2", "Rectangle split into two triangles").by(triangles::draw),
];
