//! Layer 2 of carom: the elastic half-space (chapter 4).
//!
//! | item | content |
//! |---|---|
//! | [`Material`], [`MaterialPair`] | elastic constants of a body and of two in contact (4.7) |
//! | [`PointLoad`] | displacement and stress of Boussinesq and Cerruti (4.1)-(4.5) |
//! | [`PointInfluence`] | displacements of the surfaces of two bodies by point forces (4.8) |
//! | [`Rectangle`], [`RectangleInfluence`] | the nine coefficients of a loaded cell (4.14), (4.29) |
//! | [`LoadedRectangle`], [`Stress`] | displacement and stress inside the body under a cell |
//! | [`Grid`], [`Field`], [`operator`] | products of whole fields by fast convolution (4.13) |
//! | [`room`] | the memory available to a computation |
//!
//! z points into the body. Tractions act on the body; pressure is positive in compression. Lengths,
//! forces and moduli may be in any consistent units.
//! ```
//! use carom_halfspace::{Force, Material, Point, PointLoad};
//! // A force of 1 presses a body with G = 1, nu = 1/2: (1 - nu)/(2 pi G r) at the distance r.
//! let load = PointLoad::new(Material::from_shear(1.0, 0.5)?, Force { z: 1.0, ..Force::default() })?;
//! let surface = load.displacement(Point::on_surface(0.5, 0.0))?;
//! assert!((surface.w - 0.5 / std::f64::consts::PI).abs() < 1e-15);
//! # Ok::<(), carom_special::RangeError>(())
//! ```
#![forbid(unsafe_code)]

mod difference;
mod field;
mod gauss;
mod grid;
mod influence;
mod interior;
mod material;
#[cfg(feature = "operators")]
mod multipoles;
#[cfg(feature = "operators")]
pub mod operator;
mod point_load;
mod rectangle;
pub mod room;
mod stress;
mod vector;

pub use field::Field;
pub use grid::Grid;
pub use influence::{Coefficients, PointInfluence, RectangleInfluence};
pub use interior::LoadedRectangle;
pub use material::{Material, MaterialPair};
pub use point_load::PointLoad;
pub use rectangle::{Offset, Rectangle, RectangleIntegrals};
pub use stress::{PrincipalStresses, Stress};
pub use vector::{Displacement, Force, Point, Traction};
