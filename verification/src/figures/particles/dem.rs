//! Two balls, or a ball and a plane, integrated in time like a particle code, with textbook constants and a
//! bed of springs for the contact: independent of carom's laws and impacts.

use crate::spring_impact::SpringBed;

const SPRINGS: usize = 400;
const STEPS: usize = 1600;

/// Elastic constants and density.
#[derive(Clone, Copy)]
pub(super) struct Substance {
    pub(super) young: f64,
    pub(super) poisson: f64,
    pub(super) density: f64,
}

/// A ball that moves in a plane.
#[derive(Clone, Copy)]
pub(super) struct Ball {
    pub(super) radius: f64,
    pub(super) mass: f64,
    /// Of the centre: along the surface, along the normal from ball 2 to ball 1.
    pub(super) velocity: [f64; 2],
    /// About the third axis: a positive spin moves the upper side along the surface.
    pub(super) spin: f64,
}

impl Ball {
    pub(super) fn solid(radius: f64, substance: Substance) -> Self {
        let volume = 4.0 / 3.0 * std::f64::consts::PI * radius * radius * radius;
        Self { radius, mass: substance.density * volume, velocity: [0.0; 2], spin: 0.0 }
    }

    pub(super) const fn moving(self, velocity: [f64; 2], spin: f64) -> Self {
        Self { velocity, spin, ..self }
    }

    /// A plane that does not move.
    pub(super) const PLANE: Self =
        Self { radius: f64::INFINITY, mass: f64::INFINITY, velocity: [0.0; 2], spin: 0.0 };

    /// Velocity of the point at `arm` above the centre, along the surface.
    fn surface_velocity(&self, arm: f64) -> f64 {
        if self.mass.is_finite() { self.velocity[0] + self.spin * arm } else { 0.0 }
    }

    /// An impulse on the point at `arm` above the centre.
    fn push(&mut self, impulse: [f64; 2], arm: f64) {
        if self.mass.is_finite() {
            let inertia = 0.4 * self.mass * self.radius * self.radius;
            self.velocity[0] += impulse[0] / self.mass;
            self.velocity[1] += impulse[1] / self.mass;
            self.spin += arm * impulse[0] / inertia;
        }
    }
}

/// How they touch.
#[derive(Clone, Copy)]
pub(super) struct Contact {
    /// E* and G* of the pair.
    moduli: [f64; 2],
    friction: f64,
}

impl Contact {
    /// Two bodies of the same substance.
    pub(super) fn alike(substance: Substance, friction: f64) -> Self {
        let [normal, shear] = Self::on_rigid(substance, friction).moduli;
        Self { moduli: [0.5 * normal, 0.5 * shear], friction }
    }

    /// A body on a rigid one: E* = E/(1 - nu^2), G* = G/(2 - nu).
    pub(super) fn on_rigid(substance: Substance, friction: f64) -> Self {
        let Substance { young, poisson, .. } = substance;
        let shear = young / (2.0 * (1.0 + poisson));
        Self { moduli: [young / (1.0 - poisson * poisson), shear / (2.0 - poisson)], friction }
    }
}

/// The end of an impact and its extremes.
#[derive(Clone, Copy)]
pub(super) struct Course {
    pub(super) balls: [Ball; 2],
    pub(super) duration: f64,
    pub(super) greatest_force: f64,
    pub(super) greatest_approach: f64,
}

/// Hertz's greatest approach, greatest force and duration of an impact to come.
pub(super) fn extremes(balls: &[Ball; 2], contact: Contact) -> [f64; 3] {
    let [one, two] = balls;
    let mass = 1.0 / (1.0 / one.mass + 1.0 / two.mass);
    hertz(contact.moduli[0], combined_radius(balls), mass, two.velocity[1] - one.velocity[1])
}

fn combined_radius([one, two]: &[Ball; 2]) -> f64 {
    1.0 / (1.0 / one.radius + 1.0 / two.radius)
}

/// The same from E*, R*, m* and the approach velocity.
fn hertz(modulus: f64, radius: f64, mass: f64, velocity: f64) -> [f64; 3] {
    let root = radius.sqrt();
    let approach = libm::pow(15.0 * mass * velocity * velocity / (16.0 * modulus * root), 0.4);
    let force = 4.0 / 3.0 * modulus * root * approach * approach.sqrt();
    let share = libm::tgamma(0.4) / libm::tgamma(0.9);
    let duration = 0.8 * std::f64::consts::PI.sqrt() * share * approach / velocity;
    [approach, force, duration]
}

/// Ball 1 above ball 2, from touch to separation.
pub(super) fn collide(mut balls: [Ball; 2], contact: Contact) -> Course {
    let [deepest, _, duration] = extremes(&balls, contact);
    let radius = combined_radius(&balls);
    let stiffness = [2.0 * contact.moduli[0], 8.0 * contact.moduli[1]];
    let mut bed = SpringBed::new(SPRINGS, 1.001 * deepest, radius, stiffness, contact.friction);
    let dt = duration / STEPS as f64;
    let arms = [-balls[0].radius, balls[1].radius];
    let (mut approach, mut shift, mut time) = (0.0, 0.0, 0.0);
    let mut course = Course { balls, duration, greatest_force: 0.0, greatest_approach: 0.0 };
    loop {
        let drift = |balls: &[Ball; 2], approach: &mut f64, shift: &mut f64| {
            *approach += 0.5 * dt * (balls[1].velocity[1] - balls[0].velocity[1]);
            let slip = balls[1].surface_velocity(arms[1]) - balls[0].surface_velocity(arms[0]);
            *shift += 0.5 * dt * slip;
        };
        drift(&balls, &mut approach, &mut shift);
        let load = bed.advance(approach, shift);
        balls[0].push([dt * load.tangential, dt * load.normal], arms[0]);
        balls[1].push([-dt * load.tangential, -dt * load.normal], arms[1]);
        drift(&balls, &mut approach, &mut shift);
        time += dt;
        course.greatest_force = load.normal.max(course.greatest_force);
        course.greatest_approach = approach.max(course.greatest_approach);
        if approach <= 0.0 {
            let receding = balls[0].velocity[1] - balls[1].velocity[1];
            return Course { balls, duration: time + approach / receding, ..course };
        }
    }
}
