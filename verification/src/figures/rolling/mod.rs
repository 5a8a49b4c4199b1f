//! Rolling, which the thesis leaves to further research (16.2): not in the thesis.

use crate::catalogue::Entry;

mod coefficients;
mod curves;

/// The pages.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::check("rolling.coefficients", "Kalker's creep coefficients")
        .slowly_by(coefficients::draw),
    Entry::check("rolling.curves", "Forces by creepage and spin").slowly_by(curves::draw),
];
