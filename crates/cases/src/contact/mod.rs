//! Inputs of the program CONTACT (module 3), solved with the solver of this workspace.
//!
//! [`cases`] reads a file, [`solved`] solves what it says. The names, signs and units are those of CONTACT: lengths
//! in mm, moduli in N/mm^2; z points into body 1, the upper one.

mod below;
mod block;
mod carried;
mod case;
mod digits;
mod falling;
mod fastsim;
mod fault;
mod lines;
mod method;
mod potential;
mod read;
mod row;
mod solve;
mod springs;
mod surface;
mod toml;

pub use below::{BELOW, Below};
pub use block::Block;
pub use case::{Asked, Begin, ContactCase, ContactDrive, Motion, Rolling};
pub use digits::{Choice, Digit, Does, LINES};
pub use falling::Falling;
pub use fault::Fault;
pub use potential::{Ellipse, Potential};
pub use read::cases;
pub use row::{COLUMNS, Row};
pub use solve::{Solved, solved};
pub use springs::{Bound, Fastsim};
pub use surface::Surface;
pub use toml::toml;
