//! The memory law against independent values of chapters 6 and 7.

use carom_laws::memory::{Fixed, Memory, MemoryRegime, ScalarMemory, VectorMemory};
use serde_json::Value;

use crate::common::{close, num, tables};

fn histories(prefix: &str) -> Vec<(String, Value)> {
    let all: Vec<_> = tables("histories")
        .as_object()
        .unwrap()
        .iter()
        .filter(|(name, case)| name.starts_with(prefix) && case.get("results").is_some())
        .map(|(name, case)| (name.clone(), case.clone()))
        .collect();
    assert!(all.len() >= 6);
    all
}

fn list(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(num).collect()
}

fn regime_name(regime: MemoryRegime) -> &'static str {
    match regime {
        MemoryRegime::Separated => "separated",
        MemoryRegime::Adhesion => "adhesion",
        MemoryRegime::Sliding => "sliding",
        _ => "slip",
    }
}

/// Two equal spheres, with the displacements of one of them.
struct Spheres {
    radius: f64,
    per_shift: f64,
    force: f64,
    traction: f64,
    energy: f64,
}

impl Spheres {
    fn new(case: &Value) -> Self {
        let [radius, g, nu, f] = ["R", "G", "nu", "f"].map(|name| num(&case[name]));
        let kappa = (2.0 - nu) / (2.0 * (1.0 - nu));
        let mu = 4.0 * f * g / (std::f64::consts::PI * radius * (1.0 - nu)); // (6.4)
        let force = 2.0 * std::f64::consts::PI * mu / 3.0 * radius.powf(1.5);
        Self {
            radius,
            per_shift: 1.0 / (f * kappa),
            force,
            traction: mu * radius.sqrt(),
            energy: force * f * kappa,
        }
    }
}

#[test]
fn chapter_6() {
    for (name, case) in histories("c6_") {
        let spheres = Spheres::new(&case);
        let mut memory = ScalarMemory::new();
        let mut fixed = Memory::<f64, Fixed<f64, 64>>::new();
        let results = case["results"].as_array().unwrap();
        let f = num(&case["f"]);
        for (step, want) in case["history"].as_array().unwrap().iter().zip(results) {
            let step = list(step);
            let phi = memory.advance(step[0], step[1] * spheres.per_shift).unwrap();
            let same = fixed.advance(step[0], step[1] * spheres.per_shift).unwrap();
            assert_eq!(phi, same);
            let limit = f * num(&want["F_z"]);
            let error = (phi * spheres.force - num(&want["F_x"])).abs();
            assert!(error <= 1e-14 * limit.max(1e-3), "{name}: {error:e} of {limit}");
            assert!((memory.stick_depth() - num(&want["zeta_star"])).abs() < 1e-15);
            let offset = memory.slide_offset() / spheres.per_shift;
            assert!((offset - num(&want["slide_offset"])).abs() < 1e-15);
            let energy = memory.stored_energy() * spheres.energy;
            close("energy", energy, num(&want["U_t_one_sphere"]), 1e-10);
            let regime = regime_name(memory.regime());
            assert_eq!(regime, want["regime"].as_str().unwrap(), "{name} {step:?}");
        }
        for pair in case["final_traction_rho_sigma"].as_array().unwrap() {
            let [rho, sigma] = [num(&pair[0]), num(&pair[1])];
            let q = rho * rho / (spheres.radius * memory.zeta());
            let got = memory.traction(q) * spheres.traction * memory.zeta().sqrt();
            assert!((got - sigma).abs() < 1e-9, "{name}: traction {got} for {sigma}");
        }
        assert_eq!(fixed.merges(), 0);
    }
}

#[test]
fn chapter_7() {
    for (name, case) in histories("c7_") {
        let [c_x, c_y, c_z, f] = ["c_x", "c_y", "c_z", "f"].map(|name| num(&case[name]));
        let mut memory = VectorMemory::new();
        let mut fixed = Memory::<[f64; 2], Fixed<[f64; 2], 64>>::new();
        let results = case["results"].as_array().unwrap();
        let mut worst = 0.0_f64;
        for (step, want) in case["history"].as_array().unwrap().iter().zip(results) {
            let step = list(step);
            let e = [c_x * step[1] / (f * c_z), c_y * step[2] / (f * c_z)];
            let phi = memory.advance(step[0], e).unwrap();
            assert_eq!(phi, fixed.advance(step[0], e).unwrap());
            let force = phi.map(|phi| 2.0 * f * c_z / 3.0 * phi);
            let limit = f * num(&want["F_z"]);
            let error =
                (force[0] - num(&want["F_x"])).abs().max((force[1] - num(&want["F_y"])).abs());
            worst = worst.max(error / limit);
            let star = num(&want["zeta_star"]);
            assert!((memory.stick_depth() - star).abs() < 1e-13 * memory.zeta(), "{name} {star}");
            if let Some(direction) = want["slip_dir"].as_array() {
                let got = memory.slip_direction().unwrap();
                assert!((got[0] + num(&direction[0])).abs() < 1e-12);
                assert!((got[1] + num(&direction[1])).abs() < 1e-12);
            }
        }
        assert!(worst < 1e-14, "{name}: {worst:e}");
        for row in case["final_normalised_traction"].as_array().unwrap() {
            let [rho, x, y] = [num(&row[0]), num(&row[1]), num(&row[2])];
            let got = memory.traction(rho * rho).map(|t| t * memory.zeta().sqrt());
            // A stick area of depth 2e-13, on the knife's edge, shows as its root at the centre.
            let tolerance = if rho == 0.0 { 1e-6 } else { 1e-12 };
            assert!((got[0] - x).abs() < tolerance && (got[1] - y).abs() < tolerance, "{name}");
        }
    }
}

#[test]
fn collinear_paths_in_two_directions_are_those_in_one() {
    let (s, c) = 0.7_f64.sin_cos();
    for (_, case) in histories("c6_") {
        let spheres = Spheres::new(&case);
        let (mut one, mut two) = (ScalarMemory::new(), VectorMemory::new());
        for step in case["history"].as_array().unwrap() {
            let (zeta, x) = (num(&step[0]), num(&step[1]) * spheres.per_shift);
            let phi = one.advance(zeta, x).unwrap();
            let pair = two.advance(zeta, [c * x, s * x]).unwrap();
            let scale = zeta.max(0.0).powf(1.5).max(1e-300);
            assert!((pair[0] - c * phi).abs() < 1e-14 * scale);
            assert!((pair[1] - s * phi).abs() < 1e-14 * scale);
        }
    }
}
