//! The stored table of creep coefficients is what the meshes give.

use carom_laws::creep::nodes::{axis_ratios, poissons};
use carom_rolling::{CreepCoefficients, creep_coefficients, creep_table_entry};

fn by_table(ratio: f64, poisson: f64) -> [f64; 4] {
    let c = CreepCoefficients::by_table(ratio, poisson).unwrap();
    [c.c11, c.c22, c.c23, c.c33]
}

/// Seven decimals are stored.
#[test]
fn entries_are_those_that_the_meshes_give() {
    for (row, column) in [(2, 1), (9, 5), (12, 0), (15, 3)] {
        let (ratio, poisson) = (axis_ratios()[row], poissons()[column]);
        let made = creep_table_entry(ratio, poisson).unwrap();
        for (stored, made) in by_table(ratio, poisson).into_iter().zip(made) {
            assert!((stored - made).abs() < 1e-6, "{ratio} {poisson}: {stored} {made}");
        }
    }
}

/// Halfway between entries, in the logarithm of the axis ratio.
#[test]
fn between_entries_the_table_is_within_what_its_documentation_says() {
    for (row, poisson, allowed) in [
        (4, 0.3, [2e-5, 2e-5, 2e-5, 1e-4]),
        (10, 0.05, [2e-5, 2e-5, 2e-5, 1e-4]),
        (13, 0.47, [3e-4, 3e-4, 3e-4, 1e-3]),
        (15, 0.3, [3e-4, 3e-4, 3e-4, 1e-3]),
    ] {
        let ratio = (axis_ratios()[row] * axis_ratios()[row + 1]).sqrt();
        let made = creep_table_entry(ratio, poisson).unwrap();
        for (which, (stored, made)) in by_table(ratio, poisson).into_iter().zip(made).enumerate() {
            let off = (stored / made - 1.0).abs();
            assert!(
                off < allowed[which],
                "{which} at {ratio} {poisson}: {stored} {made} {off:.1e}"
            );
        }
    }
}

/// Other meshes, and another form of their errors.
#[test]
fn coarser_meshes_come_close() {
    for (ratio, poisson) in [(0.06, 0.3), (0.3, 0.3), (1.7, 0.28), (6.0, 0.4), (17.0, 0.3)] {
        let c = creep_coefficients(ratio, poisson).unwrap();
        let meshes = [c.c11, c.c22, 0.5 * (c.c23 + c.c32), c.c33];
        for (which, (stored, made)) in by_table(ratio, poisson).into_iter().zip(meshes).enumerate()
        {
            let off = (stored / made - 1.0).abs();
            let allowed = [1e-3, 1e-3, 2e-3, 5e-3][which];
            assert!(off < allowed, "{which} at {ratio} {poisson}: {stored} {made} {off:.1e}");
        }
    }
}
