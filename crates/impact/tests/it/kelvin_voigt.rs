//! Impacts of viscous bodies by rings against a full simulation of the contact.

use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, NormalRestitution, RingImpact};
use carom_laws::friction::Friction;

/// Drawn impacts of a ball of 10 mm, 10 g and .5 m/s on a plane: moduli and Poisson's ratios of both, friction, restitution,
/// slip over f v_z, spin about the normal (rad/s); slip along and across after it, over f v_z. By relaxed and total tractions on
/// 24 cells across the contact, in steps of 1/300 of its duration, extrapolated from twice the steps; its own error is some .003.
const SIMULATED: &str = include_str!("../data/kelvin_voigt.csv");

fn simulated() -> Vec<[f64; 10]> {
    let row = |line: &str| {
        let numbers: Vec<f64> = line.split(',').map(|part| part.parse().unwrap()).collect();
        numbers.try_into().unwrap()
    };
    SIMULATED.lines().skip(1).map(row).collect()
}

/// The estimates, fitted on other impacts, cover 95 of 100.
#[test]
fn viscous_bodies_leave_as_in_a_full_simulation() {
    let (mut covered, mut sum) = (0, 0.0);
    for [g_1, nu_1, g_2, nu_2, f, e, lambda, spin, along, across] in simulated() {
        let [one, two] =
            [(g_1, nu_1), (g_2, nu_2)].map(|(g, nu)| Material::from_shear(g, nu).unwrap());
        let motion = Motion::new([0.5 * lambda * f, 0.0, -0.5], [0.0, 0.0, spin]).unwrap();
        let ball = Body::sphere(1e-2, one, 1e-2).unwrap().moving(motion);
        let collision = Collision::new(ball, Body::plane(two), Friction::new(f).unwrap()).unwrap();
        let collision = collision.with_normal_restitution(NormalRestitution::new(e).unwrap());
        let outcome = RingImpact::new(&collision).solve().unwrap();
        let rebound = outcome.rebound().unwrap();
        let over = 0.5 * f;
        let [x, y] = [0, 1].map(|k| -rebound.contact_velocity_after[k] / over);
        let told = rebound.error_estimate * rebound.contact_velocity_before.norm() / over;
        let off = (x - along).hypot(y + across);
        assert!(off < 1.3 * told + 0.003, "{f} {e} {lambda} {spin}: {off} {told}");
        covered += usize::from(off <= told);
        sum += off;
    }
    let mean = sum / 48.0;
    assert!(mean < 7e-3 && covered >= 46, "{mean} {covered}");
}
