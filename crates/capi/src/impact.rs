//! The impact of two bodies.

use carom_geometry::{Attitude, Inertia, Surface, SurfaceError};
use carom_impact::{
    Body, Collision, CollisionError, Motion, Outcome, Rebound, RingImpactError, Warning,
};
use carom_laws::friction::Friction;

use crate::collide_options::CaromCollideOptions;
use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::pair::CaromMaterial;
use crate::pointers::{read, write};

/// A sphere: `sizes[0]` is its radius.
pub const CAROM_SHAPE_SPHERE: u32 = 0;
/// A plane with the half-space behind it, held fast; its axis c looks out of the body.
pub const CAROM_SHAPE_PLANE: u32 = 1;
/// An ellipsoid: `sizes` are its semi-axes.
pub const CAROM_SHAPE_ELLIPSOID: u32 = 2;
/// A cylinder about its axis c: radius and length.
pub const CAROM_SHAPE_CYLINDER: u32 = 3;
/// A cylinder between two half spheres, about its axis c: radius, and length of the straight part.
pub const CAROM_SHAPE_CAPSULE: u32 = 4;
/// A torus about its axis c: radius of the circle, radius of the tube.
pub const CAROM_SHAPE_TORUS: u32 = 5;
/// A box: `sizes` are its edges. Its edges and corners cannot touch.
pub const CAROM_SHAPE_BOX: u32 = 6;

/// The materials couple normal and tangential displacements, which the theory leaves out.
pub const CAROM_WARNING_COUPLING: u32 = 1;
/// The contact is not small against the bodies.
pub const CAROM_WARNING_LARGE_CONTACT: u32 = 2;
/// Elastic waves would carry away more than 1 % of the normal energy.
pub const CAROM_WARNING_WAVE_LOSS: u32 = 4;
/// The spin about the normal is left alone, and torsion would take more than 1 % of it.
pub const CAROM_WARNING_SPIN_LEFT_ALONE: u32 = 8;
/// The outcome did not settle to its tolerance.
pub const CAROM_WARNING_NOT_SETTLED: u32 = 16;
/// The contact point was found by sampling; the bodies may touch elsewhere too.
pub const CAROM_WARNING_POINT_SAMPLED: u32 = 32;

/// A body about to collide. All that is zero is what is usual: a solid, its axes along those of space,
/// at the origin, at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct CaromBody {
    /// A CAROM_SHAPE.
    pub shape: u32,
    /// 1 for a thin shell, 0 for a solid.
    pub hollow: u32,
    /// What the shape needs, m.
    pub sizes: [f64; 3],
    /// The mass, kg; infinite if it is held fast. Of no meaning for a plane.
    pub mass: f64,
    /// The principal moments of inertia, kg m^2; zeros are those of the homogeneous shape.
    pub moments: [f64; 3],
    /// The material.
    pub material: CaromMaterial,
    /// The centre of mass; for a plane any of its points, m.
    pub centre: [f64; 3],
    /// The unit quaternion (w, i, j, k) that turns the body's components into those of space; zeros for
    /// none.
    pub attitude: [f64; 4],
    /// The velocity of the centre of mass, m/s.
    pub velocity: [f64; 3],
    /// The angular velocity in space axes, rad/s.
    pub spin: [f64; 3],
}

