//! carom: solver.
