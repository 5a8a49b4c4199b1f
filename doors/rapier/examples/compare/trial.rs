//! One impact, by Rapier and by the exact theory.

use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, NormalRestitution};
use carom_laws::friction::Friction;
use rapier3d::glamx::DVec3;
use rapier3d::prelude::*;

/// Radii of the balls, m.
pub(crate) const RADII: [f64; 2] = [0.5, 0.3];
/// Masses of the balls, kg.
pub(crate) const MASSES: [f64; 2] = [1.0, 0.4];
/// Speed of ball 1, m/s.
pub(crate) const SPEED: f64 = 5.0;
/// Poisson's ratio of both bodies.
pub(crate) const POISSON: f64 = 0.3;
/// Steps in which an impact must have happened.
const STEPS: usize = 30;

/// What ball 1 hits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Target {
    /// A floor that does not move.
    Floor,
    /// Ball 2, at rest, in the direction of a unit vector.
    Ball([f64; 3]),
}

/// A throw of ball 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Trial {
    /// What it hits.
    pub(crate) target: Target,
    /// Angle of the velocity from the normal, degrees.
    pub(crate) degrees: f64,
    /// Spin times radius over speed: about the direction of the drag (side), across it (top), about the normal.
    pub(crate) spin: [f64; 3],
    /// Coefficient of friction.
    pub(crate) friction: f64,
    /// Coefficient of restitution.
    pub(crate) restitution: f64,
    /// Distance of the surfaces at the start over the way of the approach in one step.
    pub(crate) gap: f64,
}

/// Motions after an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct After {
    /// Velocities of ball 1 and ball 2, m/s; those of the floor are zero.
    pub(crate) velocities: [DVec3; 2],
    /// Spins, rad/s.
    pub(crate) spins: [DVec3; 2],
}

impl Trial {
    /// A ball without spin that is thrown on the floor and touches it at once.
    pub(crate) fn plain(degrees: f64, friction: f64, restitution: f64) -> Self {
        Self { target: Target::Floor, degrees, spin: [0.0; 3], friction, restitution, gap: 1e-3 }
    }

    /// Throws at all angles up to 85 degrees, with side and top spin and spin about the normal, at three coefficients
    /// of friction and of restitution.
    pub(crate) fn all(target: Target, gap: f64) -> impl Iterator<Item = Self> {
        let spins =
            [[0.0; 3], [0.5, 0.0, 0.0], [0.0, 0.8, 0.0], [0.0, -0.8, 0.0], [-0.6, 0.4, 0.5]];
        let surfaces = [[0.1, 1.0], [0.3, 0.8], [0.8, 0.5]];
        surfaces.into_iter().flat_map(move |[friction, restitution]| {
            spins.into_iter().flat_map(move |spin| {
                (0..=17).map(move |fifth| {
                    let degrees = 5.0 * f64::from(fifth);
                    Self { target, degrees, spin, friction, restitution, gap }
                })
            })
        })
    }

    /// All throws from each of these gaps, with the exact outcome, which no gap changes.
    pub(crate) fn solved(target: Target, gaps: &[f64]) -> impl Iterator<Item = (Self, After)> {
        Self::all(target, 0.0).flat_map(move |trial| {
            let exact = trial.exact();
            gaps.iter().map(move |gap| (Self { gap: *gap, ..trial }, exact))
        })
    }

    /// Whether the material takes nothing.
    pub(crate) fn is_elastic(&self) -> bool {
        self.restitution == 1.0
    }

    /// The unit normal from ball 1 into its target, and the direction of its tangential velocity.
    pub(crate) fn axes(&self) -> [DVec3; 2] {
        let normal = match self.target {
            Target::Floor => DVec3::NEG_Y,
            Target::Ball(direction) => DVec3::from(direction),
        };
        [normal, normal.any_orthonormal_vector()]
    }

    /// Velocity and spin of ball 1 before.
    pub(crate) fn before(&self) -> [DVec3; 2] {
        let [normal, along] = self.axes();
        let (sin, cos) = self.degrees.to_radians().sin_cos();
        let [side, top, about] = self.spin;
        let spin = side * along + top * normal.cross(along) + about * normal;
        [SPEED * (cos * normal + sin * along), SPEED / RADII[0] * spin]
    }

