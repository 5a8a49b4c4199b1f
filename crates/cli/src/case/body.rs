//! A body of a case: `[body_1]`, `[body_2]` and `[ball]`.

use super::error::CaseError;
use super::range::Range;
use super::section::{Section, Words};
use super::unit::Dimension;
use carom_geometry::curvature::PrincipalRadii;
use carom_geometry::{Attitude, Inertia, Surface, SurfaceError};
use carom_halfspace::Material;
use carom_impact::{Body, Motion};
use carom_special::RangeError;

/// Fields of every body beside its shape.
const COMMON: [&str; 10] = [
    "material",
    "density",
    "mass",
    "fixed",
    "inertia",
    "position",
    "quaternion",
    "angles",
    "velocity",
    "spin",
];
/// Shapes with their own fields.
const SHAPES: [(&str, &[&str]); 9] = [
    ("sphere", &["radius"]),
    ("ellipsoid", &["semi_axes"]),
    ("cylinder", &["radius", "length"]),
    ("capsule", &["radius", "length"]),
    ("torus", &["radius", "tube_radius"]),
    ("box", &["edges"]),
    ("plane", &["normal"]),
    ("half-space", &["normal"]),
    ("given", &["radii", "point", "normal", "direction"]),
];
/// The same as words.
pub(super) const WORDS: Words = Words {
    words: &[
        "sphere",
        "ellipsoid",
        "cylinder",
        "capsule",
        "torus",
        "box",
        "plane",
        "half-space",
        "given",
    ],
    allowed: "\"sphere\", \"ellipsoid\", \"cylinder\", \"capsule\", \"torus\", \"box\", \"plane\", \
              \"half-space\" or \"given\"",
};
const MATERIAL_FIELDS: &[&str] = &["young_modulus", "shear_modulus", "poisson", "rigid"];
const MASS: &str = "given as `mass`, as `density` of a shape with a volume, or as `fixed = true`";
const INERTIA: &str = "\"solid\", \"shell\" or three moments about the body's axes, each > 0 (inf: \
                       does not turn)";
const RADII: [&str; 2] = ["first", "second"];

/// A body as a case file describes it.
#[derive(Debug, Clone)]
pub(super) struct BodyCase {
    /// At its `position`, or at the origin.
    pub(super) body: Body,
    /// The only point at which its surface is known, in its axes.
    pub(super) point: Option<[f64; 3]>,
    pub(super) is_plane: bool,
    pub(super) has_position: bool,
}

/// Whether the file must give a velocity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Velocity {
    /// By `velocity`.
    Own,
    /// By `[approach]` instead.
    Approach,
}

impl BodyCase {
    /// Reads the body in table `name`.
    pub(super) fn read(
        case: &Section<'_>,
        name: &str,
        velocity: Velocity,
    ) -> Result<Self, CaseError> {
        let body = &section(case, name)?;
        let shape = body.word("shape", WORDS)?;
        let is_plane = matches!(shape, "plane" | "half-space");
        let point = match shape {
            "given" => Some(body.vector("point", Range::Finite.of(Dimension::Length))?),
            _ => None,
        };
        let surface = read_surface(body, shape, point)?;
        let material = read_material(body)?;
        let inertia = read_inertia(body, shape, &surface)?;
        let motion = read_motion(body, velocity)?;
        // A plane above faces down unless the file says otherwise.
        let above = || (is_plane && name == "body_1").then_some([0.0, 0.0, -1.0]);
        let attitude = match (read_attitude(body, is_plane)?, above()) {
            (Some(attitude), _) => attitude,
            (None, Some(down)) => Attitude::facing(down)
                .map_err(|error| body.out_of_range("normal", error.value, error.allowed))?,
            (None, None) => Attitude::ALIGNED,
        };
        let made = Body::new(surface, material, inertia).turned(attitude).moving(motion);
        let has_position = body.has("position");
        Ok(Self {
            body: if has_position { place(body, made)? } else { made },
            point,
            is_plane,
            has_position,
        })
    }

    pub(super) fn is_heavy(&self) -> bool {
        self.body.inertia().mass().is_infinite()
    }
}

/// The body's table, which takes the fields of its shape; those of all shapes where that is
/// missing or unknown.
fn section<'a>(case: &Section<'a>, name: &str) -> Result<Section<'a>, CaseError> {
    let shape = case.word(&format!("{name}.shape"), WORDS);
    let own = SHAPES.iter().filter(|(word, _)| shape.as_ref().map_or(true, |shape| word == shape));
    let mut fields: Vec<&'static str> = vec!["shape"];
    for field in own.flat_map(|(_, fields)| fields.iter()).chain(&COMMON) {
        if !fields.contains(field) {
            fields.push(field);
        }
    }
    let section = case.section(name, &fields)?;
    shape.map(|_| section)
}

