//! Published tests of particle codes at the impact of one particle (Chung and Ooi 2011); not in the
//! thesis.
//!
//! Points were read off the printed figures; those of Chung and Ooi, and of Kharaz, Gorham and
//! Salman's measurements as they show them, by the authors of the DEMApplication of Kratos
//! (BSD licence), who keep them beside its tests. Reading errors are about 1 % of an axis.

use crate::Figure;
use crate::catalogue::Entry;

mod alumina;
mod dem;
mod glancing;
mod normal;
mod pinned;
mod shear;
mod spin;
mod viscous;

/// The pages.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::check("particles.normal", "Particle tests 1 and 2: elastic normal impact")
        .by(normal::draw),
    Entry::check("particles.alumina", "Particle test 4: an alumina ball at all angles")
        .by(alumina::draw),
    Entry::check("particles.shear", "Particle test 5: one normal velocity, all slips")
        .by(shear::draw),
    Entry::check("particles.spin", "Particle tests 6 and 7: impacts with spin").by(spin::draw),
    Entry::check("particles.pinned", "What tests of particle codes pin for oblique impacts")
        .by(pinned::draw),
    Entry::check("particles.viscous", "Impacts that lose energy in a viscous material")
        .by(viscous::draw),
    Entry::check("particles.glancing", "Glancing impacts: the line of centres turns")
        .by(glancing::draw),
];

/// Says where the published points come from.
fn name_source(figure: &mut Figure) {
    figure.stated(
        "published points",
        "Chung and Ooi 2011, Granular Matter 13, 643; read off the figures for Kratos's tests",
    );
}
