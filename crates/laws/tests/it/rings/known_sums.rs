//! What tractions, slip and long steps add up to, for contacts whose radius is not 1.

use std::f64::consts::PI;

use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, Dissipative, Shift};
use carom_laws::rings::{RingConstants, RingLaw, Tolerance};

use super::common::{law_of, shift};

/// c_z = 3 N/m^1.5 and a contact radius of 0.4 m at an approach of 1 m.
const RADIUS: f64 = 0.4;

fn small(gamma: f64, friction: f64) -> RingLaw<8, 16> {
    let constants = RingConstants { c_z: 3.0, radius: RADIUS, kappa: 1.2, gamma };
    let friction = Friction::new(friction).unwrap();
    RingLaw::from_constants(constants, friction, Tolerance::new(1e-4).unwrap()).unwrap()
}

/// Tractions over the area of their rings are the force, and times their arms the torque.
#[test]
fn tractions_of_a_small_contact_carry_force_and_torque() {
    for gamma in [0.0, 0.25, -0.25] {
        let mut law = small(gamma, 0.3);
        let zeta = 0.36_f64;
        law.advance(shift([zeta, 0.0, 0.0, 0.0])).unwrap();
        let load = law.advance(shift([zeta, 0.03, -0.02, 0.05])).unwrap();
        let radius = RADIUS * zeta.sqrt();
        let (mut force, mut torque, mut inner) = ([0.0; 2], 0.0, 0.0);
        let edges: Vec<f64> = law.slipping().map(|(edge, _)| edge * radius).collect();
        for (ring, outer) in edges.into_iter().enumerate() {
            let area = PI * (outer * outer - inner * inner) / 16.0;
            let arm = 2.0 / 3.0 * (outer.powi(3) - inner.powi(3)) / (outer * outer - inner * inner);
            for angle in 0..16 {
                let [radial, around] = law.traction(ring, angle).unwrap();
                let (sine, cosine) = (f64::from(angle as u8) * PI / 8.0).sin_cos();
                force[0] += area * (cosine * radial - sine * around);
                force[1] += area * (sine * radial + cosine * around);
                // The law counts torques clockwise.
                torque -= area * arm * around;
            }
            inner = outer;
        }
        let off = (force[0] - load.f_x).hypot(force[1] - load.f_y) + (torque - load.m_z).abs();
        assert!(off < 1e-12 * load.f_z && load.m_z > 1e-3 * load.f_z, "{gamma}: {off:e} {load:?}");
    }
}

/// The share that sticks and the rings' shares that slip, by their areas, are the whole.
#[test]
fn what_sticks_and_what_slips_are_the_whole_contact() {
    for gamma in [0.0, 0.2] {
        let mut law = small(gamma, 0.3);
        law.advance(shift([1.0, 0.0, 0.0, 0.0])).unwrap();
        let (mut seen, mut in_part) = (0, 0);
        for k in 1..40 {
            law.advance(shift([1.0, 0.02 * f64::from(k), 0.0, 0.0])).unwrap();
            let (mut slips, mut inner) = (0.0, 0.0);
            for (outer, share) in law.slipping() {
                slips += share * (outer * outer - inner * inner);
                inner = outer;
                in_part += usize::from(share > 0.0 && share < 1.0);
            }
            let whole = law.sticking() + slips / (inner * inner);
            assert!((whole - 1.0).abs() < 1e-12, "{k}: {whole}");
            seen += usize::from(slips > 0.0 && law.sticking() > 0.0);
        }
        assert!(seen > 5, "{seen} steps in partial slip");
        // Coupling makes one side of a ring slip before the other.
        assert!(gamma == 0.0 || in_part > 5, "{in_part} rings in partial slip");
    }
}

/// A step that closes the gap is that from touch on, of each motion by itself and of all at once.
#[test]
fn only_the_part_of_a_step_in_contact_counts() {
    for motion in [[0.3, 0.0, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.3], [0.2, -0.1, 0.2]] {
        let fresh = law_of::<6, 8>([1.2, 0.25, 0.3], 1e-3);
        let at = |zeta: f64, part: f64| {
            let [xi, eta, omega] = motion.map(|way| part * way);
            Shift { zeta, xi, eta, omega }
        };
        let [mut one, mut two] = [fresh.clone(), fresh];
        one.advance(at(-3.0, 0.0)).unwrap();
        let got = one.advance(at(1.0, 1.0)).unwrap();
        two.advance(at(0.0, 0.75)).unwrap();
        let want = two.advance(at(1.0, 1.0)).unwrap();
        let off = (got.f_x - want.f_x).hypot(got.f_y - want.f_y) + (got.m_z - want.m_z).abs();
        assert!(off < 1e-12, "{motion:?}: {got:?} {want:?}");
        assert!(got.f_x.hypot(got.f_y) + got.m_z.abs() > 1e-2);
    }
}

/// A long slide is f F_z times its way, but for the elastic shift, which is less than f times the approach.
#[test]
fn the_heat_of_a_long_slide_is_friction_times_its_way() {
    let (friction, zeta) = (0.3, 1e-4);
    for way in [0.5, 2.0, 40.0] {
        // 17 thousand approaches and more: all but the beginning slides.
        let mut law = small(0.0, friction);
        let normal = law.advance(shift([zeta, 0.0, 0.0, 0.0])).unwrap().f_z;
        let heat = law.dissipation(shift([zeta, way, 0.0, 0.0]));
        let want = friction * normal * way;
        assert!((heat / want - 1.0).abs() < 2e-3, "{way}: {heat} {want}");
    }
}
