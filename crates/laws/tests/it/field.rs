//! Displacements under an ellipsoidal traction against reference values.

use carom_halfspace::{Material, MaterialPair};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::field::ellipsoidal_shear;

use crate::common::{close, num, tables};

#[test]
fn gamma_phi_psi_theta() {
    for row in tables("histories")["c7_gamma_phi_psi_theta"].as_array().unwrap() {
        let [ratio, nu] = [num(&row[0]), num(&row[1])];
        let materials =
            MaterialPair::new(Material::from_shear(1.0, nu).unwrap(), Material::RIGID).unwrap();
        let ellipse = ContactEllipse::new(ratio, 1.0).unwrap();
        // u_0 = sigma b/(2G) for a < b, sigma a/(2G) for a > b.
        let sigma = 2.0 / ratio.max(1.0);
        let at = |x: f64, y: f64| ellipsoidal_shear(&ellipse, sigma, &materials, x, y).unwrap();
        let centre = at(0.0, 0.0)[0];
        close("Gamma", centre, num(&row[2]), 1e-14);
        let absolute = |got: f64, want: f64| assert!((got - want).abs() < 4e-15 * (1.0 + centre));
        absolute(centre - at(ratio, 0.0)[0], num(&row[3]));
        absolute(centre - at(0.0, 1.0)[0], num(&row[4]));
        let half = 0.5_f64.sqrt() * (1.0 - 1e-15);
        absolute(2.0 * at(ratio * half, half)[1], num(&row[5]));
    }
}
