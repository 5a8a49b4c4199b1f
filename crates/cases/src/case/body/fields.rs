//! The fields of `[body_1]`, `[body_2]` and `[ball]`.

use crate::case::field::{AXES, Default, Field, Form, Usual};
use crate::case::material::{MATERIAL, YIELDING};
use crate::case::range::Range;
use crate::case::shape::{
    BOX, CAPSULE, CYLINDER, ELLIPSOID, GIVEN, HALF_SPACE, PLANE, SHAPE, SPHERE, TORUS,
};
use crate::case::unit::{Dimension, Measure};

pub(super) const SOLID: &str = "solid";
pub(super) const SHELL: &str = "shell";

const LENGTH_ABOVE_0: Measure = Range::Positive.of(Dimension::Length);
const PLACE: Measure = Range::Finite.of(Dimension::Length);

pub(super) const RADIUS: Field =
    Field::number("radius", LENGTH_ABOVE_0, "radius; for a torus that of its centre circle")
        .of(&[SPHERE, CYLINDER, CAPSULE, TORUS])
        .such_as("0.01")
        .usually(Usual::RADIUS);
pub(super) const LENGTH: Field =
    Field::number("length", LENGTH_ABOVE_0, "length of the straight part along axis c")
        .of(&[CYLINDER, CAPSULE])
        .such_as("0.05");
pub(super) const TUBE: Field =
    Field::number("tube_radius", LENGTH_ABOVE_0, "radius of the tube, less than `radius`")
        .of(&[TORUS])
        .such_as("0.004");
pub(super) const SEMI_AXES: Field =
    Field::vector("semi_axes", LENGTH_ABOVE_0, "semi-axes along the axes a, b, c of the body")
        .of(&[ELLIPSOID])
        .such_as("[0.02, 0.015, 0.01]");
pub(super) const EDGES: Field =
    Field::vector("edges", LENGTH_ABOVE_0, "edge lengths along the axes a, b, c of the body")
        .of(&[BOX])
        .such_as("[0.03, 0.02, 0.02]");
pub(in crate::case) const RADII: Field = Field::new(
    "radii",
    Form::Vector(
        &["first", "second"],
        Range::Radius.of(Dimension::Length),
        "two principal radii [along `direction`, across]",
    ),
    "principal radii of curvature at the point",
)
.of(&[GIVEN])
.such_as("[0.01, 0.02]");
pub(in crate::case) const POINT: Field = Field::vector(
    "point",
    PLACE,
    "the point at which the curvatures are given, in axes of the body",
)
.of(&[GIVEN])
.such_as("[0, 0, -0.01]");
pub(super) const NORMAL: Field =
    Field::vector("normal", Range::Finite.pure(), "outward normal (need not be of unit length)")
        .of(&[PLANE, HALF_SPACE])
        .may("+z, for body 1 -z")
        .such_as("[0, 0, 1]");
pub(super) const OUTWARD: Field = Field::vector(
    "normal",
    Range::Finite.pure(),
    "outward normal at the point (need not be of unit length)",
)
.of(&[GIVEN])
.such_as("[0, 0, -1]");
pub(super) const DIRECTION: Field = Field::vector(
    "direction",
    Range::Finite.pure(),
    "first principal direction (need not be of unit length)",
)
.of(&[GIVEN])
.such_as("[1, 0, 0]");
pub(in crate::case) const MASS: Field = Field::number(
    "mass",
    Range::PositiveOrInfinite.of(Dimension::Mass),
    "mass; inf: the impact does not change its motion",
)
.or("`density` of a shape with a volume, or `fixed = true`")
.such_as("0.03");
pub(super) const DENSITY: Field =
    Field::number("density", Range::Positive.of(Dimension::Density), "density of a solid body")
        .or("`mass`, or `fixed = true`")
        .such_as("7850")
        .usually(Usual::DENSITY);
pub(in crate::case) const FIXED: Field =
    Field::new("fixed", Form::Switch, "fixed: of infinite mass and at rest")
        .default(Default::False)
        .such_as("true");
