//! Examples shipped with CONTACT that do not roll: not in the thesis.

use crate::catalogue::Entry;

mod spence;
mod square;

/// The pages.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::check("contact.spence", "CONTACT's shipped cases: dissimilar bodies pressed together")
        .by(spence::draw),
    Entry::check("contact.square", "CONTACT's shipped cases: stress below a square")
        .by(square::draw),
];
