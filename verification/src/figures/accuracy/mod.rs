//! Errors of carom's functions against high-precision references: not in the thesis.

use crate::catalogue::Entry;

mod half_space;
mod special;
mod turning;
mod turning_grid;
mod turning_impacts;

/// The error tables, one for each layer.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::check("accuracy.special", "Errors of the special functions, in units of 2.2e-16")
        .by(special::draw),
    Entry::check("accuracy.half-space", "Errors of the half-space, in units of 2.2e-16")
        .by(half_space::draw),
    Entry::check("accuracy.turning", "Coulomb's law where the shift turns: three laws")
        .slowly_by(turning::draw),
];
