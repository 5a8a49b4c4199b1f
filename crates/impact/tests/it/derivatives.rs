//! Derivatives of the rebound of spheres and planes against central differences of the exact impact.

use carom_drawn::{Draw as _, Xorshift};
use carom_geometry::{Inertia, Surface};
use carom_halfspace::Material;
use carom_impact::{
    Body, Collision, CollisionError, CollisionSolver, Input, Motion, NormalRestitution, Outcome,
    TorsionMode,
};
use carom_laws::friction::Friction;
use carom_laws::static_friction::StaticFriction;
use nalgebra::Vector3;

const COUNT: usize = Input::ALL.len();

/// All inputs of two balls, or of a ball and a plane, and the given ratio of stiffnesses.
#[derive(Clone, Copy)]
struct Drawn {
    inputs: [f64; COUNT],
    is_plane: bool,
    has_ratio: bool,
}

impl Drawn {
    fn of(draw: &mut Xorshift) -> Self {
        let mut inputs = [0.0; COUNT];
        let mut set = |input: Input, value: f64| inputs[input.column()] = value;
        for i in 0..2 {
            for axis in 0..3 {
                set(Input::Velocity(i, axis), draw.signed());
                set(Input::Spin(i, axis), 40.0 * draw.signed());
            }
            set(Input::Radius(i), 0.01 + 0.02 * draw.part());
            set(Input::Mass(i), 0.02 + 0.1 * draw.part());
            set(Input::Inertia(i), 0.3 + 0.36 * draw.part());
            set(Input::ShearModulus(i), 1e9 * (1.0 + draw.part()));
            set(Input::Poisson(i), 0.1 + 0.35 * draw.part());
        }
        set(Input::Velocity(0, 2), -2.5 - draw.part());
        set(Input::Friction, 0.1 + 0.8 * draw.part());
        set(Input::StiffnessRatio, 0.9 + 0.5 * draw.part());
        Self { inputs, is_plane: draw.part() < 0.5, has_ratio: draw.part() < 0.5 }
    }

    fn body(&self, i: usize) -> Body {
        let at = |input: Input| self.inputs[input.column()];
        let [shear, poisson] = [at(Input::ShearModulus(i)), at(Input::Poisson(i))];
        let material = Material::from_shear(shear, poisson).unwrap();
        let [velocity, spin] = [Input::Velocity, Input::Spin]
            .map(|kind: fn(usize, usize) -> Input| [0, 1, 2].map(|axis| at(kind(i, axis))));
        let motion = Motion::new(velocity, spin).unwrap();
        if i == 1 && self.is_plane {
            return Body::plane(material).moving(motion);
        }
        let (radius, mass) = (at(Input::Radius(i)), at(Input::Mass(i)));
        let moment = at(Input::Inertia(i)) * mass * radius * radius;
        let inertia = Inertia::new(mass, [moment; 3]).unwrap();
        Body::new(Surface::sphere(radius).unwrap(), material, inertia).moving(motion)
    }

    fn collision(&self) -> Collision {
        let friction = Friction::new(self.inputs[Input::Friction.column()]).unwrap();
        let normal = [0.3, -0.2, 1.0];
        let collision = Collision::along(self.body(0), self.body(1), normal, friction).unwrap();
        let collision = collision.with_torsion_mode(TorsionMode::LeftOut).keeping_axes();
        match self.has_ratio {
            true => collision.with_stiffness_ratio(self.inputs[Input::StiffnessRatio.column()]),
            false => Ok(collision),
        }
        .unwrap()
    }

    fn after(&self) -> [f64; 12] {
        let motions = self.collision().solve().unwrap().motions();
        let part = |i: usize| {
            let motion = motions[i / 2];
            if i.is_multiple_of(2) { motion.velocity } else { motion.spin }
        };
        std::array::from_fn(|row| part(row / 3)[row % 3])
    }

    /// psi over the values at which the course of an impact changes, as far as the nearest.
    fn nearness(&self, collision: &Collision) -> (f64, f64) {
        let (d, before) = (collision.mobility().matrix(), collision.velocity());
        let stiffness = collision.hertz().stiffness();
        let own = stiffness.c_z / stiffness.c_x;
        let kappa = if self.has_ratio { self.inputs[Input::StiffnessRatio.column()] } else { own };
        let slip = before.x.hypot(before.y);
        let friction = self.inputs[Input::Friction.column()];
        let (chi, psi) = (d.m11 / (d.m33 * kappa), slip / (before.z * kappa * friction));
        let changes = [1.0, chi, 2.0 * chi - 1.0];
        let reach = changes.map(|at| (psi / at - 1.0).abs()).into_iter().fold(1.0, f64::min);
        (reach, slip.min(before.z))
    }
}