    /// R_x: the tangential velocity of the contact point after the impact, reversed, over that before.
    pub(crate) fn r_x(&self, after: &After) -> f64 {
        let [normal, _] = self.axes();
        let [velocity, spin] = self.before();
        let across = |v: DVec3| v - v.dot(normal) * normal;
        let at = |velocity: DVec3, spin: DVec3, arm: f64| velocity + spin.cross(arm * normal);
        let before = across(at(velocity, spin, RADII[0]));
        let one = at(after.velocities[0], after.spins[0], RADII[0]);
        let two = at(after.velocities[1], after.spins[1], -RADII[1]);
        -across(one - two).dot(before) / before.length_squared()
    }

    /// The outcome by the exact theory.
    pub(crate) fn exact(&self) -> After {
        let material = Material::from_young(1e9, POISSON).unwrap();
        let [normal, _] = self.axes();
        let [velocity, spin] = self.before();
        let moving = Motion::new(velocity.into(), spin.into()).unwrap();
        let ball = |i: usize| Body::sphere(RADII[i], material, MASSES[i]).unwrap();
        let target = match self.target {
            Target::Floor => Body::plane(material),
            Target::Ball(_) => ball(1),
        };
        let friction = Friction::new(self.friction).unwrap();
        let collision =
            Collision::along(ball(0).moving(moving), target, (-normal).into(), friction).unwrap();
        let restitution = NormalRestitution::new(self.restitution).unwrap();
        // Rapier applies an impulse along the line of centres before.
        let outcome =
            collision.with_normal_restitution(restitution).keeping_axes().solve().unwrap();
        let motions = outcome.motions();
        let vector = |v: [f64; 3]| DVec3::from(v);
        After {
            velocities: motions.map(|motion| vector(motion.velocity.into())),
            spins: motions.map(|motion| vector(motion.spin.into())),
        }
    }

    /// The outcome in a world of Rapier with these hooks, without gravity and with the default parameters.
    pub(crate) fn by_rapier(&self, hooks: &dyn PhysicsHooks) -> After {
        let mut world = PhysicsWorld::new();
        world.gravity = Vector::ZERO;
        let [normal, _] = self.axes();
        let [velocity, spin] = self.before();
        let step = f64::from(world.integration_parameters.dt);
        let gap = self.gap * velocity.dot(normal) * step;
        let centre = -(RADII[0] + gap) * normal;
        let thrown = RigidBodyBuilder::dynamic()
            .translation(centre.as_vec3())
            .linvel(velocity.as_vec3())
            .angvel(spin.as_vec3());
        let (thrown, shape) = world.insert(thrown, self.ball(0));
        let (hit, target) = match self.target {
            // Its upper face is at the origin.
            Target::Floor => {
                let floor = RigidBodyBuilder::fixed().translation(-Vector::Y);
                world.insert(floor, self.surfaced(ColliderBuilder::cuboid(50.0, 1.0, 50.0)))
            }
            Target::Ball(_) => {
                let rest = RigidBodyBuilder::dynamic().translation((RADII[1] * normal).as_vec3());
                world.insert(rest, self.ball(1))
            }
        };
        for _ in 0..STEPS {
            world.step_with_events(hooks, &());
            let pair = world.narrow_phase.contact_pair(shape, target);
            if pair.is_some_and(|pair| pair.total_impulse_magnitude() > 0.0) {
                let body = |handle: RigidBodyHandle| &world.bodies[handle];
                let both = [body(thrown), body(hit)];
                return After {
                    velocities: both.map(|body| body.linvel().as_dvec3()),
                    spins: both.map(|body| body.angvel().as_dvec3()),
                };
            }
        }
        panic!("no impact in {STEPS} steps: {self:?}");
    }

    fn ball(&self, i: usize) -> ColliderBuilder {
        self.surfaced(ColliderBuilder::ball(RADII[i] as f32).mass(MASSES[i] as f32))
    }

    fn surfaced(&self, collider: ColliderBuilder) -> ColliderBuilder {
        collider
            .friction(self.friction as f32)
            .restitution(self.restitution as f32)
            .active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS)
    }
}

impl After {
    /// The largest difference of velocities over the speed of ball 1, and of spins times their radii over it.
    pub(crate) fn differs(&self, other: &Self) -> [f64; 2] {
        let largest = |one: &[DVec3; 2], two: &[DVec3; 2], unit: [f64; 2]| {
            (0..2).map(|i| unit[i] * (one[i] - two[i]).length()).fold(0.0, f64::max) / SPEED
        };
        [
            largest(&self.velocities, &other.velocities, [1.0; 2]),
            largest(&self.spins, &other.spins, RADII),
        ]
    }
}
