//! Chapter 5: Hertz, Cattaneo-Mindlin and torsion.

mod deformed;
mod frame;
mod parameters;
mod torsion;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("5.1", "Local coordinate systems of the two surfaces").by(frame::draw),
    Entry::figure("5.2", "Deformed state of the bodies").by(deformed::draw_pressed),
    Entry::figure("5.3", "Dimensionless parameters α, β, γ, δ of the Hertz contact")
        .by(parameters::draw),
    Entry::figure("5.4", "Section y = 0 of the deformed bodies").by(deformed::draw_shifted),
    Entry::figure("5.5", "Torsional compliance for complete adhesion").by(torsion::draw_compliance),
    Entry::figure("5.6", "Twisting moment with slip: exact and approximate").by(torsion::draw_slip),
];
