#![forbid(unsafe_code)]
//! The command `carom`.
fn main() {}
