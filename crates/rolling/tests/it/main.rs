//! The tests of `carom-rolling` that see it as its users do: one executable.

mod rolling;
