//! The tests of `carom-special` that see it as its users do: one executable, a module for each subject.

mod common;
mod complete;
mod gamma;
mod hypergeometric;
mod identities;
mod incomplete;
mod nodes;