/// How two bodies part. Velocities of the contact are of body 2 against body 1. The command's columns and
/// Python's record have the same names.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
#[allow(non_snake_case)] // R_x, as everywhere
pub struct CaromRebound {
    /// 1 if they collide; 0 if they do not approach each other, where nothing happens and only
    /// place, normal and motions are given.
    pub collides: u32,
    /// The CAROM_WARNING bits that hold.
    pub warnings: u32,
    /// The velocity of the centre of mass of body 1 afterwards, m/s.
    pub body_1_velocity: [f64; 3],
    /// The angular velocity of body 1 afterwards, rad/s.
    pub body_1_spin: [f64; 3],
    /// The velocity of the centre of mass of body 2 afterwards, m/s.
    pub body_2_velocity: [f64; 3],
    /// The angular velocity of body 2 afterwards, rad/s.
    pub body_2_spin: [f64; 3],
    /// The impulse that body 2 gave body 1, N s.
    pub impulse: [f64; 3],
    /// The place where they touch, m.
    pub point: [f64; 3],
    /// The normal there, from body 2 into body 1.
    pub normal: [f64; 3],
    /// The relative velocity of the contact points before, m/s.
    pub contact_velocity_before: [f64; 3],
    /// The relative velocity of the contact points after, m/s.
    pub contact_velocity_after: [f64; 3],
    /// The tangential velocity after over that before, reversed in sign, if `has_R_x`.
    pub R_x: f64,
    /// 1 if there is an R_x.
    pub has_R_x: u32,
    /// How often the approach grew.
    pub compressions: u32,
    /// The time from touch to separation, s.
    pub duration: f64,
    /// The greatest normal force, N.
    pub maximal_force: f64,
    /// The greatest approach, m.
    pub maximal_approach: f64,
    /// The semi-axis of the greatest contact ellipse along the contact's x, the smaller one, m.
    pub maximal_semi_axis_a: f64,
    /// The semi-axis of the greatest contact ellipse along the contact's y, m.
    pub maximal_semi_axis_b: f64,
    /// The kinetic energy before, J.
    pub energy_before: f64,
    /// The kinetic energy after, J.
    pub energy_after: f64,
    /// What friction took, J.
    pub energy_dissipated: f64,
    /// What the bodies' material took, J: 0 of elastic ones.
    pub energy_lost: f64,
    /// How far the velocity after may be off over that before; 0 where the solution is exact.
    pub error_estimate: f64,
    /// The relative spin about the normal after over that before, if `has_torsion`.
    pub spin_ratio: f64,
    /// The impulse of the torque on body 1 about the normal, N m s, if `has_torsion`.
    pub torque_impulse: f64,
    /// 1 if the spin about the normal was changed.
    pub has_torsion: u32,
}

/// The impact of two bodies that touch where they are, or, if `normal` is not null, of body 1 put on body
/// 2 with that common normal, from body 2 into body 1.
///
/// `options` is null for what is usual: elastic bodies, and the coupling of normal and tangential displacements of
/// dissimilar ones counts for spheres and planes, with it the spin about the normal.
///
/// # Safety
/// `body_1`, `body_2` and the three numbers of `normal` are null or may be read; `options` is null, or as many bytes
/// as its `size` says may be read; `rebound` and `error` are null or may be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_collide(
    body_1: *const CaromBody,
    body_2: *const CaromBody,
    friction: f64,
    normal: *const f64,
    options: *const CaromCollideOptions,
    rebound: *mut CaromRebound,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let collision = collision([body_1, body_2], friction, normal)?;
        let outcome = CaromCollideOptions::of(options)?.solve(collision.clone())?;
        *write(rebound, "rebound")? = told(&collision, &outcome);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// # Safety
/// The bodies and the three numbers of `normal` are null or may be read.
unsafe fn collision(
    [body_1, body_2]: [*const CaromBody; 2],
    friction: f64,
    normal: *const f64,
) -> Result<Collision, Failure> {
    // SAFETY: the caller's promise.
    let [one, two] = unsafe { [read(body_1, "body_1")?, read(body_2, "body_2")?] };
    let one = one.body().map_err(|failure| failure.at(0))?;
    let two = two.body().map_err(|failure| failure.at(1))?;
    let friction = Friction::new(friction)?;
    if normal.is_null() {
        return Ok(Collision::touching(one, two, friction)?);
    }
    // SAFETY: the caller's promise.
    let normal = unsafe { *read(normal.cast::<[f64; 3]>(), "normal")? };
    Ok(Collision::along(one, two, normal, friction)?)
}

impl CaromBody {
    fn body(&self) -> Result<Body, Failure> {
        let surface = self.surface()?;
        let inertia = self.inertia(&surface)?;
        let mut body = Body::new(surface, self.material.material()?, inertia)
            .at(self.centre)?
            .moving(Motion::new(self.velocity, self.spin)?);
        if self.attitude != [0.0; 4] {
            body = body.turned(Attitude::from_quaternion(self.attitude)?);
        }
        Ok(body)
    }

    fn surface(&self) -> Result<Surface, Failure> {
        let [a, b, _] = self.sizes;
        Ok(match self.shape {
            CAROM_SHAPE_SPHERE => Surface::sphere(a)?,
            CAROM_SHAPE_PLANE => Surface::plane(),
            CAROM_SHAPE_ELLIPSOID => Surface::ellipsoid(self.sizes)?,
            CAROM_SHAPE_CYLINDER => Surface::cylinder(a, b)?,
            CAROM_SHAPE_CAPSULE => Surface::capsule(a, b)?,
            CAROM_SHAPE_TORUS => Surface::torus(a, b)?,
            CAROM_SHAPE_BOX => Surface::cuboid(self.sizes)?,
            shape => {
                let text = format_args!("shape = {shape} is no CAROM_SHAPE: must be 0 to 6");
                return Err(Failure::new(CaromStatus::OutOfRange, "shape", text));
            }
        })
    }

