//! The table of creep forces: symmetries, limits, Kalker's slopes.

use carom_drawn::{Draw as _, Xorshift};
use carom_laws::creep::force::{CreepContact, CreepForce, CreepShape};
use std::f64::consts::PI;

fn contact(ratio: f64, poisson: f64) -> CreepContact {
    CreepContact::new([ratio.sqrt(), 1.0 / ratio.sqrt()], 1.0, poisson).unwrap()
}

fn forces(contact: &CreepContact, creepage: [f64; 3]) -> [f64; 3] {
    let CreepForce { f_x, f_y, m_z, .. } = contact.force(0.3, 1e-3, creepage).unwrap();
    [f_x, f_y, m_z].map(|force| force / 3e-4)
}

/// A contact with a random axis ratio and Poisson's ratio, and creepages of any size.
fn drawn(draw: &mut Xorshift) -> (CreepContact, [f64; 3]) {
    let ratio = 10_f64.powf(draw.signed());
    let contact = contact(ratio, 0.25 + 0.25 * draw.signed());
    let size = 1e-4 * 10_f64.powf(2.0 * draw.signed());
    (contact, [(); 3].map(|()| size * draw.signed()))
}

/// Reversed creepages have reversed forces; a mirror turns what is across, and the spin.
#[test]
fn both_symmetries_hold() {
    let mut draw = Xorshift(7);
    for _ in 0..2000 {
        let (contact, [x, y, phi]) = drawn(&mut draw);
        let [f_x, f_y, m_z] = forces(&contact, [x, y, phi]);
        for (creepage, wanted) in
            [([-x, -y, -phi], [-f_x, -f_y, -m_z]), ([x, -y, -phi], [f_x, -f_y, -m_z])]
        {
            let found = forces(&contact, creepage);
            assert!((0..3).all(|i| (found[i] - wanted[i]).abs() < 1e-12), "{found:?} {wanted:?}");
        }
    }
}

/// The table of a shape gives the bits of a contact's, and its errors.
#[test]
fn a_shape_gives_the_forces_of_its_contacts() {
    let mut draw = Xorshift(5);
    for _ in 0..20 {
        let (ratio, poisson) = (10_f64.powf(draw.signed()), 0.25 + 0.25 * draw.signed());
        let shape = CreepShape::new(ratio, 3.0, poisson).unwrap();
        for _ in 0..200 {
            let size = 10_f64.powf(draw.signed());
            let scale = 1e-4 * 10_f64.powf(4.0 * draw.signed());
            let creepage = [(); 3].map(|()| scale * draw.signed());
            let contact = CreepContact::of_size(size, ratio, 3.0, poisson).unwrap();
            assert_eq!(shape.force(size, 0.3, 1e-3, creepage), contact.force(0.3, 1e-3, creepage));
        }
        let contact = CreepContact::of_size(1.0, ratio, 3.0, poisson).unwrap();
        for (friction, force, along) in
            [(0.0, 1.0, 0.0), (f64::NAN, 1.0, 0.0), (0.3, -1.0, 0.0), (0.3, 1.0, f64::INFINITY)]
        {
            let found = shape.force(1.0, friction, force, [along, 0.0, 0.0]).unwrap_err();
            let wanted = contact.force(friction, force, [along, 0.0, 0.0]).unwrap_err();
            assert_eq!(found.to_string(), wanted.to_string());
        }
        assert!(shape.force(0.0, 0.3, 1.0, [0.0; 3]).is_err());
    }
    for (ratio, shear, poisson) in [(0.09, 1.0, 0.3), (1.0, 0.0, 0.3), (1.0, 1.0, 0.51)] {
        let found = CreepShape::new(ratio, shear, poisson).unwrap_err();
        let wanted = CreepContact::of_size(1.0, ratio, shear, poisson).unwrap_err();
        assert_eq!(found.to_string(), wanted.to_string());
    }
}

#[test]
fn forces_stay_within_friction_and_heat() {
    let mut draw = Xorshift(11);
    for _ in 0..5000 {
        let (contact, creepage) = drawn(&mut draw);
        let found = forces(&contact, creepage);
        assert!(found[0].hypot(found[1]) <= 1.0 + 1e-15);
        let power: f64 = found.iter().zip(creepage).map(|(force, rate)| force * rate).sum();
        assert!(power >= -1e-18, "{power}");
    }
}

/// At small creepages the forces are Kalker's, to 1e-3 of the greatest slope of a row.
#[test]
fn slopes_at_rest_are_kalkers_coefficients() {
    for (ratio, poisson) in [(0.1, 0.0), (0.3, 0.28), (1.0, 0.25), (2.7, 0.5), (10.0, 0.28)] {
        let contact = contact(ratio, poisson);
        let c = contact.coefficients();
        let rows = contact.derivatives(0.3, 1e-3, [0.0; 3]).unwrap();
        let wanted = [[c.c11, 0.0, 0.0], [0.0, c.c22, -c.c23], [0.0, c.c32, c.c33]];
        for (row, wanted) in rows.iter().zip(wanted) {
            let scale = wanted.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
            for (found, wanted) in row.iter().zip(wanted) {
                assert!(
                    (found - wanted).abs() < 1e-3 * scale,
                    "{ratio} {poisson}: {rows:?} {wanted:?}"
                );
            }
        }
    }
}

