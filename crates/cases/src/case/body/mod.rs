//! A body of a case: `[body_1]`, `[body_2]` and `[ball]`.

mod fields;

pub(super) use fields::{
    BALL, BODY_1, BODY_2, FIXED, INERTIA, MASS, POINT as KNOWN_POINT, POSITION, RADII, VELOCITY,
};

use super::error::CaseError;
use super::field::Field;
use super::material;
use super::section::Section;
use super::shape::{
    BOX, CAPSULE, CYLINDER, ELLIPSOID, GIVEN, HALF_SPACE, PLANE, SHAPE, SPHERE, TORUS,
};
use carom_geometry::curvature::PrincipalRadii;
use carom_geometry::{Attitude, Inertia, Surface, SurfaceError};
use carom_impact::{Body, Motion};
use carom_special::RangeError;
use fields::{
    ANGLES, DENSITY, DIRECTION, EDGES, LENGTH, NORMAL, OUTWARD, QUATERNION, RADIUS, SEMI_AXES,
    SHELL, SOLID, SPIN, TUBE,
};

/// A body as a case file describes it.
#[derive(Debug, Clone)]
pub(super) struct BodyCase {
    /// The body at its `position`, or at the origin.
    pub(super) body: Body,
    /// For shape "given": the point at which its curvatures are known, in body axes.
    pub(super) point: Option<[f64; 3]>,
    pub(super) is_plane: bool,
    pub(super) has_position: bool,
}

/// Which field gives the velocity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Velocity {
    /// `velocity` of the body.
    Own,
    /// The table `[approach]`.
    Approach,
}

impl BodyCase {
    /// Reads the body in table `field`.
    pub(super) fn read(
        case: &Section<'_>,
        field: &Field,
        velocity: Velocity,
    ) -> Result<Self, CaseError> {
        let (body, shape) = &case.shaped(field, &SHAPE)?;
        let is_plane = matches!(*shape, PLANE | HALF_SPACE);
        let point = if *shape == GIVEN { Some(body.vector(&KNOWN_POINT)?) } else { None };
        let surface = read_surface(body, shape, point)?;
        let material = material::read(body)?;
        let inertia = read_inertia(body, is_plane, &surface)?;
        let motion = read_motion(body, velocity)?;
        // The plane of body 1 faces down unless the file gives a normal.
        let above = || (is_plane && field.name == BODY_1.name).then_some([0.0, 0.0, -1.0]);
        let attitude = match (read_attitude(body, is_plane)?, above()) {
            (Some(attitude), _) => attitude,
            (None, Some(down)) => Attitude::facing(down).map_err(at(body, &NORMAL))?,
            (None, None) => Attitude::ALIGNED,
        };
        let made = Body::new(surface, material, inertia).turned(attitude).moving(motion);
        let has_position = body.has(&POSITION);
        let body = match has_position {
            true => made.at(body.vector(&POSITION)?).map_err(at(body, &POSITION))?,
            false => made,
        };
        Ok(Self { body, point, is_plane, has_position })
    }

    pub(super) fn is_heavy(&self) -> bool {
        self.body.inertia().mass().is_infinite()
    }
}

/// Reports a value that the library rejects at the field that gave it.
fn at<'a>(body: &'a Section<'_>, field: &'static Field) -> impl Fn(RangeError) -> CaseError + 'a {
    move |error| body.out_of_range(field, error.value, error.allowed)
}

fn read_surface(
    body: &Section<'_>,
    shape: &str,
    point: Option<[f64; 3]>,
) -> Result<Surface, CaseError> {
    let number = |field| body.number(field);
    match shape {
        SPHERE => Surface::sphere(number(&RADIUS)?).map_err(at(body, &RADIUS)),
        ELLIPSOID => Surface::ellipsoid(body.vector(&SEMI_AXES)?).map_err(at(body, &SEMI_AXES)),
        CYLINDER => {
            Surface::cylinder(number(&RADIUS)?, number(&LENGTH)?).map_err(at(body, &LENGTH))
        }
        CAPSULE => Surface::capsule(number(&RADIUS)?, number(&LENGTH)?).map_err(at(body, &LENGTH)),
        TORUS => Surface::torus(number(&RADIUS)?, number(&TUBE)?)
            .map_err(|error| body.out_of_range(&TUBE, error.value, "< `radius`")),
        BOX => Surface::cuboid(body.vector(&EDGES)?).map_err(at(body, &EDGES)),
        GIVEN => {
            let [first, second] = body.vector(&RADII)?;
            let radii = PrincipalRadii::new(first, second).map_err(at(body, &RADII))?;
            let (normal, direction) =
                (read_direction(body, &OUTWARD)?, read_direction(body, &DIRECTION)?);
            Surface::given(point.unwrap_or_default(), normal, direction, radii)
                .map_err(at(body, &DIRECTION))
        }
        _ => Ok(Surface::plane()),
    }
}

