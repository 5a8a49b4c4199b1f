//! Chapter 5: Hertz, Cattaneo-Mindlin and torsion.

mod compliance;
mod deformed;
mod parameters;
mod systems;
mod twist;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("5.1", "Local coordinate systems of the two surfaces").by(systems::draw),
    Entry::figure("5.2", "Deformed state of the bodies").by(deformed::contact),
    Entry::figure("5.3", "Dimensionless parameters α, β, γ, δ of the Hertz contact")
        .by(parameters::draw),
    Entry::figure("5.4", "Section y = 0 of the deformed bodies").by(deformed::shifted),
    Entry::figure("5.5", "Torsional compliance for complete adhesion").by(compliance::draw),
    Entry::figure("5.6", "Twisting moment with slip: exact and approximate").by(twist::draw),
];
