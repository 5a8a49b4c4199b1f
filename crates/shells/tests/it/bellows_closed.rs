//! Bellows against closed forms, and the balance of energy.

use std::f64::consts::{PI, TAU};

use carom_shells::Wall;
use carom_shells::bellows::{Axial, Bellows, BellowsLoad, BellowsState, Meridian};
use carom_special::quadrature::GaussLegendre;

use crate::reference::{bellows, close, list, number};

fn sine(mean_radius: f64, amplitude: f64, pitch: f64, wall: Wall, harmonics: usize) -> Bellows {
    Bellows::new(Meridian::sine(mean_radius, amplitude, pitch).unwrap(), wall, harmonics).unwrap()
}

fn load(pressure: f64, axial: Axial) -> BellowsLoad {
    BellowsLoad::new(pressure, axial).unwrap()
}

/// Delta = F pitch/(2 pi R E t); under pressure with closed ends u = p R^2 (1 - nu/2)/(E t).
#[test]
fn straight_tube() {
    let wall = Wall::new(3.0, 0.25, 0.05).unwrap();
    let tube = sine(2.0, 0.0, 5.0, wall, 8);
    let response = tube.linear_response().unwrap();
    close("spring rate", response.spring_rate, TAU * 2.0 * 3.0 * 0.05 / 5.0, 1e-13);
    // Fixed ends: N_s = nu N_t, F + pi R^2 p = 2 pi R N_s.
    close("area", response.effective_area, PI * 4.0 * (1.0 - 2.0 * 0.25), 1e-12);
    let pressure = 1e-7;
    let state = tube.solve(load(pressure, Axial::Force(0.0))).unwrap();
    let expected = pressure * 4.0 * (1.0 - 0.125) / (3.0 * 0.05);
    for at in state.profile() {
        close("u", at.radial_displacement, expected, 1e-4);
        assert!(at.rotation.abs() < 1e-14);
        close("axial stress", at.meridional_membrane, 0.5 * pressure * 2.0 / 0.05, 1e-4);
        close("hoop stress", at.hoop_membrane, pressure * 2.0 / 0.05, 1e-4);
    }
}

/// A shallow wave (Donnell), q = 2 pi/pitch: Delta/F = pitch/(2 pi R E t)
/// (1 + b^2 q^4 E t/(2(D q^4 + E t/R^2))), to the order of b^2.
#[test]
fn shallow_waves() {
    for case in list(&bellows(), "shallow") {
        let value = |key: &str| number(case, key);
        let wall = Wall::new(1.0, 0.3, value("t")).unwrap();
        let (radius, b, pitch) = (value("R"), value("b"), value("pitch"));
        let compliance =
            1.0 / sine(radius, b, pitch, wall, 32).linear_response().unwrap().spring_rate;
        close("compliance", compliance, value("compliance"), 1e-9);
        let fourth = (TAU / pitch).powi(4);
        let stretching = value("t");
        let resistance = wall.bending_stiffness() * fourth + stretching / (radius * radius);
        let bent = b * b * fourth * stretching / (2.0 * resistance);
        let donnell = pitch / (TAU * radius * stretching) * (1.0 + bent);
        close("formula", donnell, value("formula"), 1e-12);
        // The error is of second order in b.
        let error = compliance / donnell - 1.0;
        assert!((error / (b / radius).powi(2) / 23.0 - 1.0).abs() < 1.2, "{error:e}");
    }
}

/// A torus of thick wall is a slit circular beam with held slopes: B3 = 1, with a growth as mu^2.
#[test]
fn slit_ring_of_thick_wall() {
    let stiffness = |mu: f64| {
        let (radius, arc) = (1e4_f64, 1.0);
        let thickness = 6.61 / (2.0 * radius * mu);
        let wall = Wall::new(1.0, 0.3, thickness).unwrap();
        let torus = Bellows::new(Meridian::torus(radius, arc).unwrap(), wall, 24).unwrap();
        torus.linear_response().unwrap().spring_rate * 10.92 / (2.0 * radius * thickness.powi(3))
    };
    let [half, whole] = [stiffness(0.1) - 1.0, stiffness(0.2) - 1.0];
    assert!(half > 0.0 && half < 1e-3, "{half}");
    assert!((whole / half - 4.0).abs() < 0.1, "{whole} {half}");
}