fn read_direction(body: &Section<'_>, field: &'static Field) -> Result<[f64; 3], CaseError> {
    let vector: [f64; 3] = body.vector(field)?;
    let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length.is_finite() && length > 0.0 {
        return Ok(vector);
    }
    Err(body.out_of_range(field, length, "a vector of finite length > 0"))
}

fn read_inertia(
    body: &Section<'_>,
    is_plane: bool,
    surface: &Surface,
) -> Result<Inertia, CaseError> {
    let given = body.given([&MASS, &DENSITY, &FIXED]);
    if given.len() > 1 {
        return Err(body.several(&given, "give one of them"));
    }
    if body.switch(&FIXED)? {
        return match body.has(&INERTIA) {
            true => Err(body.conflict(&INERTIA, &FIXED, "a fixed body does not turn")),
            false => Ok(Inertia::FIXED),
        };
    }
    let (mass, field) = match body.has(&DENSITY) {
        true => (read_density(body, surface)?, &DENSITY),
        false => (body.number(&MASS)?, &MASS),
    };
    let of_shape = |made: Result<Inertia, SurfaceError>| {
        made.map_err(|error| match error {
            SurfaceError::Range(error) => body.out_of_range(field, mass, error.allowed),
            _ => body.missing_as(&INERTIA, "three moments: this shape has no inertia of its own"),
        })
    };
    if body.is_list(&INERTIA) {
        return Inertia::new(mass, body.vector(&INERTIA)?).map_err(at(body, &INERTIA));
    }
    match body.word(&INERTIA)? {
        // A plane with a mass moves, but does not rotate.
        SOLID if is_plane => of_shape(Inertia::new(mass, [f64::INFINITY; 3]).map_err(Into::into)),
        SHELL if body.has(&DENSITY) => {
            let reason = "a thin shell has no thickness; give its mass";
            Err(body.conflict(&DENSITY, &INERTIA, reason))
        }
        SHELL => of_shape(surface.shell(mass)),
        _ => of_shape(surface.solid(mass)),
    }
}

fn read_density(body: &Section<'_>, surface: &Surface) -> Result<f64, CaseError> {
    let density = body.number(&DENSITY)?;
    let Some(volume) = surface.volume() else {
        return Err(body.conflict(&DENSITY, &SHAPE, "it has no volume; give its `mass`"));
    };
    let mass = density * volume;
    if mass.is_finite() && mass > 0.0 {
        return Ok(mass);
    }
    Err(body.out_of_range(&DENSITY, density, "such that the mass is finite and > 0"))
}

fn read_motion(body: &Section<'_>, velocity: Velocity) -> Result<Motion, CaseError> {
    if body.switch(&FIXED)? {
        let reason = "a fixed body is at rest; a moving one of infinite mass has `mass = inf`";
        return match body.given([&VELOCITY, &SPIN]).first() {
            Some(field) => Err(body.conflict(*field, &FIXED, reason)),
            None => Ok(Motion::default()),
        };
    }
    let velocity = match velocity {
        Velocity::Own => vector_or_zero(body, &VELOCITY)?,
        Velocity::Approach if body.has(&VELOCITY) => {
            let reason = "[approach] gives the velocity of body 1";
            return Err(body.excluded(&VELOCITY, "approach".to_owned(), reason));
        }
        Velocity::Approach => [0.0; 3],
    };
    let field = if body.has(&VELOCITY) { &VELOCITY } else { &SPIN };
    Motion::new(velocity, vector_or_zero(body, &SPIN)?).map_err(at(body, field))
}

fn vector_or_zero(body: &Section<'_>, field: &Field) -> Result<[f64; 3], CaseError> {
    if body.has(field) { body.vector(field) } else { Ok([0.0; 3]) }
}

/// The attitude; None if the file does not give it.
fn read_attitude(body: &Section<'_>, is_plane: bool) -> Result<Option<Attitude>, CaseError> {
    let mut given = body.given([&QUATERNION, &ANGLES]);
    given.extend(body.given([&NORMAL]).into_iter().filter(|_| is_plane));
    let read = match given.as_slice() {
        [] => return Ok(None),
        [field] if field.name == QUATERNION.name => {
            Attitude::from_quaternion(body.vector(&QUATERNION)?).map_err(|error| {
                body.out_of_range(
                    &QUATERNION,
                    error.value,
                    "of norm 1 to within 1e-6, and this is its norm",
                )
            })
        }
        [field] if field.name == ANGLES.name => {
            let [alpha, beta, gamma] = body.vector(&ANGLES)?.map(f64::to_radians);
            Attitude::from_angles(alpha, beta, gamma).map_err(at(body, &ANGLES))
        }
        [_] => Attitude::facing(read_direction(body, &NORMAL)?).map_err(at(body, &NORMAL)),
        several => Err(body.several(several, "give one of them")),
    };
    read.map(Some)
}
