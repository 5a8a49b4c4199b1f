//! Chapter 12: the thesis's Gauss-Seidel method.

mod deformation;
mod program;
mod slip;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("12.1", "Slip and stress between the two bodies").by(slip::draw),
    Entry::figure("12.2", "Stress on elements 1 and 2 and the deformations of the first row")
        .by(deformation::draw),
    Entry::figure("12.3", "Structural diagram of the program").by(program::draw),
];
