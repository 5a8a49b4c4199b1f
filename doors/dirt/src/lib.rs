//! Contacts of grains with memory for the DEM code DIRT.
//!
//! DIRT's own contact is a tangential spring with a limit of friction: the whole contact sticks or the whole contact
//! slides. [`CaromContactPlugin`] provides the contact forces instead: Hertz's force and a law in which rings at the edge
//! slip while the inside sticks, with the memory of its load history. An impact then is the exact one of Hertz's and
//! Mindlin's theory.
//!
//! ```
//! use carom_dirt::CaromGranularPlugins;
//! use dirt_core::prelude::*;
//!
//! let mut app = App::new();
//! app.add_resource(Config::from_str(
//!     r#"
//!     [domain]
//!     x_high = 1.0
//!     y_high = 1.0
//!     z_high = 1.0
//!     [[dem.materials]]
//!     name = "glass"
//!     youngs_mod = 70e9
//!     poisson_ratio = 0.22
//!     restitution = 0.95
//!     friction = 0.3
//!     [run]
//!     steps = 10
//!     "#,
//! ));
//! app.add_resource(Input { filename: String::new(), output_dir: None });
//! app.add_plugins(CorePlugins).add_plugins(CaromGranularPlugins);
//! app.start();
//! ```
#![deny(unsafe_code)]

mod contacts;
mod force;
mod pairs;
mod plugin;

pub use plugin::{CaromContactPlugin, CaromGranularPlugins};
