//! Chapter 6: load histories with one tangential direction.

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("6.1", "Stick circles and slip rings"),
    Entry::figure("6.2", "Stress distribution after the first shift"),
    Entry::figure("6.3", "Tangential force against shift, virgin curve"),
    Entry::figure("6.4", "Stress distribution while unloading"),
    Entry::figure("6.5", "Loop of the tangential force, with permanent set"),
    Entry::figure("6.6", "Additional stress for a shift within the adhesion cone"),
    Entry::figure("6.7", "Stress distribution for a shift beyond the adhesion cone"),
    Entry::figure("6.8", "Tangential force for increasing compression"),
    Entry::figure("6.9", "Stresses for decreasing compression"),
    Entry::figure("6.10", "Tangential force for decreasing compression"),
    Entry::figure("6.11", "Stress at the first point of instantaneous adhesion"),
    Entry::figure("6.12", "Stress for the continued second decrease"),
    Entry::figure("6.13", "Contact regimes against the second shift"),
    Entry::figure("6.14", "Contact regimes against the N-th shift increment"),
];