/// The size of an input, by which entries of a row are compared.
fn size(drawn: &Drawn, input: Input) -> f64 {
    match input {
        Input::Velocity(..) => 1.0,
        Input::Spin(body, _) => 1.0 / drawn.inputs[Input::Radius(body).column()],
        _ => drawn.inputs[input.column()],
    }
}

/// The largest difference over the largest entry of its row, and how many impacts were left out near a change of regime.
fn compared(count: usize) -> (f64, usize) {
    let mut draw = Xorshift(0x2026_1129);
    let (mut left_out, mut worst) = (0, 0.0_f64);
    for _ in 0..count {
        let drawn = Drawn::of(&mut draw);
        let collision = drawn.collision();
        let (reach, slowest) = drawn.nearness(&collision);
        if reach < 1e-4 {
            left_out += 1;
            continue;
        }
        let found = collision.derivatives().unwrap().unwrap();
        assert!(!found.is_at_change);
        let mut wanted = found.matrix;
        for input in Input::ALL {
            let part = (1e-5_f64).min(2e-3 * reach);
            let is_motion = matches!(input, Input::Velocity(..) | Input::Spin(..));
            let step = size(&drawn, input) * part * if is_motion { slowest.min(1.0) } else { 1.0 };
            let at = |by: f64| {
                let mut moved = drawn;
                moved.inputs[input.column()] += by * step;
                moved.after()
            };
            let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(at);
            for row in 0..12 {
                let by = (8.0 * (c[row] - b[row]) - (d[row] - a[row])) / (12.0 * step);
                wanted[(row, input.column())] = by;
            }
        }
        // The ratio of stiffnesses alone is no input of materials.
        if !drawn.has_ratio {
            let column = Input::StiffnessRatio.column();
            wanted.set_column(column, &found.matrix.column(column).clone_owned());
        }
        for row in 0..12 {
            let scaled = |matrix: &nalgebra::SMatrix<f64, 12, COUNT>| {
                Input::ALL.map(|input| matrix[(row, input.column())] * size(&drawn, input))
            };
            let (own, wanted) = (scaled(&found.matrix), scaled(&wanted));
            let largest = wanted.into_iter().map(f64::abs).fold(0.0, f64::max);
            for (own, wanted) in own.into_iter().zip(wanted) {
                worst = worst.max((own - wanted).abs() / largest);
            }
        }
    }
    (worst, left_out)
}

#[test]
fn derivatives_are_central_differences_of_drawn_impacts() {
    let (worst, left_out) = compared(400);
    assert!(worst <= 1e-7 && left_out <= 2, "{worst:e} {left_out}");
}

#[test]
#[ignore = "takes a minute"]
fn derivatives_are_central_differences_of_ten_thousand_drawn_impacts() {
    let (worst, left_out) = compared(10_000);
    println!("worst {worst:e}, left out {left_out}");
    assert!(worst <= 1e-7 && left_out <= 50, "{worst:e} {left_out}");
}

#[test]
fn the_motions_are_those_of_the_impact() {
    let mut draw = Xorshift(5);
    for _ in 0..200 {
        let drawn = Drawn::of(&mut draw);
        let found = drawn.collision().derivatives().unwrap().unwrap();
        let exact = drawn.after();
        for (i, motion) in found.motions.iter().enumerate() {
            let [velocity, spin] =
                [0, 3].map(|from| Vector3::from_row_slice(&exact[6 * i + from..][..3]));
            assert!((motion.velocity - velocity).norm() < 1e-13);
            assert!((motion.spin - spin).norm() < 1e-11);
        }
    }
}

/// The analytic law, whatever the materials are.
struct Analytic;

impl CollisionSolver for Analytic {
    type Error = CollisionError;

    fn solve(&self, collision: &Collision) -> Result<Outcome, CollisionError> {
        collision.solve()
    }

    fn out_of_range(_: &CollisionError) -> Option<carom_special::RangeError> {
        None
    }
}

