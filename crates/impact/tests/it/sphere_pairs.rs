//! Invariants of random pairs of spheres: all entry points agree; exchanged, mirrored, rotated and separating
//! bodies.

use crate::spheres::{chi_of_sphere, collided, friction, same};
use carom_geometry::{Attitude, Surface};
use carom_halfspace::Material;
use carom_impact::closed_form::restitution_without_slip;
use carom_impact::{Body, Collision, Motion, Rebound};
use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;

/// Two spheres in any motion: sizes over 12 decades, masses over 18, any place and attitude.
#[derive(Debug, Clone)]
struct Pair {
    radii: [f64; 2],
    masses: [f64; 2],
    normal: Vector3<f64>,
    place: Vector3<f64>,
    turns: [Attitude; 2],
    motions: [Motion; 2],
    friction: f64,
    poisson: f64,
}

fn direction() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0..1.0f64)
        .prop_map(Vector3::from)
        .prop_filter("not zero", |v| v.norm() > 0.1)
        .prop_map(|v| v.normalize())
}

fn power(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (low..high).prop_map(|exponent| libm::pow(10.0, exponent))
}

/// A part of a motion: often exactly nothing, else of any size.
fn part() -> impl Strategy<Value = Vector3<f64>> {
    prop_oneof![
        1 => Just(Vector3::zeros()),
        3 => prop::array::uniform3(-1.0..1.0f64).prop_map(Vector3::from),
        1 => (direction(), power(-300.0, 0.0)).prop_map(|(v, size)| v * size),
    ]
}

fn pair() -> impl Strategy<Value = Pair> {
    let turn = || (direction(), -3.0..3.0f64);
    (
        (power(-3.0, 0.0), power(-6.0, 6.0), any::<bool>()),
        prop::array::uniform2(power(-9.0, 9.0)),
        prop_oneof![direction(), Just(Vector3::z())],
        prop_oneof![Just(0.0), power(-3.0, 6.0)],
        (direction(), turn(), turn()),
        (part(), part(), part(), part(), power(-3.0, 2.0)),
        prop_oneof![Just(0.0), Just(f64::INFINITY), power(-6.0, 3.0), 0.0..1.0f64],
        -0.9..0.5f64,
    )
        .prop_map(
            |((small, ratio, exchange), masses, normal, far, place, parts, friction, poisson)| {
                let large = small * ratio.max(1.0 / ratio);
                let radii = if exchange { [large, small] } else { [small, large] };
                let (direction, one, two) = place;
                let turned = |(axis, angle): (Vector3<f64>, f64)| {
                    Attitude::about(axis.into(), angle).unwrap()
                };
                let (v_1, v_2, w_1, w_2, approach) = parts;
                let motion =
                    |v: Vector3<f64>, w: Vector3<f64>| Motion::new(v.into(), w.into()).unwrap();
                Pair {
                    radii,
                    masses,
                    normal,
                    place: direction * far,
                    turns: [turned(one), turned(two)],
                    motions: [
                        motion(v_1 - normal * (approach + 4.0), w_1 / radii[0]),
                        motion(v_2, w_2 / radii[1]),
                    ],
                    friction,
                    poisson,
                }
            },
        )
}

impl Pair {
    fn material(&self) -> Material {
        Material::from_shear(1e9, self.poisson).unwrap()
    }

    fn along(&self, normal: [f64; 3]) -> Collision {
        let body = |i: usize| {
            Body::sphere(self.radii[i], self.material(), self.masses[i])
                .unwrap()
                .moving(self.motions[i])
        };
        Collision::along(body(0), body(1), normal, friction(self.friction)).unwrap()
    }

    fn encounter(&self) -> Collision {
        let body = |i: usize| {
            let side = if i == 0 { 1.0 } else { -1.0 };
            let surface = Surface::sphere(self.radii[i]).unwrap();
            let inertia = surface.solid(self.masses[i]).unwrap();
            Body::new(surface, self.material(), inertia)
                .turned(self.turns[i])
                .at((self.place + self.normal * (side * self.radii[i])).into())
                .unwrap()
                .moving(self.motions[i])
        };
        Collision::touching(body(0), body(1), friction(self.friction)).unwrap()
    }

    fn seen_through(&self, view: &Matrix3<f64>) -> Self {
        let hand = view.determinant().signum();
        let turned = |motion: &Motion| Motion {
            velocity: view * motion.velocity,
            spin: view * motion.spin * hand,
        };
        let motions = self.motions.each_ref().map(turned);
        Self { normal: view * self.normal, motions, ..self.clone() }
    }

    fn exchanged(&self) -> Self {
        let other = |i: usize| 1 - i;
        Self {
            radii: [0, 1].map(|i| self.radii[other(i)]),
            masses: [0, 1].map(|i| self.masses[other(i)]),
            motions: [0, 1].map(|i| self.motions[other(i)]),
            turns: [0, 1].map(|i| self.turns[other(i)]),
            normal: -self.normal,
            ..self.clone()
        }
    }

