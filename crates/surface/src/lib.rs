//! Height maps as instruments write them: read, described, levelled and written.
//!
//! [`read`] takes the bytes of an x3p, sur, sdf, npy or PNG file or of a text, and gives a [`Topography`]: heights on a
//! regular grid in metres, with the points that were not measured. [`Measures`] says what it is (roughness, slope,
//! tilt, missing points, spikes), [`Topography::levelled`], [`Topography::filled`] and [`Topography::cropped`] make of it
//! what a contact needs. There is no mechanics here.
//!
//! ```
//! use carom_surface::{Level, Reading, read};
//! let text = b"# Width: 30 um\n# Height: 20 um\n# Value units: nm\n1 2 3\n5 6 nan\n";
//! let map = read(text, &Reading::default())?.topography;
//! assert_eq!((map.columns(), map.rows(), map.missing()), (3, 2, 1));
//! assert!((map.spacing().unwrap()[0] - 1e-5).abs() < 1e-18);
//! let level = map.filled().levelled(Level::Plane);
//! assert!(level.heights().iter().all(|height| height.abs() < 1e-8));
//! # Ok::<(), carom_surface::SurfaceError>(())
//! ```
#![forbid(unsafe_code)]

mod bytes;
mod error;
mod format;
mod level;
mod measures;
mod npy;
mod picture;
mod points;
mod sdf;
mod spectrum;
mod spikes;
mod sur;
mod text;
mod topography;
mod warnings;
mod x3p;

pub use error::SurfaceError;
pub use format::{Format, Measured, Reading, read};
pub use level::Level;
pub use measures::Measures;
pub use npy::{Npy, npy};
pub use spectrum::{Spectrum, spectrum};
pub use spikes::{Spike, spikes};
pub use topography::{Crop, Topography};
pub use x3p::x3p;
