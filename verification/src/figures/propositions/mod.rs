//! Propositions (Stellingen) of the thesis that a computation can check.

use crate::catalogue::Entry;

mod all;
mod bellows;
mod flange;
mod fourier;
mod operation_count;
mod plate;

/// The propositions, by number.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::check("propositions", "The eight propositions, and where each stands").by(all::draw),
    Entry::check("proposition-3", "A rigid punch on a simply supported plate").by(plate::draw),
    Entry::check("proposition-4", "A flange at the end of a tube").by(flange::draw),
    Entry::check("proposition-5", "Large deformation of expansion bellows").by(bellows::draw),
    Entry::check("proposition-6", "The half-space by Fourier transforms").by(fourier::draw),
    Entry::check("proposition-8", "Operations of elimination and of fast products")
        .by(operation_count::draw),
];
