//! Chapter 6: load histories with one tangential direction.

mod forces;
mod path;
mod regimes;
mod stresses;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("6.1", "Stick circles and slip rings").by(stresses::draw_circles),
    Entry::figure("6.2", "Stress distribution after the first shift").by(stresses::draw_first),
    Entry::figure("6.3", "Tangential force against shift, virgin curve").by(forces::draw_virgin),
    Entry::figure("6.4", "Stress distribution while unloading").by(stresses::draw_unloading),
    Entry::figure("6.5", "Loop of the tangential force, with permanent set").by(forces::draw_loop),
    Entry::figure("6.6", "Additional stress for a shift within the adhesion cone")
        .by(stresses::draw_within_cone),
    Entry::figure("6.7", "Stress distribution for a shift beyond the adhesion cone")
        .by(stresses::draw_beyond_cone),
    Entry::figure("6.8", "Tangential force for increasing compression").by(forces::draw_increasing),
    Entry::figure("6.9", "Stresses for decreasing compression").by(stresses::draw_receding),
    Entry::figure("6.10", "Tangential force for decreasing compression")
        .by(forces::draw_decreasing),
    Entry::figure("6.11", "Stress at the first point of instantaneous adhesion")
        .by(stresses::draw_reversal),
    Entry::figure("6.12", "Stress for the continued second decrease").by(stresses::draw_continued),
    Entry::figure("6.13", "Contact regimes against the second shift").by(regimes::draw_second),
    Entry::figure("6.14", "Contact regimes against the N-th shift increment").by(regimes::draw_nth),
];
