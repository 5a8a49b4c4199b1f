//! The centre of a contact of unlike bodies moves with friction: against an integration on a grid.

use super::common::{hertz, law, shift};
use carom_laws::law::ContactLaw;

/// F_x over f F_z and F_z over that of Hertz after approach and shift have grown to 1 and f in proportion.
fn in_proportion<const N: usize>(steps: u32) -> [f64; 2] {
    let (hertz, friction) = (hertz([1.0, 20.0], [0.1, 0.3]), 0.5);
    let mut law = law::<N, 16>(&hertz, friction, 1e-4);
    for k in 1..=steps {
        let part = f64::from(k) / f64::from(steps);
        law.advance(shift([part, friction * part, 0.0, 0.0])).unwrap();
    }
    let load = law.load();
    assert!(load.f_y.abs() < 1e-9 * load.f_z);
    [load.f_x / (friction * load.f_z), load.f_z / hertz.force(1.0)]
}

#[test]
fn growth_in_proportion_has_the_force_of_a_grid_with_any_number_of_rings() {
    // On grids of 48 and 72 cells .7792 and .7796; about a fixed centre 12 rings had .793, 24 rings .801.
    let grid = 0.7805;
    for [force, _] in [in_proportion::<12>(100), in_proportion::<24>(100)] {
        assert!((force - grid).abs() < 3e-3, "{force}");
    }
}