    fn inertia(&self, surface: &Surface) -> Result<Inertia, Failure> {
        if self.shape == CAROM_SHAPE_PLANE || self.mass == f64::INFINITY {
            return Ok(Inertia::FIXED);
        }
        if self.moments != [0.0; 3] {
            return Ok(Inertia::new(self.mass, self.moments)?);
        }
        let inertia =
            if self.hollow == 0 { surface.solid(self.mass) } else { surface.shell(self.mass) };
        inertia.map_err(|error| match error {
            SurfaceError::Range(error) => error.into(),
            error => Failure::new(CaromStatus::OutOfRange, "moments", error),
        })
    }
}

fn told(collision: &Collision, outcome: &Outcome) -> CaromRebound {
    let [one, two] = outcome.motions();
    let known = CaromRebound {
        body_1_velocity: one.velocity.into(),
        body_1_spin: one.spin.into(),
        body_2_velocity: two.velocity.into(),
        body_2_spin: two.spin.into(),
        point: collision.point().into(),
        normal: collision.frame().z().into(),
        ..CaromRebound::default()
    };
    match outcome {
        Outcome::NoImpact { .. } => known,
        Outcome::Rebound(rebound) => with_rebound(known, rebound),
    }
}

fn with_rebound(known: CaromRebound, rebound: &Rebound) -> CaromRebound {
    let ellipse = rebound.maximal_contact;
    CaromRebound {
        collides: 1,
        warnings: rebound.warnings.iter().map(bit).fold(0, |all, one| all | one),
        impulse: rebound.impulse.into(),
        contact_velocity_before: rebound.contact_velocity_before.into(),
        contact_velocity_after: rebound.contact_velocity_after.into(),
        R_x: rebound.r_x.unwrap_or(0.0),
        has_R_x: rebound.r_x.is_some().into(),
        compressions: rebound.compressions,
        duration: rebound.duration,
        maximal_force: rebound.maximal_force,
        maximal_approach: rebound.maximal_approach,
        maximal_semi_axis_a: ellipse.semi_axis_a(),
        maximal_semi_axis_b: ellipse.semi_axis_b(),
        energy_before: rebound.energy.before,
        energy_after: rebound.energy.after,
        energy_dissipated: rebound.energy.dissipated,
        energy_lost: rebound.energy.lost,
        error_estimate: rebound.error_estimate,
        spin_ratio: rebound.torsion.map_or(0.0, |torsion| torsion.spin_ratio),
        torque_impulse: rebound.torsion.map_or(0.0, |torsion| torsion.torque_impulse),
        has_torsion: rebound.torsion.is_some().into(),
        ..known
    }
}

fn bit(warning: &Warning) -> u32 {
    match warning {
        Warning::Coupling { .. } => CAROM_WARNING_COUPLING,
        Warning::LargeContact { .. } => CAROM_WARNING_LARGE_CONTACT,
        Warning::WaveLoss { .. } => CAROM_WARNING_WAVE_LOSS,
        Warning::SpinLeftAlone { .. } => CAROM_WARNING_SPIN_LEFT_ALONE,
        Warning::NotSettled { .. } => CAROM_WARNING_NOT_SETTLED,
        Warning::PointSampled => CAROM_WARNING_POINT_SAMPLED,
    }
}

impl From<RingImpactError> for Failure {
    fn from(error: RingImpactError) -> Self {
        match error {
            RingImpactError::Range(error) => error.into(),
            RingImpactError::Collision(error) => error.into(),
            error @ RingImpactError::NoSeparation => Self::new(CaromStatus::NotFollowed, "", error),
        }
    }
}

impl From<SurfaceError> for Failure {
    fn from(error: SurfaceError) -> Self {
        match error {
            SurfaceError::Range(error) => error.into(),
            error => Self::new(CaromStatus::NoContact, "", error),
        }
    }
}

impl From<CollisionError> for Failure {
    fn from(error: CollisionError) -> Self {
        match error {
            CollisionError::Range(error) => error.into(),
            CollisionError::Search(error) => Self::new(CaromStatus::NoContact, "", error),
            CollisionError::BothHeldFast => Self::new(CaromStatus::OutOfRange, "mass", error),
            error => Self::new(CaromStatus::NotFollowed, "", error),
        }
    }
}
