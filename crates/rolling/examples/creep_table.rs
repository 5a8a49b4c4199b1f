//! Makes the stored table of creep coefficients anew, in ten minutes.

use std::fmt::Write as _;
use std::io::{Error, Write as _, stderr};

use carom_laws::creep::nodes::{axis_ratios, poissons};
use carom_rolling::creep_table_entry;

const HEAD: &str = "\
//! The entries of the table, made by `cargo run --release -p carom-rolling --example creep_table`.

use super::interpolation::Row;
use super::nodes::ROWS;

/// A row for each axis ratio, in it an entry for each Poisson's ratio: C11, C22, C23, C33.
#[rustfmt::skip]
pub(super) static VALUES: [Row; ROWS] = [
";

fn main() -> std::io::Result<()> {
    let mut text = HEAD.to_owned();
    for ratio in axis_ratios() {
        // Progress that cannot be shown is no reason to stop.
        let _ = write!(stderr(), "\ra/b = {ratio:.4} ");
        text.push_str("    [\n");
        for poisson in poissons() {
            let entry = creep_table_entry(ratio, poisson).map_err(Error::other)?;
            let entry = entry.map(|value| format!("{value:.7}")).join(", ");
            writeln!(text, "        [{entry}],").map_err(Error::other)?;
        }
        text.push_str("    ],\n");
    }
    text.push_str("];\n");
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../laws/src/creep/stored.rs");
    std::fs::write(path, text)
}
