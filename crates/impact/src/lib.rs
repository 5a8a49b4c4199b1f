//! carom: impact.
