//! carom: laws.
