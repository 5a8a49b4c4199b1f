//! Makes the stored table of R_x of dissimilar spheres anew, or with `--check` some entries of it.

use std::io::{Error, Write, stderr};

use carom_impact::restitution::{check_dissimilar, fill_dissimilar};

/// Entries that are made again, drawn by this seed.
const CHECKED: (usize, u64) = (100, 26);
/// How far an entry may be off: rounding to 32 bits, and what platforms round.
const CLOSE: f64 = 1e-6;

fn main() -> std::io::Result<()> {
    if std::env::args().nth(1).as_deref() == Some("--check") {
        let (count, seed) = CHECKED;
        let largest = check_dissimilar(count, seed).map_err(Error::other)?;
        println!("{count} entries drawn by seed {seed}: off by {largest:.1e} at most");
        return match largest <= CLOSE {
            true => Ok(()),
            false => Err(Error::other("the stored table is not what the law makes")),
        };
    }
    let told = |done: usize, all: usize| {
        // Progress that cannot be shown is no reason to stop.
        let _ = write!(stderr(), "\r{done} of {all}");
    };
    let bytes = fill_dissimilar(told).map_err(Error::other)?;
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/src/restitution/dissimilar/stored.bin");
    std::fs::write(path, bytes)
}
