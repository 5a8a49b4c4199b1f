//! The tests of `carom-plot` that see it as its users do: one executable, a module for each subject.

mod fields;
mod places;
