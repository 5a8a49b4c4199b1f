#![forbid(unsafe_code)]
//! The command `carom`: values of options, commands, output. Case files are read by `carom_cases`.
//!
//! A command parses its input, validates it into types of the library, computes, and formats the
//! results. Output is written only after the whole computation has succeeded, except for tables too
//! large to hold in memory. Exit code 2 means bad input, 1 a file that cannot be read or written, 3 a
//! warning with `--strict`.

mod atomic_file;
pub mod columns;
pub mod command;
pub mod destination;
pub mod error;
pub mod format;
pub mod global_options;
mod identity;
pub mod output;
pub mod outputs;
pub mod page;
mod place;
mod progress;
pub mod range;
mod round_off;
pub mod rows;

/// The examples of the book, run as documentation tests.
#[cfg(doctest)]
mod book {
    #[doc = include_str!("../../../docs/book/src/start/rust.md")]
    struct Start;
    #[doc = include_str!("../../../docs/book/src/extend/law.md")]
    struct Law;
    #[doc = include_str!("../../../docs/book/src/extend/surface.md")]
    struct Surface;
    #[doc = include_str!("../../../docs/book/src/extend/method.md")]
    struct Method;
}
