//! Systems of units, and one collision in each of them.

use carom_geometry::Surface;
use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, Rebound};
use carom_laws::friction::Friction;

/// Metres, kilograms and seconds in the units of a system.
#[derive(Clone, Copy)]
pub(crate) struct Units {
    pub(crate) length: f64,
    pub(crate) mass: f64,
    pub(crate) time: f64,
}

pub(crate) const SI: Units = Units { length: 1.0, mass: 1.0, time: 1.0 };
/// Millimetres, tonnes and microseconds.
pub(crate) const SMALL: Units = Units { length: 1e3, mass: 1e-3, time: 1e6 };

impl Units {
    fn material(self, young: f64, poisson: f64) -> Material {
        let pressure = self.mass / (self.length * self.time * self.time);
        Material::from_young(young * pressure, poisson).unwrap()
    }

    fn motion(self, velocity: [f64; 3], spin: [f64; 3]) -> Motion {
        let speed = self.length / self.time;
        Motion::new(velocity.map(|v| v * speed), spin.map(|w| w / self.time)).unwrap()
    }

    fn ball(self, radius: f64, mass: f64, material: Material, motion: Motion) -> Body {
        let ball = Body::sphere(radius * self.length, material, mass * self.mass).unwrap();
        ball.moving(motion)
    }
}

pub(crate) fn collision(units: Units, round: bool, unlike: f64) -> Collision {
    let (glass, other) = (units.material(70e9, 0.22), units.material(70e9, unlike));
    let motion = units.motion([0.5, 0.3, -2.0], [12.0, -31.0, 20.0]);
    let one = if round {
        units.ball(0.02, 0.08, glass, motion)
    } else {
        let axes = [0.03, 0.02, 0.015].map(|axis| axis * units.length);
        let shape = Surface::ellipsoid(axes).unwrap();
        let inertia = shape.solid(0.1 * units.mass).unwrap();
        Body::new(shape, glass, inertia).moving(motion)
    };
    let two = units.ball(0.04, 0.3, other, units.motion([-0.2, 0.1, 0.4], [5.0, 3.0, -4.0]));
    Collision::along(one, two, [0.3, 0.5, 0.8], Friction::new(0.2).unwrap()).unwrap()
}

/// Every number of a rebound with its dimensions: powers of length, mass and time.
pub(crate) fn numbers(r: &Rebound) -> Vec<(&'static str, f64, [i32; 3])> {
    let mut all = vec![
        ("restitution", r.r_x.unwrap(), [0, 0, 0]),
        ("duration", r.duration, [0, 0, 1]),
        ("maximal force", r.maximal_force, [1, 1, -2]),
        ("maximal approach", r.maximal_approach, [1, 0, 0]),
        ("semi-axis a", r.maximal_contact.semi_axis_a(), [1, 0, 0]),
        ("semi-axis b", r.maximal_contact.semi_axis_b(), [1, 0, 0]),
        ("maximal pressure", r.peak_pressure, [-1, 1, -2]),
        ("energy before", r.energy.before, [2, 1, -2]),
        ("energy after", r.energy.after, [2, 1, -2]),
        ("dissipated", r.energy.dissipated, [2, 1, -2]),
        ("error estimate", r.error_estimate, [0, 0, 0]),
    ];
    for axis in 0..3 {
        all.push(("impulse", r.impulse[axis], [1, 1, -1]));
        all.push(("velocity after", r.contact_velocity_after[axis], [1, 0, -1]));
        for body in 0..2 {
            all.push(("velocity", r.motions[body].velocity[axis], [1, 0, -1]));
            all.push(("spin", r.motions[body].spin[axis], [0, 0, -1]));
        }
    }
    all
}

pub(crate) fn are_the_same(one: &Rebound, other: &Rebound, tolerance: f64) {
    let Units { length, mass, time } = SMALL;
    for ((name, value, [l, m, t]), (_, scaled, _)) in numbers(one).into_iter().zip(numbers(other)) {
        let unit = length.powi(l) * mass.powi(m) * time.powi(t);
        let off = (scaled / unit - value).abs();
        // An estimate is a difference of what is nearly equal.
        let tolerance = if name == "error estimate" { 0.05 } else { tolerance };
        assert!(off <= tolerance * value.abs().max(1e-9), "{name}: {value} {}", scaled / unit);
    }
    assert_eq!(one.warnings.len(), other.warnings.len());
    assert_eq!(one.compressions, other.compressions);
}