/// The integral of F over the dilatation, with `parts` Gauss points.
fn work(bellows: &Bellows, pressure: f64, end: f64) -> f64 {
    let rule = GaussLegendre::new(12).unwrap();
    rule.integrate(0.0, end, |growth| {
        bellows.solve(load(pressure, Axial::Dilatation(growth))).unwrap().force()
    })
}

#[test]
fn work_is_stored() {
    let wall = Wall::new(1.0, 0.3, 0.1).unwrap();
    let bellows = sine(10.0, 1.0, 3.0, wall, 32);
    let state = |pressure: f64, growth: f64| -> BellowsState {
        bellows.solve(load(pressure, Axial::Dilatation(growth))).unwrap()
    };
    for growth in [0.6, -0.6] {
        let stored = state(0.0, growth).stored_energy();
        close("work", work(&bellows, 0.0, growth), stored, 1e-11);
    }
    // Under pressure: F dDelta + p dV.
    let (pressure, growth) = (2e-4, 0.3);
    let (rest, end) = (state(pressure, 0.0), state(pressure, growth));
    let done = work(&bellows, pressure, growth) + pressure * (end.volume() - rest.volume());
    let stored = end.stored_energy() - rest.stored_energy();
    assert!((done - stored).abs() < 1e-11 * end.stored_energy(), "{done} {stored}");
}

/// Small loads, F Delta = 2U to the second order: the mean over both signs.
#[test]
fn work_of_small_loads() {
    let bellows = sine(7.0, 0.8, 2.5, Wall::new(2.0, 0.2, 0.07).unwrap(), 32);
    let rate = bellows.linear_response().unwrap().spring_rate;
    let growth = 1e-4;
    let twice: f64 = [growth, -growth]
        .map(|growth| bellows.solve(load(0.0, Axial::Dilatation(growth))).unwrap().stored_energy())
        .iter()
        .sum();
    close("2 U", twice, rate * growth * growth, 1e-7);
}

#[test]
fn effective_area_is_reciprocal() {
    let walls = [(0.05, 0.0), (0.1, 0.3), (0.02, 0.45)];
    for (thickness, poisson) in walls {
        let wall = Wall::new(1.0, poisson, thickness).unwrap();
        let meridians = [
            Meridian::sine(6.0, 0.7, 2.0).unwrap(),
            Meridian::u_shaped(10.0, 0.5, 0.7).unwrap(),
            Meridian::folded(10.0, 0.5, 0.4, 1.8).unwrap(),
            Meridian::torus(5.0, 1.0).unwrap(),
        ];
        for meridian in meridians {
            let bellows = Bellows::new(meridian, wall, 48).unwrap();
            let response = bellows.linear_response().unwrap();
            close("dV/dDelta", response.volume_per_dilatation, response.effective_area, 1e-8);
        }
    }
}

/// Along any meridian d(angle) is the curvature times ds, without jumps: by radius and height alone, dr = cos(angle) ds
/// and dz = sin(angle) ds, up to the sense of the parameter; around the torus the angle grows by a whole turn.
#[test]
fn the_angle_of_a_meridian_turns_without_jumps() {
    let meridians = [
        Meridian::sine(6.0, 0.7, 2.0).unwrap(),
        Meridian::folded(10.0, 0.5, 0.4, 1.8).unwrap(),
        Meridian::torus(10.0, 1.5).unwrap(),
    ];
    const STEPS: i32 = 2000;
    for (which, meridian) in meridians.iter().enumerate() {
        let place = |k: i32| meridian.at(TAU * (f64::from(k) + 0.5) / f64::from(STEPS));
        let mut turned = 0.0;
        for k in 0..STEPS - 1 {
            let (one, two) = (place(k), place(k + 1));
            let change = two.angle - one.angle;
            turned += change;
            let [dr, dz] = [two.radius - one.radius, two.height - one.height];
            let angle = 0.5 * (one.angle + two.angle);
            let across = dr * angle.sin() - dz * angle.cos();
            assert!(change.abs() < 0.02, "{which}, {k}: {change}");
            assert!(across.abs() < 1e-3 * dr.hypot(dz), "{which}, {k}: {across}");
        }
        let whole = if which == 2 { TAU } else { 0.0 };
        assert!((turned.abs() - whole).abs() < 0.02, "{which}: {turned}");
    }
}
