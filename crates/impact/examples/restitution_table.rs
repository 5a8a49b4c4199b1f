//! Recomputes the stored table of R_x; needed if the exact impact changes by more than 1e-9.

use carom_impact::restitution::RestitutionTable;

fn main() -> std::io::Result<()> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/src/restitution/table/stored.bin");
    std::fs::write(path, RestitutionTable::build().to_bytes())
}
