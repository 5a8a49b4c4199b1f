#![forbid(unsafe_code)]
//! The parts of the command `carom`: case files, option values, output.
//!
//! Parse, make the library's validated types, run, render: nothing is written before all of
//! that has succeeded, but for rows that are too many to hold. Exit code 2 means bad input, 1 a
//! file that cannot be read or written.

mod aside;
pub mod case;
pub mod columns;
pub mod command;
pub mod destination;
pub mod error;
mod identity;
pub mod input;
pub mod manner;
pub mod numbers;
pub mod output;
pub mod outputs;
pub mod range;
pub mod rows;

pub use command::cases;

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
