//! Coulomb's law on a line of anchors: exact cases, and the limit to which it converges.

use carom_laws::law::{ContactLaw, Shift};
use carom_laws::sliders::{SliderLaw, SlipLines};
use carom_laws::stiffness::ContactStiffness;

/// Sliding is exact, and so is adhesion on a straight path.
#[test]
fn sliding_and_adhesion_on_a_straight_path_are_exact() {
    let stiffness = ContactStiffness::new(0.9, 0.7, 1.1).unwrap();
    let to = |zeta: f64, xi: f64| Shift { zeta, xi, ..Shift::default() };
    for zeta in [0.02, 0.17, 0.5, 0.9, 1.3] {
        let mut law = SlipLines::new(stiffness, 0.3, 0.1).unwrap();
        let load = law.advance(to(zeta, 3.0)).unwrap();
        assert!((load.f_x / (0.3 * load.f_z) - 1.0).abs() < 1e-13, "{zeta}");
        let mut law = SlipLines::new(stiffness, 5.0, 0.1).unwrap();
        let load = law.advance(to(zeta, 0.2 * zeta)).unwrap();
        let exact = 2.0 / 3.0 * 0.9 * 0.2 * zeta * zeta.sqrt();
        assert!((load.f_x / exact - 1.0).abs() < 1e-14, "{zeta}");
    }
}

/// However high the friction and thin the rim that slips, springs inside it are left alone: without
/// slip the force is c_x int (xi - W) dt in closed form, and friction takes about 1/(f zeta) of it.
#[test]
fn a_rim_thinner_than_rounding_costs_next_to_nothing() {
    let stiffness = ContactStiffness::new(0.9, 0.7, 1.1).unwrap();
    let to = |zeta: f64, xi: f64, eta: f64| Shift { zeta, xi, eta, omega: 0.0 };
    for friction in [1e4, 1e6, 1e9, 1e12, 1e15, 1e18] {
        for back in [0.02_f64, 0.17, 0.5, 0.9] {
            let mut law = SlipLines::new(stiffness, friction, 1e-6).unwrap();
            law.advance(to(1.0, 0.2, 0.1)).unwrap();
            law.advance(to(1.0, 0.5, -0.1)).unwrap();
            let load = law.advance(to(back, 0.3, 0.2)).unwrap();
            let of = |c: f64, at: f64, slope: f64| c * back.sqrt() * (at - slope * back / 3.0);
            let (x, y) = (of(0.9, 0.3, 0.2), of(0.7, 0.2, 0.1));
            let off = (load.f_x - x).hypot(load.f_y - y) / x.hypot(y);
            println!("{friction:e} {back}: {off:.1e}");
            // The rim is about |X|/(f zeta) of the depth.
            assert!(off < 3e-6 + 0.3 / (friction * back), "{friction}, {back}: {off}");
        }
    }
}

/// A turning path with growing and receding contact: rings of sliders at fixed distances.
#[test]
fn tends_to_rings_of_sliders() {
    for c_y in [0.9, 0.6] {
        let stiffness = ContactStiffness::new(0.9, c_y, 1.0).unwrap();
        let limit = 0.3 * stiffness.c_z;
        let mut rings = SliderLaw::new(3000, 1.31, 0.9 / c_y).unwrap();
        let mut lines = [1e-3, 1e-4, 1e-6].map(|off| SlipLines::new(stiffness, 0.3, off).unwrap());
        let mut largest = [0.0_f64; 3];
        for i in 1..=200 {
            let t = 3.0 * f64::from(i) / 200.0;
            let shift = Shift {
                zeta: 1.3 * (t * 1.2).sin().abs().max(0.2 * t.min(1.0)),
                xi: 0.5 * (2.0 * t).sin(),
                eta: 0.3 * (1.0 - (1.5 * t).cos()),
                omega: 0.0,
            };
            let x = [0.9 * shift.xi / limit, c_y * shift.eta / limit];
            let want = rings.advance(shift.zeta, x).unwrap().map(|phi| 2.0 / 3.0 * limit * phi);
            for (law, largest) in lines.iter_mut().zip(&mut largest) {
                let load = law.advance(shift).unwrap();
                assert!(load.f_x.hypot(load.f_y) <= 0.3 * load.f_z * (1.0 + 1e-14));
                let off = (load.f_x - want[0]).hypot(load.f_y - want[1]) / (2.0 / 3.0 * limit);
                *largest = largest.max(off);
            }
        }
        println!("{c_y}: {largest:?}");
        let [coarse, middle, fine] = largest;
        assert!(coarse < 3e-2 && middle < 0.5 * coarse && fine < 1e-4, "{c_y}: {largest:?}");
    }
}
