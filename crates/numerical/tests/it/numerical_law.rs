//! Impacts on the numerical contact: against the exact solution where the bodies are alike, against an
//! independent half-space program where they are not.

use carom_halfspace::{Material, MaterialPair};
use carom_impact::coupled::{CoupledImpact, Trajectory};
use carom_impact::normal::NormalImpact;
use carom_impact::{Mobility, restitution};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_solver::NumericalLaw;
use nalgebra::{Matrix3, Vector3};

const SPEED: f64 = 1e-3;
const F: f64 = 0.1;

/// Two equal spheres of unit mass to each other, of these shear moduli and Poisson's ratios.
struct Spheres {
    hertz: Hertz,
    lambda: f64,
}

impl Spheres {
    fn new(bodies: [[f64; 2]; 2], lambda: f64) -> Self {
        let [one, two] = bodies.map(|[g, nu]| Material::from_shear(g, nu).unwrap());
        let pair = MaterialPair::new(one, two).unwrap();
        let curvature = RelativeCurvature::from_coefficients(0.5, 0.5).unwrap();
        Self { hertz: Hertz::new(curvature, pair).unwrap(), lambda }
    }

    fn mobility() -> Matrix3<f64> {
        Matrix3::from_diagonal(&Vector3::new(3.5, 3.5, 1.0))
    }

    fn velocity(&self) -> Vector3<f64> {
        Vector3::new(self.lambda * F * SPEED, 0.0, SPEED)
    }

    fn normal(&self) -> NormalImpact {
        NormalImpact::new(1.0, self.hertz.stiffness().c_z, SPEED).unwrap()
    }

    fn law(&self, cells: usize) -> NumericalLaw {
        let (friction, peak) = (Friction::new(F).unwrap(), self.normal().maximal_approach());
        NumericalLaw::new(self.hertz, friction, peak, cells).unwrap().within(1e-7).unwrap()
    }

    /// R_x, e_z and the greatest approach over Hertz's.
    fn rebound(&self, cells: usize, steps: usize) -> [f64; 3] {
        let (mut law, normal) = (self.law(cells), self.normal());
        let trajectory = Trajectory {
            mobility: Self::mobility(),
            velocity: self.velocity(),
            stiffness: self.hertz.stiffness(),
            steps,
            expected: Some(normal.duration()),
        };
        let mut peak = 0.0;
        let see = |point: &carom_impact::coupled::Point, _: &NumericalLaw| {
            peak = f64::max(peak, point.shift.z);
        };
        let end = trajectory.follow(&mut law, see).unwrap().unwrap();
        let before = self.velocity();
        let along = -end.velocity.x / before.x;
        [along, -end.velocity.z / before.z, peak / normal.maximal_approach()]
    }
}

#[test]
fn alike_spheres_tend_to_the_exact_rebound() {
    for (nu, lambda, off) in [(0.0, 0.5, 1e-3), (0.3, 2.0, 5e-4), (0.0, 4.0, 5e-5)] {
        let exact = restitution::of_spheres((2.0 - nu) / (2.0 * (1.0 - nu)), lambda).unwrap();
        let spheres = Spheres::new([[1.0, nu]; 2], lambda);
        let error = |cells, steps| (spheres.rebound(cells, steps)[0] - exact).abs();
        let (coarse, fine) = (error(20, 50), error(40, 200));
        assert!(fine < off && fine < 0.5 * coarse, "{nu} {lambda}: {coarse} {fine}");
    }
}

#[test]
fn unlike_spheres_rebound_as_in_an_independent_program() {
    let spheres = Spheres::new([[1.0, 0.0], [1.0, 0.5]], 0.5);
    // Cells, steps, R_x, e_z and greatest approach over Hertz's of that program; R_x to 0.006.
    for (cells, steps, rebound) in
        [(20, 100, [0.317_226, 0.997_048, 0.996_747]), (30, 100, [0.314_159, 0.997_100, 0.996_960])]
    {
        let found = spheres.rebound(cells, steps);
        assert!((found[0] - rebound[0]).abs() < 0.003, "{found:?}");
        assert!((found[1] - rebound[1]).abs() < 1e-4, "{found:?}");
        assert!((found[2] - rebound[2]).abs() < 5e-4, "{found:?}");
    }
}

#[test]
fn exchanged_bodies_rebound_alike() {
    let bodies = [[1.0, 0.0], [10.0, 0.0]];
    let one = Spheres::new(bodies, 0.5).rebound(12, 50);
    let other = Spheres::new([bodies[1], bodies[0]], 0.5).rebound(12, 50);
    for (one, other) in one.iter().zip(other) {
        assert!((one - other).abs() < 1e-6, "{one} {other}");
    }
    // Unlike bodies grip where like ones slide back.
    assert!(one[0] > Spheres::new([[1.0, 0.0]; 2], 0.5).rebound(12, 50)[0] + 0.4);
}

#[test]
fn it_settles_like_any_other_law() {
    let spheres = Spheres::new([[1.0, 0.0]; 2], 4.0);
    let mobility = Mobility::from_matrix(Spheres::mobility()).unwrap();
    let (stiffness, friction) = (spheres.hertz.stiffness(), Friction::new(F).unwrap());
    let impact = CoupledImpact::new(mobility, stiffness, friction, spheres.velocity()).unwrap();
    let outcome = impact.within(1e-3).unwrap().solve_with(|cells| spheres.law(cells)).unwrap();
    let found = -outcome.velocity.x / spheres.velocity().x;
    let exact = restitution::of_spheres(1.0, 4.0).unwrap();
    // R_x is over the tangential velocity, the tolerance over the whole.
    let allowed = 1e-3 * spheres.velocity().norm() / spheres.velocity().x;
    assert!((found - exact).abs() < allowed, "{found} {exact}");
}