fn read_surface(
    body: &Section<'_>,
    shape: &str,
    point: Option<[f64; 3]>,
) -> Result<Surface, CaseError> {
    let number = |name: &str| body.number(name, Range::Positive.of(Dimension::Length));
    let at = |name: &'static str| {
        move |error: RangeError| body.out_of_range(name, error.value, error.allowed)
    };
    match shape {
        "sphere" => Surface::sphere(number("radius")?).map_err(at("radius")),
        "ellipsoid" => {
            Surface::ellipsoid(body.vector("semi_axes", Range::Positive.of(Dimension::Length))?)
                .map_err(at("semi_axes"))
        }
        "cylinder" => Surface::cylinder(number("radius")?, number("length")?).map_err(at("length")),
        "capsule" => Surface::capsule(number("radius")?, number("length")?).map_err(at("length")),
        "torus" => Surface::torus(number("radius")?, number("tube_radius")?)
            .map_err(|error| body.out_of_range("tube_radius", error.value, "< `radius`")),
        "box" => Surface::cuboid(body.vector("edges", Range::Positive.of(Dimension::Length))?)
            .map_err(at("edges")),
        "given" => {
            let radii = body.array(
                "radii",
                RADII,
                Range::Radius.of(Dimension::Length),
                "two principal radii",
            )?;
            let radii = PrincipalRadii::new(radii[0], radii[1]).map_err(at("radii"))?;
            let normal = read_direction(body, "normal")?;
            let direction = read_direction(body, "direction")?;
            Surface::given(point.unwrap_or_default(), normal, direction, radii)
                .map_err(at("direction"))
        }
        _ => Ok(Surface::plane()),
    }
}

fn read_direction(body: &Section<'_>, name: &str) -> Result<[f64; 3], CaseError> {
    let vector = body.vector(name, Range::Finite)?;
    let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length.is_finite() && length > 0.0 {
        return Ok(vector);
    }
    Err(body.out_of_range(name, length, "a vector of finite length > 0"))
}

fn read_inertia(body: &Section<'_>, shape: &str, surface: &Surface) -> Result<Inertia, CaseError> {
    let given: Vec<&str> =
        ["mass", "density", "fixed"].into_iter().filter(|name| body.has(name)).collect();
    if let [one, other, ..] = given.as_slice() {
        return Err(body.conflict(other, one, "give one of them"));
    }
    if body.switch("fixed")? {
        return match body.has("inertia") {
            true => Err(body.conflict("inertia", "fixed", "a fixed body does not turn")),
            false => Ok(Inertia::FIXED),
        };
    }
    let mass = match body.has("density") {
        true => read_density(body, surface)?,
        false if body.has("mass") => {
            body.number("mass", Range::PositiveOrInfinite.of(Dimension::Mass))?
        }
        false => return Err(body.missing("mass", MASS)),
    };
    let field = if body.has("density") { "density" } else { "mass" };
    let of_shape = |made: Result<Inertia, SurfaceError>| {
        made.map_err(|error| match error {
            SurfaceError::Range(error) => body.out_of_range(field, mass, error.allowed),
            _ => body.missing("inertia", "three moments: this shape has no inertia of its own"),
        })
    };
    if body.is_list("inertia") {
        let moments = body.vector("inertia", Range::PositiveOrInfinite.of(Dimension::Inertia))?;
        return Inertia::new(mass, moments)
            .map_err(|error| body.out_of_range("inertia", error.value, error.allowed));
    }
    let kind = match body.has("inertia") {
        true => body.word("inertia", Words { words: &["solid", "shell"], allowed: INERTIA })?,
        false => "solid",
    };
    match kind {
        // A plane is guided: it gives way, but does not turn.
        "solid" if matches!(shape, "plane" | "half-space") => {
            of_shape(Inertia::new(mass, [f64::INFINITY; 3]).map_err(Into::into))
        }
        "shell" if field == "density" => {
            Err(body.conflict("density", "inertia", "a thin shell has no thickness; give its mass"))
        }
        "shell" => of_shape(surface.shell(mass)),
        _ => of_shape(surface.solid(mass)),
    }
}

