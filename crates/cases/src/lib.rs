#![forbid(unsafe_code)]
//! Case files of carom: their fields, their reader, and the computation of what they describe.
//!
//! A case is a TOML file that describes a computation: bodies, materials, friction, motions. [`case`] reads
//! it strictly, in SI units or with units of its own; [`input`] reads files of limited size.
//! Each kind has a module that computes a case: [`impact::followed`], [`hertz::followed`], [`history::followed`],
//! [`scene::followed`], [`solve::solved`], [`roll::rolled`], [`stress::solved`], [`shell::solved`]. [`contact`]
//! computes inputs of the program CONTACT. [`theory`] tells where results leave the theory. The command `carom` and the Python module are built on this crate.
//!
//! ```
//! use carom_cases::case::{Case as _, CaseKind, ImpactFile};
//! let text = CaseKind::Impact.template();
//! let file = ImpactFile::parse(&text)?;
//! assert!(file.nominal().collision.solve()?.rebound().is_some());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod case;
pub mod contact;
mod error;
pub mod heights;
pub mod hertz;
pub mod history;
pub mod impact;
pub mod input;
pub mod numbers;
mod pressed;
pub mod roll;
pub mod scene;
pub mod shell;
pub mod solve;
pub mod stress;
pub mod theory;

pub use error::{Error, ErrorKind};
pub use pressed::{PointOrLine, Pressed};
