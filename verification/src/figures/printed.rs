//! How far a number is from one that another program prints.

use crate::{Cell, Figure, NewClaim, Table};

/// Where the numbers printed by CONTACT come from.
pub(super) const SOURCE: &str = "printed by CONTACT, open version 2025-07, for its own example";

/// A number that an example prints, beside what is computed.
pub(super) struct Compared {
    pub(super) name: String,
    pub(super) printed: f64,
    pub(super) own: f64,
}

/// The unit of the fourth digit of a printed number.
pub(super) fn unit(printed: f64) -> f64 {
    10_f64.powi(printed.abs().log10().floor() as i32 - 3)
}

/// How far a number is from one printed to four digits, in units of the fourth.
pub(super) fn off(own: f64, printed: f64) -> f64 {
    (own - printed).abs() / unit(printed)
}

/// The same as a cell of a table.
pub(super) fn off_cell(own: f64, printed: f64) -> Cell {
    Cell::Remark(format!("{:.2}", off(own, printed)))
}

/// Claims that numbers agree in all four printed digits: the worst is at most half a unit of the
/// last away.
#[track_caller]
pub(super) fn all_digits<'f>(
    figure: &'f mut Figure,
    what: &str,
    pairs: impl IntoIterator<Item = (f64, f64)>,
) -> NewClaim<'f> {
    let worst = pairs.into_iter().map(|(own, printed)| off(own, printed)).reduce(f64::max);
    let statement = format!("{what}: worst difference, in units of the fourth digit");
    // Without a pair the claim fails.
    figure.at_most(statement, worst.unwrap_or(f64::NAN), 0.5)
}

/// Numbers of four digits beside each other.
pub(super) fn beside(compared: &[Compared]) -> Table {
    let heads = ["", "of CONTACT", "of carom", "off, units of the 4th digit"];
    let mut table = Table::new("Number beside number", heads);
    for one in compared {
        let off = off_cell(one.own, one.printed);
        table.row(vec![Cell::from(one.name.as_str()), one.printed.into(), one.own.into(), off]);
    }
    table
}
