//! The tests of `carom-classic` that see it as its users do: one executable, a module for each subject.

mod agreement;
mod direct_refusals;
mod theory;
