#![forbid(unsafe_code)]
//! The parts of the command `carom`: option values, commands, output. Cases are read by `carom_cases`.
//!
//! Parse, make the library's validated types, run, render: nothing is written before all of
//! that has succeeded, but for rows that are too many to hold. Exit code 2 means bad input, 1 a
//! file that cannot be read or written.

mod aside;
pub mod columns;
pub mod command;
pub mod destination;
pub mod error;
mod identity;
pub mod manner;
pub mod output;
pub mod outputs;
pub mod range;
pub mod rows;

/// The examples of the README, run as documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;

/// Those of the book.
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
