//! Compression of dissimilar bodies: slip from the rim inwards, and its direction.

use super::common::{hertz, law, law_of, shift};
use carom_halfspace::{Force, Material, Point, PointLoad};
use carom_laws::law::ContactLaw;
use carom_laws::rings::RingLaw;

/// The radius outside of which all angles slip, as the edges of the ring within which it lies.
fn stick_radius<const N: usize>(law: &RingLaw<N, 8>) -> [f64; 2] {
    let rings: Vec<_> = law.slipping().collect();
    let sticks = rings.iter().take_while(|ring| ring.1 < 0.5).count();
    let edge = |i: usize| if i == 0 { 0.0 } else { rings[i - 1].0 };
    // The outermost that sticks, and the innermost that slips.
    [edge(sticks.saturating_sub(1)), edge((sticks + 1).min(N))]
}

#[test]
fn a_pressed_contact_sticks_within_the_radius_of_the_fine_solution() {
    // kappa = 1.125 and small gamma: stick radii that an independent program found on fine rings.
    for (ratio, want) in [(0.5, 0.976), (1.0, 0.889), (1.5, 0.67), (2.0, 0.47), (3.0, 0.12)] {
        let gamma = 1e-3;
        let mut law = law_of::<16, 8>([1.125, gamma, gamma / ratio], 1e-4);
        for k in 1..=100 {
            law.advance(shift([0.01 * f64::from(k), 0.0, 0.0, 0.0])).unwrap();
        }
        let [low, high] = stick_radius(&law);
        assert!(low <= want && want <= high, "{ratio}: {want} not in {low}..{high}");
        assert!(law.load().f_x.hypot(law.load().f_y) < 1e-12);
    }
}

#[test]
fn friction_on_the_body_that_is_drawn_inwards_acts_outwards() {
    // By Boussinesq, a body's surface is drawn towards a pressure on it by (1 - 2 nu)/G.
    let inwards = |body: Material| {
        let load = PointLoad::new(body, Force { z: 1.0, ..Force::default() }).unwrap();
        -load.displacement(Point::on_surface(1.0, 0.0)).unwrap().u
    };
    for (moduli, poisson) in [
        ([2.0, 2.0], [0.0, 0.5]),
        ([2.0, 2.0], [0.5, 0.0]),
        ([1.0, 5.0], [0.3, 0.3]),
        ([5.0, 1.0], [0.2, 0.3]),
    ] {
        let body = |i: usize| Material::from_shear(moduli[i], poisson[i]).unwrap();
        // The other body comes outwards against body 1 if that is drawn inwards more, and takes it along.
        let outwards = (inwards(body(0)) - inwards(body(1))).signum();
        let hertz = hertz(moduli, poisson);
        let mut law = law::<6, 8>(&hertz, 0.05, 1e-3);
        law.advance(shift([1.0, 0.0, 0.0, 0.0])).unwrap();
        for angle in 0..8 {
            let [radial, around] = law.traction(4, angle).unwrap();
            assert!(radial * outwards > 0.01 * hertz.force(1.0) * 0.05, "{radial} {outwards}");
            assert!(around.abs() < 1e-12);
        }
        // The spread helps to carry: F_z grows, by second order in gamma.
        let gamma = hertz.materials().gamma();
        let grown = law.load().f_z / hertz.force(1.0) - 1.0;
        assert!(grown > 0.0 && grown < gamma * gamma, "{grown}");
    }
}

#[test]
fn friction_adds_to_the_force_what_no_slip_adds_at_most() {
    // gamma = 0.3: by complete adhesion F_z grows most; less friction, less growth, none at all without.
    let mut last = 0.0;
    for friction in [0.0, 0.01, 0.1, 0.3, 1.0, f64::INFINITY] {
        let mut law = law_of::<6, 8>([7.0 / 6.0, 0.3, friction], 1e-4);
        for k in 1..=20 {
            law.advance(shift([0.05 * f64::from(k), 0.0, 0.0, 0.0])).unwrap();
        }
        let grown = law.load().f_z / (8.0 / 3.0) - 1.0;
        assert!(grown >= last - 1e-6 && grown < 0.09, "f = {friction}: {grown}");
        last = grown;
    }
    assert!(last > 0.01);
}
