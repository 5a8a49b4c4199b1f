//! The quantities of a rebound of which a study computes statistics.

use nalgebra::Vector3;

use crate::outcome::Rebound;

/// A scalar quantity of a rebound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// R_x.
    Restitution,
    /// Speed of the centre of a body afterwards: body 1 is 0, body 2 is 1.
    Speed(usize),
    /// Angle of that velocity from the normal that points away from the other body, degrees.
    Angle(usize),
    /// Component (x, y, z: 0, 1, 2) of that velocity.
    Velocity(usize, usize),
    /// Component of the angular velocity of a body afterwards.
    Spin(usize, usize),
    /// Duration.
    Duration,
    /// Maximum normal force.
    MaximalForce,
    /// The greatest pressure.
    PeakPressure,
    /// Energy dissipated.
    Dissipated,
}

impl Quantity {
    const COUNT: usize = 21;

    /// All quantities.
    pub const ALL: [Self; Self::COUNT] = [
        Self::Restitution,
        Self::Speed(0),
        Self::Angle(0),
        Self::Velocity(0, 0),
        Self::Velocity(0, 1),
        Self::Velocity(0, 2),
        Self::Spin(0, 0),
        Self::Spin(0, 1),
        Self::Spin(0, 2),
        Self::Speed(1),
        Self::Angle(1),
        Self::Velocity(1, 0),
        Self::Velocity(1, 1),
        Self::Velocity(1, 2),
        Self::Spin(1, 0),
        Self::Spin(1, 1),
        Self::Spin(1, 2),
        Self::Duration,
        Self::MaximalForce,
        Self::PeakPressure,
        Self::Dissipated,
    ];

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Restitution => "R_x",
            Self::Speed(0) => "body_1_speed",
            Self::Speed(_) => "body_2_speed",
            Self::Angle(0) => "body_1_angle",
            Self::Angle(_) => "body_2_angle",
            Self::Velocity(0, 0) => "body_1_velocity_x",
            Self::Velocity(0, 1) => "body_1_velocity_y",
            Self::Velocity(0, _) => "body_1_velocity_z",
            Self::Velocity(_, 0) => "body_2_velocity_x",
            Self::Velocity(_, 1) => "body_2_velocity_y",
            Self::Velocity(_, _) => "body_2_velocity_z",
            Self::Spin(0, 0) => "body_1_spin_x",
            Self::Spin(0, 1) => "body_1_spin_y",
            Self::Spin(0, _) => "body_1_spin_z",
            Self::Spin(_, 0) => "body_2_spin_x",
            Self::Spin(_, 1) => "body_2_spin_y",
            Self::Spin(_, _) => "body_2_spin_z",
            Self::Duration => "duration",
            Self::MaximalForce => "maximal_force",
            Self::PeakPressure => "peak_pressure",
            Self::Dissipated => "energy_dissipated",
        }
    }

    /// Its value in a rebound; None if it has none.
    pub(crate) fn of(self, rebound: &Rebound) -> Option<f64> {
        let motion = |body: usize| &rebound.motions[body.min(1)];
        Some(match self {
            Self::Restitution => return rebound.r_x,
            Self::Speed(body) => motion(body).velocity.norm(),
            Self::Angle(body) => {
                let sign = if body == 0 { 1.0 } else { -1.0 };
                from_normal(&motion(body).velocity, &(sign * rebound.normal))
            }
            Self::Velocity(body, axis) => motion(body).velocity[axis.min(2)],
            Self::Spin(body, axis) => motion(body).spin[axis.min(2)],
            Self::Duration => rebound.duration,
            Self::MaximalForce => rebound.maximal_force,
            Self::PeakPressure => rebound.peak_pressure,
            Self::Dissipated => rebound.energy.dissipated,
        })
    }
}

// Zero for a body at rest.
fn from_normal(velocity: &Vector3<f64>, normal: &Vector3<f64>) -> f64 {
    if *velocity == Vector3::zeros() {
        return 0.0;
    }
    let along = velocity.dot(normal);
    libm::atan2((velocity - along * normal).norm(), along).to_degrees()
}
