//! Rolling, which the thesis leaves to further research (16.2): not in the thesis.

use crate::catalogue::Entry;

mod bentall;
mod coefficients;
mod conformal;
mod creep_table;
mod curves;
mod fastsim;
mod growth;
mod onset;
mod printed;
mod shipped;
mod tractcurv;

/// The pages.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::check("rolling.coefficients", "Kalker's creep coefficients")
        .slowly_by(coefficients::draw),
    Entry::check("rolling.curves", "Forces by creepage and spin").slowly_by(curves::draw),
    Entry::check("rolling.tractcurv", "CONTACT's shipped cases: a traction curve")
        .by(tractcurv::draw),
    Entry::check("rolling.fastsim", "CONTACT's shipped cases: FASTSIM").by(fastsim::draw),
    Entry::check("rolling.creep_table", "CONTACT's published table of creep forces")
        .by(creep_table::draw),
    Entry::check("rolling.bentall", "CONTACT's shipped cases: dissimilar cylinders")
        .by(bentall::draw),
    Entry::check("rolling.shipped", "CONTACT's shipped cases: spin, and polymer cylinders")
        .by(shipped::draw),
    Entry::check("rolling.conformal", "CONTACT's shipped cases: a conformal contact")
        .by(conformal::draw),
    Entry::check("rolling.onset", "CONTACT's shipped cases: a ball begins to roll").by(onset::draw),
    Entry::check("rolling.growth", "Products as elements become smaller").slowly_by(growth::draw),
];
