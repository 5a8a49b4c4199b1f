//! Rigid slip against reference values of chapter 14.

use carom_classic::rigid_slip::{pole_of, rigid_slip, spin_about};
use carom_laws::ellipse::ContactEllipse;

use crate::reference::{num, tables};

#[test]
fn any_pole() {
    let mut worst = 0.0_f64;
    for row in tables("torsion")["rigid_slip_14_3"].as_array().unwrap() {
        let ellipse = ContactEllipse::new(num(&row["a"]), num(&row["b"])).unwrap();
        let (x, y) = (num(&row["xp"]), num(&row["yp"]));
        let load = spin_about(&ellipse, x, y).unwrap();
        // The table has beta = -Omega in its forces.
        for (got, want) in [(-load.force_x, "fx"), (-load.force_y, "fy"), (load.torque, "mz")] {
            let error = (got - num(&row[want])).abs();
            worst = worst.max(error);
            assert!(error < 1e-12, "{row} {want} {got}");
        }
        let pole = pole_of(&ellipse, num(&row["vK"]), num(&row["alpha_deg"]).to_radians());
        assert!((pole[0] - x).abs() < 1e-14 * (1.0 + x.abs()));
        assert!((pole[1] - y).abs() < 1e-14 * (1.0 + y.abs()));
    }
    println!("worst {worst:e}");
    for row in tables("torsion")["rigid_slip_circle"].as_array().unwrap() {
        let circle = ContactEllipse::circle(1.0).unwrap();
        let load = spin_about(&circle, 0.0, num(&row["v"])).unwrap();
        assert!((-load.force_x - num(&row["f"])).abs() < 1e-13);
        assert!((load.torque - num(&row["m"])).abs() < 1e-13);
    }
}

/// Spin that is slow beside the slip: its tractions lean by x Omega/xi, which makes the torque
/// f F_z (x^2 in the mean) Omega/xi, of a^2/5 for the pressure of Hertz.
#[test]
fn slow_spin_has_a_torque_of_its_own() {
    for (a, b) in [(1.0_f64, 1.0_f64), (0.2, 3.0), (5.0, 0.4)] {
        let (ellipse, size) = (ContactEllipse::new(a, b).unwrap(), (a * b).sqrt());
        for (slow, tolerance) in [(2e-4, 1e-6), (1e-6, 1e-9), (1e-60, 1e-9)] {
            for (velocity, square) in [([2.0, 0.0], a * a), ([0.0, -2.0], b * b)] {
                let spin = 2.0 * slow / a.max(b);
                let load = rigid_slip(&ellipse, velocity, spin).unwrap();
                let torque = 0.2 * square * (0.5 * spin) / size;
                assert!((load.torque / torque - 1.0).abs() < tolerance, "{a} {b} {slow}: {load:?}");
                let sign = 0.5 * (velocity[0] * load.force_x + velocity[1] * load.force_y);
                assert!((sign - 1.0).abs() < tolerance, "{load:?}");
            }
        }
    }
}
