//! The integration tests of `carom-rolling`: one executable.

mod rolling;
