#![forbid(unsafe_code)]
//! Case files of carom: what they may say, how they are read, and what comes of them.
//!
//! A case is a TOML file that says what is to be computed: bodies, materials, friction, motions.
//! [`case`] reads it strictly, in SI units or with units of its own; [`input`] reads files of a bounded size.
//! [`impact::followed`], [`history::followed`] and [`solve::solved`] follow a case to its end. The command
//! `carom` and the Python module stand on this crate.
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
pub mod solve;

pub use error::{Error, is_bad_collision};
