//! Torsion against reference values of chapters 5, 7 and 10.

use std::f64::consts::PI;

use carom_drawn::{Draw as _, Splitmix};
use carom_halfspace::{Material, MaterialPair};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::torsion::adhesion::{AdhesiveTorsion, sliding_torque_arm};
use carom_laws::torsion::ellipse::EllipseTorsion;
use carom_laws::torsion::history::TwistHistory;
use carom_laws::torsion::lubkin::{Lubkin, approximate_torque};

use crate::common::{cases, close, num, tables};

fn pair(g: f64, nu: f64) -> MaterialPair {
    MaterialPair::new(Material::from_shear(g, nu).unwrap(), Material::RIGID).unwrap()
}

#[test]
fn adhesion() {
    for (inp, out) in cases("statics", "torsion_adhesion") {
        let ellipse = ContactEllipse::new(num(&inp["a"]), num(&inp["b"])).unwrap();
        let materials = pair(num(&inp["G"]), num(&inp["nu"]));
        let torsion = AdhesiveTorsion::new(ellipse, materials);
        let [t1, t2] = torsion.coefficients();
        close("T1", t1, num(&out["T1"]), 4e-15);
        close("T2", t2, num(&out["T2"]), 4e-15);
        close("stiffness", torsion.stiffness(), num(&out["stiffness"]), 4e-15);
        let slide = sliding_torque_arm(&ellipse);
        close("slide", slide, num(&out["slide_moment_over_fF"]), 4e-15);
    }
    for row in tables("torsion")["torsion_ellipse_535_765"].as_array().unwrap() {
        let ellipse = ContactEllipse::new(num(&row["a_over_b"]), 1.0).unwrap();
        let torsion = AdhesiveTorsion::new(ellipse, pair(1.0, num(&row["nu"])));
        close("compliance", 1.0 / torsion.stiffness(), num(&row["Gb3_beta_over_M"]), 4e-15);
        close("M_zS", sliding_torque_arm(&ellipse), num(&row["MzS_over_fFb"]), 4e-15);
    }
}

#[test]
fn adhesive_traction_carries_the_torque() {
    let ellipse = ContactEllipse::new(0.5, 1.0).unwrap();
    let torsion = AdhesiveTorsion::new(ellipse, pair(1.0, 0.3));
    let n = 400;
    let mut torque = 0.0;
    for i in 0..n {
        // rho = sin(t) takes the edge's root away.
        let t = (f64::from(i) + 0.5) / f64::from(n) * PI / 2.0;
        for j in 0..64 {
            let phi = (f64::from(j) + 0.5) / 64.0 * 2.0 * PI;
            let (x, y) = (0.5 * t.sin() * phi.cos(), t.sin() * phi.sin());
            let [u, v] = torsion.traction(1.0, x, y);
            torque += (y * u - x * v) * t.sin() * t.cos();
        }
    }
    torque *= 0.5 * PI / 2.0 / f64::from(n) * 2.0 * PI / 64.0;
    close("torque", torque, torsion.stiffness(), 1e-5);
}

fn check_lubkin(state: &Lubkin, out: &serde_json::Value, tolerance: f64) {
    for (name, got) in [
        ("M", state.torque()),
        ("beta", state.twist()),
        ("deficit", state.deficit()),
        ("M_approx_542", approximate_torque(state.twist())),
    ] {
        close(name, got, num(&out[name]), tolerance);
    }
}