/// In rigid sliding without spin the force is the friction limit against the slip; in pure spin of a circle the torque is that
/// of the pressure, 3 pi/16 of f F_z a.
#[test]
fn rigid_sliding_ends_the_table() {
    for ratio in [0.1, 0.7, 4.0] {
        let contact = contact(ratio, 0.3);
        for (x, y) in [(1.0, 0.0), (0.0, -1.0), (-0.6, 0.8)] {
            let [f_x, f_y, m_z] = forces(&contact, [1e3 * x, 1e3 * y, 0.0]);
            assert!(
                (f_x - x).abs() < 2e-3 && (f_y - y).abs() < 2e-3 && m_z.abs() < 2e-3,
                "{ratio} {x} {y}: {f_x} {f_y} {m_z}"
            );
        }
    }
    let [f_x, f_y, m_z] = forces(&contact(1.0, 0.3), [0.0, 0.0, 1e4]);
    assert!(
        (m_z - 3.0 * PI / 16.0).abs() < 1e-3 && f_x.abs() + f_y.abs() < 1e-3,
        "{f_x} {f_y} {m_z}"
    );
}

/// Without spin the forces of similar contacts depend on the scaled creepage alone: units and sizes do not count.
#[test]
fn forces_scale() {
    let one = contact(0.5, 0.28);
    let other = CreepContact::new([5e-3, 1e-2], 82e9, 0.28).unwrap();
    let small = one.force(0.3, 1e-3, [1e-4, 2e-4, 3e-4]).unwrap();
    // G ab/(f F_z) and sqrt(ab) times spin are the same.
    let (area, force) = (5e-5, 5e4);
    let along = |creepage: f64| creepage * (1.0 / 3e-4) / (82e9 * area / (0.4 * force));
    let creepage = [along(1e-4), along(2e-4), along(3e-4) / f64::sqrt(area)];
    let great = other.force(0.4, force, creepage).unwrap();
    let unit = 0.4 * force / 3e-4;
    assert!((great.f_x / (unit * small.f_x) - 1.0).abs() < 1e-12);
    assert!((great.f_y / (unit * small.f_y) - 1.0).abs() < 1e-12);
    assert!((great.m_z / (unit * f64::sqrt(area) * small.m_z) - 1.0).abs() < 1e-12);
    assert!((great.error / (unit * small.error) - 1.0).abs() < 1e-12);
}

/// Slender contacts with small creepages that are mostly spin, a/b, Poisson's ratio and creepages times G ab/(f F_z),
/// the spin times sqrt(ab) too, beside steady rolling on grids of 64 and 128 cells continued to none (to .003).
#[test]
fn the_error_of_a_slender_contact_that_spins_is_told() {
    for (ratio, poisson, creepage, off) in [
        (
            9.031911262941518,
            0.4927698756310647,
            [0.0034468762, -0.0056601111, 0.0442450324],
            0.0068,
        ),
        (
            9.708624220872846,
            0.4497694568615079,
            [-0.0899053900, -0.2133539129, 0.2205022218],
            0.0066,
        ),
        (
            0.13769344467057157,
            0.020908638303808125,
            [-0.0941308258, 0.2068365137, 2.214360172],
            0.0061,
        ),
    ] {
        let [a, b] = [f64::sqrt(ratio), f64::sqrt(1.0 / ratio)];
        let contact = CreepContact::new([a, b], 1.0, poisson).unwrap();
        let found = contact.force(1.0, 1.0, creepage).unwrap();
        assert!((off..3.0 * off).contains(&found.error), "{ratio}: {found:?}");
    }
}

#[test]
fn what_the_table_does_not_hold_is_refused() {
    for (semi_axes, modulus, poisson) in [
        ([0.099, 1.0], 1.0, 0.3),
        ([1.0, 0.0999], 1.0, 0.3),
        ([1.0, 1.0], 0.0, 0.3),
        ([1.0, 1.0], 1.0, 0.51),
        ([1.0, 1.0], 1.0, -0.1),
        ([f64::NAN, 1.0], 1.0, 0.3),
    ] {
        assert!(CreepContact::new(semi_axes, modulus, poisson).is_err());
    }
    let contact = contact(1.0, 0.3);
    for (friction, force, creepage) in [
        (0.0, 1.0, [0.0; 3]),
        (0.3, -1.0, [0.0; 3]),
        (0.3, 1.0, [f64::NAN, 0.0, 0.0]),
        (0.3, 1.0, [0.0, 0.0, f64::INFINITY]),
        (0.3, 1e300, [1e-3, 0.0, 0.0]),
        (1e-61, 1.0, [1e-3, 0.0, 0.0]),
        (0.3, 1.0, [0.0, -1e61, 0.0]),
    ] {
        assert!(contact.force(friction, force, creepage).is_err());
    }
    assert_eq!(contact.force(0.3, 1.0, [0.0; 3]).unwrap().f_x, 0.0);
}

/// At the ends of all ranges forces are numbers within the friction limit.
#[test]
fn extreme_contacts_have_forces() {
    let ends = [1e-60, 1.0, 1e60];
    for (size, modulus) in ends.into_iter().flat_map(|size| ends.map(|modulus| (size, modulus))) {
        let contact = CreepContact::of_size(size, 2.0, modulus, 0.3).unwrap();
        for (friction, force) in ends.into_iter().flat_map(|f| ends.map(|force| (f, force))) {
            for creepage in [[1e60, 0.0, 0.0], [0.0, 1e-60, -1e60], [1e60; 3], [0.0, 0.0, 1e-60]] {
                let found = contact.force(friction, force, creepage).unwrap();
                let limit = friction * force * (1.0 + 1e-12);
                assert!(found.f_x.hypot(found.f_y) <= limit, "{found:?} {creepage:?}");
                assert!(found.m_z.abs() <= limit * size && found.error <= limit, "{found:?}");
            }
        }
    }
}
