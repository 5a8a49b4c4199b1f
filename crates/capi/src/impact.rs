//! The impact of two bodies.

use carom_geometry::{Attitude, Inertia, Surface, SurfaceError};
use carom_impact::{Body, Collision, CollisionError, Motion, Outcome, Rebound, RingImpactError};

use crate::collide_options::CaromCollideOptions;
use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::material::CaromMaterial;
use crate::pointers::{read, write};
use crate::sized::SizedOptions as _;
use crate::validity::bits;

/// A sphere: `sizes[0]` is its radius.
pub const CAROM_SHAPE_SPHERE: u32 = 0;
/// A fixed plane bounding a half-space; its axis c is the outward normal.
pub const CAROM_SHAPE_PLANE: u32 = 1;
/// An ellipsoid: `sizes` are its semi-axes.
pub const CAROM_SHAPE_ELLIPSOID: u32 = 2;
/// A cylinder about its axis c: radius and length.
pub const CAROM_SHAPE_CYLINDER: u32 = 3;
/// A cylinder between two half spheres, about its axis c: radius, and length of the straight part.
pub const CAROM_SHAPE_CAPSULE: u32 = 4;
/// A torus about its axis c: radius of the centre circle, radius of the tube.
pub const CAROM_SHAPE_TORUS: u32 = 5;
/// A box: `sizes` are its edge lengths. Contact at its edges and corners is not computed.
pub const CAROM_SHAPE_BOX: u32 = 6;

/// A body before a collision. Zero fields take the defaults: a solid at the origin, at rest, its axes along
/// those of space.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct CaromBody {
    /// The shape, a CAROM_SHAPE constant.
    pub shape: u32,
    /// 1 for a thin shell, 0 for a solid.
    pub hollow: u32,
    /// The dimensions of the shape, m; see the CAROM_SHAPE constants.
    pub sizes: [f64; 3],
    /// The mass, kg; infinite for a fixed body. Ignored for a plane.
    pub mass: f64,
    /// The principal moments of inertia, kg m^2; zeros for those of a homogeneous body.
    pub moments: [f64; 3],
    /// The material.
    pub material: CaromMaterial,
    /// The centre of mass, m; for a plane any of its points.
    pub centre: [f64; 3],
    /// The unit quaternion (w, i, j, k) that transforms components in body axes to space axes; zeros for no
    /// rotation.
    pub attitude: [f64; 4],
    /// The velocity of the centre of mass, m/s.
    pub velocity: [f64; 3],
    /// The angular velocity in space axes, rad/s.
    pub spin: [f64; 3],
}

/// The result of an impact. Relative velocities at the contact are of body 2 against body 1. Columns of the
/// command `carom` and fields of Python's `Rebound` have the same names.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
#[allow(non_snake_case)] // R_x, as everywhere
pub struct CaromRebound {
    /// 1 if the bodies collide. 0 if they do not approach each other: then only point, normal and motions are
    /// given.
    pub collides: u32,
    /// The CAROM_WARNING bits that apply.
    pub warnings: u32,
    /// The velocity of the centre of mass of body 1 after the impact, m/s.
    pub body_1_velocity: [f64; 3],
    /// The angular velocity of body 1 after the impact, rad/s.
    pub body_1_spin: [f64; 3],
    /// The velocity of the centre of mass of body 2 after the impact, m/s.
    pub body_2_velocity: [f64; 3],
    /// The angular velocity of body 2 after the impact, rad/s.
    pub body_2_spin: [f64; 3],
    /// The impulse that body 2 exerts on body 1, N s.
    pub impulse: [f64; 3],
    /// The contact point, m.
    pub point: [f64; 3],
    /// The unit normal at the contact point, from body 2 into body 1.
    pub normal: [f64; 3],
    /// The relative velocity of the contact points before the impact, m/s.
    pub contact_velocity_before: [f64; 3],
    /// The relative velocity of the contact points after the impact, m/s.
    pub contact_velocity_after: [f64; 3],
    /// Minus the tangential velocity of the contact after the impact over that before; valid if `has_R_x` is
    /// 1.
    pub R_x: f64,
    /// 1 if R_x is defined.
    pub has_R_x: u32,
    /// Number of compression phases, each a maximum of the approach.
    pub compressions: u32,
    /// The time from first contact to separation, s.
    pub duration: f64,
    /// The maximum normal force, N.
    pub maximal_force: f64,
    /// The maximum approach, m.
    pub maximal_approach: f64,
    /// The semi-axis of the largest contact ellipse along x of the contact, the smaller one, m.
    pub maximal_semi_axis_a: f64,
    /// The semi-axis of the largest contact ellipse along y of the contact, m.
    pub maximal_semi_axis_b: f64,
    /// The kinetic energy before the impact, J.
    pub energy_before: f64,
    /// The kinetic energy after the impact, J.
    pub energy_after: f64,
    /// The energy dissipated by friction, J.
    pub energy_dissipated: f64,
    /// The energy dissipated in the material of the bodies, J; 0 for elastic bodies.
    pub energy_lost: f64,
    /// Estimated error of the velocity after the impact over that before; 0 for an exact solution.
    pub error_estimate: f64,
    /// How far R_x may be off by another cause of the loss along the normal; 0 for elastic bodies and a given cause.
    pub model_uncertainty: f64,
    /// The relative spin about the normal after the impact over that before; valid if `has_torsion` is 1.
    pub spin_ratio: f64,
    /// The angular impulse on body 1 about the normal, N m s; valid if `has_torsion` is 1.
    pub torque_impulse: f64,
    /// 1 if friction was applied to the spin about the normal.
    pub has_torsion: u32,
}

/// Computes the impact of two bodies that touch at their given positions. If `normal` is not null, body 1 is
/// first moved into contact with body 2 such that this is the common normal, from body 2 into body 1.
///
/// `options` may be null for the defaults: elastic bodies; for spheres and planes the coupling of normal and
/// tangential displacements of dissimilar materials counts where it matters, and with it the spin about the
/// normal.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `normal` must be null or have three numbers. `options` must be null or have as many bytes as its `size`
/// says.
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
        let options = CaromCollideOptions::of(options)?;
        let collision = collision([body_1, body_2], (friction, &options), normal)?;
        let outcome = options.solve(collision.clone())?;
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
    (friction, options): (f64, &CaromCollideOptions),
    normal: *const f64,
) -> Result<Collision, Failure> {
    // SAFETY: the caller's promise.
    let [one, two] = unsafe { [read(body_1, "body_1")?, read(body_2, "body_2")?] };
    let one = one.body().map_err(|failure| failure.at(0))?;
    let two = two.body().map_err(|failure| failure.at(1))?;
    let friction = options.friction(friction)?;
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
                let text = format_args!("shape = {shape} is not a CAROM_SHAPE: must be 0 to 6");
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
        warnings: bits(rebound),
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
        model_uncertainty: rebound.model_uncertainty,
        spin_ratio: rebound.torsion.map_or(0.0, |torsion| torsion.spin_ratio),
        torque_impulse: rebound.torsion.map_or(0.0, |torsion| torsion.torque_impulse),
        has_torsion: rebound.torsion.is_some().into(),
        ..known
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
