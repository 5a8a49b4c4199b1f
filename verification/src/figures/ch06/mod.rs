//! Chapter 6: load histories with one tangential direction.

mod first_shift;
mod history;
mod regimes;
mod reversal;
mod springs;
mod unloading;
mod varying;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("6.1", "Stick circles and slip rings").by(first_shift::regions),
    Entry::figure("6.2", "Stress distribution after the first shift")
        .by(first_shift::stress_after_shift),
    Entry::figure("6.3", "Tangential force against shift, virgin curve")
        .by(first_shift::virgin_curve),
    Entry::figure("6.4", "Stress distribution while unloading").by(unloading::stress),
    Entry::figure("6.5", "Loop of the tangential force, with permanent set")
        .by(unloading::force_loop),
    Entry::figure("6.6", "Additional stress for a shift within the adhesion cone")
        .by(varying::within_cone),
    Entry::figure("6.7", "Stress distribution for a shift beyond the adhesion cone")
        .by(varying::beyond_cone),
    Entry::figure("6.8", "Tangential force for increasing compression").by(varying::force_growing),
    Entry::figure("6.9", "Stresses for decreasing compression").by(varying::stress_shrinking),
    Entry::figure("6.10", "Tangential force for decreasing compression")
        .by(varying::force_shrinking),
    Entry::figure("6.11", "Stress at the first point of instantaneous adhesion")
        .by(reversal::first_point),
    Entry::figure("6.12", "Stress for the continued second decrease").by(reversal::second_decrease),
    Entry::figure("6.13", "Contact regimes against the second shift").by(regimes::second),
    Entry::figure("6.14", "Contact regimes against the N-th shift increment").by(regimes::nth),
];
