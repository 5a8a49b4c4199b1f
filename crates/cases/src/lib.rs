#![forbid(unsafe_code)]
//! Case files of carom: their fields, their reader, and the computation of what they describe.
//!
//! A case is a TOML file that describes a computation: bodies, materials, friction, motions. [`case`] reads
//! it strictly, in SI units or with units of its own; [`input`] reads files of limited size.
//! [`impact::followed`], [`history::followed`], [`solve::solved`] and [`shell::solved`] compute a case. The command `carom` and
//! the Python module are built on this crate.
//!
//! ```
//! use carom_cases::case::{CaseKind, ImpactFile};
//! let text = CaseKind::Impact.begin();
//! let file = ImpactFile::parse(&text)?;
//! assert!(file.nominal().collision.solve()?.rebound().is_some());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod case;
mod error;
pub mod history;
pub mod impact;
pub mod input;
pub mod numbers;
pub mod shell;
pub mod solve;

pub use error::{Error, is_bad_collision};
