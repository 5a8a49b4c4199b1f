//! The oblique impact seen as a whole: its regimes and its angle of rebound; not in the thesis.

use crate::catalogue::Entry;

mod angles;
mod play;
mod radial_slip;
mod regimes;
mod unlike;

/// The pages.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::check("rebound.regimes", "Which regimes an oblique impact goes through")
        .by(regimes::draw),
    Entry::check("rebound.angles", "Angle of rebound against angle of incidence").by(angles::draw),
    Entry::check("rebound.unlike", "Eight pairs of unlike materials: what coupling changes")
        .slowly_by(unlike::draw),
    Entry::check("rebound.slip", "Why dissimilar bodies rebound better: radial slip")
        .by(radial_slip::draw),
    Entry::check("rebound.play", "The table under the impact to play with").by(play::draw),
];