fn read_density(body: &Section<'_>, surface: &Surface) -> Result<f64, CaseError> {
    let density = body.number("density", Range::Positive.of(Dimension::Density))?;
    let Some(volume) = surface.volume() else {
        return Err(body.conflict("density", "shape", "it has no volume; give its `mass`"));
    };
    let mass = density * volume;
    if mass.is_finite() && mass > 0.0 {
        return Ok(mass);
    }
    Err(body.out_of_range("density", density, "such that the mass is finite and > 0"))
}

fn read_motion(body: &Section<'_>, velocity: Velocity) -> Result<Motion, CaseError> {
    if body.switch("fixed")? {
        let moving = ["velocity", "spin"].into_iter().find(|name| body.has(name));
        let reason = "a fixed body is at rest; a moving one of infinite mass has `mass = inf`";
        return match moving {
            Some(name) => Err(body.conflict(name, "fixed", reason)),
            None => Ok(Motion::default()),
        };
    }
    let velocity = match velocity {
        Velocity::Own => body.vector("velocity", Range::Speed.of(Dimension::Speed))?,
        Velocity::Approach if body.has("velocity") => {
            let reason = "[approach] gives the velocity of body 1";
            return Err(body.conflict("velocity", "approach", reason));
        }
        Velocity::Approach => [0.0; 3],
    };
    let spin = body.vector("spin", Range::Speed.of(Dimension::Spin))?;
    Motion::new(velocity, spin)
        .map_err(|error| body.out_of_range(error.field, error.value, error.allowed))
}

fn place(body: &Section<'_>, made: Body) -> Result<Body, CaseError> {
    let position = body.vector("position", Range::Finite.of(Dimension::Length))?;
    made.at(position).map_err(|error| body.out_of_range("position", error.value, error.allowed))
}

/// None if the file says nothing of it.
fn read_attitude(body: &Section<'_>, is_plane: bool) -> Result<Option<Attitude>, CaseError> {
    let mut ways = vec!["quaternion", "angles"];
    if is_plane {
        ways.push("normal");
    }
    let given: Vec<&str> = ways.into_iter().filter(|name| body.has(name)).collect();
    let at = |name: &'static str| {
        move |error: RangeError| body.out_of_range(name, error.value, error.allowed)
    };
    let read = match given.as_slice() {
        [] => return Ok(None),
        ["quaternion"] => {
            let allowed = "a unit quaternion [w, i, j, k]";
            let parts = body.array("quaternion", ["w", "i", "j", "k"], Range::Finite, allowed)?;
            Attitude::from_quaternion(parts).map_err(|error| {
                body.out_of_range("quaternion", error.value, "of norm 1 to within 1e-6")
            })
        }
        ["angles"] => {
            let names = ["alpha", "beta", "gamma"];
            let allowed = "three angles [alpha, beta, gamma] in degrees";
            let [alpha, beta, gamma] = body
                .array("angles", names, Range::Finite.of(Dimension::Degrees), allowed)?
                .map(f64::to_radians);
            Attitude::from_angles(alpha, beta, gamma).map_err(at("angles"))
        }
        ["normal"] => Attitude::facing(read_direction(body, "normal")?).map_err(at("normal")),
        [one, .., other] => Err(body.conflict(other, one, "give one of them")),
        [_] => return Ok(None),
    };
    read.map(Some)
}

pub(super) fn read_material(body: &Section<'_>) -> Result<Material, CaseError> {
    let material = body.section("material", MATERIAL_FIELDS)?;
    if material.switch("rigid")? {
        let others = ["young_modulus", "shear_modulus", "poisson"];
        return match others.into_iter().find(|name| material.has(name)) {
            Some(name) => {
                Err(material.conflict(name, "rigid", "a rigid body has no elastic constants"))
            }
            None => Ok(Material::RIGID),
        };
    }
    if material.has("shear_modulus") && material.has("young_modulus") {
        let reason = "give one of the two";
        return Err(material.conflict("shear_modulus", "young_modulus", reason));
    }
    let poisson = |material: &Section<'_>| material.number("poisson", Range::Poisson);
    let made = if material.has("shear_modulus") {
        let modulus = material.number("shear_modulus", Range::Positive.of(Dimension::Pressure))?;
        Material::from_shear(modulus, poisson(&material)?)
    } else if material.has("young_modulus") {
        let modulus = material.number("young_modulus", Range::Positive.of(Dimension::Pressure))?;
        Material::from_young(modulus, poisson(&material)?)
    } else {
        let allowed = "finite and > 0 (or `shear_modulus`, or `rigid = true`)";
        return Err(material.missing("young_modulus", allowed));
    };
    made.map_err(|RangeError { field, value, allowed }| {
        material.out_of_range(field, value, allowed)
    })
}