#[test]
fn lubkin() {
    for (inp, out) in cases("statics", "lubkin_by_k") {
        check_lubkin(&Lubkin::at_modulus(num(&inp["k"])).unwrap(), &out, 1e-13);
    }
    for (inp, out) in cases("statics", "lubkin_by_kc") {
        check_lubkin(&Lubkin::at_stick_radius(num(&inp["kc"])).unwrap(), &out, 1e-14);
    }
    for (inp, out) in cases("statics", "lubkin_inverse_by_beta") {
        let state = Lubkin::at_twist(num(&inp["beta_hat"])).unwrap();
        close("kc", state.stick_radius(), num(&out["kc"]), 1e-13);
        close("M", state.torque(), num(&out["M"]), 4e-15);
        let Ok(back) = Lubkin::at_torque(state.torque()) else { continue };
        let tolerance = 1e-14 * (1.0 + 1.0 / state.stiffness());
        close("inverse", back.twist(), state.twist(), tolerance.min(0.5));
    }
    for wrong in [-1e-9, 160.0, f64::NAN] {
        assert_eq!(Lubkin::at_twist(wrong).unwrap_err().field, "twist");
        assert_eq!(Lubkin::at_torque(wrong).unwrap_err().field, "torque");
    }
    for row in tables("torsion")["lubkin"].as_array().unwrap() {
        let state = Lubkin::at_stick_radius(num(&row["kp"])).unwrap();
        close("twist", state.twist(), num(&row["Ga2beta_over_fF"]), 1e-14);
        close("torque", state.torque(), num(&row["M_over_fFa"]), 1e-14);
    }
}

#[test]
fn lubkin_traction() {
    let mut worst = 0.0_f64;
    for (inp, out) in cases("statics", "lubkin_stress") {
        let state = Lubkin::at_stick_radius(num(&inp["kc"])).unwrap();
        let (got, want) = (state.traction(num(&inp["rho"])), num(&out["sigma"]));
        let error = (got - want).abs() / want.abs().max(1e-300);
        worst = worst.max(if want == 0.0 { got.abs() } else { error });
    }
    assert!(worst < 1e-12, "{worst:e}");
    for row in tables("torsion")["lubkin_traction"].as_array().unwrap() {
        let state = Lubkin::at_stick_radius(num(&row["kp"])).unwrap();
        let got = state.traction(num(&row["rho_over_a"]));
        close("traction", got, num(&row["sigma_a2_over_fF"]), 1e-12);
    }
}

#[test]
fn histories() {
    for (name, steps) in tables("torsion")["histories"].as_object().unwrap() {
        let mut history = TwistHistory::new();
        for step in steps.as_array().unwrap() {
            let al = num(&step["al"]);
            let mu = history.advance(al, num(&step["bh"])).unwrap();
            let limit = 3.0 * PI / 32.0 * al.powi(4);
            let error = (mu - num(&step["mu"])).abs() / limit;
            assert!(error < 1e-14, "{name}: {error:e}");
            close("stick", history.stick_radius(), num(&step["stick"]), 1e-13);
            for pair in step["b_at"].as_array().unwrap() {
                let (got, want) = (history.density(num(&pair[0])), num(&pair[1]));
                assert!((got - want).abs() < 1e-13, "{name}: density {got} {want}");
            }
        }
    }
}

#[test]
fn proportional_growth_has_its_closed_form_in_any_steps() {
    for row in tables("torsion")["proportional_loading"].as_array().unwrap() {
        let (r, want) = (num(&row["r"]), num(&row["mu_al1"]));
        let error = |n: usize| {
            let mut history = TwistHistory::new();
            for i in 1..=n {
                let al = i as f64 / n as f64;
                history.advance(al, r * al).unwrap();
            }
            (history.torque() - want).abs()
        };
        for n in [1, 2, 7, 100, 400] {
            assert!(error(n) < 1e-14, "r = {r}, {n} steps: {:e}", error(n));
        }
    }
}

#[test]
fn twist_histories_keep_their_energy_and_symmetry() {
    let mut random = Splitmix(3);
    let (mut history, mut mirror) = (TwistHistory::new(), TwistHistory::new());
    let (mut al, mut bh) = (0.0, 0.0);
    let mut worst = 0.0_f64;
    for _ in 0..20_000 {
        let size = 10_f64.powf(random.between(-3.0, 0.0));
        match random.below(3) {
            0 => bh += random.between(-1.0, 1.0) * size,
            1 => al = (al + random.between(-1.0, 1.0) * size).clamp(0.05, 2.0),
            _ => {
                bh += random.between(-1.0, 1.0) * size;
                al = (al + size * random.part()).min(2.0);
            }
        }
        bh *= 0.99;
        let mu = history.advance(al, bh).unwrap();
        let minus = mirror.advance(al, -bh).unwrap();
        assert!(mu.is_finite() && (mu + minus).abs() <= 1e-13 * al.powi(4));
        let part = mu.abs() / (3.0 * PI / 32.0 * al.powi(4));
        worst = worst.max(part);
        assert!(history.stored_energy() >= 0.0);
        assert!(history.stick_radius() <= al, "{} {al}", history.stick_radius());
    }
    assert!(worst <= 1.0 + 1e-12 && history.ring_steps() > 0);
}