    fn along_normal(&self) -> Rebound {
        collided(&self.along(self.normal.into()).keeping_axes())
    }

    /// The greatest velocity of the contact that is about: roundings are measured against it.
    fn speed(&self) -> f64 {
        let of = |i: usize| {
            self.motions[i].velocity.norm() + self.motions[i].spin.norm() * self.radii[i]
        };
        of(0) + of(1)
    }

    fn is_close(&self, own: &Rebound, other: &Rebound) -> Result<(), TestCaseError> {
        let (speed, allowed) = (self.speed(), 1e-12);
        for i in 0..2 {
            let (own, other) = (&own.motions[i], &other.motions[i]);
            let off = (own.velocity - other.velocity).norm() / speed;
            prop_assert!(off <= allowed, "velocity {off:e}");
            let off = (own.spin - other.spin).norm() * self.radii[i] / speed;
            prop_assert!(off <= allowed, "spin {off:e}");
        }
        Ok(())
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn spheres_in_their_places_and_along_their_normal_are_the_same(pair in pair()) {
        let encounter = pair.encounter();
        let d = encounter.mobility().matrix();
        prop_assert_eq!((d.m12, d.m13, d.m23, d.m11), (0.0, 0.0, 0.0, d.m22));
        same(&encounter, |normal| pair.along(normal))?;
    }

    #[test]
    fn exchange_mirror_and_turn_of_spheres(pair in pair(), turn in (direction(), -3.0..3.0f64)) {
        let rebound = pair.along_normal();
        let mut exchanged = pair.exchanged().along_normal();
        exchanged.motions.reverse();
        pair.is_close(&exchanged, &rebound)?;
        let turn = *Attitude::about(turn.0.into(), turn.1).unwrap().matrix();
        let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0));
        for view in [turn, mirror, turn * mirror] {
            let mut seen = pair.seen_through(&view).along_normal();
            let hand = view.determinant().signum();
            for motion in &mut seen.motions {
                motion.velocity = view.tr_mul(&motion.velocity);
                motion.spin = view.tr_mul(&motion.spin) * hand;
            }
            pair.is_close(&seen, &rebound)?;
        }
    }

    #[test]
    fn bodies_that_do_not_approach_are_left_alone(pair in pair()) {
        let motions = pair.motions.map(|motion| Motion { velocity: -motion.velocity, ..motion });
        let parting = Pair { motions, ..pair };
        let collision = parting.along(parting.normal.into());
        for outcome in [collision.solve().unwrap(), parting.encounter().solve().unwrap()] {
            prop_assert!(outcome.rebound().is_none());
            prop_assert_eq!(outcome.motions(), motions);
        }
        prop_assert!(collision.history(7).unwrap().is_empty());
    }

    #[test]
    fn restitution_is_continuous_to_normal_incidence(
        exponent in -300.0..0.0f64,
        f in power(-3.0, 2.0),
        poisson in -0.9..0.5f64,
        angle in -3.0..3.0f64,
    ) {
        let material = Material::from_shear(1e9, poisson).unwrap();
        let chi = chi_of_sphere(poisson);
        let limit = restitution_without_slip(chi);
        let slip = libm::pow(10.0, exponent);
        let velocity = [slip * angle.cos(), slip * angle.sin(), -1.0];
        let ball = Body::sphere(0.02, material, 0.1).unwrap();
        let ball = ball.moving(Motion::new(velocity, [0.0; 3]).unwrap());
        let collision = Collision::new(ball, Body::plane(material), friction(f)).unwrap();
        let own = collided(&collision).r_x.unwrap();
        let psi = slip / f * chi / 3.5;
        prop_assert!((own - limit).abs() <= 2.0 * psi + 1e-11, "{own} {limit} {psi:e}");
    }
}

/// An impact that slides throughout is at Coulomb's limit to the last digits, however little of the motion it
/// changes: where 1 + R_x is 1e-12, too.
#[test]
fn what_grazes_is_at_coulombs_limit() {
    let steel = Material::from_young(208e9, 0.3).unwrap();
    for exponent in 1..13 {
        for f in [1e-4, 0.01, 0.3] {
            let normal = libm::pow(10.0, -f64::from(exponent));
            let motion = Motion::new([1.0, 0.2, -normal], [0.0; 3]).unwrap();
            let ball = Body::sphere(0.01, steel, 0.03).unwrap().moving(motion);
            let other = Body::sphere(0.02, steel, 0.5).unwrap();
            let rebound =
                collided(&Collision::new(ball, other, friction(f)).unwrap().keeping_axes());
            let impulse = rebound.impulse;
            let (drag, limit) = (impulse.xy().norm(), f * impulse.z);
            assert!((drag / limit - 1.0).abs() < 1e-15, "{normal} {f}: {drag} of {limit}");
            let heat = drag * 1.04_f64.sqrt();
            assert!((rebound.energy.dissipated / heat - 1.0).abs() < 4.0 * f * normal + 1e-14);
        }
    }
}
