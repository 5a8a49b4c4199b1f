//! Comparison with measurements: published impacts beside the exact elastic theory, constant coefficients and
//! the laws of particle codes; not in the thesis.

use crate::catalogue::Entry;

mod alumina_on_glass;
mod coefficients;
mod glass_pairs;
mod models;
mod superball;

/// The pages.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::check("measured.alumina-on-glass", "Alumina balls on glass at all angles")
        .by(alumina_on_glass::draw),
    Entry::check("measured.glass-pairs", "24 impacts of two glass spheres").by(glass_pairs::draw),
    Entry::check("measured.coefficients", "Coefficients of eleven pairs of materials")
        .by(coefficients::draw),
    Entry::check("measured.superball", "A rubber ball, and where the theory ends")
        .by(superball::draw),
];
