//! Recomputes the stored tables of R_x; needed if the exact impact changes by more than 1e-9, or that with a loss by more than
//! 1e-6.

use carom_impact::restitution::RestitutionTable;

fn main() -> std::io::Result<()> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/src/restitution/table/");
    std::fs::write(format!("{folder}stored.bin"), RestitutionTable::build().to_bytes())?;
    std::fs::write(format!("{folder}loss.bin"), RestitutionTable::losses_to_bytes())
}
