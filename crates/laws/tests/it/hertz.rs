//! Curvature, Hertz contact and stiffness against 25-digit reference values.

use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::hertz::{Hertz, HertzParameters, HertzState};
use carom_laws::stiffness::ContactStiffness;
use carom_special::AxisRatio;
use carom_table::Value as Told;
use serde_json::Value;

use crate::common::{cases, close, num};

fn pair(inp: &Value) -> MaterialPair {
    let body = |g: &str, nu: &str| Material::from_shear(num(&inp[g]), num(&inp[nu])).unwrap();
    if inp.get("G").is_some() {
        return MaterialPair::new(body("G", "nu"), Material::RIGID).unwrap();
    }
    let rigid_or = |g: &str, nu: &str| {
        if num(&inp[g]).is_infinite() { Material::RIGID } else { body(g, nu) }
    };
    MaterialPair::new(rigid_or("G1", "nu1"), rigid_or("G2", "nu2")).unwrap()
}

fn check_contact(hertz: &Hertz, state: &HertzState, out: &Value) {
    let c = hertz.stiffness();
    let p = hertz.parameters();
    let tol = 4e-15;
    for (name, got) in [
        ("a", state.ellipse.semi_axis_a()),
        ("b", state.ellipse.semi_axis_b()),
        ("kc", hertz.axis_ratio().get()),
        ("zeta", state.approach),
        ("F", state.force),
        ("sigma_z0", state.peak_pressure),
        ("A", hertz.curvature().a()),
        ("B", hertz.curvature().b()),
        ("cz", c.c_z),
        ("cx", c.c_x),
        ("cy", c.c_y),
        ("alpha", p.alpha),
        ("beta", p.beta),
        ("gamma", p.gamma),
        ("delta", p.delta),
    ] {
        if let Some(want) = out.get(name) {
            close(name, got, num(want), tol);
        }
    }
}

#[test]
fn parameters_of_the_axis_ratio() {
    for (inp, out) in cases("statics", "hertz_dimensionless_by_kc") {
        let p = HertzParameters::of(AxisRatio::new(num(&inp["kc"])).unwrap());
        for (name, got) in
            [("alpha", p.alpha), ("beta", p.beta), ("gamma", p.gamma), ("delta", p.delta)]
        {
            close(name, got, num(&out[name]), 2e-15);
        }
    }
}

#[test]
fn stiffness_ratios() {
    for (inp, out) in cases("statics", "stiffness_ratios") {
        let ratio = AxisRatio::new(num(&inp["kc"])).unwrap();
        let c = ContactStiffness::from_axis_ratio(1.0, ratio, num(&inp["nu"])).unwrap();
        close("cx_over_cz", c.c_x, num(&out["cx_over_cz"]), 2e-15);
        close("cy_over_cz", c.c_y, num(&out["cy_over_cz"]), 2e-15);
    }
}

#[test]
fn from_curvature_and_force_or_approach() {
    for table in ["hertz_from_AB_F", "hertz_from_AB_zeta"] {
        for (inp, out) in cases("statics", table) {
            let (a, b) = (num(&inp["A"]), num(&inp["B"]));
            let gap = RelativeCurvature::from_coefficients(a, b).unwrap();
            let hertz = Hertz::new(gap, pair(&inp)).unwrap();
            let state = match inp.get("F") {
                Some(force) => hertz.at_force(num(force)).unwrap(),
                None => hertz.at_approach(num(&inp["zeta"])).unwrap(),
            };
            check_contact(&hertz, &state, &out);
            let again = hertz.at_semi_axis_a(state.ellipse.semi_axis_a()).unwrap();
            close("F from a", again.force, state.force, 2e-15);
            let again = hertz.at_semi_axis_b(state.ellipse.semi_axis_b()).unwrap();
            close("F from b", again.force, state.force, 2e-15);
        }
    }
}

#[test]
fn from_the_axes() {
    for (inp, out) in cases("statics", "hertz_from_axes") {
        let ellipse = ContactEllipse::new(num(&inp["a"]), num(&inp["b"])).unwrap();
        let force = num(&inp["F"]);
        let hertz = Hertz::from_ellipse_and_force(ellipse, force, pair(&inp)).unwrap();
        let state = hertz.at_force(force).unwrap();
        close("a", state.ellipse.semi_axis_a(), ellipse.semi_axis_a(), 4e-15);
        check_contact(&hertz, &state, &out);
    }
}

