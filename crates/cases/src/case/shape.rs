//! The field that names the shape of a body, on which its other fields depend.

use super::field::{Field, Form};

pub(super) const SPHERE: &str = "sphere";
pub(super) const ELLIPSOID: &str = "ellipsoid";
pub(super) const CYLINDER: &str = "cylinder";
pub(super) const CAPSULE: &str = "capsule";
pub(super) const TORUS: &str = "torus";
pub(super) const BOX: &str = "box";
pub(super) const PLANE: &str = "plane";
pub(super) const HALF_SPACE: &str = "half-space";
pub(super) const GIVEN: &str = "given";

/// The shape of a body.
pub(super) const SHAPE: Field = Field::new(
    "shape",
    Form::Word(&[
        (SPHERE, "about its centre of mass"),
        (ELLIPSOID, "with semi-axes along the axes of the body"),
        (CYLINDER, "about axis c; contact on its curved side"),
        (CAPSULE, "a cylinder with hemispherical ends, about axis c"),
        (TORUS, "a ring about axis c"),
        (BOX, "with edges along the axes of the body; contact on a face"),
        (PLANE, "an infinite plane, the surface of a half-space"),
        (HALF_SPACE, "another name for plane"),
        (GIVEN, "a surface known by its curvatures at one point"),
    ]),
    "shape of the surface",
)
.such_as("\"sphere\"");
