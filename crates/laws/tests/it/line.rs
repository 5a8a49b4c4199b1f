//! The line contact against quadrature of Flamant's solution, slender ellipses and its own integrals.

use carom_halfspace::{Material, MaterialPair, Point, Stress, Traction};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::field::partial_slip_stress;
use carom_laws::line::{LineContact, line_stress};
use std::f64::consts::PI;

fn steel() -> Material {
    Material::from_young(208e9, 0.3).unwrap()
}

fn roller() -> LineContact {
    LineContact::new(5e-3, 20e-3, MaterialPair::new(steel(), steel()).unwrap()).unwrap()
}

/// The stress under line loads with the densities p and t sqrt(1 - s^2), by Flamant's solution
/// sigma_rr = -2 (p cos + t sin)/(pi r), s = cos u at Gauss-Chebyshev points, whose rule is exact for their form.
fn by_flamant(peak: Traction, x: f64, z: f64) -> Stress {
    let count = 4000;
    let mut sum = Stress::default();
    for i in 1..=count {
        let u = PI * f64::from(i) / f64::from(count + 1);
        let weight = PI / f64::from(count + 1) * u.sin() * u.sin();
        let (dx, r2) = (x - u.cos(), (x - u.cos()).powi(2) + z * z);
        let radial = -2.0 / PI * (peak.normal * z + peak.x * dx) / r2;
        // Out of the plane: a line load t_y gives the stress -t_y/(pi r) along r.
        let across = -peak.y / (PI * r2);
        sum = sum
            + Stress {
                xx: radial * dx * dx / r2,
                zz: radial * z * z / r2,
                zx: radial * dx * z / r2,
                xy: across * dx,
                yz: across * z,
                ..Stress::default()
            } * weight;
    }
    sum
}