#[test]
fn from_the_radii() {
    for table in ["principal_curvatures", "hertz_from_radii"] {
        for (inp, out) in cases("statics", table) {
            let radii = |r: &str, across: &str| {
                PrincipalRadii::new(num(&inp[r]), num(&inp[across])).unwrap()
            };
            let gap =
                RelativeCurvature::new(radii("R1", "R1p"), radii("R2", "R2p"), num(&inp["omega"]))
                    .unwrap();
            close("A", gap.a(), num(&out["A"]), 4e-15);
            close("B", gap.b(), num(&out["B"]), 2e-14);
            if gap.a() != gap.b() {
                let turn = gap.angle() - num(&out["alpha_angle"]);
                assert!(turn.sin().abs() < 1e-14, "alpha {} {out}", gap.angle());
            }
            if inp.get("F").is_some() {
                let hertz = Hertz::new(gap, pair(&inp)).unwrap();
                check_contact(&hertz, &hertz.at_force(num(&inp["F"])).unwrap(), &out);
                let column = Hertz::COLUMNS.iter().find(|column| column.name() == "angle").unwrap();
                let Told::Number(degrees) = column.value(&hertz) else { panic!("a number") };
                close("degrees", degrees * std::f64::consts::PI / 180.0, gap.angle(), 1e-15);
            }
        }
    }
}

#[test]
fn slender_contacts_invert() {
    let steel = Material::from_shear(1.0, 0.3).unwrap();
    let pair = MaterialPair::new(steel, steel).unwrap();
    for exponent in 0..=12 {
        let ratio = 10f64.powi(-exponent);
        let ellipse = ContactEllipse::new(ratio, 1.0).unwrap();
        let given = Hertz::from_ellipse(ellipse, 1e-3, pair).unwrap();
        let found = Hertz::new(given.curvature(), pair).unwrap();
        close("kc", found.axis_ratio().get(), ratio, 3e-15);
        close("b", found.ellipse(1e-3).unwrap().semi_axis_b(), 1.0, 3e-15);
    }
}

#[test]
fn pressure_carries_the_force_and_the_tangent_is_its_derivative() {
    let body = Material::from_shear(1.0, 0.2).unwrap();
    let gap = RelativeCurvature::from_coefficients(3.0, 1.0).unwrap();
    let hertz = Hertz::new(gap, MaterialPair::new(body, body).unwrap()).unwrap();
    let state = hertz.at_approach(0.01).unwrap();
    let (a, b) = (state.ellipse.semi_axis_a(), state.ellipse.semi_axis_b());
    // Midpoint rule in the elliptical radius squared, where sqrt(1 - q) has a weak end.
    let n = 20_000;
    let mut sum = 0.0;
    for i in 0..n {
        let q = 1.0 - ((f64::from(i) + 0.5) / f64::from(n)).powi(2);
        sum += state.pressure(a * q.sqrt(), 0.0) * (1.0 - q).sqrt();
    }
    let force = std::f64::consts::PI * a * b * 2.0 * sum / f64::from(n);
    close("force", force, state.force, 1e-8);
    let h = 1e-6;
    let slope = (hertz.force(0.01 + h) - hertz.force(0.01 - h)) / (2.0 * h);
    close("tangent", slope, state.normal_stiffness, 1e-8);
    close("surface", hertz.contact_surface(0.01, 0.002, 0.002), 0.005, 1e-15);
    // A rigid body keeps its surface.
    for (pair, surface) in [([Material::RIGID, body], 0.002), ([body, Material::RIGID], 0.007)] {
        let hertz = Hertz::new(gap, MaterialPair::new(pair[0], pair[1]).unwrap()).unwrap();
        close("rigid surface", hertz.contact_surface(0.01, 0.002, 0.003), surface, 1e-15);
    }
    assert_eq!(hertz.force(-1.0), 0.0);
    assert_eq!(hertz.at_approach(f64::NAN).unwrap_err().field, "approach");
    assert_eq!(hertz.at_force(-1.0).unwrap_err().field, "force");
}

#[test]
fn compression_stores_the_work_of_the_force() {
    let body = Material::from_shear(1.0, 0.2).unwrap();
    let gap = RelativeCurvature::from_coefficients(3.0, 1.0).unwrap();
    let hertz = Hertz::new(gap, MaterialPair::new(body, body).unwrap()).unwrap();
    // Two points of Gauss in the root of the approach, of which F dzeta is a quartic.
    let (mut work, parts, root) = (0.0, 200, 0.1_f64);
    for i in 0..parts {
        for node in [0.5 - 0.75_f64.sqrt() / 3.0, 0.5 + 0.75_f64.sqrt() / 3.0] {
            let t = root * (f64::from(i) + node) / f64::from(parts);
            work += hertz.force(t * t) * 2.0 * t * root / f64::from(2 * parts);
        }
    }
    close("energy", hertz.normal_energy(0.01), work, 1e-9);
    assert_eq!(hertz.normal_energy(-0.01), 0.0);
}