#[test]
fn differences_are_the_closed_derivatives_within_their_errors() {
    let mut draw = Xorshift(77);
    for _ in 0..20 {
        let drawn = Drawn::of(&mut draw);
        let collision = drawn.collision();
        if drawn.nearness(&collision).0 < 1e-2 {
            continue;
        }
        let closed = collision.derivatives().unwrap().unwrap().matrix;
        // Bodies that yield: the impulse is that of elastic ones times (1 + e)/2.
        let part = |e: f64| 0.5 * (1.0 + e);
        let of_yield = NormalRestitution::by_yield(0.6).unwrap();
        let yields = collision.clone().with_normal_restitution(of_yield);
        for (collision, part) in [(collision, 1.0), (yields, part(0.6))] {
            let found = collision.differences(&Analytic, 1e-4).unwrap().unwrap();
            for input in Input::ALL {
                // Without a given ratio the one of the materials counts.
                if input == Input::StiffnessRatio && !drawn.has_ratio {
                    continue;
                }
                let column = input.column();
                for row in 0..12 {
                    let own = if row == column { 1.0 } else { 0.0 };
                    let wanted = own + part * (closed[(row, column)] - own);
                    let off = (found.derivatives.matrix[(row, column)] - wanted).abs();
                    let scale = if row % 6 < 3 { 1.0 } else { 100.0 } / size(&drawn, input);
                    assert!(off <= 1e-6 * scale, "{input:?} {row}: {off:e} {wanted}");
                }
            }
        }
    }
}

#[test]
fn what_has_no_closed_theory_has_no_derivatives() {
    let drawn = Drawn::of(&mut Xorshift(9));
    let none = |collision: Collision| collision.derivatives().unwrap().is_none();
    let collision = drawn.collision();
    assert!(!none(collision.clone()));
    let mut heavy = drawn;
    for i in 0..2 {
        heavy.inputs[Input::Mass(i).column()] *= 1e3;
    }
    assert!(!none(heavy.collision()));
    assert!(none(collision.clone().with_normal_restitution(NormalRestitution::new(0.9).unwrap())));
    assert!(none(collision.clone().with_torsion()));
    let [f, k] = [0.3, 0.2].map(|f| Friction::new(f).unwrap());
    assert!(none(collision.with_friction(StaticFriction::new(f, k).unwrap()).unwrap()));
    let leaves = drawn.body(0).moving(Motion::new([0.0, 0.0, 9.0], [0.0; 3]).unwrap());
    assert!(none(Collision::new(leaves, drawn.body(1), f).unwrap()));
}

#[test]
fn without_friction_and_without_slip_one_sided_derivatives_are_finite() {
    let drawn = Drawn::of(&mut Xorshift(3));
    let limit = |friction: Friction| drawn.collision().with_friction(friction).unwrap();
    for friction in [Friction::NONE, Friction::INFINITE] {
        let found = limit(friction).derivatives().unwrap().unwrap();
        assert!(found.matrix.iter().all(|entry| entry.is_finite()), "{friction:?}");
    }
    // From f = 0 on friction is f J_z against the slip.
    let found = limit(Friction::NONE).derivatives().unwrap().unwrap();
    let [some, none] = [Friction::new(1e-6).unwrap(), Friction::NONE]
        .map(|friction| limit(friction).solve().unwrap().motions()[0].velocity);
    let by = found.matrix.fixed_view::<3, 1>(0, Input::Friction.column());
    assert!(((some - none) * 1e6 - by).norm() < 1e-8 * by.norm());
}

/// At the least slip at which a ball slides throughout, psi = 2 chi - 1, one side of a step grips at the end.
#[test]
fn differences_across_a_change_of_regime_are_of_one_side_and_flagged() {
    let steel = Material::from_shear(80e9, 0.3).unwrap();
    let (friction, kappa) = (0.1, (1.0 - 0.15) / (1.0 - 0.3));
    let limit = friction * (7.0 - kappa);
    for (part, flagged) in [(1.0 + 2e-4, true), (1.5, false), (0.9, false)] {
        let motion = Motion::new([part * limit, 0.0, -1.0], [0.0; 3]).unwrap();
        let ball = Body::sphere(0.01, steel, 0.0329).unwrap().moving(motion);
        let friction = Friction::new(friction).unwrap();
        let collision = Collision::new(ball, Body::plane(steel), friction).unwrap();
        let found = collision.differences(&Analytic, 1e-3).unwrap().unwrap();
        assert_eq!(found.derivatives.is_at_change, flagged, "{part}");
        let by = found.derivatives.matrix[(0, Input::Friction.column())];
        if part > 1.0 {
            // v_x' = v_x - 2 f |v_z|.
            assert!((by + 2.0).abs() < 1e-6, "{part}: {by}");
        }
    }
}

#[test]
fn a_ratio_of_stiffnesses_that_is_too_small_is_named() {
    let steel = Material::from_shear(80e9, 0.3).unwrap();
    let motion = Motion::new([0.2, 0.0, -1.0], [0.0; 3]).unwrap();
    let ball = Body::sphere(0.01, steel, 0.0329).unwrap().moving(motion);
    let collision = Collision::new(ball, Body::plane(steel), Friction::new(0.1).unwrap()).unwrap();
    let told = collision.with_stiffness_ratio(0.034).unwrap().derivatives().unwrap_err();
    assert!(told.to_string().contains("normal_over_tangential_stiffness = 0.034"), "{told}");
}