pub(in crate::case) const INERTIA: Field = Field::new(
    "inertia",
    Form::WordOrVector(
        &[(SOLID, "homogeneous"), (SHELL, "a thin shell")],
        AXES,
        Range::PositiveOrInfinite.of(Dimension::Inertia),
        "three moments about the axes of the body, each > 0 (inf: no rotation)",
    ),
    "moments of inertia",
)
.default(Default::Word(SOLID));
pub(in crate::case) const POSITION: Field = Field::new(
    "position",
    Form::Vector(AXES, PLACE, "three numbers [x, y, z], the centre of mass"),
    "position of the centre of mass",
)
.may("body 1 lies on top of body 2 along z; a plane passes through the origin")
.such_as("[0, 0, 0]");
pub(super) const QUATERNION: Field = Field::new(
    "quaternion",
    Form::Vector(&["w", "i", "j", "k"], Range::Finite.pure(), "a unit quaternion [w, i, j, k]"),
    "attitude: rotation from the axes of the body to those of space",
)
.may("axes parallel to those of space, or `angles`")
.such_as("[1, 0, 0, 0]");
pub(super) const ANGLES: Field = Field::new(
    "angles",
    Form::Vector(
        &["alpha", "beta", "gamma"],
        Range::Finite.of(Dimension::Degrees),
        "three angles [alpha, beta, gamma] in degrees",
    ),
    "attitude (8.3): rotation by gamma about z, then beta about the new y, then alpha about the new x",
)
.may("axes parallel to those of space, or `quaternion`")
.such_as("[0, 0, 0]");
pub(in crate::case) const VELOCITY: Field =
    Field::vector("velocity", Range::Speed.of(Dimension::Speed), "velocity of the centre of mass")
        .may("at rest, or of body 1 as `[approach]` says")
        .such_as("[0.25, 0, -0.5]");
pub(super) const SPIN: Field = Field::vector(
    "spin",
    Range::Speed.of(Dimension::Spin),
    "angular velocity, in the axes of space",
)
.may("no spin")
.such_as("[0, 0, 0]");

/// All fields of a body.
pub(super) const FIELDS: &[Field] = &[
    SHAPE, RADIUS, LENGTH, TUBE, SEMI_AXES, EDGES, RADII, POINT, NORMAL, OUTWARD, DIRECTION,
    YIELDING, DENSITY, MASS, FIXED, INERTIA, POSITION, QUATERNION, ANGLES, VELOCITY, SPIN,
];
/// Fields of a moving body in a new case.
pub(super) const MOVING: &[(&Field, &str)] = &[(&DENSITY, ""), (&VELOCITY, ""), (&SPIN, "")];

/// Body 1, on which the other one acts from below.
pub(in crate::case) const BODY_1: Field =
    Field::new("body_1", Form::Table(FIELDS), "the body on the side to which z points")
        .begun(MOVING);
/// Body 2.
pub(in crate::case) const BODY_2: Field =
    Field::new("body_2", Form::Table(FIELDS), "the other body")
        .begun(&[(&SHAPE, "\"plane\""), (&FIXED, "")]);
const PLACE_OF_BALL: Field = Field::vector("position", PLACE, "centre at the start")
    .or("`scene.start`")
    .such_as("[0, 0, 0.5]");
const SHAPE_OF_BALL: Field = Field::new(
    "shape",
    Form::Word(&[(SPHERE, "a scene computes the flight of spheres only")]),
    "shape of the surface",
)
.such_as("\"sphere\"");
/// The ball of a scene.
pub(in crate::case) const BALL: Field = Field::new(
    "ball",
    Form::Table(&[
        SHAPE_OF_BALL,
        RADIUS,
        MATERIAL,
        DENSITY.or("`mass`"),
        MASS.or("`density`"),
        INERTIA,
        PLACE_OF_BALL,
        VELOCITY.may("at rest"),
        SPIN,
    ]),
    "the ball that flies and bounces",
)
.begun(MOVING);