#[test]
fn ellipse_by_the_exponential_law() {
    let case = &tables("histories")["c7_torsion_766"];
    let (ratio, long) = (num(&case["a_over_b"]), num(&case["b_larger"]));
    let ellipse = ContactEllipse::new(ratio * long, long).unwrap();
    let materials = pair(num(&case["G_combined"]), num(&case["nu"]));
    let limit = num(&case["f"]) * num(&case["F_z"]);
    let mut torsion = EllipseTorsion::of_contact(ellipse, materials, limit).unwrap();
    close("M_zS", torsion.sliding_torque(), num(&case["M_zS"]), 1e-14);
    close("M_zA'", torsion.initial_stiffness(), num(&case["M_zA_prime"]), 1e-14);
    for pair in case["load_then_unload_beta_M"].as_array().unwrap() {
        torsion.advance(num(&pair[0])).unwrap();
        close("M", torsion.torque(), num(&pair[1]), 1e-13);
    }
    // Energy of random histories, and loops that close.
    let mut random = Splitmix(9);
    let mut torsion = EllipseTorsion::new(1.0, 2.0).unwrap();
    let mut work = 0.0;
    for _ in 0..2000 {
        let to = random.between(-2.0, 2.0);
        let n = 50;
        let from = torsion.twist();
        for i in 1..=n {
            let before = torsion.torque();
            let at = from + (to - from) * f64::from(i) / f64::from(n);
            let heat = torsion.dissipated();
            let after = torsion.advance(at).unwrap();
            assert!(torsion.dissipated() >= heat);
            work += 0.5 * (before + after) * (to - from) / f64::from(n);
        }
        assert!(torsion.torque().abs() <= 1.0);
    }
    let balance = torsion.dissipated() + torsion.stored_energy();
    close("energy", balance, work, 1e-3);
}

#[test]
fn ellipse_closes_its_first_loop_at_the_mirrored_twist() {
    // First loading, there and back again: at -beta_1 the first loading of the other sense goes on.
    for turn in [0.2, 0.7, 2.0] {
        let mut torsion = EllipseTorsion::new(1.5, 2.0).unwrap();
        torsion.advance(turn).unwrap();
        torsion.advance(-1.1 * turn).unwrap();
        let mut fresh = EllipseTorsion::new(1.5, 2.0).unwrap();
        fresh.advance(-1.1 * turn).unwrap();
        close("torque", torsion.torque(), fresh.torque(), 1e-14);
        close("tangent", torsion.tangent(), fresh.tangent(), 1e-14);
        close("energy", torsion.stored_energy(), fresh.stored_energy(), 1e-14);
    }
}

#[test]
fn ellipse_tangent_is_the_slope_of_its_torque() {
    let mut torsion = EllipseTorsion::new(1.5, 2.0).unwrap();
    for to in [0.4, 0.9, 0.1, -0.3, 0.2, -1.4, 0.5] {
        let back = (to - torsion.twist()).signum();
        torsion.advance(to).unwrap();
        let slope = |step: f64| {
            let mut next = torsion.clone();
            (next.advance(to + back * step).unwrap() - torsion.torque()) / (back * step)
        };
        // Richardson's extrapolation of one-sided differences, to the third order.
        let want = (slope(4e-4) - 6.0 * slope(2e-4) + 8.0 * slope(1e-4)) / 3.0;
        close("tangent", torsion.tangent(), want, 1e-8);
    }
}
