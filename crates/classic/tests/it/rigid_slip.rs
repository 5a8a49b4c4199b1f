//! Rigid slip against reference values of chapter 14.

use carom_classic::rigid_slip::{pole_of, spin_about};
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
