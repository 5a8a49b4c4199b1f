//! Torsion compared with springs and sliders in parallel, differences of the torque, and integrals
//! of the stiffness.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use carom_drawn::{Draw as _, Splitmix};
use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Shift};
use carom_laws::torsion::adhesion::AdhesiveTorsion;
use carom_laws::torsion::ellipse::EllipseTorsion;
use carom_laws::torsion::history::TwistHistory;
use carom_laws::torsion::law::TorsionLaw;

const SLIDING: f64 = 2.0;
const STIFFNESS: f64 = 5.0;

/// Equally stiff springs, each with a slider that gives way at its own twist: together they load
/// as `M_zS (1 - exp(-M_zA' beta/M_zS))`.
struct Springs {
    twist: f64,
    /// Twist at which it yields, and stretch.
    springs: Vec<[f64; 2]>,
}

impl Springs {
    const COUNT: u32 = 20_000;

    fn new() -> Self {
        let part = |i: u32| (f64::from(i) + 0.5) / f64::from(Self::COUNT);
        let yields = |i: u32| -SLIDING / STIFFNESS * (1.0 - part(i)).ln();
        Self { twist: 0.0, springs: (0..Self::COUNT).map(|i| [yields(i), 0.0]).collect() }
    }

    fn advance(&mut self, twist: f64) {
        for [limit, stretch] in &mut self.springs {
            *stretch = (*stretch + twist - self.twist).clamp(-*limit, *limit);
        }
        self.twist = twist;
    }

    fn mean(&self, of: impl Fn(&[f64; 2]) -> f64) -> f64 {
        STIFFNESS * self.springs.iter().map(of).sum::<f64>() / f64::from(Self::COUNT)
    }
}

#[test]
fn torsion_of_an_ellipse_is_that_of_springs_and_sliders() {
    // Loops inside loops; -0.6 and beyond closes the first one at minus its point of reversal.
    let path = [0.5, 0.1, 0.3, -0.2, 0.0, -0.6, -0.9, 0.4, 0.95, 0.7, 1.2, -1.3];
    let mut torsion = EllipseTorsion::new(SLIDING, STIFFNESS).unwrap();
    let mut springs = Springs::new();
    for twist in path {
        torsion.advance(twist).unwrap();
        springs.advance(twist);
        let torque = springs.mean(|[_, stretch]| *stretch);
        assert_abs_diff_eq!(torsion.torque(), torque, epsilon = 2e-4 * SLIDING);
        let sticking = springs.mean(|[limit, stretch]| f64::from(stretch.abs() < *limit));
        assert_abs_diff_eq!(torsion.tangent(), sticking, epsilon = 2e-4 * STIFFNESS);
        let energy = springs.mean(|[_, stretch]| 0.5 * stretch * stretch);
        assert_abs_diff_eq!(torsion.stored_energy(), energy, epsilon = 1e-3 * energy);
    }
}

#[test]
fn tangent_of_a_twist_is_the_slope_of_the_torque() {
    let after = |path: &[f64]| {
        let mut history = TwistHistory::new();
        history.advance(1.0, 0.0).unwrap();
        for &twist in path {
            history.advance(1.0, twist).unwrap();
        }
        history
    };
    let step = 1e-5;
    for (path, twist) in [(&[][..], 0.3), (&[], 0.9), (&[0.8], 0.4), (&[0.8], -0.2)] {
        let at = |twist: f64| after(&[path, &[twist]].concat());
        let slope = (at(twist + step).torque() - at(twist - step).torque()) / (2.0 * step);
        assert_relative_eq!(at(twist).tangent(), slope, max_relative = 1e-7);
    }
}

#[test]
fn torque_without_slip_is_the_integral_of_the_stiffness() {
    let body = Material::from_shear(2.0, 0.3).unwrap();
    let materials = MaterialPair::new(body, body).unwrap();
    let curvature = RelativeCurvature::from_coefficients(0.5, 0.2).unwrap();
    let hertz = Hertz::new(curvature, materials).unwrap();
    let stiffness =
        |zeta: f64| AdhesiveTorsion::new(hertz.ellipse(zeta).unwrap(), materials).stiffness();
    let fresh = TorsionLaw::new(&hertz, Friction::new(f64::INFINITY).unwrap()).unwrap();
    // From touch, twist growing with the approach: the stiffness grows as zeta^1.5 (5.35).
    let mut law = fresh.clone();
    let many = (1..=2000).map(|i| f64::from(i) / 2000.0).fold(0.0, |_, part| {
        let to = Shift { zeta: 0.02 * part, omega: 0.03 * part, ..Shift::default() };
        law.advance(to).unwrap().m_z
    });
    assert_relative_eq!(many, 0.4 * stiffness(0.02) * 0.03, max_relative = 1e-6);
    // In one step the twist grows with the radius.
    let mut law = fresh;
    let mut go =
        |zeta: f64, omega: f64| law.advance(Shift { zeta, omega, ..Shift::default() }).unwrap().m_z;
    let growing = go(0.02, 0.03);
    assert_relative_eq!(growing, 0.25 * stiffness(0.02) * 0.03, max_relative = 1e-12);
    let further = go(0.02, 0.05);
    assert_relative_eq!(further - growing, stiffness(0.02) * 0.02, max_relative = 1e-12);
}

/// Coarse paths on which two annuli slip, so that rings are solved, with lengths in another unit.
#[test]
fn a_twist_does_not_depend_on_the_unit_of_length() {
    let body = Material::from_shear(2.0, 0.3).unwrap();
    let law = |unit: f64| {
        let gap = RelativeCurvature::from_coefficients(0.5 / unit, 0.5 / unit).unwrap();
        let hertz = Hertz::new(gap, MaterialPair::new(body, body).unwrap()).unwrap();
        TorsionLaw::new(&hertz, Friction::new(0.3).unwrap()).unwrap()
    };
    let mut drawn = Splitmix(86);
    for _ in 0..40 {
        let units = [1.0, 1e3, 3.7e-4];
        let mut laws = units.map(law);
        let (mut zeta, mut omega, mut greatest) = (1e-6_f64, 0.0, 0.0_f64);
        for _ in 0..12 {
            zeta = (zeta + 1e-6 * drawn.between(-1.0, 1.5)).abs() + 1e-7;
            omega += drawn.between(-4e-4, 4e-4);
            let mut torques = [0.0; 3];
            for ((law, unit), torque) in laws.iter_mut().zip(units).zip(&mut torques) {
                let to = Shift { zeta: zeta * unit, omega, ..Shift::default() };
                *torque = law.advance(to).unwrap().m_z / unit.powi(3);
            }
            greatest = torques.iter().fold(greatest, |greatest, torque| greatest.max(torque.abs()));
            for torque in torques {
                assert_abs_diff_eq!(torque, torques[0], epsilon = 1e-9 * greatest);
            }
        }
    }
}
