//! The integration tests of `carom-special`: one executable with a module for each subject.

mod common;
mod complete;
mod gamma;
mod hypergeometric;
mod identities;
mod incomplete;
mod nodes;
#[path = "../../../../testing/tabled.rs"]
mod tabled;