fn differ(one: Stress, other: Stress) -> f64 {
    let parts = |s: Stress| [s.xx, s.zz, s.xy, s.yz, s.zx];
    parts(one).iter().zip(parts(other)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn stresses_are_those_of_flamants_line_loads() {
    for peak in [
        Traction { x: 0.0, y: 0.0, normal: 1.0 },
        Traction { x: 0.3, y: 0.0, normal: 0.0 },
        Traction { x: 0.0, y: 0.4, normal: 0.0 },
        Traction { x: -0.3, y: 0.2, normal: 1.0 },
    ] {
        for (x, z) in
            [(0.0, 0.3), (0.4, 0.1), (-0.9, 0.5), (1.0, 0.2), (-1.7, 0.05), (2.5, 1.0), (0.0, 4.0)]
        {
            let found = line_stress(1.0, steel(), peak, 0.0, [x, z]).unwrap();
            assert!(differ(found, by_flamant(peak, x, z)) < 1e-12, "{peak:?} {x} {z}");
            assert!((found.yy - 0.3 * (found.xx + found.zz)).abs() < 1e-15);
        }
    }
}

/// Partial slip is the traction of sliding less that of the strip that sticks.
#[test]
fn a_strip_that_sticks_has_the_traction_of_cattaneo() {
    let peak = Traction { x: 0.3, y: 0.1, normal: 1.0 };
    let found = line_stress(2.0, steel(), peak, 0.6, [0.5, 0.4]).unwrap();
    let whole = by_flamant(peak, 0.25, 0.2);
    let kept = Traction { x: -0.6 * 0.3, y: -0.6 * 0.1, normal: 0.0 };
    let strip = by_flamant(kept, 0.5 / 1.2, 0.4 / 1.2);
    assert!(differ(found, whole + strip) < 1e-12);
}

/// In the middle of an ellipse ten thousand times as long as wide, whose stresses along and across differ by (1 - 2 nu) a/b.
#[test]
fn a_slender_ellipse_has_the_stresses_of_a_line() {
    let ellipse = ContactEllipse::new(1.0, 1e4).unwrap();
    let peak = Traction { x: 0.3, y: 0.2, normal: 1.0 };
    for (x, z) in [(0.0, 0.0), (0.3, 0.0), (0.5, 0.7), (-1.2, 0.3), (0.9, 2.0)] {
        let slender =
            partial_slip_stress(ellipse, steel(), peak, 0.5, Point { x, y: 0.0, z }).unwrap();
        let line = line_stress(1.0, steel(), peak, 0.5, [x, z]).unwrap();
        let off = differ(slender, line).max((slender.yy - line.yy).abs());
        assert!(off < 5e-5, "{x} {z}: {off:e} {slender:?} {line:?}");
    }
}

/// The surface carries the tractions, and nothing beyond the strip.
#[test]
fn tractions_are_those_of_the_surface() {
    let peak = Traction { x: 0.3, y: 0.2, normal: 1.0 };
    for x in [-1.0, -0.6, 0.0, 0.8, 1.0] {
        let form = f64::sqrt(1.0 - x * x);
        let found = line_stress(1.0, steel(), peak, 0.0, [x, 0.0]).unwrap();
        let off = [found.zz + form, found.zx + 0.3 * form, found.yz + 0.2 * form];
        assert!(off.iter().all(|off| off.abs() < 1e-15), "{x}: {off:?}");
    }
    let beyond = line_stress(1.0, steel(), peak, 0.0, [1.5, 0.0]).unwrap();
    assert!(beyond.zz.abs() + beyond.zx.abs() + beyond.yz.abs() < 1e-15);
}

/// The approach in the middle is the displacement by 1/(pi E* r) over the strip of length L: along it 2 asinh(L/(2 |x|)),
/// across it by quadrature with the logarithm taken out.
#[test]
fn the_approach_is_that_of_a_loaded_strip() {
    for length in [5e-3, 20e-3, 0.5] {
        let line = LineContact::new(5e-3, length, roller().materials()).unwrap();
        let state = line.at_force(2e3).unwrap();
        let (a, modulus) = (state.half_width, line.materials().contact_modulus());
        let count = 20_000;
        let mut sum = 0.0;
        for i in 0..count {
            // s = t^3 crowds the points at the singularity in the middle.
            let t = (f64::from(i) + 0.5) / f64::from(count);
            let (x, weight) = (a * t * t * t, 3.0 * a * t * t / f64::from(count));
            sum += 2.0 * weight * state.pressure(x) * 2.0 * (0.5 * length / x).asinh();
        }
        let exact = sum / (PI * modulus);
        // The closed form leaves out (a/L)^2.
        let error = (state.approach / exact - 1.0).abs();
        assert!(error < 1e-6 + (a / length).powi(2), "{length}: {error}");
    }
}

#[test]
fn each_load_gives_the_same_contact() {
    let line = roller();
    let state = line.at_force(1234.0).unwrap();
    for other in [
        line.at_approach(state.approach).unwrap(),
        line.at_half_width(state.half_width).unwrap(),
        line.at_peak_pressure(state.peak_pressure).unwrap(),
    ] {
        assert!((other.force / state.force - 1.0).abs() < 1e-13);
        assert!((other.approach / state.approach - 1.0).abs() < 1e-13);
    }
    for force in [1e-9, 1.0, 1e6] {
        let state = line.at_force(force).unwrap();
        let again = line.at_approach(state.approach).unwrap();
        assert!((again.force / force - 1.0).abs() < 1e-12, "{force}");
        let step = 1e-5 * state.approach;
        let [less, more] =
            [-step, step].map(|by| line.at_approach(state.approach + by).unwrap().force);
        assert!(((more - less) / (2.0 * step) / state.normal_stiffness - 1.0).abs() < 1e-8);
    }
}

/// No shear below the middle exceeds the one that is named, .30028 p_0 at .78615 a.
#[test]
fn the_greatest_shear_is_found_by_a_search() {
    let state = roller().at_force(1e3).unwrap();
    let peak = Traction { x: 0.0, y: 0.0, normal: state.peak_pressure };
    let shear = |z: f64| {
        let stress = line_stress(state.half_width, steel(), peak, 0.0, [0.0, z]).unwrap();
        0.5 * (stress.xx - stress.zz).abs()
    };
    let at = state.greatest_shear_depth();
    assert!((shear(at) / state.greatest_shear() - 1.0).abs() < 1e-14);
    for i in 1..2000 {
        assert!(
            shear(1e-3 * f64::from(i) * 2.0 * state.half_width)
                <= state.greatest_shear() * (1.0 + 1e-15)
        );
    }
}

/// Carter's traction f p - f (b/a) p_b, whose strip sticks at the leading edge, has the creepage (f/R)(a - b) there: the
/// difference of the strains -2 f p_0 x/(E* a) of both parts; its sum is the force.
#[test]
fn carters_force_is_that_of_his_tractions() {
    let line = roller();
    let state = line.at_force(1e3).unwrap();
    let (a, friction) = (state.half_width, 0.3);
    for stick in [0.0, 0.2, 0.5, 0.9, 1.0] {
        let creepage = friction * a * (1.0 - stick) / line.radius();
        let found = line.carter(&state, friction, creepage).unwrap();
        assert!((found - (1.0 - stick * stick)).abs() < 1e-14);
        assert_eq!(line.carter(&state, friction, -creepage).unwrap(), -found);
    }
    assert_eq!(line.carter(&state, friction, 1.0).unwrap(), 1.0);
}

#[test]
fn what_is_no_line_is_refused() {
    let pair = roller().materials();
    for (radius, length) in
        [(0.0, 1.0), (1.0, -1.0), (f64::INFINITY, 1.0), (1.0, f64::NAN), (1.0, 1e308)]
    {
        assert!(LineContact::new(radius, length, pair).is_err());
    }
    let line = roller();
    for state in
        [line.at_force(0.0), line.at_force(1e30), line.at_approach(1.0), line.at_half_width(11e-3)]
    {
        assert!(state.is_err());
    }
    assert!(
        line_stress(1.0, steel(), Traction { x: 0.0, y: 0.0, normal: 1.0 }, 1.5, [0.0, 0.0])
            .is_err()
    );
    assert!(
        line_stress(1.0, steel(), Traction { x: 0.0, y: 0.0, normal: 1.0 }, 0.5, [0.0, -1.0])
            .is_err()
    );
    let state = line.at_force(1.0).unwrap();
    assert!(line.carter(&state, 0.0, 0.1).is_err() && line.carter(&state, 0.3, f64::NAN).is_err());
}
