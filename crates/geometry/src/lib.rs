//! Geometry of two bodies in contact: surfaces, positions and attitudes, relative curvature, the
//! search for nearest and contact points, inertia (section 5.1, section 8.1). It contains no
//! mechanics.
//!
//! | item | what |
//! |---|---|
//! | [`Surface`] | spheres, ellipsoids, planes, cylinders, capsules, tori, boxes, functions |
//! | [`LocalSurface`] | normal, principal curvatures and directions at a point of a surface |
//! | [`Placed`], [`Attitude`] | a surface with its position and attitude in space |
//! | [`nearest_points`] | the nearest points of two bodies, in contact or not |
//! | [`ContactPoint`] | the contact point of two bodies, with its axes [`ContactFrame`] |
//! | [`curvature`] | the gap A x^2 + B y^2 from the principal radii of both bodies |
//! | [`mesh::TriangleMesh`] | a surface of triangles, and where it touches a ball |
//! | [`Inertia`] | mass and moments of inertia of solids and shells |
//!
//! ```
//! use carom_geometry::curvature::{PrincipalRadii, RelativeCurvature};
//! // Two equal crossed cylinders touch like a sphere of their radius on a plane.
//! let cylinder = PrincipalRadii::cylinder(0.01)?;
//! let crossed = RelativeCurvature::new(cylinder, cylinder, std::f64::consts::FRAC_PI_2)?;
//! assert!((crossed.a() - 50.0).abs() < 1e-12 && (crossed.b() - 50.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

/// The vector and matrix types of the interface.
pub use nalgebra;

mod attitude;
mod contact_point;
mod direction;
mod frame;
mod inertia;
mod nearest;
mod placed;
mod surface;

pub mod curvature;
pub mod mesh;

pub use attitude::{Attitude, angle_matrix};
pub use contact_point::{ContactPoint, TOUCH_TOLERANCE};
pub use direction::perpendicular;
pub use frame::{ContactFrame, FrameError};
pub use inertia::Inertia;
pub use nearest::{Certainty, NearestPoints, SearchError, nearest_points};
pub use placed::Placed;
pub use surface::{BodySide, Height, LocalSurface, Surface, SurfaceError};
